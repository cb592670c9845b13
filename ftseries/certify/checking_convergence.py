r"""Check a certificate of convergence, with none of the code that found it.

Formula.  The guesses in the file (x̄, v ≈ W^{-1/2} and the matrix A of polynomials) are only read.
A function f = Σ f_n(μ) e^{int} with f_{-n} = ±f_n is kept as its f_n, n ≥ 0, each a FLINT
polynomial in μ with balls for coefficients, and a bound on what is missing in the norm
Σ |f_{n,m}|.  The inequalities are those of :mod:`ftseries.certify.convergence`.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from itertools import accumulate
from operator import mul

from flint import arb, arb_poly

from ..aliases import Json
from .balls import at_least, at_most
from .certificate import number, require, upper_bound
from .grammar import decimal, entries, integers, modes, record, whole

__all__ = ["check_convergence"]

_LARGE = 200                        # bits of an integer


def _length(poly: arb_poly) -> arb:
    return sum((abs(c) for c in poly.coeffs()), arb(0)).upper()


class _Waves:
    """Σ f_n(μ) e^{int} up to ``error``; ``limits`` are the modes and the powers of μ kept."""

    def __init__(self, rows: dict[int, arb_poly], limits: tuple[int, int], sign: int = 1,
                 error: arb | int = 0) -> None:
        self.rows, self.limits, self.sign, self.error = rows, limits, sign, arb(error)

    @classmethod
    def cosines(cls, rows: dict[int, list[int]], bits: int, limits: tuple[int, int]) -> _Waves:
        return cls({n: arb_poly([arb(c) for c in row]) * (arb(2) ** -(bits + (n > 0)))
                    for n, row in rows.items()}, limits)

    def __getitem__(self, n: int) -> arb_poly:
        row = self.rows.get(abs(n), arb_poly())
        return row * self.sign if n < 0 else row

    def lengths(self) -> dict[int, arb]:
        return {n: _length(f) for n, f in self.rows.items()}

    def norm(self) -> arb:
        return (sum((x * (2 if n else 1) for n, x in self.lengths().items()), arb(0))
                + self.error).upper()

    def known(self) -> arb:
        return (self.norm() - self.error).upper()

    def __mul__(self, other: _Waves) -> _Waves:
        rows: dict[int, arb_poly] = defaultdict(arb_poly)
        for i, f in self.rows.items():
            for j, g in other.rows.items():
                h = f * g
                rows[i + j] += h
                if j and i >= j:
                    rows[i - j] += h * other.sign
                if i and j >= i:
                    rows[j - i] += h * self.sign
        error = self.known() * other.error + other.known() * self.error + self.error * other.error
        return _Waves(rows, self.limits, self.sign * other.sign, error)._cut()

    def _cut(self) -> _Waves:
        top, orders = self.limits
        rows, error = {}, self.error
        for n, f in self.rows.items():
            keep = f.truncate(orders) if n <= top else arb_poly()
            error += _length(f - keep) * (2 if n else 1)
            if n <= top:
                rows[n] = keep
        return _Waves(rows, self.limits, self.sign, error.upper())

    def __add__(self, other: _Waves) -> _Waves:
        rows = {n: self[n] + other[n] for n in {*self.rows, *other.rows}}
        return _Waves(rows, self.limits, self.sign, self.error + other.error)

    def times(self, factor: int) -> _Waves:
        return _Waves({n: f * factor for n, f in self.rows.items()}, self.limits, self.sign,
                      self.error * abs(factor))

    def times_mu(self) -> _Waves:
        return _Waves({n: f.left_shift(1) for n, f in self.rows.items()}, self.limits, self.sign,
                      self.error)._cut()

    def slope(self) -> _Waves:
        """-i d/dt of the finite sum."""
        return _Waves({n: f * n for n, f in self.rows.items()}, self.limits, -self.sign)

    def widened(self, error: arb) -> _Waves:
        return _Waves(self.rows, self.limits, self.sign, (self.error + error).upper())


def check_convergence(data: Json) -> str:
    """What the certificate proves, as a sentence, or :class:`ftseries.certify.NotProved`."""
    record(data, "theorem lam modes orders center root inverse radius uniqueness largest norms")
    kappa, top = decimal(data["lam"]), whole(data["modes"], 4, 400)
    orders = whole(data["orders"], 1, 2000)
    require(kappa > 0, "λ > 0")
    limits = 2 * top, orders
    low, high, largest = (number(data[key]) for key in ("radius", "uniqueness", "largest"))
    require(low >= 0 and low < high and high <= largest, "0 ≤ r < R ≤ r*")
    index = [n for n in range(top + 1) if n == 0 or n % 3]
    size = (len(index),) * 2
    a = [[arb_poly(integers(c, orders, _LARGE)) * arb(2) ** -30 for c in entries(row, *size)]
         for row in entries(data["inverse"], *size)]
    norms = {name: number(value) for name, value in record(data["norms"], "r phi").items()}
    center, root = ({n: integers(row, orders, _LARGE) for n, row in
                     modes(data[key], 2 * top).items()} for key in ("center", "root"))
    require(all(n == 0 or n % 3 for n in center) and {0, 1} <= center.keys(),
            "x̄ has the modes 0, 1, 2, 4, 5, …")
    require(all(n % 2 == 0 for n in root), "v has even modes")
    part = [_Waves.cosines({n: row for n, row in center.items() if n % 2 == i}, 60, limits)
            for i in (0, 1)]
    v = _Waves.cosines(root, 60, limits)
    require(sum(row[0] for row in root.values()) > 0, "v > 0 at t = μ = 0")
    first = {0: arb(1), 1: kappa}
    start = sum((abs(arb(row[0]) / 2**60 - first.get(n, arb(0))) for n, row in center.items()),
                arb(0))
    require(start < high, "the center at λ = 0")

    u, y = part
    roots = list(accumulate([v] * 7, mul))
    power = _powers(u, y, roots)
    g, h, inverse = power(3), power(5), power(2)
    m = [[g + (h * u * u).times(-3), (h * u * y).times(-3).times_mu()],
         [(h * u * y).times(-3), g + (h * y * y).times(-3).times_mu()]]
    angle = [(y * inverse).times(-1), u * inverse]
    columns = [sum((_length(row[j]) for row in a), arb(0)) for j in range(len(index))]
    norm_a = upper_bound([*columns, 1 / arb(top + 1) ** 2])
    rate = (u * y.slope() + (y * u.slope()).times(-1)) * inverse
    y_bound = _residual(center, [u * g, y * g], rate, a, index, kappa, norm_a)
    z1 = _first(a, m, angle, index, limits[0], norm_a)
    second, drho, dchi = _second(u.widened(largest), y.widened(largest), roots)
    z2 = norm_a * second
    require(y_bound - (1 - z1) * low + z2 * low**2 / 2 <= 0, "p(r) ≤ 0")
    require(z1 + z2 * high < 1, "Z₁ + Z₂ R < 1")
    rho = (u * u + (y * y).times_mu()) * power(1)
    sums = {"r": arb(3).root(3) * (rho.norm() + drho * low),
            "phi": (sum((2 * x / n for n, x in rate.lengths().items()), arb(0))
                    + rate.error + dchi * low)}
    for name, bound in sums.items():
        require(bound <= norms[name], f"the bound of the series of {name}")
    return ("Checked. The Fourier-Taylor series of the figure eight converge absolutely for all "
            f"|λ| ≤ {data['lam']}, with sums of at most {at_most(norms['r'])} and "
            f"{at_most(norms['phi'])}; as functions they lie within {at_most(low)} of the sums in "
            f"the file, alone within {at_least(high)}.")


def _powers(u: _Waves, y: _Waves, roots: list[_Waves]) -> Callable[[int], _Waves]:
    """p ↦ W^{-p/2}, from v, v², v³, …"""
    w = u * u + (y * y).times_mu()
    one = _Waves({0: arb_poly([1])}, u.limits)
    defect = (one + (roots[1] * w).times(-1)).norm()
    require(defect < 1, "‖1 - v²W‖ < 1")

    def power(p: int) -> _Waves:
        root = roots[p - 1]
        return root.widened(root.norm() * ((1 - defect) ** (-arb(p) / 2) - 1))
    return power


def _residual(center: dict[int, list[int]], force: list[_Waves], rate: _Waves,
              a: list[list[arb_poly]], index: list[int], kappa: arb, norm_a: arb) -> arb:
    """Y."""
    last = max(*center, *force[0].rows, *force[1].rows)
    f = {n: arb_poly([arb(c) for c in center.get(n, ())]) * (n * n * arb(2) ** -60)
         - force[n % 2][n] * 2 for n in range(1, last + 1) if n % 3}
    f[0] = rate[1] * 2 - kappa
    inside = sum((_length(sum((c * f[n] for c, n in zip(row, index)), arb_poly())) for row in a),
                 arb(0))
    beyond = sum((_length(f[n]) / n**2 for n in f if n > index[-1]), arb(0))
    return (inside + beyond + norm_a * (force[0].error + force[1].error + rate.error)).upper()


def _first(a: list[list[arb_poly]], m: list[list[_Waves]], angle: list[_Waves], index: list[int],
           reach: int, norm_a: arb) -> arb:
    """Z₁: columns up to N + 2N are summed up, all others stay beyond the block."""
    top = index[-1] + (index[-1] % 3 == 2)                      # N or N - 1: both are skipped
    lengths = {(i, j): m[i][j].lengths() for i in (0, 1) for j in (0, 1)}
    turning = [f.lengths() for f in angle]

    def entry(n: int, k: int) -> arb_poly:
        f = m[n % 2][k % 2] if n else angle[k % 2]
        return f[(n or 1) - k] + f[(n or 1) + k]

    def size(n: int, k: int) -> arb:
        table = lengths[n % 2, k % 2] if n else turning[k % 2]
        return table.get(abs((n or 1) - k), arb(0)) + table.get((n or 1) + k, arb(0))

    def beyond(k: int) -> arb:
        return sum((size(n, k) / n**2 for n in range(top + 1, k + reach + 1) if n % 3), arb(0))

    sums = []
    for j, k in enumerate(index):
        column = [(n * n if n == k else 0) - entry(n, k) if n else entry(n, k) for n in index]
        inside = sum((_length(int(i == j) - sum((c * b for c, b in zip(row, column)), arb_poly()))
                      for i, row in enumerate(a)), arb(0))
        sums.append(inside + beyond(k))
    table = [[_length(c) for c in row] for row in a]
    for k in range(top + 1, top + reach + 2):
        if k % 3:
            reached = [size(n, k) for n in index]
            sums.append(sum((c * b for row in table for c, b in zip(row, reached)), arb(0))
                        + beyond(k))
    far = [(m[0][j].norm() + m[1][j].norm()) / (top + 1) ** 2 for j in (0, 1)]
    error = upper_bound(m[0][j].error + m[1][j].error + angle[j].error for j in (0, 1))
    return (upper_bound([*sums, *far]) + norm_a * error).upper()


def _second(u: _Waves, y: _Waves, roots: list[_Waves]) -> tuple[arb, arb, arb]:
    """Bounds of the second derivative of F and of the first ones of ρ and χ in the whole ball."""
    power, part = _powers(u, y, roots), (u, y)
    s, b = power(1).norm(), upper_bound(x.norm() for x in part)
    fifth = [(power(5) * x).norm() for x in part]
    uu, uy, yy = power(7) * u * u, power(7) * u * y, power(7) * y * y
    seventh = [f.norm() for f in (uu * u, uu * y, uy * y, yy * y)]
    force = upper_bound(15 * (seventh[i + j] + seventh[i + j + 1]) + 3 * (fifth[i] + fifth[j])
                     + (3 * (fifth[0] + fifth[1]) if i == j else 0) for i in (0, 1) for j in (0, 1))
    return force + s**2 + 2 * b**2 * s**4, s * b, s**2 * b
