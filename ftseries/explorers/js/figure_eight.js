// The explorer of the figure eight: three bodies, their chain of relative vectors, and S_x(λ).
// See figure_eight.py; the mathematics is in eight.js.

import { linspace } from "./series.js";
import { mount } from "./view.js";
import { drawScene, extent, MARGIN } from "./figure_eight_scene.js";
import { bodiesOf, Eight, GRID, subscript, verdict } from "./eight.js";

const RANGE = [0, 2.3];
const TICK = 0.1; // seconds between two reports of the running time to its slider

function build(stage) {
  const eight = new Eight(stage.series("r"), stage.series("phi"));
  const truth = { x: samples(stage.series("x")), y: samples(stage.series("y")) };
  const plot = stage.plot({
    label: "The three bodies",
    title: "Bodies, and relative vectors head to tail",
    x: { label: "x", range: [-1, 1] },
    y: { label: "y", range: [-1, 1] },
    aspect: 1.12,
    equal: true,
    legend: [
      [{ color: "muted", width: 1.2, dash: [5, 4] }, "Newton’s orbit"],
      [{ color: "c4", width: 8, alpha: 0.35 }, "gap S"],
    ],
  });
  const closure = new ClosurePlot(stage, eight);
  const { panels } = stage;
  let time = stage.get("clock");
  let reported = time;
  let waiting = 0;
  let drawn = {};
  if (!stage.reducedMotion()) stage.set("playing", true);

  /** The running time goes to the trait t now and then; another value of t comes from the reader. */
  function report(value) {
    reported = value;
    stage.set("clock", value);
    stage.set("t", value);
  }

  function listen() {
    const t = stage.get("t") || 0;
    const inside = stage.number("t", 0, 2 * Math.PI);
    if (t !== stage.get("clock")) {
      stage.set("playing", false);
      report(t);
      time = inside;
    } else if (t !== reported) {
      reported = t;
      time = inside;
    }
  }

  return {
    step(seconds) {
      time = (time + seconds * stage.number("speed", 0, 10)) % (2 * Math.PI);
      waiting += seconds;
      if (waiting >= TICK) {
        waiting = 0;
        report(time);
      }
    },

    draw() {
      listen();
      const order = stage.order();
      const zero = eight.zero(order);
      if (stage.get("closing")) {
        stage.set("closing", false);
        if (zero <= RANGE[1]) stage.set("lam", zero);
      }
      const lam = stage.number("lam", ...RANGE);
      const playing = stage.get("playing");
      const columns = stage.root.clientWidth > 620 ? "minmax(0, 3fr) minmax(0, 2fr)" : "";
      if (panels.style.gridTemplateColumns !== columns) panels.style.gridTemplateColumns = columns;

      if (drawn.lam !== lam || drawn.order !== order) {
        const S = eight.closure(lam, order);
        const sizes = eight.gaps(lam, order);
        const { vectors, orbit } = eight.set(lam, order).motion();
        drawn = { lam, order, S, orbit, half: extent(vectors, orbit) };
        const text = describe(order, lam, S, sizes);
        stage.say(text);
        plot.describe(`Three bodies on one orbit, and their relative vectors: ${text}`);
      }
      closure.draw(lam, order, drawn.S);
      const relatives = eight.set(lam, order).relatives(time);
      const bodies = bodiesOf(relatives);
      frame(plot, drawn.half);
      drawScene(plot.begin(), { orbit: drawn.orbit, truth, time, relatives, bodies });
      if (!playing || waiting === 0) {
        const digits = playing ? 3 : 11;
        stage.show([
          [`λ${subscript(order)}`, zero],
          ["Sₓ", drawn.S],
          ["t", playing ? time.toFixed(digits) : time],
          ...bodies.map((place, i) => [`r${subscript(i + 1)}`, complex(place, digits)]),
        ]);
      }
    },
  };
}

/** S_x against λ; drawn again only when something in it has changed. */
class ClosurePlot {
  constructor(stage, eight) {
    Object.assign(this, { stage, eight, curves: new Map(), lams: linspace(...RANGE, 93) });
    this.plot = stage.plot({
      label: "Sₓ against λ",
      title: "Gap Sₓ at t = 0",
      x: { label: "λ", range: RANGE },
      y: { label: "Sₓ", range: [-1, 4.5] },
      aspect: 1.1,
      legend: [
        ["series", "this order"],
        ["exact", `order ${stage.stored}`],
      ],
    });
    this.plot.onPoint((lam) => stage.set("lam", Number(lam.toFixed(3))));
  }

  curve(order) {
    if (!this.curves.has(order)) {
      this.curves.set(order, this.lams.map((lam) => this.eight.closure(lam, order)));
    }
    return this.curves.get(order);
  }

  draw(lam, order, S) {
    const { plot, stage, lams } = this;
    plot.aspect = stage.root.clientWidth > 620 ? 1.66 : 0.62;
    const state = [lam, order, plot.figure.clientWidth, plot.aspect, devicePixelRatio];
    const { colors } = stage.theme;
    if (colors === this.colors && state.every((value, i) => value === this.state[i])) return;
    Object.assign(this, { state, colors });
    const zero = this.eight.zero(order);
    const name = `λ${subscript(order)} = ${zero.toFixed(5)}`;
    plot.begin();
    plot.across(0, { color: "muted", width: 1.2 });
    plot.line(lams, this.curve(stage.stored), "exact");
    plot.line(lams, this.curve(order), "series");
    plot.down(zero, { color: "c5", width: 1.5, dash: [3, 3] });
    plot.dot(zero, 0, { color: "c5" }, 5);
    plot.text(zero, 0, name, "ink", { align: "right", dx: -9, dy: 14 });
    plot.line([lam, lam], [0, S], { color: "c4", width: 7, alpha: 0.4 });
    plot.dot(lam, S, { color: "c4" }, 6);
    plot.describe(
      `Sₓ against λ: ${signed(this.curve(order)[0], 2)} at λ = 0, zero at ${name}, ` +
        `${signed(S, 4)} at λ = ${lam.toFixed(3)}.`,
    );
  }
}

/** Show the whole motion, and Newton's, in one scale for x and y, as large as the canvas allows. */
function frame(plot, [halfX, halfY]) {
  const width = plot.figure.clientWidth - 45;
  const height = plot.figure.clientWidth * plot.aspect - 58;
  const [roomX, roomY] = [width / 2 - MARGIN, height / 2 - MARGIN];
  const scale = Math.min(roomX / Math.max(0.5, halfX), roomY / Math.max(1.08, halfY));
  plot.x.range = [-width / 2 / scale, width / 2 / scale];
  plot.y.range = [-height / 2 / scale, height / 2 / scale];
}

/** The verdict is on Sₓ at t = 0, as in the paper; |S|, with its y, varies so much at this order. */
function describe(order, lam, S, sizes) {
  const [least, most] = sizes.map((size) => size.toFixed(3));
  const gaps = least === most
    ? `gap ${most} at all times`
    : `Sₓ = ${S.toFixed(3).replace("-", "−")} at t = 0, gap between ${least} and ${most} in a period`;
  return `order ${order}, λ = ${lam.toFixed(3)}, ${gaps}: ${verdict(S)}.`;
}

function samples(series) {
  return series.sample(series.amplitudes(0, 0), GRID);
}

function signed(value, decimals) {
  return value.toFixed(decimals).replace("-", "−");
}

function complex([x, y], digits) {
  const sign = y < 0 ? "−" : "+";
  return `${signed(x, digits)} ${sign} ${Math.abs(y).toFixed(digits)} i`;
}

export default { render: (context) => mount(context, build) };
