"""The cubic oscillator of section 2: printed equations, closed forms, exact to order 40."""

import mpmath
import numpy as np
import pytest
import sympy as sp

import ftseries as fts
from ftseries.references import cubic, cubic_taylor

a = sp.Symbol("a", positive=True)
EPS = np.finfo(float).eps


@pytest.fixture(scope="module")
def order_40():
    return fts.solve(fts.CubicOscillator(), 40)


@pytest.mark.parametrize("n", range(42))
def test_every_coefficient_to_order_40_is_that_of_the_closed_form(order_40, n):
    exact = cubic_taylor.fourier_taylor(n, 40)
    assert [order_40.coefficient("x", n, m) for m in range(41)] == exact


def test_every_frequency_coefficient_to_order_40(order_40):
    assert [order_40.coefficient("omega", m) for m in range(41)] == (
        cubic_taylor.frequency_taylor(40))


@pytest.mark.parametrize("scale", [a, sp.Rational(2, 3), 3, sp.sqrt(2)])
def test_coefficients_for_other_a(scale):
    solution = fts.solve(fts.CubicOscillator(scale), 8)
    for n in range(9):
        expected = cubic_taylor.fourier_taylor(n, 8, scale)
        assert all(sp.simplify(solution.coefficient("x", n, m) - expected[m]) == 0
                   for m in range(9))
    expected = cubic_taylor.frequency_taylor(8, scale)
    assert all(sp.simplify(solution.coefficient("omega", m) - expected[m]) == 0 for m in range(9))


def test_C7_as_printed():
    solution = fts.solve(fts.CubicOscillator(a), 3)
    printed = {(0, 0): -a, (0, 2): 1 / (12 * a), (1, 1): 1, (1, 3): -1 / (192 * a**2),
               (2, 2): -1 / (12 * a)}                                        # (C7a)
    for n in range(3):
        for m in range(4):
            assert sp.simplify(solution.coefficient("x", n, m) - printed.get((n, m), 0)) == 0
    omega = [2 * sp.sqrt(3 * a), 0, -1 / (8 * sp.sqrt(3) * a ** sp.Rational(3, 2)), 0]    # (C7b)
    assert all(sp.simplify(solution.coefficient("omega", m) - omega[m]) == 0 for m in range(4))


def test_C6_chooses_the_seed():
    """The three equations at order 2, solved by SymPy: the seed is one of the solutions."""
    A01, A11, w = sp.symbols("A01 A11 w")
    equations = [12 * (2 * A01**2 + A11**2 - 2) + A11**2 * w**2, A01 * A11, A11 * (w**2 - 12)]
    solutions = sp.solve(equations, [A01, A11, w])
    assert (0, 1, 2 * sp.sqrt(3)) in solutions and len(solutions) > 1
    solution = fts.solve(fts.CubicOscillator(), 1)
    assert (solution.coefficient("x", 0, 1), solution.coefficient("x", 1, 1),
            solution.coefficient("omega", 0)) == (0, 1, 2 * sp.sqrt(3))


def test_parity_of_n_and_m_agrees(order_40):
    """The paper's remark: powers of λ increase in steps of two."""
    assert all((n - m) % 2 == 0 and not sine for m, row in enumerate(order_40.coefficients["x"])
               for sine, n in row)
    assert not any(order_40.coefficients["omega"][1::2])


def test_C8_printed_frequency_and_period():
    """In double precision, within two units of the last place."""
    solution = fts.solve(fts.CubicOscillator(), 24)
    omega = solution.evaluate("omega", lam=0.5)
    assert abs(omega - 3.4458763864722597) <= 4 * EPS * 2
    assert abs(2 * np.pi / omega - 1.8233925429960192) <= 2 * EPS * 2


def test_the_error_of_order_24_lies_far_below_double_precision():
    """The first left-out term is of order (1/6)^26 ≈ 1e-20 at λ = a/2, radius 3a."""
    solution = fts.solve(fts.CubicOscillator(), 24)
    with mpmath.workdps(40):
        exact = cubic.frequency("0.5", dps=40)
        error = abs(solution.evaluate("omega", lam="0.5", dps=40) - exact)
        assert mpmath.mpf("1e-26") < error < mpmath.mpf("1e-20")
        t = mpmath.mpf("0.7")
        error = abs(solution.evaluate("x", t, lam="0.5", dps=40)
                    - cubic.position(t, "0.5", dps=40))
        assert mpmath.mpf("1e-26") < error < mpmath.mpf("1e-18")


@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
def test_order_24_against_the_weierstrass_function(arithmetic):
    t = np.linspace(0, 4, 50)
    solution = fts.solve(fts.CubicOscillator(), 24, arithmetic)
    # figure 3: double precision is what limits it
    assert np.abs(solution.evaluate("x", t, lam=0.5) - cubic.position(t, 0.5)).max() < 5e-15


@pytest.mark.parametrize("lam", [0.5, 1.5, -1.0])
def test_turning_points(order_40, lam):
    """x(0) = -a + λ, x(T/2) = -a - λ; order 40 leaves (|λ|/3)^41."""
    half = np.pi / order_40.evaluate("omega", lam=lam)
    tolerance = 20 * (abs(lam) / 3) ** 41 + 1e-14
    assert order_40.evaluate("x", 0, lam=lam) == pytest.approx(-1 + lam, abs=tolerance)
    assert order_40.evaluate("x", half, lam=lam) == pytest.approx(-1 - lam, abs=tolerance)
