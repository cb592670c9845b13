"""The figure eight: published digits, its symmetries, and three routes to the same motion."""

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ftseries.errors import InputError
from ftseries.references import newton, three_bodies

THIRD = 2 * np.pi / 3
times = st.floats(-20, 20)


@pytest.fixture(scope="module")
def lying():
    """The refined values scaled and turned back to the published form, |r_1(0)| = 1, 30 digits."""
    with mpmath.workdps(40):
        (r_1, _, _), (_, _, v_3) = newton.figure_eight_state(30)
        size = abs(r_1)
        return {
            "position_1": 1j * mpmath.conj(r_1) / size,
            "velocity_3": 1j * mpmath.conj(v_3) * mpmath.sqrt(size),
            "period": 2 * mpmath.pi / size ** mpmath.mpf(1.5),
        }


class TestPublished:
    def test_digits_of_chenciner_and_montgomery(self, lying):
        """All eight decimals are right. The print normalizes |r_1(0)| to 1, to its own accuracy."""
        assert abs(abs(newton.POSITION_1) - 1) < 5e-9
        for published, refined in ((newton.POSITION_1, lying["position_1"]),
                                   (newton.VELOCITY_3, lying["velocity_3"])):
            assert round(float(refined.real), 8) == published.real
            assert round(float(refined.imag), 8) == published.imag
        assert round(float(lying["period"]), 8) == newton.PERIOD

    def test_digits_of_simo(self, lying):
        """The fourteen decimals of the same values that are in common use.

        The last of them is off by up to 2, all by the same rotation of 2e-14 radian.
        """
        assert abs(complex(lying["position_1"]) - (0.97000435669734 - 0.24308753153583j)) < 2.5e-14
        assert abs(complex(lying["velocity_3"]) + (0.93240737144104 + 0.86473146092102j)) < 2.5e-14
        assert abs(float(lying["period"]) - 6.32591398292621) < 1e-14

    def test_lambda_of_the_paper(self):
        """(E_lambda_0) to its digits, and the digits of the float64 series of order 400."""
        assert round(newton.figure_eight_lambda(), 5) == 2.07568
        assert abs(newton.figure_eight_lambda() - 2.0756839088490) < 1e-13

    def test_published_motion(self):
        """Eight digits leave a distance of 1e-8 to 1e-7 over the period, and no closed curve."""
        t = np.linspace(0, 2 * np.pi, 101)
        published = newton.published_figure_eight(t)
        distance = np.sqrt((abs(published - newton.figure_eight(t)) ** 2).sum(0))
        assert 1e-10 < distance.max() < 1e-7
        assert 1e-10 < abs(published[:, -1] - published[:, 0]).max() < 1e-7

    def test_published_state_is_not_refined(self):
        """Scaled back, it is the print again, digit for digit."""
        scale = (newton.PERIOD / (2 * np.pi)) ** (1 / 3)
        r, v = newton.published_state()
        assert 1j * np.conj(r[0]) * scale**2 == pytest.approx(newton.POSITION_1, abs=1e-15)
        assert 1j * np.conj(v[2]) / scale == pytest.approx(newton.VELOCITY_3, abs=1e-15)
        assert r[2] == 0
        assert r[0] == -r[1]
        assert v.sum() == 0


class TestConventionsOfThePaper:
    def test_relative_vectors(self):
        """(E2), (E5): φ_12 = λ cos t + odd cosines, r_12 = even cosines, the others shifted."""
        t = 2 * np.pi * np.arange(180) / 180
        r_12, r_23, r_31 = (r - np.roll(newton.figure_eight(t), -1, axis=0)[k]
                            for k, r in enumerate(newton.figure_eight(t)))
        np.testing.assert_allclose(r_23, np.roll(r_12, 60), rtol=0, atol=1e-14)
        np.testing.assert_allclose(r_31, np.roll(r_12, -60), rtol=0, atol=1e-14)
        phi, distance = (np.fft.fft(f) / 90 for f in (np.angle(r_12), abs(r_12)))
        np.testing.assert_allclose([phi.imag, distance.imag], 0, atol=1e-14)  # no sines
        np.testing.assert_allclose([phi[::2], distance[1::2]], 0, atol=1e-14)
        assert phi[1].real == pytest.approx(newton.figure_eight_lambda(), abs=1e-14)
        assert distance[0].real / 2 > 0

    def test_signs_of_E7(self):
        """x_3 begins with sin 2t and y_3 with sin t, both negative; no multiple of three."""
        c = newton.figure_eight_coefficients()
        assert c[1].imag < -1
        assert c[2].real < -0.3
        np.testing.assert_allclose(c[::3], 0, atol=1e-16)
        np.testing.assert_allclose([c[1::2].real, c[::2].imag], 0, atol=1e-16)

    def test_upright(self):
        """The long axis is the y-axis: body 1 is at its end at t = 2π/12, moving sideways."""
        r = newton.figure_eight(np.pi / 6)
        assert r[0].imag == pytest.approx(np.max(newton.figure_eight(np.linspace(0, 7, 999)).imag),
                                          abs=1e-4)
        np.testing.assert_allclose([r[0].real, (r[1] - r[2]).imag, (r[1] + r[2]).real], 0,
                                   atol=1e-15)

    @given(times)
    def test_symmetries(self, t):
        r = newton.figure_eight([t, -t, t - THIRD, t + THIRD, np.pi - t])
        tolerance = {"rtol": 0, "atol": 1e-13}  # the phase t itself is rounded
        np.testing.assert_allclose(r[2, 1], -r[2, 0], **tolerance)
        np.testing.assert_allclose(r[2, 4], -r[2, 0].conj(), **tolerance)
        np.testing.assert_allclose(r[:2, 0], r[2, 2:4], **tolerance)
        np.testing.assert_allclose(r.sum(0), 0, **tolerance)


