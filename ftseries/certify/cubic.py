r"""Theorem: the truncated series of the cubic oscillator is in error by at most this.

Formula.  At a = 1 let x = Σ A_n cos nτ, τ = ωt and Ω = ω².  (C3) differentiated, x'' = 6x² -
2(3 + λ²), and the initial value x(0) = λ - 1, x'(0) = 0 are F(Ω, A) = 0 with

.. math::  F_* = \sum_n A_n - (λ - 1), \qquad
           F_n = n^2 Ω A_n + 6 [A * A]_n - 2(3 + λ^2) δ_{n0}, \quad n \ge 0.

The center (Ω̄, Ā) is the truncated series itself, exactly; its highest mode is N.  The norm is
\|Ω\| + Σ \|A_n\|.  The approximate inverse first solves the modes n > N by 1/(n² Ω̄), then takes
their sum out of F_*, then applies a float inverse a of the block:

.. math::  A F = \Bigl( a \bigl(F_{\le N} - e_* σ\bigr),\; \frac{F_n}{n^2 Ω̄} \Bigr), \qquad
           σ = \sum_{n > N} \frac{F_n}{n^2 Ω̄} .

F is quadratic, so Z₂ holds everywhere.  A zero has x(0) = λ - 1 and x'(0) = 0, so it is *the*
solution; A_1 ≠ 0 makes 2π its shortest period in τ.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from flint import arb, arb_mat, fmpq

from ..aliases import Exact, FilePath
from ..arguments import decimal, whole
from ..errors import InputError
from ..precision import working
from ..problems.cubic import CubicOscillator
from ..solver import solve
from . import certificate
from .algebra import largest_of, upper
from .balls import NotProved, at_most
from .grammar import MOST_BITS
from .newton_kantorovich import Bounds, radius

__all__ = ["CubicTheorem", "cubic_bound"]


@dataclass(frozen=True)
class CubicTheorem:
    """What was proved, in the paper's units.

    Attributes
    ----------
    amplitudes : arb
        Σ_n of the error of A_n, hence a bound of that of x at every phase ωt.
    omega : arb
        A bound of the error of ω.
    slope : arb
        Σ_n n \\|A_n\\| of the truncated series.
    bounds : Bounds
    a, lam : fmpq
    order : int
    radius : arb
        r, at a = 1.
    center : tuple
        Ω̄ and the list of the Ā_n at a = 1, rational numbers.
    precision : int
    """

    amplitudes: arb
    omega: arb
    slope: arb
    bounds: Bounds
    a: fmpq
    lam: fmpq
    order: int
    radius: arb
    center: tuple[fmpq, list[fmpq]]
    precision: int

    def __str__(self) -> str:
        b = self.bounds
        return (f"Theorem. At a = {self.a}, λ = {self.lam} the series of Taylor order {self.order} "
                f"is in error by at most {at_most(self.amplitudes)} in x at every phase and "
                f"{at_most(self.omega)} in ω. [Y = {at_most(b.y)}, Z₁ = {at_most(b.z1)}, "
                f"Z₂ = {at_most(b.z2)}]")

    def at(self, t: float) -> arb:
        """A bound of the error of x at the time t (a number): its phase drifts."""
        with working(bits=self.precision):
            return upper(self.amplitudes + abs(arb(t)) * self.omega * self.slope)

    def save(self, path: FilePath) -> None:
        """Write a certificate for :func:`ftseries.certify.check`."""
        omega, modes = self.center
        certificate.write(path, {
            "theorem": "cubic oscillator", "precision": self.precision,
            "a": str(self.a), "lam": str(self.lam), "order": self.order,
            "square": str(omega), "modes": [str(c) for c in modes],
            "radius": certificate.exact(self.radius)})


def cubic_bound(a: Exact, lam: Exact, order: int, precision: int = 256) -> CubicTheorem:
    """Prove a bound of the truncation error of the cubic oscillator's series.

    Parameters
    ----------
    a, lam : int, str, Fraction or float
        The parameters of (C1), (C2), taken exactly, a float by its decimals; both positive.
    order : int
        Taylor order of the truncated series.
    precision : int
        Bits, 53 to 20000.

    Raises
    ------
    NotProved
        The series is too poor at this λ; the message shows the constants.

    Examples
    --------
    >>> from ftseries import certify
    >>> bound = certify.cubic_bound(1, "0.5", 24)
    >>> bound.amplitudes < 3e-21, bound.omega < 4e-22, bound.at(100) < 4e-20
    (True, True, True)
    """
    a, lam = decimal(a), decimal(lam)
    order, precision = whole("order", order), whole("precision", precision, 53, MOST_BITS)
    if not a > 0 or not lam > 0:
        raise InputError(f"a={a}, lam={lam}: both must be positive")
    scaled = lam / a
    solution = solve(CubicOscillator(), order=order)
    modes = [fmpq(0)] * (order + 1)
    for m, row in enumerate(solution.coefficients["x"]):
        for (_, n), c in row.items():
            modes[n] += c * scaled**m
    root = sum((c * scaled**m for m, row in enumerate(solution.coefficients["omega"])
                for c in row.values()), fmpq(0))
    square = 12 * root**2
    with working(bits=precision):
        bounds = _bounds(square, modes, scaled)
        low, _ = radius(bounds)
        if not (low < arb(square) and low < abs(arb(modes[1]))):
            raise NotProved(f"not proved: r = {float(low):.3g} does not exclude ω = 0 or A_1 = 0")
        below = (square - low).sqrt() + arb(12).sqrt() * arb(root)
        unit = arb(a)
        return CubicTheorem(upper(unit * low), upper(unit.sqrt() * low / below),
                            upper(unit * sum((n * abs(arb(c)) for n, c in enumerate(modes)),
                                             arb(0))),
                            bounds, a, lam, order, low, (square, modes), precision)


def _bounds(square: fmpq, modes: list[fmpq], lam: fmpq) -> Bounds:
    """Y, Z₁, Z₂ of the module's formula; row and column 0 are * and Ω."""
    top, omega = len(modes) - 1, arb(square)
    value = [arb(c) for c in modes] + [arb(0)] * (4 * top + 2)         # up to n + k

    def coupling(n: int, k: int) -> arb:
        if k == 0 or n == 0:
            return 12 * value[k + n] / (2 if n == 0 and k else 1)
        return 6 * (value[abs(n - k)] * (1 if n != k else 2) + value[n + k])

    def column(k: int) -> list[arb]:
        return [arb(1)] + [coupling(n, k) + (n * n * omega if n == k else 0)
                           for n in range(top + 1)]

    columns = [[arb(0)] + [n * n * value[n] for n in range(top + 1)]]
    columns += [column(k) for k in range(top + 1)]
    block = arb_mat(columns).transpose()
    floats = np.array([[float(x.mid()) for x in row] for row in block.tolist()])
    try:
        inverse = np.linalg.inv(floats)
    except np.linalg.LinAlgError:
        raise NotProved("not proved: the derivative is singular; take a larger λ") from None
    a = arb_mat([[arb(float(c)) for c in row] for row in inverse])
    norms = [sum((abs(a[i, j]) for i in range(top + 2)), arb(0)) for j in range(top + 2)]

    def applied(head: list[arb], tail: dict[int, arb]) -> tuple[list[arb], dict[int, arb]]:
        """A F of (F_*, F_0, …, F_N) and {n > N: F_n}, as the same pair."""
        tail = {n: c / (n * n * omega) for n, c in tail.items()}
        head = [head[0] - sum(tail.values(), arb(0)), *head[1:]]
        return [row[0] for row in (a * arb_mat([[c] for c in head])).tolist()], tail

    def size(head: list[arb], tail: dict[int, arb]) -> arb:
        return upper(sum((upper(c) for c in [*head, *tail.values()]), arb(0)))

    squares = [arb(0)] * (2 * top + 1)
    for n in range(top + 1):
        for k in range(top + 1):
            half = value[n] * value[k] / 2
            squares[n + k] += half
            squares[abs(n - k)] += half
    force = [6 * squares[n] + n * n * omega * value[n] for n in range(2 * top + 1)]
    force[0] -= 2 * (3 + arb(lam) ** 2)
    start = sum(value, arb(0)) - (arb(lam) - 1)
    y = size(*applied([start, *force[:top + 1]],
                      {n: force[n] for n in range(top + 1, 2 * top + 1)}))
    sums = []
    for k in range(-1, 2 * top + 1):
        tail = {} if k < 0 else {n: coupling(n, k) for n in range(top + 1, k + top + 1)}
        if k > top:
            tail[k] += k * k * omega
        head, tail = applied(columns[0] if k < 0 else column(k), tail)
        if k > top:
            tail[k] -= 1
        else:
            head[k + 1] -= 1
        sums.append(size(head, tail))
    length = sum((abs(c) for c in value), arb(0))
    far = (1 + norms[0]) / omega                       # what A makes of n² times a mode n > N
    z1 = largest_of([*sums, 12 * length * far / (top + 1) ** 2])
    stretch = largest_of([far, *(n * n * norms[n + 1] for n in range(top + 1))])
    product = largest_of([far / (top + 1) ** 2, *norms[1:]])
    return Bounds(y, z1, upper(stretch + 12 * product), arb(1))
