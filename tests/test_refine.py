"""Newton's method from a truncated series, against closed forms and integration."""

import math
import warnings

import numpy as np
import pytest
from sample_problems import Duffing

import ftseries as fts
from ftseries.references import cubic, mathieu, newton

T = np.linspace(-3, 9, 200)


@pytest.fixture(scope="module")
def eight():
    return fts.solve(fts.FigureEight(), order=6)


def test_the_eight_from_order_six(eight):
    orbit = eight.refine()
    assert abs(orbit.lam - newton.figure_eight_lambda()) < 4e-15
    gap = fts.figure_eight.positions(orbit, T, orbit.lam) - newton.figure_eight(T)
    assert np.abs(gap).max() < 5e-14                    # the reference itself is good to 1e-14
    assert orbit.residual < 1e-12 and orbit.steps < 20
    assert abs(fts.figure_eight.closure(orbit, orbit.lam)) < 1e-13


@pytest.mark.parametrize("order", [2, 4, 12, 30])
def test_the_first_guess_does_not_change_the_eight(order):
    orbit = fts.solve(fts.FigureEight(), order=order).refine()
    assert abs(orbit.lam - newton.figure_eight_lambda()) < 4e-15


def test_a_refined_series_is_the_series_where_that_is_accurate(eight):
    orbit, exact = eight.refine(0.8), fts.solve(fts.FigureEight(), order=40)
    for name in ("r", "phi"):
        gap = orbit.evaluate(name, T) - exact.evaluate(name, T, lam=0.8)
        assert np.abs(gap).max() < 2e-14
    assert orbit.coefficients["phi"][0, 1] == 0.8         # λ keeps its meaning


@pytest.mark.parametrize("a", [1, 2])
@pytest.mark.parametrize("lam", [0.0, 0.5, 1.0, 2.0, 2.5, -1.0])
def test_oscillator_against_jacobi_functions(lam, a):
    orbit = fts.solve(fts.CubicOscillator(a=a), order=12).refine(lam * a)
    assert abs(orbit.evaluate("omega") - cubic.frequency(lam * a, a)) < 3e-13
    assert np.abs(orbit.evaluate("x", T) - cubic.position(T, lam * a, a)).max() < 3e-12


def test_oscillator_close_to_the_separatrix():
    """At λ = 2.99 the nome is 0.26 and the period 2.8 times longer: more modes are taken."""
    orbit = fts.solve(fts.CubicOscillator(a=1), order=12).refine(2.99)
    assert abs(orbit.evaluate("omega") - cubic.frequency(2.99)) < 1e-11
    assert max(n for _, n in orbit.coefficients["x"]) > 24


@pytest.mark.parametrize("lam, mu", [(2, -0.3), (1, 0.2), (2.5, 0)])
def test_mathieu_against_the_hill_matrix(lam, mu):
    orbit = fts.solve(fts.GeneralizedMathieu(), order=12).refine(lam, mu=mu)
    assert abs(orbit.evaluate("a") - mathieu.eigenvalue(lam, mu)) < 1e-13
    gap = orbit.evaluate("psi", T) - mathieu.eigenfunction(T, lam, mu)
    assert np.abs(gap).max() < 1e-12


@pytest.mark.parametrize("branch", ["a0", "a1", "a2", "b2", "a5", "b7"])
def test_other_branches_against_scipy(branch):
    from scipy.special import mathieu_a, mathieu_b
    lam, n = 1.5, int(branch[1:])
    orbit = fts.solve(fts.GeneralizedMathieu(mu=0, branch=branch), order=14).refine(lam)
    truth = (mathieu_a if branch[0] == "a" else mathieu_b)(n, lam**2 / 2)
    assert abs(orbit.evaluate("a") - truth) < 1e-12 * max(1, abs(truth))


OSCILLATOR = {"unknowns": {"x": fts.Field("cos", fixed=(1,)), "omega": fts.Scalar()},
              "frequency": "omega"}


def test_beyond_the_radius_the_family_is_followed():
    """λ = 4 lies beyond the radius 2.746: straight from there, Newton's method finds another."""
    sol = fts.solve(fts.GeneralizedMathieu(mu=0), order=12)
    assert abs(sol._orbit({}, 4.0).refine(lam=4).evaluate("a") - mathieu.eigenvalue(4)) > 1
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert abs(sol.refine(4).evaluate("a") - mathieu.eigenvalue(4)) < 1e-11
        assert abs(sol.refine(2).evaluate("a") - mathieu.eigenvalue(2)) < 1e-12
        for lam in (6, 20):                             # on the way a passes through 0
            assert sol.refine(lam).evaluate("a") == pytest.approx(mathieu.eigenvalue(lam), 1e-12)


@pytest.mark.parametrize("equation, order, lam, omega", [
    ("x'' + x + x**3", 4, 3.6464, 3.3785177535),            # Jacobi's cn; it was -3.3785
    ("x'' + (2/3)*x - (2/5)*x**5 - x**4 + lam*x", 8, 0.8162, 1.0673914),     # in steps of 0.02
])
def test_no_other_branch_is_reached_in_silence(equation, order, lam, omega):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        orbit = fts.solve(fts.Equations(equation, **OSCILLATOR), order).refine(lam)
    assert orbit.evaluate("omega") == pytest.approx(omega, abs=1e-7)


