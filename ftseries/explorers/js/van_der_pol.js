// Van der Pol's limit cycle by the series in ε, cut off and by Padé. See van_der_pol.py.

import { Complaint, horner, linspace } from "./series.js";
import { short } from "./axes.js";
import { mount } from "./view.js";
import { limitCycle } from "./limit_cycle.js";

const LARGEST = 10; // ε, as in van_der_pol.py
const FLOOR = 1e-14; // below it the error is rounding
const EPSILONS = linspace(0, LARGEST, 81);
const TURN = linspace(0, 2 * Math.PI, 361);
const TWO = linspace(0, 4 * Math.PI, 721);
const COMPARED = [["exact", "integrated"], ["series", "series"], ["second", "Padé"]];

export default { render: (context) => mount(context, build) };

function build(stage) {
  const [x, omega] = [stage.series("x"), stage.series("omega")];
  const sums = new Map(Object.entries(stage.get("pades")).map(([n, parts]) => [Number(n), decoded(parts, Number(n))]));
  const nearest = stage.get("nearest");
  const radius = Math.sqrt(nearest);
  if (!sums.size || !(radius > 0)) throw new Complaint("The Padé approximants are missing.");
  const orders = [...sums.keys()].sort((a, b) => a - b);

  const plane = stage.plot({
    title: "Limit cycle",
    label: "Limit cycle in the phase plane: integrated, by the series and by Padé approximants",
    x: { label: "x", range: [-2.6, 2.6] }, y: { label: "dx/dt" }, legend: COMPARED,
  });
  const motion = stage.plot({
    title: "Motion",
    label: "x(t) over two periods: integrated, by the series and by Padé approximants",
    x: { label: "t" }, y: { label: "x(t)", range: [-3, 3] }, legend: COMPARED,
  });
  const axis = { label: "ε", range: [0, LARGEST] };
  const frequency = stage.plot({
    title: "Frequency",
    label: "The frequency over ε, with the radius of convergence",
    x: axis, y: { label: "ω", range: [0.2, 1.2] }, legend: [...COMPARED, ["limit", `radius, |ε²| = ${nearest.toFixed(4)}`]],
  });
  const error = stage.plot({
    title: "Error of the frequency",
    label: "The error of the frequency over ε, logarithmic, with the radius of convergence",
    x: axis, y: { label: "|Δω|", range: [FLOOR, 10], log: true }, legend: COMPARED.slice(1),
  });
  for (const plot of [frequency, error]) plot.onPoint((eps) => stage.set("eps", Math.round(20 * eps) / 20));
  const truth = Float64Array.from(EPSILONS, (eps) => limitCycle(eps).omega);
  let cycle = limitCycle(1);
  let drawn = 1; // the ε of this cycle

  function draw() {
    const eps = stage.number("eps", 0, LARGEST, "ε");
    const wanted = stage.order();
    const order = orders.findLast((n) => n <= wanted) ?? orders[0];
    const sum = stage.get("resummed") ? sums.get(order) : undefined;
    if (eps !== drawn) [cycle, drawn] = [limitCycle(eps), eps];
    const amplitudes = x.amplitudes(eps, order);
    const w = omega.scalar(eps, order);
    const padé = sum && resum(sum, eps);

    drawPlane(amplitudes, w, padé);
    drawMotion(amplitudes, w, padé);
    drawFrequency(eps, order, sum);

    const [off, better] = [Math.abs(w - cycle.omega), padé && Math.abs(padé.omega - cycle.omega)];
    const side = eps < radius ? "inside" : "beyond";
    stage.say(`ε = ${eps.toFixed(2)}, ${side} the radius ${radius.toFixed(2)}; order ${order}: error of ω ` +
      `${short(off, 1)}` + (padé ? `, by Padé ${short(better, 1)}` : ""));
    stage.show([
      ["ω, integrated", cycle.omega],
      ["ω, series", w],
      ["ω, Padé", padé ? padé.omega : "off"],
      ["radius, |ε²|", nearest.toFixed(4)],
    ]);
    if (!padé && eps > radius) {
      stage.note("Beyond the radius of convergence more orders make the series worse; switch Padé on.");
    }
  }

  function drawPlane(amplitudes, w, padé) {
    const exact = Array.from(TURN, cycle.at);
    plane.y.range = [-1.2, 1.2].map((u) => u * Math.max(...exact.map(([, v]) => Math.abs(v))));
    plane.begin();
    plane.line(exact.map(([place]) => place), exact.map(([, v]) => v), "exact");
    plane.line(x.sample(amplitudes, TURN), x.slope(amplitudes, TURN).map((slope) => w * slope), "series");
    if (padé) plane.line(repeated(padé.x, 2), repeated(padé.v, 2), "second");
  }

  function drawMotion(amplitudes, w, padé) {
    motion.x.range = [0, (4 * Math.PI) / cycle.omega];
    motion.begin();
    motion.line(TWO.map((tau) => tau / cycle.omega), Array.from(TWO, (tau) => cycle.at(tau)[0]), "exact");
    const times = TWO.map((tau) => tau / cycle.omega);
    motion.line(times, x.sample(amplitudes, times.map((t) => w * t)), "series");
    if (padé && padé.omega > 0) {
      const turns = Math.min(40, 2 + Math.ceil((4 * padé.omega) / cycle.omega));
      const places = repeated(padé.x, turns);
      motion.line(places.map((_, i) => (i * Math.PI) / (padé.x.length - 1) / padé.omega), places, "second");
    }
  }

  function drawFrequency(eps, order, sum) {
    const plain = EPSILONS.map((e) => omega.scalar(e, order));
    const resummed = sum && EPSILONS.map((e) => quotient(sum.omega[0], e * e));
    const gap = (values) => values.map((value, i) => Math.max(FLOOR, Math.abs(value - truth[i])));
    for (const [plot, shape] of [[frequency, (values) => values], [error, gap]]) {
      plot.begin();
      if (plot === frequency) plot.line(EPSILONS, truth, "exact");
      plot.line(EPSILONS, shape(plain), "series");
      if (sum) plot.line(EPSILONS, shape(resummed), "second");
      plot.down(radius, "limit");
      plot.down(eps, "guide");
    }
    frequency.dot(eps, cycle.omega, "point");
  }

  return { draw };
}

