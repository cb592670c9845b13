"""Newton's equations: an exact solution, conservation laws, two integrators that share nothing."""

import mpmath
import numpy as np
import pytest

from ftseries.errors import InputError
from ftseries.references import three_bodies
from ftseries.references.three_bodies import integrate, integrate_taylor

TURN = np.exp(2j * np.pi / 3) ** np.arange(3)
RATE = 3**-0.25  # of Lagrange's triangle at distance 1 from the centre: ω² = 1/√3
SCATTERED = np.array([-1, 1 + 0.2j, 0.1j]), np.array([0.3 + 0.5j, 0.3 + 0.4j, -0.6 - 0.9j])


@pytest.mark.parametrize("method", [integrate, integrate_taylor])
class TestBothIntegrators:
    def test_lagrange_triangle(self, method):
        t = np.array([[-5.0, 0.0, 1.0], [3.0, 3.0, 0.5]])
        r, v = method(t, TURN, 1j * RATE * TURN)
        exact = TURN[:, None, None] * np.exp(1j * RATE * t)
        np.testing.assert_allclose(r, exact, rtol=0, atol=2e-13)
        np.testing.assert_allclose(v, 1j * RATE * exact, rtol=0, atol=2e-13)

    def test_conservation_laws(self, method):
        """Energy, angular momentum, momentum and centre of mass over a passage of three bodies."""
        r, v = method(np.linspace(-1, 1, 21), *SCATTERED)
        for constant in (three_bodies.energy, three_bodies.angular_momentum):
            np.testing.assert_allclose(constant(r, v), constant(*SCATTERED), rtol=0, atol=1e-12)
        momentum = SCATTERED[1].sum()
        np.testing.assert_allclose(v.sum(0), momentum, rtol=0, atol=1e-12)
        drift = SCATTERED[0].sum() + momentum * np.linspace(-1, 1, 21)
        np.testing.assert_allclose(r.sum(0), drift, rtol=0, atol=1e-12)

    def test_there_and_back(self, method):
        r, v = method(0.8, *SCATTERED)
        np.testing.assert_allclose(method(-0.8, r, v)[0], SCATTERED[0], rtol=0, atol=1e-12)

    @pytest.mark.parametrize("exponent", [-0.5, 0, 0.7, 2])
    def test_lagrange_triangle_under_other_forces(self, method, exponent):
        """ω² r = √3 d^-(α+1) at r = 1, d = √3."""
        rate = np.sqrt(3 ** (-exponent / 2))
        r, v = method([-1.0, 0.5, 2.0], TURN, 1j * rate * TURN, exponent=exponent)
        exact = TURN[:, None] * np.exp(1j * rate * np.array([-1.0, 0.5, 2.0]))
        np.testing.assert_allclose(r, exact, rtol=0, atol=2e-13)
        np.testing.assert_allclose(v, 1j * rate * exact, rtol=0, atol=2e-13)

    def test_nothing_moves_in_no_time(self, method):
        np.testing.assert_array_equal(method(0, *SCATTERED), SCATTERED)

    def test_collision(self, method):
        """Released at distance 1, two bodies meet after π/4, half a period of a degenerate ellipse.

        Its semi-axis is 1/2 and the sum of the masses 2; the third body is far away.
        """
        with pytest.raises(InputError, match="cannot be followed"):
            method(2.0, [-0.5, 0.5, 100j], [0, 0, 0])

    @pytest.mark.parametrize(("arguments", "name"), [
        ((np.nan, *SCATTERED), "t .*finite"),
        (("now", *SCATTERED), "t="),
        ((1.0, SCATTERED[0][:2], SCATTERED[1]), "three complex numbers"),
        ((1.0, SCATTERED[0], SCATTERED[1] * np.nan), "finite"),
        ((1.0, [0, 0, 1], SCATTERED[1]), "different points"),
    ])
    def test_refusals(self, method, arguments, name):
        with pytest.raises(InputError, match=name):
            method(*arguments)


def test_the_integrators_agree():
    t = np.linspace(-1, 1, 41)
    np.testing.assert_allclose(
        integrate(t, *SCATTERED), integrate_taylor(t, *SCATTERED), rtol=0, atol=1e-12)


@pytest.mark.parametrize("exponent", [-0.3, 0, 1.5])
def test_the_integrators_agree_under_other_forces(exponent):
    t = np.linspace(-1, 1, 41)
    np.testing.assert_allclose(
        integrate(t, *SCATTERED, exponent=exponent),
        integrate_taylor(t, *SCATTERED, exponent=exponent), rtol=0, atol=5e-12)


def test_taylor_in_digits():
    """Lagrange's triangle to 40 digits, from initial values of 50."""
    with mpmath.workdps(50):
        rate = mpmath.mpf(3) ** mpmath.mpf(-0.25)
        turn = np.array([mpmath.expjpi(mpmath.mpf(2 * k) / 3) for k in range(3)])
        t = [mpmath.mpf("0.5"), mpmath.mpf(-1)]
        r, v = integrate_taylor(t, turn, 1j * rate * turn, dps=40)
        for k, time in enumerate(t):
            exact = turn * mpmath.expj(rate * time)
            assert max(abs(r[:, k] - exact)) < mpmath.mpf("1e-39")
            assert max(abs(v[:, k] - 1j * rate * exact)) < mpmath.mpf("1e-39")


def test_accelerations_are_the_gradient_of_the_potential():
    """Central differences of -energy at rest: exact up to h² and rounding/h."""
    r, h = SCATTERED[0], 1e-5

    def force(body, direction):
        step, still = np.zeros(3, complex), np.zeros(3)
        step[body] = direction * h
        return (three_bodies.energy(r - step, still) - three_bodies.energy(r + step, still)) / 2 / h
    gradient = [force(body, 1) + 1j * force(body, 1j) for body in range(3)]
    np.testing.assert_allclose(three_bodies.accelerations(r), gradient, rtol=0, atol=1e-8)


def test_residual():
    r = TURN[:, None] * np.exp(1j * RATE * np.linspace(0, 1, 5))
    np.testing.assert_allclose(three_bodies.newton_residual(r, -RATE**2 * r), 0, atol=1e-15)
    np.testing.assert_allclose(three_bodies.newton_residual(r, 0 * r), RATE**2 * r, atol=1e-15)


@pytest.mark.parametrize("dps", [0, 1.5, "many"])
def test_digits_refused(dps):
    with pytest.raises(InputError, match="dps="):
        integrate_taylor(1.0, *SCATTERED, dps=dps)
