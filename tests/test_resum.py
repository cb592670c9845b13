"""Padé sums of whole solutions against closed forms, beyond the radius of convergence too."""

import warnings

import numpy as np
import pytest
from sample_problems import Duffing

import ftseries as fts
from ftseries.references import cubic, mathieu, newton
from ftseries.resum import at_phase

T = np.linspace(0, 2 * np.pi, 90, endpoint=False)


@pytest.fixture(scope="module")
def oscillator():
    return fts.solve(fts.CubicOscillator(a=1), order=60)


@pytest.fixture(scope="module")
def hill():
    return fts.solve(fts.GeneralizedMathieu(), order=99)


@pytest.fixture(scope="module")
def eight():
    return fts.solve(fts.FigureEight(), order=80)


def test_inside_the_radius_it_is_the_series(oscillator):
    padé = oscillator.resum()
    assert abs(padé.evaluate("x", T, lam=0.5) - cubic.position(T, 0.5)).max() < 1e-14
    assert abs(padé.evaluate("omega", lam=0.5) - cubic.frequency(0.5)) < 1e-14
    assert padé.order == 60 and padé.problem is oscillator.problem


@pytest.mark.parametrize("lam", [2.0, 2.5, 2.8, 2.95])
def test_towards_the_separatrix_the_error_is_covered(oscillator, lam):
    padé = oscillator.resum()
    gap = abs(padé.evaluate("omega", lam=lam) - cubic.frequency(lam))
    plain = abs(oscillator.evaluate("omega", lam=lam) - cubic.frequency(lam))
    assert gap <= padé.error("omega", lam) + 2e-15 and gap < plain / 10 + 2e-15


@pytest.mark.parametrize("lam, mu", [(3, 0), (4, 0), (3, 0.1), (3, -0.1)])
def test_mathieu_beyond_its_radius_against_the_hill_matrix(hill, lam, mu):
    padé = hill.resum(mu=mu)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", fts.ConvergenceWarning)
        assert lam > hill.radius_of_convergence("a", mu=mu).value
        plain = abs(hill.evaluate("a", lam=lam, mu=mu) - mathieu.eigenvalue(lam, mu))
    gap = abs(padé.evaluate("a", lam=lam) - mathieu.eigenvalue(lam, mu))
    assert gap <= padé.error("a", lam) + 1e-14 and gap < 1e-4 < plain


def test_arrays_broadcast_and_agree_with_numbers(hill):
    padé = hill.resum(mu=0)
    lam = np.array([0.5, 1.0, 2.0])
    table = padé.evaluate("psi", T[:, None], lam=lam)
    assert table.shape == (90, 3)
    for j, one in enumerate(lam):
        assert abs(table[:, j] - padé.evaluate("psi", T, lam=one)).max() < 1e-12
    assert padé.error("a", lam).shape == (3,)


def test_zero_of_the_closure_with_its_error(eight):
    """λ_0 of the eight by Padé alone, against the integration of Newton's equations."""
    truth = newton.figure_eight_lambda()
    for order in (30, 50, 70, 80):
        lam = eight.truncate(order).resum().estimate(fts.figure_eight.closure_zero)
        assert abs(lam.value - truth) <= lam.error
    assert lam.error < 1e-8


def test_the_eight_by_pade(eight):
    padé = eight.resum()
    lam = fts.figure_eight.closure_zero(padé)
    gap = abs(fts.figure_eight.positions(padé, T, lam) - newton.figure_eight(T)).max()
    plain = fts.figure_eight.positions(eight, T, fts.figure_eight.closure_zero(eight))
    assert gap < 1e-9 < 1e-6 < abs(plain - newton.figure_eight(T)).max()


def test_defects_are_reported_where_the_coefficients_are_rounded():
    exact = fts.solve(fts.GeneralizedMathieu(mu=0), order=99).resum()
    rounded = fts.solve(fts.GeneralizedMathieu(mu=0), order=99, arithmetic="float").resum()
    assert len(rounded.defects()) > 2 * len(exact.defects())
    assert len(rounded.defects()["a", 0, 0]) > len(exact.defects().get(("a", 0, 0), []))
    # the defects do no harm at a distance
    assert abs(rounded.evaluate("a", lam=3) - exact.evaluate("a", lam=3)) < 1e-5


