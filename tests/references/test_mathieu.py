"""The generalized Mathieu equation: published eigenvalues, series and branch point, two routes."""

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import special

from ftseries.errors import InputError
from ftseries.references import mathieu
from ftseries.references.floquet import hill_monodromy

EPS = np.finfo(float).eps


class TestPublished:
    @pytest.mark.parametrize(("q", "b1"), [(5, -5.79008060), (10, -13.93655248), (15, -22.51300350),
                                           (20, -31.31338617), (25, -40.25677898)])
    def test_table_20_1_of_abramowitz_and_stegun(self, q, b1):
        assert round(float(mathieu.eigenvalue(np.sqrt(2 * q))), 8) == b1

    def test_series_20_2_25_of_abramowitz_and_stegun(self):
        """b_1(q) to q⁸, from the values on the circle |q| = 1/2 by Cauchy's formula.

        The radius of convergence 3.77 leaves (0.5/3.77)^64 to aliasing; rounding is 1e-15 2⁸.
        """
        published = [1, -1, -1 / 8, 1 / 64, -1 / 1536, -11 / 36864, 49 / 589824, -55 / 9437184,
                     -83 / 35389440]
        q = np.exp(2j * np.pi * np.arange(64) / 64) / 2
        series = np.fft.fft(mathieu.eigenvalue(np.sqrt(2 * q))) / 64 * 2.0 ** np.arange(64)
        np.testing.assert_allclose(series[:9], published, rtol=0, atol=1e-12)

    @pytest.mark.parametrize("mu", [-0.3, 0, 0.3, 0.2 - 0.4j])
    def test_M3(self, mu):
        """The printed polynomials in μ, from the values on the circle |λ| = 1/2."""
        printed = {0: 1, 2: -1 / 2, 4: -1 / 32, 6: (32 * mu + 1) / 512,
                   8: (-1024 * mu**2 - 64 * mu - 1) / 24576}
        lam = np.exp(2j * np.pi * np.arange(64) / 64) / 2
        series = np.fft.fft(mathieu.eigenvalue(lam, mu)) / 64 * 2.0 ** np.arange(64)
        expected = [printed.get(m, 0) for m in range(10)]
        np.testing.assert_allclose(series[:10], expected, rtol=0, atol=1e-12)

    def test_branch_point_of_DLMF_28_6_1(self):
        """b_1 and b_3 meet at |q| = 3.7699574940: there their squared distance has a zero."""
        def gap(q):
            lowest = np.linalg.eigvals(mathieu.hill_matrix(np.sqrt(2 * complex(q))))
            lowest = lowest[np.argsort(lowest.real)][:2]
            return mpmath.mpc((lowest[0] - lowest[1]) ** 2)
        with mpmath.workdps(15):
            q = mpmath.findroot(gap, (2 + 3j, 2 + 3.2j, 1.9 + 3.2j), solver="muller", tol=1e-18)
        assert round(float(abs(q)), 9) == round(3.7699574940, 9)

    def test_eigenvalue_of_figure_5(self):
        """The size of the matrix grows with the digits: forty of them do not move with sixty."""
        forty = mathieu.eigenvalue(2, "-0.3", dps=40)
        with mpmath.workdps(60):
            assert abs(forty - mathieu.eigenvalue(2, "-0.3", dps=60)) < mpmath.mpf("1e-38")
        assert float(forty) == pytest.approx(mathieu.eigenvalue(2, -0.3), abs=4 * EPS)


