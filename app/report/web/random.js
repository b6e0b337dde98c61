// The page of `crest report --study random`, from random.json.

const methodOf = Object.fromEntries(data.methods.map((m) => [m.id, m]));
const groupOf = Object.fromEntries(data.groups.map((g) => [g.id, g]));

function share(value) { return value === null ? "–" : `${(100 * value).toFixed(value > 0.9999 && value < 1 ? 4 : 2)} %`; }
function finest(summary) { return summary.steps[summary.steps.length - 1]; }
function stepOf(summary, step) { return summary.steps.find((s) => s.step === step || s.step === null); }
function sceneText(index) {
  const s = data.scenes[index];
  return `scene ${index} (${s.field}, ${s.features}, ${s.view})`;
}

function rowOf(summary) {
  const last = finest(summary), steps = data.steps.map((step, i) => summary.steps[i]);
  const of = (s, text) => ({number: s ? text(s) : ""});
  return [methodOf[summary.method].name, summary.answer, ...steps.map((s) => of(s, () => share(s.within))),
          {number: share(last.worst_within)}, {number: number(last.worst_scene)},
          ...data.steps.slice(1).map((_, i) => of(summary.orders[i], (order) => order.toFixed(2))),
          ...steps.map((s) => of(s, () => String(s.outliers))),
          of(last.crossings, (c) => String(c.missed)), of(last.crossings, (c) => String(c.invented))];
}

function panelOf(group) {
  const table = element("table"), at = (text) => data.steps.map((step) => ({number: `${text} ${stepText(step)}`}));
  fillTable(table, ["Method", "against", ...at("at"), {number: "worst"}, {number: "scene"},
                    ...data.steps.slice(1).map((step) => ({number: `order to ${stepText(step)}`})), ...at("outliers"),
                    {number: "missed"}, {number: "invented"}],
            group.summaries.map(rowOf));
  return element("div", {class: "panel scroll"}, element("h3", {}, `${group.title} (${group.scenes})`), table);
}

function findings() {
  const lines = [];
  for (const group of data.groups.filter((g) => g.id !== "all" && g.best_sampled !== null)) {
    const best = group.summaries.find((s) => s.method === group.best_sampled);
    lines.push(`${group.title}: the best of the sampled methods that show peaks and base TF is ${methodOf[best.method].name} (${best.method}): of the pixels within 1/255 are ` +
               `${best.steps.map((s) => `${share(s.within)} at ${stepText(s.step)}`).join(", ")}; worst at ${stepText(finest(best).step)} is ${sceneText(finest(best).worst_scene)}.`);
  }
  for (const s of groupOf.all.summaries.filter((s) => finest(s).step === null))
    lines.push(`${methodOf[s.method].name} (${s.method}): ${share(finest(s).within)} of ${number(finest(s).pixels)} pixels within 1/255, ` +
               `the furthest off by ${number(finest(s).max)}${finest(s).crossings ? `; of ${finest(s).crossings.exact} crossings ${finest(s).crossings.missed} missed, ${finest(s).crossings.invented} invented` : ""}.`);
  for (const m of data.measurements.filter((m) => m.step === null && m.wrong > 0))
    lines.push(`${m.method} is wrong in ${sceneText(m.scene)} of seed ${data.seed}: ${m.wrong} of ${m.pixels} pixels, by ${number(m.max)} at (${m.worst_pixel.join(", ")}).`);
  return lines;
}

function drawChart() {
  const answer = byId("answer").value, group = groupOf[byId("group").value];
  const series = group.summaries.filter((s) => s.answer === answer && s.steps.length > 1).map((s, n) => ({
    name: methodOf[s.method].name, style: seriesStyle(n),
    points: s.steps.map((p) => ({x: p.step, y: p.rmse, tip: () => [element("b", {}, `${methodOf[s.method].name}, step ${stepText(p.step)}`),
                                                                 `RMSE ${number(p.rmse)}, ${share(p.within)} within 1/255`]}))}));
  byId("chart").replaceChildren(series.length ? logLogChart({series, xTitle: "step", yTitle: "RMSE", target: null, front: []})
                                              : element("p", {class: "soft"}, "Nothing was compared here."));
}

function fillMethod() {
  const lines = [
    `Renderer: ${data.renderer}; ${data.processors} processors; ${number(data.seconds)} s.`,
    "Errors are over premultiplied RGBA, on the pixels where either picture has alpha > 0; pixels whose ray grazes a surface within the rounding of 32-bit float are left out. " +
        "The exact answers are solved ray by ray, in double.",
    "Another seed makes other scenes: --seed N. random.csv has every comparison, random.json all numbers."];
  byId("method").append(...lines.map((line) => element("p", {class: "small"}, line)), command(data.command));
}

byId("subject").textContent = `Seed ${data.seed}: ${data.scenes.length} scenes, ${data.size.join(" × ")} pixels; ${data.made_at.replace("T", " ").replace("Z", " UTC")}`;
byId("outlier").textContent = String(data.outlier_difference);
if (data.scenes.length < data.scenes_of_seed)
  byId("notices").append(element("div", {class: "panel notice"}, `The budget left out the last ${data.scenes_of_seed - data.scenes.length} of the seed's ${data.scenes_of_seed} scenes.`));
byId("findings").append(...findings().map((line) => element("li", {}, line)));
byId("groups").append(...data.groups.filter((g) => g.id !== "all" && g.scenes > 0).map(panelOf));
byId("answer").append(...[...new Set(groupOf.all.summaries.map((s) => s.answer))].map((a) => element("option", {value: a}, a)));
byId("group").append(...data.groups.filter((g) => g.scenes > 0).map((g) => element("option", {value: g.id}, g.title)));
for (const id of ["answer", "group"]) byId(id).addEventListener("change", drawChart);
drawChart();
byId("scenes").append(...data.scenes.map((s) => figure(s.picture, `${sceneText(s.index)}, ${s.dims.join(" × ")} points`)));
fillTable(byId("limits"), ["Method", "in files", "Its limits"], data.methods.map((m) => [m.name, m.id, m.limits]));
fillMethod();
fillTable(byId("all"), [{number: "Scene"}, "Method", {number: "Step"}, "against", {number: "Pixels"}, {number: "within 1/255"}, {number: "RMSE"}, {number: "Largest"},
                        {number: "at pixel"}, {number: "Outliers"}, {number: "Missed"}, {number: "Invented"}],
          data.measurements.map((m) => [{number: String(m.scene)}, m.method, {number: stepText(m.step)}, m.answer, {number: String(m.pixels)}, {number: share(m.within)},
                                        {number: number(m.rmse)}, {number: number(m.max)}, {number: m.worst_pixel.join(", ")}, {number: String(m.outliers)},
                                        {number: m.crossings ? String(m.crossings.missed) : ""}, {number: m.crossings ? String(m.crossings.invented) : ""}]));
