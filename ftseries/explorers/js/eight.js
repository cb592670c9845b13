// The family of the eight: relative vectors, bodies, the closure and its zero, for one λ and order.
//
//   r_12(t) = r(t) e^{iφ(t)},  r_23(t) = r_12(t - 2π/3),  r_31(t) = r_12(t + 2π/3);
//   r_1 = (r_12 - r_31)/3 and cyclically (E4a);  S = r_12 + r_23 + r_31 (E4),
//
// as in ftseries/problems/figure_eight.py.

import { linspace } from "./series.js";
import { gap } from "./figure_eight_scene.js";

export const THIRD = (2 * Math.PI) / 3;
const SAMPLES = 240;
export const GRID = linspace(0, 2 * Math.PI, SAMPLES + 1);

export class Eight {
  constructor(r, phi) {
    Object.assign(this, { r, phi, zeros: new Map() });
  }

  set(lam, order) {
    this.radii = this.r.amplitudes(lam, order);
    this.angles = this.phi.amplitudes(lam, order);
    return this;
  }

  /** r_12 at times, as {x, y}. */
  vectors(times) {
    const length = this.r.sample(this.radii, times);
    const angle = this.phi.sample(this.angles, times);
    return {
      x: length.map((r, i) => r * Math.cos(angle[i])),
      y: length.map((r, i) => r * Math.sin(angle[i])),
    };
  }

  /** [r_12, r_23, r_31] at a time. */
  relatives(time) {
    const { x, y } = this.vectors([time, time - THIRD, time + THIRD]);
    return [0, 1, 2].map((i) => [x[i], y[i]]);
  }

  /** r_12 on GRID, and the orbit that the three bodies share: r_1 on GRID. */
  motion() {
    const vectors = this.vectors(GRID);
    const orbit = (values) =>
      values.map((value, i) => (value - values[(i + SAMPLES / 3) % SAMPLES]) / 3);
    return { vectors, orbit: { x: orbit(vectors.x), y: orbit(vectors.y) } };
  }

  /** S_x of (E4) at t = 0. */
  closure(lam, order) {
    return gap(this.set(lam, order).relatives(0))[0];
  }

  /** The least and the greatest |S| in a period. */
  gaps(lam, order) {
    const { x, y } = this.set(lam, order).motion().vectors;
    const third = SAMPLES / 3;
    const at = (values, i) => values[i] + values[i + third] + values[i + 2 * third];
    const sizes = Array.from({ length: third }, (_, i) => Math.hypot(at(x, i), at(y, i)));
    return [Math.min(...sizes), Math.max(...sizes)];
  }

  /** λ_n: the smallest positive zero of the closure below 4, or NaN. */
  zero(order) {
    if (!this.zeros.has(order)) this.zeros.set(order, this.#search(order));
    return this.zeros.get(order);
  }

  #search(order) {
    let [left, right] = [0, 0];
    const sign = Math.sign(this.closure(0, order));
    do {
      [left, right] = [right, right + 0.02];
      if (right > 4) return NaN;
    } while (Math.sign(this.closure(right, order)) === sign);
    for (;;) {
      const middle = (left + right) / 2;
      if (middle <= left || middle >= right) return middle;
      if (Math.sign(this.closure(middle, order)) === sign) left = middle;
      else right = middle;
    }
  }
}

/** (E4a): the three bodies from their relative vectors. */
export function bodiesOf([r12, r23, r31]) {
  const third = (a, b) => [(a[0] - b[0]) / 3, (a[1] - b[1]) / 3];
  return [third(r12, r31), third(r23, r12), third(r31, r23)];
}

/** Words for a state: what the gap S_x at t = 0 means. */
export function verdict(S) {
  const size = Math.abs(S);
  if (size < 5e-4) return "the chain closes: three bodies under gravitation, to this order";
  if (size < 0.05) return "the chain nearly closes";
  return "the chain stays open, so this is no motion of three bodies under gravitation";
}

/** The digits of an integer as subscripts. */
export function subscript(integer) {
  return String(integer).replace(/\d/g, (digit) => "₀₁₂₃₄₅₆₇₈₉"[digit]);
}
