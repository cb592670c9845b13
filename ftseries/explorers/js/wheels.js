// Rotating arrows whose lengths are power series in λ and whose tips draw the eight. See wheels.py.
//
//   r_12 = Σ c_n cos nt,  c_n = X_n(λ) + i Y_n(λ):  the arrows c_n/2 e^{int} and c_n/2 e^{-int};
//   r_3 = Σ d_n sin nt,   d_n = -(2/3) sin(2πn/3) c_n, by (E4a):  d_n/2i e^{int} and -d_n/2i e^{-int}.

import { linspace } from "./series.js";
import { mount } from "./view.js";

const RANGE = [0, 2.2];
const GRID = linspace(0, 2 * Math.PI, 241);
const LAMBDAS = linspace(...RANGE, 89);
const COLORS = { 0: "c4", 1: "c1", 2: "c2", 4: "c3", 5: "c5" };
const LOOKS = [[0, []], [1, []], [2, [7, 4]], [4, [2, 3]], [5, [7, 3, 2, 3]]];

function build(stage) {
  const wheels = new Wheels(stage.series("x"), stage.series("y"));
  const order = stage.stored;
  const plane = (title, label, half, tip) =>
    stage.plot({
      title, label, equal: true, aspect: 1.25,
      x: { label: "x", range: [-0.75 * half, 0.75 * half] }, y: { label: "y", range: [-half, half] },
      legend: [[{ color: "muted", width: 1.2 }, tip]],
    });
  const relative = plane("From body 2 to body 1", "Arrows that draw r₁₂", 2.2, "where its tip goes");
  const body = plane("Body 3", "Arrows that draw the orbit of body 3", 1.2, "the orbit");
  const lengths = stage.plot({
    title: "Lengths", label: "Lengths of the arrows against λ",
    x: { label: "λ", range: RANGE }, y: { label: "length", range: [-0.5, 2.1] },
    legend: LOOKS.map(([n, dash]) => [{ color: COLORS[n], width: 2, dash }, n ? `n = ±${n}` : "n = 0"]),
  });
  const curves = LOOKS.map(() => []);
  for (const lam of LAMBDAS) {
    wheels.set(lam, order);
    LOOKS.forEach(([n], i) => curves[i].push(wheels.length(n)));
  }
  lengths.onPoint((lam) => stage.set("lam", Number(lam.toFixed(2))));
  let time = stage.get("t");
  stage.playUntilTouched();

  return {
    step(seconds) {
      time = (time + 0.8 * seconds) % (2 * Math.PI);
      stage.set("t", time);
    },

    draw() {
      const { panels } = stage;
      const wide = stage.root.clientWidth > 620;
      const columns = wide ? "repeat(3, minmax(0, 1fr))" : "";
      lengths.aspect = wide ? 1.25 : 0.7;
      if (panels.style.gridTemplateColumns !== columns) panels.style.gridTemplateColumns = columns;
      const lam = stage.number("lam", ...RANGE);
      time = stage.number("t", 0, 2 * Math.PI);
      wheels.set(lam, order);
      drawArms(relative, wheels.relative(time), Array.from(GRID, (t) => wheels.tip(wheels.relative(t))));
      drawArms(body, wheels.body(time), Array.from(GRID, (t) => wheels.tip(wheels.body(t))));

      lengths.begin();
      lengths.across(0, { color: "muted", width: 1.2 });
      LOOKS.forEach(([n, dash], i) => lengths.line(LAMBDAS, curves[i], { color: COLORS[n], width: 2, dash }));
      lengths.down(lam, "guide");
      LOOKS.forEach(([n]) => lengths.dot(lam, wheels.length(n), { color: COLORS[n] }, 4));

      const still = wheels.length(0);
      const length = Math.abs(still).toFixed(3);
      const verdict = Number(length) === 0 ? "it is gone, so three such vectors close" : "it is a third of the gap";
      const text = `λ = ${lam.toFixed(3)}: the arrow that does not turn has the length ${length}; ${verdict}.`;
      stage.say(text);
      relative.describe(`Arrows that draw r₁₂: ${text}`);
    },
  };
}

/** The modes of r_12 at one λ, and arms [n, x, y] from them. */
class Wheels {
  constructor(x, y) {
    Object.assign(this, { x, y });
  }

  set(lam, order) {
    const read = (series) => {
      const values = series.amplitudes(lam, order);
      return series.modes.map(({ n }, i) => [n, values[i]]);
    };
    const real = read(this.x).map(([n, value]) => [n, value, 0]);
    const imaginary = read(this.y).map(([n, value]) => [n, 0, value]);
    this.modes = [...real, ...imaginary].sort((a, b) => a[0] - b[0]);
    return this;
  }

  /** The amplitude c_n with its sign: X_n or Y_n; an arrow of n > 0 has half of it. */
  length(n) {
    const [, x, y] = this.modes.find((mode) => mode[0] === n) ?? [n, 0, 0];
    return (n ? 0.5 : 1) * (x + y);
  }

  relative(t) {
    return this.modes.flatMap(([n, x, y]) => {
      if (n === 0) return [[0, x, y]];
      return [turned(n, x / 2, y / 2, t), turned(-n, x / 2, y / 2, t)];
    });
  }

  body(t) {
    return this.modes.flatMap(([n, x, y]) => {
      const factor = (-2 / 3) * Math.sin((2 * Math.PI * n) / 3);
      if (n === 0) return [];
      const [u, v] = [(factor * y) / 2, (-factor * x) / 2]; // d_n / 2i
      return [turned(n, u, v, t), turned(-n, -u, -v, t)];
    });
  }

  tip(arms) {
    return arms.reduce(([a, b], [, x, y]) => [a + x, b + y], [0, 0]);
  }
}

function turned(n, x, y, t) {
  const [c, s] = [Math.cos(n * t), Math.sin(n * t)];
  return [n, x * c - y * s, x * s + y * c];
}

/** Arrows one after the other from the origin, each on its wheel, and the path of the last tip. */
function drawArms(plot, arms, path) {
  plot.begin();
  plot.line(path.map((p) => p[0]), path.map((p) => p[1]), { color: "muted", width: 1.4 });
  let [x, y] = [0, 0];
  for (const [n, dx, dy] of arms) {
    const length = Math.hypot(dx, dy);
    const color = COLORS[Math.abs(n)] ?? "muted";
    const circle = linspace(0, 2 * Math.PI, 61);
    if (n) {
      plot.line(circle.map((u) => x + length * Math.cos(u)), circle.map((u) => y + length * Math.sin(u)), { color: "faint", width: 1, alpha: 0.6 });
    }
    plot.arrow(x, y, x + dx, y + dy, { color, width: 2.2 }, 9);
    [x, y] = [x + dx, y + dy];
  }
  plot.dot(x, y, { color: "ink" }, 5);
}

export default { render: (context) => mount(context, build) };