class TestTwoRoutes:
    def test_matrix_against_scipy(self):
        lam = np.linspace(-4, 4, 41)
        for index in range(4):
            # SciPy's series and continued fractions are good to some 1e-12 of the scale n²
            np.testing.assert_allclose(mathieu.eigenvalue(lam, index=index),
                                       mathieu.mathieu_b(lam, index), rtol=0, atol=1e-11)

    def test_eigenfunction_against_scipy(self):
        """se_1 is normalized to integral π; ours to the coefficient λ of sin x."""
        lam, x = 1.3, np.linspace(-4, 4, 17)
        se, slope = special.mathieu_sem(1, lam**2 / 2, np.degrees(x))
        c = mathieu.sine_coefficients(lam)
        norm = np.sqrt(np.sum(c**2))  # Parseval: the integral of ψ² is π Σ c²
        np.testing.assert_allclose(mathieu.eigenfunction(x, lam), norm * se, atol=1e-12)
        np.testing.assert_allclose(
            mathieu.eigenfunction(x, lam, derivative=1), norm * slope, atol=1e-11)

    @pytest.mark.parametrize(("lam", "mu", "index"), [(2, -0.3, 0), (1, 0.5, 0), (1.5, -1, 1)])
    def test_matrix_against_integration(self, lam, mu, index):
        x = np.linspace(-2 * np.pi, 2 * np.pi, 81)
        a = mathieu.eigenvalue(lam, mu, index)
        start = (0, mathieu.eigenfunction(0, lam, mu, index, derivative=1))
        psi, slope = mathieu.integrate(x, a, lam, mu, start)
        np.testing.assert_allclose(psi, mathieu.eigenfunction(x, lam, mu, index), atol=1e-11)
        np.testing.assert_allclose(
            slope, mathieu.eigenfunction(x, lam, mu, index, derivative=1), atol=1e-10)

    @pytest.mark.parametrize(("lam", "mu"),
                             [(2, "-0.3"), ("0.7", "0.4"), (mpmath.mpc(1, 0.5), 0.1)])
    def test_digits_against_float(self, lam, mu):
        kind = complex if isinstance(lam, mpmath.mpc) else float
        exact = mathieu.sine_coefficients(lam, mu, dps=40)
        rough = mathieu.sine_coefficients(kind(lam), float(mu))
        np.testing.assert_allclose(rough, [kind(c) for c in exact[: len(rough)]], atol=1e-14)
        with mpmath.workdps(40):
            assert abs(exact[0] - mpmath.mpmathify(lam)) < mpmath.mpf("1e-38")
        assert abs(exact[-1]) < 1e-40

    def test_hill_matrix_from_its_integrals(self):
        """(2/π) ∫ sin(nx) (-d²/dx² + λ² cos 2x + λ⁴μ cos 4x) sin(kx) dx over half a period."""
        lam, mu, n = 1.7, -0.6, 1 + 2 * np.arange(6)
        x = (np.arange(64) + 0.5) * np.pi / 64  # exact for the trigonometric polynomials here
        waves = np.sin(np.outer(n, x))
        potential = lam**2 * np.cos(2 * x) + lam**4 * mu * np.cos(4 * x)
        integrals = (waves * (potential + (n**2)[:, None, None])) @ waves.T * (2 / 64)
        for row in range(6):
            np.testing.assert_allclose(mathieu.hill_matrix(lam, mu, 6)[row], integrals[row, row],
                                       rtol=0, atol=1e-12)


