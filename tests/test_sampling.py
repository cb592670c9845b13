"""Functions on a grid have the operations of series: each is compared with its definition."""

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given

import ftseries as fts
from ftseries.sampling import Samples

GRID = Samples(32, lam=0.5)
numbers = st.floats(-2, 2)
modes = st.dictionaries(st.integers(0, 7), st.tuples(numbers, numbers), min_size=1, max_size=4)


def build(samples, coefficients):
    total = samples.constant(0)
    for n, (a, b) in coefficients.items():
        total = total + a * samples.cos(n) + b * samples.sin(n)
    return total


def values(coefficients, tau, derivative=0):
    turn = derivative * np.pi / 2
    return sum(float(n) ** derivative * (a * np.cos(n * tau + turn) + b * np.sin(n * tau + turn))
               for n, (a, b) in coefficients.items())


@given(modes, modes)
def test_arithmetic_is_pointwise(f, g):
    u, v = build(GRID, f), build(GRID, g)
    x, y = values(f, GRID.tau), values(g, GRID.tau)
    for ours, theirs in ((u + v, x + y), (u - v, x - y), (u * v, x * y), (2 - u, 2 - x), (-u, -x),
                         (3 * u / 2, 1.5 * x), (u**2, x * x), ((u**2 + 1) ** -2, (x * x + 1) ** -2),
                         (2 / (u**2 + 1), 2 / (x * x + 1)), (u.sin(), np.sin(x)),
                         (u.cos(), np.cos(x)), (u.exp(), np.exp(x))):
        assert np.allclose(ours.values, theirs, rtol=1e-12, atol=1e-12)


@given(modes, st.sampled_from([1, 2]))
def test_derivatives(f, times):
    found = build(GRID, f).diff(times).values
    assert np.abs(found - values(f, GRID.tau, times)).max() < 1e-11


@given(modes, st.fractions(-1, 1, max_denominator=6))
def test_shift(f, fraction):
    from ftseries.arguments import rational
    found = build(GRID, f).shift(rational(fraction)).values
    assert np.abs(found - values(f, GRID.tau + 2 * np.pi * float(fraction))).max() < 1e-12


@given(modes)
def test_neighbours_are_the_two_other_bodies(f):
    u = build(GRID, f)
    others = values(f, GRID.tau + 2 * np.pi / 3) + values(f, GRID.tau - 2 * np.pi / 3)
    assert np.abs(u.neighbours().values - others).max() < 1e-12


@given(modes)
def test_a_step_along_i_is_the_exact_derivative(f):
    """Im g(u + ih)/h for g = u² u'' has no cancellation; compared with 2 u u'' + 0 by hand."""
    h = 1e-30
    u = build(GRID, f)
    moved = u + 1j * h
    slope = (moved * moved * moved.diff(2)).values.imag / h
    assert np.abs(slope - (2 * u * u.diff(2)).values).max() < 1e-9


def test_leading_axes():
    many = Samples(16, np.array([0.0, 1.0, 2.0]))
    assert (many.lam * many.cos(1)).values.shape == (3, 16)
    assert np.allclose((many.lam**2 + 1).values[:, 0], [1, 2, 5])


def test_equations_vanish_on_known_solutions():
    """sin x with a = 1 at λ = 0; the seed of the eight at rest."""
    grid = Samples(32, lam=0.0)
    residual = fts.GeneralizedMathieu(mu=0).equations(grid.lam, grid.sin(1), grid.constant(1))
    assert np.abs(residual["(M1)"].values).max() < 1e-13
    rest = fts.FigureEight().equations(grid.lam, grid.constant(1), grid.constant(0))
    assert max(np.abs(r.values).max() for r in rest.values()) < 1e-15


def test_the_third_derivative_is_refused():
    with pytest.raises(fts.InputError, match="order 3"):
        GRID.cos(1).diff(3)
