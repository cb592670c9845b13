// The lowest odd solution of the generalized Mathieu equation by the truncated Hill matrix, as
// ftseries/references/mathieu.py has it. For n, k = 1, 3, 5, … the matrix is
//
//   n² δ_nk + λ²/2 M¹_nk + λ⁴μ/2 M²_nk,   Mʲ_nk = δ(|n - k|, 2j) - δ(n + k, 2j),
//
// symmetric with two bands beside the diagonal. Its lowest eigenvalue a and the eigenvector c give
// ψ(x) = Σ c_n sin nx with c_1 = λ.

const SIZE = 26; // n up to 51: for |λ| ≤ 3, |μ| ≤ 1/2 the c_n beyond are below rounding

/** Lowest eigenvalue and the sine coefficients [c_1, c_3, …], with c_1 = λ. */
export function lowest(lam, mu) {
  const bands = hill(lam, mu);
  // Inverse iteration: from a shift below all eigenvalues towards the lowest one, then by
  // Rayleigh's quotient, which triples the correct digits.
  let vector = new Float64Array(SIZE).fill(1e-3);
  vector[0] = 1;
  let a = bands[0].reduce((low, d, i) => Math.min(low, d - radius(bands, i)), Infinity) - 1;
  let factors = factor(bands, a);
  for (let i = 0; i < 400; i++) {
    vector = normalised(solve(factors, vector));
    const image = times(bands, vector);
    const quotient = dot(vector, image);
    const residual = Math.hypot(...image.map((value, j) => value - quotient * vector[j]));
    if (residual < 1e-13 * (1 + Math.abs(quotient))) break;
    if (residual < 0.1) factors = factor(bands, quotient - 1e-14 * (1 + Math.abs(quotient)));
  }
  a = dot(vector, times(bands, vector));
  return { a, c: vector.map((value) => (lam * value) / vector[0]) };
}

/** ψ at many places from its sine coefficients. */
export function eigenfunction(xs, c) {
  return xs.map((x) => c.reduce((sum, value, i) => sum + value * Math.sin((2 * i + 1) * x), 0));
}

/** Diagonal and the two bands below it. */
function hill(lam, mu) {
  const [q, s] = [lam ** 2 / 2, (lam ** 4 * mu) / 2];
  const diagonal = Float64Array.from({ length: SIZE }, (_, i) => (2 * i + 1) ** 2);
  const first = new Float64Array(SIZE).fill(q);
  const second = new Float64Array(SIZE).fill(s);
  diagonal[0] -= q; // n + k = 2
  first[0] -= s; //    n + k = 4
  return [diagonal, first, second];
}

function radius([, first, second], i) {
  const near = Math.abs(first[i]) + Math.abs(second[i]);
  return near + Math.abs(first[i - 1] ?? 0) + Math.abs(second[i - 2] ?? 0);
}

function times([diagonal, first, second], v) {
  return v.map(
    (value, i) =>
      diagonal[i] * value + first[i] * (v[i + 1] ?? 0) + second[i] * (v[i + 2] ?? 0) +
      (first[i - 1] ?? 0) * (v[i - 1] ?? 0) + (second[i - 2] ?? 0) * (v[i - 2] ?? 0),
  );
}

/** L D Lᵀ of the matrix minus a shift; L has ones on its diagonal and two bands. */
function factor([diagonal, first, second], shift) {
  const [d, l, k] = [new Float64Array(SIZE), new Float64Array(SIZE), new Float64Array(SIZE)];
  for (let i = 0; i < SIZE; i++) {
    const [one, two] = [i > 0 ? l[i - 1] : 0, i > 1 ? k[i - 2] : 0];
    d[i] = diagonal[i] - shift - one * one * (d[i - 1] ?? 0) - two * two * (d[i - 2] ?? 0);
    if (d[i] === 0) d[i] = 1e-300;
    l[i] = (first[i] - (i > 0 ? k[i - 1] * d[i - 1] * l[i - 1] : 0)) / d[i];
    k[i] = second[i] / d[i];
  }
  return [d, l, k];
}

function solve([d, l, k], right) {
  const x = Float64Array.from(right);
  for (let i = 1; i < SIZE; i++) x[i] -= l[i - 1] * x[i - 1] + (i > 1 ? k[i - 2] * x[i - 2] : 0);
  for (let i = 0; i < SIZE; i++) x[i] /= d[i];
  for (let i = SIZE - 2; i >= 0; i--) x[i] -= l[i] * x[i + 1] + (i < SIZE - 2 ? k[i] * x[i + 2] : 0);
  return x;
}

function dot(u, v) {
  return u.reduce((sum, value, i) => sum + value * v[i], 0);
}

function normalised(v) {
  const size = Math.sqrt(dot(v, v));
  return v.map((value) => value / size);
}
