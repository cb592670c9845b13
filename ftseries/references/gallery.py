r"""Exact frequencies of the oscillators of Duffing and of the pendulum, order by order.

Formula.  With the nome q, θ_2^4 = (Σ_{k odd} q^{k²/4})^4 and θ_3 = 1 + 2 Σ q^{k²}, the Fourier
series of cn and am give the amplitude λ of the first cosine and the frequency ω as series in q
(NIST Digital Library of Mathematical Functions, 22.11.2, 22.11.9, 20.9.1, 20.9.2):

==========================  ====================  =================================
x″ + sin x = 0              λ² = 64 q/(1+q)²      ω² = 1/θ_3^4
x″ + x + x³ = 0             λ² = 32 q/(1+q)² ω²   ω² = 1/(θ_3^4 - 2 θ_2^4)
==========================  ====================  =================================

Reversion of the first gives ω² as a series in λ².
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import acb, acb_poly, arb, fmpq, fmpq_series

from ftseries.precision import working

__all__ = ["pendulum", "duffing", "duffing_turn"]

#: terms of a series in q where |q| = 0.16 is meant: the rest is below all rounding
_TERMS = 40
_BITS = 100


def pendulum(order: int) -> list[fmpq]:
    """The coefficients of λ⁰, λ², …, λ^(2·order) of ω², rational.

    >>> pendulum(2)                                      # ω = 1 - λ²/16 + λ⁴/1024
    [1, -1/8, 3/512]
    """
    return _frequency(order, 0, lambda omega2: 64)


def duffing(order: int) -> list[fmpq]:
    """The same for x″ + x + x³ = 0.

    >>> duffing(2)
    [1, 3/4, 3/128]
    """
    return _frequency(order, 2, lambda omega2: 32 * omega2)


def duffing_turn() -> complex:
    """A λ² next to 0 at which λ²(q) of x″ + x + x³ = 0 turns: ω² has a square root there.

    The zero of dλ²/dq with the smallest |q|, in the upper half plane.

    >>> round(duffing_turn().real, 12), round(duffing_turn().imag, 12)
    (-1.306238065953, 0.690193869702)
    """
    with working(bits=_BITS, terms=_TERMS):
        q, inverse = _squares(_TERMS, 2)
        below = (1 + q)**2 * inverse                                # λ² = 32 q / below
        turns = below - q * below.derivative()
        zeros = acb_poly([arb(turns[k]) for k in range(_TERMS - 1)]).roots()
        place = complex(min((z for z in zeros if z.imag > 0), key=lambda z: float(abs(z).mid())))
        return 32 * place / complex(acb_poly([arb(below[k]) for k in range(_TERMS)])(acb(place)))


def _squares(terms: int, weight: int) -> tuple[Any, Any]:
    """The series of q itself and of 1/ω²."""
    q = fmpq_series([0, 1], prec=terms)
    one = fmpq_series([1], prec=terms)
    theta3 = one + sum(2 * q**(k * k) for k in range(1, terms) if k * k < terms)
    half = one + sum(q**(k * k + k) for k in range(1, terms) if k * k + k < terms)
    return q, theta3**4 - weight * 16 * q * half**4                 # θ_2 = 2 q^{1/4} half


def _frequency(order: int, weight: int, factor: Callable[[Any], Any]) -> list[fmpq]:
    with working(terms=order + 2):
        q, inverse = _squares(order + 2, weight)
        omega2 = 1 / inverse
        series = omega2((factor(omega2) * q / (1 + q)**2).reversion())
        return [fmpq(series[k]) for k in range(order + 1)]
