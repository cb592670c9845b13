r"""Comparing coefficients, order by order: one stage for each Taylor order.

At stage k the coefficients U_k of Taylor order k are sought.  With R the residual, DR its leading
linear part (:mod:`ftseries.linear`) and s_e the order at which equation e begins to depend on the
unknowns,

1. evaluate R_{k+s} with U_k = 0;
2. solve L₀ x = -R_{k+s}.  What is left over depends affinely on the kernel coordinates that
   earlier orders left open (A_{0,2m} in the figure eight, a_m in Mathieu's equation): settle them;
3. set U_k = x plus the consequences of what was settled, open the kernel coordinates of order k,
   and check that R_{k+s} now vanishes.

A coordinate that stays open means that λ has no concrete meaning yet; a left-over that nothing can
change means that the equations contradict each other.  Both name the coefficient or the equation.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, TypeAlias

from flint import fmpq

from .aliases import Coefficients, Column, Number, Row, Vector
from .errors import ContradictionError, SolveError, UndeterminedError
from .expansion import Expansion
from .laurent import RationalRing
from .linear import Elimination, Family

if TYPE_CHECKING:
    from .linear import LinearPart
    from .problem import Problem
    from .trig import Ring

__all__ = ["LATEST", "Stages", "contradiction"]

#: what is to be added to the unknowns, by Taylor order
Changes: TypeAlias = dict[int, dict[Column, Number]]

#: how many orders late a coordinate may be settled
LATEST = 4


class Stages:
    """The state of one solve over one ring; ``known`` is extended in place."""

    def __init__(self, problem: Problem, linear: LinearPart, ring: Ring, known: Coefficients,
                 order: int) -> None:
        self.problem, self.linear, self.ring = problem, linear, ring
        self.known, self.order = known, order
        self.expansion = Expansion(ring)
        self.unknowns = {name: self.expansion.unknown() for name in problem.unknowns}
        self.residuals = list(problem.residuals(self.expansion.lam, self.unknowns).values())
        self.elimination = linear.elimination
        if not isinstance(ring, RationalRing):
            self.elimination = self.elimination.converted(ring.number)
        self.open: list[tuple[int, Family]] = []        # (the order it starts at, Family)
        self.start = min(len(rows) for rows in known.values())
        for name, rows in known.items():
            for k, row in enumerate(rows):
                self.unknowns[name].set(k, ring.from_modes(row))

    def run(self, bar: Any, fresh: bool = True) -> None:
        """All stages; a ``fresh`` run also checks the seed and opens what it leaves free."""
        for k in range(self.start if fresh else 0):
            self.open_kernel(k)
            self.verify(k, "the seed does not satisfy equation {name} at order {order} of λ; "
                           "check the first coefficients")
        k = self.start
        while k <= self.order or any(start <= self.order for start, _ in self.open):
            self.stage(k)
            if k <= self.order:
                bar.update()
            k += 1
        for rows in self.known.values():
            del rows[self.order + 1:]

    def stage(self, k: int) -> None:
        self.expansion.forget(k)
        for name, rows in self.known.items():
            if len(rows) <= k:
                rows.append({})
                self.unknowns[name].set(k, self.ring.from_modes({}))
        residual = self.residual(k)
        update, left = self.elimination.solve({row: -c for row, c in residual.items()})
        changes = {k: update}
        self.settle(k, left, changes)
        touched = self.apply(changes, k)
        self.expansion.forget(min(touched, default=k))
        self.open_kernel(k)
        if k <= self.order:
            self.verify(k, "equation {name} has no solution at order {order} of λ, mode {mode}: "
                           "no coefficient can change it; the equations contradict each other, the "
                           "seed or the ansatz, or the first orders are non-linear: then give a "
                           "longer seed")

    def residual(self, k: int) -> dict[Row, Number]:
        """The rows of R_{k+s}."""
        rows = {}
        for e, (series, shift) in enumerate(zip(self.residuals, self.linear.shifts)):
            for (sine, n), c in series[k + shift].modes().items():
                if self.ring.exact or n <= k + shift + self.problem.ahead:
                    rows[e, sine, n] = c
        return rows

    def settle(self, k: int, left: dict[Row, Number], changes: Changes) -> None:
        """Fix open coordinates so that ``left`` vanishes; add what follows to ``changes``."""
        number = self.ring.number
        effects = {i: family.effect(k - start) for i, (start, family) in enumerate(self.open)}
        matrix = Elimination(effects)
        values, _ = matrix.converted(number).solve(
            {row: c for row, c in left.items() if any(row in e for e in effects.values())})
        for i, value in values.items():
            start, family = self.open[i]
            for j, term in enumerate(family.terms[:k - start + 1]):
                for column, c in term.items():
                    row = changes.setdefault(start + j, {})
                    row[column] = row.get(column, number(0)) + value * number(c)
        self.open = [self.combined(vector, k) for vector in matrix.kernel]
        for start, family in self.open:
            if k - start >= LATEST and start <= self.order:
                name, sine, n = next(iter(family.terms[0]))
                raise UndeterminedError(
                    f"nothing determines {_label(self.problem, name, sine, n, start)}: λ has no "
                    "concrete meaning yet; fix an amplitude ('fixed' in its Field) or add the "
                    "equation that defines λ")

    def combined(self, vector: Vector, k: int) -> tuple[int, Family]:
        """The open direction Σ vector_i · (direction i); a single one is kept as it is."""
        if len(vector) == 1:
            (only,) = vector
            return self.open[int(only)]
        first = min(self.open[i][0] for i in vector)
        terms: list[Vector] = [{} for _ in range(k - first + 1)]
        for i, weight in vector.items():
            start, family = self.open[i]
            for j, term in enumerate(family.terms[:k - start + 1]):
                for column, c in term.items():
                    row = terms[start - first + j]
                    row[column] = row.get(column, fmpq(0)) + weight * c
        return first, Family(self.linear, terms)

    def apply(self, changes: Changes, k: int) -> set[int]:
        """Add ``changes`` to the unknowns; the orders that were touched."""
        touched, scale = set(), self.scale(k)
        for m, update in changes.items():
            names = set()
            for (name, sine, n), c in update.items():
                if not self.problem.allowed(name, n, m):
                    if not self.ring.negligible(c, scale):
                        label = _label(self.problem, name, sine, n, m)
                        if m < len(self.problem.seed[name]):
                            raise SolveError("the seed does not satisfy the equations: they would "
                                             f"change {label} by {c}")
                        raise SolveError("the ansatz is too narrow: the equations ask for "
                                         f"{label} = {c}, which it leaves out")
                    continue
                row = self.known[name][m]
                row[sine, n] = row[sine, n] + c if (sine, n) in row else c
                names.add(name)
            for name in names:
                row = self.known[name][m]
                if self.ring.exact:
                    for mode in [mode for mode, c in row.items() if self.ring.is_zero(c)]:
                        del row[mode]
                for j in range(m, k + 1):
                    self.unknowns[name].set(j, self.ring.from_modes(self.known[name][j]))
                touched.add(m)
        return touched

    def open_kernel(self, k: int) -> None:
        """Kernel coordinates that order k leaves free."""
        for family in self.linear.families:
            if all(self.problem.allowed(name, n, k) for name, _, n in family.terms[0]):
                self.open.append((k, family))

    def verify(self, k: int, message: str) -> None:
        residual = self.residual(k)                     # evaluates the nodes that scale looks at
        scales = [self.scale(k + shift) for shift in self.linear.shifts]
        for (e, sine, n), c in residual.items():
            if not self.ring.negligible(c, scales[e]):
                if not self.ring.exact and not math.isfinite(c):
                    raise SolveError(f"the coefficients leave the floats at order {k} of λ; stay "
                                     "below, or solve with arithmetic='ball' or 'exact'")
                if not self.ring.exact and abs(c) < 1e-3 * scales[e]:
                    raise SolveError(
                        f"rounding has grown to {abs(c) / scales[e]:.0e} of the terms at order "
                        f"{k} of λ; stay below, or solve with arithmetic='ball' or 'exact'")
                raise ContradictionError(message.format(
                    name=self.linear.names[e], order=k + self.linear.shifts[e],
                    mode=f"{'sin' if sine else 'cos'} {n}τ"))

    def scale(self, order: int) -> float:
        return _scale(self.expansion, order)


def contradiction(problem: Problem, ring: Ring, known: Coefficients,
                  top: int) -> tuple[str, int] | None:
    """(equation, order) of the first residual up to order ``top`` that does not vanish."""
    expansion = Expansion(ring)
    unknowns = {name: expansion.polynomial(rows) for name, rows in known.items()}
    residuals = problem.residuals(expansion.lam, unknowns)
    for k in range(top + 1):
        rows = {name: residual[k].modes() for name, residual in residuals.items()}
        scale = _scale(expansion, k)
        for name, row in rows.items():
            if not all(ring.negligible(c, scale) for (_, n), c in row.items()
                       if ring.exact or n <= k + problem.ahead):
                return name, k
    return None


def _scale(expansion: Expansion, order: int) -> float:
    """The size of the terms of this order, for the rounding of the float ring."""
    if expansion.ring.exact:
        return 0
    return max((abs(row).max() for node in expansion.nodes if len(node.table) > order
                for row in node.table[order].parts.values()), default=0.0)


def _label(problem: Problem, name: str, sine: int, n: int, m: int) -> str:
    if not hasattr(problem.unknowns[name], "series"):
        return f"the coefficient {name}_{m}"
    return f"the coefficient of {'sin' if sine else 'cos'} {n}τ in {name} at order {m} of λ"
