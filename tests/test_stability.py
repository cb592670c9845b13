"""Floquet theory against closed forms, conservation laws and independent integrations."""

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import mathieu_a, mathieu_b

import ftseries as fts
from ftseries import stability
from ftseries.references import floquet, mathieu, newton
from ftseries.references.three_bodies import integrate_taylor

OMEGA = 3**-0.25  # of Lagrange's triangle at distance 1 from the centre: ω² = 1/√3


@pytest.fixture(scope="module")
def eight():
    return stability.bodies(newton.figure_eight)


@pytest.fixture(scope="module")
def triangle():
    corners = np.exp(2j * np.pi * np.arange(3) / 3)[:, None]
    return stability.bodies(lambda t: corners * np.exp(1j * OMEGA * t), 2 * np.pi / OMEGA)


class TestMonodromy:
    def test_constant_matrix_gives_its_exponential(self):
        m, change = stability.monodromy(lambda t: np.diag([0.5, -1.0, 2.0]), 1.5, 3)
        np.testing.assert_allclose(m, np.diag(np.exp([0.75, -1.5, 3.0])), rtol=1e-12)
        assert 0 < change.max() < 1e-10

    def test_claimed_change_bounds_the_error(self):
        m, change = stability.monodromy(lambda t: np.array([[0, 1], [-25.0, 0]]), 2.0, 2)
        exact = [[np.cos(10), np.sin(10) / 5], [-5 * np.sin(10), np.cos(10)]]
        assert np.abs(m - exact).max() < change.max() < 1e-10

    @pytest.mark.parametrize("period", [0, -1.0, np.nan])
    def test_bad_period(self, period):
        with pytest.raises(fts.InputError, match="period"):
            stability.monodromy(lambda t: np.eye(1), period, 1)


class TestHill:
    @pytest.mark.parametrize("a", [0.3, 1.7, 5.2])
    def test_without_a_potential(self, a):
        m, k = stability.hill(a, 0), a**0.5
        exact = [[np.cos(k * np.pi), np.sin(k * np.pi) / k],
                 [-k * np.sin(k * np.pi), np.cos(k * np.pi)]]
        np.testing.assert_allclose(m.matrix, exact, rtol=0, atol=1e-11)
        slope = -np.pi * np.sin(k * np.pi) / k
        assert m.discriminant_slope == pytest.approx(slope, abs=1e-10)
        assert m.place == "band" and m.jordan is None and m.rate == 0
        assert np.cos(np.pi * m.angle) == pytest.approx(abs(np.cos(k * np.pi)), abs=1e-11)

    @given(a=st.floats(-6, 12), lam=st.floats(0, 2), mu=st.floats(-0.5, 0.5))
    @settings(max_examples=10, deadline=None)
    def test_laws_of_an_even_potential(self, a, lam, mu):
        """det = 1, equal diagonal elements, and M(2π) = M(π)²."""
        one = stability.hill(a, lam, mu)
        scale = max(1, np.abs(one.matrix).max()) ** 2
        assert one.determinant == pytest.approx(1, abs=1e-11 * scale)
        assert one.matrix[0, 0] == pytest.approx(one.matrix[1, 1], abs=1e-11 * scale)
        two = stability.hill(a, lam, mu, 2 * np.pi)
        np.testing.assert_allclose(two.matrix, one.matrix @ one.matrix, rtol=0, atol=1e-10 * scale)

    @pytest.mark.parametrize(("a", "lam", "mu"), [(2, 2, "-0.3"), (-2.5, 1.5, "0.4"), (7, 1, "0")])
    def test_against_power_series_in_30_digits(self, a, lam, mu):
        m = stability.hill(a, lam, float(mu))
        exact = np.array(floquet.hill_monodromy(a, lam, mu).tolist(), dtype=float)
        assert np.abs(m.matrix - exact).max() < m.error
        with mpmath.workdps(30):
            step = mpmath.mpf(10) ** -8
            d = [sum(floquet.hill_monodromy(a + sign * step, lam, mu)[i, i] for i in (0, 1))
                 for sign in (1, -1)]
            slope = float((d[0] - d[1]) / (2 * step))
        assert m.discriminant_slope == pytest.approx(slope, rel=1e-10, abs=1e-10)

    @pytest.mark.parametrize(("value", "level"), [
        (mathieu_a(0, 2), 2), (mathieu_b(1, 2), -2), (mathieu_a(1, 2), -2), (mathieu_b(2, 2), 2)])
    def test_edges_are_scipys_characteristic_values(self, value, level):
        """λ = 2 is q = 2; the edges are correct to 1e-13, the slopes of D below 100."""
        m = stability.hill(value, 2)
        assert m.discriminant == pytest.approx(level, abs=1e-10)
        assert stability.hill(value - 1e-4, 2).place != stability.hill(value + 1e-4, 2).place

    def test_jordan_block_on_the_papers_edge(self):
        m = stability.hill(mathieu.eigenvalue(2, -0.3), 2, -0.3)
        assert m.place == "edge"
        assert np.abs(m.jordan).max() > 3 and np.abs(m.jordan @ m.jordan).max() < 1e-10
        assert m.matrix[1, 0] == pytest.approx(float(floquet.hill_monodromy(
            mathieu.eigenvalue(2, "-0.3", dps=30), 2, "-0.3")[1, 0]), abs=1e-10)

    def test_slope_at_the_edge_is_c_times_the_integral(self):
        """∫ψ_2² over [0, π] is π/2 Σ c_n² over the square of ψ'(0) = Σ n c_n."""
        m = stability.hill(mathieu.eigenvalue(2, -0.3), 2, -0.3)
        c = mathieu.sine_coefficients(2, -0.3)
        n = 1 + 2 * np.arange(len(c))
        integral = np.pi / 2 * np.sum(c**2) / np.sum(n * c) ** 2
        assert m.discriminant_slope == pytest.approx(m.matrix[1, 0] * integral, rel=1e-10)

    def test_the_series_lies_in_the_gap_and_the_law_holds(self):
        sol = fts.solve(fts.GeneralizedMathieu(), order=99)
        a = sol.evaluate("a", lam=2, mu=-0.3)
        m = stability.hill(a, 2, -0.3)
        assert m.place == "gap" and m.angle == 0
        power = floquet.hill_monodromy(a, 2, "-0.3", dps=40) ** 80
        assert 1 + m.departure(80) == pytest.approx(float(power[1, 1]), rel=1e-6)

    def test_departure_in_the_band(self):
        a = mathieu.eigenvalue(2, -0.3) - 5e-5
        m = stability.hill(a, 2, -0.3)
        assert m.place == "band" and m.rate == 0
        power = floquet.hill_monodromy(a, 2, "-0.3", dps=40) ** 30
        assert 1 - m.departure(30) == pytest.approx(float(power[1, 1]), abs=1e-7)

    @pytest.mark.parametrize("period", [1.0, 0.0, -np.pi, np.inf])
    def test_period_must_be_a_multiple_of_pi(self, period):
        with pytest.raises(fts.InputError, match="period"):
            stability.hill(1, 1, 0, period)

    def test_values_must_be_finite(self):
        with pytest.raises(fts.InputError, match="lam"):
            stability.hill(1, np.nan)


