// The page of `crest report --study knoll`, from knoll.json.

const fps = (value) => value >= 10 ? value.toFixed(0) : value.toFixed(value >= 1 ? 1 : 2);
const times = (value) => `${value.toFixed(2)} ×`;
const shotOf = (group, id) => group.shots.find((shot) => shot.variant === id);

// Ours over the paper's, in one cell.
function both(ours, paper) {
  return {number: element("span", {}, ours, element("br"), element("span", {class: "soft small"}, paper || "–"))};
}

function range(r, text = (x) => x.toFixed(2)) {
  return r === null ? "–" : text(r.low) === text(r.high) ? text(r.low) : `${text(r.low)} to ${text(r.high)}`;
}

function fillClaims() {
  const look = {holds: "met", better: "met", worse: "never", "not measured": "soft"};
  fillTable(byId("claims"), ["The paper says", "Measured is", {number: "Paper"}, {number: "Measured"}, "Verdict", "Why, and of what"],
            data.claims.map((c) => [c.claim, c.quantity, {number: range(c.paper)}, {number: range(c.measured)},
                element("b", {class: look[c.verdict]}, c.verdict),
                element("div", {class: "small"}, c.why, c.evidence.length < 2 ? null :
                    element("details", {}, element("summary", {}, `${c.evidence.length} numbers`),
                            element("div", {}, c.evidence.map((e) => element("div", {}, `${e.of}: ${e.value.toFixed(2)}`)))))]));
  if (data.left_out.length)
    byId("left-out").append(element("div", {class: "panel notice small"}, element("b", {}, "Left out: "),
                                    data.left_out.map((part) => `${part.what} (${part.why})`).join("; ")));
}

// Table 1's columns: a variant, its name, and the paper's.
const ways = [["xor-paper", "pf", "fps_peaks"], ["xor", "pf, divided"], ["post", "pc", "fps_post"], ["preintegrated", "pi", "fps_preintegrated"],
              ["preintegrated-table", "pi, table"]];

function fillTable1() {
  const heads = ["Scene", {number: "samples/r"}, {number: "dvr/r"}, {number: "crossings/r"}, ...ways.map(([, name]) => ({number: `fps ${name}`})),
                 {number: "pf : pc"}, {number: "pf : pi"}];
  fillTable(byId("table1"), heads, data.table1.map((row) => {
    const p = row.paper, peaks = shotOf(row, "xor-paper"), post = shotOf(row, "post");
    return [element("b", {}, row.title), both(number(peaks.samples_per_ray), String(p.samples_per_ray)),
            both(number(post.dvr_samples_per_ray), String(p.dvr_samples_per_ray)), {number: number(peaks.crossings_per_ray)},
            ...ways.map(([id, , paper]) => both(fps(shotOf(row, id).fps), paper && String(p[paper]))),
            both(times(row.ratios.peaks_to_post), times(p.fps_post / p.fps_peaks)),
            both(times(row.ratios.peaks_to_preintegrated), times(p.fps_preintegrated / p.fps_peaks))];
  }));
  fillTable(byId("errors"), ["RMSE", ...ways.map(([, name]) => ({number: name})), {number: "crossings missed: pf"}, {number: "divided"}],
            data.table1.map((row) => [element("b", {}, row.title), ...ways.map(([id]) => ({number: number(shotOf(row, id).error.rmse)})),
                                      ...["xor-paper", "xor"].map((id) => ({number: missed(shotOf(row, id))}))]));
  for (const scene of data.scenes)
    byId("scenes").append(element("p", {class: "small"}, element("b", {}, `${scene.title}: `),
        `${scene.volume}, ${scene.dims.join(" × ")} points; ${scene.preset}. ${scene.note}`));
}

function missed(shot) {
  const c = shot.error.crossings;
  return c ? percent(c.missed / Math.max(c.exact, 1)) : "–";
}

function fillTable2() {
  const heads = ["Held", "Scene", "Method", {number: "Step"}, {number: "fps, uni. / diff."}, {number: "Samples a ray, uni. / diff."},
                 {number: "RMSE, uni. / diff."}, {number: "Diff. is as fast"}];
  const title = (id) => data.scenes.find((scene) => scene.id === id).title;
  const pair = (a, b) => `${a} / ${b}`;
  fillTable(byId("table2"), heads, data.table2.map((row) => {
    const u = row.uniform, d = row.differential, p = row.paper;
    return [row.held, title(row.scene), row.title, {number: number(row.step)},
            both(pair(fps(u.fps), fps(d.fps)), pair(p.fps_uniform, p.fps_differential)),
            both(pair(number(u.samples_per_ray), number(d.samples_per_ray)), p.samples_uniform ? pair(p.samples_uniform, p.samples_differential) : ""),
            {number: pair(number(u.error.rmse), number(d.error.rmse))},
            both(`${row.reached ? "" : "more than "}${times(row.speed_up)}`, times(p.fps_differential / p.fps_uniform))];
  }));
}

