"""The closed forms of the cubic oscillator: printed digits, exact identities, two routes each."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from ftseries.errors import FTSeriesError, InputError
from ftseries.references import cubic, cubic_taylor, weierstrass

scales = st.floats(0.2, 5)
ratios = st.floats(-2.9, 2.9)  # λ/a
times = st.floats(-5, 5)
EPS = np.finfo(float).eps


@pytest.fixture(autouse=True)
def fifty_digits():
    with mpmath.workdps(50):
        yield


class TestPrintedNumbers:
    def test_period_C9b(self):
        assert mpmath.nstr(cubic.period("0.5", dps=40), 22) == "1.823392542996019014655"

    def test_period_C9b_as_printed_with_K(self):
        printed = 2 * mpmath.sqrt(mpmath.mpf(2) / 7) * mpmath.ellipk(mpmath.mpf(2) / 7)
        assert mpmath.almosteq(cubic.period("0.5", dps=40), printed, rel_eps=mpmath.mpf("1e-40"))

    def test_frequency_and_period_C8(self):
        """The paper's double-precision digits: within two units of the last place."""
        assert abs(cubic.frequency(0.5) - 3.4458763864722597) <= 2 * EPS * 2
        assert abs(cubic.period(0.5) - 1.8233925429960192) <= 2 * EPS

    def test_invariants_C11(self):
        assert cubic.invariants(Fraction(1, 2)) == (13, 6)

    def test_energy_and_turning_points_of_figure_1(self):
        half = Fraction(1, 2)
        assert cubic.energy(half) == -3
        assert cubic.turning_points(half) == (Fraction(-3, 2), Fraction(-1, 2))
        assert cubic.elliptic_parameter(half) == Fraction(2, 7)

    def test_C7(self):
        a = sympy.Symbol("a", positive=True)
        omega = [2 * sympy.sqrt(3 * a), 0, -1 / (8 * sympy.sqrt(3) * a ** sympy.Rational(3, 2))]
        printed = {0: [-a, 0, 1 / (12 * a), 0], 1: [0, 1, 0, -1 / (192 * a**2)],
                   2: [0, 0, -1 / (12 * a), 0], 3: [0, 0, 0]}
        computed = cubic_taylor.frequency_taylor(2, a)
        assert [sympy.simplify(x - y) for x, y in zip(computed, omega, strict=True)] == [0, 0, 0]
        for n, coefficients in printed.items():
            terms = len(coefficients) - 1
            assert cubic_taylor.fourier_taylor(n, terms, a) == coefficients


class TestIdentities:
    @given(st.fractions(-3, 3), st.fractions(-3, 3), st.fractions(1, 3))
    def test_polynomial_C3_three_ways(self, x, lam, a):
        g2, g3 = cubic.invariants(lam, a)
        p = cubic.polynomial(x, lam, a)
        assert p == 2 * (cubic.energy(lam, a) - cubic.potential(x, lam, a))
        assert p == 4 * x**3 - g2 * x - g3

    @given(st.fractions(0, 3), st.fractions(1, 3))
    def test_turning_points_are_roots(self, lam, a):
        assert [cubic.polynomial(x, lam, a) for x in cubic.turning_points(lam, a)] == [0, 0]

    @given(times, ratios, scales)
    def test_energy_is_conserved(self, t, ratio, a):
        x, v = cubic.position(t, ratio * a, a), cubic.velocity(t, ratio * a, a)
        total = v**2 / 2 + cubic.potential(x, ratio * a, a)
        # the terms reach 100 a³, and the phase, up to 30, amplifies rounding
        assert abs(total - cubic.energy(ratio * a, a)) < 1e-11 * a**3

    @given(times, ratios, scales)
    def test_scaling(self, t, ratio, a):
        """x(t; λ, a) = a X(√a t; λ/a), rounding amplified by the speed and the elapsed phase."""
        assert cubic.position(t, ratio * a, a) == pytest.approx(
            a * cubic.position(np.sqrt(a) * t, ratio), rel=0, abs=1e-11 * a)

    @given(times, st.floats(0, 2.9))
    def test_sign_of_lam_shifts_by_half_a_period(self, t, lam):
        half = cubic.period(lam) / 2
        assert cubic.position(t, -lam) == pytest.approx(cubic.position(t + half, lam), abs=1e-11)

    def test_starts_at_the_outer_turning_point(self):
        lam = np.linspace(-2.9, 2.9, 59)
        np.testing.assert_allclose(cubic.position(0, lam), -1 + lam, rtol=0, atol=4 * EPS)
        np.testing.assert_allclose(cubic.velocity(0, lam), 0, rtol=0, atol=1e-14)

    def test_rest_and_broadcasting(self):
        assert np.all(cubic.position(np.ones((5, 1)), 0, a=[1, 2, 3]) == -np.array([1, 2, 3]))
        assert cubic.position(np.ones((5, 1)), [0.1, 0.2]).shape == (5, 2)
        assert cubic.frequency(0) == pytest.approx(2 * np.sqrt(3), rel=2 * EPS)


