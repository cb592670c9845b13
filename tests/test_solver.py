"""One solver for every problem: closed forms and published series that share nothing with it."""

from fractions import Fraction

import flint
import numpy as np
import pytest
import sympy as sp
from flint import fmpq, fmpq_series
from sample_problems import (
    Coupled,
    Duffing,
    Exponential,
    LotkaVolterra,
    MassOnSpring,
    Pendulum,
    Quotient,
    Relativistic,
    VanDerPol,
)
from scipy.integrate import solve_ivp

import ftseries as fts
from ftseries import Field, Problem

TERMS = 32


@pytest.fixture
def series_cap():
    """FLINT keeps TERMS terms of a power series."""
    cap, flint.ctx.cap = flint.ctx.cap, TERMS
    yield
    flint.ctx.cap = cap


def rational(c):
    return sp.Rational(int(c.p), int(c.q))


def theta_3(s):
    """θ₃ as a series in the nome s."""
    squares = {k * k for k in range(TERMS)}
    return fmpq_series([1] + [2 if m in squares else 0 for m in range(1, TERMS)])


def theta_2_to_the_4(s):
    """θ₂⁴ = 16 s (Σ s^{k(k+1)})⁴."""
    steps = {k * (k + 1) for k in range(TERMS)}
    return 16 * s * fmpq_series([1 if m in steps else 0 for m in range(TERMS)]) ** 4


def in_lambda_squared(of_s, lambda_squared_of_s):
    """A series in the nome s as a series in λ², by reversion."""
    return of_s(lambda_squared_of_s.reversion())


