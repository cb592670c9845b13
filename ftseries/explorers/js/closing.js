// Three relative vectors head to tail, which the reader closes by λ: drag the open end. See closing.py.

import { mount } from "./view.js";
import { BODY_COLORS, CHAIN, drawArrow, drawCorner, drawGap, drawNames, gap } from "./figure_eight_scene.js";
import { Eight, verdict } from "./eight.js";

const RANGE = [0, 2.2];
const REACH = [2.4, 2.05]; // half the width and height shown
const NEAR = 0.04; // the zero of S_x catches a dragged end

function build(stage) {
  const eight = new Eight(stage.series("r"), stage.series("phi"));
  const order = stage.stored;
  const zero = eight.zero(order);
  const plot = stage.plot({
    label: "Three arrows head to tail",
    x: { range: [-REACH[0], REACH[0]] },
    y: { range: [-REACH[1], REACH[1]] },
    equal: true,
    frame: false,
  });
  let time = stage.get("t");
  stage.playUntilTouched();
  plot.onPoint((x) => {
    const lam = lambdaOf(eight, order, zero, 2 * Math.abs(x));
    stage.set("lam", Math.abs(lam - zero) < NEAR ? zero : lam);
  });

  return {
    step(seconds) {
      time = (time + 0.8 * seconds) % (2 * Math.PI);
      stage.set("t", time);
    },

    draw() {
      const lam = stage.number("lam", ...RANGE);
      time = stage.number("t", 0, 2 * Math.PI);
      const relatives = eight.set(lam, order).relatives(time);
      plot.aspect = stage.root.clientWidth > 500 ? 0.52 : 0.85;
      plot.begin();
      drawChain(plot, relatives);
      const S = eight.closure(lam, order);
      const text = `λ = ${lam.toFixed(3)}, gap ${Math.abs(S).toFixed(3)} at every t: ${verdict(S)}.`;
      stage.say(text);
      plot.describe(`The arrows r₂₃, r₁₂, r₃₁ head to tail: ${text}`);
    },
  };
}

/** The λ up to the zero at which the gap has this size, since S_x falls there. */
function lambdaOf(eight, order, zero, size) {
  let [low, high] = [0, zero];
  for (let i = 0; i < 40; i++) {
    const middle = (low + high) / 2;
    if (eight.closure(middle, order) > size) low = middle;
    else high = middle;
  }
  return Number(low.toFixed(3));
}

/** The chain with its gap centred in the picture, and a handle on its open end. */
function drawChain(plot, relatives) {
  const { context, theme } = plot;
  const S = gap(relatives);
  const chain = [[-S[0] / 2, -S[1] / 2]];
  for (const { vector } of CHAIN) {
    chain.push([0, 1].map((i) => chain.at(-1)[i] + relatives[vector][i]));
  }
  const pixels = chain.map(([x, y]) => [plot.px(x), plot.py(y)]);
  drawGap(context, theme, pixels);
  CHAIN.forEach(({ from, to }, k) => {
    const colors = [from, to].map((body) => theme.color(BODY_COLORS[body]));
    drawArrow(context, pixels[k], pixels[k + 1], colors, 4);
  });
  for (const corner of pixels) drawCorner(context, theme, corner);
  const [x, y] = pixels[3];
  context.save();
  context.strokeStyle = theme.color("c4");
  context.lineWidth = 2.5;
  context.beginPath();
  context.arc(x, y, 11, 0, 2 * Math.PI);
  context.stroke();
  context.restore();
  drawNames(context, theme, pixels, Math.hypot(...S));
}

export default { render: (context) => mount(context, build) };
