"""Singularities of functions whose singularities are known."""

import math

import hypothesis.strategies as st
import pytest
from flint import arb, ctx, fmpq
from hypothesis import given

from ftseries import InputError
from ftseries.analysis import domb_sykes, nearest_singularities, root_test, thin


def power(s, z0, order):
    """(1 - z/z0)^s."""
    c = [fmpq(1)]
    for k in range(1, order + 1):
        c.append(c[-1] * (fmpq(k - 1) - s) / (k * fmpq(z0)))
    return c


def legendre(x, s, order):
    """(1 - 2xz + z²)^s, singular at x ± i sqrt(1 - x²); (1 - 2xz + z²) f' = 2s (z - x) f."""
    c = [fmpq(1), -2 * s * x]
    for k in range(1, order):
        c.append((2 * x * (k - s) * c[k] + (2 * s - k + 1) * c[k - 1]) / (k + 1))
    return c


def exponential(order):
    return [fmpq(1, math.factorial(k)) for k in range(order + 1)]


def product(a, b):
    return [sum((a[j] * b[k - j] for j in range(k + 1)), fmpq(0)) for k in range(len(a))]


def elliptic(order):
    """2K(m)/π: a logarithm at m = 1."""
    return [fmpq(math.comb(2 * k, k) ** 2, 16**k) for k in range(order + 1)]


def inverse(c):
    d = [1 / c[0]]
    for k in range(1, len(c)):
        d.append(-sum((c[j] * d[k - j] for j in range(1, k + 1)), fmpq(0)) / c[0])
    return d


def as_floats(c):
    return [int(x.p) / int(x.q) for x in c]


def add(a, b):
    return [x + y for x, y in zip(a, b)]


KNOWN = {                                   # name: (coefficients of an order, location, exponent)
    "square root": (lambda n: power(fmpq(1, 2), 2, n), 2, 0.5),
    "cube root and background": (
        lambda n: add(exponential(n), product(exponential(n), power(fmpq(1, 3), 2, n))), 2, 1 / 3),
    "double pole": (lambda n: product(exponential(n), power(fmpq(-2), 1, n)), 1, -2),
    "negative axis": (
        lambda n: product(exponential(n), power(fmpq(-1, 2), fmpq(-3, 2), n)), -1.5, -0.5),
    "logarithm": (elliptic, 1, 0),
    "two on a ray": (
        lambda n: add(power(fmpq(1, 2), 1, n), power(fmpq(1, 2), fmpq(6, 5), n)), 1, 0.5),
    "pair": (lambda n: legendre(fmpq(1, 3), fmpq(-1, 2), n), 1 / 3 + math.sqrt(8 / 9) * 1j, -0.5),
    "pair near the axis": (
        lambda n: legendre(fmpq(99, 100), fmpq(1, 2), n), 0.99 + math.sqrt(1 - 0.99**2) * 1j, 0.5),
    "pair times exponential": (
        lambda n: product(exponential(n), legendre(fmpq(1, 2), fmpq(1, 2), n)),
        0.5 + math.sqrt(0.75) * 1j, 0.5),
    "pair and one farther": (
        lambda n: add(legendre(fmpq(1, 2), fmpq(1, 2), n), power(fmpq(1, 2), fmpq(11, 10), n)),
        0.5 + math.sqrt(0.75) * 1j, 0.5),
}


@pytest.mark.parametrize("kind", [list, as_floats])
@pytest.mark.parametrize("order", [20, 40, 100])
@pytest.mark.parametrize("name", KNOWN)
def test_known_singularity_lies_within_the_error(name, order, kind):
    make, location, exponent = KNOWN[name]
    found = nearest_singularities(kind(make(order)))[0]
    gap = abs(abs(found.location.imag) * 1j + found.location.real - location)
    assert gap <= found.error
    assert abs(found.exponent - exponent) <= found.exponent_error
    assert found.radius.value == abs(found.location) and found.radius.error == found.error
    # the error given must not be empty caution: 40 terms tell a few digits of every one of these
    if order >= 40:
        assert found.error < 4e-3 * abs(location)


