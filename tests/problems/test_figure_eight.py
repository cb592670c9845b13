"""The figure eight of section 4: printed coefficients, Newton's equations, other force laws."""

import warnings

import numpy as np
import pytest
import sympy as sp
from sample_problems import LemniscateEight, PowerLawEight
from scipy.special import ellipj

import ftseries as fts
from ftseries.references import newton

eight = fts.figure_eight
TRUE_LAMBDA = 2.0756839088491                 # from the shooting of references.newton, see below
c = sp.cbrt(3)


@pytest.fixture(scope="module")
def order_30():
    return fts.solve(fts.FigureEight(), 30)


@pytest.fixture(scope="module")
def order_400():
    return fts.solve(fts.FigureEight(), 400, "float", progress=False)


def acceleration(z, power=3):
    """The right-hand side of (E0) for complex positions of shape (3, …)."""
    total = np.zeros_like(z)
    for i in range(3):
        for j in range(3):
            if i != j:
                d = z[j] - z[i]
                total[i] += d / np.abs(d) ** power
    return total


def second_derivative(z):
    """d²/dt² of samples over the period 2π, by the discrete Fourier transform."""
    n = np.fft.fftfreq(z.shape[-1], 1 / z.shape[-1])
    return np.fft.ifft(-n**2 * np.fft.fft(z))


# --- printed coefficients -----------------------------------------------------------------------

E6 = {("r", 0, 0): c, ("r", 0, 2): -c / 16, ("r", 0, 4): 3 * c / 256,                    # (E6a)
      ("r", 2, 2): c / 8, ("r", 2, 4): -c / 128, ("r", 2, 6): 5 * c / 4096,              # (E6b)
      ("r", 4, 4): c / 256, ("r", 4, 6): -29 * c / 49152, ("r", 6, 6): -c / 8192,        # (E6c)
      ("phi", 1, 1): sp.Integer(1), ("phi", 3, 3): -sp.Rational(1, 48),
      ("phi", 3, 5): -sp.Rational(1, 512), ("phi", 5, 5): -sp.Rational(9, 20480),        # (E6d)
      ("r", 0, 6): -7 * c / 24576}                                       # A06, not printed


def test_E6_and_nothing_else_to_order_6():
    solution = fts.solve(fts.FigureEight(), 6)
    for name in ("r", "phi"):
        for m in range(7):
            for n in range(7):
                assert solution.coefficient(name, n, m) == E6.get((name, n, m), 0), (name, n, m)


def test_E_lambda_the_first_mode_of_phi_is_lambda(order_30):
    assert [order_30.coefficient("phi", 1, m) for m in range(31)] == [0, 1] + [0] * 29


def test_E5_parities(order_30):
    assert all(n % 2 == 0 and m % 2 == 0 for m, row in enumerate(order_30.coefficients["r"])
               for _, n in row)
    assert all(n % 2 == 1 and m % 2 == 1 for m, row in enumerate(order_30.coefficients["phi"])
               for _, n in row)


def test_E7_the_orbit_of_order_6():
    """x_3, y_3 of (E7a), (E7b) are r_3 of (E4a), expanded again in λ and cut at order 6."""
    solution = fts.solve(fts.FigureEight(), 6)
    lam, t = 0.05, np.linspace(0, 2 * np.pi, 41)
    r_3 = eight.positions(solution, t, lam)[2]
    k = 3 ** (1 / 6)
    x = (-(lam**4 - 32 * lam**2 + 512) * lam**2 * np.sin(2 * t) / (4096 * k)
         - (lam**2 + 192) * lam**4 * np.sin(4 * t) / (49152 * k))
    y = (-lam * (3 * lam**4 - 32 * lam**2 + 256) * np.sin(t) / (256 * k)
         + 3 * lam**5 * np.sin(5 * t) / (4096 * k))
    # the difference begins at order 7 and 8: 0.05^7 = 8e-10, times coefficients below 1e-2
    assert np.abs(r_3 - (x + 1j * y)).max() < 1e-11


# --- the zeros of S_x ---------------------------------------------------------------------------

def test_lambda_6(order_30):
    assert f"{eight.closure_zero(order_30.truncate(6)):.5f}" == "2.09531"


def test_E7_the_mean_of_lambda_12_to_30(order_30):
    zeros = [eight.closure_zero(order_30.truncate(n)) for n in range(12, 31, 2)]
    assert f"{np.mean(zeros):.5f}" == "2.07552"
    assert abs(np.mean(zeros) / TRUE_LAMBDA - 1) < 8e-5                  # the paper's deviation


def test_largest_distance_to_the_true_orbit(order_30):
    """The paper prints 1.6e-3; numbers put into r and φ at λ = 2.07552 give 1.66e-3."""
    t = np.linspace(0, 2 * np.pi, 241)
    gap = eight.positions(order_30, t, 2.07552) - newton.figure_eight(t)
    distance = np.sqrt((np.abs(gap) ** 2).sum(axis=0)).max()
    assert distance == pytest.approx(1.66e-3, abs=5e-6)


def test_S_y_vanishes_and_S_is_constant():
    """For every λ, physical or not: the sum of (E3) over the three pairs is S″ = 0."""
    solution = fts.solve(fts.FigureEight(), 80, "float")
    t = np.linspace(0, 2 * np.pi, 30)
    shifts = np.array([0, -1, 1])[:, None] * 2 * np.pi / 3
    S = (solution.evaluate("r", t + shifts, lam=0.8)
         * np.exp(1j * solution.evaluate("phi", t + shifts, lam=0.8))).sum(axis=0)
    assert np.abs(S.imag).max() < 1e-14 * 10
    assert np.abs(S - S[0]).max() < 1e-14 * 10
    assert S[0].real == pytest.approx(float(eight.closure(solution, 0.8)), abs=1e-14)
    assert S[0].real > 1                                             # not physical at all


