"""Radius, residual, error estimate of solutions, against closed forms and known constants."""

import math

import numpy as np
import pytest
from flint import fmpq
from sample_problems import Duffing

import ftseries as fts
from ftseries.analysis import nearest_singularities
from ftseries.references import cubic, cubic_taylor, mathieu, newton

#: the branch points of Mathieu's b_1 and a_0, |q|: DLMF 28.6(ii), table 28.6.1 (n = 1 and n = 0)
RADIUS_B1, RADIUS_A0 = 3.7699574940, 1.4687686138


@pytest.fixture(scope="module")
def oscillator():
    return fts.solve(fts.CubicOscillator(a=1), order=60)


@pytest.fixture(scope="module")
def eight():
    return fts.solve(fts.FigureEight(), order=80)


@pytest.fixture(scope="module")
def long_eight():
    return fts.solve(fts.FigureEight(), order=200, arithmetic="float")


@pytest.fixture(scope="module")
def hill():
    return fts.solve(fts.GeneralizedMathieu(), order=60)


def test_sequence_of_the_oscillator_is_the_closed_form(oscillator):
    for n in (0, 1, 4):
        step, first, c = oscillator.sequence("x", n)
        closed = cubic_taylor.fourier_taylor(n, 60)
        assert (step, first) == (2, {0: 0, 1: 1, 4: 4}[n])
        assert c == [fmpq(x.p, x.q) for x in closed[first::2]]


def test_expand_reproduces_what_is_known(oscillator, eight):
    """The energy of (C2): E = x'²/2 + V, here 3 Ω² … at a = 1: -4 + 4λ² and no other mode."""
    def energy(lam, x, omega):
        return 6 * omega**2 * x.diff() ** 2 + 2 * x * (3 + lam**2) - 2 * x**3
    assert oscillator.expand(energy)[:2] == (2, 0)
    assert oscillator.expand(energy)[2][:2] == [-4, 4]
    assert not any(oscillator.expand(energy)[2][2:])
    with pytest.raises(fts.InputError, match="zero"):
        oscillator.expand(energy, n=1)
    # S_x by numbers put into the truncated series is the sum of its own series, nearly
    c = eight.expand(eight.problem.condition)[2]
    total = sum(float(int(x.p) / int(x.q)) * 1.0**k for k, x in enumerate(c))
    assert abs(3 * 3 ** (1 / 3) * total - fts.figure_eight.closure(eight, 1.0)) < 1e-14


def test_expand_in_every_arithmetic(eight, hill):
    c = eight.truncate(20).expand(eight.problem.condition)[2]
    for arithmetic in ("float", "ball"):
        sol = fts.solve(fts.FigureEight(), order=20, arithmetic=arithmetic)
        other = sol.expand(sol.problem.condition)[2]
        assert all(abs(float(y) - int(x.p) / int(x.q)) < 1e-14 for x, y in zip(c, other))
    step, first, square = hill.expand(lambda lam, psi, a: psi**2, mu=0)
    assert (step, first, square[0]) == (2, 2, fmpq(1, 2))               # λ² sin² x


@pytest.mark.parametrize("function", [lambda r: r * r, "r*r", 3, lambda lam, r: r, max,
                                      lambda lam, r, phi, more: r])
def test_expand_refuses_what_does_not_take_all_unknowns(eight, function):
    with pytest.raises(fts.InputError, match="give one like lambda lam, r, phi: …"):
        eight.expand(function)


def test_expand_refuses_what_is_not_a_series(eight):
    with pytest.raises(fts.InputError, match="must return a series"):
        eight.expand(lambda lam, r, phi: 3)


def test_radius_of_the_oscillator_is_three(oscillator):
    """1/ω = K(m)/(π sqrt(3a + λ)) has a plain logarithm at λ² = 9; ω itself goes like 1/log."""
    period = oscillator.expand(lambda lam, x, omega: omega**-1)[2]
    (s,) = nearest_singularities(period)
    assert abs(s.location - 9) <= s.error < 1e-11 and abs(s.exponent) <= s.exponent_error < 1e-9
    for name in ("x", "omega"):
        radius = oscillator.radius_of_convergence(name)
        assert abs(radius.value - 3) <= radius.error < 0.01
    scaled = fts.solve(fts.CubicOscillator(a=sp_half()), order=60).radius_of_convergence("x")
    assert abs(scaled.value - 1.5) <= scaled.error


def sp_half():
    import sympy as sp
    return sp.Rational(1, 2)


@pytest.mark.parametrize("branch, radius", [("b1", RADIUS_B1), ("a1", RADIUS_B1),
                                            ("a0", RADIUS_A0), ("a2", RADIUS_A0)])
def test_radius_of_mathieu_eigenvalues(branch, radius):
    sol = fts.solve(fts.GeneralizedMathieu(mu=0, branch=branch), order=99)
    found = sol.radius_of_convergence("a")
    q, error = found.value**2 / 2, found.value * found.error
    assert abs(q - radius) <= error + 1e-10 and error < 1e-6             # printed to 10 decimals
    singular = sol.singularities("a")[0]
    assert abs(singular.exponent - 0.5) <= singular.exponent_error       # two eigenvalues meet


