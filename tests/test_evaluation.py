"""Evaluation of plain tables: against direct sums, mpmath, and known radii."""

import re
import warnings
from decimal import Decimal
from fractions import Fraction
from math import comb

import mpmath
import numpy as np
import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from sample_problems import Duffing

import ftseries as fts
from ftseries.errors import ConvergenceWarning, InputError, PrecisionWarning
from ftseries.evaluation import (
    amplitudes,
    broadcastable,
    derivative,
    doubt,
    fourier_sum,
    radius_estimate,
)
from ftseries.references import gallery

coefficients = st.floats(-3, 3, allow_subnormal=False)
tables = st.dictionaries(st.sampled_from([(0, 0), (0, 1), (0, 4), (1, 1), (1, 2), (1, 3)]),
                         st.lists(coefficients, min_size=4, max_size=4), max_size=6)


@given(tables, st.floats(-2, 2), st.floats(-10, 10))
def test_both_sums_against_the_definition(table, lam, tau):
    direct = sum(c * lam**m * (np.sin if sine else np.cos)(n * tau)
                 for (sine, n), row in table.items() for m, c in enumerate(row))
    value = fourier_sum(amplitudes(table, lam), tau)
    assert value == pytest.approx(direct, abs=2e-12)        # at most 24 terms of size 3·2³


@given(tables, st.sampled_from([(), (3,), (2, 3)]), st.sampled_from([(), (1,), (3,), (2, 1)]))
def test_shapes_broadcast(table, lam_shape, tau_shape):
    lam = np.linspace(-1, 1, int(np.prod(lam_shape))).reshape(lam_shape)
    tau = np.linspace(0, 5, int(np.prod(tau_shape))).reshape(tau_shape)
    value = fourier_sum(amplitudes(table, lam), tau + 0 * lam)
    assert value.shape == np.broadcast_shapes(lam_shape, tau_shape)
    for index in np.ndindex(value.shape):
        one = fourier_sum(amplitudes(table, np.broadcast_to(lam, value.shape)[index]),
                          np.broadcast_to(tau, value.shape)[index])
        assert value[index] == pytest.approx(one, abs=1e-13)


def test_horner_at_high_order():
    """Σ λ^m = 1/(1 - λ) at λ = 0.9 with 400 terms: the tail is 0.9^400/0.1 = 5e-18."""
    assert amplitudes({(0, 0): [1.0] * 400}, 0.9)[0, 0] == pytest.approx(10, abs=1e-13)


@pytest.mark.parametrize("radius", [0.5, 1.0, 3.0])
@pytest.mark.parametrize("p", [-0.5, 0.5, 1.5])
def test_radius_of_an_algebraic_singularity(radius, p):
    """(1 - λ/R)^p has the radius R; 60 coefficients give it to half a percent."""
    row, c = [], 1.0
    for k in range(60):
        row.append(c)
        c *= -(p - k) / (k + 1) / radius
    assert radius_estimate({(0, 0): row}) == pytest.approx(radius, rel=5e-3)


def test_radius_needs_enough_coefficients():
    assert radius_estimate({}) is None
    assert radius_estimate({(0, 0): [1.0] * 8}) is None
    assert radius_estimate({(0, 0): [1.0] + [0.0] * 50}) is None
    assert radius_estimate({(0, 0): [1.0, 0.0] * 20}) == pytest.approx(1, rel=1e-10)


def test_a_doubt_names_the_radius():
    table = {(0, 0): [comb(2 * k, k) / 4**k for k in range(40)]}          # 1/√(1 - λ)
    assert re.match(r"λ = 2 lies outside .* near 1", doubt(table, "x", 2.0))
    assert doubt(table, "x", np.array([0.5, -0.99])) is None
    assert doubt(table, "x", np.array([])) is None


