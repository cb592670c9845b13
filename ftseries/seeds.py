r"""Seeds: the first terms of the unknowns, and the units in which all numbers become rational.

Formula.  With x = s X, ω = s_ω Ω and λ = l Λ, a term c λ^m of x is (c l^m / s) Λ^m of X.  The scale
s is an irrational leading c l^m; the unit l is 1, or what makes another c l^m / s, or an amplitude
itself, rational.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, TypeAlias

import sympy as sp

from .aliases import Expr, Mode
from .errors import InputError
from .expressions import by_name, quoted
from .problem import Field, Scalar
from .translate import harmonic, plain

if TYPE_CHECKING:
    from .symbolic import Equations

__all__ = ["ratio", "read", "measured", "units"]

#: unknown to Taylor order to mode to coefficient
Terms: TypeAlias = dict[str, dict[int, dict[Mode, Expr]]]


def read(problem: Equations, seed: Any) -> tuple[dict[str, str], Terms]:
    """Each unknown's first terms as text, and taken apart."""
    if not isinstance(seed, dict):
        raise InputError(f"seed={quoted(seed)}: give a dict from each unknown to its first terms, "
                         "such as {'x': 'lam*cos(omega*t)'}")
    texts: dict[str, str] = {}
    terms: Terms = {}
    for name, value in by_name(seed).items():
        if name not in problem.unknowns:
            raise InputError(f"the seed names {name}, which is not an unknown; they are "
                             f"{', '.join(problem.unknowns)}")
        value = sp.expand(problem.language.expression(value))
        texts[name] = problem.language.written(value)
        terms[name] = {}
        for term in sp.Add.make_args(value):
            m, mode, c = _term(problem, name, term)
            row = terms[name].setdefault(m, {})
            if c != 0:
                row[mode] = row.get(mode, 0) + c
    return texts, terms


def _term(problem: Equations, name: str, term: Expr) -> tuple[int, Mode, Expr]:
    """(Taylor order, mode, coefficient) of one term of a seed."""
    omega = sp.Symbol(problem.frequency) if problem.frequency else sp.S.One
    time, lam = (sp.Symbol(s) for s in (problem.variable, problem.language.lam))
    number, rest = term.as_independent(lam, time, as_Add=False) if term else (term, sp.S.One)
    m, mode = 0, None
    for factor in sp.Mul.make_args(rest):
        base, exponent = factor.as_base_exp()
        n = harmonic(factor, time, omega)
        if base == lam and exponent.is_Integer and exponent > 0:
            m += int(exponent)
        elif n and mode is None and isinstance(problem.unknowns[name], Field):
            mode = int(isinstance(factor, sp.sin)), n
        elif factor != 1:
            number = sp.nan
    if number.free_symbols or not number.is_finite or number.is_real is False:
        waves = f" * cos or sin of n*{omega}*{time}" if isinstance(
            problem.unknowns[name], Field) else ""
        raise InputError(f"the seed of {name} has the term {term}; its terms are number * "
                         f"{lam}**m{waves}")
    return m, mode or (0, 0), number


def measured(problem: Equations, terms: Terms,
             unit: Expr) -> tuple[dict[str, Any], dict[str, Expr]]:
    """The seed in rational numbers, and the scale of each unknown that needs one."""
    seed: dict[str, Any] = {}
    scales: dict[str, Expr] = {}
    for name, orders in terms.items():
        _, leading = next(_numbers(orders), (0, sp.S.One))
        first = plain(leading * unit**min((m for m, row in orders.items() if row), default=0))
        if not first.is_Rational:
            scales[name] = first
        scale = scales.get(name, sp.S.One)
        rows = []
        for m in range(max(orders) + 1):
            row = {mode: plain(c * unit**m / scale) for mode, c in orders.get(m, {}).items()}
            for mode, number in row.items():
                if not number.is_Rational:
                    raise InputError(
                        f"the seed of {name} has the number {orders[m][mode]} beside {leading}, "
                        "and their ratio is not rational; measure the unknown in other units")
            rows.append(row)
        scalar = isinstance(problem.unknowns[name], Scalar)
        seed[name] = [row.get((0, 0), 0) for row in rows] if scalar else rows
    return seed, scales


def units(terms: Terms) -> list[Expr]:
    """What λ may be measured in: 1, and what makes a second number of an unknown rational."""
    found = [sp.S.One]
    for orders in terms.values():
        m0, leading = next(_numbers(orders), (0, sp.S.One))
        for m, c in _numbers(orders):
            for power, number in ((m, 1 / c), (m - m0, leading / c)):
                unit = plain(sp.root(abs(number), power)) if power > 0 else sp.S.One
                if not unit.is_Rational and unit not in found:
                    found.append(unit)
    return found


def ratio(terms: Terms) -> tuple[str, str, Expr] | None:
    """Two fields whose amplitudes at order 1 have an irrational ratio, and that ratio."""
    leading = [(name, c) for name, orders in terms.items() for c in orders.get(1, {}).values()]
    for i, (name, c) in enumerate(leading):
        for other, d in leading[:i]:
            if not plain(c / d).is_Rational:
                return name, other, plain(c / d)
    return None


def _numbers(orders: dict[int, dict[Mode, Expr]]) -> Iterator[tuple[int, Expr]]:
    """(Taylor order, number) of the terms that are not zero, lowest order first."""
    return ((m, c) for m in sorted(orders) for c in orders[m].values() if c != 0)
