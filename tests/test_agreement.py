"""Exact, ball and float arithmetic agree; solutions satisfy their equations by other routes."""

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from flint import arb, ctx, fmpq
from hypothesis import given
from hypothesis import strategies as st
from sample_problems import SMALL, Duffing, Exponential, LotkaVolterra, Pendulum, VanDerPol

import ftseries as fts
from ftseries.problem import Scalar

PAPER = [fts.CubicOscillator, lambda: fts.GeneralizedMathieu(mu="-3/10"), fts.FigureEight]
PAPER_IDS = ["cubic", "Mathieu", "eight"]
ALL = pytest.mark.parametrize("make", PAPER + SMALL,
                              ids=PAPER_IDS + [kind.__name__ for kind in SMALL])
ORDER = 24


def numbers(solution):
    """((name, m, mode), number) of every non-zero coefficient in the solver's units."""
    for name, rows in solution.coefficients.items():
        for m, row in enumerate(rows):
            for mode, number in row.items():
                yield (name, m, mode), number


def fraction(number):
    """An exact rational, or a ball without radius, as a Fraction: no rounding anywhere."""
    if isinstance(number, fmpq):
        return Fraction(int(number.p), int(number.q))
    mantissa, exponent = number.man_exp()
    return int(mantissa) * Fraction(2) ** int(exponent)


@ALL
def test_balls_contain_the_exact_coefficients(make):
    exact = dict(numbers(fts.solve(make(), ORDER)))
    balls = dict(numbers(fts.solve(make(), ORDER, "ball", precision=200)))
    assert set(exact) <= set(balls)
    for key, ball in balls.items():
        middle, radius = fraction(ball.mid()), fraction(ball.rad())
        value = fraction(exact.get(key, fmpq(0)))
        assert abs(value - middle) <= radius
        # and they are narrow: 200 bits are 60 digits, of which order 24 costs fewer than 20
        assert key not in exact or radius < abs(value) / 10**40


@ALL
def test_balls_shrink_with_the_precision(make):
    wide = dict(numbers(fts.solve(make(), ORDER, "ball", precision=64)))
    narrow = dict(numbers(fts.solve(make(), ORDER, "ball", precision=192)))
    assert all(wide.get(key, arb(0)).overlaps(ball) for key, ball in narrow.items())
    assert (sum(float(ball.rad()) for ball in narrow.values())
            < 2**-100 * sum(float(ball.rad()) for ball in wide.values()))


@ALL
def test_float_agrees_with_exact_to_rounding(make):
    """Relative to the largest coefficient of the neighbouring orders: Cauchy sums of 24 orders lose
    at most four of the sixteen digits."""
    exact = {key: float(fraction(c)) for key, c in numbers(fts.solve(make(), ORDER))}
    float_ = dict(numbers(fts.solve(make(), ORDER, "float")))
    for key in set(exact) | set(float_):
        scale = max(abs(c) for (_, m, _), c in exact.items() if abs(m - key[1]) <= 1)
        assert abs(float_.get(key, 0.0) - exact.get(key, 0.0)) <= 1e-11 * scale, key


@ALL
def test_the_order_asked_for_does_not_change_the_coefficients(make):
    long, short = fts.solve(make(), ORDER), fts.solve(make(), 11)
    assert long.truncate(11).coefficients == short.coefficients
    for order in range(4):
        assert fts.solve(make(), order).coefficients == short.truncate(order).coefficients


class Oscillator(fts.Problem):
    """ω² x'' + x + c_2 x² + c_3 x³ + … = 0 with given rational numbers c."""

    unknowns = {"x": fts.Field("cos", fixed=(1,)), "omega": fts.Scalar()}
    seed = {"x": [{}, {1: 1}], "omega": [1]}
    frequency = "omega"

    def __init__(self, c):
        self.c = c

    def equations(self, lam, x, omega):
        force = x
        for k, c in enumerate(self.c, 2):
            force = force + c * x**k
        return {"Newton": omega**2 * x.diff(2) + force}


