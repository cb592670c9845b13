"""The sequence algebra: every operation's result contains what it stands for."""

import numpy as np
import pytest
from flint import arb, ctx
from hypothesis import given
from hypothesis import strategies as st

from ftseries.certify import NotProved
from ftseries.certify.algebra import RING, Enclosure, largest_of, norm, upper
from ftseries.certify.balls import at_least, at_most

NU = arb("1.1")
SUMS = st.dictionaries(st.tuples(st.integers(0, 1), st.integers(1, 6)), st.floats(-1, 1),
                       min_size=1, max_size=4)
TIMES = np.linspace(0, 6, 7)


def enclosure(modes, radius=0):
    return Enclosure(RING.from_modes({m: arb(c) for m, c in modes.items()}), radius, NU)


def value(modes, t):
    return sum(arb(c) * (arb(n * t).sin() if sine else arb(n * t).cos())
               for (sine, n), c in modes.items())


def at(function, t):
    """Values at t of all functions in an enclosure: the norm bounds the absolute value."""
    return value(function.center.modes(), t) + arb(0, function.radius)


@given(SUMS, SUMS)
def test_norm_is_submultiplicative(f, g):
    product = norm((enclosure(f) * enclosure(g)).center, NU)
    assert product <= norm(enclosure(f).center, NU) * norm(enclosure(g).center, NU) * (1 + 1e-8)


@given(SUMS, SUMS, st.integers(1, 6))
def test_products_and_cuts_enclose_the_values(f, g, top):
    product = (enclosure(f) * enclosure(g)).cut(top)
    for t in TIMES:
        assert at(product, t).overlaps(value(f, t) * value(g, t))


@given(SUMS, SUMS, SUMS)
def test_product_of_enclosures_contains_products_of_members(f, g, change):
    size = norm(enclosure(change).center, NU)
    product = enclosure(f, size) * enclosure(g)
    moved = (enclosure(f) + enclosure(change)) * enclosure(g)
    assert norm((moved + product * -1).center, NU) <= product.radius * (1 + 1e-8) + 1e-14


@given(SUMS)
def test_cosine_and_sine(f):
    with ctx.workprec(100):
        c, s = enclosure(f).cos_sin(12)
        for t in TIMES:
            assert at(c, t).overlaps(value(f, t).cos())
            assert at(s, t).overlaps(value(f, t).sin())


@pytest.mark.parametrize("p", [1, 2, 3, 5])
def test_negative_power_contains_the_values(p):
    w = {(0, 0): 2.0, (0, 1): 0.3}
    v = RING.from_modes({(0, 0): arb("0.711"), (0, 1): arb("-0.054"), (0, 2): arb("0.003")})
    power = enclosure(w).negative_power(p, v)
    assert power.radius < 0.01
    for t in TIMES:
        assert at(power, t).contains(1 / value(w, t).sqrt() ** p)


@pytest.mark.parametrize("v, message", [({(0, 0): 1.5}, "not below 1"), ({(0, 0): -0.7}, "v.0."),
                                        ({(0, 0): float("nan")}, "not below 1")])
def test_poor_root_is_refused(v, message):
    with pytest.raises(NotProved, match=message):
        enclosure({(0, 0): 2.0}).negative_power(3, enclosure(v).center)


def test_upper_bounds_are_exact_and_not_below():
    x = arb("0.1")
    assert upper(x).rad() == 0 and upper(x) >= x and upper(-x) >= x
    assert largest_of([arb(1), arb(3, 0.5), arb(2)]) >= arb("3.5")
    assert not largest_of([arb(1), arb("nan")]) < 10              # unknown is never small


@given(st.floats(1e-30, 1e30))
def test_printed_bounds_are_on_the_safe_side(x):
    assert float(at_least(arb(x))) < x < float(at_most(arb(x)))
