// The picture of the eight: orbit, trails, bodies, and the relative vectors laid head to tail.
//
//   drawScene(plot, scene)     into a plot of plot.js whose begin() has been called, with
//     scene.orbit, scene.truth   closed curves {x, y} of equidistant times: of this λ, of Newton
//     scene.time                 the time t
//     scene.relatives            [r12, r23, r31] at that time, each [x, y];  scene.bodies likewise
//
// The chain is r23, r12, r31, in this order because r23 ends at body 2, where r12 starts, and so
// on. By (E4a) its corners miss the bodies 3, 2, 1, 3 by -S/2, -S/6, S/6, S/2 when the gap is
// centred on body 3: the chain and the triangle of the bodies become one as S goes to zero.

export const BODY_COLORS = ["c2", "c1", "c3"]; // as in the figures
export const CHAIN = [
  { vector: 1, from: 2, to: 1, name: "r₂₃" },
  { vector: 0, from: 1, to: 0, name: "r₁₂" },
  { vector: 2, from: 0, to: 2, name: "r₃₁" },
];
const DELAY = [0, -1 / 3, 1 / 3]; // body 1, 2, 3 on the common orbit, in periods
const RADIUS = 11;
export const MARGIN = 18; // pixels around the motion, for discs and trails
const FADE = 14; // steps of a trail

/** S = r12 + r23 + r31. */
export function gap(relatives) {
  return [0, 1].map((i) => relatives[0][i] + relatives[1][i] + relatives[2][i]);
}

/** The four corners of the chain; the last misses the first by S. */
export function corners(relatives, bodies) {
  const S = gap(relatives);
  const points = [[bodies[2][0] - S[0] / 2, bodies[2][1] - S[1] / 2]];
  for (const { vector } of CHAIN) {
    const [x, y] = points.at(-1);
    points.push([x + relatives[vector][0], y + relatives[vector][1]]);
  }
  return points;
}

/** Half the width and height that hold the whole motion, from r12 and r1 over one period. */
export function extent(vectors, orbit) {
  const third = (orbit.x.length - 1) / 3;
  const at = ({ x, y }, i) => [x[i % (3 * third)], y[i % (3 * third)]];
  const half = [0, 0];
  for (let i = 0; i < 3 * third; i++) {
    const shifts = [i, i + 2 * third, i + third]; // t, t - 2π/3, t + 2π/3
    const relatives = shifts.map((shift) => at(vectors, shift));
    const bodies = shifts.map((shift) => at(orbit, shift));
    for (const point of [...bodies, ...corners(relatives, bodies)]) {
      for (const axis of [0, 1]) half[axis] = Math.max(half[axis], Math.abs(point[axis]));
    }
  }
  return half;
}

export function drawScene(plot, scene) {
  const { context, theme } = plot;
  const pixel = ([x, y]) => [plot.px(x), plot.py(y)];
  const size = Math.hypot(...gap(scene.relatives));
  const chain = corners(scene.relatives, scene.bodies).map(pixel);
  const bodies = scene.bodies.map(pixel);
  context.save();
  context.beginPath();
  context.rect(plot.left, plot.top, plot.right - plot.left, plot.bottom - plot.top);
  context.clip();
  plot.line(scene.truth.x, scene.truth.y, { color: "muted", width: 1.2, dash: [5, 4] });
  plot.line(scene.orbit.x, scene.orbit.y, { color: "muted", width: 1, alpha: 0.4 });
  const physical = Math.max(0, 1 - size / 0.6);
  for (let body = 0; body < 3; body++) drawTrail(plot, scene, body, 0.45 + 0.55 * physical);
  drawGap(context, theme, chain);
  CHAIN.forEach(({ from, to }, k) => {
    const spare = Math.max(4, RADIUS + 2 - distance(chain[k + 1], bodies[to]));
    const colors = [from, to].map((body) => theme.color(BODY_COLORS[body]));
    drawArrow(context, chain[k], chain[k + 1], colors, spare);
  });
  for (const corner of chain) drawCorner(context, theme, corner);
  bodies.forEach((place, body) => drawBody(context, theme, place, body, physical));
  context.restore();
  drawNames(context, theme, chain, size);
}

/** The last third of a period behind a body, thinner and fainter with age. */
export function drawTrail(plot, { orbit, time }, body, strength) {
  const { context, theme } = plot;
  const count = orbit.x.length - 1; // the last point repeats the first
  const head = (time / (2 * Math.PI) + DELAY[body]) * count;
  const length = 0.31 * count;
  const point = (position) => {
    const q = ((position % count) + count) % count;
    const [i, w] = [Math.floor(q), q % 1];
    const mix = (values) => values[i] + w * (values[i + 1] - values[i]);
    return [plot.px(mix(orbit.x)), plot.py(mix(orbit.y))];
  };
  context.save();
  context.strokeStyle = theme.color(BODY_COLORS[body]);
  context.lineCap = "butt";
  for (let k = 0; k < FADE; k++) {
    const [start, end] = [head - length * (1 - k / FADE), head - length * (1 - (k + 1) / FADE)];
    const age = (k + 1) / FADE;
    context.beginPath();
    context.moveTo(...point(start));
    for (let q = Math.floor(start) + 1; q < end; q++) context.lineTo(...point(q));
    context.lineTo(...point(end));
    context.globalAlpha = 0.16 * age * age * strength;
    context.lineWidth = 4 + 12 * age;
    context.stroke();
    context.globalAlpha = (0.05 + 0.8 * age * age) * strength;
    context.lineWidth = 1 + 4.5 * age;
    context.stroke();
  }
  context.restore();
}