@pytest.mark.parametrize("step, first", [(1, 0), (2, 0), (2, 1), (3, 0), (4, 2)])
@pytest.mark.parametrize("order", [*range(1, 24)])
def test_terms_that_do_not_fall_are_a_doubt_at_every_order(step, first, order):
    """Σ z^k, z = λ^step, and zeros between: at z = 3 the last term is three times the others."""
    row = [float(m % step == first and m >= first) for m in range(order + 1)]
    found = doubt({(0, 1): row}, "x", 3 ** (1 / step), given=first + 1)
    if order < step + first:
        assert found is None                                # nothing to compare the first term with
    else:
        assert re.search("the last terms of 'x' are not small.*unknown|outside the radius", found)
    assert doubt({(0, 1): row}, "x", 0.3 ** (1 / step), given=first + 1) is None
    assert doubt({(0, 1): row}, "x", 0.0) is None


def test_what_is_no_doubt():
    polynomial = {(0, 0): [1.0, 0.0, 7.0, *[0.0] * 20]}
    assert doubt(polynomial, "x", 50.0) is None             # the series has ended long before
    assert doubt({}, "x", 2.0) is None
    assert doubt({(0, 0): [1.0, 5.0]}, "x", 9.0, given=2) is None           # the seed alone
    assert doubt({(0, 0): [1.0, 5.0]}, "x", 9.0, given=1) is not None


def test_terms_beyond_all_floats():
    assert doubt({(0, 0): [1.0] * 10}, "x", 1e300) is not None


@given(tables, st.floats(-10, 10), st.integers(0, 3))
def test_derivatives_against_the_definition(table, tau, order):
    """cos(nτ + kπ/2) n^k is the derivative of order k of cos nτ."""
    direct = sum(sum(row) * n**order * np.cos(n * tau + (order - sine) * np.pi / 2)
                 for (sine, n), row in table.items())
    assert fourier_sum(derivative(amplitudes(table, 1.0), order), tau) == pytest.approx(
        direct, abs=1e-11)


def test_broadcastable_names_the_shapes():
    arrays = broadcastable(t=[1, 2], lam=0.5)
    assert arrays["t"].shape == (2,) and arrays["lam"].shape == ()
    with pytest.raises(InputError, match=r"t \(2,\), lam \(3,\)"):
        broadcastable(t=[1, 2], lam=[1, 2, 3])


# --- through a solution -------------------------------------------------------------------------

@pytest.fixture(scope="module")
def cubic():
    return fts.solve(fts.CubicOscillator(), 12)


@pytest.fixture(scope="module")
def duffing():
    return fts.solve(Duffing(), 20)


@given(st.floats(-5, 5), st.floats(-1.5, 1.5))
def test_digits_agree_with_floats(cubic, t, lam):
    """15 and 40 digits of the same polynomial; the phase ωt loses a few units at |t| = 5."""
    value = cubic.evaluate("x", t, lam=lam)
    assert value == pytest.approx(float(cubic.evaluate("x", t, lam=lam, dps=40)), abs=5e-14)
    assert float(cubic.evaluate("omega", lam=lam, dps=30)) == pytest.approx(
        cubic.evaluate("omega", lam=lam), abs=5e-15 * 4)


def test_more_digits_refine_fewer(cubic):
    few, many = (cubic.evaluate("x", "0.3", lam="0.5", dps=d) for d in (20, 60))
    with mpmath.workdps(60):
        assert 0 < abs(few - many) < mpmath.mpf("1e-19")


def test_digits_follow_the_definition(cubic):
    """Summed again from the exact coefficients by mpmath, at 50 digits."""
    with mpmath.workdps(60):
        lam, t = mpmath.mpf("0.4"), mpmath.mpf("1.7")
        omega = sum(mpmath.mpmathify(cubic.coefficient("omega", m).evalf(70)) * lam**m
                    for m in range(13))
        x = sum(mpmath.mpmathify(cubic.coefficient("x", n, m).evalf(70)) * lam**m
                * mpmath.cos(n * omega * t) for m in range(13) for n in range(m + 1))
        assert abs(cubic.evaluate("x", t, lam=lam, dps=50) - x) < mpmath.mpf("1e-49")


