"""Is `evaluate` ever wrong in silence, and how often does it warn in vain?  As a table.

`make calibration` makes the whole one; this is the part of it that takes seconds.
"""

import calibration
import numpy as np
import pytest

from ftseries.references import cubic, mathieu

ORDERS, SHARES, LATE = (1, 2, 3, 4, 6, 8, 12, 20, 40), (.3, .5, .7, .85, .95, 1.05, 1.3, 1.7), (
    0, 10**4)
CASES = {case.name: case for case in calibration.cases()}


@pytest.fixture(scope="module")
def found():
    """Of the van der Pol oscillator and the figure eight, few λ: their truths take a while."""
    few = {"van der Pol": (.5, .85, 1.3), "figure eight": (.5, .85, 1.05)}
    return [row for name, case in CASES.items()
            for row in calibration.rows(case, ORDERS, few.get(name, SHARES), LATE)]


def test_the_table(found):
    """At most one wrong value in 200 is silent, and then by less than 2 %; few warnings in vain."""
    for late in LATE:
        some = [row for row in found if row.late == late]
        _, _, wrong, silent, _, good, vain, best, worst = calibration.summary(some, late, "all")
        assert wrong > 150 and (good > 80 and best > 60 if not late else good > 20 and best > 10)
        assert silent <= wrong / 200 and vain <= 0.08 * good and worst <= 0.01 * best
    assert all(row.error < 0.02 for row in found if row.error > 0.01 and not row.warned)


def test_every_problem_warns_outside_and_is_silent_inside(found):
    for name in CASES:
        rows = [row for row in found if row.case == name and row.late == 0]
        assert any(not row.warned for row in rows)
        assert all(row.warned for row in rows if row.order == 1 or row.share > 1.2)


def test_the_truths_are_true():
    """Two ways to the same motion: elliptic functions and Newton's method; SciPy and a matrix."""
    for name in ("Duffing", "pendulum", "cubic", "van der Pol"):
        case = CASES[name]
        orbit = case.solution.refine(lam := 0.5 * case.radius)
        omega, values = case.truth(lam)
        for unknown, truth in values.items():
            t = [calibration.PHASES / omega] if np.ndim(truth) else []
            assert orbit.evaluate(unknown, *t) == pytest.approx(truth, abs=2e-11)
    assert mathieu.eigenvalue(1.5) == pytest.approx(mathieu.mathieu_b(1.5), rel=1e-13)
    assert CASES["cubic"].truth(1.0)[0] == pytest.approx(
        2 * np.pi / cubic.period_by_quadrature(1.0), rel=1e-12)