class TestBodies:
    def test_against_taylor_integration(self, eight):
        independent = floquet.figure_eight_monodromy()
        assert np.abs(eight.matrix - independent).max() < 10 * eight.error < 1e-9

    def test_columns_against_nonlinear_motions(self, eight):
        """Differences of Newton's motions: h⁴ times a derivative, 1e-12 over h of rounding."""
        r, v = newton.figure_eight_state()
        h = 5e-4
        for body, part, column in ((0, 1, 0), (2, 1j, 5)):
            ends = {}
            for n in (-2, -1, 1, 2):
                moved = r.astype(complex)
                moved[body] += n * h * part
                ends[n] = integrate_taylor(2 * np.pi, moved, v).ravel().view(float)
            difference = (8 * (ends[1] - ends[-1]) - (ends[2] - ends[-2])) / (12 * h)
            np.testing.assert_allclose(eight.matrix[:, column], difference, rtol=0, atol=1e-5)

    def test_published_rotation_numbers(self, eight):
        numbers, errors = eight.rotation_numbers()
        assert np.all(abs(numbers - floquet.ROTATION_NUMBERS) < 5e-9)  # eight digits are printed
        assert np.all(errors < 1e-9)

    def test_symplectic_with_determinant_one(self, eight):
        assert eight.determinant == pytest.approx(1, abs=1e-11)
        values = eight.multipliers
        for value in values:
            assert abs(values - 1 / value).min() < 1e-5  # Jordan blocks halve the digits

    def test_symmetries_and_their_partners(self, eight):
        m, period = eight.matrix, eight.period
        x, y, time, rotation = eight.symmetries.T
        assert eight.defect < 1e-9
        for shift in (x, y):
            boost = np.roll(shift, 6)
            np.testing.assert_allclose(m @ boost, boost + period * shift, rtol=0, atol=1e-9)
        np.testing.assert_allclose(m @ eight.scaling, eight.scaling - 3 * period * time,
                                   rtol=0, atol=1e-9)
        r = newton.figure_eight(0.0)
        np.testing.assert_allclose(rotation[:6], np.stack([-r.imag, r.real], axis=1).ravel(),
                                   rtol=0, atol=1e-13)

    def test_basis_changes_no_integral(self, eight):
        j = np.block([[np.zeros((6, 6)), np.eye(6)], [-np.eye(6), np.zeros((6, 6))]])
        assert eight.basis.shape == (12, 4)
        assert np.abs((j @ eight.symmetries).T @ eight.basis).max() < 1e-13
        assert np.abs(eight.symmetries.T @ eight.basis).max() < 1e-13

    def test_truncated_series_claim_their_errors(self, eight):
        sol = fts.solve(fts.FigureEight(), order=60, arithmetic="float")
        true = eight.rotation_numbers()[0]
        for order in (30, 60):
            part = sol.truncate(order)
            lam = fts.figure_eight.closure_zero(part)
            numbers, errors = stability.bodies(
                lambda t, part=part, lam=lam: fts.figure_eight.positions(part, t, lam)
            ).rotation_numbers()
            assert np.all(abs(numbers - true) < errors)

    def test_lagranges_triangle_has_its_known_exponents(self, triangle):
        """λ⁴ + λ² + 9/4 = 0 in units of ω (Routh): e^{2πλ} = e^{±√2π}, each twice; and 1 twice."""
        found = np.sort(np.linalg.eigvals(triangle.essential).real)
        large = np.exp(2**0.5 * np.pi)
        np.testing.assert_allclose(found, [1 / large, 1 / large, 1, 1, large, large], rtol=1e-6)

    def test_unstable_motion_has_no_rotation_numbers(self, triangle):
        with pytest.raises(fts.InputError, match="unstable"):
            triangle.rotation_numbers()

    def test_positions_that_are_not_periodic(self):
        with pytest.raises(fts.InputError, match="not smooth and periodic"):
            stability.bodies(newton.figure_eight, period=6.0)

    def test_bodies_that_meet(self):
        with pytest.raises(fts.InputError, match="meet"):
            stability.bodies(lambda t: np.stack([np.cos(t), -np.cos(t), 0 * t + 5j]))

    @pytest.mark.parametrize("wrong", [lambda t: t, lambda t: np.full((3, t.size), np.nan)])
    def test_positions_of_a_wrong_kind(self, wrong):
        with pytest.raises(fts.InputError, match="positions"):
            stability.bodies(wrong)


