// The page of `crest report --study vdls`, from vdls.json.

const series = (id) => data.series.find((s) => s.id === id);
const setupsOf = (s) => s.points[0].timings.map((t) => t.setup);
const rate = (perSecond) => `${number(perSecond / 1e6)} M`;
const megabytes = (bytes) => `${number(bytes / 1e6)} MB`;

function fillVolumes() {
  const heads = ["Volume", "Renderer", {number: "Memory"}, {number: "Views"}, {number: "Frame"}, {number: "Frames/s"},
                 {number: "Samples"}, {number: "Samples/s"}];
  fillTable(byId("table"), heads, data.table.flatMap((row) => row.timings.map((t, n) =>
    [n === 0 ? `${row.title}, ${row.dims.join("×")}` : "", t.setup,
     {number: megabytes(t.setup.startsWith("VDLS") ? row.vdls_bytes : row.raycaster_bytes)}, {number: String(t.views)},
     {number: ms(t.frame_ms)}, {number: number(t.frames_per_second)}, {number: rate(t.samples)}, {number: rate(t.samples_per_second)}])));
  byId("volumes").append(...data.table.map((row) => pair(row.id, row.title, row.largest_difference)));
}

function pair(id, title, difference) {
  return element("div", {class: "panel"}, element("h3", {}, title),
                 element("div", {class: "pair"}, figure(`images/${id}-vdls.png`, "VDLS"), figure(`images/${id}-raycaster.png`, "ray caster")),
                 element("p", {class: "small"}, `largest difference ${number(difference.same_gradients)} with the same gradients, ${number(difference.gradient_volume)} with precomputed ones`));
}

// Beside each time what it is of the first setup's, where there are several.
function timingTable(s, caption) {
  const table = element("table"), setups = setupsOf(s), views = s.points[0].timings[0].views;
  const value = (t, first) => ({number: `${ms(t.frame_ms)}, ${(t.frame_ms / first.frame_ms).toFixed(2)}`});
  if (s.points.length > 1)
    fillTable(table, [s.x_title, ...setups.map((name) => ({number: name}))],
              s.points.map((p) => [p.label, ...p.timings.map((t) => value(t, p.timings[0]))]));
  else
    fillTable(table, ["setup", {number: "frame, ratio to the first"}],
              s.points[0].timings.map((t) => [t.setup, value(t, s.points[0].timings[0])]));
  return element("div", {class: "panel scroll"}, element("h3", {}, s.title), table,
                 element("p", {class: "small"}, `${caption} Mean of ${views} views.`));
}

const fitsOf = (s, setup) => s.fits.filter((f) => f.setup === setup);
const growthText = (f) => f.growth === "proportional" ? `proportional to the ${f.scale} (within ${percent(f.largest_residual)})`
  : f.growth === "linear" ? `a line in the ${f.scale} (within ${percent(f.largest_residual)}) with ${ms(f.fixed_ms)} that do not grow`
  : `no line in the ${f.scale} (off by up to ${percent(f.largest_residual)})`;

function chart(s) {
  const lines = setupsOf(s).map((name, n) => ({
    name, style: seriesStyle(n),
    points: s.points.map((p) => ({x: p.x, y: p.timings[n].frame_ms, onFront: true,
                                  tip: () => [element("b", {}, `${name}, ${p.label}`), ms(p.timings[n].frame_ms)]}))}));
  return element("div", {class: "panel"}, element("h3", {}, s.title),
                 logLogChart({series: lines, xTitle: s.x_title, yTitle: "frame time, ms", target: null, front: []}),
                 ...setupsOf(s).map((name) => element("p", {class: "small"}, `${name}: ${fitsOf(s, name).map(growthText).join("; ")}.`)));
}

function quadtreeFigure(quadtree) {
  const [width, height] = data.size;
  const overlay = svg("svg", {viewBox: `0 0 ${width} ${height}`, class: "picture"},
                      svg("image", {href: data.pictures[quadtree.picture], width, height}),
                      quadtree.nodes.map(([x, y, side]) => svg("rect", {x, y, width: side, height: side, fill: "none",
                                                                        stroke: "#5bb8e0", "stroke-width": 0.3})));
  return element("figure", {class: "panel"}, overlay, element("figcaption", {}, `${quadtree.title}: ${quadtree.nodes.length} active nodes`));
}

