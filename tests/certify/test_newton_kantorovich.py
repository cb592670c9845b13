"""The radii polynomial on equations of one unknown, where every constant is known by hand."""

import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from ftseries.certify import Bounds, NotProved, radius


@given(st.floats(1.2, 1.6))
def test_square_root_of_two(guess):
    x = arb(guess)                                       # F = u² - 2, A = 0.35, F'' = 2
    a = arb("0.35")
    try:
        low, high = radius(Bounds(abs(a * (x * x - 2)), abs(1 - 2 * a * x), 2 * a, arb(1)))
    except NotProved:
        assert abs(guess - 2**0.5) > 0.1
    else:
        assert abs(x - arb(2).sqrt()) <= low < high
        assert high < abs(x + arb(2).sqrt())             # the other root is farther away


def test_exact_center_has_radius_zero():
    low, high = radius(Bounds(arb(0), arb("0.1"), arb(1), arb(1)))
    assert low == 0 and high > 0.8


@pytest.mark.parametrize("bounds, message", [
    (("1e-3", "1.3", "1", "1"), r"Z₁ = 1.3.*must be below 1"),
    (("0.5", "0.1", "1", "1"), r"Y = 0.5.*not above 2 Y Z₂"),
    (("1e-3", "0.1", "1", "1e-4"), r"exceeds r\*"),
    (("nan", "0.1", "1", "1"), "not proved"),
    (("1e-3", "nan", "1", "1"), "not proved"),
    (("1e-3", "0.1", "nan", "1"), "not proved"),
])
def test_what_is_not_proved_shows_its_constants(bounds, message):
    with pytest.raises(NotProved, match=message):
        radius(Bounds(*map(arb, bounds)))
