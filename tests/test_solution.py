"""A solved problem: coefficients of the caller's type, truncation, tables, repr."""

import pickle

import numpy as np
import pytest
import sympy as sp
from flint import arb, ctx
from sample_problems import LotkaVolterra, VanDerPol

import ftseries as fts


@pytest.fixture(scope="module")
def solutions():
    return {name: fts.solve(fts.FigureEight(), 12, name) for name in ("exact", "float", "ball")}


def test_numbers_by_arithmetic(solutions):
    exact, float_, ball = (solutions[name].coefficient("r", 4, 6)
                           for name in ("exact", "float", "ball"))
    assert exact == -29 * sp.cbrt(3) / 49152 and isinstance(exact, sp.Expr)
    assert isinstance(float_, float) and float_ == pytest.approx(float(exact), rel=1e-14)
    assert isinstance(ball, arb)
    with ctx.workprec(400):
        root = (ball * -49152 / 29) ** 3
        assert root.contains(3) and ball.rad() < 1e-35


def test_zero_coefficients_by_arithmetic(solutions):
    for name, zero in (("exact", sp.S.Zero), ("float", 0.0), ("ball", arb(0))):
        for orders in ((3, 4), (9, 6), (4, 2)):
            value = solutions[name].coefficient("r", *orders)
            assert value == zero and type(value) is type(zero)


def test_sine_and_cosine():
    solution = fts.solve(LotkaVolterra(), 3)
    assert solution.coefficient("u", 2, 2, sine=False) == sp.Rational(1, 3)
    assert solution.coefficient("u", 2, 2, sine=True) == sp.Rational(1, 6)
    assert solution.coefficient("u", 0, 2) == 0                     # n = 0 needs no choice
    psi = fts.solve(fts.GeneralizedMathieu(0), 3)
    assert psi.coefficient("psi", 1, 1) == psi.coefficient("psi", 1, 1, sine=True) == 1
    assert psi.coefficient("psi", 1, 1, sine=False) == 0


@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
def test_truncation(solutions, arithmetic):
    solution = solutions[arithmetic]
    cut = solution.truncate(5)
    assert (cut.order, cut.arithmetic, cut.problem, cut.precision) == (
        5, arithmetic, solution.problem, solution.precision)
    assert str(cut.coefficient("phi", 5, 5)) == str(solution.coefficient("phi", 5, 5))
    assert cut.truncate(5).coefficients == cut.coefficients
    assert solution.truncate(8).truncate(3).coefficients == solution.truncate(3).coefficients
    assert solution.order == 12                                     # the original is unchanged
    with pytest.raises(fts.InputError, match="order 5, not to 6"):
        cut.coefficient("r", 0, 6)


def test_evaluation_of_a_truncation_leaves_out_the_rest(solutions):
    """r cut at order 2, by hand: 3^{1/3} (1 - λ²/16 + λ²/8 cos 2t)."""
    t, lam = np.linspace(0, 6, 13), 0.7
    hand = np.cbrt(3) * (1 - lam**2 / 16 + lam**2 / 8 * np.cos(2 * t))
    for solution in solutions.values():
        assert solution.truncate(2).evaluate("r", t, lam=lam) == pytest.approx(hand, abs=1e-15)
        assert solution.truncate(3).evaluate("r", t, lam=lam) == pytest.approx(hand, abs=1e-15)


def test_table(solutions):
    for solution in solutions.values():
        table = solution.table("phi")
        assert table[0, 1] == [0.0, 1.0] + [0.0] * 11
        assert table[0, 5][5] == pytest.approx(-9 / 20480, rel=1e-15)
        table[0, 1][1] = 5.0                                        # a copy: nothing is spoilt
        assert solution.table("phi")[0, 1][1] == 1.0


def test_table_in_the_papers_units():
    solution = fts.solve(fts.CubicOscillator(4), 3)
    assert solution.table("x") == {(0, 0): [-4.0, 0.0, 1 / 48, 0.0],
                                   (0, 1): [0.0, 1.0, 0.0, -1 / 3072],
                                   (0, 2): [0.0, 0.0, -1 / 48, 0.0],
                                   (0, 3): [0.0, 0.0, 0.0, 1 / 3072]}
    assert solution.table("omega")[0, 0] == pytest.approx(
        [2 * 12**0.5, 0, -1 / (64 * 3**0.5), 0], rel=1e-15)


def test_table_with_a_parameter():
    solution = fts.solve(fts.GeneralizedMathieu(), 8)
    assert solution.table("a", mu=0.5)[0, 0] == [1, 0, -1 / 2, 0, -1 / 32, 0, 17 / 512, 0,
                                                 (-256 - 32 - 1) / 24576]


def test_time_is_the_time_and_not_the_phase():
    """x has the period 2π/ω."""
    for problem in (fts.CubicOscillator(), VanDerPol()):
        solution = fts.solve(problem, 14)
        name = next(iter(problem.unknowns))
        period = 2 * np.pi / solution.evaluate("omega", lam=0.6)
        t = np.linspace(0, 1, 5)
        assert solution.evaluate(name, t + period, lam=0.6) == pytest.approx(
            solution.evaluate(name, t, lam=0.6), abs=1e-13)
        assert abs(solution.evaluate(name, 0.2 + np.pi, lam=0.6)
                   - solution.evaluate(name, 0.2 + np.pi + period / 2, lam=0.6)) > 1e-3


@pytest.mark.parametrize("problem", [fts.FigureEight(), fts.GeneralizedMathieu()])
def test_solutions_travel_between_processes(problem):
    solution = fts.solve(problem, 9)
    back = pickle.loads(pickle.dumps(solution))
    assert back.coefficients == solution.coefficients and repr(back) == repr(solution)


def test_repr(solutions):
    assert repr(solutions["exact"]) == "<Solution of FigureEight(), order 12, exact>"
    assert repr(solutions["ball"]) == "<Solution of FigureEight(), order 12, ball, precision=128>"


@pytest.mark.parametrize("a", ["2/3", 2, sp.sqrt(2)])
@pytest.mark.parametrize("arithmetic", ["float", "ball"])
def test_units_in_other_arithmetics(a, arithmetic):
    exact = fts.solve(fts.CubicOscillator(a), 7)
    other = fts.solve(fts.CubicOscillator(a), 7, arithmetic, precision=200)
    for m in range(8):
        pairs = [(exact.coefficient("omega", m), other.coefficient("omega", m))]
        pairs += [(exact.coefficient("x", n, m), other.coefficient("x", n, m))
                  for n in range(m + 1)]
        for true, value in pairs:
            assert float(value) == pytest.approx(float(true), rel=1e-14, abs=0)
