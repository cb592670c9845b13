r"""Are the stated errors true? True error over stated error, against motions known from elsewhere.

    PYTHONPATH=tests python benchmarks/stated_errors.py         # or: make stated-errors

A row is one statement: ``error_estimate`` of a truncated series at a fixed phase, ``error`` of a
Padé sum, its ``estimate`` of the frequency, or a radius of convergence.  Truth: Fourier series in
the nome for the oscillators of Duffing, the pendulum and the cubic potential; Hill's matrix for
Mathieu's equation; integration for van der Pol; Newton's equations for the figure eight.
"""

import math
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from sample_problems import Duffing, Pendulum, VanDerPol
from scipy.optimize import brentq

import ftseries as fts
from ftseries.evaluation import fourier_sum
from ftseries.references import cubic, gallery, mathieu, newton
from ftseries.references.van_der_pol import LimitCycle

PHASES = 2 * np.pi * (np.arange(24) + 0.3) / 24
ORDERS = (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 20, 24, 30, 40, 50, 60)
SHARES = (0.1, 0.3, 0.5, 0.7, 0.85, 0.95, 0.975, 0.99, 1.1, 1.3, 1.7)
RADIUS_ORDERS = (18, 20, 22, 24, 30, 40, 42, 50, 60, 70, 84, 90, 92, 100)


@dataclass
class Case:
    """``truth(λ)`` gives values by unknown: at PHASES, or a number; good to ``accuracy``."""

    name: str
    problem: fts.Problem
    radius: float
    truth: Callable[[float], dict[str, Any]]
    most: float = 2.0
    accuracy: float = 2e-15
    parameters: dict[str, float] | None = None
    lams: tuple[float, ...] = ()

    def up_to(self, order: int) -> fts.Solution:
        return fts.solve(self.problem, order, progress=False)

    @property
    def points(self) -> tuple[float, ...]:
        return self.lams or tuple(s * self.radius for s in SHARES if s <= self.most)


def _theta_3(q):
    return 1 + 2 * sum(q ** (k * k) for k in range(1, 40))


def _theta_2(q):
    return 2 * q**0.25 * sum(q ** (k * (k + 1)) for k in range(40))


def _odd_cosines(amplitude):
    return sum(amplitude(k) * np.cos((2 * k + 1) * PHASES) for k in range(400))


def pendulum(lam):
    """DLMF 22.16.9: x = 8 Σ (-1)^k q^{k+1/2} cos (2k+1)τ / ((2k+1) (1 + q^{2k+1}))."""
    q = (lam / (4 + math.sqrt(16 - lam**2))) ** 2
    return {"omega": _theta_3(q) ** -2, "x": _odd_cosines(
        lambda k: 8 * (-1) ** k * q ** (k + 0.5) / (2 * k + 1) / (1 + q ** (2 * k + 1)))}


def _duffing_omega(q):
    return (_theta_3(q) ** 4 - 2 * _theta_2(q) ** 4) ** -0.5


def duffing(lam):
    """DLMF 22.11.2: x = λ Σ q^k (1 + q) cos (2k+1)τ / (1 + q^{2k+1})."""
    q = brentq(lambda q: math.sqrt(32 * q) / (1 + q) * _duffing_omega(q) - lam, 0,
               math.exp(-math.pi) * (1 - 1e-9), xtol=1e-300, rtol=1e-15)
    return {"omega": _duffing_omega(q), "x": _odd_cosines(
        lambda k: lam * q**k * (1 + q) / (1 + q ** (2 * k + 1)))}


def cubic_motion(lam):
    return {"omega": float(cubic.frequency(lam)), "x": fourier_sum(
        {(0, n): cubic.fourier_coefficient(n, lam) for n in range(60)}, PHASES)}


def mathieu_function(mu):
    def truth(lam):
        return {"a": float(mathieu.eigenvalue(lam, mu)),
                "psi": mathieu.eigenfunction(PHASES, lam, mu)}
    return truth


def van_der_pol(lam):
    cycle = LimitCycle(lam**2)
    return {"omega": cycle.omega, "y": lam * cycle(PHASES)}


def eight(lam):
    """r_12 from the positions by Newton's equations, at the λ at which they hold."""
    first, second, _ = newton.figure_eight(PHASES)
    between = second - first
    return {"r": np.abs(between)}


def cases():
    return [
        Case("pendulum", Pendulum(), 4, pendulum, 0.99),
        Case("Duffing", Duffing(), abs(gallery.duffing_turn()) ** 0.5, duffing),
        Case("cubic", fts.CubicOscillator(), 3, cubic_motion, 0.99),
        Case("Mathieu", fts.GeneralizedMathieu(0), 2.745891, mathieu_function(0), 1.7, 2e-14),
        Case("van der Pol", VanDerPol(), 1.35992, van_der_pol, accuracy=2e-12),
        Case("figure eight", fts.FigureEight(), 2.2095, eight, accuracy=3e-14,
             lams=(newton.figure_eight_lambda(),)),
    ]


@dataclass
class Row:
    """A statement; the ratio allows for what the truth itself may be off by."""

    kind: str
    case: str
    unknown: str
    order: int
    lam: float
    true: float
    stated: float
    size: float
    accuracy: float
    warned: bool | None = None

    @property
    def ratio(self) -> float:
        excess = max(self.true - self.accuracy * self.size, 0.0)
        return excess / self.stated if self.stated else math.inf * excess if excess else 0.0


