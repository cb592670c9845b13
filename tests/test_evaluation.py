"""Evaluation of plain tables: against direct sums, mpmath, and known radii."""

import warnings
from decimal import Decimal
from fractions import Fraction
from functools import lru_cache

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
    fourier_sum,
    radius_estimate,
    turned,
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


@given(tables, st.floats(-10, 10), st.integers(0, 3))
def test_derivatives_against_the_definition(table, tau, order):
    """cos(nτ + kπ/2) n^k is the derivative of order k of cos nτ."""
    direct = sum(sum(row) * n**order * np.cos(n * tau + (order - sine) * np.pi / 2)
                 for (sine, n), row in table.items())
    assert fourier_sum(derivative(amplitudes(table, 1.0), order), tau) == pytest.approx(
        direct, abs=1e-11)


@given(st.floats(-3, 3), st.floats(-1e20, 1e20))
def test_whole_turns_are_taken_off_exactly(nu, t):
    """Against rationals: 2⁻¹⁰⁰ of 3e20 turns, and the rounding of the difference."""
    rest = nu * 2.0**-54
    exact = (Fraction(nu) + Fraction(rest)) * Fraction(t)
    found = turned(nu, rest, np.array(t)) / (2 * np.pi)
    assert float(exact - round(exact) - Fraction(float(found))) % 1 in (
        pytest.approx(0, abs=1e-9), pytest.approx(1, abs=1e-9))


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
    (1, "omega", None, 5), (2, "omega", None, 5), (4, "omega", None, 5), (20, "omega", None, 5),
    (1, "x", 0.1, 3), (4, "x", 0.1, 3), (4, "x", 0.1, [0.1, -3])])
@pytest.mark.parametrize("dps", [None, 20])
def test_outside_the_radius_every_order_warns(duffing, order, name, t, lam, dps):
    """The radius is 1.2; ω is 4.4 at λ = 5, and its sum of order 20 is -4e9."""
    cut = duffing.truncate(order)
    with pytest.warns(ConvergenceWarning, match="do not fall|only the first|may change") as caught:
        cut.evaluate(name, t, lam=lam, dps=dps)
    assert len(caught) == 1 and caught[0].filename == __file__


def silent(solution, *asked, **values):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return solution.evaluate(*asked, **values)


@pytest.mark.parametrize("order", range(3, 21))
def test_inside_the_radius_no_order_warns(duffing, order):
    """At λ = 0.2, a sixth of the radius, from the second term on, and at t = 0.1."""
    silent(duffing.truncate(order), "x", 0.1, lam=[-0.2, 0.1])
    silent(duffing, "x", 0.1, lam=[-1.0, 0.5, 1.0])


# --- at late times ------------------------------------------------------------------------------

@pytest.mark.parametrize("order", [6, 10, 20])
def test_the_error_of_the_frequency_is_multiplied_by_time(duffing, order):
    """Silent as long as t times the true error of ω is below a hundredth, at λ = 0.5: never later.

    The reference has 50 more orders, of which the first alone is below 10⁻¹⁰.
    """
    long, cut = fts.solve(Duffing(), 50), duffing.truncate(order)
    error = abs(cut.evaluate("omega", lam=0.5) - long.evaluate("omega", lam=0.5))
    silent(cut, "x", 0.01 / error / 1000, lam=0.5)
    for t in (0.01 / error, [0, -1 / error]):
        with pytest.warns(ConvergenceWarning, match="λ = 0.5 and the phase ωt = .* of 'omega'"):
            cut.evaluate("x", t, lam=0.5)


@pytest.mark.parametrize("t", [1e5, -1e9, 1e12, 1e15, 1e17])
def test_late_times_keep_their_digits(cubic, t):
    """The phase of exact coefficients is reduced with twice the digits; t is exact."""
    lam = [0.01, 0.02]
    value = silent(cubic, "x", t, lam=lam, derivative=1)
    with mpmath.workdps(60):
        omega = [sum(mpmath.mpmathify(cubic.coefficient("omega", m).evalf(60)) * mpmath.mpf(z)**m
                     for m in range(13)) for z in lam]
        exact = [-sum(cubic.coefficient("x", n, m).evalf(40) * mpmath.mpf(z)**m * n * w
                      * mpmath.sin(n * w * t) for m in range(13) for n in range(m + 1))
                 for z, w in zip(lam, omega)]
    assert value == pytest.approx(np.array(exact, dtype=float), abs=1e-14 * 0.07)
    bits = [mpmath.mpf(z) for z in lam]
    assert cubic.evaluate("x", t, lam=bits, derivative=1, dps=30).astype(float) == pytest.approx(
        value, abs=1e-14 * 0.07)