class TestIdentities:
    @settings(max_examples=40)
    @given(st.floats(-2.5, 2.5), st.floats(-1, 1), st.integers(0, 2))
    def test_eigenfunction_solves_M1(self, lam, mu, index):
        x = np.linspace(-1, 4, 23)
        a = mathieu.eigenvalue(lam, mu, index)
        psi = mathieu.eigenfunction(x, lam, mu, index)
        force = (-a + lam**2 * np.cos(2 * x) + lam**4 * mu * np.cos(4 * x)) * psi
        bend = mathieu.eigenfunction(x, lam, mu, index, derivative=2)
        scale = np.sum(abs(mathieu.sine_coefficients(lam, mu, index)))  # of ψ, times n² ≈ 100
        np.testing.assert_allclose(bend, force, rtol=0, atol=1e-11 * scale + 1e-300)

    @given(st.floats(-3, 3), st.floats(-1, 1))
    def test_eigenvalues_are_simple_and_in_order(self, lam, mu):
        a = [mathieu.eigenvalue(lam, mu, index) for index in range(4)]
        assert a[0] < a[1] < a[2] < a[3]

    @given(st.complex_numbers(max_magnitude=1.5, allow_nan=False), st.floats(-0.3, 0.3))
    @settings(max_examples=20, deadline=None)
    def test_reflection(self, lam, mu):
        """a is a function of λ², real for real λ and μ."""
        a = mathieu.eigenvalue(lam, mu)
        assert mathieu.eigenvalue(-lam, mu) == pytest.approx(a, abs=1e-12)
        assert mathieu.eigenvalue(lam.conjugate(), mu) == pytest.approx(a.conjugate(), abs=1e-12)

    def test_mean_value_property(self):
        """The branch followed to complex λ is analytic: its mean over a circle is its centre."""
        for index in range(3):
            lam = 1.2 + 0.3 * np.exp(2j * np.pi * np.arange(32) / 32)
            mean = np.mean(mathieu.eigenvalue(lam, 0.2, index))
            assert mean == pytest.approx(mathieu.eigenvalue(1.2, 0.2, index), abs=1e-12)

    def test_at_rest(self):
        assert [float(mathieu.eigenvalue(0, 0.5, k)) for k in range(3)] == [1, 9, 25]
        assert np.all(mathieu.eigenfunction(np.arange(3), 0, 0.5) == 0)

    def test_wronskian_is_conserved(self):
        x = np.linspace(-10, 10, 41)
        u, v = (mathieu.integrate(x, -2.9, 2, -0.3, start) for start in ((1, 0), (0, 1)))
        size = np.max(abs(u)) * np.max(abs(v))
        np.testing.assert_allclose(u[0] * v[1] - u[1] * v[0], 1, rtol=0, atol=1e-13 * size + 1e-11)

    def test_free_motion(self):
        x = np.array([[-7.0, 0.0], [3.0, 3.0]])
        psi, slope = mathieu.integrate(x, a=4, lam=0, start=(1, 2))
        np.testing.assert_allclose(psi, np.cos(2 * x) + np.sin(2 * x), rtol=0, atol=1e-12)
        np.testing.assert_allclose(slope, 2 * np.cos(2 * x) - 2 * np.sin(2 * x), rtol=0, atol=1e-12)

    def test_broadcasting(self):
        lam, mu = np.linspace(0, 2, 5)[:, None], np.linspace(-0.3, 0.3, 4)
        surface = mathieu.eigenvalue(lam, mu)
        assert surface.shape == (5, 4)
        assert surface[3, 1] == pytest.approx(mathieu.eigenvalue(lam[3, 0], mu[1]), abs=1e-14)
        assert mathieu.eigenfunction(np.zeros((7, 1, 1)), lam, mu).shape == (7, 5, 4)


@pytest.mark.parametrize(("call", "name"), [
    (lambda: mathieu.eigenvalue(np.nan), "lam .*finite"),
    (lambda: mathieu.eigenvalue(1, np.inf), "mu .*finite"),
    (lambda: mathieu.eigenvalue(complex(0, np.inf)), "lam .*finite"),
    (lambda: mathieu.eigenvalue("two"), "lam="),
    (lambda: mathieu.eigenvalue(1, index=-1), "index="),
    (lambda: mathieu.eigenvalue(1e9), "too large"),
    (lambda: mathieu.eigenvalue("two", dps=20), "lam="),
    (lambda: mathieu.eigenvalue(2, dps=-1), "dps="),
    (lambda: mathieu.eigenfunction(np.inf, 1), "x .*finite"),
    (lambda: mathieu.eigenfunction(0, 1, derivative=-1), "derivative="),
    (lambda: mathieu.integrate(0, np.nan, 1), "a .*finite"),
    (lambda: mathieu.mathieu_b(1j), "lam=.*real"),
])
def test_refusals(call, name):
    with pytest.raises(InputError, match=name):
        call()


class TestBandEdges:
    @pytest.mark.parametrize(("lam", "mu"), [(0.7, 0), (2.0, -0.3), (1.5, 0.4)])
    def test_edges_are_where_the_discriminant_is_two(self, lam, mu):
        """Period π where tr M = 2, change of sign where tr M = -2: another route."""
        edges = mathieu.band_edges(lam, mu)
        assert np.all(np.diff(edges) > 0)
        for a, trace in zip(edges, (2, -2, -2, 2, 2), strict=True):
            assert abs(hill_monodromy(a, lam, mu, dps=15)[0, 0] * 2 - trace) < 1e-9

    def test_ordinary_mathieu_equation(self):
        q = 1.3
        names = [special.mathieu_a(0, q), special.mathieu_b(1, q), special.mathieu_a(1, q),
                 special.mathieu_b(2, q), special.mathieu_a(2, q)]
        np.testing.assert_allclose(mathieu.band_edges(np.sqrt(2 * q)), names, rtol=0, atol=1e-12)

    def test_the_second_is_the_odd_eigenvalue(self):
        lam = np.linspace(0, 2.4, 25)
        edges = mathieu.band_edges(lam, -0.3, count=2)
        np.testing.assert_allclose(edges[:, 1], mathieu.eigenvalue(lam, -0.3), rtol=0, atol=1e-12)