def test_digits_broadcast(cubic):
    t, lam = np.array([[0.1], [0.2]]), [0.1, 0.2, 0.3]
    many = cubic.evaluate("x", t, lam=lam, dps=20)
    assert many.shape == (2, 3) and isinstance(many[1, 2], mpmath.mpf)
    assert many.astype(float) == pytest.approx(cubic.evaluate("x", t, lam=lam), abs=1e-15)


def test_the_working_precision_of_mpmath_is_left_alone(cubic):
    before = mpmath.mp.dps
    cubic.evaluate("x", 0.1, lam=0.5, dps=77)
    assert mpmath.mp.dps == before


def test_exact_input_is_used_exactly(cubic):
    """A text, a fraction and the float 0.1 mean a tenth, in every library but mpmath."""
    import sympy as sp
    with mpmath.workdps(40):
        values = [cubic.evaluate("omega", lam=lam, dps=40)
                  for lam in ("0.1", sp.Rational(1, 10), 0.1, np.float64(0.1),
                              np.float32(0.1), sp.Float(0.1), Fraction(1, 10), Decimal("0.1"),
                              fmpq(1, 10))]
        assert len(set(values)) == 1
        assert abs(cubic.evaluate("omega", lam=mpmath.mpf("0.1"), dps=40) - values[0]) < 1e-39
        bits = fmpq(*(0.1).as_integer_ratio())                    # the float as a binary number
        binary = cubic.evaluate("omega", lam=bits, dps=40)
        assert abs(binary - values[0]) > mpmath.mpf("1e-20")
        assert cubic.evaluate("omega", lam=mpmath.mpf(0.1), dps=40) == binary


def test_numerical_derivatives_in_lambda_and_mu():
    """mpmath differentiates with tiny binary steps: they have to arrive as they are."""
    solution = fts.solve(fts.GeneralizedMathieu(), 8)
    with mpmath.workdps(40):
        def a(lam, mu=0):
            return solution.evaluate("a", lam=lam, mu=mu, dps=mpmath.mp.dps)

        slope, curve = mpmath.diff(a, 0), mpmath.diff(a, 0, 2)
        by_mu = mpmath.diff(a, (1, 0), (0, 1))
        assert abs(slope) < 1e-25 and abs(curve + 1) < 1e-20           # a = 1 - λ²/2 + …
        exact = sum(solution.coefficient("a", m).diff("mu").subs("mu", 0) for m in range(9))
        assert abs(by_mu - mpmath.mpf(exact.p) / exact.q) < 1e-20


def test_a_scalar_over_an_array(cubic):
    lam = np.linspace(-1, 1, 7)
    values = cubic.evaluate("omega", lam=lam)
    assert values.shape == (7,)
    assert values == pytest.approx(values[::-1], abs=1e-15)                # even in λ
    assert values[3] == pytest.approx(np.sqrt(12), rel=1e-15)


def test_broadcasting_over_t_lambda_and_mu():
    solution = fts.solve(fts.GeneralizedMathieu(), 9)
    x, lam, mu = np.linspace(0, 1, 2), np.linspace(0, 1, 3), np.array([-0.1, 0.2])
    values = solution.evaluate("psi", x[:, None, None], lam=lam[:, None], mu=mu)
    assert values.shape == (2, 3, 2)
    for i, j, k in np.ndindex(values.shape):
        assert values[i, j, k] == solution.evaluate("psi", x[i], lam=lam[j], mu=mu[k])


def test_lambda_zero_gives_the_rest_state(cubic):
    assert cubic.evaluate("x", [0, 1.3], lam=0) == pytest.approx([-1, -1], abs=0)
    assert fts.solve(fts.GeneralizedMathieu(0), 5).evaluate("psi", 0.3, lam=0) == 0


