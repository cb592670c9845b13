// Evaluation of a truncated Fourier-Taylor series, as ftseries/evaluation.py does it.
//
//   u(t; λ) = Σ_n A_n(λ) cos nτ + B_n(λ) sin nτ,   A_n(λ) = Σ_{m ≤ order} A_{n,m} λ^m,   τ = ωt.
//
//   const x = new Series(data.x, "x")    decodes what ftseries/explorers/base.py packs;
//                                        throws Complaint where that cannot be shown
//   x.order                              the highest Taylor order stored
//   x.setParameter(mu)                   the coefficients are polynomials in μ: put a number in
//   x.amplitudes(lam, order)             Float64Array, one number for each of x.modes
//   x.modes                              [{sine: 0 or 1, n}], sorted by n
//   x.scalar(lam, order)                 the value of a scalar unknown (a frequency, an eigenvalue)
//   x.at(amplitudes, tau)                the Fourier sum at one phase τ
//   x.sample(amplitudes, taus, out)      the same at many phases, into a Float64Array
//   x.slope(amplitudes, taus)            its derivative with respect to τ at many phases
//
// A solution's value at the time t is x.at(x.amplitudes(lam, order), omega.scalar(lam, order) * t).

/** Something a reader can be told in one sentence, in the place of the explorer. */
export class Complaint extends Error {}

export class Series {
  constructor(packed, name) {
    if (!packed || !Array.isArray(packed.rows) || !packed.rows.length) {
      throw new Complaint(`The series of ${name} is empty: there is nothing to show.`);
    }
    const bytes = Uint8Array.from(atob(packed.values), (c) => c.charCodeAt(0));
    const values = new Float64Array(bytes.buffer);
    if (!values.every(Number.isFinite)) {
      throw new Complaint(`The coefficients of ${name} contain NaN or infinite numbers.`);
    }
    this.name = name;
    this.order = packed.order;
    this.rows = [];
    const modes = new Map();
    let start = 0;
    for (const [sine, n, k, m, step, count] of packed.rows) {
      const key = 2 * n + sine;
      if (!modes.has(key)) modes.set(key, { sine, n, taylor: new Float64Array(this.order + 1) });
      const row = { mode: modes.get(key), k, m, step, values: values.subarray(start, start + count) };
      this.rows.push(row);
      start += count;
      if (m + step * (count - 1) > this.order) start = NaN;
    }
    if (start !== values.length) throw new Complaint(`The coefficients of ${name} are incomplete.`);
    this.modes = [...modes.values()].sort((a, b) => a.n - b.n || a.sine - b.sine);
    const orders = this.modes.map((mode) => mode.n);
    this.first = Math.min(...orders);
    this.step = orders.reduce((g, n) => gcd(g, n - this.first), 0) || 1;
    this.top = Math.max(...orders);
    this.setParameter(0);
  }

  /** Put a number in for the parameter μ of the coefficients. */
  setParameter(mu) {
    if (mu === this.parameter) return;
    this.parameter = mu;
    for (const mode of this.modes) mode.taylor.fill(0);
    for (const { mode, k, m, step, values } of this.rows) {
      const power = mu ** k;
      values.forEach((value, i) => (mode.taylor[m + step * i] += power * value));
    }
  }

  amplitudes(lam, order) {
    const top = Math.min(order, this.order);
    return Float64Array.from(this.modes, ({ taylor }) => horner(taylor, lam, top));
  }

  scalar(lam, order) {
    return horner(this.modes[0].taylor, lam, Math.min(order, this.order));
  }

  at(amplitudes, tau) {
    return this.sample(amplitudes, [tau], [0])[0];
  }

  sample(amplitudes, taus, out = new Float64Array(taus.length)) {
    const [cosines, sines] = this.#bySine((n, sine, i) => [sine, amplitudes[i]]);
    return this.#fourier(cosines, sines, taus, out);
  }

  slope(amplitudes, taus) {
    const turned = (n, sine, i) => [1 - sine, (sine ? n : -n) * amplitudes[i]];
    return this.#fourier(...this.#bySine(turned), taus, new Float64Array(taus.length));
  }

  #bySine(put) {
    const size = (this.top - this.first) / this.step + 1;
    const parts = [new Float64Array(size), new Float64Array(size)];
    this.modes.forEach(({ sine, n }, i) => {
      const [kind, value] = put(n, sine, i);
      parts[kind][(n - this.first) / this.step] = value;
    });
    return parts;
  }

  /** Horner's rule in z = e^{i step τ}: Re Σ (A_n - i B_n) z^n. */
  #fourier(cosines, sines, taus, out) {
    const { step, first } = this;
    const size = cosines.length;
    for (let j = 0; j < taus.length; j++) {
      const c = Math.cos(step * taus[j]);
      const s = Math.sin(step * taus[j]);
      let re = 0;
      let im = 0;
      for (let i = size - 1; i >= 0; i--) {
        const next = re * c - im * s + cosines[i];
        im = re * s + im * c - sines[i];
        re = next;
      }
      out[j] = first ? re * Math.cos(first * taus[j]) - im * Math.sin(first * taus[j]) : re;
    }
    return out;
  }
}

/** Σ_{m ≤ order} coefficients[m] x^m. */
export function horner(coefficients, x, order = coefficients.length - 1) {
  let total = 0;
  for (let m = order; m >= 0; m--) total = total * x + coefficients[m];
  return total;
}

/** `count` equidistant numbers from `start` to `end`, both included. */
export function linspace(start, end, count) {
  return Float64Array.from({ length: count }, (_, i) => start + ((end - start) * i) / (count - 1));
}

function gcd(a, b) {
  return b ? gcd(b, a % b) : a;
}
