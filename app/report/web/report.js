// The page of `crest report`, from the JSON that docs/report.schema.json describes.

data.answers.sort((a, b) => b.own - a.own);  // the scene's own first
const methodOf = Object.fromEntries(data.methods.map((m) => [m.id, m]));
const target = data.settings.target;
const targetName = data.measures.find((m) => m.id === target.measure).name;
const clocks = {frame_ms: "wall clock, until the device has finished", device_ms: "the device's own clock"};

function errorAgainst(point, answer) { return point.errors.find((e) => e.answer === answer); }
function pointTitle(point) { return point.step === null ? methodOf[point.method].name : `${methodOf[point.method].name}, step ${stepText(point.step)}`; }

function convergenceOf(point, answer) { return methodOf[point.method].convergence.find((c) => c.answer === answer); }

function errorText(measure, value) {
  return value === null ? "–" : ["share", "missed", "invented"].includes(measure) ? percent(value) : number(value);
}

function targetText() {
  return target.measure === "share" ? `at most ${percent(target.most)} of the compared pixels off by more than 1/255`
                                    : `${targetName} at most ${errorText(target.measure, target.most)}`;
}

function errorSummary(error) {
  const m = error.measures;
  const parts = [`${percent(m.share)} of pixels off by more than 1/255`, `RMSE ${number(m.rmse)}`, `largest ${number(m.max)}`];
  if (error.crossings && error.crossings.exact > 0) parts.push(`${error.crossings.missed} of ${error.crossings.exact} crossings missed`);
  return parts.join(" · ");
}

// The points of each method against an answer, from coarse to fine.
function seriesAgainst(answer) {
  return data.methods
      .map((method, n) => ({name: method.name, style: seriesStyle(n),
                            points: data.points.filter((p) => p.method === method.id && errorAgainst(p, answer))
                                        .sort((a, b) => b.step - a.step)}))
      .filter((s) => s.points.length);
}

function pointTip(point, answer) {
  const error = errorAgainst(point, answer.name);
  const line = (name, value) => element("tr", {}, element("td", {class: "soft"}, name), element("td", {}, value));
  const spread = `${number(Math.min(...point.frame_ms_all))} to ${number(Math.max(...point.frame_ms_all))}, ${point.frame_ms_all.length} frames`;
  return [element("b", {}, pointTitle(point)),
          element("table", {}, line("time", `${ms(point.frame_ms)} (${spread})`), line("device", ms(point.device_ms)),
                  line("samples", `${number(point.samples_per_ray)} a ray`),
                  data.measures.filter((m) => error.measures[m.id] !== null).map((m) => line(m.name, errorText(m.id, error.measures[m.id]))))];
}

function chartOf(answer, measure, clock) {
  const front = answer.front[measure.id].map((i) => data.points[i]);
  const place = (point) => ({x: point[clock], y: errorAgainst(point, answer.name).measures[measure.id]});
  const series = seriesAgainst(answer.name)
      .map((s) => ({...s, points: s.points.filter((p) => place(p).y !== null).map((p) => ({
        ...place(p), tip: () => pointTip(p, answer), onFront: clock === "frame_ms" && front.includes(p),
        chosen: data.points[answer.cheapest] === p, click: () => showPicture(p)}))}))
      .filter((s) => s.points.length);
  if (!series.length) return element("p", {class: "soft"}, "Nothing is compared here: no method has crossings, or no pixel shows anything.");
  return logLogChart({series, xTitle: `time of a frame in ms (${clocks[clock]})`, yTitle: measure.name,
                      target: measure.id === target.measure ? {y: target.most, text: "target"} : null,
                      front: clock === "frame_ms" ? front.map(place) : []});
}

function drawCharts() {
  const measure = data.measures.find((m) => m.id === byId("measure").value), clock = byId("clock").value;
  byId("charts").replaceChildren(...data.answers.filter((a) => seriesAgainst(a.name).length).map((answer) => {
    const best = answer.cheapest === null ? element("span", {class: "never"}, "target never reached")
                                          : element("span", {class: "met"}, `cheapest under the target: ${pointTitle(data.points[answer.cheapest])} (ringed)`);
    return element("div", {class: "panel"},
                   element("h3", {}, `against ${answer.name}`, element("span", {class: "soft"}, answer.own ? "  the scene's own mode" : "")),
                   element("div", {class: "small"}, best), chartOf(answer, measure, clock));
  }));
}

