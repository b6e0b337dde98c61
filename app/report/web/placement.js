// The page of `crest report --study placement`, from placement.json.

const placements = data.volumes[0].placements.map((p) => p.placement);
const figureRates = [1, 4, 16];
const sums = {paper: "eq. (6): g Δx", absorbing: "1 − exp: what a segment absorbs of its own light counts"};
const fields = {linear: "linear, (x + 1.5)/3", curved: "curved, (1 + cos(πx/1.5) cos(πy/1.5))/2"};

function seriesOf(field, sum, placement) {
  return data.plane.series.find((s) => s.field === field && s.sum === sum && s.placement === placement);
}

function runOf(series, rate) { return series.runs.find((run) => run.rate === rate); }
function order(value) { return value === null ? "–" : value.toFixed(2); }
function error(value) { return value < 1e-12 ? "0" : number(value); }

// The paper's fig. 2: intensities by ray, the closed form as a line, samples as dots.
function rayChart(exact, run, title, highest) {
  const width = 345, height = 168, left = 34, right = 6, top = 20, bottom = 24;
  const x = (ray) => left + ray / (data.plane.rays - 1) * (width - left - right);
  const y = (value) => height - bottom - value / highest * (height - top - bottom);
  const chart = svg("svg", {class: "chart", viewBox: `0 0 ${width} ${height}`, role: "img"},
                    svg("text", {class: "title", x: left, y: 13}, title));
  for (let value = 0; value <= highest; value += 0.5)
    chart.append(svg("line", {class: "grid-line", x1: left, x2: width - right, y1: y(value), y2: y(value)}),
                 svg("text", {x: left - 6, y: y(value) + 4, "text-anchor": "end"}, String(value)));
  for (let ray = 0; ray < data.plane.rays; ray += 20)
    chart.append(svg("text", {x: x(ray), y: height - 8, "text-anchor": "middle"}, String(ray)));
  chart.append(svg("path", {class: "exact", d: pathOf(exact.map((value, ray) => [x(ray), y(value)]))}));
  run.intensities.forEach((value, ray) => {
    if (value === 0 && exact[ray] === 0) return;
    chart.append(svg("circle", {class: "sampled", cx: x(ray).toFixed(1), cy: y(value).toFixed(1), r: 1.7}));
  });
  return chart;
}

function drawRays() {
  const field = byId("field").value, sum = byId("sum").value;
  const exact = data.plane.fields.find((f) => f.name === field).exact;
  const runs = placements.flatMap((p) => figureRates.map((rate) => [p, runOf(seriesOf(field, sum, p), rate)]));
  const highest = 1.02 * Math.max(...exact, ...runs.flatMap(([, run]) => run.intensities));
  byId("rays").replaceChildren(...runs.map(([p, run]) => rayChart(exact, run, `${p}, rate ${run.rate}`, highest)));
  drawOrders();
}

function drawOrders() {
  const field = byId("field").value, sum = byId("sum").value, measure = byId("error").value;
  const series = placements.map((placement, n) => {
    const s = seriesOf(field, sum, placement);
    const points = s.runs.map((run) => {
      const y = run.dense_errors[measure];
      return {x: 1 / run.rate, y: y < 1e-12 ? 0 : y, onFront: true,
              tip: () => [element("b", {}, `${placement}, rate ${run.rate}`), `error ${error(y)}`]};
    });
    return {name: `${placement} (order ${order(s[`${measure}_order`])})`, style: seriesStyle(n), points};
  });
  byId("orders").replaceChildren(logLogChart({series, xTitle: "step, in spacings",
      yTitle: measure === "max" ? "largest error of a ray" : "RMS error of the rays", target: null, front: []}));
}

function fillPlaneTable() {
  const rows = data.plane.series.map((s) => [
    s.field, s.sum === "paper" ? "eq.\u00a0(6)" : "1\u00a0−\u00a0exp", s.placement,
    ...figureRates.flatMap((rate) => {
      const e = runOf(s, rate).errors;
      return [{number: error(e.max)}, {number: error(e.rms)}];
    }),
    {number: order(s.max_order)}, {number: order(s.rms_order)}, {number: String(runOf(s, 1).errors.unsampled)}]);
  fillTable(byId("plane"), ["Field", "Sum", "Placement", ...figureRates.flatMap((rate) => [{number: `max, rate ${rate}`}, {number: "RMS"}]),
                            {number: "order, max"}, {number: "RMS"}, {number: "unsampled"}], rows);
  byId("plane-note").textContent = `Errors of the paper's ${data.plane.rays} rays, where they meet the square; "unsampled": those of them without a sample at rate 1. Orders are fitted over rates 1, 2, 4, … 64 of a fan of ` +
      `${data.plane.dense_rays} rays, in which the worst ray is no matter of chance; “–”: the error is that of rounding, below 10⁻¹².`;
}

function pointAt(placement, step) { return placement.points.find((p) => p.step === step); }

function errorTable(volume) {
  const table = element("table");
  const steps = volume.placements[0].points.map((p) => p.step);
  fillTable(table, ["RMSE at step", ...steps.map((s) => ({number: stepText(s)})), {number: "order"}, {number: `largest, step ${stepText(data.pictured_step)}`},
                    {number: "off by > 1/255"}, {number: "samples a ray"}],
            volume.placements.map((p) => {
              const at = pointAt(p, data.pictured_step);
              return [p.placement, ...p.points.map((point) => ({number: number(point.rmse)})), {number: order(p.order)}, {number: number(at.max)},
                      {number: percent(at.share)}, {number: number(at.dvr_samples_per_ray)}];
            }));
  return element("div", {class: "scroll"}, table);
}

