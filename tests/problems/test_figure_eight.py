"""The figure eight of section 4: printed coefficients, Newton's equations, other force laws."""

import warnings
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

import ftseries as fts
from ftseries.problems import LemniscateEight, PlanarEight
from ftseries.references import lemniscate, newton

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

def residual(solution, lam, exponent):
    """Largest departure from the equations of motion with the force d^-(exponent + 1)."""
    t = 2 * np.pi * np.arange(512) / 512
    z = eight.positions(solution, t, lam)
    assert np.abs(z.sum(axis=0)).max() < 1e-12
    return np.abs(second_derivative(z) - acceleration(z, exponent + 2)).max()


@pytest.mark.parametrize("alpha, order, tolerance", [("1/2", 160, 1e-7), ("3/2", 240, 1e-4)])
def test_power_laws_satisfy_their_newton_equations(alpha, order, tolerance):
    """The force |d|^{-(α+1)}: each has its own λ and rate of convergence."""
    solution = fts.solve(fts.FigureEight(alpha), order, "float", progress=False)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert residual(solution, eight.closure_zero(solution), float(Fraction(alpha))) < tolerance


@pytest.mark.parametrize("alpha", [0, 1, 2])
def test_whole_exponents_in_exact_arithmetic(alpha):
    """A_22 = 3/(4 (α + 5)) in units of 3^(1/(α + 2)), derived by hand in the book."""
    solution = fts.solve(fts.FigureEight(alpha), 12)
    assert (solution.coefficient("r", 2, 2)
            == sp.Rational(3, 4 * (alpha + 5)) * 3 ** sp.Rational(1, alpha + 2))
    float_ = fts.solve(fts.FigureEight(alpha), 12, "float")
    for name in ("r", "phi"):
        for mode, row in solution.table(name).items():
            assert float_.table(name)[mode] == pytest.approx(row, rel=1e-12, abs=1e-15)


def test_exponent_1_is_the_figure_eight():
    solution = fts.solve(fts.FigureEight(1), 12)
    assert solution.coefficients == fts.solve(fts.FigureEight(), 12).coefficients
    assert repr(solution.problem) == "FigureEight()"


@pytest.mark.parametrize("exponent", [-2, -3, "x", "sqrt(2)", float("nan"), None])
def test_exponents_refused(exponent):
    with pytest.raises(fts.InputError, match="exponent=.*above -2|is not a number"):
        fts.FigureEight(exponent)


@pytest.mark.parametrize("problem", [fts.FigureEight("3/2"), PlanarEight(0), LemniscateEight()])
def test_problems_are_saved_with_their_force(problem, tmp_path):
    solution = fts.solve(problem, 6, "float")
    solution.save(tmp_path / "eight.json")
    again = fts.load(tmp_path / "eight.json")
    assert repr(again.problem) == repr(problem)
    assert again.evaluate(next(iter(problem.unknowns)), 0.3, lam=0.2) == solution.evaluate(
        next(iter(problem.unknowns)), 0.3, lam=0.2)


@pytest.mark.parametrize("exponent", ["-1/2", 0, 1, "3/2"])
def test_cartesian_and_polar_coordinates_give_one_motion(exponent):
    """The same choreography, with λ of two meanings."""
    polar = fts.solve(fts.FigureEight(), 12).refine().refine(fts.FigureEight(exponent))
    planar = fts.solve(PlanarEight(), 12).refine().refine(PlanarEight(exponent))
    t = np.linspace(0, 6, 40)
    gap = eight.positions(polar, t, polar.lam) - eight.positions(planar, t, planar.lam)
    assert np.abs(gap).max() < 1e-12
    assert residual(planar, planar.lam, float(Fraction(exponent))) < 1e-8


