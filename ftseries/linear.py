r"""The linear part of the equations, found by probing them.

Formula.  Let R(U; λ) be the residual and U the solution.  Its derivative along U is

.. math::  DR_e = λ^{s_e} (L_0 + λ L_1 + λ^2 L_2 + …)_e  \quad\text{for equation } e,

where the L_j do not depend on the Taylor order that is being solved.  A *column* (name, sine, n)
is one mode of one unknown, a *row* (equation, sine, n) one mode of one residual.  :class:`Tangent`
gives DR·T for a series T of modes by running the problem's own equations over dual numbers u + ε v,
ε² = 0, in exact arithmetic.  :class:`Elimination` solves L₀ x = b and gives the kernel of L₀; what
cannot be solved is left over, and vanishes only if kernel coordinates of earlier orders are right.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from flint import fmpq

from .aliases import Coefficients, Column, Exact, Modes, Multiplier, Number, Terms, Vector
from .arguments import rational
from .errors import ContradictionError, InputError
from .expansion import Expansion
from .trig import Ring

if TYPE_CHECKING:
    from .problem import Problem
    from .trig import Trig

__all__ = ["Elimination", "Family", "LinearPart", "Tangent"]

#: orders of λ within which every equation must begin to depend on some unknown
REACH = 6
#: the lowest modes of each unknown that are probed for it
_PROBES = 4


class Dual:
    """A Taylor coefficient u + ε v with ε² = 0; it has the operations of a ``Trig``."""

    __slots__ = ("value", "tangent")

    def __init__(self, value: Trig, tangent: Trig) -> None:
        self.value, self.tangent = value, tangent

    def __add__(self, other: Dual) -> Dual:
        return Dual(self.value + other.value, self.tangent + other.tangent)

    def __mul__(self, other: Dual) -> Dual:
        return Dual(self.value * other.value,
                    self.value * other.tangent + self.tangent * other.value)

    def scale(self, number: Number) -> Dual:
        return Dual(self.value.scale(number), self.tangent.scale(number))

    def multiply_modes(self, multiplier: Multiplier) -> Dual:
        return Dual(self.value.multiply_modes(multiplier), self.tangent.multiply_modes(multiplier))

    def power(self, alpha: fmpq) -> Dual:
        value = self.value.power(alpha)
        return Dual(value, self.value.power(alpha - 1).scale(alpha) * self.tangent)

    def exp(self) -> Dual:
        return Dual(self.value.exp(), self.tangent)

    def sincos(self) -> tuple[Dual, Dual]:
        zero, one = self.value.sincos()
        return Dual(zero, self.tangent), Dual(one, zero)


class DualRing(Ring):
    """Dual numbers over an exact ring."""

    def __init__(self, base: Ring) -> None:
        self.base, self.names, self.zero = base, base.names, base.from_modes({})

    def number(self, x: Exact) -> Number:
        return self.base.number(x)

    def parameter(self, name: str) -> Number:
        return self.base.parameter(name)

    def from_modes(self, modes: Modes) -> Dual:  # type: ignore[override]   # in place of a Trig
        return Dual(self.base.from_modes(modes), self.zero)

    def convolve(  # type: ignore[override]
            self, a: Terms, b: Terms, k: int, lo: int, hi: int, alpha: int = 1,
            beta: int = 0) -> Dual:
        value_a, value_b = [x.value for x in a], [x.value for x in b]
        tangent_a, tangent_b = [x.tangent for x in a], [x.tangent for x in b]
        sum_ = self.base.convolve
        return Dual(sum_(value_a, value_b, k, lo, hi, alpha, beta),
                    sum_(value_a, tangent_b, k, lo, hi, alpha, beta)
                    + sum_(tangent_a, value_b, k, lo, hi, alpha, beta))


class Tangent:
    """DR·T at a base: the problem's equations over dual numbers, set up once for all T.

    ``base`` maps names to lists of ``{mode: number}``.
    """

    def __init__(self, problem: Problem, ring: Ring, base: Coefficients) -> None:
        self.ring, self.base = ring, base
        self.expansion = Expansion(DualRing(ring))
        self.unknowns = {name: self.expansion.unknown() for name in problem.unknowns}
        residuals = problem.residuals(self.expansion.lam, self.unknowns)
        self.names, self.residuals = list(residuals), list(residuals.values())

    def along(self, direction: list[Vector], top: int) -> Iterator[Vector]:
        """DR·T at the orders 0, …, ``top``, one after the other, each a dict ``{row: number}``.

        ``direction`` is the list of the T_j, each a dict ``{column: number}``.
        """
        self.expansion.forget(0)
        for name, unknown in self.unknowns.items():
            known = self.base[name]
            for k in range(top + 1):
                v = {(sine, n): self.ring.number(c) for (other, sine, n), c in
                     (direction[k] if k < len(direction) else {}).items() if other == name}
                unknown.set(k, Dual(self.ring.from_modes(known[k] if k < len(known) else {}),
                                    self.ring.from_modes(v)))
        for k in range(top + 1):
            yield {(e, *mode): c for e, residual in enumerate(self.residuals)
                   for mode, c in residual[k].tangent.modes().items()}


class Elimination:
    """Gauss-Jordan elimination of a sparse exact matrix, replayed on right-hand sides.

    ``columns`` maps each column to its ``{row: fmpq}``; columns are taken in the given order.

    >>> e = Elimination({"x": {0: fmpq(2), 1: fmpq(1)}, "y": {0: fmpq(4), 1: fmpq(2)}})
    >>> e.kernel
    [{'y': 1, 'x': -2}]
    >>> e.solve({0: fmpq(6), 1: fmpq(4)})                 # 2x + 4y = 6, x + 2y = 4: no solution
    ({'x': 4}, {0: -2})
    """

    def __init__(self, columns: Mapping[Any, Vector]) -> None:
        rows: dict[Any, Vector] = {}
        where = {col: set(entries) for col, entries in columns.items()}
        for col, entries in columns.items():
            for row, value in entries.items():
                rows.setdefault(row, {})[col] = value
        pivots: dict[Any, Any] = {}
        free = []
        #: pivot row, its column, 1/pivot, and (row, factor) of each row that the pivot row changes
        self.steps: list[tuple[Any, Any, Number, list[tuple[Any, Number]]]] = []
        for col in columns:
            usable = [row for row in where[col] if row not in pivots]
            if not usable:
                free.append(col)
                continue
            pivot = max(usable, key=_height)
            value = rows[pivot][col]
            changes = []
            for row in where[col] - {pivot}:
                factor = rows[row][col] / value
                changes.append((row, factor))
                for c, v in rows[pivot].items():
                    new = rows[row].get(c, 0) - factor * v
                    if new:
                        rows[row][c] = new
                        where[c].add(row)
                    else:
                        rows[row].pop(c, None)
                        where[c] -= {row} if c != col else set()
            where[col] = {pivot}
            pivots[pivot] = col
            self.steps.append((pivot, col, 1 / value, changes))
        self.kernel = [{f: fmpq(1)} | {col: -rows[row][f] / rows[row][col]
                                       for row, col in pivots.items() if f in rows[row]}
                       for f in free]

    def converted(self, number: Callable[[Exact], Number]) -> Elimination:
        """The same elimination with its factors as numbers of another ring."""
        other = object.__new__(Elimination)
        other.kernel = self.kernel
        other.steps = [(pivot, col, number(inverse), [(row, number(f)) for row, f in changes])
                       for pivot, col, inverse, changes in self.steps]
        return other

    def solve(self, b: Vector) -> tuple[Vector, Vector]:
        """(x, left): L x = b up to the rows in ``left``, which no column can change."""
        b = dict(b)
        for pivot, _, _, changes in self.steps:
            value = b.get(pivot)
            if value is not None:
                for row, factor in changes:
                    b[row] = b[row] - factor * value if row in b else -factor * value
        x = {col: b.pop(pivot) * inverse for pivot, col, inverse, _ in self.steps if pivot in b}
        return x, b


def _height(row: Any) -> tuple[int, ...]:
    return (row[2], -row[0], row[1]) if isinstance(row, tuple) else (row,)


class Family:
    """A kernel direction of L₀ with its consequences in the following orders.

    ``terms[j]`` is its response T_j (T_0 lies in the kernel), ``effects[j]`` what DR·T leaves over
    at order j.  Both are the same for every Taylor order at which the direction starts.
    """

    def __init__(self, linear: LinearPart, terms: list[Vector]) -> None:
        self.linear, self.terms = linear, terms
        self.effects: list[Vector] = [{}] * len(terms)

    def cut(self, length: int) -> None:
        """Keep so many orders of the response."""
        del self.terms[length:], self.effects[length:]

    def effect(self, late: int) -> Vector:
        """What a unit coordinate leaves over ``late`` orders after its own."""
        while len(self.effects) <= late:
            j = len(self.effects)
            x, left = self.linear.elimination.solve(self.linear.rows(self.terms, j))
            self.terms.append({col: -c for col, c in x.items() if c})
            self.effects.append({row: c for row, c in left.items() if c})
        return self.effects[late]


class LinearPart:
    """L₀ of a problem for all modes up to ``top``, its kernel and the families it opens."""

    def __init__(self, problem: Problem, ring: Ring, base: Coefficients, top: int) -> None:
        self.tangent = Tangent(problem, ring, base)
        self.names = self.tangent.names
        columns = [(name, *mode) for name, unknown in problem.unknowns.items()
                   for mode in unknown.columns(top)]
        columns.sort(key=lambda c: -c[2])
        self.shifts = self._leading_orders([c for name in problem.unknowns for c in
                                            [c for c in columns if c[0] == name][-_PROBES:]])
        self.elimination = Elimination({c: self.rows([{c: fmpq(1)}], 0) for c in columns})
        self.families = [Family(self, [vector]) for vector in self.elimination.kernel]
        #: L_j depends on the unknowns up to order j + reach
        self.reach, self.top = max(self.shifts), top
        self.base = self._base(base)

    def _base(self, known: Coefficients) -> list[list[Modes]]:
        """What L₀ depends on."""
        return [[dict(rows[m]) if m < len(rows) else {} for m in range(self.reach + 1)]
                for rows in known.values()]

    def fits(self, known: Coefficients) -> bool:
        """Is this still the linear part, now that so much is known?"""
        return self.base == self._base(known)

    def settled(self, k: int) -> None:
        """Order k is known from now on: drop the responses that were found without it."""
        for family in self.families:
            family.cut(max(k - self.reach, 1))

    def forget(self) -> None:
        """Drop all responses, as the unknowns have changed."""
        self.settled(0)

    def _leading_orders(self, columns: list[Column]) -> list[int]:
        """s_e for every equation."""
        shifts: dict[int, int] = {}
        for k in range(REACH + 1):
            for c in columns:
                *_, rows = self.tangent.along([{c: fmpq(1)}], k)
                for e, *_ in rows:
                    shifts.setdefault(e, k)
            if len(shifts) == len(self.names):
                break
        for e, name in enumerate(self.names):
            if e not in shifts:
                raise ContradictionError(f"equation {name} does not depend on any unknown up to "
                                         f"order {REACH} of λ; check it or the seed")
        return [shifts[e] for e in range(len(self.names))]

    def rows(self, direction: list[Vector], late: int) -> Vector:
        """(DR·T) at order ``late`` above the leading order of each equation, as rationals."""
        probe = list(self.tangent.along(direction, late + max(self.shifts)))
        return {(e, sine, n): self._rational(c, e) for e, s in enumerate(self.shifts)
                for (row, sine, n), c in probe[late + s].items() if row == e}

    def _rational(self, number: Number, e: int) -> fmpq:
        if isinstance(number, fmpq):
            return number
        if not number.is_constant():
            raise InputError(f"the linear part of equation {self.names[e]} depends on a parameter "
                             f"({self.tangent.ring.written(number)}), so the coefficients are not "
                             "polynomials in it; give the parameter a value")
        return rational(number.leading_coefficient()) if number else fmpq(0)
