// The eights of all forces d^-(α+1): orbit, λ and rotation numbers over α. See force_exponent.py.

import { linspace } from "./series.js";
import { short } from "./axes.js";
import { mount } from "./view.js";
import { multiplier, pairs, thirdReturn } from "./choreography.js";

const RANGE = [-0.5, 2]; // of α
const [FINE, COARSE] = [480, 160]; // steps over a third of the period: for numbers, for curves
const GRID = linspace(0, 2 * Math.PI, 361);
const EXPONENTS = linspace(...RANGE, 126);
const ON_CIRCLE = 1e-7; // a modulus beyond 1 + this is instability
const BODIES = ["c2", "c1", "c3"]; // as in the figures

export default { render: (context) => mount(context, build) };

function build(stage) {
  const family = new Family(stage.series("x"), stage.series("y"), stage.series("lam"));
  const plane = stage.plot({
    title: "Three bodies",
    label: "The eight and its three bodies, with the eight of gravitation",
    x: { label: "x", range: [-1, 1] }, y: { label: "y", range: [-1.2, 1.2] },
    equal: true, aspect: 1, legend: [["series", "this force"], ["guide", "gravitation, α = 1"]],
  });
  const axis = { label: "α", range: RANGE };
  const curve = stage.plot({
    title: "λ", label: "λ over α", x: axis, y: { label: "λ", range: [2, 2.12] },
  });
  const turns = stage.plot({
    title: "Rotation numbers",
    label: "The rotation numbers ν over α, where the multipliers lie on the unit circle",
    x: axis, y: { label: "ν", range: [0, 0.5] }, legend: [["series", "on the circle"], ["limit", "α shown"]],
  });
  for (const plot of [curve, turns]) {
    plot.onPoint((alpha) => stage.set("alpha", Math.round(alpha * 100) / 100));
  }
  const newton = family.orbit(1);
  const lams = EXPONENTS.map((alpha) => family.lam(alpha));
  const points = [];
  for (const alpha of EXPONENTS) {
    for (const rho of family.multipliers(alpha, COARSE)) {
      if (Math.abs(Math.hypot(...rho) - 1) < 1e-3) points.push([alpha, rotation(rho)]);
    }
  }

  function draw() {
    const [alpha, t] = [stage.number("alpha", ...RANGE, "α"), stage.number("t", 0, 2 * Math.PI)];
    const orbit = family.orbit(alpha);
    plane.begin();
    plane.line(...newton, "guide");
    plane.line(...orbit, "series");
    family.bodies(alpha, t).forEach(([x, y], i) => plane.dot(x, y, { color: BODIES[i] }, 7));

    const lam = family.lam(alpha);
    curve.begin();
    curve.line(EXPONENTS, lams, "series");
    curve.dot(alpha, lam, "point");

    const rhos = family.multipliers(alpha, FINE);
    const stable = rhos.every((rho) => Math.hypot(...rho) < 1 + ON_CIRCLE);
    turns.begin();
    turns.down(alpha, "limit");
    for (const [a, nu] of points) turns.dot(a, nu, "series", 2.5);
    if (stable) for (const rho of rhos) turns.dot(alpha, rotation(rho), "point", 5);

    const nu = rhos.map(rotation);
    const growth = Math.max(...rhos.map((rho) => Math.hypot(...rho)));
    const verdict = stable
      ? `linearly stable, rotation numbers ${nu.map((value) => short(value, 4)).join(" and ")}`
      : `unstable, disturbances grow ${short(growth, 3)}-fold in a period`;
    stage.say(`α = ${alpha.toFixed(2).replace("-", "−")}, λ = ${lam.toFixed(5)}: ${verdict}`);
    stage.show([
      ["λ", lam],
      ["ν₁", stable ? Math.min(...nu).toFixed(8) : "none"],
      ["ν₂", stable ? Math.max(...nu).toFixed(8) : "none"],
      ["largest multiplier", stable ? "1" : growth.toPrecision(8)],
      ["closest approach", family.closest(alpha).toFixed(6)],
    ]);
  }

  return { draw };
}

/** ν of a multiplier exp(2πiν), folded to 0 … 1/2. */
function rotation([re, im]) {
  return Math.abs(Math.atan2(im, re)) / (2 * Math.PI);
}

/** The orbits as functions of α: series whose Taylor coefficients are read as Chebyshev's. */
class Family {
  constructor(x, y, lam) {
    Object.assign(this, { x, y, series: lam });
  }

  lam(alpha) {
    return amplitudes(this.series, alpha)[0];
  }

  /** r_12 at times. */
  vectors(alpha, times) {
    const [x, y] = [this.x, this.y].map((part) => part.sample(amplitudes(part, alpha), times));
    return { x, y };
  }

  /** (E4a): the three bodies at one time. */
  bodies(alpha, t) {
    const { x, y } = this.vectors(alpha, [t, t - (2 * Math.PI) / 3, t + (2 * Math.PI) / 3]);
    return [[0, 2], [1, 0], [2, 1]].map(([i, j]) => [(x[i] - x[j]) / 3, (y[i] - y[j]) / 3]);
  }

  /** Their common path on GRID. */
  orbit(alpha) {
    const { x, y } = this.vectors(alpha, GRID);
    return [x, y].map((values) => values.map((value, i) => (value - values[(i + 120) % 360]) / 3));
  }

  closest(alpha) {
    const { x, y } = this.vectors(alpha, [Math.PI / 2]);
    return Math.hypot(x[0], y[0]);
  }

  /** The two multipliers of modulus at least 1, by Richardson's extrapolation. */
  multipliers(alpha, steps) {
    const run = (count) => {
      const times = Float64Array.from({ length: 6 * count }, (_, i) => (i * Math.PI) / (3 * count));
      return thirdReturn(this.vectors(alpha, times), alpha, count);
    };
    const [coarse, fine] = [run(steps / 2), run(steps)];
    return pairs(fine.map((row, i) => row.map((value, j) => value + (value - coarse[i][j]) / 15)))
      .map(multiplier);
  }
}

/** Clenshaw's rule for every mode of a series. */
function amplitudes({ modes }, alpha) {
  const u = (2 * (alpha - RANGE[0])) / (RANGE[1] - RANGE[0]) - 1;
  return Float64Array.from(modes, ({ taylor }) => {
    let [b, c] = [0, 0];
    for (let k = taylor.length - 1; k > 0; k--) [b, c] = [taylor[k] + 2 * u * b - c, b];
    return taylor[0] + u * b - c;
  });
}