def test_cartesian_series_is_the_polar_one_expanded_again():
    """x = r cos φ, y = r sin φ; the amplitude of y is another parameter, so at small λ."""
    polar, planar = (fts.solve(problem, 14) for problem in (fts.FigureEight(), PlanarEight()))
    t = 2 * np.pi * np.arange(64) / 64
    y = polar.evaluate("r", t, lam=0.1) * np.sin(polar.evaluate("phi", t, lam=0.1))
    lam = 2 * np.mean(y * np.cos(t))
    x = polar.evaluate("r", t, lam=0.1) * np.cos(polar.evaluate("phi", t, lam=0.1))
    # the first order left out, 0.15^16 = 7e-14, has a small coefficient
    assert np.abs(planar.evaluate("y", t, lam=lam) - y).max() < 1e-14 * 5
    assert np.abs(planar.evaluate("x", t, lam=lam) - x).max() < 1e-14 * 5


class TestLemniscate:
    """Three bodies on Bernoulli's lemniscate, the one eight with a closed form."""

    def test_lambda_converges_to_that_of_the_lemniscate(self):
        errors = []
        for order in (40, 80, 120, 200):
            solution = fts.solve(LemniscateEight(), order, "float", progress=False)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                errors.append(abs(eight.closure_zero(solution) - lemniscate.lam()))
        assert all(late < early / 2 for early, late in zip(errors, errors[1:], strict=False))
        assert errors[-1] < 1e-5

    def test_refined_it_is_the_lemniscate(self):
        """To rounding, which near the double points of |Z| is amplified about tenfold."""
        orbit = fts.solve(LemniscateEight(), 60, "float", progress=False).refine()
        t = np.linspace(0, 6, 50)
        assert orbit.lam == pytest.approx(lemniscate.lam(), abs=1e-13)
        assert np.abs(eight.positions(orbit, t, orbit.lam) - lemniscate.bodies(t)).max() < 1e-12


# --- r e^{iφ}, expanded once more -----------------------------------------------------------------

def test_expanded_gives_the_constant_of_the_closure(order_30):
    """S_x = 3^{4/3} (1 - 5/16 λ² + 7/256 λ⁴ - …): the first terms by hand."""
    sol = eight.expanded(order_30)
    assert [sol.coefficient("x", 0, m) / c for m in (0, 2, 4)] == [
        1, -sp.Rational(5, 16), sp.Rational(7, 256)]
    assert [sol.coefficient("y", 1, m) / c for m in (1, 3)] == [1, -sp.Rational(1, 8)]


def test_expanded_has_no_mode_that_three_divides(order_30):
    for name, parity in (("x", 0), ("y", 1)):
        modes = {n for _, n in eight.expanded(order_30).table(name)}
        assert all((n == 0 or n % 3) and n % 2 == parity for n in modes)


def test_expanded_is_the_same_motion(order_30):
    t, sol = np.linspace(0, 6, 50), eight.expanded(order_30)
    for lam, tolerance in ((0.5, 1e-14), (1.5, 1e-4)):        # (1.5/2.23)^31 = 5e-6, times a factor
        gap = abs(eight.relative(sol, t, lam) - eight.relative(order_30, t, lam)).max()
        assert gap < tolerance
    assert round(eight.closure_zero(eight.expanded(order_30.truncate(6))), 5) == 2.05428


@pytest.mark.parametrize("exponent", [0, "1/2"])
def test_expanded_knows_other_forces(exponent):
    sol = fts.solve(fts.FigureEight(exponent), 20)
    again = eight.expanded(sol)
    assert again.problem.exponent == sol.problem.exponent
    assert abs(eight.positions(again, 1.0, 0.5) - eight.positions(sol, 1.0, 0.5)).max() < 1e-12


@pytest.mark.parametrize("make", [
    lambda: fts.solve(fts.CubicOscillator(a=1), 4),
    lambda: fts.solve(fts.FigureEight(), 4, "float"),
    lambda: fts.solve(PlanarEight(), 4), lambda: "eight"])
def test_expanded_takes_exact_eights_alone(make):
    with pytest.raises(fts.InputError, match="is not an exact figure eight; give solve"):
        eight.expanded(make())
