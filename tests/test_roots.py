"""Polynomial equations with roots of few kinds."""

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

import ftseries as fts
from ftseries.roots import Roots, vanishes

X, Y, Z, MU = sp.symbols("x y z mu")
small = st.integers(-4, 4)


@settings(max_examples=25)
@given(st.lists(small, min_size=1, max_size=4))
def test_rational_roots_come_back(values):
    roots = Roots()
    found = roots.solve([sp.expand(sp.prod([X - v for v in values]))], [X])
    assert sorted(s[X] for s in found) == sorted(set(values)) and not roots.left


@settings(max_examples=25, deadline=None)
@given(st.lists(small, min_size=5, max_size=5))
def test_two_conics_have_the_real_solutions_that_sympy_finds(c):
    system = [X**2 + c[0] * Y + c[1], X * Y + c[2] * X + c[3] * Y + c[4]]
    roots = Roots()
    found = roots.solve(system, [X, Y])
    for s in found:
        assert all(vanishes(sp.expand(e.xreplace(s))) for e in system if len(s) == 2)
    if not roots.left and found and all(len(s) == 2 for s in found):
        real = [s for s in sp.solve(system, [X, Y], dict=True)
                if all(abs(sp.im(sp.N(v, 30))) < 1e-20 for v in s.values())]
        assert len(found) == len(real)


@pytest.mark.parametrize("polynomial, values", [
    (X**3 - 3, [sp.cbrt(3)]), (X**3 + 8, [-2]), (X**2 + 1, []), ((X - 2)**3, [2]),
    (X**4 - 8 * X**2 + 11, [sp.sqrt(4 - sp.sqrt(5)), -sp.sqrt(4 - sp.sqrt(5)),
                            sp.sqrt(4 + sp.sqrt(5)), -sp.sqrt(4 + sp.sqrt(5))]),
    (X**6 - 2, [2**sp.Rational(1, 6), -2**sp.Rational(1, 6)]), (X**2 - 6 * X + 9, [3]),
    (X**2 - 2 * sp.sqrt(2) * X + 2, [sp.sqrt(2)]), (MU * X**2 - X, [0, 1 / MU])])
def test_the_roots_of_one_polynomial(polynomial, values):
    found = Roots().solve([sp.expand(polynomial)], [X])
    assert {sp.simplify(s[X]) for s in found} == set(map(sp.sympify, values))


def test_what_is_too_hard_is_left():
    roots = Roots()
    assert roots.solve([X * (X**3 - X + 1)], [X]) == [{X: 0}]
    assert roots.solve([X**4 - X + 1], [X]) == []                 # it has no real root
    assert roots.left == [X**3 - X + 1]


def test_what_stays_free_is_missing():
    assert Roots().solve([X - 2 * Y], [X, Y]) == [{X: 2 * Y}]
    assert Roots().solve([X**2 + Y**2 - 4], [X, Y]) == [{}]
    assert Roots().solve([], [X]) == [{}]


def test_contradictions_have_no_solution():
    assert Roots().solve([X - 1, X - 2], [X]) == []
    assert Roots().solve([X - 1, MU], [X]) == []


def test_too_many_solutions_are_refused_at_once():
    with pytest.raises(fts.InputError, match="too many solutions"):
        Roots().solve([X**4 + Y**3 + Z + 1, X + Y**4 + Z**3 - 2, X**3 + Y + Z**4 + 5], [X, Y, Z])


def test_a_product_of_many_factors_is_bounded():
    system = [sp.expand(sp.prod([s - k for k in range(8)])) for s in (X, Y, Z)]
    with pytest.raises(fts.InputError, match="too many solutions"):
        Roots().solve(system, [X, Y, Z])