def test_late_times_without_a_frequency():
    """sin x at x = 10⁹: the phase is x itself."""
    mathieu = fts.solve(fts.GeneralizedMathieu(0), 9)
    assert silent(mathieu, "psi", [1e9, 1e12], lam=1e-5) == pytest.approx(
        1e-5 * np.sin([1e9, 1e12]), rel=1e-9)


def test_floats_lose_the_phase():
    """Their ω is good to 2⁻⁵³ or so; exact coefficients lose nothing until 10²² radians."""
    floats, exact = (fts.solve(fts.CubicOscillator(), 24, kind) for kind in ("float", "exact"))
    silent(floats, "x", 1e5, lam=0.1)
    for t, kept in ((1e9, 6), (1e15, 0)):
        with pytest.warns(PrecisionWarning, match=f"leaves {kept} digits of 'x'"):
            value = floats.evaluate("x", t, lam=0.5)
        assert t > 1e10 or value == pytest.approx(exact.evaluate("x", t, lam=0.5), abs=1e-6)
    with pytest.warns(PrecisionWarning, match="digits of 'x'"):
        exact.evaluate("x", 1e30, lam=1e-4)


def test_late_and_far_are_not_mixed(duffing):
    """t = 10⁶ at λ = 0.01 and t = 0 at λ = 1 are each good: no pair of them is late and far."""
    silent(duffing, "x", [1e6, 0.0], lam=[0.01, 1.0])
    for t, lam in (([1e6, 0.0], [[0.01], [1.0]]), ([0, 1e6, 0], [1.0, 0.7, 0.01])):
        with pytest.warns(ConvergenceWarning, match="of 'omega' that are left out"):
            duffing.evaluate("x", t, lam=lam)


# --- what is known ------------------------------------------------------------------------------

OSCILLATOR = {"unknowns": {"x": fts.Field("cos", fixed=(1,)), "omega": fts.Scalar()},
              "frequency": "omega"}


@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
@pytest.mark.parametrize("order", [1, 2, 5, 12])
def test_finite_solutions_are_no_doubt(arithmetic, order):
    """x = λ cos t; and λ cos t + λ²/2, forced."""
    harmonic = fts.solve(fts.Equations("x'' + x = 0", **OSCILLATOR), order, arithmetic)
    assert silent(harmonic, "x", 1e3, lam=50.0) == pytest.approx(50 * np.cos(1e3), rel=1e-12)
    assert silent(harmonic, "omega", lam=50.0) == 1
    if order > 1:
        forced = fts.solve(fts.Equations("x'' + 2*x = lam*cos(t) + lam**2", unknowns={
            "x": fts.Field("cos")}), order, arithmetic)
        assert silent(forced, "x", 1.0, lam=7.0) == pytest.approx(7 * np.cos(1) + 24.5, rel=1e-13)
    else:
        assert silent(harmonic.truncate(1), "x", 1.0, lam=7.0, derivative=1) == pytest.approx(
            -7 * np.sin(1), rel=1e-13)


def test_a_constant_frequency_of_a_series_without_end():
    """x'' + ((1 + x) - (1 + x)⁻³)/4 = 0 is isochronous: ω = 1."""
    problem = fts.Equations("x'' + ((1 + x) - 1/(1 + x)**3)/4 = 0", **OSCILLATOR)
    solution = fts.solve(problem, 16)
    assert silent(solution, "omega", lam=0.9) == 1
    silent(solution, "x", 1e9, lam=0.1)
    with pytest.warns(ConvergenceWarning, match="of 'omega' only the first terms are known"):
        solution.truncate(4).evaluate("x", 1e9, lam=0.1)