def test_derivatives_in_time(cubic):
    """(C2): x″ = 6x² - 2(3 + λ²), x′² = 4x³ - 4x(3 + λ²) - 8 + 8λ²; order 12 leaves out λ^13."""
    t, lam = np.linspace(0, 3, 40), 0.1
    x, v, a = (cubic.evaluate("x", t, lam=lam, derivative=k) for k in range(3))
    assert v**2 == pytest.approx(4 * x**3 - 4 * x * (3 + lam**2) - 8 + 8 * lam**2, abs=1e-11)
    assert a == pytest.approx(6 * x**2 - 2 * (3 + lam**2), abs=1e-11)
    assert (v[1:20] * (x[1:20] - x[:19]) > 0).sum() > 15               # and the sign
    third = cubic.evaluate("x", t, lam=lam, derivative=3)
    assert third == pytest.approx(12 * x * v, abs=1e-10)
    many = cubic.evaluate("x", t, lam="0.1", derivative=1, dps=25)
    assert many.astype(float) == pytest.approx(v, abs=1e-14)


def test_derivatives_with_a_parameter_and_without_a_frequency():
    """ψ = λ sin x + …: ψ′(0) at first order is λ; arrays of μ go the other way through evaluate."""
    solution = fts.solve(fts.GeneralizedMathieu(), 9)
    slopes = solution.evaluate("psi", 0.0, lam=0.01, mu=[0.0, 0.2], derivative=1)
    assert slopes == pytest.approx([0.01, 0.01], abs=1e-5)
    table = solution.table("psi", mu=0.2)
    assert slopes[1] == pytest.approx(sum(n * c * 0.01**m for (_, n), row in table.items()
                                          for m, c in enumerate(row)), rel=1e-14)


@pytest.mark.parametrize("order, name, t, lam", [
    (2, "omega", None, 5), (4, "omega", None, 5), (20, "omega", None, 5), (4, "x", 0.1, 3)])
@pytest.mark.parametrize("dps", [None, 20])
def test_outside_the_radius_every_order_warns(duffing, order, name, t, lam, dps):
    """The radius is 1.2; ω is 4.4 at λ = 5, and its sum of order 20 is -4e9."""
    cut = duffing.truncate(order)
    with pytest.warns(ConvergenceWarning, match="last terms of .* are not small") as caught:
        cut.evaluate(name, t, lam=lam, dps=dps)
    assert caught[0].filename == __file__


@pytest.mark.parametrize("order", range(1, 21))
def test_inside_the_radius_no_order_warns(duffing, order):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        duffing.truncate(order).evaluate("x", 0.1, lam=[-1.0, 0.5, 1.0])


def test_the_warning_points_at_the_caller_through_arrays_of_parameters():
    solution = fts.solve(fts.GeneralizedMathieu(), 9)
    with pytest.warns(ConvergenceWarning) as caught:
        solution.evaluate("a", lam=9.0, mu=[0.1, 0.2])
    assert caught[0].filename == __file__


@pytest.mark.parametrize("arithmetic, digits", [("float", 15), ("ball", 38)])
def test_digits_that_the_coefficients_do_not_have(arithmetic, digits):
    solution = fts.solve(fts.CubicOscillator(), 4, arithmetic)
    solution.evaluate("x", 0.1, lam=0.5, dps=digits)
    with pytest.warns(PrecisionWarning, match=f"dps={digits + 1}: .* have {digits} digits"):
        solution.evaluate("x", 0.1, lam=0.5, dps=digits + 1)


def test_tables_are_of_plain_floats(cubic):
    assert {type(c) for row in cubic.table("x").values() for c in row} == {float}


