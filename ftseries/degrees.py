r"""How far the Fourier orders of the terms of an equation run: what a grid has to carry.

Formula.  With d_m the highest Fourier order at the Taylor order m, -∞ where there is none,

.. math::  d_m(u + v) = \max(d_m(u), d_m(v)), \qquad
           d_m(u v) = \max_{j} \big( d_j(u) + d_{m-j}(v) \big),

and powers, exponentials, sines and cosines follow by the recurrences of :mod:`ftseries.series`.
With the ansatz n ≤ m every d_m is at most m; where an ansatz runs ahead, n ≤ m + a, every factor
brings its own a.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .aliases import Exact, Modes, Multiplier, Number, Terms
from .expansion import Expansion
from .trig import Ring, Table

if TYPE_CHECKING:
    from .problem import Problem

__all__ = ["highest"]


class Degree:
    """The highest Fourier order of a sum; -1 for none.  It has the operations of a ``Trig``."""

    __slots__ = ("n",)

    def __init__(self, n: int) -> None:
        self.n = n

    def __add__(self, other: Degree) -> Degree:
        return self if self.n >= other.n else other

    def __mul__(self, other: Degree) -> Degree:
        return Degree(self.n + other.n if min(self.n, other.n) >= 0 else -1)

    def scale(self, number: Number) -> Degree:
        return self

    def multiply_modes(self, multiplier: Multiplier) -> Degree:
        return self

    def power(self, alpha: Exact) -> Degree:
        return Degree(0)

    def exp(self) -> Degree:
        return Degree(0)

    def sincos(self) -> tuple[Degree, Degree]:
        return Degree(-1), Degree(0)


class DegreeRing(Ring):
    """Degrees in place of numbers."""

    def __init__(self, names: tuple[str, ...]) -> None:
        self.names = names

    def number(self, x: Exact) -> Number:
        return 1

    def parameter(self, name: str) -> Number:
        return 1

    def from_modes(self, modes: Modes) -> Degree:  # type: ignore[override]   # in place of a Trig
        return Degree(max((n for _, n in modes), default=-1))

    def table(self) -> Terms:
        return Table()

    def convolve(self, a: Terms, b: Terms, k: int, lo: int, hi: int,  # type: ignore[override]
                 alpha: int = 1, beta: int = 0) -> Degree:
        return Degree(max((u.n + v.n for u, v in zip(a[lo:hi + 1], reversed(b[k - hi:k - lo + 1]))
                           if min(u.n, v.n) >= 0), default=-1))


def highest(problem: Problem, top: int) -> int:
    """The highest Fourier order in any term of the equations up to the order ``top`` of λ.

    >>> import ftseries as fts
    >>> highest(fts.FigureEight(), 6)
    6
    """
    expansion: Any = Expansion(DegreeRing(problem.parameters))
    unknowns = {}
    for name, rows in problem.first_coefficients().items():
        kind = problem.unknowns[name]
        unknowns[name] = expansion.polynomial(rows + [
            {mode: 1 for mode in kind.columns(m + problem.ahead)[:1] if problem.in_powers(name, m)}
            for m in range(len(rows), top + 1)])
    residuals = problem.residuals(expansion.lam, unknowns)
    for residual in residuals.values():
        residual[top]
    return max(int(term.n) for node in expansion.nodes for term in node.table[:top + 1])
