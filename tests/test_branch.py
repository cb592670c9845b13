"""Branch points from the equations themselves, against tables and against Taylor coefficients."""

import numpy as np
import pytest

import ftseries as fts
from ftseries.branch import branch_point
from ftseries.references import mathieu


def upper(z):
    return complex(z.real, abs(z.imag))


@pytest.mark.parametrize("branch, radius", [("b1", 3.7699574940), ("b3", 3.7699574940),
                                            ("a1", 3.7699574940), ("a0", 1.4687686138),
                                            ("a2", 1.4687686138)])
def test_mathieu_against_the_dlmf(branch, radius):
    """Table 28.6.1 of the DLMF, ten decimals; for a_0 and a_2 the series goes in λ⁴."""
    sol = fts.solve(fts.GeneralizedMathieu(mu=0, branch=branch), order=60)
    step, found = sol.sequence("a")[0], sol.branch_point("a")
    assert abs(abs(found.location) ** (2 / step) / 2 - radius) < 1e-10 + found.error


@pytest.mark.parametrize("mu", [-0.3, 0.1, 0.3])
def test_two_eigenvalues_of_the_hill_matrix_meet_there(mu):
    sol = fts.solve(fts.GeneralizedMathieu(), order=60)
    z = sol.branch_point("a", mu=mu).location
    a = np.linalg.eigvals(mathieu.hill_matrix(np.sqrt(z), mu, 30))
    gaps = np.abs(a[:, None] - a)[np.triu_indices(30, 1)]
    assert gaps.min() < 1e-4                      # a square root: 1e-9 in z gives 3e-5 in a
    away = np.linalg.eigvals(mathieu.hill_matrix(np.sqrt(z * 1.01), mu, 30))
    assert np.abs(away[:, None] - away)[np.triu_indices(30, 1)].min() > 100 * gaps.min()


def test_the_eight_against_its_taylor_coefficients():
    """Two ways to the same place: 400 coefficients, and Newton's method on the equations."""
    sharp = fts.solve(fts.FigureEight(), order=60).branch_point("r")
    long = fts.solve(fts.FigureEight(), order=400, arithmetic="float")
    for name, n in (("r", 0), ("r", 2), ("r", 4), ("phi", 3), ("phi", 5)):
        near = long.singularities(name, n)[0]
        assert abs(upper(near.location) - sharp.location) <= near.error + sharp.error
        assert abs(near.exponent - sharp.exponent) <= near.exponent_error < 1e-2
        assert near.error < 1e-4
    for order in (60, 80, 100):
        radius = fts.solve(fts.FigureEight(), order=order).radius_of_convergence("r")
        assert abs(radius.value - abs(sharp.location) ** 0.5) <= radius.error
    assert sharp.error < 1e-8


def test_the_logarithm_of_the_oscillator_is_no_branch_point_of_this_kind():
    sol = fts.solve(fts.CubicOscillator(a=1), order=40)
    with pytest.raises(fts.SolveError, match="another kind"):
        sol.branch_point("x", 1)


def test_too_few_coefficients():
    with pytest.raises(fts.InputError, match="too few"):
        fts.solve(fts.FigureEight(), order=10).branch_point("r")


def test_a_guess_that_is_no_solution_is_refused():
    """Newton's method overflows; nothing is said of where it ended."""
    guess = {"psi": {(1, 3): 1e200}, "a": {(0, 0): 1e200}}
    with np.errstate(all="ignore"), pytest.raises(fts.SolveError, match="no two solutions meet"):
        branch_point(fts.GeneralizedMathieu(mu=0), guess, guess, 1 + 1j)