def _value(sums, name, problem):
    amplitude = sums[name]
    return amplitude[0, 0] if isinstance(problem.unknowns[name], fts.Scalar) \
        else fourier_sum(amplitude, PHASES)


def _row(case, name, order, lam, value, size, kind, found, stated, warned=None):
    true = float(np.max(np.abs(found - value)))
    return Row(kind, case.name, name, order, lam, true, float(stated), size, case.accuracy, warned)


def rows(case, orders=ORDERS, arithmetic="exact", some=slice(None)):
    """Series and Padé sums of a case, at a fixed phase, at some of its λ."""
    parameters = case.parameters or {}
    whole = fts.solve(case.problem, max(orders), arithmetic, progress=False)
    for lam in case.points[some]:
        truth = case.truth(lam)
        for order in orders:
            solution = whole.truncate(order)
            for name, value in truth.items():
                size = float(np.max(np.abs(value)))
                row = partial(_row, case, name, order, lam, value, size)
                sums = {name: solution._amplitudes(name, np.asarray(lam),
                                                   tuple(parameters.items()))}
                try:
                    stated = solution.error_estimate(name, lam, **parameters)
                except fts.InputError:
                    yield row("refused", 0 * value, np.inf)
                else:
                    yield row("series", _value(sums, name, case.problem), stated)
                summed = padé(solution, parameters)
                try:
                    with warnings.catch_warnings(record=True) as said:
                        warnings.simplefilter("always")
                        t = (0.0,) * (not isinstance(case.problem.unknowns[name], fts.Scalar))
                        summed.evaluate(name, *t, lam=lam)
                    found = _value({name: summed.amplitudes(name, lam)}, name, case.problem)
                    yield row("Padé", found, summed.error(name, lam), bool(said))
                    if isinstance(case.problem.unknowns[name], fts.Scalar):
                        guess = summed.estimate(lambda s, name=name, lam=lam:
                                                float(s.amplitudes(name, lam)[0, 0]))
                        yield row("estimate", guess.value, guess.error)
                except fts.InputError:
                    yield row("pole", 0 * value, np.inf)


_sums = {}


def padé(solution, parameters):
    key = repr(solution), str(parameters)
    if key not in _sums:
        _sums[key] = solution.resum(**parameters)
    return _sums[key]


def radius_rows(case, orders=RADIUS_ORDERS):
    """The radius of every unknown as a whole."""
    whole = case.up_to(max(orders))
    for order in orders:
        solution = whole.truncate(order)
        for name in case.problem.unknowns:
            try:
                radius = solution.radius_of_convergence(name, **(case.parameters or {}))
            except fts.InputError:
                continue
            yield Row("radius", case.name, name, order, case.radius,
                      abs(radius.value - case.radius), radius.error, case.radius, 2e-6)


def mode_rows(orders=(22, 30, 40, 50, 60, 70, 80, 84, 90, 92, 100)):
    """The radius of single modes of the cubic oscillator, where all have the radius 3."""
    case = cases()[2]
    whole = case.up_to(max(orders))
    for order in orders:
        for n in range(5):
            try:
                radius = whole.truncate(order).radius_of_convergence("x", n)
            except fts.InputError:
                continue
            yield Row("mode", case.name, f"x, n={n}", order, 3, abs(radius.value - 3),
                      radius.error, 3, 0)


def summary(found):
    """A line of the table for each kind of statement."""
    for kind in dict.fromkeys(row.kind for row in found):
        some = [row for row in found if row.kind == kind]
        ratios = [row.ratio for row in some]
        wrong = [row for row in some if row.true > 0.01 * row.size]
        over = [row for row in some if row.stated > 100 * max(row.true, 1e-15 * row.size)]
        yield (kind, len(some), sum(r > 1 for r in ratios), sum(r > 3 for r in ratios),
               f"{max(ratios):.3g}", sum(row.stated == 0 for row in some), len(over),
               sum(row.stated == np.inf for row in some), len(wrong),
               sum(row.warned is False for row in wrong),
               sum(row.warned is True and row.true < 1e-3 * row.size for row in some))


COLUMNS = ("statement", "n", "true > stated", "> 3 stated", "largest ratio", "stated 0",
           "stated > 100 true", "stated ∞", "true > 1 %", "of these silent",
           "warned, true < 0.1 %")


def main():
    found = [row for case in cases() for row in rows(case)]
    found += [row for case in cases() for row in radius_rows(case)] + list(mode_rows())
    print("|" + "|".join(COLUMNS) + "|\n" + "|---" * len(COLUMNS) + "|")
    for line in summary(found):
        print("|" + "|".join(map(str, line)) + "|")
    for row in sorted(found, key=lambda row: -row.ratio)[:40]:
        if row.ratio > 1:
            print(f"{row.kind:9} {row.case:14} {row.unknown:9} order {row.order:3} λ {row.lam:.4g}"
                  f": true {row.true:.2e}, stated {row.stated:.2e}, size {row.size:.2g}")


if __name__ == "__main__":
    main()
