// The generalized Mathieu equation: eigenvalue, solution, error and the map of (λ, μ). See mathieu.py.

import { horner, linspace } from "./series.js";
import { short } from "./axes.js";
import { element } from "./plot.js";
import { mount } from "./view.js";
import { eigenfunction, lowest } from "./hill.js";

const [LARGEST, WIDEST] = [3, 0.5]; // λ and |μ|
const [COLUMNS, ROWS] = [61, 41]; // of the map
const PLACES = linspace(0, 2 * Math.PI, 361);
const LAMBDAS = linspace(0, LARGEST, 121);
const [EXACT_TO, FAILED] = [1e-15, 1]; // errors at the ends of the colour scale
// Matplotlib's cividis, equally spaced: readable with every kind of colour vision.
const CIVIDIS = [
  [0, 34, 78], [26, 56, 111], [67, 78, 108], [97, 101, 111], [125, 124, 120],
  [155, 148, 118], [188, 174, 108], [222, 201, 88], [254, 232, 56],
];

export default { render: (context) => mount(context, build) };

function build(stage) {
  const [psi, a] = [stage.series("psi"), stage.series("a")];
  const region = stage.get("region");
  const curve = stage.plot({
    title: "Eigenvalue",
    label: "The eigenvalue a against λ: series and Hill matrix",
    x: { label: "λ", range: [0, LARGEST] }, y: { label: "a" },
    legend: [["exact", "Hill matrix"], ["series", "series"], ["limit", "radius of convergence"]],
  });
  const map = stage.plot({
    title: "Where the series holds",
    label: "Map over λ and μ: error of the eigenvalue, with the radius of convergence",
    x: { label: "λ", range: [0, LARGEST] }, y: { label: "μ", range: [-WIDEST, WIDEST] },
    legend: [[EDGE, "radius of convergence"]],
  });
  map.figure.appendChild(colourBar());
  map.onPoint((lam, mu) => {
    stage.set("lam", Math.round(lam * 100) / 100);
    stage.set("mu", Math.round(mu * 100) / 100);
  });
  const ANGLES = { label: "x", range: [0, 2 * Math.PI], ticks: linspace(0, 2 * Math.PI, 5), format: multiple };
  const wave = stage.plot({
    title: "Periodic solution",
    label: "ψ(x) by the series and by the Hill matrix",
    x: ANGLES, y: { label: "ψ(x)" }, legend: [["exact", "Hill matrix"], ["series", "series"]],
  });
  const error = stage.plot({
    title: "Difference",
    label: "Difference of ψ between series and Hill matrix, logarithmic",
    x: ANGLES, y: { label: "|series − Hill matrix|", log: true, range: [1e-16, 30] },
    legend: [["error", "|series − Hill matrix|"]],
  });

  const mus = linspace(-WIDEST, WIDEST, ROWS);
  const lambdas = linspace(0, LARGEST, COLUMNS);
  const truth = []; // a of the Hill matrix on the map's grid
  const tables = []; // Taylor coefficients of a, for each μ of the grid
  for (const mu of mus) {
    truth.push(lambdas.map((lam) => lowest(lam, mu).a));
    a.setParameter(mu);
    tables.push(Float64Array.from(a.modes[0].taylor));
  }
  const cache = { image: {}, curve: {} };

  function draw() {
    const order = stage.order();
    const [lam, mu] = [stage.number("lam", 0, LARGEST), stage.number("mu", -WIDEST, WIDEST, "μ")];
    a.setParameter(mu);
    psi.setParameter(mu);
    const hill = lowest(lam, mu);
    const value = a.scalar(lam, order);
    const radius = edge(region, mu);

    if (cache.curve.mu !== mu) cache.curve = { mu, exact: LAMBDAS.map((l) => lowest(l, mu).a) };
    const [low, high] = [Math.min(...cache.curve.exact), Math.max(...cache.curve.exact)];
    const room = 0.12 * (high - low);
    curve.y.range = [low - room, high + room];
    curve.begin();
    curve.line(LAMBDAS, cache.curve.exact, "exact");
    curve.line(LAMBDAS, inside(LAMBDAS.map((l) => a.scalar(l, order)), curve.y.range), "series");
    curve.down(radius, "limit");
    curve.dot(lam, hill.a, { color: "muted" });
    curve.dot(lam, value, "series");

    if (cache.image.order !== order) cache.image = { order, pixels: pixels(order) };
    map.begin();
    map.image(cache.image.pixels, COLUMNS, ROWS);
    map.line(region.radius, region.mu, { color: "#00224e", width: 4, alpha: 0.55 });
    map.line(region.radius, region.mu, EDGE);
    map.dot(lam, mu, "point", 6);

    const amplitudes = psi.amplitudes(lam, order);
    const series = psi.sample(amplitudes, PLACES);
    const exact = eigenfunction(PLACES, hill.c);
    const reach = 1.15 * Math.max(0.1, ...exact.map(Math.abs));
    wave.y.range = [-reach, reach];
    wave.begin();
    wave.line(PLACES, exact, "exact");
    const difference = series.map((y, i) => Math.abs(y - exact[i]));
    const shown = Math.max(...difference) < reach;
    if (shown) wave.line(PLACES, series, "series");
    else wave.text(Math.PI, 0, "the series has no value here", "ink", { align: "center", dy: -14, size: 13 });
    error.begin();
    error.line(PLACES, difference.map((y) => Math.max(1e-16, y)), "error");

    const side = lam < radius ? "inside" : "outside";
    stage.say(
      `order ${order}, λ = ${lam.toFixed(2)}, μ = ${mu.toFixed(2).replace("-", "−")}, ${side} the radius ` +
        `${radius.toFixed(2)}; error of a ${short(Math.abs(value - hill.a), 1)}, of ψ ${short(Math.max(...difference), 1)}`,
    );
    stage.show([
      ["a, series", value],
      ["a, Hill matrix", hill.a],
      ["ψ(π/2), series", psi.at(amplitudes, Math.PI / 2)],
      ["ψ(π/2), Hill matrix", eigenfunction([Math.PI / 2], hill.c)[0]],
    ]);
  }

  /** The map of |a - a of the Hill matrix| as colours. */
  function pixels(order) {
    const bytes = new Uint8ClampedArray(4 * COLUMNS * ROWS);
    let at = 0;
    tables.forEach((taylor, row) => {
      lambdas.forEach((lam, column) => {
        const error = Math.abs(horner(taylor, lam, order) - truth[row][column]);
        bytes.set([...colour(error), 255], at);
        at += 4;
      });
    });
    return bytes;
  }

  return { draw };
}

