r"""When `evaluate` is wrong, does it say so? Against motions known from elsewhere, as a table.

    PYTHONPATH=tests python benchmarks/calibration.py           # or: make calibration

A row is one unknown of one problem at one order, one λ and one late time: the largest error over a
period, relative to the largest value, and whether `evaluate` warned. Truth: Jacobi's elliptic
functions for the oscillators of Duffing, the pendulum and the cubic potential; SciPy and Hill's
matrix for Mathieu's equation, with the parameter μ kept free in one of them; integration for van
der Pol; Newton's method for the figure eight.
"""

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import numpy as np
from sample_problems import Duffing, Pendulum, VanDerPol
from scipy.optimize import brentq
from scipy.special import ellipj, ellipk

import ftseries as fts
from ftseries.references import cubic, mathieu
from ftseries.references.van_der_pol import LimitCycle

PHASES = 2 * np.pi * (np.arange(24) + 0.3) / 24
ORDERS = (1, 2, 3, 4, 5, 6, 8, 10, 12, 14, 16, 20, 24, 30, 40, 60)
SHARES = (.3, .4, .5, .6, .7, .75, .8, .85, .9, .95, .98, 1.02, 1.05, 1.1, 1.15, 1.2, 1.3, 1.4,
          1.5, 1.7, 2)
LATE = (0, 10**2, 10**4, 10**6, 10**9)
#: an error that must not pass in silence, and one that needs no warning
WRONG, GOOD = 1e-2, 1e-3


@dataclass
class Case:
    """A problem, the radius of convergence, and ``truth(λ)``: ω or None, values by unknown."""

    name: str
    problem: fts.Problem
    radius: float
    truth: Callable[[float], tuple[float | None, dict[str, Any]]]
    most: float = 2.0
    parameters: dict[str, float] | None = None
    arithmetic: str = "float"
    top: int = 60

    @cached_property
    def solution(self) -> fts.Solution:
        return fts.solve(self.problem, self.top, self.arithmetic, progress=False)


def first_cosine(values):
    """2 × the mean of u(τ) cos τ, from values over a period."""
    return 2 * np.mean(values * np.cos(_grid())) if len(values) else 0.0


def _grid():
    return 2 * np.pi * np.arange(512) / 512


def by_amplitude(motion, lowest, highest):
    """The truth at the amplitude where the first cosine of ``motion(amplitude, τ)`` is λ."""
    def truth(lam):
        found = brentq(lambda a: first_cosine(motion(a, _grid())[1]) - lam, lowest, highest,
                       xtol=1e-14)
        omega, x = motion(found, PHASES)
        return omega, {"x": x, "omega": omega}
    return truth


def duffing(amplitude, tau):
    """A cn."""
    m = amplitude**2 / (2 + 2 * amplitude**2)
    quarter = ellipk(m)
    return (np.pi * np.sqrt(1 + amplitude**2) / (2 * quarter),
            amplitude * ellipj(2 * quarter * tau / np.pi, m)[1])


def pendulum(k, tau):
    """2 arcsin(k cd)."""
    quarter = ellipk(k * k)
    _, cn, dn, _ = ellipj(2 * quarter * tau / np.pi, k * k)
    return np.pi / (2 * quarter), 2 * np.arcsin(np.clip(k * cn / dn, -1, 1))


def cubic_motion(lam):
    omega = float(cubic.frequency(lam))
    return omega, {"x": cubic.position(PHASES / omega, lam), "omega": omega}


def mathieu_function(mu):
    def truth(lam):
        a = mathieu.eigenvalue(lam, mu) if mu else mathieu.mathieu_b(lam)
        return None, {"psi": mathieu.eigenfunction(PHASES, lam, mu), "a": float(a)}
    return truth


def van_der_pol(lam):
    cycle = LimitCycle(lam**2)
    return cycle.omega, {"y": lam * cycle(PHASES), "omega": cycle.omega}


@cache
def eight(lam):
    """Newton's method, followed from the series inside its disc."""
    orbit = fts.solve(fts.FigureEight(), 60, "float", progress=False).refine(min(lam, 2.0))
    for step in np.arange(2.05, lam, 0.05):
        orbit = orbit.refine(lam=step)
    orbit = orbit.refine(lam=lam)
    return 1.0, {name: orbit.evaluate(name, PHASES) for name in ("r", "phi")}


def cases():
    return [
        Case("Duffing", Duffing(), 1.21547, by_amplitude(duffing, 1e-9, 20)),
        Case("pendulum", Pendulum(), 4, by_amplitude(pendulum, 1e-9, 1 - 1e-10), 0.95),
        Case("cubic", fts.CubicOscillator(), 3, cubic_motion, 0.98),
        Case("Mathieu, μ = 0", fts.GeneralizedMathieu(0), 2.74589, mathieu_function(0)),
        Case("Mathieu, μ free", fts.GeneralizedMathieu(), 1.86, mathieu_function(-0.3),
             parameters={"mu": -0.3}, arithmetic="exact", top=40),
        Case("van der Pol", VanDerPol(), 1.35992, van_der_pol),
        Case("figure eight", fts.FigureEight(), 2.2095, eight, 1.15),
    ]


@dataclass
class Row:
    case: str
    unknown: str
    order: int
    share: float
    late: int
    error: float
    warned: bool


def rows(case, orders=ORDERS, shares=SHARES, late=LATE):
    """Every unknown of a case at every order, λ/R and late time, in periods."""
    for share in (share for share in shares if share <= case.most):
        lam = share * case.radius
        omega, values = case.truth(lam)
        for order in (order for order in orders if order <= case.top):
            solution = case.solution.truncate(order)
            for name, truth in values.items():
                moves = np.ndim(truth) > 0
                for periods in late if omega and moves else (0,):
                    rate = omega or 1.0
                    t = [(PHASES + 2 * np.pi * periods) / rate] if moves else []
                    with warnings.catch_warnings(record=True) as said:
                        warnings.simplefilter("always")
                        value = solution.evaluate(name, *t, lam=lam, **(case.parameters or {}))
                    error = np.max(abs(value - truth)) / np.max(abs(truth))
                    doubted = any(w.category is fts.ConvergenceWarning for w in said)
                    yield Row(case.name, name, order, share, periods, float(error), doubted)


COLUMNS = ("periods", "order", "wrong", "of these silent", "the worst of these", "good",
           "of these warned", "error below 0.01 %", "of these warned")


def summary(found, late, order):
    """A line of the table: counts of the rows that are wrong and silent, or good and warned."""
    wrong = [row for row in found if row.error > WRONG]
    silent = [row for row in wrong if not row.warned]
    good, best = ([row for row in found if row.error < limit] for limit in (GOOD, GOOD / 10))
    worst = f"{max((row.error for row in silent), default=0):.2%}"
    return (late, order, len(wrong), len(silent), worst, len(good),
            sum(row.warned for row in good), len(best), sum(row.warned for row in best))


def main():
    found = [row for case in cases() for row in rows(case)]
    print("|" + "|".join(COLUMNS) + "|\n" + "|---" * len(COLUMNS) + "|")
    for late in LATE:
        for order in (*ORDERS, "all"):
            some = [row for row in found if row.late == late and order in (row.order, "all")]
            print("|" + "|".join(map(str, summary(some, f"{late:g}", order))) + "|")
    for row in found:
        if row.error > WRONG and not row.warned:
            print(row)


if __name__ == "__main__":
    main()