export function drawGap(context, theme, chain) {
  context.save();
  context.strokeStyle = theme.color("c4");
  context.lineCap = "round";
  context.beginPath();
  context.moveTo(...chain[0]);
  context.lineTo(...chain[3]);
  context.globalAlpha = 0.3;
  context.lineWidth = 11;
  context.stroke();
  context.restore();
}

export function drawArrow(context, [ax, ay], [bx, by], colors, spare) {
  const length = Math.hypot(bx - ax, by - ay);
  if (length < 2 * spare) return;
  const [ux, uy] = [(bx - ax) / length, (by - ay) / length];
  const [tipX, tipY] = [bx - spare * ux, by - spare * uy];
  const head = Math.min(12, 0.4 * length);
  const gradient = context.createLinearGradient(ax, ay, bx, by);
  gradient.addColorStop(0, colors[0]);
  gradient.addColorStop(1, colors[1]);
  context.strokeStyle = gradient;
  context.lineWidth = 2.2;
  context.beginPath();
  context.moveTo(ax, ay);
  context.lineTo(tipX - 0.7 * head * ux, tipY - 0.7 * head * uy);
  context.stroke();
  context.fillStyle = colors[1];
  context.beginPath();
  context.moveTo(tipX, tipY);
  context.lineTo(tipX - head * ux - 0.42 * head * uy, tipY - head * uy + 0.42 * head * ux);
  context.lineTo(tipX - head * ux + 0.42 * head * uy, tipY - head * uy - 0.42 * head * ux);
  context.fill();
}

export function drawCorner(context, theme, [x, y]) {
  context.beginPath();
  context.arc(x, y, 3, 0, 2 * Math.PI);
  context.fillStyle = theme.color("paper");
  context.strokeStyle = theme.color("ink");
  context.lineWidth = 1.2;
  context.fill();
  context.stroke();
}

/** A numbered disc: full colour for a physical motion, pale where the chain stays open. */
export function drawBody(context, theme, [x, y], body, physical) {
  const color = theme.color(BODY_COLORS[body]);
  context.save();
  context.beginPath();
  context.arc(x, y, RADIUS, 0, 2 * Math.PI);
  context.fillStyle = theme.color("paper");
  context.fill();
  context.globalAlpha = 0.12 + 0.88 * physical;
  context.fillStyle = context.strokeStyle = color;
  context.fill();
  context.globalAlpha = 1;
  context.lineWidth = 2;
  context.stroke();
  context.fillStyle = theme.color(physical > 0.5 ? "paper" : "ink");
  context.font = `600 12px ${theme.family}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(String(body + 1), x, y + 0.5);
  context.restore();
}

/** Names beside the middles of the arrows and of the gap, away from the rest of the chain, and somewhere
 *  else along an arrow where the name of the gap is in the way. */
export function drawNames(context, theme, chain, size) {
  const beside = (from, to, others, away, flat) => {
    const [middle, inside] = [between(from, to), between(...others)];
    const length = distance(from, to) || 1;
    const normal = [(to[1] - from[1]) / length, (from[0] - to[0]) / length];
    const outward = (middle[0] - inside[0]) * normal[0] + (middle[1] - inside[1]) * normal[1];
    const side = Math.sign(Math.abs(outward) < 2 ? flat * normal[1] : outward);
    const along = (u, s) => [0, 1].map((i) => from[i] + u * (to[i] - from[i]) + away * s * normal[i]);
    return [0.5, 0.25, 0.75].flatMap((u) => [along(u, side), along(u, -side)]);
  };
  const write = (text, place, color) => {
    context.strokeStyle = theme.color("paper");
    context.fillStyle = theme.color(color);
    context.strokeText(text, ...place);
    context.fillText(text, ...place);
  };
  context.save();
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineWidth = 4;
  context.font = `italic 16px Georgia, "Times New Roman", serif`;
  const open = distance(chain[0], chain[3]) > 24;
  const [gapName] = beside(chain[0], chain[3], [chain[1], chain[2]], 23, 1);
  CHAIN.forEach((link, k) => {
    const others = chain.filter((_, i) => i !== k && i !== k + 1);
    const places = beside(chain[k], chain[k + 1], others, 16, -1);
    const clear = ([x, y]) => Math.abs(x - gapName[0]) > 60 || Math.abs(y - gapName[1]) > 20;
    write(link.name, (open && places.find(clear)) || places[0], "ink");
  });
  if (open) write(`S = ${size.toFixed(3)}`, gapName, "c4");
  context.restore();
}

function between(a, b) {
  return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
}

function distance(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}
