r"""Oscillations in a cubic potential, section 2 of the paper.

Index convention and formula.  With the ansatz (C5),

.. math::  x(t) = \sum_{n \ge 0} \sum_{m \ge n} A_{n,m} λ^m \cos nωt, \qquad ω = \sum_m ω_m λ^m.

Lengths are measured in a and times in 1/√a, so the solver works at a = 1; there ω = 2√3·Ω, and all
coefficients of x and Ω are rational.  Then A_{n,m}(a) = a^{1-m} A_{n,m}(1) and
ω_m(a) = 2√3 a^{1/2-m} Ω_m(1).
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from ..aliases import Expr, Function, Json
from ..errors import InputError
from ..expressions import expression, quoted
from ..problem import Field, Problem, Scalar

__all__ = ["CubicOscillator"]


class CubicOscillator(Problem):
    """A particle between the turning points -a-λ and -a+λ of the cubic potential (C1).

    Parameters
    ----------
    a : number or SymPy expression
        The positive parameter of (C1); a symbol stays a symbol in the coefficients.

    Examples
    --------
    >>> import sympy as sp, ftseries as fts
    >>> sol = fts.solve(fts.CubicOscillator(a=sp.Symbol("a", positive=True)), order=3)
    >>> sol.coefficient("x", 1, 3)                       # equation (C7a)
    -1/(192*a**2)
    """

    unknowns = {"x": Field("cos"), "omega": Scalar()}
    seed = {"x": [{0: -1}, {1: 1}], "omega": [1]}
    frequency = "omega"

    def __init__(self, a: Any = 1) -> None:
        self.a = expression(a)
        if self.a.is_positive is False or self.a in (sp.nan, sp.oo, sp.zoo):
            raise InputError(f"a={quoted(a)}: the parameter a of (C1) must be positive and finite")

    def equations(  # type: ignore[override]     # the unknowns by name
            self, lam: Function, x: Function, omega: Function) -> dict[str, Function]:
        return {"(C3)": 12 * omega**2 * x.diff()**2 - 4 * (x - 2) * (x - lam + 1) * (x + lam + 1)}

    def scale(self, name: str) -> Expr:
        return self.a if name == "x" else 2 * sp.sqrt(3) * sp.sqrt(self.a)

    @property
    def lam_scale(self) -> Expr:
        return self.a

    def arguments(self) -> dict[str, Json]:
        return {"a": str(self.a)}