def test_an_unknown_that_is_zero():
    problem = fts.Equations(
        ["x'' + x + x**3/4 + x*y**2", "y'' + 5*y + y**3"], frequency="omega",
        unknowns={"x": fts.Field("cos", fixed=(1,)), "y": fts.Field("cos"), "omega": fts.Scalar()})
    orbit = fts.solve(problem, 6).refine(0.1)
    alone = fts.solve(fts.Equations("x'' + x + x**3/4", **OSCILLATOR), 6).refine(0.1)
    assert np.abs(orbit.evaluate("y", T)).max() < 1e-15
    assert orbit.evaluate("omega") == pytest.approx(alone.evaluate("omega"), abs=1e-15)
    assert orbit.refine(lam=0.2).evaluate("y", 0.3, derivative=1) == 0


@pytest.mark.parametrize("call, error, word", [
    (lambda e: e.refine(3.5), fts.SolveError, "followed to λ = "),
    (lambda e: e.refine(math.nan), fts.InputError, "lam"),
    (lambda e: e.refine("two"), fts.InputError, "lam"),
    (lambda e: e.refine(1, mu=0), fts.InputError, "no parameters"),
    (lambda e: fts.solve(fts.CubicOscillator(a=1), order=6).refine(), fts.InputError, "give lam"),
    (lambda e: fts.solve(fts.CubicOscillator(a=1), order=6).refine(3.1), fts.SolveError, "λ = 3.1"),
    (lambda e: fts.solve(fts.GeneralizedMathieu(), order=6).refine(1), fts.InputError, "mu"),
    (lambda e: e.truncate(0).refine(), fts.FTSeriesError, "S_x has no zero"),
])
def test_what_cannot_be_refined_is_refused(eight, call, error, word):
    with pytest.raises(error, match=word):
        call(eight)


def test_what_is_no_orbit_is_refused_and_rest_is_one():
    """At λ = 10⁶ the series is nonsense; the end of Newton's method must not be called an orbit."""
    sol = fts.solve(Duffing(), 20)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for order in (4, 10, 20):
            with pytest.raises(fts.SolveError, match=r"at λ = 1e\+06"):
                sol.truncate(order).refine(1e6)
        rest = sol.refine(0)
    assert rest.evaluate("omega") == 1 and rest.evaluate("x", 0.3) == 0


@pytest.mark.parametrize("exponent", ["-1/2", "5/2"])
def test_the_first_few_modes_may_leave_a_rest(exponent):
    """With 24 modes F is not small here; with as many as are needed it is rounding."""
    orbit = fts.solve(fts.FigureEight(exponent), order=40, arithmetic="float").refine()
    assert orbit.residual < 1e-9 and max(n for _, n in orbit.coefficients["r"]) > 24


def test_velocity_of_an_orbit():
    """(C2): x″ = 6x² - 2(3 + λ²) and x′² = 4x³ - 4x(3 + λ²) - 8 + 8λ² at a = 1."""
    orbit, lam = fts.solve(fts.CubicOscillator(a=1), order=12).refine(2.5), 2.5
    x, v, a = (orbit.evaluate("x", T, derivative=k) for k in range(3))
    assert np.abs(v**2 - (4 * x**3 - 4 * x * (3 + lam**2) - 8 + 8 * lam**2)).max() < 1e-10
    assert np.abs(a - (6 * x**2 - 2 * (3 + lam**2))).max() < 1e-10
    assert type(orbit.evaluate("x", 0.1)) is type(orbit.evaluate("omega")) is float
    assert type(orbit.coefficients["x"][0, 1]) is float
    with pytest.raises(fts.InputError, match="'y' is not an unknown"):
        orbit.evaluate("y", 0.1)


def test_a_family_is_followed_from_force_to_force(eight):
    """There and back: the orbit of gravitation again."""
    orbit = first = eight.refine()
    for exponent in ("1/2", 0, "1/2", 1):
        orbit = orbit.refine(fts.FigureEight(exponent))
        assert orbit.residual < 1e-11
    assert orbit.lam == pytest.approx(first.lam, abs=1e-13)
    gap = fts.figure_eight.positions(orbit, T, orbit.lam) - newton.figure_eight(T)
    assert np.abs(gap).max() < 5e-13


def test_a_family_is_followed_in_lambda(eight):
    """S_x along the family, against the series where that converges."""
    series, orbit = fts.solve(fts.FigureEight(), order=60, arithmetic="float"), eight.refine(0.5)
    for lam in (0.8, 1.1, 1.4):
        orbit = orbit.refine(lam=lam)
        assert orbit.lam == lam
        expected = fts.figure_eight.closure(series, lam)
        assert fts.figure_eight.closure(orbit, lam) == pytest.approx(expected, abs=1e-10)


def test_only_problems_with_the_same_unknowns_are_followed(eight):
    with pytest.raises(fts.InputError, match="has the unknowns x, omega, but this is an orbit"):
        eight.refine().refine(fts.CubicOscillator(a=1))


def test_an_orbit_has_only_its_own_lambda(eight):
    orbit = eight.refine()
    assert orbit.evaluate("r", 0.3, lam=orbit.lam) == orbit.evaluate("r", 0.3)
    with pytest.raises(fts.InputError, match="lam=2.0: this orbit has λ = 2.0756"):
        orbit.evaluate("r", 0.3, lam=2.0)