def test_one_number_in_one_number_out(cubic):
    assert type(cubic.evaluate("x", 0.3, lam=0.5)) is float
    assert type(cubic.evaluate("omega", lam=0.5)) is float
    assert isinstance(cubic.evaluate("x", 0.3, lam=0.5, dps=30), mpmath.mpf)
    assert cubic.evaluate("x", [0.3], lam=0.5).shape == (1,)
    assert cubic.evaluate("x", [], lam=0.5).shape == (0,)


def test_a_soft_spring_needs_no_floats_beyond_all_bounds():
    """Lengths are measured in a, times in 1/√a; then the coefficient of λ^90 has a^{-89}."""
    a, t = Fraction(1, 10**4), np.linspace(0, 9, 7)
    soft, one = (fts.solve(fts.CubicOscillator(a=a), 90) for a in (a, 1))
    for lam in (0.3, 1.2):
        scaled = float(a) * one.evaluate("x", float(a)**0.5 * t, lam=lam)
        assert soft.evaluate("x", t, lam=lam * float(a)) == pytest.approx(scaled, rel=1e-12)
        assert soft.resum().evaluate("x", t, lam=lam * float(a)) == pytest.approx(scaled, rel=1e-11)
    assert soft.residual(5e-5)["(C3)"] < 1e-12
    assert soft.refine(1e-4).residual < 1e-12
    assert soft.error_estimate("x", 5e-5) == pytest.approx(
        float(a) * one.error_estimate("x", 0.5), rel=1e-6)
    with pytest.raises(InputError, match="beyond the floats"):
        soft.table("x")
    with pytest.warns(ConvergenceWarning, match="λ = 0.0004 lies outside .* near 0.0003"):
        soft.evaluate("x", t, lam=4e-4)


def test_a_unit_beyond_the_floats_is_named():
    """Lengths of the eight are measured in 3^{1/(α+2)}."""
    near, far = (fts.solve(fts.FigureEight(exponent=alpha), 6, arithmetic="float")
                 for alpha in (Fraction(-199, 100), Fraction(-1999, 1000)))
    for ask in (lambda: far.coefficient("r", 2, 2), lambda: far.evaluate("r", 0.3, lam=0.2),
                lambda: far.refine(0.2), lambda: far.resum().evaluate("r", 0.3, lam=0.2)):
        with pytest.raises(InputError, match=r"1.3e\+477, beyond the floats; .*dps"):
            ask()
    with mpmath.workdps(15):
        value = far.evaluate("r", 0.3, lam=0.2, dps=15) / mpmath.mpf(3) ** 1000
        assert value == pytest.approx(near.evaluate("r", 0.3, lam=0.2) / 3.0**100, abs=1e-3)
    assert far.residual(0.2)["(E3a)"] < 1e-6


class Weak(Duffing):
    """x'' + x/10⁴ + x³ = 0: the radius of convergence is 0.012, and the 200th coefficient 10³⁸³."""

    seed = {"x": [{}, {1: 1}], "omega": [Fraction(1, 100)]}

    def equations(self, lam, x, omega):
        return {"(weak)": omega**2 * x.diff(2) + x / 10**4 + x**3}


def test_coefficients_beyond_the_floats_are_refused():
    solution = fts.solve(Weak(), 200)
    with pytest.raises(InputError, match=r"of 'x' leave the floats at order 16\d of λ; truncate"):
        solution.evaluate("x", 0.3, lam=1e-3)
    cut = solution.truncate(150)
    square = sum(float(c) * 0.01**k for k, c in enumerate(gallery.duffing(10)))    # λ/ω₀ = 0.1
    assert cut.evaluate("omega", lam=1e-3) == pytest.approx(0.01 * square**0.5, rel=1e-14)


@pytest.mark.filterwarnings("ignore:(overflow|invalid value) encountered:RuntimeWarning")
def test_a_float_solution_that_leaves_the_floats_says_so():
    with pytest.raises(fts.SolveError, match="leave the floats at order 16. of λ; stay below"):
        fts.solve(Weak(), 200, arithmetic="float")
