// A particle in the cubic well, and where the series believes it to be. See rolling.py.

import { linspace } from "./series.js";
import { short } from "./axes.js";
import { mount } from "./view.js";
import { energy, frequency, position, potential, top } from "./elliptic.js";

const LARGEST = 3; // the separatrix, a = 1
const TOUR = [0.5, 1.5, 2.3, 2.8, 2.97];
const STAY = 7; // units of time at each λ of the tour
const SPEED = 0.8; // units of time in a second
const LAMS = Float64Array.from(linspace(0, 1, 201), (u) => LARGEST * (1 - (1 - u) ** 3));
const RANGE = [-4.5, 2.6];

function build(stage) {
  const [x, omega] = [stage.series("x"), stage.series("omega")];
  const well = stage.plot({
    title: "The particle", label: "The particle in its well", aspect: 0.62,
    x: { label: "x", range: RANGE }, y: { label: "V(x)" },
    legend: [["ink", "V(x)"], ["limit", "energy"], ["exact", "particle"], ["series", "by the series"]],
  });
  const chart = stage.plot({
    title: "Its frequency", label: "Frequency over λ", aspect: 0.62,
    x: { label: "λ", range: [0, LARGEST] }, y: { label: "ω", range: [0, 3.7] },
    legend: [["exact", "exact"], ["series", "series"]],
  });
  chart.onPoint((lam) => stage.set("lam", Math.max(0.1, Number(lam.toFixed(2)))));
  const truth = LAMS.map(frequency);
  let time = 0;
  let touring = true;
  let shown;
  stage.playUntilTouched();

  return {
    step(seconds) {
      time += SPEED * seconds;
      if (!touring || time < STAY) return;
      time = 0;
      shown = TOUR[(TOUR.indexOf(shown) + 1) % TOUR.length];
      stage.set("lam", shown);
    },

    draw() {
      const [lam, order] = [stage.number("lam", 0.1, LARGEST), stage.order()];
      shown ??= lam;
      if (lam !== shown) [time, touring, shown] = [0, false, lam];
      const w = omega.scalar(lam, order);
      const believed = x.at(x.amplitudes(lam, order), w * time);
      const place = position(time, lam);

      const [summit, E] = [top(lam), energy(lam)];
      const height = potential(summit, lam);
      well.y.range = [-1.25 * height, 1.4 * height];
      well.begin();
      const places = linspace(...RANGE, 181);
      well.line(places, places.map((s) => potential(s, lam)), "ink");
      well.line([-1 - lam, -1 + lam], [E, E], "limit");
      well.dot(place, potential(place, lam), { color: "muted" }, 10);
      well.dot(believed, potential(believed, lam), "series", 6);

      chart.begin();
      chart.line(LAMS, truth, "exact");
      chart.line(LAMS, LAMS.map((l) => omega.scalar(l, order)), "series");
      chart.down(lam, "guide");
      chart.dot(lam, frequency(lam), { color: "muted" }, 7);
      chart.dot(lam, w, "series", 5);

      const away = Math.abs(w / frequency(lam) - 1);
      const words = lam >= LARGEST ? "the particle stays on the top for ever"
        : away < 0.005 ? "the series holds" : "the series runs ahead of the particle";
      const state = `λ = ${lam.toFixed(2)}, order ${order}, ω off by ${short(100 * away)} %: ${words}`;
      stage.say(lam >= LARGEST ? `λ = ${lam.toFixed(2)}, order ${order}: ${words}` : state);
      well.describe(`The particle in its well: ${state}`);
      stage.show([["ω, series", w], ["ω, exact", frequency(lam)]]);
    },
  };
}

export default { render: (context) => mount(context, build) };
