// The table of `crest stability`, group by group.

function count(verdict) { return data.rows.filter((row) => row.verdict === verdict).length; }

function verdictOf(row) {
  const text = row.verdict === "limited" ? `limited: ${row.limit.why}, at most ${number(row.limit.bound)}` : row.verdict;
  return element("span", {class: row.verdict === "pass" ? "met" : "never"}, text);
}

function cellsOf(row) {
  return [row.picture ? element("img", {class: "picture", style: "width: 48px", src: row.picture, alt: row.case}) : "",
          row.case, row.quantity + (row.worst_at ? ` (worst at ${row.worst_at})` : ""), row.truth, {number: number(row.bound)},
          {number: row.measured === null ? "not finite" : number(row.measured)}, verdictOf(row)];
}

function panelOf(group) {
  const table = element("table");
  fillTable(table, ["", "Case", "What is compared", "Truth", {number: "Bound"}, {number: "Measured"}, "Verdict"],
            data.rows.filter((row) => row.group === group).map(cellsOf));
  return element("section", {}, element("h2", {}, group), element("div", {class: "panel scroll"}, table));
}

byId("subject").textContent = data.renderer;
byId("summary").textContent =
    `${data.rows.length} cases: ${count("FAIL")} do not keep their bound, ${count("limited")} keep a measured limit of 32-bit float instead.`;
byId("groups").append(...[...new Set(data.rows.map((row) => row.group))].map(panelOf));
