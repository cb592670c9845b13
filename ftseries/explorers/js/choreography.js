// A choreography of three bodies under the force d^-(α+1): its variation, by Runge and Kutta.
//
// A disturbance u = (η_12, η_23) of the relative vectors obeys
//
//   η_12'' = 2 g_12 - g_23 - g_31,  g_ij = A_ij η_ij,  η_31 = -η_12 - η_23,
//   A = -|r|^-(α+2) (1 - (α+2) e e'),  e = r_ij/|r_ij|,
//
// and cyclically. After a third of the period r_23 is where r_12 was and r_31 where r_23 was, so that
// (u, u')(0) -> (η_23, η_31, and their derivatives)(2π/3) is a matrix C whose cube is the monodromy
// matrix. Energy and angular momentum make four of its eight eigenvalues 1; the other four are
// ρ, 1/ρ with ρ + 1/ρ = p, and the traces of C and C² give the two p.

/** C, 8 × 8 by columns. `samples` = {x, y}: r_12 at 6·steps equidistant times of the period 2π. */
export function thirdReturn(samples, alpha, steps) {
  const h = (2 * Math.PI) / 3 / steps;
  const tides = tidal(samples, alpha);
  const third = 2 * steps;
  const matrix = [];
  for (let column = 0; column < 8; column++) {
    const state = new Float64Array(8);
    state[column] = 1;
    for (let n = 0; n < steps; n++) step(state, tides, third, 2 * n, h);
    const half = ([a, b, c, d]) => [c, d, -a - c, -b - d];
    matrix.push([...half(state.subarray(0, 4)), ...half(state.subarray(4))]);
  }
  return matrix;
}

/** [xx, xy, yy] of A at each sample. */
function tidal({ x, y }, alpha) {
  return Array.from(x, (_, i) => {
    const square = x[i] * x[i] + y[i] * y[i];
    const pull = square ** (-alpha / 2 - 1);
    const stretch = ((alpha + 2) * pull) / square;
    return [stretch * x[i] * x[i] - pull, stretch * x[i] * y[i], stretch * y[i] * y[i] - pull];
  });
}

function step(state, tides, third, i, h) {
  const size = tides.length;
  const slope = (s, k) => {
    const [p, q, r] = [tides[k % size], tides[(k + 2 * third) % size], tides[(k + third) % size]];
    const [ax, ay] = act(p, s[0], s[1]);
    const [bx, by] = act(q, s[2], s[3]);
    const [cx, cy] = act(r, -s[0] - s[2], -s[1] - s[3]);
    return [s[4], s[5], s[6], s[7],
      2 * ax - bx - cx, 2 * ay - by - cy, 2 * bx - ax - cx, 2 * by - ay - cy];
  };
  const moved = (k, w) => state.map((value, j) => value + w * k[j]);
  const k1 = slope(state, i);
  const k2 = slope(moved(k1, h / 2), i + 1);
  const k3 = slope(moved(k2, h / 2), i + 1);
  const k4 = slope(moved(k3, h), i + 2);
  for (let j = 0; j < 8; j++) state[j] += (h / 6) * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]);
}

function act([xx, xy, yy], u, v) {
  return [xx * u + xy * v, xy * u + yy * v];
}

/** The two p = ρ + 1/ρ of C, as complex numbers [re, im], larger real part first. */
export function pairs(matrix) {
  let [first, second] = [0, 0];
  for (let i = 0; i < 8; i++) {
    first += matrix[i][i];
    for (let j = 0; j < 8; j++) second += matrix[i][j] * matrix[j][i];
  }
  const sum = first - 4; //                                    p + q
  const squares = second; //                                   p² + q²: 4 + (p² - 2) + (q² - 2)
  const square = squares / 2 - (sum * sum) / 4; //             ((p - q)/2)²
  const root = Math.sqrt(Math.abs(square));
  return square < 0 ? [[sum / 2, root], [sum / 2, -root]] : [[sum / 2 + root, 0], [sum / 2 - root, 0]];
}

/** The multiplier of the whole period, ρ³, of modulus at least 1, from p of a third: [re, im]. */
export function multiplier([re, im]) {
  const [a, b] = [(re * re - im * im) / 4 - 1, (re * im) / 2]; // (p/2)² - 1
  const size = Math.hypot(a, b);
  const [u, v] = [Math.sqrt((size + a) / 2), (b < 0 ? -1 : 1) * Math.sqrt((size - a) / 2)];
  const both = [[re / 2 + u, im / 2 + v], [re / 2 - u, im / 2 - v]];
  const [x, y] = both.sort((p, q) => Math.hypot(...q) - Math.hypot(...p))[0];
  return [x * x * x - 3 * x * y * y, 3 * x * x * y - y * y * y];
}