@pytest.fixture(scope="module", params=["-1/2", "0", "6/5"])
def other_eight(request):
    """The eight under the force d^-(α+1), and the analysis of its stability."""
    orbit = fts.solve(fts.FigureEight(), order=12).refine()
    orbit = orbit.refine(fts.FigureEight("1/4")).refine(fts.FigureEight(request.param))
    alpha = float(orbit.problem.exponent)
    return alpha, orbit, stability.bodies(
        lambda t: fts.figure_eight.positions(orbit, t, orbit.lam),
        force=lambda d: d**-(alpha + 1))


def test_other_forces_keep_the_symmetries_and_keplers_third_law(other_eight):
    alpha, _, motion = other_eight
    m = motion.matrix
    assert motion.defect < 1e-8
    drift = (alpha + 2) * motion.period * motion.symmetries[:, 2]
    assert np.abs(m @ motion.scaling - motion.scaling + drift).max() < 1e-8


def test_other_forces_against_taylor_series_in_time(other_eight):
    alpha, orbit, motion = other_eight
    t = 2 * np.pi * np.arange(1024) / 1024
    z = fts.figure_eight.positions(orbit, t, orbit.lam)
    v = np.fft.ifft(1j * np.fft.fftfreq(1024, 1 / 1024) * np.fft.fft(z))
    m = floquet.figure_eight_monodromy([z[:, 0], v[:, 0]], alpha)
    # rounding of the initial values times the growth of disturbances
    assert np.abs(m - motion.matrix).max() < 1e-9 * np.abs(m).max()


@pytest.mark.parametrize("bodies, words", [(3, "two of the bodies meet"),
                                           (1, "two bodies or more")])
def test_bodies_at_rest_in_one_place_are_refused(bodies, words):
    """The integration of their disturbances would never end."""
    with pytest.raises(fts.InputError, match=words):
        stability.bodies(lambda t: np.zeros((bodies, *np.shape(t)), complex))
