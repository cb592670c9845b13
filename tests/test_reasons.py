"""What refusals say about the motions near rest."""

import numpy as np
import pytest

import ftseries as fts
from ftseries.reasons import rates

SEED = {"x": "lam*cos(omega*t)", "omega": 1}


def problem(equation, parameters=()):
    return fts.Equations(equation, {"x": fts.Field("cos"), "omega": fts.Scalar()}, SEED, "omega",
                         parameters)


@pytest.mark.parametrize("equation, state, roots", [
    ("x'' + 2*x + x**3 = 0", 0, [2**0.5 * 1j, -2**0.5 * 1j]),
    ("x'' - x + x**3 = lam*x", 1, [2**0.5 * 1j, -2**0.5 * 1j]),
    ("x'' + 3*x' + 2*sin(x) = 0", 0, [-1, -2]),
    ("x'' = x'*x + x'", 0, [0, 1]),
])
def test_the_rates_are_the_eigenvalues_of_the_linear_part(equation, state, roots):
    found = rates(problem(equation), {"x": state})
    assert np.sort_complex(found) == pytest.approx(np.sort_complex(roots), abs=1e-12)


def test_two_fields_against_numpy():
    pair = fts.Equations(["x' = 2*y - x", "y' = x**2 - 3*y - x"], {
        "x": fts.Field("both"), "y": fts.Field("both"), "omega": fts.Scalar()},
        SEED | {"y": "lam*sin(omega*t)"}, "omega")
    expected = np.linalg.eigvals([[-1, 2], [2 * 3 - 1, -3]])
    assert np.sort(np.real(rates(pair, {"x": 3, "y": 2}))) == pytest.approx(np.sort(expected))


def test_a_parameter_counts_1():
    assert np.sort_complex(rates(problem("x'' + mu*x", ("mu",)), {"x": 0})) == pytest.approx(
        [-1j, 1j])


@pytest.mark.parametrize("equation", ["x'' + x + x(t - pi/omega) = 0", "x'**2 + x**2 = lam**2"])
def test_where_there_is_no_polynomial_there_are_no_rates(equation):
    assert rates(problem(equation), {"x": 0}) is None