function allGroups() {
  const pairs = data.table2.map((row) => ({id: row.group, shots: [row.uniform, row.differential]}));
  return [...data.table1, ...pairs];
}

function fillFigures() {
  const groups = allGroups();
  for (const f of data.figures) {
    if (!f.panels.length) continue;
    const cards = f.panels.map((p) => {
      const shot = shotOf(groups.find((g) => g.id === p.group), p.variant);
      const lost = shot.error.crossings ? `, ${missed(shot)} of the crossings missed` : "";
      const bias = shot.model_difference === null ? "" : `; by design ${number(shot.model_difference)} from the integral`;
      return element("div", {}, element("h3", {}, p.label), element("div", {class: "pair"},
          figure(p.picture, `${fps(shot.fps)} fps${p.paper_fps ? ` (paper: ${p.paper_fps})` : ""}, ${number(shot.samples_per_ray)} samples a ray`),
          figure(p.error_picture, `RMSE ${number(shot.error.rmse)}${lost}${bias}`)));
    });
    byId("figures").append(element("div", {class: "panel"}, element("h3", {}, `Figure ${f.figure}. ${f.title}`),
        f.note ? element("p", {class: "small soft"}, f.note) : null, element("div", {class: "grid"}, cards)));
  }
}

function fillBins() {
  if (!data.bins) return;
  byId("bins-about").textContent = "Twelve peaks, a 125th of the range apart, in noise. Peaks as published against base+crossings, with Table 1's sampling; " +
      "pre-integration against the integral, with its table for a step of 1/2. A table of more bins than separate the peaks is not built: the number used is told.";
  const sizes = [...new Set(data.bins.shots.map((shot) => Number(shot.variant.split("-")[1])))];
  fillTable(byId("bins"), [{number: "Bins"}, {number: "used"}, {number: "Peaks: RMSE"}, {number: "crossings missed"}, {number: "frame"},
                           {number: "Pre-integration: RMSE"}, {number: "frame"}],
            sizes.map((n) => {
              const peaks = shotOf(data.bins, `peaks-${n}`), pre = shotOf(data.bins, `preintegrated-${n}`);
              return [{number: String(n)}, {number: String(peaks.peak_bins)}, {number: number(peaks.error.rmse)},
                      {number: missed(peaks)}, {number: ms(peaks.frame_ms)},
                      {number: pre ? number(pre.error.rmse) : "–"}, {number: pre ? ms(pre.frame_ms) : "–"}];
            }));
}

function fillBuilds() {
  fillTable(byId("builds"), [{number: "Bins"}, {number: "Peak table"}, {number: "Pre-integration table"}, {number: "as fast"}],
            data.builds.map((b) => [{number: String(b.bins)}, {number: ms(b.peak_ms)}, {number: ms(b.preintegration_ms)},
                                    {number: times(b.preintegration_ms / b.peak_ms)}]));
}

function fillMethod() {
  const lines = [
    `Renderer: ${data.renderer}; ${data.processors} processors; ${data.size.join(" × ")} pixels; ${number(data.seconds)} s.`,
    `Differential steps depend on s_k times a pixel's size. The paper's pictures are some ${data.paper_width} pixels wide, with s_k = 4; ` +
        `the same steps take s_k = ${number(data.s_k)} at this size.`,
    "Times are wall clock until the device has finished, medians of at least three rounds in changing order; ratios are medians over the rounds. Shading and early termination are off while anything is measured.",
    "Errors are over the pixels where either picture has alpha > 0, without those whose ray grazes a surface. PEAK_XOR_DVR is compared with base+crossings.",
    "presets/ has each scene with its camera, for crest render and the studio; knoll.csv a row for each measured way; knoll.json all numbers."];
  byId("method").append(...lines.map((line) => element("p", {class: "small"}, line)), command(data.command));
}

byId("subject").textContent = `Tables 1 and 2, figures 3 to 7 and the claims of Knoll et al. 2009; ${data.made_at.replace("T", " ").replace("Z", " UTC")}`;
fillClaims();
fillTable1();
fillTable2();
fillScale();
fillFigures();
fillBins();
fillBuilds();
fillMethod();
