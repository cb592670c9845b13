// Hill's equation: discriminant, multipliers on the unit circle, a solution. See stability.py.

import { linspace } from "./series.js";
import { short } from "./axes.js";
import { mount } from "./view.js";

const [LOWEST, HIGHEST, LARGEST, WIDEST] = [-8, 12, 3, 0.5]; // a, λ, |μ|
const [FINE, COARSE] = [1200, 120]; // steps over π: for numbers, for curves
const ENERGIES = linspace(LOWEST, HIGHEST, 301);
const TURN = linspace(0, 2 * Math.PI, 181);
const CIRCLE = [TURN.map(Math.cos), TURN.map(Math.sin)];
const HALVES = 16; // half periods π of the solution shown

export default { render: (context) => mount(context, build) };

function build(stage) {
  const curve = stage.plot({
    title: "Discriminant",
    label: "The discriminant D against a, with the band between minus 2 and 2",
    x: { label: "a", range: [LOWEST, HIGHEST] }, y: { label: "D", range: [-5, 5] },
    legend: [["series", "D(a)"], ["limit", "edges, D = ±2"]],
  });
  curve.onPoint((a) => stage.set("a", Math.round(a * 100) / 100));
  const circle = stage.plot({
    title: "Multipliers",
    label: "The two multipliers in the complex plane, with the unit circle",
    x: { label: "real part", range: [-2.2, 2.2] }, y: { label: "imaginary part", range: [-1.4, 1.4] },
    equal: true, legend: [["point", "multipliers"], ["faint", "unit circle"]],
  });
  const wave = stage.plot({
    title: "The odd solution",
    label: "The solution that starts at 0 with slope 1, over sixteen half periods",
    x: { label: "x / π", range: [0, HALVES] }, y: { label: "ψ₂(x)" },
  });
  let cache = {};

  function draw() {
    const [lam, mu] = [stage.number("lam", 0, LARGEST), stage.number("mu", -WIDEST, WIDEST, "μ")];
    const a = stage.number("a", LOWEST, HIGHEST, "a");
    if (cache.lam !== lam || cache.mu !== mu) {
      cache = { lam, mu, d: ENERGIES.map((e) => trace(run(e, lam, mu, COARSE))) };
    }
    const matrix = monodromy(a, lam, mu);
    const d = trace(matrix);
    curve.begin();
    curve.across(2, "limit");
    curve.across(-2, "limit");
    curve.line(ENERGIES, cache.d, "series");
    curve.down(a, "guide");
    curve.dot(a, Math.max(-5, Math.min(5, d)), "point");

    const rho = multipliers(d);
    circle.begin();
    circle.line(...CIRCLE, "faint");
    for (const [x, y] of rho) if (Math.abs(x) < 2.2) circle.dot(x, y, "point", 6);

    const path = [];
    run(a, lam, mu, COARSE, HALVES, (psi) => path.push(psi));
    const reach = 1.1 * Math.max(...path.map(Math.abs));
    wave.y.range = [-reach, reach];
    wave.begin();
    wave.line(path.map((_, i) => i / COARSE), path, "series");

    const [place, what] = Math.abs(d) < 2
      ? ["band", `turn by ${short(Math.acos(d / 2), 3)} over π`]
      : ["gap", `growth by ${short(Math.abs(rho[0][0]), 3)} over π`];
    stage.say(`a = ${a.toFixed(2).replace("-", "−")}, λ = ${lam.toFixed(2)}, ` +
      `μ = ${mu.toFixed(2).replace("-", "−")}: ${place}, ${what}`);
    stage.show([
      ["D", d],
      ["multiplier", rho[0][1] ? `${rho[0][0].toFixed(8)} ± ${rho[0][1].toFixed(8)} i` : rho[0][0]],
      ["det M", matrix[0] * matrix[3] - matrix[1] * matrix[2]],
    ]);
  }

  return { draw };
}

const trace = (m) => m[0] + m[3];

/** The two roots of ρ² - Dρ + 1, larger modulus (or upper half plane) first: [[re, im], …]. */
function multipliers(d) {
  const square = (d * d) / 4 - 1;
  const root = Math.sqrt(Math.abs(square));
  if (square < 0) return [[d / 2, root], [d / 2, -root]];
  const large = d / 2 + Math.sign(d) * root;
  return [[large, 0], [1 / large, 0]];
}

/** M over π as [ψ₁, ψ₂, ψ₁', ψ₂'], Richardson's extrapolation of two Runge-Kutta runs. */
function monodromy(a, lam, mu) {
  const [coarse, fine] = [run(a, lam, mu, FINE), run(a, lam, mu, 2 * FINE)];
  return fine.map((value, i) => value + (value - coarse[i]) / 15);
}

/** The classical Runge-Kutta method with `steps` over π; `visit` sees ψ₂ at each step. */
function run(a, lam, mu, steps, halves = 1, visit = () => {}) {
  const h = Math.PI / steps;
  const q = (x) => -a + lam ** 2 * Math.cos(2 * x) + lam ** 4 * mu * Math.cos(4 * x);
  let [u, v, p, r] = [1, 0, 0, 1];
  visit(v);
  for (let n = 0; n < steps * halves; n++) {
    const [q0, q1, q2] = [q(n * h), q((n + 0.5) * h), q((n + 1) * h)];
    [u, p] = step(u, p, q0, q1, q2, h);
    [v, r] = step(v, r, q0, q1, q2, h);
    visit(v);
  }
  return [u, v, p, r];
}

function step(y, s, q0, q1, q2, h) {
  const [k1, l1] = [s, q0 * y];
  const [k2, l2] = [s + (h / 2) * l1, q1 * (y + (h / 2) * k1)];
  const [k3, l3] = [s + (h / 2) * l2, q1 * (y + (h / 2) * k2)];
  const [k4, l4] = [s + h * l3, q2 * (y + h * k3)];
  return [y + (h / 6) * (k1 + 2 * k2 + 2 * k3 + k4), s + (h / 6) * (l1 + 2 * l2 + 2 * l3 + l4)];
}
