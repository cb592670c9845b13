r"""A rigorous algebra of Fourier-Taylor series: two indices, one norm.

Formula.  For f = Σ f_{n,m} μ^m e^{int}, with n of one parity and f_{-n,m} = ±f_{n,m}, let

.. math::  \|f\| = \sum_{n,m} |f_{n,m}| .

A cosine or sine counts with its amplitude, as in :mod:`ftseries.certify.algebra` with ν = 1.
Monomials multiply to monomials, so ‖fg‖ ≤ ‖f‖ ‖g‖: a Banach algebra of functions that are
analytic in |μ| < 1, continuous up to |μ| = 1, and bounded there by their norm.  Multiplication
by μ has the norm 1.

A :class:`FourierTaylor` stands for all f within ``error`` of a sum with n ≤ top, m < orders, whose
coefficients are integers over 2^BITS.  All of them are one FLINT polynomial (Kronecker's
substitution), so that a product is exact; what is cut off and rounded goes into the error.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TypeAlias

from flint import arb, fmpz, fmpz_poly

from .algebra import upper

__all__ = ["BITS", "FourierTaylor", "Space", "size"]

#: ``{n: [integers]}``: the coefficients of the powers of μ, by Fourier order
Integers: TypeAlias = dict[int, list[int]]

BITS = 96
ULP = arb(2) ** -BITS


def size(poly: fmpz_poly) -> fmpz:
    """Σ |coefficients| of an integer polynomial."""
    return sum(map(abs, poly.coeffs()), fmpz(0))


class Space:
    """How much of a series is kept: the Fourier orders up to ``top`` and ``orders`` powers of μ."""

    def __init__(self, top: int, orders: int) -> None:
        self.top, self.orders, self.slot = top, orders, 2 * orders

    def waves(self, rows: Mapping[int, Sequence[int]], bits: int,
              odd: bool = False) -> FourierTaylor:
        """Σ rows[n][m]/2^bits μ^m cos nt, all n even or all ``odd``; rows are integers.

        The last bit is lost: a cosine is half the sum of two exponentials.
        """
        degree = max(rows, default=odd)
        shift = BITS - bits - 1
        lines = [[fmpz(c) << shift + (n == 0) for c in rows.get(abs(n), ())]
                 for n in range(-degree, degree + 1, 2)]
        return FourierTaylor(self, _packed(lines, self.slot), degree, 0)

    def one(self) -> FourierTaylor:
        return self.waves({0: [1]}, 0)


class FourierTaylor:
    """Functions near a finite sum; the Fourier orders are -degree, -degree + 2, …, degree."""

    def __init__(self, space: Space, poly: fmpz_poly, degree: int, error: arb | int) -> None:
        self.space, self.poly, self.degree, self.error = space, poly, degree, upper(error)

    def __getitem__(self, n: int) -> fmpz_poly:
        """The factor of e^{int} as an integer polynomial of μ, in units of 2^-BITS."""
        i, odd = divmod(n + self.degree, 2)
        if odd or abs(n) > self.degree:
            return fmpz_poly()
        slot = self.space.slot
        return self.poly.truncate((i + 1) * slot).right_shift(i * slot)

    @cached_property
    def center_norm(self) -> arb:
        """Norm of the finite sum."""
        return upper(size(self.poly) * ULP)

    def norm(self) -> arb:
        return upper(self.center_norm + self.error)

    def __add__(self, other: FourierTaylor) -> FourierTaylor:
        low, high = sorted((self, other), key=lambda f: f.degree)
        if (high.degree - low.degree) % 2:
            raise ValueError("only functions of the same parity can be added")
        shift = (high.degree - low.degree) // 2 * self.space.slot
        return FourierTaylor(self.space, low.poly.left_shift(shift) + high.poly, high.degree,
                             low.error + high.error)

    def __mul__(self, other: FourierTaylor | int) -> FourierTaylor:
        if isinstance(other, int):
            return FourierTaylor(self.space, self.poly * other, self.degree,
                                 self.error * abs(other))
        error = (self.center_norm * other.error + other.center_norm * self.error
                 + self.error * other.error)
        return self._kept(self.poly * other.poly, self.degree + other.degree, BITS, error)

    def times_mu(self) -> FourierTaylor:
        return self._kept(self.poly.left_shift(1), self.degree, 0, self.error)

    def widened(self, error: arb) -> FourierTaylor:
        return FourierTaylor(self.space, self.poly, self.degree, self.error + error)

    def slope(self) -> FourierTaylor:
        """-i d/dt of the finite sum; for an exact one only."""
        if not self.error == 0:
            raise ValueError("the derivative of what is not known has no bound")
        lines = [self[n] * n for n in range(-self.degree, self.degree + 1, 2)]
        return FourierTaylor(self.space, _packed([p.coeffs() for p in lines], self.space.slot),
                             self.degree, 0)

    def _kept(self, poly: fmpz_poly, degree: int, bits: int, error: arb) -> FourierTaylor:
        """poly/2^bits, cut and rounded."""
        space, dropped, lines = self.space, fmpz(0), []
        slot, kept, half = space.slot, space.orders, fmpz(1) << bits >> 1
        coefficients = poly.coeffs()
        for i, n in enumerate(range(-degree, degree + 1, 2)):
            line = coefficients[i * slot:(i + 1) * slot]
            if abs(n) > space.top:
                dropped += sum(map(abs, line))
            else:
                dropped += sum(map(abs, line[kept:]))
                lines.append([c + half >> bits for c in line[:kept]] if bits else line[:kept])
        error = error + (dropped * arb(2) ** -bits + len(lines) * kept) * ULP
        return FourierTaylor(space, _packed(lines, slot), len(lines) - 1, error)


def _packed(lines: Sequence[Sequence[fmpz]], slot: int) -> fmpz_poly:
    coefficients: list[fmpz | int] = []
    for line in lines:
        coefficients += line
        coefficients += [0] * (slot - len(line))
    return fmpz_poly(coefficients)
