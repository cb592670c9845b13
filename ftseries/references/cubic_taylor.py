"""Exact Taylor coefficients in λ of the closed forms of `cubic`: every ω_m and A_{n,m} of (C5).

With F(m) = 2K(m)/π = ₂F₁(½, ½; 1; m) and G(m) = 2E(m)/π = ₂F₁(-½, ½; 1; m), the closed forms read,
at a = 1 and with m = 2λ/(3 + λ),

    ω² = 4 (3 + λ)/F²,   A_0 = 2 - (3 + λ) G/F,   A_n = -2 ω² n (-q)ⁿ/(1 - q²ⁿ).

The nome q(m) = m/16 + 8 (m/16)² + … follows from d ln q/dm = π²/(4m(1 - m)K²) = 1/(m(1 - m)F²)
(DLMF 19.4.1 with Legendre's relation 19.7.1). All these are power series with rational
coefficients: python-flint multiplies, inverts and composes them exactly. Since x has the dimension
of λ and of a, and ω² that of a, A_{n,m}(a) = a^{1-m} A_{n,m}(1) and ω_m(a) = a^{1/2-m} ω_m(1).
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from math import comb
from typing import Any

import sympy
from flint import fmpq, fmpq_series

from ftseries.aliases import Exact, Expr
from ftseries.arguments import decimal, whole
from ftseries.errors import InputError
from ftseries.precision import working

__all__ = ["fourier_taylor", "frequency_squared_taylor", "frequency_taylor"]


def frequency_taylor(order: int, a: Exact = 1) -> list[Expr]:
    """[ω_0, …, ω_order] of (C5b) as SymPy numbers; `a` is a positive number or symbol.

    >>> frequency_taylor(2)
    [2*sqrt(3), 0, -sqrt(3)/24]
    """
    a = _positive(a)
    with _closed_forms(whole("order", order)) as (omega2, _, _):
        root = _rationals((omega2 / 12).sqrt(), order)
    return [2 * sympy.sqrt(3 * a) * c / a**m for m, c in enumerate(root)]


def frequency_squared_taylor(order: int, a: Exact = 1) -> list[Expr]:
    """The Taylor coefficients 0, …, order of ω² in λ as SymPy numbers.

    >>> frequency_squared_taylor(4)
    [12, 0, -1/2, 0, -17/1152]
    """
    a = _positive(a)
    with _closed_forms(whole("order", order)) as (omega2, _, _):
        return [c * a ** (1 - m) for m, c in enumerate(_rationals(omega2, order))]


def fourier_taylor(n: int, order: int, a: Exact = 1) -> list[Expr]:
    """[A_{n,0}, …, A_{n,order}] of (C5a) as SymPy numbers; `a` is a positive number or symbol.

    >>> fourier_taylor(1, 3)
    [0, 1, 0, -1/192]
    """
    n, a = whole("n", n), _positive(a)
    with _closed_forms(whole("order", order)) as (omega2, mean, q):
        closed = mean if n == 0 else -2 * n * omega2 * (-q) ** n / (1 - q ** (2 * n))
        return [c * a ** (1 - m) for m, c in enumerate(_rationals(closed, order))]


@contextmanager
def _closed_forms(order: int) -> Iterator[Any]:
    """ω², A_0 and q as series in λ at a = 1, while flint keeps `order` + 1 terms."""
    terms = order + 2  # one is lost to the division by m
    with working(terms=terms):
        squares = [fmpq(comb(2 * k, k) ** 2, 16**k) for k in range(terms)]
        F = fmpq_series(squares)
        G = fmpq_series([c / (1 - 2 * k) for k, c in enumerate(squares)])
        m, one = fmpq_series([0, 1]), fmpq_series([1])
        log_q = ((one / ((one - m) * F * F) - one) / m).integral()
        q = m / 16 * log_q.exp()
        stretch = fmpq_series([3, 1])  # 3 + λ
        of_lam = fmpq_series([0, 2]) / stretch
        F, G, q = F(of_lam), G(of_lam), q(of_lam)
        yield 4 * stretch / (F * F), 2 - stretch * G / F, q


def _rationals(series: Any, order: int) -> list[fmpq]:
    if series.prec <= order:
        raise ArithmeticError(f"only {series.prec} Taylor coefficients of {order + 1} are known")
    return [sympy.Rational(int(c.p), int(c.q)) for c in (series[m] for m in range(order + 1))]


def _positive(a: Exact) -> Any:
    if not isinstance(a, sympy.Basic) or isinstance(a, sympy.Float):
        q = decimal(a)
        a = sympy.Rational(int(q.p), int(q.q))
    if not a.is_positive:
        raise InputError(f"a must be a positive number or Symbol('a', positive=True), not {a}.")
    return a
