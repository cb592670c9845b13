// The limit cycle of x'' + x = ε (1 - x²) x', as ftseries/references/van_der_pol.py defines it.
//
//   const cycle = limitCycle(eps);       0 ≤ ε ≤ 10; ε = 0 is the limit, the circle of radius 2
//   cycle.omega, cycle.amplitude         frequency and largest x
//   cycle.at(tau)                        [x, dx/dt] at the phase τ = ωt, ∫ x sin τ dτ = 0
//
// Half a period, from rest at x = a to rest at x = -b(a), is integrated by Taylor series of order
// 24 in t; the cycle, on which b(a) = a, is found by the secant method.

const ORDER = 24;
const SIZE = 1e-18; // of the last term of a step
const POINTS = 512; // for the mean over half a period

export function limitCycle(eps) {
  let [a, before] = [2, 2.02];
  let [path, gap, gapBefore] = [half(eps, a), 0, 0];
  if (eps > 0) {
    gapBefore = before + half(eps, before).end;
    gap = a + path.end;
    for (let i = 0; i < 20 && gap !== gapBefore && Math.abs(a - before) > 1e-15; i++) {
      [a, before] = [a - (gap * (a - before)) / (gap - gapBefore), a];
      path = half(eps, a);
      [gap, gapBefore] = [a + path.end, gap];
    }
  }
  const omega = Math.PI / path.length;
  let start = 0;
  const at = (tau) => {
    const halves = Math.floor((tau - start) / Math.PI);
    const state = along(path, (tau - start - halves * Math.PI) / omega);
    return halves % 2 ? state.map((value) => -value) : state;
  };
  let [re, im] = [0, 0];
  for (let j = 0; j < POINTS; j++) {
    const tau = (Math.PI * j) / POINTS;
    const [x] = at(tau);
    re += x * Math.cos(tau);
    im -= x * Math.sin(tau);
  }
  start = Math.atan2(im, re);
  return { omega, amplitude: a, at };
}

/** The motion from rest at a > 0 to the next rest: its steps, its length in time, its last x. */
function half(eps, a) {
  const steps = [];
  let [x, v, t] = [a, 0, 0];
  for (let i = 0; i < 1000; i++) {
    const step = { t, ...taylor(eps, x, v) };
    steps.push(step);
    const far = value(step.v, step.h);
    if (t > 0 && far >= 0) {
      const s = root(step.v, step.h);
      return { steps, length: t + s, end: value(step.x, s) };
    }
    [x, v, t] = [value(step.x, step.h), far, t + step.h];
  }
  return { steps, length: NaN, end: NaN };
}

/** Taylor coefficients of x and v = x' at one time, and the step for which they are good. */
function taylor(eps, x0, v0) {
  const [x, v] = [[x0], [v0]];
  const square = []; // of x² and, with it, of (1 - x²) v
  for (let k = 0; k < ORDER; k++) {
    let [w, u] = [0, v[k]];
    for (let j = 0; j <= k; j++) w += x[j] * x[k - j];
    square.push(w);
    for (let j = 0; j <= k; j++) u -= square[j] * v[k - j];
    x.push(v[k] / (k + 1));
    v.push((eps * u - x[k]) / (k + 1));
  }
  const fits = (k) => (SIZE / Math.max(Math.abs(x[k]), Math.abs(v[k]))) ** (1 / k);
  return { x, v, h: Math.min(fits(ORDER), fits(ORDER - 1)) };
}

function value(coefficients, s) {
  let total = 0;
  for (let k = ORDER; k >= 0; k--) total = total * s + coefficients[k];
  return total;
}

/** The zero of a polynomial that is negative at 0 and not at h. */
function root(coefficients, h) {
  let [low, high] = [0, h];
  for (let i = 0; i < 60; i++) {
    const middle = (low + high) / 2;
    if (value(coefficients, middle) < 0) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

function along(path, t) {
  let [low, high] = [0, path.steps.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (path.steps[middle].t <= t) low = middle;
    else high = middle - 1;
  }
  const step = path.steps[low];
  return [value(step.x, t - step.t), value(step.v, t - step.t)];
}
