r"""Comparing coefficients, order by order: one stage for each Taylor order.

At stage k the coefficients U_k of Taylor order k are sought.  With R the residual, DR its leading
linear part (:mod:`ftseries.linear`) and s_e the order at which equation e begins to depend on the
unknowns,

1. evaluate R_{k+s} with U_k = 0;
2. solve L₀ x = -R_{k+s}.  What is left over depends on the kernel coordinates that earlier orders
   left open (A_{0,2m} in the figure eight, a_m in Mathieu's equation): settle them, the newest
   first, by their linear effect;
3. set U_k = x plus the consequences of what was settled, and open the kernel coordinates of order
   k;
4. evaluate again all rows that the stage touched, from the lowest order on: they have to vanish.

A coordinate that is settled late, at k, was opened at some order m < k, and its powers and products
act from order 2m on: on rows that were already closed, or on those of this very stage.  Where a row
that has been touched does not vanish, all stages are passed through again, and every coefficient
starts from the value it has now: what was settled before needs no change then, and what came too
late acts in its place.  A row that does not vanish while a coordinate is open whose square might
enter it waits for that one.

Why it ends.  If every coordinate is determined by an equation that is affine in it once those
settled before are right, then each pass makes one more right for good, and there are finitely many
up to the order at which squares no longer matter: coordinates opened at m and settled by m + late
disturb nothing beyond 2·late + s.  Otherwise the first orders are truly non-linear; that is refused
after some passes without progress.

A coordinate that stays open means that λ has no concrete meaning yet; a left-over that nothing can
change means that the equations contradict each other.  Both name the coefficient or the equation.
Stages beyond the order that was asked settle what is open there, and are held to the same.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, TypeAlias

from flint import fmpq

from . import rounding
from .aliases import Coefficients, Column, Number, Row, Vector
from .errors import ContradictionError, SolveError, UndeterminedError
from .expansion import Expansion
from .laurent import RationalRing
from .linear import Elimination, Family, LinearPart

if TYPE_CHECKING:
    from .problem import Problem
    from .trig import Ring

__all__ = ["LATEST", "Stages"]

#: what is to be added to the unknowns, by Taylor order
Changes: TypeAlias = dict[int, dict[Column, Number]]

#: how many orders late a coordinate is settled at the latest: tried one after the other
LATEST = (4, 12)
#: passes that end at the same stage before the first orders count as non-linear
_PASSES = 6


class Stages:
    """The state of one solve over one ring; ``known`` is extended in place."""

    def __init__(self, problem: Problem, linear: LinearPart, ring: Ring, known: Coefficients,
                 order: int, late: int = LATEST[0]) -> None:
        self.problem, self.ring, self.known = problem, ring, known
        self.order, self.late = order, late
        self.expansion = Expansion(ring)
        self.unknowns = {name: self.expansion.unknown() for name in problem.unknowns}
        self.residuals = list(problem.residuals(self.expansion.lam, self.unknowns).values())
        #: the size of the terms by which each order was found, in floats
        self.sizes: dict[int, float] = {}
        #: the largest term of each order of λ, in floats
        self.terms: dict[int, float] = {}
        #: how many orders of each unknown are given, and the first that is sought
        self.given = {name: len(rows) for name, rows in known.items()}
        self.start = min(self.given.values())
        self.begin(linear)

    def begin(self, linear: LinearPart) -> None:
        """What is given, and nothing open."""
        self.linear, self.elimination = linear, linear.elimination
        if not isinstance(self.ring, RationalRing):
            self.elimination = self.elimination.converted(self.ring.number)
        self.open: list[tuple[int, Family]] = []        # (the order it starts at, Family)
        self.waiting: int | None = None                 # the lowest order with a row that waits
        self.expansion.forget(0)
        for name, given in self.given.items():
            for k in range(given):
                self.unknowns[name].set(k, self.ring.from_modes(self.known[name][k]))

    def run(self, bar: Any, fresh: bool = True) -> None:
        """All stages; a ``fresh`` run also checks the seed and opens what it leaves free."""
        for k in range(self.start if fresh else 0):
            self.open_kernel(k)
            if row := self.unsatisfied(k):
                self.refuse(k, row, "the seed does not satisfy equation {name} at order {order} of "
                                    "λ; check the first coefficients")
        k, farthest, passes = self.start, self.start, 0
        while k <= self.order or any(start <= self.order for start, _ in self.open):
            touched = self.stage(k)
            lowest = min(k if self.waiting is None else self.waiting, *touched, k)
            bad = next((j for j in range(lowest, k + 1) if self.unsatisfied(j)), None)
            if bad is not None and fresh and (min(touched, default=k) < k
                                              or not self.linear.fits(self.known)):
                farthest, passes = max(farthest, k), 1 if k > farthest else passes + 1
                if passes > _PASSES:
                    self.nonlinear(bad)
                k = self.again()
                continue
            if bad is not None and not (fresh and self.may_change(bad)):
                self.refuse(bad)
            self.waiting = bad
            if k <= self.order:
                bar.update()
            k += 1
        if self.waiting is not None:
            self.refuse(self.waiting)
        for rows in self.known.values():
            del rows[self.order + 1:]

    def again(self) -> int:
        """Back to the first stage, with all coefficients as they are; its number."""
        if self.linear.fits(self.known):
            self.linear.forget()
        else:
            self.linear = LinearPart(self.problem, self.ring, self.known, self.linear.top)
        self.begin(self.linear)
        for k in range(self.start):
            self.open_kernel(k)
        return self.start

    def may_change(self, order: int) -> bool:
        """May the square of an open coordinate enter the rows of this order?"""
        return any(2 * start <= order + max(self.linear.shifts) for start, _ in self.open)

    def stage(self, k: int) -> set[int]:
        """One more order; those that it touched."""
        self.expansion.forget(k)
        for name, rows in self.known.items():
            if len(rows) <= k:
                rows.append({})
            if k >= self.given[name]:
                self.unknowns[name].set(k, self.ring.from_modes(rows[k]))
        ahead = None if self.ring.exact else self.problem.ahead         # the rest is rounding
        update, left = self.elimination.solve(
            {row: -c for row, c in self.residual(k, ahead).items()})
        changes = {k: update}
        self.settle(k, left, changes)
        touched = self.apply(changes, k)
        self.expansion.forget(min(touched, default=k))
        self.linear.settled(k)
        self.open_kernel(k)
        return touched

    def residual(self, k: int, ahead: int | None = None) -> dict[Row, Number]:
        """The rows of R_{k+s}; of Fourier orders at most so far ahead."""
        return {(e, sine, n): c for e, (series, shift) in enumerate(
            zip(self.residuals, self.linear.shifts)) for (sine, n), c in
            series[k + shift].modes().items()
            if ahead is None or n <= k + shift + ahead}

    def settle(self, k: int, left: dict[Row, Number], changes: Changes) -> None:
        """Fix open coordinates so that ``left`` vanishes; add what follows to ``changes``."""
        number = self.ring.number
        self.open.sort(key=lambda each: -each[0])               # the newest change the least
        effects = {i: family.effect(k - start) for i, (start, family) in enumerate(self.open)}
        matrix = Elimination(effects)
        values, _ = matrix.converted(number).solve(
            {row: c for row, c in left.items() if any(row in e for e in effects.values())})
        for i, value in values.items():
            if self.ring.is_zero(value):
                continue
            start, family = self.open[i]
            for j, term in enumerate(family.terms[:k - start + 1]):
                for column, c in term.items():
                    row = changes.setdefault(start + j, {})
                    row[column] = row.get(column, number(0)) + value * number(c)
        self.open = [self.combined(vector, k) for vector in matrix.kernel]
        for start, family in self.open:
            if k - start >= self.late and start <= self.order:
                name, sine, n = next(iter(family.terms[0]))
                label = _label(self.problem, name, sine, n, start)
                if self.waiting is not None:
                    self.nonlinear(self.waiting)
                raise UndeterminedError(
                    f"nothing up to {self.late} orders later determines {label}: λ has no concrete "
                    "meaning yet; fix an amplitude ('fixed' in its Field) or add the equation that "
                    "defines λ")

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
        """Add ``changes`` to the unknowns, as far as the ansatz has them; the orders touched."""
        touched = set()
        for m, update in changes.items():
            names = set()
            for (name, sine, n), c in update.items():
                if self.problem.allowed(name, n, m) and not self.ring.is_zero(c):
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

    def unsatisfied(self, k: int) -> tuple[Row, Number, float] | None:
        """A row of R_{k+s} that does not vanish, its value, and the size of its terms."""
        residual = self.residual(k)                     # evaluates the nodes that scale looks at
        scales = [self.scale(k + shift) for shift in self.linear.shifts]
        self.sizes[k] = max(self.terms[k + shift] for shift in self.linear.shifts)
        return next(((row, c, scales[row[0]]) for row, c in residual.items()
                     if not self.ring.negligible(c, scales[row[0]])), None)

    def scale(self, order: int) -> float:
        """The size of what is rounded at this order, see :mod:`ftseries.rounding`."""
        for j in range(order + 1):
            if j == order or j not in self.terms:
                self.terms[j] = _scale(self.expansion, j)
        return 0 if self.ring.exact else rounding.size([self.terms[j] for j in range(order + 1)])

    def refuse(self, k: int, row: tuple[Row, Number, float] | None = None, message: str =
               "equation {name} has no solution at order {order} of λ, mode {mode}: no coefficient "
               "can change it; the equations contradict each other, the seed or the ansatz, or the "
               "first orders are non-linear: then give a longer seed") -> None:
        """Say why the rows of R_{k+s} cannot vanish."""
        (e, sine, n), c, scale = row or self.unsatisfied(k)     # type: ignore[misc]
        order, name = k + self.linear.shifts[e], self.linear.names[e]
        beyond = n > order + self.problem.ahead
        if not self.ring.exact:
            if not math.isfinite(c):
                raise SolveError(f"the coefficients leave the floats at order {k} of λ; stay "
                                 "below, or solve with arithmetic='ball' or 'exact'")
            if abs(c) < 1e-3 * scale and not beyond:
                raise SolveError(
                    f"rounding has grown to {abs(c) / scale:.0e} of the terms at order "
                    f"{k} of λ; stay below, or solve with arithmetic='ball' or 'exact'")
        if k >= self.start:
            self.refuse_ansatz(k, beyond)
        if beyond:
            raise SolveError(f"the ansatz is too narrow: equation {name} has a term in "
                             f"{_wave(sine, n)} at order {order} of λ, and the Fourier orders of "
                             f"the ansatz are n ≤ m + {self.problem.ahead} at order m; choose a "
                             "larger 'ahead'")
        raise ContradictionError(message.format(name=name, order=order, mode=_wave(sine, n)))

    def refuse_ansatz(self, k: int, beyond: bool) -> None:
        """Refuse if coefficients would satisfy the rows that the ansatz or the seed leaves out."""
        update, _ = self.elimination.solve({row: -c for row, c in self.residual(k).items()})
        scale, ahead = self.scale(k), self.problem.ahead
        wanted = [(column, c) for column, c in update.items()
                  if not self.problem.allowed(column[0], column[2], k)
                  and (beyond and column[2] > k + ahead or not self.ring.negligible(c, scale))]
        if not wanted:
            return
        least = 0 if self.ring.exact else 1e-3 * max(abs(c) for _, c in wanted)    # no rounding
        (name, sine, n), c = next(each for each in wanted if not least or abs(each[1]) > least)
        label, number = _label(self.problem, name, sine, n, k), self.ring.written(c)
        if k < len(self.problem.seed[name]):
            raise SolveError("the seed does not satisfy the equations: they would "
                             f"change {label} by {number}")
        raise SolveError(f"the ansatz is too narrow: the equations ask for {label} = {number}, "
                         "which it leaves out" + (
                             f": its Fourier orders are n ≤ m + {ahead} at order m of λ; this one "
                             f"needs ahead={n - k} or more" if n > k + ahead else ""))

    def nonlinear(self, k: int) -> None:
        """Refuse where passing through the stages again does not lead on."""
        row, *_ = self.unsatisfied(k)           # type: ignore[misc]
        e = row[0]
        raise SolveError(
            f"equation {self.linear.names[e]} is non-linear in the coefficients that it has to "
            f"determine at order {k + self.linear.shifts[e]} of λ, and correcting them does not "
            "end; a longer seed chooses one of its solutions, if it has any")


def _scale(expansion: Expansion, order: int) -> float:
    """The largest term of this order, for the rounding of the float ring."""
    if expansion.ring.exact:
        return 0
    return max((abs(row).max() for node in expansion.nodes if len(node.table) > order
                for row in node.table[order].parts.values()), default=0.0)


def _label(problem: Problem, name: str, sine: int, n: int, m: int) -> str:
    if not hasattr(problem.unknowns[name], "series"):
        return f"the coefficient {name}_{m}"
    return f"the coefficient of {_wave(sine, n)} in {name} at order {m} of λ"


def _wave(sine: int, n: int) -> str:
    return f"{'sin' if sine else 'cos'} {n}τ"
