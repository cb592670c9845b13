// ψ over its potential, and the bands of energy with the dot on their edge. See bands.py.

import { linspace } from "./series.js";
import { short } from "./axes.js";
import { mount } from "./view.js";
import { eigenfunction, lowest } from "./hill.js";

const PLACES = linspace(-Math.PI, Math.PI, 241);
const SLOW = 0.25; // λ in a second, to and fro
const WELL = { color: "muted", width: 2 };
const LEVEL = { color: "c2", width: 1.6, dash: [7, 4] };
const BAND = { color: "c3", alpha: 0.3, width: 9 };

function build(stage) {
  const [psi, a] = [stage.series("psi"), stage.series("a")];
  const { lam: lams, edges } = stage.get("bands");
  const [mu, radius, largest] = [stage.get("mu"), stage.get("radius"), lams.at(-1)];
  const pi = (x) => ["−π", "−π/2", "0", "π/2", "π"][Math.round((2 * x) / Math.PI) + 2];
  const well = stage.plot({
    title: "ψ in the potential", label: "ψ over the potential", aspect: 0.8,
    x: { label: "x", range: [-Math.PI, Math.PI], ticks: linspace(-Math.PI, Math.PI, 5), format: pi },
    y: { label: "energy" },
    legend: [[WELL, "potential"], [LEVEL, "energy a"], ["series", "ψ, on the level a"], [BAND, "bands"]],
  });
  const energies = edges.flat();
  const chart = stage.plot({
    title: "Bands", label: "Bands of energy over λ, with the eigenvalue on an edge", aspect: 0.8,
    x: { label: "λ", range: [0, largest] },
    y: { label: "a", range: [Math.min(...energies) - 0.5, Math.max(...energies) + 0.5] },
    legend: [[BAND, "bands"], ["series", "a, series"], ["limit", "radius of convergence"]],
  });
  chart.onPoint((lam) => stage.set("lam", Number(lam.toFixed(2))));
  let way = 1;
  stage.playUntilTouched();

  return {
    step(seconds) {
      const next = stage.get("lam") + way * SLOW * seconds;
      if (next > radius - 0.05 || next < 0.3) way = next < 0.3 ? 1 : -1;
      stage.set("lam", Math.min(largest, Math.max(0, next)));
    },

    draw() {
      const [lam, order] = [stage.number("lam", 0, largest), stage.order()];
      const energy = a.scalar(lam, order);
      const truth = lowest(lam, mu);
      const exact = eigenfunction(PLACES, truth.c);
      const series = psi.sample(psi.amplitudes(lam, order), PLACES);
      const height = Math.max(...exact.map(Math.abs), 1e-9);
      const miss = Math.max(...series.map((y, i) => Math.abs(y - exact[i])));

      const potential = PLACES.map((x) => lam ** 2 * Math.cos(2 * x) + lam ** 4 * mu * Math.cos(4 * x));
      const [low, high] = [Math.min(...potential, 0), Math.max(...potential, truth.a, 4)];
      const room = 0.12 * (high - low);
      well.y.range = [low - room, high + room];
      const scale = (0.16 * (high - low)) / height;
      well.begin();
      const now = bandsAt(lams, edges, lam);
      for (const [from, to] of now) stripe(well, from, to);
      well.line(PLACES, potential, WELL);
      well.across(truth.a, LEVEL);
      well.line(PLACES, exact.map((y) => truth.a + scale * y), "exact");
      if (miss < 0.5 * height) well.line(PLACES, series.map((y) => truth.a + scale * y), "series");

      chart.begin();
      for (let k = 0; k + 1 < edges.length; k += 2) chart.fill(lams, edges[k], edges[k + 1], BAND);
      const shown = linspace(0, largest, 121);
      const [bottom, top] = chart.y.range;
      const values = shown.map((l) => a.scalar(l, order));
      chart.line(shown, values.map((y) => (y < bottom || y > top ? NaN : y)), "series");
      chart.down(radius, "limit");
      chart.dot(lam, energy, "point", 6);

      const off = Math.abs(energy - truth.a);
      let verdict = "the dot is on the edge of the band";
      if (off > 0.02) verdict = "the dot has left the edge: this order is not enough";
      if (off > 0.02 && lam > radius) verdict = "beyond the radius of convergence no order helps";
      stage.say(
        `order ${order}, λ = ${lam.toFixed(2)}, a = ${energy.toFixed(4).replace("-", "−")}, ` +
          `error of a ${short(off, 1)}, of ψ ${short(miss, 1)}: ${verdict}`,
      );
    },
  };
}

/** The bands at one λ, between the places where Python has computed their edges. */
function bandsAt(lams, edges, lam) {
  const i = Math.min(lams.length - 2, Math.floor((lam / lams.at(-1)) * (lams.length - 1)));
  const part = (lam - lams[i]) / (lams[i + 1] - lams[i]);
  const now = edges.map((edge) => edge[i] + part * (edge[i + 1] - edge[i]));
  return now.flatMap((from, k) => (k % 2 === 0 ? [[from, now[k + 1] ?? 1e3]] : []));
}

/** A band in the left picture, over all x. */
function stripe(plot, from, to) {
  const [low, high] = plot.y.range;
  const [bottom, top] = [Math.max(from, low), Math.min(to, high)];
  if (bottom < top) plot.fill(plot.x.range, [bottom, bottom], [top, top], BAND);
}

export default { render: (context) => mount(context, build) };
