// The triangle of coefficients (n, m) of one series, order by order. See coefficients.py.

import { Complaint } from "./series.js";
import { superscript } from "./axes.js";
import { element } from "./plot.js";
import { mount } from "./view.js";

const STEP = 0.6; // seconds between two orders while it grows
const REST = 2.4; // seconds that the whole triangle stays

export default { render: (context) => mount(context, build) };

function build(stage) {
  const [name, label, scalar, texts] = ["name", "label", "scalar", "texts"].map(stage.get, stage);
  const series = stage.series(name);
  const cells = [];
  for (const { mode, m, step, values } of series.rows) {
    values.forEach((value, i) => value && cells.push({ ...mode, m: m + step * i, value }));
  }
  if (!cells.length) throw new Complaint(`All coefficients of ${name} are zero.`);
  const both = new Set(cells.map((cell) => cell.sine)).size > 1;
  const rows = [...new Set(cells.map((cell) => 2 * cell.n + cell.sine))].sort((a, b) => b - a);
  const columns = [...new Set(cells.map((cell) => cell.m))].sort((a, b) => a - b);
  const sizes = cells.map((cell) => Math.log10(Math.abs(cell.value)));
  const [least, most] = [Math.min(...sizes), Math.max(...sizes)];

  const grid = stage.panels.appendChild(element("div", "ft-triangle"));
  grid.setAttribute("role", "grid");
  grid.setAttribute("aria-label", `Coefficients of ${name}: rows Fourier order, columns Taylor order`);
  grid.style.gridTemplateColumns = `max-content repeat(${columns.length}, minmax(0, 2.1rem))`;
  const byPlace = new Map();
  for (const row of rows) grid.appendChild(gridRow(row));
  grid.appendChild(scale());
  stage.panels.classList.add("ft-single");
  stage.panels.appendChild(legend());
  const detail = stage.panels.appendChild(element("p", "ft-detail"));
  let chosen = cells[0];

  function gridRow(row) {
    const line = element("div", "ft-row");
    line.setAttribute("role", "row");
    const [n, sine] = [row >> 1, row & 1];
    const head = line.appendChild(element("span", "ft-head", both ? `${sine ? "sin" : "cos"} ${n}` : `${n}`));
    head.setAttribute("role", "rowheader");
    for (const cell of cells.filter((cell) => 2 * cell.n + cell.sine === row)) {
      line.appendChild(place(cell));
    }
    return line;
  }

  function place(cell) {
    const node = (cell.node = element("span", `ft-cell ${cell.value < 0 ? "ft-negative" : "ft-positive"}`));
    const size = (Math.log10(Math.abs(cell.value)) - least) / (most - least || 1);
    node.style.setProperty("--ft-size", `${Math.round(22 + 78 * size)}%`);
    cell.column = columns.indexOf(cell.m);
    node.style.gridColumn = cell.column + 2;
    node.setAttribute("role", "gridcell");
    node.setAttribute("aria-label", spoken(cell));
    node.tabIndex = -1;
    node.addEventListener("pointerenter", () => choose(cell));
    node.addEventListener("focus", () => choose(cell));
    node.addEventListener("click", () => node.focus());
    node.addEventListener("keydown", (event) => move(cell, event));
    byPlace.set(node, cell);
    return node;
  }

  /** The Taylor orders below the triangle: as many as there is room for. */
  function scale() {
    const line = element("div", "ft-row ft-scale");
    line.setAttribute("aria-hidden", "true");
    line.appendChild(element("span", "ft-head", both ? "" : "n ╱ m"));
    const every = Math.ceil(columns.length / 13);
    columns.forEach((m, i) => {
      if (i % every) return;
      const mark = line.appendChild(element("span", "", String(m)));
      mark.style.gridColumn = i + 2;
    });
    return line;
  }

  function legend() {
    const list = element("ul", "ft-legend");
    for (const [kind, text] of [["positive", "positive"], ["negative", "negative"]]) {
      const item = list.appendChild(element("li", ""));
      const swatch = item.appendChild(element("span", `ft-cell ft-${kind} ft-swatch`));
      swatch.style.setProperty("--ft-size", "85%");
      item.append(text);
    }
    const [pale, full] = [least, most].map((size) => `10${superscript(Math.round(size))}`);
    list.appendChild(element("li", "", `size: from ${pale}, pale, to ${full}, full colour`));
    return list;
  }

  function exact({ sine, n, m, value }) {
    return texts[[sine, n, m]] ?? String(value);
  }

  function spoken(cell) {
    const fourier = scalar ? "" : `${both ? (cell.sine ? "sine, " : "cosine, ") : ""}n = ${cell.n}, `;
    return `${label}, ${fourier}m = ${cell.m}: ${exact(cell)}`;
  }

  function choose(cell) {
    chosen.node.tabIndex = -1;
    chosen.node.classList.remove("ft-chosen");
    chosen = cell;
    cell.node.tabIndex = 0;
    cell.node.classList.add("ft-chosen");
    const orders = scalar ? cell.m : `${both ? (cell.sine ? "sin " : "cos ") : ""}${cell.n}, ${cell.m}`;
    const rounded = cell.value.toPrecision(6).replace("-", "−");
    detail.replaceChildren(label, element("sub", "", orders), ` = ${exact(cell)} ≈ ${rounded}`);
  }

  /** Arrow keys: to the nearest visible coefficient in that direction. */
  function move(from, event) {
    const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const shown = cells.filter((cell) => !cell.node.hidden);
    let target;
    if (event.key === "Home") target = shown[0];
    if (event.key === "End") target = shown.at(-1);
    if (event.key in ways) {
      const [dm, dn] = ways[event.key];
      const ahead = ({ n, sine, m }) =>
        dm ? dm * (m - from.m) : dn * (2 * n + sine - 2 * from.n - from.sine);
      const aside = ({ n, sine, m }) =>
        dm ? Math.abs(2 * n + sine - 2 * from.n - from.sine) : 2 * Math.abs(m - from.m);
      target = shown
        .filter((cell) => ahead(cell) > 0)
        .sort((p, q) => 4 * aside(p) + ahead(p) - 4 * aside(q) - ahead(q))[0];
    }
    if (!target) return;
    event.preventDefault();
    target.node.focus();
  }

  function draw() {
    const order = stage.order();
    const newest = Math.max(...columns.filter((m) => m <= order));
    let count = 0;
    for (const cell of cells) {
      const hidden = cell.m > order;
      if (cell.node.hidden !== hidden) cell.node.hidden = hidden;
      cell.node.classList.toggle("ft-new", cell.m === newest);
      count += !hidden;
    }
    if (chosen.m > order) choose(cells[0]);
    if (stage.get("playing") && chosen.m < newest) choose(cells.findLast((cell) => cell.m === newest));
    const noun = count === 1 ? "coefficient that is" : "coefficients that are";
    stage.say(`${name} to order ${order}: ${count} ${noun} not zero`);
  }

  let waited = 0;
  function step(seconds) {
    const order = stage.get("order");
    waited += seconds;
    if (waited < (order < columns.at(-1) ? STEP : REST)) return;
    waited = 0;
    stage.set("order", columns.find((m) => m > order) ?? columns[0]);
  }

  if (stage.get("alone")) stage.playUntilTouched();
  choose(chosen);
  return { draw, step };
}