class TestTwoRoutes:
    @pytest.mark.parametrize("method", [three_bodies.integrate, three_bodies.integrate_taylor])
    def test_integration_follows_the_fourier_series(self, method):
        """Two periods, though only the first twelfth of one went into the series."""
        t = np.linspace(-2 * np.pi, 2 * np.pi, 73)
        r, v = method(t, *newton.figure_eight_state())
        np.testing.assert_allclose(r, newton.figure_eight(t), rtol=0, atol=2e-13)
        np.testing.assert_allclose(v, newton.figure_eight(t, 1), rtol=0, atol=1e-12)

    def test_newtons_equations_in_float64(self):
        t = np.linspace(0, 2 * np.pi, 50)
        residual = newton.newton_residual(newton.figure_eight(t), newton.figure_eight(t, 2))
        assert abs(residual).max() < 1e-11  # two derivatives of 80 harmonics: 1e-16 times 80²

    def test_newtons_equations_in_thirty_digits(self):
        with mpmath.workdps(40):
            t = [mpmath.mpf(k) / 7 for k in range(5)]
            r, acceleration = (newton.figure_eight(t, d, dps=30) for d in (0, 2))
            assert np.max(abs(newton.newton_residual(r, acceleration))) < mpmath.mpf("1e-28")

    def test_digits_against_float(self):
        state = newton.figure_eight_state(30)
        np.testing.assert_allclose(newton.figure_eight_state(), state.astype(complex), atol=5e-16)
        lam = newton.figure_eight_lambda(30)
        assert float(lam) == pytest.approx(newton.figure_eight_lambda(), abs=2e-15)
        t = np.linspace(0, 3, 4)
        exact = newton.figure_eight(t, dps=30).astype(complex)
        np.testing.assert_allclose(newton.figure_eight(t), exact, rtol=0, atol=1e-14)

    def test_thirty_digits_against_forty(self):
        """Other orders, steps and numbers of samples: thirty digits stay."""
        with mpmath.workdps(40):
            change = newton.figure_eight_lambda(30) - newton.figure_eight_lambda(40)
            assert abs(change) < mpmath.mpf("1e-30")
            state = newton.figure_eight_state(30) - newton.figure_eight_state(40)
            assert np.max(abs(state)) < mpmath.mpf("1e-30")


class TestConservationLaws:
    @settings(max_examples=30)
    @given(times)
    def test_energy_and_angular_momentum(self, t):
        r, v = newton.figure_eight(t), newton.figure_eight(t, 1)
        at_start = newton.energy(*newton.figure_eight_state())
        assert newton.energy(r, v) == pytest.approx(at_start, abs=1e-12)
        assert newton.angular_momentum(r, v) == pytest.approx(0, abs=1e-13)
        assert abs(v.sum()) < 1e-13

    def test_virial_theorem(self):
        """The mean of 2·kinetic + potential energy over a period vanishes."""
        t = 2 * np.pi * np.arange(180) / 180
        r, v = newton.figure_eight(t), newton.figure_eight(t, 1)
        kinetic = (abs(v) ** 2).sum(0) / 2
        assert np.mean(newton.energy(r, v) + kinetic) == pytest.approx(0, abs=1e-13)


@pytest.mark.parametrize(("call", "name"), [
    (lambda: newton.figure_eight(np.nan), "t .*finite"),
    (lambda: newton.figure_eight("noon"), "t="),
    (lambda: newton.figure_eight(0, -1), "derivative="),
    (lambda: newton.figure_eight(0, dps=0), "dps="),
    (lambda: newton.figure_eight(mpmath.inf, dps=20), "t .*finite"),
    (lambda: newton.figure_eight_state(2.5), "dps="),
    (lambda: newton.published_figure_eight(np.inf), "t .*finite"),
])
def test_refusals(call, name):
    with pytest.raises(InputError, match=name):
        call()
