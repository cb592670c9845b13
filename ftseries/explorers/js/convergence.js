// Poles, zeros and the circle of convergence by order; error by order. See convergence.py.

import { Complaint, linspace } from "./series.js";
import { mount } from "./view.js";

const WINDOW = 9; // half the width of the shown part of the plane, as in convergence.py
const TURN = linspace(0, 2 * Math.PI, 181);

export default { render: (context) => mount(context, build) };

function build(stage) {
  const orders = stage.get("orders");
  const [plain, resummed] = [stage.get("plain"), stage.get("resummed")];
  const radius = stage.get("radius");
  if (!orders.length || ![radius, ...plain, ...resummed].every(Number.isFinite)) {
    throw new Complaint("The data of this explorer are missing or not finite.");
  }
  const plane = stage.plot({
    title: "Poles and zeros in the plane of λ²",
    label: "Poles and zeros of the Padé approximant, and the circle of convergence",
    x: { label: "Re λ²", range: [-WINDOW, WINDOW] }, y: { label: "Im λ²", range: [-WINDOW, WINDOW] },
    equal: true,
    legend: [["error", "poles"], ["series", "zeros"], ["limit", "circle of convergence"],
      ["ink", "physical λ²"]],
  });
  const errors = stage.plot({
    title: "Error of S at the true λ",
    label: "The error by Taylor order, truncated and by Padé approximants, on a logarithmic scale",
    x: { label: "Taylor order", range: [orders[0], orders.at(-1)] },
    y: { label: "|S| / S(0)", range: [1e-14, 1], log: true },
    legend: [["series", "truncated"], ["second", "Padé"]],
  });
  errors.onPoint((x) => stage.set("order", orders.reduce(
    (best, n) => (Math.abs(n - x) < Math.abs(best - x) ? n : best))));

  function draw() {
    const wanted = stage.number("order", orders[0], orders.at(-1), "order");
    const i = Math.max(0, Math.min(orders.length - 1, Math.round((wanted - orders[0]) / 2)));
    const [poles, zeros] = [stage.get("poles")[i], stage.get("zeros")[i]];
    plane.begin();
    plane.line(TURN.map((t) => radius * Math.cos(t)), TURN.map((t) => radius * Math.sin(t)), "limit");
    plane.across(0, "faint");
    for (const [x, y] of zeros) plane.dot(x, y, "series", 6);
    for (const [x, y] of poles) plane.dot(x, y, "error", 3.5);
    const physical = stage.get("physical");
    plane.line([physical, physical], [-0.7, 0.7], "ink");

    const shown = (values) => values.map((value) => Math.max(value, 1e-14));
    errors.begin();
    errors.line(orders, shown(plain), "series");
    errors.line(orders, shown(resummed), "second");
    errors.down(orders[i], "guide");
    errors.dot(orders[i], Math.max(plain[i], 1e-14), "series");
    errors.dot(orders[i], Math.max(resummed[i], 1e-14), "second");

    stage.say(`order ${orders[i]}: ${poles.length} poles in view, error ${plain[i].toExponential(0)} ` +
      `truncated, ${resummed[i].toExponential(0)} by Padé`);
    stage.show([["radius in λ²", radius], ["truncated", plain[i].toExponential(3)],
      ["Padé", resummed[i].toExponential(3)]]);
  }

  return { draw };
}
