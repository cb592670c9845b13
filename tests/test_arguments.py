"""What a caller may give."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from ftseries.arguments import decimal, rational, real, scalar, scalars, whole
from ftseries.errors import InputError


@pytest.mark.parametrize("value, expected", [
    (3, (3, 1)), ("0.1", (1, 10)), ("-7/3", (-7, 3)), (0.5, (1, 2)), (Fraction(2, 6), (1, 3)),
    (sp.Rational(-4, 6), (-2, 3)), (sp.Integer(5), (5, 1)), (fmpq(3, 4), (3, 4)), (True, (1, 1)),
    (mpmath.mpf("0.375"), (3, 8)), (sp.Float("0.125"), (1, 8)), (0.1, (0.1).as_integer_ratio()),
])
def test_rational_numbers_of_every_kind(value, expected):
    number = rational(value)
    assert (int(number.p), int(number.q)) == expected


@pytest.mark.parametrize("value", ["x", None, 1j, [1], sp.sqrt(2), sp.Symbol("a"), float("nan"),
                                   float("inf"), mpmath.inf, mpmath.nan, "1/0", sp.oo, sp.nan])
def test_what_is_not_rational(value):
    with pytest.raises(InputError, match="is not a rational number"):
        rational(value)


def test_a_long_mantissa_is_kept():
    with mpmath.workprec(200):
        third = rational(mpmath.mpf(1) / 3)
    assert 0 < abs(third - fmpq(1, 3)) < fmpq(1, 2**199)
    assert rational(sp.Float("0.1", 40)) != rational(0.1)


@pytest.mark.parametrize("value", ["x", 1j, [[1], [1, 2]], True, [True, False]])
def test_what_is_not_real(value):
    with pytest.raises(InputError, match="^z=.* is not a real number or an array of them$"):
        real("z", value)


@pytest.mark.parametrize("value", [None, np.nan, np.inf, [1, -np.inf]])
def test_what_is_not_finite(value):
    with pytest.raises(InputError, match="^z contains a value that is NaN or infinite"):
        real("z", value)


def test_real_numbers_become_an_array_of_floats():
    array = real("t", [1, sp.Rational(5, 2)])
    assert array.tolist() == [1.0, 2.5] and array.dtype == float


def test_one_number_or_one_for_each_name():
    values = scalars({"lam": np.float32(0.5), "mu": "-2"})
    assert values == {"lam": 0.5, "mu": -2.0} and set(map(type, values.values())) == {float}
    with pytest.raises(InputError, match=r"^lam=\[0.5\]: give one number"):
        scalar("lam", [0.5])


@pytest.mark.parametrize("value", [3, 7, np.int64(5), sp.Integer(4)])
def test_whole_numbers_between_two_ends(value):
    number = whole("n", value, 3, 7)
    assert number == value and type(number) is int


@pytest.mark.parametrize("value", [2, 8, 3.0, "3", None, True, 10**30, [3]])
def test_what_is_not_such_a_number(value):
    with pytest.raises(InputError, match=r"^n=.*: give a whole number from 3 to 7$"):
        whole("n", value, 3, 7)


def test_without_an_upper_end_any_whole_number_will_do():
    assert whole("n", 10**30) == 10**30 and whole("n", 0) == 0
    for value in (-1, False, True):
        with pytest.raises(InputError, match="of at least 0$"):
            whole("n", value)


@pytest.mark.parametrize("value, text", [
    (0.3, "3/10"), (np.float64(0.3), "3/10"), (np.float32(0.3), "3/10"), (1e-7, "1/10000000"),
    (1 / 3, "3333333333333333/10000000000000000"), (-2.5, "-5/2"), (7, "7"), ("0.30", "3/10"),
    (0.1 + 0.2, "7500000000000001/25000000000000000"), (sp.Float(0.3), "3/10"),
    (mpmath.mpf(0.3), "3/10"), (Fraction(1, 3), "1/3"), (sp.Rational(2, 7), "2/7"),
    (sp.Float("0.1234567890123456789012", 25), "308641972530864197253/2500000000000000000000"),
])
def test_a_float_is_the_decimal_that_it_looks_like(value, text):
    assert str(decimal(value)) == text


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_every_float_is_its_shortest_decimal(x):
    f = Fraction(repr(x))
    assert (decimal(x) == decimal(sp.Float(x)) == decimal(mpmath.mpf(x))
            == fmpq(f.numerator, f.denominator))


@pytest.mark.parametrize("value", ["x", None, 1j, float("nan"), np.inf, mpmath.inf, sp.nan, sp.oo])
def test_what_is_not_decimal(value):
    with pytest.raises(InputError, match="is not a rational number"):
        decimal(value)