function showPicture(point) {
  const card = document.querySelector(`[data-point="${data.points.indexOf(point)}"]`);
  if (card) card.scrollIntoView({behavior: "smooth", block: "center"});
}

function fillHeader() {
  const s = data.scene;
  byId("subject").textContent = `${s.volume} (${s.dims.join(" × ")}), ${s.preset ? `preset ${s.preset}` : "default transfer function"}, ` +
      `mode ${s.mode}, ${s.size.join(" × ")} pixels; ${data.made_at.replace("T", " ").replace("Z", " UTC")}`;
  if (!data.complete)
    byId("notices").append(element("div", {class: "panel notice"}, `Stopped by hand after ${data.points.length} points: what was measured until then is here.`));
}

function isEmpty(answer) {
  return data.points.every((p) => !(errorAgainst(p, answer.name)?.compared.pixels > 0));
}

function recommendationOf(answer) {
  const head = `against ${answer.name}${answer.own ? ", the scene's own mode" : ""}`;
  if (answer.cheapest === null)
    return element("div", {class: "panel"}, element("h3", {class: "soft"}, head),
                   element("div", {class: answer.own ? "lead never" : "never"},
                           isEmpty(answer) ? "nothing to recommend: no pixel that could be compared shows anything" : "never reached by what was measured"));
  const point = data.points[answer.cheapest];
  return element("div", {class: "panel"}, element("h3", {class: "soft"}, head),
                 element("div", {class: answer.own ? "lead" : ""}, `${pointTitle(point)}: ${ms(point.frame_ms)} a frame`),
                 element("p", {class: "small soft"}, errorSummary(errorAgainst(point, answer.name))),
                 convergenceOf(point, answer.name).steady ? null : element("p", {class: "small never"}, "Some finer steps miss the target again: this one may owe it to chance."),
                 command(point.command));
}

function fillRecommendation() {
  const measured = data.answers.filter((a) => seriesAgainst(a.name).length);
  const others = measured.filter((a) => !a.own);
  byId("recommendation").append(
      element("p", {}, `The fastest setting that keeps under the target: ${targetText()}.`), ...measured.filter((a) => a.own).map(recommendationOf));
  if (others.length)
    byId("recommendation").append(element("details", {}, element("summary", {}, "For the other modes"), others.map(recommendationOf)));
}

function fillConvergence() {
  const rows = data.methods.flatMap((method) => method.convergence.map((c) => {
    const point = c.cheapest === null ? null : data.points[c.cheapest];
    const order = c.order === null ? element("span", {class: "soft"}, "none") : element("span", {}, c.order.toFixed(2));
    return [method.name, c.answer, {number: order},
            c.order === null ? "–" : `${stepText(c.fitted_from)} to ${stepText(c.fitted_to)} (${c.fitted_points} steps)`,
            point ? {number: stepText(point.step) + (c.steady ? "" : " *")} : {number: element("span", {class: "never"}, "never reached")},
            {number: point ? ms(point.frame_ms) : ""}];
  }));
  byId("unsteady").hidden = data.methods.every((m) => m.convergence.every((c) => c.steady));
  fillTable(byId("convergence"), ["Method", "against", {number: "Order"}, "fitted on steps", {number: "Target at step"}, {number: "at"}], rows);
}

function fillLimits() {
  fillTable(byId("limits"), ["Method", "in files", "Its limits"], data.methods.map((m) => [m.name, m.id, m.limits]));
}

function cardOf(point, error) {
  return element("div", {class: "panel", "data-point": data.points.indexOf(point)}, element("h3", {}, pointTitle(point)),
                 element("div", {class: "pair"}, figure(point.picture, `${ms(point.frame_ms)}, ${number(point.samples_per_ray)} samples a ray`),
                         figure(error.picture, errorSummary(error))));
}

function fillPictures() {
  for (const answer of data.answers) {
    const shown = seriesAgainst(answer.name).flatMap((s) => s.points).filter((p) => p.picture);
    if (!shown.length) continue;
    const exact = element("div", {class: "panel"}, element("h3", {}, `exact: ${answer.name}`),
                          element("div", {class: "pair"}, figure(answer.picture, "solved ray by ray, in double"),
                                  element("figure", {}, element("p", {class: "small soft"}, `${number(answer.crossings_per_ray)} crossings of surfaces a ray.`))));
    byId("pictures").append(element("h3", {style: "margin-top: 22px"}, `against ${answer.name}`),
                            element("div", {class: "grid"}, exact, shown.map((p) => cardOf(p, errorAgainst(p, answer.name)))));
  }
}

