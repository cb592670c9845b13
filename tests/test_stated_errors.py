"""Stated errors against true ones; the whole table: make stated-errors."""

import numpy as np
import pytest
from flint import fmpq
from sample_problems import Duffing, Pendulum, VanDerPol
from stated_errors import cases, mode_rows, radius_rows, rows

import ftseries as fts
from ftseries.analysis import pade

#: of so many statements, one may be below the true error by more than a factor of 3: the whole
#: table has 8 of 1881 sums, the largest ratio 5.4
FEW, LARGEST = 50, 6


@pytest.mark.parametrize("case", cases(), ids=lambda case: case.name)
def test_true_errors_are_about_those_stated(case):
    found = list(rows(case, (1, 2, 3, 4, 8, 9, 16, 30), "exact", slice(None, None, 3)))
    ratios = np.array([row.ratio for row in found])
    assert all(row.stated > 2.0**-54 * row.size for row in found)
    assert ratios.max() < LARGEST and (ratios > 3).sum() <= max(1, len(found) // FEW)
    wrong = [row for row in found if row.warned is not None and row.true > 0.02 * row.size]
    assert all(row.warned for row in wrong)


def test_radii():
    found = [row for case in cases()[:3] for row in radius_rows(case, (18, 22, 40, 60))]
    found += mode_rows((22, 60))
    assert len(found) > 20 and max(row.ratio for row in found) <= 3.1
    pendulum = next(row for row in found if (row.unknown, row.order) == ("x", 22))
    assert pendulum.stated > 0.1                     # one mode has a pole at 8/√3, 10⁻¹⁵ sharp


def test_a_singular_block_of_the_pendulum():
    """c_4 of ω is matched at orders 8 and 9, where [2/2] does not exist."""
    for order in (8, 9):
        padé = fts.solve(Pendulum(), order).resum()
        approximant = padé.approximants("omega")[0, 0][2]
        p, q = (np.array([float(x) for x in part]) for part in approximant.exact)
        _, _, c = padé.solution.sequence("omega")
        taylor = np.convolve(q, [int(x.p) / int(x.q) for x in c])[:5]
        assert taylor == pytest.approx(np.append(p, np.zeros(5))[:5], abs=1e-15)
        assert padé.error("omega", 3.9) > abs(padé.evaluate("omega", lam=3.9) - 0.1438597061) / 3


@pytest.mark.parametrize("problem, order", [(Duffing(), 1), (VanDerPol(), 1), (VanDerPol(), 3)])
def test_of_one_term_nothing_is_known(problem, order):
    padé = fts.solve(problem, order).resum()
    assert padé.error("omega", 0.5) == np.inf
    assert padé.estimate(lambda s: s.evaluate("omega", lam=0.5)).error == np.inf


def test_zeros_of_a_table_in_a_block_are_matched():
    """1 + z⁴: [2/2] does not exist."""
    approximant = pade([fmpq(1), 0, 0, 0, fmpq(1)])
    assert approximant(0.5) == pytest.approx(1 + 0.5**4, abs=1e-15)


def test_balls_propagate_into_sums_and_radii():
    exact = fts.solve(fts.CubicOscillator(1), 60)
    balls = fts.solve(fts.CubicOscillator(1), 60, "ball", precision=53)
    truth = exact.resum().evaluate("omega", lam=2.7)
    with pytest.warns(fts.PrecisionWarning, match="have no digits"):
        padé = balls.resum()
        value = padé.evaluate("omega", lam=2.7)
    assert abs(value - truth) < 3 * padé.error("omega", 2.7)
    assert abs(balls.radius_of_convergence("omega").value - 3) < \
        balls.radius_of_convergence("omega").error
    assert balls.error_estimate("omega", 2.7) > sum(
        float(row[0, 0].rad()) * 2.7**m for m, row in enumerate(balls.coefficients["omega"]) if row)
    poor = fts.solve(fts.CubicOscillator(1), 60, "ball", precision=24)
    with pytest.raises(fts.InputError, match="have digits; solve with a larger precision"):
        poor.radius_of_convergence("omega")


def test_a_late_phase_is_in_the_error():
    padé = fts.solve(Duffing(), 20).resum()
    fixed, late = padé.error("x", 1.0), padé.error("x", 1.0, t=1e6)
    assert late == pytest.approx(fixed + 1e6 * padé.error("omega", 1.0) * 1.1, rel=0.1)
    with pytest.warns(fts.ConvergenceWarning, match="not determined"):
        padé.evaluate("x", 1e9, lam=1.0)