@given(st.lists(st.fractions(-2, 2, max_denominator=5), min_size=1, max_size=4))
def test_random_oscillators_in_every_arithmetic(c):
    problem, order = Oscillator(c), 9
    exact, float_, balls = (fts.solve(problem, order, arithmetic)
                            for arithmetic in ("exact", "float", "ball"))
    values, floats = dict(numbers(exact)), dict(numbers(float_))
    assert set(values) <= set(dict(numbers(balls)))
    for key, ball in numbers(balls):
        value = fraction(values.get(key, fmpq(0)))
        assert abs(value - fraction(ball.mid())) <= fraction(ball.rad())
        scale = max(abs(fraction(v)) for (_, m, _), v in values.items() if abs(m - key[1]) <= 1)
        assert abs(floats.get(key, 0.0) - value) <= 1e-12 * scale
    # the equation itself, by a spectral derivative; what is cut off is of order λ^10
    t, omega, found = functions(exact, 0.01, 64)
    x = found["x"]
    force = x + sum(float(k) * x**p for p, k in enumerate(c, 2))
    assert np.abs(derivative(x, omega, 2) + force).max() < 1e-12


@pytest.mark.parametrize("make", [fts.CubicOscillator, fts.FigureEight, SMALL[6]],
                         ids=["cubic", "eight", "van der Pol"])
def test_float_at_high_order_agrees_with_balls(make):
    """Order 80: eight digits are left at least, and no false alarm of the solver."""
    balls = {key: float(c) for key, c in numbers(fts.solve(make(), 80, "ball", precision=400))}
    floats = dict(numbers(fts.solve(make(), 80, "float")))
    top = {m: max(abs(c) for (_, k, _), c in balls.items() if k == m) for _, m, _ in balls}
    assert all(abs(floats.get(key, 0.0) - c) < 1e-8 * top[key[1]] for key, c in balls.items())


def test_ball_solve_leaves_the_precision_of_flint_alone():
    before = ctx.prec
    fts.solve(fts.FigureEight(), 12, "ball", precision=300)
    assert ctx.prec == before


# --- the equations hold, by numerical evaluation and a spectral derivative ----------------------

def functions(solution, lam, points=256):
    """Every unknown on a uniform grid of one period, and ω; in the paper's units."""
    problem = solution.problem
    omega = solution.evaluate(problem.frequency, lam=lam) if problem.frequency else 1.0
    t = 2 * np.pi * np.arange(points) / points / omega
    values = {name: (solution.evaluate(name, lam=lam) if isinstance(unknown, Scalar)
                     else solution.evaluate(name, t, lam=lam))
              for name, unknown in problem.unknowns.items()}
    return t, omega, values


def derivative(values, omega, times=1):
    """d/dt of samples of a smooth periodic function, by the discrete Fourier transform."""
    n = np.fft.rfftfreq(values.shape[-1], 1 / values.shape[-1])
    spectrum = np.fft.rfft(values)
    spectrum[np.abs(spectrum) < 1e-16 * np.abs(spectrum).max()] = 0
    return np.fft.irfft((1j * n * omega) ** times * spectrum, values.shape[-1])


