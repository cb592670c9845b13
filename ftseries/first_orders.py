r"""The first orders of the equations, with symbols in place of the first coefficients.

The symbols are parameters of a polynomial ring, over which the problem's own equations are run, so
that the coefficient of each mode and order of λ becomes a polynomial in them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

import sympy as sp

from .aliases import Expr, Mode
from .conversion import to_sympy
from .expansion import Expansion
from .laurent import PolynomialRing, SurdRing
from .problem import Scalar

if TYPE_CHECKING:
    from .problem import Field
    from .symbolic import Equations

__all__ = ["Known", "Symbols", "fixed", "is_low", "residual", "symbols"]

#: the symbol of each first coefficient, (unknown, mode, order); the values found for some
Symbols: TypeAlias = dict[tuple[str, Mode, int], Expr]
Known: TypeAlias = dict[Expr, Expr]


def symbols(problem: Equations, top: int) -> Symbols:
    """``{(name, mode, m): symbol}`` up to Taylor order ``top``."""
    return {(name, mode, m): sp.Dummy(f"{name}_{'sc'[1 - mode[0]]}{mode[1]}_{m}"
                                      if not isinstance(unknown, Scalar) else f"{name}_{m}")
            for name, unknown in problem.unknowns.items()
            for m in range(top + 1) for mode in unknown.columns(m + problem.ahead)
            if problem.in_powers(name, m)}


def is_low(problem: Equations, name: str, m: int) -> bool:
    """Is this one of the coefficients that a seed gives: order 0, and 1 of a field?"""
    return m == 0 or (m == 1 and not isinstance(problem.unknowns[name], Scalar))


def residual(problem: Equations, named: Symbols, known: Known, order: int) -> list[Expr]:
    """The residual's coefficients of one order as SymPy polynomials in what is not yet known."""
    open_symbols = [s for (_, _, m), s in named.items() if m <= order and s not in known]
    irrational = {s: v for s, v in known.items() if not v.is_Rational}
    ring = (SurdRing if problem.surd else PolynomialRing)(
        (*problem.parameters, *open_symbols, *irrational))
    expansion = Expansion(ring)
    unknowns = {}
    for name, unknown in problem.unknowns.items():
        unknowns[name] = expansion.unknown()
        for m in range(order + 1):
            row: dict[Mode, Any] = {}
            for (other, mode, k), s in named.items():
                if other == name and k == m:
                    value = known.get(s, s)
                    row[mode] = (ring.parameter(s) if value == s or s in irrational
                                 else ring.number(value))
            for mode, value in fixed(problem, name, unknown, m).items():
                row[mode] = ring.number(value)
            unknowns[name].set(m, ring.from_modes({k: v for k, v in row.items() if v != 0}))
    values = [known.get(s, s) for s in ring.names]
    return [sp.expand(e) if irrational else e
            for residual in problem.equations(expansion.lam, **unknowns).values()
            for e in (to_sympy(c, values) for c in residual[order].modes().values())]


def fixed(problem: Equations, name: str, unknown: Field | Scalar, m: int) -> dict[Mode, int]:
    """λ is the amplitude of a fixed Fourier order; a fixed mode (sine, n) is a phase and zero."""
    orders = unknown.fixed if not isinstance(unknown, Scalar) and m == 1 else ()
    return {unknown.mode(n): 1 for n in orders if not isinstance(n, tuple)}