@given(x=st.integers(-9, 9), s=st.sampled_from([fmpq(1, 2), fmpq(-1, 2), fmpq(1, 3), fmpq(-3)]))
def test_any_pair_is_found_with_its_type(x, s):
    z, conjugate = nearest_singularities(legendre(fmpq(x, 10), s, 30))[:2]
    assert abs(z.location - (x / 10 + math.sqrt(1 - x * x / 100) * 1j)) < 1e-12
    assert abs(z.exponent - int(s.p) / int(s.q)) < 1e-9
    assert conjugate.location == z.location.conjugate()


@given(scale=st.floats(0.05, 50), factor=st.floats(-5, 5).filter(lambda x: abs(x) > 0.1))
def test_scaling_moves_the_singularity_and_nothing_else(scale, factor):
    c = as_floats(KNOWN["pair times exponential"][0](40))
    z = nearest_singularities(c)[0]
    moved = nearest_singularities([factor * x / scale**k for k, x in enumerate(c)])[0]
    assert abs(moved.location / scale - z.location) <= moved.error / scale + z.error
    assert abs(moved.exponent - z.exponent) <= moved.exponent_error + z.exponent_error


def test_two_of_different_type_on_one_circle():
    found = nearest_singularities(add(power(fmpq(1, 2), 1, 60), power(fmpq(-1, 2), -1, 60)))
    assert sorted((round(s.location.real, 5), round(s.exponent, 3)) for s in found) == [
        (-1, -0.5), (1, 0.5)]


def test_inverse_logarithm_is_slow_and_the_error_says_so():
    """1/K(m) ~ 1/log(1 - m): no power; the fits drift, and the error must cover the drift."""
    for order in (20, 40, 100):
        for kind in (list, as_floats):
            found = nearest_singularities(kind(inverse(elliptic(order))))[0]
            assert abs(found.location - 1) <= found.error
            assert found.error > 1e-6


def test_balls_count_with_their_middle():
    exact = elliptic(60)
    with ctx.workprec(300):
        good = nearest_singularities([arb(x) for x in exact])[0]
    (poor,) = nearest_singularities([arb(x, 1e-15) for x in as_floats(exact)])
    assert abs(good.location - 1) <= good.error < 1e-13
    assert abs(poor.location - 1) <= poor.error < 1e-6


def test_thin_finds_the_regular_zeros():
    assert thin([0, 0, 3, 0, 0, 4, 0, 0, 5]) == (3, 2, [3, 4, 5])
    assert thin([0, 7, 0]) == (1, 1, [7, 0])


def test_root_test_and_domb_sykes_on_a_square_root():
    c = power(fmpq(1, 2), 2, 200)
    k, radius = root_test(c)[-1]
    assert k == 200 and abs(radius - 2) < 0.1                    # like log k / k
    (x1, r1), (x2, r2) = domb_sykes(c)[-2:]
    slope = (r2 - r1) / (x2 - x1)
    assert abs(r2 - x2 * slope - 0.5) < 1e-12                    # ratios: 1/2 (1 - 3/(2k)) exactly
    assert abs(slope / 0.5 + 1.5) < 1e-10


@pytest.mark.parametrize("c, word", [
    ([1.0] * 9, "too few"),
    ([1.0] * 12 + [math.nan], "finite"),
    ([1.0] * 12 + [math.inf], "finite"),
    (["one"] * 12, "real"),
    ([1.0] * 5 + [0.0] * 12, "polynomial"),
    ([1 / math.factorial(k) for k in range(60)], "has none"),
])
def test_what_cannot_be_located_is_refused(c, word):
    with pytest.raises(InputError, match=word):
        nearest_singularities(c)


def test_all_zero_sequence_is_refused():
    with pytest.raises(InputError, match="all coefficients are zero"):
        thin([0, 0.0, 0])
    with pytest.raises(InputError):
        nearest_singularities([0.0] * 20)