function fillVolumes() {
  for (const volume of data.volumes) {
    const cards = volume.placements.map((p) => {
      const at = pointAt(p, data.pictured_step);
      return element("div", {}, element("h3", {}, p.placement),
                     element("div", {class: "pair"}, figure(p.picture, `${number(at.dvr_samples_per_ray)} samples a ray`),
                             figure(p.error_picture, `RMSE ${number(at.rmse)}, largest ${number(at.max)}`)));
    });
    byId("volumes").append(element("div", {class: "panel"}, element("h3", {}, volume.title),
        element("p", {class: "small soft"}, `${volume.note} ${volume.dims.join(" × ")} points, ${volume.size.join(" × ")} pixels.`),
        element("div", {class: "grid"}, cards), errorTable(volume)));
  }
}

function fillCrop() {
  fillTable(byId("crop"), ["Placement", {number: "Largest difference"}, {number: "Pixels off by > 1/255"}, {number: "of pixels"}],
            data.clip_against_crop.map((c) => [c.placement, {number: number(c.max)}, {number: percent(c.share)}, {number: String(c.pixels)}]));
}

function fillTimes() {
  const t = data.times, volume = data.volumes.find((v) => v.id === t.scene);
  byId("times-about").textContent = `${volume.title}, ${t.size.join(" × ")} pixels, step ${stepText(t.step)}, drawn turn by turn in changing order, ` +
      `${t.placements[0].frame_ms_all.length} rounds. The ratio is the median over the rounds, to entry_exit_corner in the same round. The last line is ` +
      "entry_exit_corner once more: what its ratio differs from 1 by is what the machine does by itself.";
  fillTable(byId("times"), ["Placement", {number: "Median"}, {number: "Ratio"}, {number: "Samples a ray"}],
            t.placements.map((p) => [p.control ? `${p.placement} again` : p.placement, {number: ms(p.frame_ms)}, {number: p.ratio.toFixed(3)},
                                     {number: number(p.dvr_samples_per_ray)}]));
}

// What the numbers say, in sentences that only state them.
function fillFindings() {
  const at = (field, sum, placement) => seriesOf(field, sum, placement);
  const rms = (s) => error(runOf(s, 1).errors.rms);
  const corner = at("curved", "absorbing", "entry_exit_corner"), cornerPaper = at("linear", "paper", "entry_exit_corner");
  const lines = [
    `Worst rays converge with order ${["eye", "entry", "entry_exit"].map((p) => order(at("curved", "absorbing", p).max_order)).join(", ")} for eye, entry and entry_exit, ` +
        `with order ${order(corner.max_order)} for entry_exit_corner (curved field, 1 − exp).`,
    `On the linear field entry_exit_corner with 1 − exp is off by ${error(runOf(at("linear", "absorbing", "entry_exit_corner"), 1).errors.max)} even at rate 1: g = 2τ makes the sum depend on the depth alone, ` +
        "and midpoints sum a linear field exactly.",
    `With the paper's own sum, eq. (6), no placement is better than first order (entry_exit_corner: ${order(cornerPaper.max_order)}): a segment's light is not dimmed by the segment. ` +
        `At rate 1 it is off by ${rms(cornerPaper)} in the mean square; eye with 1 − exp by ${rms(at("linear", "absorbing", "eye"))}.`,
    ...data.volumes.map((v) => `${v.title}: at step ${stepText(data.pictured_step)}, RMSE ${v.placements.map((p) => `${number(pointAt(p, data.pictured_step).rmse)} (${p.placement})`).join(", ")}.`),
    `Frame times: ${data.times.placements.map((p) => `${p.ratio.toFixed(3)} (${p.control ? "entry_exit_corner again" : p.placement})`).join(", ")}.`];
  byId("findings").append(...lines.map((line) => element("li", {}, line)));
}

function fillMethod() {
  const lines = [
    `Renderer: ${data.renderer}; ${data.processors} processors.`,
    "The extruded square's transfer function is white with τ = s/2, its opacity linear between 33 points, so its picture is g/2 of the plane study. " +
        `The middle row of its exact picture is within ${number(data.distance_from_plane)} of the closed form's.`,
    "Errors are over the pixels where either picture has alpha > 0.",
    "placement.csv has every ray's intensity; placement.json all numbers."];
  byId("method").append(...lines.map((line) => element("p", {class: "small"}, line)), command(data.command));
}

for (const [id, names] of [["field", fields], ["sum", sums]]) {
  byId(id).append(...Object.entries(names).map(([value, name]) => element("option", {value}, name)));
  byId(id).addEventListener("change", drawRays);
}
byId("error").addEventListener("change", drawOrders);
byId("subject").textContent = `Four placements, in the plane and in volumes; ${data.made_at.replace("T", " ").replace("Z", " UTC")}`;

fillFindings();
drawRays();
fillPlaneTable();
fillScale();
fillVolumes();
fillCrop();
fillTimes();
fillMethod();