def test_a_silence_before_the_second_term():
    """x'' + x + x¹¹ = 0: ω = 1 + (63/2⁸) λ¹⁰ …; up to order 9 there is nothing but the seed."""
    solution = fts.solve(fts.Equations("x'' + x + x**11 = 0", **OSCILLATOR), 22)
    for order in (1, 5, 8, 9):
        for name, t in (("omega", []), ("x", [0.3])):
            with pytest.warns(ConvergenceWarning, match="only the first terms are known"):
                solution.truncate(order).evaluate(name, *t, lam=0.9)
    assert silent(solution, "omega", lam=0.4) == pytest.approx(1 + 231 / 1024 * 0.4**10, rel=1e-8)


def test_free_parameters_count():
    """At μ = 1 the series of a converges more slowly than at μ = 0."""
    solution = fts.solve(fts.GeneralizedMathieu(), 21)
    silent(solution, "a", lam=1.3, mu=[0.0, 0.1])
    with pytest.warns(ConvergenceWarning) as caught:
        solution.evaluate("a", lam=1.5, mu=[0.0, 3.0, 4.0])
    assert len(caught) == 1


def test_the_warning_points_at_the_caller_through_arrays_of_parameters():
    solution = fts.solve(fts.GeneralizedMathieu(), 9)
    with pytest.warns(ConvergenceWarning) as caught:
        solution.evaluate("a", lam=9.0, mu=[0.1, 0.2])
    assert caught[0].filename == __file__


# --- digits -------------------------------------------------------------------------------------

def test_digits_that_floats_do_not_have():
    solution = fts.solve(fts.CubicOscillator(), 4, "float")
    silent(solution, "x", 0.1, lam=0.05, dps=15)
    with pytest.warns(PrecisionWarning, match="dps=16: .* have 15 digits"):
        solution.evaluate("x", 0.1, lam=0.05, dps=16)


@lru_cache
def cubic_solved(order, arithmetic, bits=None):
    return fts.solve(fts.CubicOscillator(), order, arithmetic, precision=bits or 128)


@pytest.mark.parametrize("order, bits, lam", [(60, 53, 2.7), (60, 53, 1.8), (100, 128, 2.7),
                                              (60, 128, 2.0), (24, 53, 0.5)])
@pytest.mark.parametrize("name, t", [("omega", []), ("x", [0.3]), ("x", [1e4])])
def test_balls_say_how_many_digits_they_have(order, bits, lam, name, t):
    """As many as the enclosing ball has, and never more than are right."""
    exact, balls = cubic_solved(order, "exact"), cubic_solved(order, "ball", bits)
    true = exact.enclosure(name, *t, lam=lam, precision=400)
    ball = balls.enclosure(name, *t, lam=lam, precision=400)
    assert ball.overlaps(true)
    for dps in (None, 10, int(bits / 3.3)):
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            value = balls.evaluate(name, *t, lam=lam, dps=dps)
        said = [str(w.message) for w in said if w.category is PrecisionWarning]
        kept = int(said[0].split("leave ")[1].split()[0]) if said else dps or 15
        size = {"omega": 2, "x": 1}[name]
        assert not kept or abs(float(value) - float(true)) <= size * 10.0**-min(kept, 15) * 2
        assert said or ball.rad() < 10 * 10.0**-(dps or 15)
        assert not said or ball.rad() > 10.0**-(dps or 15)


def test_enough_bits_say_nothing():
    solution = fts.solve(fts.CubicOscillator(), 24, "ball", precision=300)
    assert float(silent(solution, "x", 0.3, lam=0.5, dps=60)) == pytest.approx(
        silent(solution, "x", 0.3, lam=0.5), rel=1e-15)


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


@pytest.mark.parametrize("second, zero", [("y'' + 5*y = x**12", False), ("y'' + 5*y + y**3", True)])
def test_an_unknown_without_terms_is_zero_only_if_its_equation_says_so(second, zero):
    """y = O(λ¹²) is not 0, although nine orders of it are."""
    sol = fts.solve(fts.Equations(["x'' + x + x**3/10 + x*y**2 = 0", second], unknowns={
        "x": fts.Field("cos", fixed=(1,)), "y": fts.Field("cos"), "omega": fts.Scalar()},
        frequency="omega"), 8)
    assert (sol.resum().error("y", 1.0) == 0) == zero
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        assert sol.evaluate("y", 0, lam=1.0) == 0
    assert [w.category for w in caught] == [fts.ConvergenceWarning] * (not zero)
