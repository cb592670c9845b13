"""Values in balls: they contain sums made without this package, and nothing wider is silent."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

import ftseries as fts
from ftseries.errors import InputError


@pytest.fixture(scope="module")
def cubic():
    return fts.solve(fts.CubicOscillator(), 12)


@pytest.fixture(scope="module")
def balls():
    return fts.solve(fts.CubicOscillator(), 12, "ball", precision=60)


def by_hand(solution, lam, t, derivative=0):
    """The truncated series of the cubic oscillator, from its exact coefficients, by mpmath."""
    def number(x):
        return mpmath.mpmathify(x.evalf(mpmath.mp.dps))
    omega = sum(number(solution.coefficient("omega", m)) * lam**m for m in range(13))
    return sum(number(solution.coefficient("x", n, m)) * lam**m * (n * omega)**derivative
               * mpmath.cos(n * omega * t + derivative * mpmath.pi / 2)
               for m in range(13) for n in range(m + 1))


def contains(ball, number):
    """Is an mpmath number, which is right to 1e-80, in the ball?"""
    with mpmath.workdps(100):
        return ball.overlaps(arb(mpmath.nstr(number, 90), "1e-80"))


@pytest.mark.parametrize("lam, t", [("0.5", "0.3"), ("-1.7", "2.5"), ("0.1", "1e6")])
@pytest.mark.parametrize("derivative", [0, 1, 2])
def test_the_ball_contains_the_sum(cubic, balls, lam, t, derivative):
    with mpmath.workdps(100):
        value = by_hand(cubic, mpmath.mpf(lam), mpmath.mpf(t), derivative)
    exact = cubic.enclosure("x", t, lam=lam, derivative=derivative, precision=300)
    assert contains(exact, value) and exact.rad() < 1e-75
    wide = balls.enclosure("x", t, lam=lam, derivative=derivative)
    assert contains(wide, value) and exact.rad() < wide.rad() < 1e-5


def test_numbers_mean_what_they_look_like(cubic):
    """0.1 is 1/10 in every form; the binary neighbour, given as a ball of its bits, is another."""
    values = [cubic.enclosure("omega", lam=lam, precision=200) for lam in
              (0.1, "0.1", Fraction(1, 10), fmpq(1, 10), sp.Rational(1, 10), np.float64(0.1))]
    assert all(value.overlaps(values[0]) for value in values)
    assert not cubic.enclosure("omega", lam=arb(0.1), precision=200).overlaps(values[0])
    root = cubic.enclosure("omega", lam=sp.sqrt(2) / 10, precision=200)
    assert root.overlaps(cubic.enclosure("omega", lam=mpmath.sqrt(2) / 10).union(root))


@given(st.floats(-1, 1), st.floats(-1, 1))
@settings(max_examples=30)
def test_a_ball_for_lambda_and_for_t_means_all_its_points(cubic, a, b):
    wide = cubic.enclosure("x", arb(0.3, 0.01), lam=arb(0.5, 0.02))
    t, lam = arb(0.3) + arb(0.0099) * a, arb(0.5) + arb(0.0199) * b
    assert wide.contains(cubic.enclosure("x", t, lam=lam).mid())


def test_arrays_of_balls(cubic):
    values = cubic.enclosure("x", [[0.1], [0.2]], lam=["0.1", "0.2", "0.3"])
    assert values.shape == (2, 3) and isinstance(values[1, 2], arb)
    assert values[1, 2].overlaps(cubic.enclosure("x", 0.2, lam=0.3))
    assert isinstance(cubic.enclosure("x", 0.2, lam=0.3), arb)


def test_units_and_parameters_and_cut_solutions():
    """ω is √a ω(1) and x is a x(1) at a = 1/3; μ is exact, too."""
    soft = fts.solve(fts.CubicOscillator(Fraction(1, 3)), 8)
    one = fts.solve(fts.CubicOscillator(), 10).truncate(8)
    ratio = soft.enclosure("omega", lam="0.1") / one.enclosure("omega", lam="0.3")
    assert (ratio**2 * 3).contains(1) and soft.enclosure("omega", lam="0.1").rad() < 1e-35
    free, fixed = (fts.solve(fts.GeneralizedMathieu(*mu), 8) for mu in ([], ["0.1"]))
    values = [free.enclosure("psi", 1, lam=1, mu=0.1, precision=300),
              fixed.enclosure("psi", 1, lam=1, precision=300)]
    assert values[0].overlaps(values[1]) and values[0].rad() < 1e-80


@pytest.mark.parametrize("ask, words", [
    (lambda s: s.enclosure("x", lam=0.1), "depends on time"),
    (lambda s: s.enclosure("omega", 1, lam=0.1), "leave t out"),
    (lambda s: s.enclosure("y", 1, lam=0.1), "not an unknown"),
    (lambda s: s.enclosure("omega", lam=0.1, mu=1), "no parameters"),
    (lambda s: s.enclosure("omega", lam=0.1, precision=1), "precision=1"),
    (lambda s: s.enclosure("omega", lam="a"), "'a' is not a rational"),
    (lambda s: s.enclosure("omega", lam=float("nan")), "nan is not a rational"),
    (lambda s: s.enclosure("omega", lam=sp.Symbol("a")), "not a rational|not made of rationals"),
    (lambda s: s.enclosure("x", [1, 2], lam=[1, 2, 3]), "do not broadcast"),
])
def test_what_has_no_ball(cubic, ask, words):
    with pytest.raises(InputError, match=words):
        ask(cubic)


def test_floats_have_no_ball():
    solution = fts.solve(fts.CubicOscillator(), 4, "float")
    with pytest.raises(InputError, match="arithmetic='exact' or 'ball'"):
        solution.enclosure("omega", lam=0.1)


def test_of_many_places_the_worst_is_told():
    """At λ = 2.7 nothing is left of what λ = 0.5 has."""
    sol = fts.solve(fts.CubicOscillator(), 60, "ball", precision=53)
    with pytest.warns(fts.PrecisionWarning, match="leave 0 of 15 digits"):
        sol.evaluate("omega", lam=[0.5, 2.7])
    with pytest.warns(fts.PrecisionWarning, match="leave 0 of 15 digits"):
        sol.evaluate("omega", lam=[-2.7, 0.5])
