r"""The bounds of the proof that the Fourier-Taylor series of the figure eight converges.

Formula.  The equations, unknowns and A are those of :mod:`ftseries.certify.convergence`.  DF has
the rows n² h - [M h]_n with M_ij = δ_ij W^{-3/2} - 3 W^{-5/2} x_i x_j (times μ for j = y), and
[(u h_y - y h_u)/W]_1.  With x·h = u h_u + μ y h_y, the second derivative of x W^{-3/2} is

.. math::  15 W^{-7/2} (x·h)(x·k)\, x - 3 W^{-5/2} \big((x·h)\, k + (x·k)\, h + (h·k)\, x\big) ,

and that of χ at most s² + 2b²s⁴, where s = ‖W^{-1/2}‖ and b = max(‖u‖, ‖y‖).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, TypeAlias

from flint import arb, fmpz, fmpz_poly

from .algebra import largest_of, negative_power, upper
from .balls import NotProved
from .fourier_taylor import BITS, FourierTaylor, Space, size
from .newton_kantorovich import Bounds, radius

__all__ = ["GUESS", "INVERSE", "Matrix", "Rows", "block", "prove"]

GUESS, INVERSE = 60, 30             # bits of x̄ and v, and of A
ROOM = 1 + arb(2) ** -8             # so that others may check the bounds, rounded differently


Rows: TypeAlias = dict[int, list[int]]
Matrix: TypeAlias = list[list[list[int]]]


def block(modes: int) -> list[int]:
    """The Fourier orders of the unknowns up to ``modes``."""
    return [n for n in range(modes + 1) if n == 0 or n % 3]


def prove(center: Rows, root: Rows, inverse: Matrix, kappa: arb, space: Space,
          modes: int) -> dict[str, Any]:
    """What can be said of a zero of F near x̄, from the guesses x̄, v and A."""
    u, y = (space.waves({n: row for n, row in center.items() if n % 2 == i}, GUESS, odd=bool(i))
            for i in (0, 1))
    v, one = space.waves(root, GUESS), space.one()
    if not sum(row[0] for row in root.values()) > 0:
        raise NotProved("not proved: v > 0 at t = μ = 0, so v may approximate the negative root")
    w = u * u + (y * y).times_mu()
    power = {p: negative_power(w, p, v, one) for p in (1, 2, 3, 5)}
    slope = (u * y.slope() + y * u.slope() * -1) * power[2]          # of χ
    force = u * power[3], y * power[3]
    uu, uy, yy = u * u, u * y, (y * y).times_mu()
    m = [[power[3] + power[5] * uu * -3, power[5] * uy.times_mu() * -3],
         [power[5] * uy * -3, power[3] + power[5] * yy * -3]]
    angle = [y * power[2] * -1, u * power[2]]
    index = block(modes)
    a = [[fmpz_poly(c) for c in row] for row in inverse]
    sizes = [[size(c) * arb(2) ** -INVERSE for c in row] for row in a]
    norm_a = largest_of([*map(_sum, zip(*sizes)), arb(1) / (modes + 1) ** 2])
    y_bound = _y(center, a, force, slope, kappa, index, modes, norm_a)
    z1 = _z1(a, sizes, m, angle, index, modes, space.top, norm_a)
    largest = arb(2) ** -16
    second, *slopes = _second_derivative(u.widened(largest), y.widened(largest), v, one)
    bounds = Bounds(upper(y_bound * ROOM), z1, upper(norm_a * second * ROOM), largest)
    low, high = radius(bounds)
    start = {n: row[0] * arb(2) ** -GUESS for n, row in center.items()}
    start[0], start[1] = start[0] - 1, start[1] - kappa
    if not largest_of(map(_sum, [start.values()])) < high:
        raise NotProved("not proved: at λ = 0 the center is not near u = 1, y = κ cos t")
    return {"radius": low, "uniqueness": high, "bounds": bounds,
            **_series_norms(w * power[1], slope, slopes, low)}


def _sum(values: Iterable[arb]) -> arb:
    return sum(map(upper, values), arb(0))


def _y(center: Rows, a: list[list[fmpz_poly]], force: tuple[FourierTaylor, FourierTaylor],
       slope: FourierTaylor, kappa: arb, index: list[int], modes: int, norm_a: arb) -> arb:
    one = fmpz(1) << BITS
    k = (kappa.mid() * one).floor().unique_fmpz() or fmpz(0)
    error = _sum([kappa - k / arb(one), *(f.error for f in force), slope.error])
    f = {0: slope[1] - slope[-1] - k}
    for n in block(max(*center, *(g.degree for g in force)))[1:]:
        f[n] = n * n * fmpz_poly(center.get(n, [])) * (one >> GUESS) - force[n % 2][n] * 2
    inside = fmpz(0)
    for row in a:
        inside += size(sum((c * f[n] for c, n in zip(row, index)), fmpz_poly()))
    beyond = _sum(size(f[n]) / arb(n) ** 2 for n in f if n > modes)
    return upper(inside * arb(2) ** -(BITS + INVERSE) + beyond * arb(2) ** -BITS + norm_a * error)


def _z1(a: list[list[fmpz_poly]], sizes: list[list[arb]], m: list[list[FourierTaylor]],
        angle: list[FourierTaylor], index: list[int], modes: int, top: int, norm_a: arb) -> arb:
    def entry(n: int, k: int) -> fmpz_poly:
        f, n = (m[n % 2][k % 2], n) if n else (angle[k % 2], 1)
        return f[n - k] + f[n + k]

    ulp = arb(2) ** -BITS
    lengths = {(i, j): [size(m[i][j][n]) * ulp for n in range(m[i][j].degree + 1)]
               for i in (0, 1) for j in (0, 1)}
    reach = {j: [size(angle[j][n]) * ulp for n in range(angle[j].degree + 1)] for j in (0, 1)}

    def length(n: int, k: int) -> arb:
        table, n = (lengths[n % 2, k % 2], n) if n else (reach[k % 2], 1)
        return sum((table[i] for i in (abs(n - k), n + k) if i < len(table)), arb(0))

    def beyond(k: int) -> arb:
        return _sum(length(n, k) / n**2 for n in range(modes + 1, k + top + 1) if n % 3)

    one, sums = fmpz(1) << BITS + INVERSE, []
    for j, k in enumerate(index):
        column = [(n * n << BITS if n == k and n else 0) - entry(n, k) if n else entry(n, k)
                  for n in index]
        total = fmpz(0)
        for i, row in enumerate(a):
            total += size((one if i == j else 0)
                          - sum((c * b for c, b in zip(row, column)), fmpz_poly()))
        sums.append(total * arb(2) ** -(BITS + INVERSE) + beyond(k))
    for k in range(modes + 1, modes + top + 1):
        if k % 3:
            reached = [length(n, k) for n in index]
            sums.append(_sum(s * c for row in sizes for s, c in zip(row, reached)) + beyond(k))
    far = [(m[0][j].norm() + m[1][j].norm()) / (modes + 1) ** 2 for j in (0, 1)]
    error = largest_of(m[0][j].error + m[1][j].error + angle[j].error for j in (0, 1))
    return upper(largest_of([*sums, *far]) + norm_a * error)


def _second_derivative(u: FourierTaylor, y: FourierTaylor, v: FourierTaylor,
                       one: FourierTaylor) -> tuple[arb, arb, arb]:
    """Bounds of the second derivative of F, and of the first ones of ρ and χ, for these u and y."""
    w, part = u * u + (y * y).times_mu(), (u, y)
    h, seventh = (negative_power(w, p, v, one) for p in (5, 7))
    s, b = negative_power(w, 1, v, one).norm(), largest_of(x.norm() for x in part)
    single = [(h * x).norm() for x in part]
    pairs = [seventh * u * u, seventh * u * y, seventh * y * y]
    triple = [(pairs[0] * u).norm(), *((pair * y).norm() for pair in pairs)]
    force = largest_of(15 * (triple[i + j] + triple[i + j + 1]) + 3 * (single[i] + single[j])
                       + (3 * (single[0] + single[1]) if i == j else 0)
                       for i in (0, 1) for j in (0, 1))
    return upper(force + s**2 + 2 * b**2 * s**4), s * b, s**2 * b


def _series_norms(rho: FourierTaylor, slope: FourierTaylor, slopes: list[arb],
                  low: arb) -> dict[str, Any]:
    """Bounds of r and φ = √μ χ; dρ = (u du + μ y dy)/ρ, and dχ as above."""
    ulp, orders = arb(2) ** -BITS, rho.space.orders
    sizes = {"r": [arb(0)] * orders, "phi": [arb(0)] * orders}
    for name, f in (("r", rho), ("phi", slope)):
        for n in range(-f.degree, f.degree + 1, 2):
            for m, c in enumerate(f[n].coeffs()):
                sizes[name][m] += abs(c) * ulp / (abs(n) if name == "phi" else 1)
    unit = arb(3).root(3)
    sizes["r"] = [x * unit for x in sizes["r"]]
    rest = {"r": upper((rho.error + slopes[0] * low) * unit),
            "phi": upper(slope.error + slopes[1] * low)}
    return {"sizes": sizes, "rest": rest,
            "norms": {name: upper((_sum(sizes[name]) + rest[name]) * ROOM) for name in sizes}}
