"""Are these the coefficients of a solution?

Method.  The residuals of coefficients U_0, …, U_N that claim to solve a problem are looked at at
one phase, every order up to λ^N (:mod:`ftseries.phases`).  Then the first orders are solved again
exactly, and the last ones in the arithmetic of the coefficients (exact ones as balls of 128 bits,
free parameters at random rational values), for what those residuals leave open: a coordinate that
is settled late, see :mod:`ftseries.stages`.
"""

from __future__ import annotations

import random
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from flint import arb, fmpq, fmpq_mpoly
from tqdm import tqdm

from .aliases import Coefficients, Number
from .arguments import shown
from .conversion import at
from .degrees import highest
from .errors import UndeterminedError
from .grid import FloatRing
from .laurent import BallRing, RationalRing, SurdRing
from .linear import REACH, LinearPart
from .phases import unsatisfied
from .precision import working
from .stages import LATEST, Stages

if TYPE_CHECKING:
    from .problem import Problem
    from .trig import Ring

__all__ = ["fault"]

#: bits for exact coefficients
_BITS = 128
#: random values of free parameters are multiples of 1/_POINTS in (0, 1)
_POINTS = 2**20


def fault(problem: Problem, arithmetic: str, coefficients: Coefficients,
          precision: int | None = None) -> str | None:
    """Why these are not the coefficients of a solution (a predicate of them), or None.

    >>> import ftseries as fts
    >>> sol = fts.solve(fts.CubicOscillator(), order=6)
    >>> fault(sol.problem, "exact", sol.coefficients) is None
    True
    >>> sol.coefficients["omega"][6][0, 0] += 1
    >>> fault(sol.problem, "exact", sol.coefficients)
    'differ from those of CubicOscillator(a=1) in omega at order 6 of λ'
    """
    for late in LATEST:
        try:
            with np.errstate(all="ignore"), working(bits=precision or _BITS):
                return _Check(problem, arithmetic, coefficients, precision, late).fault()
        except UndeterminedError:
            if late == LATEST[-1]:
                raise
    return None


class _Check:
    def __init__(self, problem: Problem, arithmetic: str, coefficients: Coefficients,
                 precision: int | None, late: int) -> None:
        self.problem, self.arithmetic, self.coefficients = problem, arithmetic, coefficients
        self.precision, self.late = precision, late
        self.top = min(map(len, coefficients.values())) - 1
        point = {name: fmpq(random.SystemRandom().randrange(1, _POINTS), _POINTS)
                 for name in problem.parameters}
        self.exact: Ring = (_SurdAt if problem.surd else _RationalAt)(point)
        reach = self.top + late + REACH
        self.ring = _BallsAt(point) if arithmetic != "float" else FloatRing(
            degree=highest(problem, reach) if problem.ahead else reach, order=reach)
        values = list(point.values())
        self.given = _converted({name: [{mode: at(c, values) for mode, c in row.items()}
                                        for row in rows] for name, rows in coefficients.items()},
                                self.ring)

    def fault(self) -> str | None:
        """A contradiction, or what solving the first and the last orders again gives otherwise."""
        if found := unsatisfied(self.problem, self.arithmetic, self.coefficients,
                                precision=self.precision):
            return self.contradicts(found.equation, found.order)
        seed = self.problem.first_coefficients()
        order = max(self.top, *map(len, seed.values()))
        known = _converted(seed, self.exact)
        linear = LinearPart(self.problem, self.exact, known,
                            order + self.late + self.problem.ahead)
        tail = self.late + linear.reach
        lead = min(order, 2 * tail)
        exact = Stages(self.problem, linear, self.exact, known, lead, self.late)
        exact.run(tqdm(disable=True))
        start = min(self.top, max(lead, self.top - tail)) + 1
        stages = Stages(self.problem, exact.linear, self.ring, {
            name: [dict(row) for row in rows[:start]] for name, rows in self.given.items()},
            self.top, self.late)
        for k in range(start):
            if row := stages.unsatisfied(k):
                e = row[0][0]
                return self.contradicts(stages.linear.names[e], k + stages.linear.shifts[e])
        if reason := self.other(exact.known, range(min(lead, self.top) + 1), stages):
            return reason
        stages.run(tqdm(disable=True), fresh=False)
        return self.other(stages.known, range(start, self.top + 1), stages)

    def contradicts(self, equation: str, order: int) -> str:
        return f"contradict equation {equation} of {shown(self.problem)} at order {order} of λ"

    def other(self, found: Coefficients, orders: range, stages: Stages) -> str | None:
        """The first coefficients that are not those ``found``."""
        found, zero = _converted(found, self.ring), self.ring.number(0)
        for m in orders:
            # what settles a coordinate of order m, and rounds it, may stand some orders later
            size = max(stages.sizes.get(k, 0.0) for k in range(m, m + self.late + 1))
            for name, rows in self.given.items():
                row, other = rows[m], found[name][m]
                if not all(self.ring.negligible(row.get(mode, zero) - other.get(mode, zero), size)
                           for mode in {*row, *other}):
                    return (f"differ from those of {shown(self.problem)} in {name} at order {m} of "
                            "λ")
        return None


class _BallsAt(BallRing):
    """Balls, with a number in the place of each free parameter."""

    def __init__(self, point: Mapping[str, fmpq]) -> None:
        self.point, self.names = point, tuple(point)

    def parameter(self, name: str) -> arb:
        return self.number(self.point[name])


class _RationalAt(RationalRing):
    """The same exactly."""

    def __init__(self, point: Mapping[str, fmpq]) -> None:
        self.point, self.names = point, tuple(point)

    def parameter(self, name: str) -> fmpq:
        return self.point[name]


class _SurdAt(SurdRing):
    """The same exactly, with √3."""

    def __init__(self, point: Mapping[str, fmpq]) -> None:
        super().__init__()
        self.point, self.names = point, tuple(point)

    def parameter(self, name: str) -> fmpq_mpoly:
        return self.number(self.point[name])


def _converted(known: Coefficients, ring: Ring) -> Coefficients:
    def number(c: Number) -> Number:
        if isinstance(c, fmpq_mpoly) and not isinstance(ring, SurdRing):
            return ring.number(c.to_dict().get((0, 0), fmpq(0)))      # √3 cancels in the end
        return ring.number(c)
    return {name: [{mode: number(c) for mode, c in row.items()} for row in rows]
            for name, rows in known.items()}