const EDGE = { color: "#ffffff", width: 2.2, dash: [7, 4], ground: "#434e6c" };

/** The radius of convergence at μ, between the points where Python has computed it. */
function edge({ mu, radius }, at) {
  const i = Math.max(0, mu.findLastIndex((m, j) => m <= at && j < mu.length - 1));
  const part = (at - mu[i]) / (mu[i + 1] - mu[i]);
  return radius[i] + part * (radius[i + 1] - radius[i]);
}

/** Values outside a range become gaps: a series that diverges leaves the picture once. */
function inside(values, [low, high]) {
  return values.map((y) => (y < low || y > high ? NaN : y));
}

function colour(error) {
  const u = Math.log(Math.max(error, EXACT_TO) / EXACT_TO) / Math.log(FAILED / EXACT_TO);
  const place = Math.min(1, u) * (CIVIDIS.length - 1);
  const i = Math.min(CIVIDIS.length - 2, Math.floor(place));
  return CIVIDIS[i].map((c, k) => c + (place - i) * (CIVIDIS[i + 1][k] - c));
}

function colourBar() {
  const bar = element("div", "ft-colourbar");
  bar.append(`error of a:  10⁻¹⁵`, element("span", ""), "1");
  const stops = CIVIDIS.map((c) => `rgb(${c})`).join();
  bar.querySelector("span").style.background = `linear-gradient(to right, ${stops})`;
  return bar;
}

function multiple(x) {
  const quarters = Math.round((2 * x) / Math.PI);
  return ["0", "π/2", "π", "3π/2", "2π"][quarters];
}