ODES = {
    "cubic": (fts.CubicOscillator, 0.3, lambda t, w, x, omega: [
        derivative(x, w) ** 2 - 4 * (x - 2) * (x - 0.3 + 1) * (x + 0.3 + 1)]),
    "cubic, Newton's form": (fts.CubicOscillator, 0.3, lambda t, w, x, omega: [
        derivative(x, w, 2) + 2 * (3 + 0.09) - 6 * x**2]),
    "Mathieu": (lambda: fts.GeneralizedMathieu(mu="-3/10"), 0.7, lambda t, w, psi, a: [
        derivative(psi, 1, 2)
        + (a - 0.49 * np.cos(2 * t) + 0.3 * 0.7**4 * np.cos(4 * t)) * psi]),
    "Duffing": (SMALL[0], 0.4, lambda t, w, x, omega: [derivative(x, w, 2) + x + x**3]),
    "pendulum": (SMALL[1], 0.7, lambda t, w, x, omega: [derivative(x, w, 2) + np.sin(x)]),
    "relativistic": (SMALL[2], 0.3, lambda t, w, x, omega: [
        derivative(x, w, 2) + x * (1 - derivative(x, w) ** 2) ** 1.5]),
    "quotient": (SMALL[3], 0.25, lambda t, w, x, omega: [derivative(x, w, 2) + x / (1 + x**2)]),
    "Toda": (SMALL[4], 0.5, lambda t, w, x, omega: [derivative(x, w, 2) + np.expm1(x)]),
    "Lotka-Volterra": (SMALL[5], 0.3, lambda t, w, u, v, omega: [
        derivative(u, w) + (1 + u) * v, derivative(v, w) - (1 + v) * u]),
    "van der Pol": (SMALL[6], 0.5, lambda t, w, y, omega: [
        derivative(y, w, 2) + y - (0.25 - y**2) * derivative(y, w)]),
    "coupled": (SMALL[7], 0.4, lambda t, w, x, y, omega: [
        derivative(x, w, 2) + 2 * x - y + x**3, derivative(y, w, 2) + 2 * y - x]),
}


@pytest.mark.parametrize("name", ODES)
@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
def test_the_solution_satisfies_its_differential_equation(name, arithmetic):
    """At a λ well inside the disk of convergence order 40 leaves only rounding: two spectral
    derivatives of modes up to 40 multiply it by some hundreds."""
    make, lam, ode = ODES[name]
    solution = fts.solve(make(), 40, arithmetic)
    t, omega, values = functions(solution, lam)
    for residual in ode(t, omega, **values):
        assert np.abs(residual).max() < 2e-12


@pytest.mark.parametrize("name", ["Duffing", "pendulum", "relativistic", "quotient", "Toda",
                                  "Lotka-Volterra", "coupled"])
def test_the_residual_of_a_truncation_falls_with_its_order(name):
    """Twice the λ, 2^(order + 1) times the residual: the truncation leaves exactly O(λ^(N+1))."""
    make, _, ode = ODES[name]
    solution = fts.solve(make(), 5)

    def size(lam):
        t, omega, values = functions(solution, lam)
        return max(np.abs(residual).max() for residual in ode(t, omega, **values))

    assert size(0.1) > 1e-11                             # above rounding: the ratio means something
    assert 5.6 <= np.log2(size(0.2) / size(0.1)) <= 7.4     # order 6, or 7 with odd orders alone


# --- the equations hold, by symbolic expansion in low order -------------------------------------

tau, lam = sp.symbols("tau lambda")


def symbolic(solution, name):
    """One unknown as a SymPy polynomial in λ, from nothing but ``coefficient``."""
    total = 0
    unknown = solution.problem.unknowns[name]
    for m in range(solution.order + 1):
        if isinstance(unknown, Scalar):
            total += solution.coefficient(name, m) * lam**m
            continue
        for n in range(m + 1):
            total += solution.coefficient(name, n, m, sine=False) * lam**m * sp.cos(n * tau)
            total += solution.coefficient(name, n, m, sine=True) * lam**m * sp.sin(n * tau)
    return total


def vanishes_to(order, residual):
    """Is every Taylor coefficient of λ up to ``order`` the zero function?"""
    polynomial = sp.Poly(sp.expand(residual), lam)
    return all(sp.expand(polynomial.coeff_monomial(lam**m).rewrite(sp.exp)) == 0
               for m in range(order + 1))


