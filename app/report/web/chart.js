// What Crest's pages share: small helpers for elements and numbers, and a log-log diagram as SVG.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);

// element("td", {class: "number"}, "text", child, ...)
function element(name, attributes = {}, ...children) {
  return fill(document.createElement(name), attributes, children);
}

function svg(name, attributes = {}, ...children) {
  return fill(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, children);
}

function fill(node, attributes, children) {
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return node;
}

function byId(id) { return document.getElementById(id); }

// Three significant digits, as people write them.
function number(value) {
  if (value === null || value === undefined) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1000) return value.toFixed(0);
  if (size >= 0.001) return String(Number(value.toPrecision(3)));
  const [digits, exponent] = value.toExponential(1).split("e");
  return `${digits}·10${superscript(Number(exponent))}`;
}

function superscript(n) {
  return String(n).replace("-", "⁻").replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]);
}

function percent(share) { return `${number(100 * share)} %`; }
function ms(time) { return time === null ? "–" : time >= 10000 ? `${number(time / 1000)} s` : `${number(time)} ms`; }

// 0.25 -> "1/4": steps are powers of two.
function stepText(step) { return step === null ? "–" : step < 1 ? `1/${number(1 / step)}` : number(step); }

// rows: arrays of cells; a cell is text, a node, or {number: text}.
function fillTable(table, heads, rows) {
  const cell = (name) => (content) =>
    content !== null && typeof content === "object" && "number" in content
      ? element(name, {class: "number"}, content.number)
      : element(name, {}, content);
  table.replaceChildren(element("thead", {}, element("tr", {}, heads.map(cell("th")))),
                        element("tbody", {}, rows.map((row) => element("tr", {}, row.map(cell("td"))))));
}

// A command that breaks between its options only, and is copied as it is.
function command(text) {
  return element("code", {class: "command"}, text.split(/ (?=-)/).flatMap((part) => [element("span", {class: "word"}, part), " "]));
}

// The bar of error_scale_json(), into the element with the id "scale".
function fillScale() {
  const s = data.error_scale, bar = element("div", {class: "bar", style: `background: linear-gradient(to right, ${s.colors.join(",")})`});
  const place = (value) => 100 * Math.log10(value / s.least) / Math.log10(s.most / s.least);
  for (const [value, text] of [[1e-5, "≤ 10⁻⁵"], [1e-4, "10⁻⁴"], [1e-3, "10⁻³"], [1 / 255, "1/255"], [0.1, "0.1"], [1, "1"]])
    bar.append(element("span", {style: `left: ${place(value)}%`}, text));
  const swatch = (color, text) => element("span", {}, element("span", {class: "swatch", style: `background: ${color}`}), text);
  byId("scale").append(bar, swatch(s.not_compared, "nothing shown in either"), swatch(s.grazing, "grazing a surface, compared apart"));
}

// A picture among data.pictures, by its file name.
function figure(file, caption) {
  return element("figure", {}, element("img", {class: "picture", src: data.pictures[file], alt: caption, title: file}), element("figcaption", {}, caption));
}

const tooltip = byId("tooltip");

function showTooltip(event, content) {
  tooltip.replaceChildren(...content);
  tooltip.hidden = false;
  const box = tooltip.getBoundingClientRect(), margin = 14;
  const x = Math.min(event.pageX + margin, scrollX + innerWidth - box.width - margin);
  const above = event.clientY + box.height + 2 * margin > innerHeight;
  tooltip.style.left = `${x}px`;
  tooltip.style.top = `${above ? event.pageY - box.height - margin : event.pageY + margin}px`;
}

function hideTooltip() { tooltip.hidden = true; }

const markPaths = [  // within a square from -1 to 1
  "M-1 0A1 1 0 1 1 1 0A1 1 0 1 1 -1 0Z", "M-.9-.9H.9V.9H-.9Z", "M0-1.2L1.1.8H-1.1Z", "M0-1.25L1.25 0L0 1.25L-1.25 0Z",
  "M0 1.2L1.1-.8H-1.1Z", "M-1.1-.4H-.4V-1.1H.4V-.4H1.1V.4H.4V1.1H-.4V.4H-1.1Z"];

// The n-th series' look, in lines, marks and legends.
function seriesStyle(n) {
  return {color: `var(--s${n % 8})`, mark: markPaths[n % markPaths.length], dash: n % 2 ? "5 3" : "none"};
}

function legend(series) {
  return element("div", {class: "legend"}, series.map((s) => {
    const entry = element("span", {},
        svg("svg", {viewBox: "0 0 26 12"},
            svg("line", {x1: 0, x2: 26, y1: 6, y2: 6, stroke: s.style.color, "stroke-width": 1.8, "stroke-dasharray": s.style.dash}),
            svg("path", {d: s.style.mark, transform: "translate(13 6) scale(4.2)", fill: s.style.color})),
        s.name);
    entry.dataset.series = s.name;
    return entry;
  }));
}

function decades(low, high) {
  const list = [];
  for (let e = Math.floor(low); e <= Math.ceil(high); ++e) list.push(e);
  return list;
}