class TestTwoRoutes:
    @pytest.mark.parametrize(("lam", "a"), [(0.5, 1), (0.01, 1), (2.5, 1), (1.0, 2.0), (-0.7, 0.5)])
    def test_period_by_quadrature(self, lam, a):
        assert cubic.period_by_quadrature(lam, a) == pytest.approx(cubic.period(lam, a), rel=1e-13)

    @pytest.mark.parametrize(("lam", "a"), [("0.5", 1), ("2.99", 1), ("0.001", 1), ("2", 3)])
    @pytest.mark.parametrize("t", ["0", "0.3", "-1.7", "40"])
    def test_jacobi_against_weierstrass(self, t, lam, a):
        """Forty digits, less the two that the elapsed phase may cost."""
        jacobi = cubic.position(t, lam, a, dps=40)
        assert abs(jacobi - weierstrass.position(t, lam, a, dps=40)) < mpmath.mpf("1e-38")

    def test_float_against_digits(self):
        t = np.linspace(-3, 3, 13)
        exact = [float(cubic.position(s, 2.5, dps=30)) for s in t]
        np.testing.assert_allclose(cubic.position(t, 2.5), exact, rtol=0, atol=1e-13)

    def test_against_integration_of_the_equation_of_motion(self):
        """x'' = -V'(x) by DOP853, without any elliptic function."""
        lam, a, t = 2.0, 1.0, np.linspace(0, 4, 41)
        def slope(_, y):
            return y[1], -2 * (3 * a**2 + lam**2) + 6 * y[0] ** 2
        path = solve_ivp(slope, (0, 4), (-a + lam, 0), "DOP853", t, rtol=1e-13, atol=1e-14,
                         max_step=0.01)
        np.testing.assert_allclose(cubic.position(t, lam), path.y[0], rtol=0, atol=1e-10)
        np.testing.assert_allclose(cubic.velocity(t, lam), path.y[1], rtol=0, atol=1e-10)

    @pytest.mark.parametrize("lam", ["0.5", "-0.5", "2"])
    def test_fourier_series_sums_to_the_motion(self, lam):
        """Sixty terms: at λ = 2 the nome is 0.066, so the rest is far below 1e-30."""
        t, omega = mpmath.mpf("0.37"), cubic.frequency(lam, dps=40)
        total = sum(cubic.fourier_coefficient(n, lam, dps=40) * mpmath.cos(n * omega * t)
                    for n in range(60))
        assert abs(total - cubic.position(t, lam, dps=40)) < mpmath.mpf("1e-37")

    def test_fourier_coefficients_in_float64(self):
        lam = np.array([-2.0, -0.5, 0.0, 0.5, 2.0])
        for n in range(5):
            exact = [float(cubic.fourier_coefficient(n, x, dps=30)) for x in lam]
            computed = cubic.fourier_coefficient(n, lam)
            np.testing.assert_allclose(computed, exact, rtol=1e-13, atol=1e-15)

    @pytest.mark.parametrize("n", [0, 1, 2, 5])
    def test_exact_taylor_coefficients_against_numerical_ones(self, n):
        closed = mpmath.taylor(
            lambda lam: cubic.fourier_coefficient(n, lam, dps=mpmath.mp.dps), 0, 12)
        exact = cubic_taylor.fourier_taylor(n, 12)
        for numerical, rational in zip(closed, exact, strict=True):
            assert abs(numerical - mpmath.mpf(rational.p) / rational.q) < mpmath.mpf("1e-40")

    def test_exact_frequency_against_numerical_one(self):
        closed = mpmath.taylor(lambda lam: cubic.frequency(lam, dps=mpmath.mp.dps), 0, 12)
        for numerical, exact in zip(closed, cubic_taylor.frequency_taylor(12), strict=True):
            assert abs(numerical - mpmath.mpmathify(exact.evalf(60))) < mpmath.mpf("1e-40")

    def test_exact_taylor_series_sum_to_the_closed_forms(self):
        """At λ = 1/2 order 60 leaves about (1/6)^62 of the radius 3: 1e-47."""
        lam = mpmath.mpf(1) / 2
        omega2 = cubic_taylor.frequency_squared_taylor(60)
        total = mpmath.polyval([mpmath.mpf(c.p) / c.q for c in reversed(omega2)], lam)
        assert abs(total - cubic.frequency(lam, dps=50) ** 2) < mpmath.mpf("1e-45")

    def test_taylor_scaling_in_a(self):
        """Order by order: the series at a = 2 is that of 2 A_n(λ/2)."""
        for n in range(3):
            doubled = cubic_taylor.fourier_taylor(n, 6, a=2)
            single = cubic_taylor.fourier_taylor(n, 6)
            assert doubled == [2 * c / sympy.Integer(2) ** m for m, c in enumerate(single)]
            assert cubic.fourier_coefficient(n, 0.3, 2) == pytest.approx(
                2 * cubic.fourier_coefficient(n, 0.15), rel=1e-13)