@pytest.mark.parametrize("mu", [-0.3, -0.1, 0.1, 0.3])
def test_mathieu_branch_point_is_a_double_eigenvalue_of_the_hill_matrix(hill, mu):
    """Within the error of the estimate two eigenvalues meet, and nowhere nearer to 0."""
    singular = hill.singularities("a", mu=mu)[0]
    lam = np.sqrt(double_eigenvalue(singular.location, mu))
    assert abs(lam**2 - singular.location) <= singular.error < 3e-2
    radius = hill.radius_of_convergence("a", mu=mu)
    assert abs(radius.value - abs(lam)) <= radius.error


def double_eigenvalue(z, mu):
    """The λ² near z at which the two lowest odd eigenvalues are equal: Newton on (a - b)²."""
    def gap(z):
        values = np.linalg.eigvals(mathieu.hill_matrix(np.sqrt(complex(z)), mu, 24))
        pairs = values[:, None] - values
        np.fill_diagonal(pairs, np.inf)
        return pairs.flat[np.abs(pairs).argmin()] ** 2
    for _ in range(60):
        slope = (gap(z + 1e-5) - gap(z - 1e-5)) / 2e-5
        step = gap(z) / slope
        z -= step
        if abs(step) < 1e-9:
            break
    return z


def test_radius_of_the_eight_agrees_between_orders_and_arithmetics(eight, long_eight):
    short, long = eight.radius_of_convergence("r"), long_eight.radius_of_convergence("r")
    assert abs(short.value - long.value) <= short.error + long.error
    assert long.error < 1e-3 < short.error < 0.05
    assert abs(long_eight.radius_of_convergence("phi").value - long.value) <= 2 * long.error
    # the eight's λ lies inside
    assert newton.figure_eight_lambda() < long.value - long.error


def test_residual_of_the_exact_orbit_is_rounding_and_falls_with_the_order():
    sizes = [max(fts.solve(fts.CubicOscillator(a=1), order=n).residual(0.5).values())
             for n in (4, 8, 12, 16, 40)]
    assert all(b < a / 50 for a, b in zip(sizes, sizes[1:4])) and sizes[-1] < 1e-13
    first = fts.solve(fts.GeneralizedMathieu(mu=0), order=1).residual(1.0)
    # ψ = sin x, a = 1: the residual is -λ² cos 2x sin x, at most 1
    assert first == {"(M1)": pytest.approx(1.0, abs=1e-3)}


def test_error_estimate_of_the_oscillator():
    """Not a bound, but never a hundred times too small or too large here."""
    t = np.linspace(0, 4, 101)
    for order in (24, 40, 60):
        sol = fts.solve(fts.CubicOscillator(a=1), order=order)
        for lam in (0.5, 1.0, 1.5, 2.0):
            estimate = sol.error_estimate("omega", lam)
            true = abs(sol.evaluate("omega", lam=lam) - cubic.frequency(lam))
            if true > 1e-14:
                assert 0.3 < estimate / true < 100
            x = sol.evaluate("x", t, lam=lam) - cubic.position(t, lam)
            assert np.abs(x).max() < 100 * (sol.error_estimate("x", lam) + 4 * estimate) + 1e-13
    assert sol.error_estimate("omega", 3.1) == math.inf


def test_error_estimate_of_the_eight(eight, long_eight):
    truth = fts.figure_eight.positions
    lam, t = newton.figure_eight_lambda(), np.linspace(0, 2 * np.pi, 60)
    for sol in (eight, long_eight):
        true = np.abs(truth(sol, t, lam) - newton.figure_eight(t)).max()
        assert true < 3 * sol.error_estimate("r", lam) < 1e3 * true


@pytest.mark.parametrize("call, word", [
    (lambda s: s.truncate(8).radius_of_convergence("x"), "at order 8: .* too few .* try order=40"),
    (lambda s: fts.solve(Duffing(), 20).radius_of_convergence("omega"), "order 20: .* order=40"),
    (lambda s: s.truncate(16).error_estimate("omega", 0.1), "at order 16: .* try order=40"),
    (lambda s: s.truncate(8).radius_of_convergence("omega"), "too few"),
    (lambda s: s.truncate(8).singularities("x", 1), "too few"),
    (lambda s: s.sequence("x", 61), "no coefficients"),
    (lambda s: s.sequence("x", 2, sine=True), "no coefficients"),
    (lambda s: s.radius_of_convergence("y"), "not an unknown"),
    (lambda s: s.radius_of_convergence("x", mu=1), "no parameters"),
    (lambda s: s.residual(math.nan), "lam"),
    (lambda s: s.residual("a"), "lam"),
    (lambda s: s.error_estimate("x", math.inf), "lam"),
])
def test_bad_input_is_refused(oscillator, call, word):
    with pytest.raises(fts.InputError, match=word):
        call(oscillator)