/** The approximants of one order: lists of [numerator, denominator]; see van_der_pol.py. */
function decoded(parts, order) {
  const read = (name, degree) => {
    const bytes = Uint8Array.from(atob(parts[name] ?? ""), (c) => c.charCodeAt(0));
    const numbers = new Float64Array(bytes.buffer.slice(0, bytes.length - (bytes.length % 8)));
    const size = degree + 1;
    const whole = numbers.length > 0 && numbers.length % (2 * size) === 0;
    if (!whole || !numbers.every(Number.isFinite)) {
      throw new Complaint(`The Padé approximants of order ${order} are missing or not finite.`);
    }
    return Array.from({ length: numbers.length / (2 * size) }, (_, i) =>
      [0, 1].map((j) => numbers.subarray((2 * i + j) * size, (2 * i + j + 1) * size)));
  };
  return { x: read("x", order / 2), slope: read("slope", order / 2), omega: read("omega", order / 4) };
}

function quotient([numerator, denominator], z) {
  return horner(numerator, z) / horner(denominator, z);
}

/** ω, and x and dx/dt at equidistant phases from 0 to π, from those of the first quarter. */
function resum(sum, eps) {
  const omega = quotient(sum.omega[0], eps * eps);
  const quarters = (list, sign) => {
    const far = list.slice(0, -1).reverse().map((pair) => sign * quotient(pair, -eps));
    return list.map((pair) => quotient(pair, eps)).concat(far);
  };
  return { omega, x: quarters(sum.x, -1), v: quarters(sum.slope, 1).map((slope) => omega * slope) };
}

/** Half a period and its mirror images, `halves` times. */
function repeated(half, halves) {
  const rest = half.slice(1);
  const all = [...half];
  for (let i = 1; i < halves; i++) all.push(...rest.map((value) => (i % 2 ? -value : value)));
  return all;
}