# --- order 400 ----------------------------------------------------------------------------------

def test_the_physical_lambda(order_400):
    """The error falls about 0.93-fold per order: 0.93^400 ≈ 2e-13."""
    assert newton.figure_eight_lambda() == pytest.approx(TRUE_LAMBDA, abs=1e-13)
    assert eight.closure_zero(order_400) == pytest.approx(TRUE_LAMBDA, abs=2e-12)


def test_S_x_vanishes_at_its_zero(order_400):
    assert abs(eight.closure(order_400, eight.closure_zero(order_400))) < 1e-14


def test_newtons_equations_E0(order_400):
    """Everywhere to 1e-8: positions on a grid, their spectral second derivative, the forces."""
    t = 2 * np.pi * np.arange(512) / 512
    z = eight.positions(order_400, t, eight.closure_zero(order_400))
    assert np.abs(second_derivative(z) - acceleration(z)).max() < 1e-8
    assert np.abs(z.sum(axis=0)).max() < 1e-14                             # (E_CM1)
    assert np.abs(z - newton.figure_eight(t)).max() < 1e-10


def test_choreography(order_400):
    t = np.linspace(0, 2 * np.pi, 25)
    z = eight.positions(order_400, t, 2.0756839088491)
    late = eight.positions(order_400, t + 2 * np.pi / 3, 2.0756839088491)
    assert np.abs(late - z[[2, 0, 1]]).max() < 1e-11          # each in the place of another


def test_positions_of_many_lambdas(order_30):
    t, lam = np.linspace(0, 1, 4).reshape(2, 2), np.array([0.5, 1.0, 1.5])
    z = eight.positions(order_30, t, lam)
    assert z.shape == (3, 2, 2, 3)
    for i, value in enumerate(lam):
        assert np.allclose(z[..., i], eight.positions(order_30, t, value), rtol=0, atol=1e-14)


# --- other forces -------------------------------------------------------------------------------

@pytest.mark.parametrize("alpha, order, tolerance", [("1/2", 160, 1e-7), ("3/2", 240, 1e-4)])
def test_power_laws_satisfy_their_newton_equations(alpha, order, tolerance):
    """The force |d|^{-(α+1)}: each has its own λ and rate of convergence."""
    problem = PowerLawEight(alpha)
    solution = fts.solve(problem, order, "float", progress=False)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        lam = eight.closure_zero(solution)
    t = 2 * np.pi * np.arange(256) / 256
    z = eight.positions(solution, t, lam)
    error = np.abs(second_derivative(z) - acceleration(z, float(problem.alpha) + 2)).max()
    assert error < tolerance
    assert np.abs(z.sum(axis=0)).max() < 1e-12


def test_power_law_1_is_the_figure_eight():
    assert (fts.solve(PowerLawEight(1), 12).coefficients
            == fts.solve(fts.FigureEight(), 12).coefficients)


class TestLemniscate:
    """Three bodies on Bernoulli's lemniscate, the one eight with a closed form."""

    m = (2 + np.sqrt(3)) / 4
    T = LemniscateEight.period

    def relative(self, tau):
        """r_12 upright at time tau of the period 2π: bodies 1 and 2 follow 3 by ∓T/3."""
        def position(t):
            sn, cn, _, _ = ellipj(t, self.m)
            return (sn + 1j * sn * cn) / (1 + cn**2)
        t = np.asarray(tau) * self.T / (2 * np.pi)
        d = position(t - self.T / 3) - position(t + self.T / 3)
        return 1j * np.conj(d)

    def test_the_closed_form_solves_its_equations(self):
        """The pair potential ½ ln r - (√3/24) r², with a spectral derivative."""
        tau = 2 * np.pi * np.arange(1024) / 1024

        def pull(t):
            z = self.relative(t)
            return z * (1 / (2 * np.abs(z) ** 2) - np.sqrt(3) / 12)

        left = LemniscateEight.W * second_derivative(self.relative(tau))
        right = -2 * pull(tau) + pull(tau - 2 * np.pi / 3) + pull(tau + 2 * np.pi / 3)
        assert np.abs(left - right).max() < 1e-9

    def test_lambda_converges_to_that_of_the_lemniscate(self):
        tau = 2 * np.pi * np.arange(4096) / 4096
        phi = np.unwrap(np.angle(self.relative(tau)))
        truth = abs(2 * np.mean((phi - phi.mean()) * np.cos(tau)))
        errors = []
        for order in (40, 80, 120, 200):
            solution = fts.solve(LemniscateEight(), order, "float", progress=False)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                errors.append(abs(eight.closure_zero(solution) - truth))
        assert all(late < early / 2 for early, late in zip(errors, errors[1:], strict=False))
        assert errors[-1] < 1e-5

    def test_the_series_is_the_lemniscate(self):
        """Order 200 at the true λ: r_12(t) within 1e-4, the size of the left-out terms."""
        tau = np.linspace(0, 2 * np.pi, 49)
        truth = self.relative(tau)
        solution = fts.solve(LemniscateEight(), 200, "float", progress=False)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            r = solution.evaluate("r", tau, lam=2.0830394043899574)
        assert np.abs(r - np.abs(truth)).max() < 1e-4