class TestWeierstrass:
    def test_differential_equation(self):
        z = mpmath.mpc("0.31", "0.17")
        with mpmath.workdps(60):
            slope = mpmath.diff(lambda s: weierstrass.weierstrass_p(s, 13, 6, mpmath.mp.dps), z)
            p = weierstrass.weierstrass_p(z, 13, 6, 60)
            assert abs(slope**2 - 4 * p**3 + 13 * p + 6) < mpmath.mpf("1e-45")

    def test_laurent_series(self):
        """℘ = z⁻² + g2 z²/20 + g3 z⁴/28 + g2² z⁶/1200 + 3 g2 g3 z⁸/6160 + O(z¹⁰)."""
        z = mpmath.mpf("1e-4")
        series = z**-2 + 13 * z**2 / 20 + 6 * z**4 / 28 + 169 * z**6 / 1200 + 234 * z**8 / 6160
        assert abs(weierstrass.weierstrass_p(z, 13, 6, 60) - series) < mpmath.mpf("1e-39")

    def test_shift_C10_as_printed_and_as_an_integral(self):
        u1 = weierstrass.shift("0.5", dps=40)
        root = mpmath.sqrt(mpmath.mpf(2) / 7)
        K = mpmath.ellipk
        printed = mpmath.mpc(-root * K(mpmath.mpf(2) / 7), root * K(mpmath.mpf(5) / 7))
        assert abs(u1 - printed) < mpmath.mpf("1e-39")
        # (C10) in two parts: P > 0 above x = 2 (x = 2 + s²), P < 0 between -1/2 and 2
        # (x = 3/4 - 5/4 cos θ); the branch of the root fixes the sign of the imaginary part.
        real = mpmath.quad(lambda s: 1 / mpmath.sqrt((s**2 + 2.5) * (s**2 + 3.5)),
                           [0, 1, mpmath.inf])
        imaginary = mpmath.quad(
            lambda th: 1 / (2 * mpmath.sqrt(mpmath.mpf(9) / 4 - 1.25 * mpmath.cos(th))),
            [0, mpmath.pi])
        assert abs(u1 - mpmath.mpc(-real, imaginary)) < mpmath.mpf("1e-30")

    def test_the_motion_is_real(self):
        z = mpmath.mpf("0.2") - weierstrass.shift("0.5", dps=50)
        assert abs(mpmath.im(weierstrass.weierstrass_p(z, 13, 6, 50))) < mpmath.mpf("1e-47")


@pytest.mark.parametrize(("call", "name"), [
    (lambda: cubic.frequency(3.0), "lam"),
    (lambda: cubic.frequency(-3.0), "lam"),
    (lambda: cubic.position(0, 0.5, a=-1), "lam and a"),
    (lambda: cubic.position(np.nan, 0.5), "t .*finite"),
    (lambda: cubic.position("soon", 0.5), "t=.*real"),
    (lambda: cubic.position(0, 1j), "lam=.*real"),
    (lambda: cubic.frequency("half", dps=20), "lam=.*not a number"),
    (lambda: cubic.frequency("nan", dps=20), "lam .*finite"),
    (lambda: cubic.frequency("3.5", dps=20), "lam"),
    (lambda: cubic.frequency("0.5", dps=0), "dps"),
    (lambda: cubic.frequency("0.5", dps=2.5), "dps"),
    (lambda: cubic.fourier_coefficient(-1, 0.5), "n="),
    (lambda: cubic.period_by_quadrature(0), "lam must not be 0"),
    (lambda: weierstrass.position(0, 0), "lam"),
    (lambda: weierstrass.weierstrass_p(1, 3, 1), "g2"),
    (lambda: cubic_taylor.frequency_taylor(-1), "order"),
    (lambda: cubic_taylor.fourier_taylor(1.5, 3), "n="),
    (lambda: cubic_taylor.fourier_taylor(1, 3, a=-1), "a must be"),
])
def test_refusals(call, name):
    with pytest.raises(InputError, match=name) as refusal:
        call()
    assert isinstance(refusal.value, FTSeriesError)