function fillDifferences() {
  const cards = data.answers.filter((a) => a.model_difference).map((a) =>
    element("div", {class: "panel"}, element("h3", {}, `${a.name} from integral`),
            element("div", {class: "pair"}, figure(a.picture, `exact ${a.name}`), figure(a.model_difference.picture, errorSummary({...a.model_difference, crossings: null})))));
  byId("differences").append(cards.length ? element("div", {class: "grid"}, cards)
                                          : element("p", {class: "soft"}, "No second exact answer was rendered."));
}

function fillStarts() {
  fillTable(byId("starts"), ["Method", {number: "First frame"}, {number: "at step"}, {number: "An edit adds"}],
            data.methods.map((m) => [m.name, {number: ms(m.first_frame_ms)}, {number: stepText(m.started_at_step)}, {number: ms(m.edit_ms)}]));
}

function fillMethod() {
  const s = data.settings, anchors = data.points.map((p) => p.anchor_ms).filter((t) => t > 0);
  const grazing = Math.max(0, ...data.points.flatMap((p) => p.errors.map((e) => e.grazing_share)));
  const leftOut = Math.max(0, ...data.points.map((p) => p.crossings_left_out_per_ray));
  const lines = [
    `Renderer: ${data.renderer}; ${data.processors} processors.`,
    `It took ${number(data.seconds)} s, of these ${number(data.reference_seconds)} s for the exact answers` +
        (s.budget_seconds === null ? "; there was no budget." : `; the budget was ${number(s.budget_seconds)} s.`),
    `A frame's time is the median of ${s.frames} frames (more of short ones, 3 where one takes over a second). The points of a group were drawn turn by turn, together with the sweep's ` +
        `first point, whose median lay between ${ms(Math.min(...anchors))} and ${ms(Math.max(...anchors))} in the groups: so far the machine drifted, which is taken out of the times shown.`,
    "Shading has no exact answer, and early termination adds an error of its own: both are off, for the times as for the errors.",
    `Errors are over premultiplied RGBA, on the pixels where either picture has alpha > 0. Pixels whose ray grazes a surface within the rounding of 32-bit float are left out: ` +
        `at most ${percent(grazing)} of them here.`,
    `FLIP (Andersson et al. 2020) is the mean over the same pixels, over the background, at ${number(s.flip_pixels_per_degree)} pixels a degree.`,
    `A step composites at most ${data.scene.max_peaks} crossings (max_peaks); those beyond were at most ${number(leftOut)} a ray.`];
  if (/llvmpipe/.test(data.renderer))
    lines.push("This renderer's device clock (GL_TIME_ELAPSED) covers only a part of each frame: go by the wall clock.");
  byId("method").append(...lines.map((line) => element("p", {class: "small"}, line)), command(data.command));
}

function fillDetails() {
  byId("left-out-title").textContent = `Left out (${data.left_out.length})`;
  fillTable(byId("left-out"), ["What", "Why"], data.left_out.map((l) => [l.what, l.why]));
  const rows = data.points.flatMap((p) => p.errors.map((e) => [
    p.method, {number: stepText(p.step)}, e.answer, {number: ms(p.frame_ms)}, {number: ms(p.device_ms)}, {number: number(p.samples_per_ray)},
    ...data.measures.map((m) => ({number: errorText(m.id, e.measures[m.id])})), p.why]));
  fillTable(byId("points"), ["Method", {number: "Step"}, "against", {number: "Time"}, {number: "Device"}, {number: "Samples a ray"},
                             ...data.measures.map((m) => ({number: m.id})), "measured for"], rows);
}

byId("measure").append(...data.measures.map((m) => element("option", {value: m.id}, m.name)));
byId("measure").value = target.measure;
byId("clock").append(...Object.entries(clocks).map(([id, name]) => element("option", {value: id}, name)));
byId("measure").addEventListener("change", drawCharts);
byId("clock").addEventListener("change", drawCharts);

fillHeader();
fillRecommendation();
drawCharts();
fillConvergence();
fillLimits();
fillScale();
fillPictures();
fillDifferences();
fillStarts();
fillMethod();
fillDetails();