class TestPendulum:
    """θ = 8 Σ (-1)^{(n-1)/2} p^n/(n (1 + p^{2n})) cos nτ, ω = θ₃(p²)⁻² with the nome p²."""

    order = 31

    def test_every_coefficient(self, series_cap):
        s, one = fmpq_series([0, 1]), fmpq_series([1])
        lambda_squared = 64 * s / (one + s) ** 2                       # λ = 8p/(1 + p²), s = p²
        solution = fts.solve(Pendulum(), self.order)
        omega = in_lambda_squared(one / theta_3(s) ** 2, lambda_squared)
        for k in range(self.order // 2 + 1):
            assert solution.coefficient("omega", 2 * k) == rational(omega[k])
        for n in range(3, self.order + 1, 2):
            half = (n - 1) // 2
            ratio = (-1) ** half * s**half * (one + s) / (n * (one + s**n))        # A_n/λ
            ratio = in_lambda_squared(ratio, lambda_squared)
            for k in range((self.order - 1) // 2 + 1):
                assert solution.coefficient("x", n, 2 * k + 1) == rational(ratio[k])

    def test_period_from_the_elliptic_integral(self):
        """ω = π/2K(sin θ₀/2), the amplitude θ₀ being x(0): no nome at all."""
        from scipy.special import ellipk
        solution = fts.solve(Pendulum(), 60)
        for lam in (0.3, 1.0, 1.8):
            amplitude = solution.evaluate("x", 0, lam=lam)
            assert solution.evaluate("omega", lam=lam) == pytest.approx(
                np.pi / 2 / ellipk(np.sin(amplitude / 2) ** 2), rel=1e-12)

    def test_low_orders_in_the_amplitude_of_the_first_mode(self):
        solution = fts.solve(Pendulum(), 4)
        assert [solution.coefficient("omega", m) for m in (0, 2, 4)] == [
            1, -sp.Rational(1, 16), sp.Rational(1, 1024)]


def test_duffing_every_coefficient(series_cap):
    """x = A cn: λ² = 32 s/((1 + s)²(θ₃⁴ - 2θ₂⁴)), ω⁻² = θ₃⁴ - 2θ₂⁴,
    A_n/λ = p^{n-1}(1 + s)/(1 + sⁿ), s = p² the nome."""
    order = 31
    s, one = fmpq_series([0, 1]), fmpq_series([1])
    inverse = theta_3(s) ** 4 - 2 * theta_2_to_the_4(s)
    lambda_squared = 32 * s / ((one + s) ** 2 * inverse)
    solution = fts.solve(Duffing(), order)
    omega = in_lambda_squared((one / inverse).sqrt(), lambda_squared)
    for k in range(order // 2 + 1):
        assert solution.coefficient("omega", 2 * k) == rational(omega[k])
    for n in range(3, order + 1, 2):
        ratio = in_lambda_squared(s ** ((n - 1) // 2) * (one + s) / (one + s**n), lambda_squared)
        for k in range((order - 1) // 2 + 1):
            assert solution.coefficient("x", n, 2 * k + 1) == rational(ratio[k])


class TestVanDerPol:
    """Andersen and Geer 1982: ω = 1 - ε²/16 + 17ε⁴/3072 + 35ε⁶/884736 - …, ε = λ²."""

    def test_frequency(self):
        solution = fts.solve(VanDerPol(), 24)
        computed = [solution.coefficient("omega", 4 * k) for k in range(4)]
        assert computed == [1, -sp.Rational(1, 16), sp.Rational(17, 3072),
                            sp.Rational(35, 884736)]
        assert not any(solution.coefficients["omega"][m] for m in range(25) if m % 4)

    def test_the_amplitude_settled_two_orders_late(self):
        """y/λ = 2 cos τ + ε (¾ sin τ - ¼ sin 3τ) + …, with the phase moved to y ~ cos τ."""
        solution = fts.solve(VanDerPol(), 5)
        assert solution.coefficient("y", 1, 1, sine=False) == 2
        assert solution.coefficient("y", 3, 3, sine=True) == -sp.Rational(1, 4)
        assert solution.coefficient("y", 1, 3, sine=False) == 0
        # the equation itself is checked by SymPy in test_agreement; here: settled, and not by zero
        assert solution.coefficient("y", 1, 5, sine=False) != 0

    @pytest.mark.parametrize("wrong", [1, 3, -1])
    def test_another_leading_amplitude_is_contradicted(self, wrong):
        """Solvability at order 3: A (1 - A²/4) = 0."""
        class Wrong(VanDerPol):
            seed = {"y": [{}, {(0, 1): wrong}], "omega": [1]}
        del Problem.classes["Wrong"]
        with pytest.raises(fts.SolveError, match="order"):
            fts.solve(Wrong(), 6)

    def test_the_limit_cycle_by_integration(self):
        """ε = 1/4: DOP853 runs onto the cycle; its period and amplitude."""
        lam = 0.5
        solution = fts.solve(VanDerPol(), 60)
        omega = solution.evaluate("omega", lam=lam)
        T = 2 * np.pi / omega
        t = np.linspace(0, T, 9)
        y = solution.evaluate("y", t, lam=lam)
        before, after = solution.evaluate("y", [-1e-4, 1e-4], lam=lam)
        slope = (after - before) / 2e-4
        run = solve_ivp(lambda t, u: [u[1], -u[0] + (lam**2 - u[0] ** 2) * u[1]], (0, T),
                        [y[0], slope], method="DOP853", t_eval=t, rtol=1e-13, atol=1e-13)
        assert np.abs(run.y[0] - y).max() < 1e-8                     # the slope is good to 1e-8


def test_lotka_volterra_by_integration():
    """One period from (u, v)(0) comes back, and follows the series in between."""
    lam = 0.4
    solution = fts.solve(LotkaVolterra(), 40)
    T = 2 * np.pi / solution.evaluate("omega", lam=lam)
    t = np.linspace(0, T, 17)
    u, v = solution.evaluate("u", t, lam=lam), solution.evaluate("v", t, lam=lam)
    run = solve_ivp(lambda t, z: [-(1 + z[0]) * z[1], (1 + z[1]) * z[0]], (0, T), [u[0], v[0]],
                    method="DOP853", t_eval=t, rtol=1e-13, atol=1e-13)
    assert np.abs(run.y - [u, v]).max() < 1e-11
    # the first integral is constant along the orbit
    H = u - np.log1p(u) + v - np.log1p(v)
    assert np.ptp(H) < 1e-13


def test_lotka_volterra_frequency():
    """T = 2π(1 + h/6 + …) with the energy h = λ²/2 + … (Volterra): ω = 1 - λ²/12 + …"""
    solution = fts.solve(LotkaVolterra(), 2)
    assert solution.coefficient("omega", 2) == -sp.Rational(1, 12)


def test_exponential_oscillator_by_hand():
    """Toda's particle to order 3 by hand: ω = 1 - λ²/24 + …"""
    solution = fts.solve(Exponential(), 3)
    # mode 0: x₀ = -λ²/4; mode 2: λ²/12; mode 1 at λ³: -2ω₂ + (x₀ + x₂/2) + 1/8 = 0
    assert solution.coefficient("x", 0, 2) == -sp.Rational(1, 4)
    assert solution.coefficient("x", 2, 2) == sp.Rational(1, 12)
    assert solution.coefficient("omega", 2) == sp.Rational(1, 2) * (
        -sp.Rational(1, 4) + sp.Rational(1, 24) + sp.Rational(1, 8))


@pytest.mark.parametrize("kind, energy", [
    (Exponential, lambda x, p: p**2 / 2 + np.exp(x) - x),
    (Quotient, lambda x, p: p**2 / 2 + np.log1p(x**2) / 2),
    (Relativistic, lambda x, p: 1 / np.sqrt(1 - p**2) + x**2 / 2),
    (Duffing, lambda x, p: p**2 / 2 + x**2 / 2 + x**4 / 4),
])
def test_energy_is_conserved(kind, energy):
    """A first integral the equations do not mention; p by a spectral derivative."""
    lam = 0.3
    solution = fts.solve(kind(), 40)
    omega = solution.evaluate("omega", lam=lam)
    tau = 2 * np.pi * np.arange(128) / 128
    x = solution.evaluate("x", tau / omega, lam=lam)
    n = np.fft.rfftfreq(128, 1 / 128)
    p = np.fft.irfft(1j * n * omega * np.fft.rfft(x), 128)
    assert np.ptp(energy(x, p)) < 1e-13


def test_two_coupled_oscillators_in_their_linear_mode():
    """y starts as x; at order 2 by hand: (2 - ω²)y = x and 3/4 λ² of x³ give ω₂ = 3/16."""
    solution = fts.solve(Coupled(), 3)
    assert solution.coefficient("y", 1, 1) == 1
    assert solution.coefficient("omega", 2) == sp.Rational(3, 16)
    # y_1 = x_1/(2 - ω²): its λ³ coefficient is d(1/(2-ω²)) = 2 ω₂ = 3/8
    assert solution.coefficient("y", 1, 3) == sp.Rational(3, 8)


def test_a_parameter_of_ones_own():
    """μ x³ in place of x³: λ² and μ enter as μλ² alone."""
    mu = sp.Symbol("mu")
    symbolic, plain = fts.solve(MassOnSpring(), 9), fts.solve(Duffing(), 9)
    for m in range(0, 9, 2):
        assert sp.expand(symbolic.coefficient("omega", m)
                         - plain.coefficient("omega", m) * mu ** (m // 2)) == 0
    for n in range(1, 10, 2):
        for m in range(n, 10, 2):
            assert sp.expand(symbolic.coefficient("x", n, m)
                             - plain.coefficient("x", n, m) * mu ** ((m - 1) // 2)) == 0


class Printed(fts.FigureEight):
    """(E3a), (E3b) letter by letter, with the shifts (E5b), (E5d): over Q(√3)."""

    surd = True

    def equations(self, lam, r, phi):
        third = Fraction(1, 3)
        r23, r31, p23, p31 = (u.shift(s) for u in (r, phi) for s in (-third, third))
        a, b = r31**-2 / 3, r23**-2 / 3
        return {"(E3a)": r.diff(2) - (r * phi.diff()**2 - 2 * r**-2 / 3 + a * fts.cos(phi - p31)
                                      + b * fts.cos(phi - p23)),
                "(E3b)": phi.diff(2) - r**-1 * (-2 * r.diff() * phi.diff()
                                                - a * fts.sin(phi - p31) - b * fts.sin(phi - p23))}


del Problem.classes["Printed"]


@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
def test_E3_letter_by_letter(arithmetic):
    """The declaration by projections and the printed one have one solution; √3 cancels."""
    printed = fts.solve(Printed(), 14, arithmetic)
    short = fts.solve(fts.FigureEight(), 14, arithmetic)
    for name, rows in short.coefficients.items():
        for row, other in zip(rows, printed.coefficients[name], strict=True):
            for mode in set(row) | set(other):
                x, y = row.get(mode, 0), other.get(mode, 0)
                if arithmetic == "exact":
                    assert x == y
                elif arithmetic == "ball":
                    assert flint.arb(x).overlaps(flint.arb(y))
                else:
                    assert x == pytest.approx(y, abs=1e-15)


def test_a_root_of_three_that_stays():
    class Turned(Problem):
        unknowns = {"x": Field("both")}
        seed = {"x": [{}]}
        surd = True

        def equations(self, lam, x):
            return {"(turned)": x - (lam * lam.expansion.cos(1)).shift(Fraction(1, 12))}
    del Problem.classes["Turned"]
    with pytest.raises(fts.SolveError, match="x at order 1 contains √3"):
        fts.solve(Turned(), 3)


def test_a_linear_forced_equation():
    """x″ + 2x = λ cos τ + λ³ cos 3τ: x = λ cos τ - λ³/7 cos 3τ, and nothing else."""
    class Forced(Problem):
        unknowns = {"x": Field("cos")}
        seed = {"x": [{}]}

        def equations(self, lam, x):
            e = lam.expansion
            return {"(forced)": x.diff(2) + 2 * x - lam * e.cos(1) - lam**3 * e.cos(3)}
    del Problem.classes["Forced"]
    assert [dict(row) for row in fts.solve(Forced(), 4).coefficients["x"]] == [
        {}, {(0, 1): 1}, {}, {(0, 3): fmpq(-1, 7)}, {}]


def test_an_algebraic_equation_without_time():
    """x² = 1 + λ: the binomial series; no derivative anywhere."""
    class Root(Problem):
        unknowns = {"x": fts.Scalar()}
        seed = {"x": [1]}

        def equations(self, lam, x):
            return {"(root)": x * x - 1 - lam}
    del Problem.classes["Root"]
    solution = fts.solve(Root(), 9)
    assert [solution.coefficient("x", m) for m in range(10)] == [
        sp.binomial(sp.Rational(1, 2), m) for m in range(10)]


def test_more_equations_than_unknowns():
    """A consequence of the others does no harm: Duffing's equation with its energy integral."""
    class Both(Duffing):
        unknowns = Duffing.unknowns | {"E": fts.Scalar("even")}
        seed = Duffing.seed | {"E": [0, 0, Fraction(1, 2)]}

        def equations(self, lam, x, omega, E):
            return super().equations(lam, x, omega) | {
                "(energy)": (omega * x.diff()) ** 2 / 2 + x**2 / 2 + x**4 / 4 - E}
    del Problem.classes["Both"]
    both, one = fts.solve(Both(), 13), fts.solve(Duffing(), 13)
    assert both.coefficients["x"] == one.coefficients["x"]
    assert both.coefficients["omega"] == one.coefficients["omega"]


def test_a_longer_seed_changes_nothing():
    full = fts.solve(fts.CubicOscillator(), 12)

    class Longer(fts.CubicOscillator):
        seed = {"x": [{n: c for (_, n), c in row.items()} for row in full.coefficients["x"][:6]],
                "omega": [row.get((0, 0), 0) for row in full.coefficients["omega"][:4]]}
    del Problem.classes["Longer"]
    assert fts.solve(Longer(), 12).coefficients == full.coefficients


def test_progress_is_silent_below_seconds(capsys):
    fts.solve(fts.FigureEight(), 20)
    captured = capsys.readouterr()
    assert captured.out == "" and captured.err == ""


def test_progress_reports_every_order(monkeypatch):
    from ftseries import solver
    seen = []

    class Bar:
        def __init__(self, **options):
            seen.append(options)

        def __enter__(self):
            return self

        def __exit__(self, *_):
            pass

        def update(self):
            seen.append(1)

    monkeypatch.setattr(solver, "tqdm", Bar)
    fts.solve(fts.FigureEight(), 20)
    assert seen[0]["total"] == 20 and sum(seen[1:]) == 20 and not seen[0]["disable"]
    seen.clear()
    fts.solve(fts.FigureEight(), 30, "float", progress=False)
    assert seen[0]["disable"] and sum(seen[1:]) == 30


class Staggered(Problem):
    """Three linear equations that agree at λ = 0: what one order leaves open, the next two settle.

    The solution is p = 1/(1 - λ), q = √(1 + λ), r = e^λ, from which the right sides are made.
    """

    unknowns = {"p": fts.Scalar(), "q": fts.Scalar(), "r": fts.Scalar()}
    seed = {"p": [1], "q": [1], "r": [1]}

    def equations(self, lam, p, q, r):
        def left(p, q, r):
            first = p + 2 * q + 3 * r
            return {"(1)": first, "(2)": first + lam * (p - q + 2 * r) + lam**2 * q,
                    "(3)": first + lam * (2 * p - 2 * q + 4 * r) + lam**2 * (2 * p + 3 * q - r)}
        right = left((1 - lam) ** -1, (1 + lam) ** sp.Rational(1, 2), fts.exp(lam))
        return {name: value - right[name] for name, value in left(p, q, r).items()}


def test_what_several_orders_leave_open_is_settled_together():
    solution, lam = fts.solve(Staggered(), order=12), sp.Symbol("lam")
    for name, f in (("p", 1 / (1 - lam)), ("q", sp.sqrt(1 + lam)), ("r", sp.exp(lam))):
        taylor = sp.series(f, lam, 0, 13).removeO()
        assert [solution.coefficient(name, m) for m in range(13)] == [
            taylor.coeff(lam, m) for m in range(13)]


@pytest.mark.parametrize("arithmetic, order, said", [
    ("float", 72, "stay below about 73"), ("exact", 25, "stay below about 26"),
    ("ball", 20, "and precision=128 stay below about 21"),
])
def test_the_largest_order_for_a_memory_of_one_mebibyte(monkeypatch, arithmetic, order, said):
    """2 unknowns · 24 nodes · (order + 1)²/2 numbers of 8, 64 and 64 + 128/4 bytes."""
    monkeypatch.setattr("os.sysconf", {"SC_PAGE_SIZE": 4096, "SC_PHYS_PAGES": 256}.__getitem__)
    assert fts.solve(fts.CubicOscillator(), order, arithmetic).order == order
    with pytest.raises(fts.FTSeriesError, match=said):
        fts.solve(fts.CubicOscillator(), order + 1, arithmetic)