function fillQuality() {
  byId("phantom").textContent = `Figure 11: ${data.phantom}, against the integral that is solved ray by ray in double; the numbers are over premultiplied RGBA.`;
  fillTable(byId("quality"), ["Method", {number: "Samples a voxel"}, {number: "RMSE"}, {number: "Largest"}, {number: "Off by > 1/255"}, {number: "FLIP"}],
            data.quality.map((q) => [q.name, {number: number(q.samples_per_voxel)}, {number: number(q.rmse)}, {number: number(q.max)},
                                     {number: percent(q.share)}, {number: number(q.flip)}]));
  byId("phantoms").append(...data.quality.map((q) => element("div", {class: "panel"},
      element("h3", {}, `${q.name}, ${number(q.samples_per_voxel)} a voxel`),
      element("div", {class: "pair"}, figure(q.picture, "picture"), figure(q.error_picture, "difference from the exact one")))));
}

// What the numbers say, in sentences that only state them.
function fillFindings() {
  const largestDifference = (kind) => Math.max(...[...data.table, ...data.filters].map((row) => row.largest_difference[kind]));
  const time = (row, setup) => row.timings.find((t) => t.setup === setup).frame_ms;
  const ratios = (a, b) => data.table.map((row) => `${(time(row, a) / time(row, b)).toFixed(2)} (${row.id})`).join(", ");
  const claims = ["volumes", "images", "rates"].flatMap((id) => setupsOf(series(id)).flatMap((setup) =>
      fitsOf(series(id), setup).map((f) => `${setup}: ${growthText(f)}`)));
  const fastest = series("layers").points.reduce((a, b) => a.timings[0].frame_ms < b.timings[0].frame_ms ? a : b);
  const lines = [
    `Without its speed-ups VDLS takes this many times as long as with the paper's: ${ratios("VDLS basic", "VDLS enhanced")}.`,
    `With the paper's two layers a pass it takes this many times as long as by default: ${ratios("VDLS enhanced", "VDLS")}.`,
    `By default it takes this many times as long as the ray caster without skipping: ${ratios("VDLS", "ray caster")}; as with skipping: ${ratios("VDLS", "ray caster, skipping")}.`,
    `${fastest.label} layers a pass take the least time.`,
    `“Proportional to the data size, image resolution and sampling rate”: ${claims.join("; ")}.`,
    `Both engines show the same: with the same gradients the largest difference of the six volumes and the six filters is ` +
        `${number(largestDifference("same_gradients"))}; with precomputed ones, which in the outermost cells are others, ${number(largestDifference("gradient_volume"))}.`];
  byId("findings").append(...lines.map((line) => element("li", {}, line)));
}

byId("subject").textContent = `${data.size.join(" × ")} pixels; ${data.made_at.replace("T", " ").replace("Z", " UTC")}`;
fillFindings();
fillVolumes();
byId("steps").append(...[
  timingTable(series("intervals"), "Frame time, and its ratio to that without homo-regions."),
  timingTable(series("quadtrees"), "The threshold is the difference of sample counts up to which brothers become one node; 8 where none is named."),
  timingTable(series("layers"), "Frame time, and its ratio to that front to back with the early test.")]);
byId("quadtrees").append(...data.quadtrees.filter((q) => q.nodes.length).map(quadtreeFigure));
byId("scaling").append(...["volumes", "images", "rates"].map((id) => chart(series(id))));
byId("filters").append(...data.filters.map((f) => pair(`filter-${f.name}`, f.name, f.largest_difference)));
fillScale();
fillQuality();
byId("method").append(...[`Renderer: ${data.renderer}; ${data.processors} processors.`,
  "All setups of a table draw the same views turn by turn, after a first frame that is not timed. Samples are counted on four views, at a quarter of the size.",
  "vdls.json has all numbers."].map((line) => element("p", {class: "small"}, line)), command(data.command));
