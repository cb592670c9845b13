r"""Values of a truncated series in balls that enclose them.

Formula.  u(t; λ) = Σ_n A_n(λ) cos nωt + B_n(λ) sin nωt with A_n(λ) = Σ_m A_{n,m} λ^m, all in ball
arithmetic: the radii of the coefficients, of λ, of t and of every rounding are in the result.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import mpmath
from flint import arb, arb_poly, ctx, fmpq
from mpmath.libmp import dps_to_prec, from_man_exp

from .aliases import Exact, Mode, Modes
from .conversion import at, to_ball
from .evaluation import derivative
from .precision import working

__all__ = ["Polynomials", "Sum", "ball", "good", "polynomials", "rounded", "turns"]

#: the amplitudes of an unknown as polynomials in λ
Polynomials: TypeAlias = Mapping[Mode, arb_poly]


def polynomials(rows: Sequence[Modes], point: Sequence[fmpq], scale: arb) -> Polynomials:
    """``{(sine, n): Σ_m A_{n,m} z^m}`` at a point of the free parameters, times a scale."""
    table: dict[Mode, list[arb]] = {}
    for m, row in enumerate(rows):
        for mode, number in row.items():
            table.setdefault(mode, [arb(0)] * len(rows))[m] = scale * arb(at(number, point))
    return {mode: arb_poly(column) for mode, column in table.items()}


def ball(x: Any, read: Callable[[Exact], fmpq]) -> arb:
    """A number as a ball at the precision in force; ``read`` says what a float means.

    >>> from ftseries.arguments import decimal, rational
    >>> ball(0.1, decimal).contains(fmpq(1, 10)), ball(0.1, rational).contains(fmpq(1, 10))
    (True, False)
    """
    if isinstance(x, arb):
        return x
    if isinstance(x, type(mpmath.pi)):                      # a constant, to any number of bits
        value = read(mpmath.mp.make_mpf(x.func(ctx.prec + 10, "n")))
        return arb(value, abs(arb(value)) * arb(2) ** (-ctx.prec - 8))
    irrational = getattr(x, "is_number", False) and not (x.is_Rational or x.is_Float)
    return to_ball(x) if irrational else arb(read(x))


@dataclass(frozen=True)
class Sum:
    """The series at one λ: amplitudes and the frequency."""

    amplitudes: Mapping[Mode, arb]
    omega: arb

    @classmethod
    def at(cls, z: arb, *series: Polynomials) -> Sum:
        """Where λ is z in the unit of the series, which are those of a field and of ω."""
        own, *frequency = [{mode: polynomial(z) for mode, polynomial in each.items()}
                           for each in series]
        return cls(own, frequency[0].get((0, 0), arb(0)) if frequency else arb(1))

    def value(self, time: arb, order: int = 0) -> tuple[arb, arb]:
        """A derivative of the unknown at a time, and its size ω^order Σ n^order |A_n|."""
        tau, total, size = self.omega * time, arb(0), arb(0)
        for (sine, n), a in derivative(self.amplitudes, order).items():
            total += a * ((n * tau).sin() if sine else (n * tau).cos())
            size += abs(a)
        return self.omega**order * total, abs(self.omega) ** order * size


def turns(omega: arb) -> tuple[float, float]:
    """ω/2π as the sum of two floats."""
    exact = omega / (2 * arb.pi())
    return (first := float(exact)), float(exact - first)


def good(value: arb, size: arb) -> float:
    """The decimal digits of a value in a ball, against its size; infinite where it is exact."""
    if value.rad() == 0:
        return math.inf
    with working(bits=64):
        part = value.rad() / size.mid()
        return float(-part.log() / arb(10).log()) if part > 0 else -math.inf


def rounded(value: arb, dps: int) -> Any:
    """The midpoint of a ball as an mpmath number of so many digits."""
    mantissa, exponent = map(int, value.mid().man_exp())
    return mpmath.mp.make_mpf(from_man_exp(mantissa, exponent, dps_to_prec(dps), "n"))
