// The exact oscillation in the cubic potential at a = 1, as ftseries/references/cubic.py gives it:
//
//   x(t) = -1 - λ + 2λ cd²(√(3 + λ) t | m),   ω = π √(3 + λ) / K(m),   m = 2λ / (3 + λ).
//
// Jacobi's functions by the arithmetic-geometric mean (Abramowitz and Stegun 16.4, 17.6), from
// 1 - m = (3 - λ) / (3 + λ), which keeps its digits near λ = 3.

/** Exact position at the time t, for 0 ≤ λ ≤ 3 (at λ = 3 the particle rests on the top). */
export function position(t, lam) {
  const { cn, dn } = jacobi(Math.sqrt(3 + lam) * t, (3 - lam) / (3 + lam));
  return -1 - lam + 2 * lam * (cn / dn) ** 2;
}

/** Exact frequency ω for 0 ≤ λ ≤ 3: π √(3 + λ) / K(m) = 2 √(3 + λ) agm(1, √(1 - m)). */
export function frequency(lam) {
  return lam < 3 ? 2 * Math.sqrt(3 + lam) * agm((3 - lam) / (3 + lam)).at(-1).a : 0;
}

/** V(x) of (C1). */
export function potential(x, lam) {
  return 2 * x * (3 + lam ** 2) - 2 * x ** 3;
}

/** E of (C2). */
export function energy(lam) {
  return -4 * (1 - lam) * (1 + lam);
}

/** The place of the top of the potential, V'(x) = 0: the separatrix passes through it. */
export function top(lam) {
  return Math.sqrt((3 + lam ** 2) / 3);
}

/** The speed at x of a particle of energy E, √(2(E - V)); NaN where it cannot be. */
export function speed(x, lam, E) {
  return Math.sqrt(2 * (E - potential(x, lam)));
}

/** cn and dn of argument u and complementary parameter m1 = 1 - k², 0 ≤ m1 ≤ 1. */
export function jacobi(u, m1) {
  if (m1 <= 0) return { cn: 1 / Math.cosh(u), dn: 1 / Math.cosh(u) };
  const steps = agm(m1);
  const last = steps.length - 1;
  let phi = 2 ** last * steps[last].a * u;
  for (let k = last; k > 0; k--) phi = (phi + Math.asin((steps[k].c / steps[k].a) * Math.sin(phi))) / 2;
  const [sn, cn] = [Math.sin(phi), Math.cos(phi)];
  return { cn, dn: Math.hypot(cn, Math.sqrt(m1) * sn) };
}

/** The steps a, b, c of the arithmetic-geometric mean of 1 and √m1, until c is below rounding. */
function agm(m1) {
  const steps = [{ a: 1, b: Math.sqrt(m1), c: Math.sqrt(1 - m1) }];
  while (Math.abs(steps.at(-1).c) > 1e-16 * steps.at(-1).a && steps.length < 40) {
    const { a, b } = steps.at(-1);
    steps.push({ a: (a + b) / 2, b: Math.sqrt(a * b), c: (a - b) / 2 });
  }
  return steps;
}