def test_a_pole_is_refused_and_its_neighbourhood_flagged():
    """ψ_3 of order 5 has the [1/0] sum; a at order 4 is [1/1]: its pole is a number."""
    padé = fts.solve(fts.GeneralizedMathieu(mu=0), order=4).resum()
    step, _, approximant = padé.approximants("a")[0, 0]
    # a = 1 - λ²/2 - λ⁴/32: q = 1 - λ²/16
    assert approximant.poles() == pytest.approx([16])
    with pytest.raises(fts.InputError, match="pole"):
        padé.evaluate("a", lam=4.0)
    with pytest.raises(fts.InputError, match="pole"):
        padé.error("a", 4.0)
    with pytest.raises(fts.InputError, match="pole"):
        padé.evaluate("a", lam=np.array([1.0, 4.0]))
    assert padé.error("a", 4 + 1e-9) > 1e6


def test_bad_input_is_refused(oscillator, hill):
    with pytest.raises(fts.InputError, match="mu"):
        hill.resum()
    with pytest.raises(fts.InputError, match="depends on time"):
        oscillator.resum().evaluate("x", lam=1)
    with pytest.raises(fts.InputError, match="lam"):
        oscillator.resum().evaluate("x", 0.0, lam=np.nan)
    with pytest.raises(fts.InputError, match="not an unknown"):
        oscillator.resum().evaluate("y", 0.0, lam=1)


def test_a_sum_that_is_not_determined_is_announced():
    padé = fts.solve(Duffing(), 40).resum()
    for name, t in (("omega", None), ("x", 0.3)):
        with pytest.warns(fts.ConvergenceWarning, match="is not determined at λ = 100: its error"):
            padé.evaluate(name, t, lam=[0.5, 100.0])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        value = padé.evaluate("omega", lam=3)            # beyond the radius 1.2, and good
    assert type(value) is type(padé.error("omega", 3)) is float
    assert 0 < padé.error("omega", 3) < 1e-4
    with pytest.raises(fts.InputError, match="'y' is not an unknown"):
        padé.error("y", 1)


def test_velocity_beyond_the_radius(hill):
    """ψ″ = (λ² cos 2x - a) ψ, from the equation of Mathieu at q = λ²/2."""
    padé, lam = hill.resum(mu=0), 3.0
    psi, slope, second = (padé.evaluate("psi", T, lam=lam, derivative=k) for k in range(3))
    a = padé.evaluate("a", lam=lam)
    assert np.abs(second - (lam**2 * np.cos(2 * T) - a) * psi).max() < 1e-3 * np.abs(psi).max()
    h = 1e-5
    near = [padé.evaluate("psi", T + s, lam=lam) for s in (h, -h)]
    assert slope == pytest.approx((near[0] - near[1]) / (2 * h), abs=1e-8)   # h² and rounding / h


def test_a_field_at_one_phase():
    """Summed at a small λ, the coefficients give the field and its slope there."""
    sol, lam, tau = fts.solve(fts.CubicOscillator(a=2), order=16), 0.3, 0.7
    omega = sol.evaluate("omega", lam=lam)
    value, slope = (sum(float(c) * lam**m for m, c in enumerate(at_phase(sol, "x", tau, slope=s)))
                    for s in (False, True))
    assert value == pytest.approx(sol.evaluate("x", tau / omega, lam=lam), abs=1e-14)
    near = sol.evaluate("x", (tau + 1e-4 * np.array([-2, -1, 1, 2])) / omega, lam=lam)
    assert slope == pytest.approx(near @ [1, -8, 8, -1] / 12e-4, abs=1e-10)     # rounding / step


@pytest.mark.parametrize("problem, name, tau, message", [
    (fts.GeneralizedMathieu(), "psi", 0.0, "free parameters; give them values"),
    (fts.CubicOscillator(), "omega", 0.0, "'omega' does not depend on the phase"),
    (fts.CubicOscillator(a=1), "y", 0.0, "'y' is not an unknown"),
    (fts.CubicOscillator(a=1), "x", float("nan"), "tau"),
])
def test_a_phase_that_is_refused(problem, name, tau, message):
    with pytest.raises(fts.InputError, match=message):
        at_phase(fts.solve(problem, order=4), name, tau)


def test_what_is_shown(oscillator):
    assert repr(oscillator.resum()) == "<Padé sum of <Solution of CubicOscillator(a=1), " \
        "order 60, exact>>"
    orbit = oscillator.refine(lam=0.5)
    assert repr(orbit).startswith("<Orbit of CubicOscillator(a=1) at λ = 0.5, residual ")


def test_one_mode_has_the_radius_of_the_whole(oscillator):
    """λ = 3a, the separatrix (C9)."""
    radius = oscillator.radius_of_convergence("x", n=1)
    assert abs(radius.value - 3) < 10 * radius.error < 0.3
