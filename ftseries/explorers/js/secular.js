// The hard spring x'' + x + x³ = 0: exactly, by Taylor and by Fourier and Taylor. See secular.py.

import { linspace } from "./series.js";
import { short } from "./axes.js";
import { mount } from "./view.js";
import { jacobi } from "./elliptic.js";

const END = 60; // of the time axis
const TIMES = linspace(0, END, 961);
const SPEED = 6; // units of time in a second, while the pen draws
const REST = 2; // seconds before it begins again
const LARGEST = 0.9;
const TAYLOR = { color: "c2", width: 1.6 };

/** λ cn(√(1 + λ²) t | m), 1 - m = (2 + λ²)/(2 + 2λ²). */
export function exactly(t, lam) {
  return lam * jacobi(Math.sqrt(1 + lam ** 2) * t, (2 + lam ** 2) / (2 + 2 * lam ** 2)).cn;
}

/** The plain Taylor series in λ, to the order 3. */
export function byTaylor(t, lam) {
  const secular = (-3 / 8) * t * Math.sin(t);
  return lam * Math.cos(t) + lam ** 3 * (secular + (Math.cos(3 * t) - Math.cos(t)) / 32);
}

function build(stage) {
  const [x, omega] = [stage.series("x"), stage.series("omega")];
  const plot = stage.plot({
    label: "x(t) exactly and by two series", aspect: 0.36,
    x: { label: "t", range: [0, END] }, y: { label: "x(t)" },
    legend: [["exact", "exact"], [TAYLOR, "Taylor series"], ["series", "Fourier-Taylor series"]],
  });
  let pen = END;
  let rested = REST;
  stage.playUntilTouched();

  return {
    step(seconds) {
      if (pen < END) pen = Math.min(END, pen + SPEED * seconds);
      else if ((rested += seconds) > REST) [pen, rested] = [0, 0];
    },

    draw() {
      const [lam, order] = [stage.number("lam", 0, LARGEST), stage.order()];
      if (!stage.get("playing")) [pen, rested] = [END, REST];
      const amplitudes = x.amplitudes(lam, order);
      const w = omega.scalar(lam, order);
      const series = x.sample(amplitudes, TIMES.map((t) => w * t));
      const hidden = (t, value) => (t <= pen ? value : NaN);
      const reach = 2.2 * Math.max(lam, 0.02);
      plot.y.range = [-reach, reach];
      plot.begin();
      plot.line(TIMES, TIMES.map((t) => exactly(t, lam)), "exact");
      plot.line(TIMES, TIMES.map((t) => hidden(t, byTaylor(t, lam))), TAYLOR);
      plot.line(TIMES, TIMES.map((t, i) => hidden(t, series[i])), "series");
      if (pen < END) plot.down(pen, "guide");

      const truth = TIMES.map((t) => exactly(t, lam));
      const worst = (values) => Math.max(...values.map((value, i) => Math.abs(value - truth[i])));
      const [plain, both] = [worst(TIMES.map((t) => byTaylor(t, lam))), worst(series)];
      const state = `λ = ${lam.toFixed(2)}, order ${order}, largest error up to t = ${END}: ` +
        `Taylor ${short(plain)}, Fourier-Taylor ${short(both)}`;
      stage.say(state);
      plot.describe(`x(t) exactly and by two series: ${state}`);
      stage.show([["ω", w], [`x(${END}), exact`, exactly(END, lam)],
        [`x(${END}), Taylor`, byTaylor(END, lam)],
        [`x(${END}), Fourier-Taylor`, x.at(amplitudes, w * END)]]);
    },
  };
}

export default { render: (context) => mount(context, build) };
