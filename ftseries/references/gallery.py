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

from flint import ctx, fmpq, fmpq_series

__all__ = ["pendulum", "duffing"]


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


def _frequency(order: int, weight: int, factor: Callable[[Any], Any]) -> list[fmpq]:
    previous, ctx.cap = ctx.cap, order + 2
    try:
        q = fmpq_series([0, 1], prec=order + 2)
        one = fmpq_series([1], prec=order + 2)
        theta3 = one + sum(2 * q**(k * k) for k in range(1, order + 2) if k * k < order + 2)
        half = one + sum(q**(k * k + k) for k in range(1, order + 2) if k * k + k < order + 2)
        omega2 = one / (theta3**4 - weight * 16 * q * half**4)          # θ_2 = 2 q^{1/4} half
        lam2 = factor(omega2) * q / (one + q)**2
        nome = lam2.reversion()
        series = omega2(nome)
        return [fmpq(series[k]) for k in range(order + 1)]
    finally:
        ctx.cap = previous
