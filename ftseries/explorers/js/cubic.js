// The cubic oscillator, x'' = -V'(x): potential, motion, error and phase portrait. See cubic.py.

import { linspace } from "./series.js";
import { short } from "./axes.js";
import { mount } from "./view.js";
import { energy, frequency, position, potential, speed, top } from "./elliptic.js";

export const END = 6; // of the time axis, about three periods
const TIMES = linspace(0, END, 481);
const FLOOR = 1e-16; // below it the difference is rounding

export default { render: (context) => mount(context, build) };

function build(stage) {
  const [x, omega] = [stage.series("x"), stage.series("omega")];
  const COMPARED = [["exact", "exact"], ["series", "series"]];
  const hill = stage.plot({
    title: "Potential and energy",
    label: "Potential V(x) with the energy line and the particle",
    x: { label: "x" }, y: { label: "V(x)" },
    legend: [["ink", "V(x)"], ["limit", "energy E"], ["series", "particle"]],
  });
  const motion = stage.plot({
    title: "Motion",
    label: "x(t) by the series and exactly",
    x: { label: "t", range: [0, END] }, y: { label: "x(t)" }, legend: COMPARED,
  });
  const error = stage.plot({
    title: "Difference",
    label: "Difference between series and exact solution against time, logarithmic",
    x: { label: "t", range: [0, END] }, y: { label: "|series − exact|", log: true, range: [FLOOR, 30] },
    legend: [["error", "|series − exact|"]],
  });
  const phase = stage.plot({
    title: "Phase portrait",
    label: "Phase portrait: velocity against position, with the separatrix",
    x: { label: "x" }, y: { label: "dx/dt" },
    legend: [["exact", "exact"], ["series", "series"], ["second", "separatrix"]],
  });
  motion.onPoint((t) => stage.set("t", t));
  error.onPoint((t) => stage.set("t", t));

  function draw() {
    const [order, lam] = [stage.order(), stage.number("lam", 0, 3.5)];
    const t = stage.number("t", 0, END);
    const exists = lam <= 3;
    const amplitudes = x.amplitudes(lam, order);
    const w = omega.scalar(lam, order);
    const series = x.sample(amplitudes, TIMES.map((time) => w * time));
    const exact = TIMES.map((time) => (exists ? position(time, lam) : NaN));
    const here = { series: x.at(amplitudes, w * t), exact: exists ? position(t, lam) : NaN };
    const largest = series.reduce((most, value, i) => Math.max(most, Math.abs(value - exact[i])), 0);

    drawHill(lam, here);
    const reach = 1.12 * Math.max(lam, 0.1);
    motion.y.range = [-1 - reach, -1 + reach];
    motion.begin();
    motion.line(TIMES, exact, "exact");
    motion.line(TIMES, series, "series");
    motion.down(t, "guide");
    motion.dot(t, here.exact, PALE);
    motion.dot(t, here.series, "series");

    error.begin();
    error.line(TIMES, series.map((value, i) => Math.max(FLOOR, Math.abs(value - exact[i]))), "error");
    error.down(t, "guide");
    drawPhase(lam, here, amplitudes, w, t);

    const size = exists ? `largest error ${short(largest, 1)}` : "no periodic solution";
    stage.say(`order ${order}, λ = ${lam.toFixed(2)}, ${size}`);
    stage.show([
      ["ω, series", w],
      ["ω, exact", exists ? frequency(lam) : "none"],
      [`x(${t.toFixed(2)}), series`, here.series],
      [`x(${t.toFixed(2)}), exact`, exists ? here.exact : "none"],
    ]);
    if (!exists) {
      stage.note("Past λ = 3a the particle starts beyond the top of the potential and escapes; the " +
        "series still draws an oscillation.");
    }
  }

  function drawHill(lam, here) {
    const [summit, E] = [top(lam), energy(lam)];
    hill.x.range = [-2 * summit - 0.5, 1.75 * summit + 0.35];
    hill.y.range = [-1.15 * potential(summit, lam), 1.3 * potential(summit, lam)];
    hill.begin();
    const places = linspace(...hill.x.range, 161);
    hill.line(places, places.map((place) => potential(place, lam)), "ink");
    hill.line([-1 - lam, -1 + lam], [E, E], "limit");
    for (const [place, style] of [[here.exact, PALE], [here.series, "series"]]) {
      hill.line([place, place], [potential(place, lam), E], { ...GAP, color: style.color ?? "c1" });
      hill.dot(place, potential(place, lam), style, 6);
    }
  }

  function drawPhase(lam, here, amplitudes, w, t) {
    const [summit, E] = [top(lam), energy(lam)];
    const fastest = speed(-summit, lam, potential(summit, lam));
    phase.x.range = hill.x.range;
    phase.y.range = [-1.15 * fastest, 1.15 * fastest];
    phase.begin();
    const places = linspace(-2 * summit, phase.x.range[1], 241);
    const rim = places.map((place) => speed(place, lam, potential(summit, lam)) || 0);
    phase.line(places, rim, "second");
    phase.line(places, rim.map((p) => -p), "second");
    if (lam <= 3) {
      const inside = linspace(0, Math.PI, 181).map((u) => -1 - lam * Math.cos(u));
      const orbit = inside.map((place) => speed(place, lam, E) || 0);
      phase.line(inside, orbit, "exact");
      phase.line(inside, orbit.map((p) => -p), "exact");
    }
    const taus = linspace(0, 2 * Math.PI, 241);
    phase.line(x.sample(amplitudes, taus), x.slope(amplitudes, taus).map((slope) => w * slope), "series");
    phase.dot(here.series, w * x.slope(amplitudes, [w * t])[0], "series");
  }

  function step(seconds) {
    stage.set("t", (stage.get("t") + seconds) % END);
  }

  return { draw, step };
}

const PALE = { color: "muted" };
const GAP = { width: 1.5, dash: [3, 3], alpha: 0.8 };
