"""Composition, reversion and Euler's map: algebraic laws and known expansions."""

import math

import hypothesis.strategies as st
import pytest
from flint import arb, ctx, fmpq
from hypothesis import given

from ftseries import InputError
from ftseries.analysis import compose, euler_map, nearest_singularities, revert

rationals = st.fractions(-2, 2, max_denominator=5).map(lambda f: fmpq(f.numerator, f.denominator))
tails = st.lists(rationals, min_size=6, max_size=14)


@given(tails, st.sampled_from([fmpq(1), fmpq(-2), fmpq(1, 3)]))
def test_reversion_is_the_inverse_of_composition(tail, slope):
    c = [fmpq(0), slope, *tail]
    identity = [fmpq(0), fmpq(1)] + [fmpq(0)] * len(tail)
    assert compose(c, revert(c)) == compose(revert(c), c) == identity
    assert revert(revert(c)) == c


@given(tails, tails, tails)
def test_composition_is_associative(f, g, h):
    n = min(map(len, (f, g, h)))
    f, g, h = f[:n], [fmpq(0), *g[1:n]], [fmpq(0), *h[1:n]]
    assert compose(compose(f, g), h) == compose(f, compose(g, h))


def test_long_series_are_not_cut():
    """python-flint's own cap is 10 terms."""
    log = [fmpq(0)] + [fmpq((-1) ** (k + 1), k) for k in range(1, 41)]
    exp = [fmpq(0)] + [fmpq(1, math.factorial(k)) for k in range(1, 41)]
    assert revert(log) == exp and compose(log, exp) == [0, 1] + [0] * 39
    assert ctx.cap == 10


def test_euler_map_takes_the_logarithm_beyond_its_radius():
    log = [fmpq(0)] + [fmpq((-1) ** (k + 1), k) for k in range(1, 61)]
    d, w = euler_map(log, 1)
    assert d == [0] + [fmpq(1, k) for k in range(1, 61)]            # ln(1 + z) = -ln(1 - w)
    total = sum(float(int(x.p) / int(x.q)) * w(2.0) ** k for k, x in enumerate(d))
    assert abs(total - math.log(3)) < 1e-12                         # |w| = 2/3: (2/3)^60/60


def test_euler_map_moves_the_singularity():
    """sqrt(1 + z) = (1 - w)^{-1/2}."""
    c = [fmpq(1)]
    for k in range(1, 31):
        c.append(c[-1] * fmpq(3 - 2 * k, 2 * k))
    (s,) = nearest_singularities(euler_map(c, 1)[0])
    assert abs(s.location - 1) < 1e-13 and abs(s.exponent + 0.5) < 1e-13


def test_floats_and_balls():
    catalan = revert([0.0, 1.0, -1.0] + [0.0] * 20)
    assert all(isinstance(x, float) for x in catalan)
    assert catalan == [0] + [math.comb(2 * k, k) / (k + 1) for k in range(22)]
    assert revert([arb(0), arb(1), arb(-1), arb(0)])[3].contains(2)


@pytest.mark.parametrize("call, word", [
    (lambda: compose([1, 1], [1, 1]), "vanish"), (lambda: compose([1, 1], []), "vanish"),
    (lambda: revert([1, 1]), "vanish"), (lambda: revert([0, 0, 1]), "not zero"),
    (lambda: revert([0]), "not zero"), (lambda: euler_map([1, 1], 0), "p=0"),
    (lambda: euler_map([1, 1], "pole"), "rational"),
])
def test_impossible_maps_are_refused(call, word):
    with pytest.raises(InputError, match=word):
        call()