// A log-log diagram. series: [{name, style, points: [{x, y, label, onFront, chosen, tip, click}]}]; a y of 0 lies in a lane
// of its own at the bottom. target: {y, text} or null. Returns an element: the diagram with its legend.
function logLogChart({series, xTitle, yTitle, target, front}) {
  const width = 1040, height = 470, left = 78, right = 22, top = 16, bottom = 52;
  const all = series.flatMap((s) => s.points);
  const positive = all.map((p) => p.y).concat(target && target.y > 0 ? [target.y] : []).filter((y) => y > 0);
  const hasZero = all.some((p) => p.y === 0);
  const xs = all.map((p) => Math.log10(p.x)), ys = positive.map(Math.log10);
  const xLow = Math.min(...xs) - 0.08, xHigh = Math.max(...xs) + 0.08;
  const yLow = (ys.length ? Math.min(...ys) : -3) - 0.15, yHigh = (ys.length ? Math.max(...ys) : 0) + 0.15;
  const floor = height - bottom - (hasZero ? 34 : 0);
  const x = (v) => left + (Math.log10(v) - xLow) / (xHigh - xLow) * (width - left - right);
  const y = (v) => v > 0 ? floor - (Math.log10(v) - yLow) / (yHigh - yLow) * (floor - top) : height - bottom - 12;

  const chart = svg("svg", {class: "chart", viewBox: `0 0 ${width} ${height}`, role: "img"});
  drawGrid(chart, {x, y, xLow, xHigh, yLow, yHigh, left, top, floor, right: width - right, bottom: height - bottom, hasZero});
  chart.append(svg("text", {class: "title", x: (left + width - right) / 2, y: height - 10, "text-anchor": "middle"}, xTitle),
               svg("text", {class: "title", transform: `translate(16 ${(top + floor) / 2}) rotate(-90)`, "text-anchor": "middle"}, yTitle));
  if (target && target.y > 0 && Math.log10(target.y) > yLow)
    chart.append(svg("line", {class: "target", x1: left, x2: width - right, y1: y(target.y), y2: y(target.y)}),
                 svg("text", {class: "target-text", x: left + 6, y: y(target.y) - 6}, target.text));
  if (front.length) chart.append(svg("path", {class: "front", d: pathOf(front.map((p) => [x(p.x), y(p.y)]))}));
  for (const s of series) chart.append(drawSeries(s, x, y));
  const result = element("div", {}, chart, legend(series));
  connectLegend(result);
  return result;
}

function pathOf(points) { return "M" + points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L"); }

function drawGrid(chart, a) {
  for (const e of decades(a.xLow, a.xHigh))
    for (let m = 1; m < 10; ++m) {
      const at = Math.log10(m) + e;
      if (at < a.xLow || at > a.xHigh) continue;
      const px = a.x(10 ** at), labelled = m === 1 || ((m === 2 || m === 5) && a.xHigh - a.xLow < 3.3);
      chart.append(svg("line", {class: labelled ? "grid-line" : "grid-line minor", x1: px, x2: px, y1: a.top, y2: a.bottom}));
      if (labelled) chart.append(svg("text", {x: px, y: a.bottom + 17, "text-anchor": "middle"}, number(m * 10 ** e)));
    }
  for (const e of decades(a.yLow, a.yHigh))
    for (const m of a.yHigh - a.yLow < 2 ? [1, 2, 5] : [1]) {
      const at = Math.log10(m) + e;
      if (at < a.yLow || at > a.yHigh) continue;
      const py = a.y(10 ** at);
      chart.append(svg("line", {class: "grid-line", x1: a.left, x2: a.right, y1: py, y2: py}),
                   svg("text", {x: a.left - 8, y: py + 4, "text-anchor": "end"},
                       m > 1 || e >= -3 ? number(m * 10 ** e) : `10${superscript(e)}`));
    }
  if (a.hasZero)
    chart.append(svg("line", {class: "grid-line", x1: a.left, x2: a.right, y1: a.floor, y2: a.floor}),
                 svg("text", {x: a.left - 8, y: a.bottom - 8, "text-anchor": "end"}, "none"));
}

function drawSeries(s, x, y) {
  const group = svg("g", {class: "series", color: s.style.color});
  group.dataset.series = s.name;
  const points = s.points.map((p) => [x(p.x), y(p.y)]);
  group.append(svg("path", {class: "line", d: pathOf(points), stroke: s.style.color, "stroke-dasharray": s.style.dash}));
  s.points.forEach((p, i) => {
    const [px, py] = points[i];
    if (p.chosen) group.append(svg("circle", {class: "chosen", cx: px, cy: py, r: 10}));
    const mark = svg("path", {class: p.onFront ? "mark on-front" : "mark", d: s.style.mark, stroke: s.style.color, "vector-effect": "non-scaling-stroke",
                              transform: `translate(${px.toFixed(1)} ${py.toFixed(1)}) scale(4.6)`});
    mark.addEventListener("mousemove", (event) => showTooltip(event, p.tip()));
    mark.addEventListener("mouseleave", hideTooltip);
    if (p.click) mark.addEventListener("click", p.click);
    group.append(mark);
  });
  return group;
}

// A legend entry under the mouse dims the other series.
function connectLegend(root) {
  const groups = root.querySelectorAll("g.series");
  for (const entry of root.querySelectorAll(".legend > span")) {
    entry.addEventListener("mouseenter", () => groups.forEach((g) => g.classList.toggle("dim", g.dataset.series !== entry.dataset.series)));
    entry.addEventListener("mouseleave", () => groups.forEach((g) => g.classList.remove("dim")));
  }
}