@pytest.mark.parametrize("make", [Duffing, Pendulum, Exponential])
def test_newton_equations_by_sympy(make):
    order = 4 if make is Exponential else 5
    solution = fts.solve(make(), order)
    x, omega = symbolic(solution, "x"), symbolic(solution, "omega")
    force = {Duffing: x + x**3, Pendulum: x - x**3 / 6 + x**5 / 120,
             Exponential: sum(x**k / sp.factorial(k) for k in range(1, 5))}[make]
    assert vanishes_to(order, sp.expand(omega**2 * sp.diff(x, tau, 2) + force))


def test_first_order_system_by_sympy():
    solution = fts.solve(LotkaVolterra(), 4)
    u, v, omega = (symbolic(solution, name) for name in ("u", "v", "omega"))
    assert vanishes_to(4, sp.expand(omega * sp.diff(u, tau) + (1 + u) * v))
    assert vanishes_to(4, sp.expand(omega * sp.diff(v, tau) - (1 + v) * u))


def test_van_der_pol_by_sympy():
    solution = fts.solve(VanDerPol(), 5)
    y, omega = symbolic(solution, "y"), symbolic(solution, "omega")
    assert vanishes_to(5, sp.expand(
        omega**2 * sp.diff(y, tau, 2) + y - (lam**2 - y**2) * omega * sp.diff(y, tau)))


def test_C3_by_sympy_with_the_symbol_a():
    a = sp.Symbol("a", positive=True)
    solution = fts.solve(fts.CubicOscillator(a), 5)
    x, omega = symbolic(solution, "x"), symbolic(solution, "omega")
    residual = omega**2 * sp.diff(x, tau) ** 2 - 4 * (x - 2 * a) * (x - lam + a) * (x + lam + a)
    assert vanishes_to(6, sp.expand(residual))              # squared: one order more than x itself


def test_M1_by_sympy_with_the_symbol_mu():
    mu = sp.Symbol("mu")
    solution = fts.solve(fts.GeneralizedMathieu(), 7)
    psi, a = symbolic(solution, "psi"), symbolic(solution, "a")
    potential = -a + lam**2 * sp.cos(2 * tau) + lam**4 * mu * sp.cos(4 * tau)
    assert vanishes_to(7, sp.expand(sp.diff(psi, tau, 2) - potential * psi))


def test_E3_by_sympy():
    """(E3a) and (E3b) as printed, with the three shifted unknowns written out."""
    solution = fts.solve(fts.FigureEight(), 4)
    series = {name: symbolic(solution, name) for name in ("r", "phi")}
    at = [0, -2 * sp.pi / 3, 2 * sp.pi / 3]                                 # 12, 23, 31
    r12, r23, r31 = (sp.expand_trig(series["r"].subs(tau, tau + s)) for s in at)
    p12, p23, p31 = (sp.expand_trig(series["phi"].subs(tau, tau + s)) for s in at)
    c = sp.cbrt(3)

    def inverse_square(r):
        u = sp.expand(r / c) - 1                                            # r = 3^{1/3} (1 + u)
        return (1 - 2 * u + 3 * u**2) / c**2                                # u = O(λ²)

    def cosine(d):
        return 1 - d**2 / 2 + d**4 / 24

    def sine(d):
        return d - d**3 / 6

    radial = (sp.diff(r12, tau, 2) - r12 * sp.diff(p12, tau) ** 2 + 2 * inverse_square(r12)
              - inverse_square(r31) * cosine(p12 - p31) - inverse_square(r23) * cosine(p12 - p23))
    angular = (r12 * sp.diff(p12, tau, 2) + 2 * sp.diff(r12, tau) * sp.diff(p12, tau)
               + inverse_square(r31) * sine(p12 - p31) + inverse_square(r23) * sine(p12 - p23))
    for residual in (radial, angular):
        expanded = sp.Poly(sp.expand(residual), lam)
        for m in range(5):
            coefficient = expanded.coeff_monomial(lam**m)
            assert sp.simplify(sp.expand(coefficient.rewrite(sp.exp))) == 0
