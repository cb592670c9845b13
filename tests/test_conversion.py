"""Numbers of every ring as mpmath numbers, floats and balls."""

from contextlib import nullcontext

import pytest
import sympy as sp
from flint import arb, fmpq

import ftseries as fts
from ftseries.conversion import float_unit, to_ball, to_float


def test_to_float():
    assert to_float(fmpq(1, 3)) == 1 / 3 and to_float(arb("0.75")) == 0.75


@pytest.mark.parametrize("unit", [sp.Rational(2, 3), sp.cbrt(3), 2 * sp.sqrt(3) / 5, sp.pi / 3,
                                  1 + sp.sqrt(2), sp.exp(1) / 2, sp.sin(2) * sp.log(3)])
def test_to_ball(unit):
    assert to_ball(unit).contains(arb(str(sp.N(unit, 60)), "1e-50"))


@pytest.mark.parametrize("unit", [sp.gamma(sp.Rational(1, 3)), sp.EulerGamma])
def test_what_is_no_elementary_number(unit):
    with pytest.raises(fts.InputError, match="not made of rationals"):
        to_ball(unit)


@pytest.mark.parametrize("arithmetic, error", [("ball", 1e-28), ("float", 1e-14)])
def test_many_digits_from_every_arithmetic(arithmetic, error):
    exact, other = (fts.solve(fts.CubicOscillator(), 12, kind, precision=160)
                    for kind in ("exact", arithmetic))
    with nullcontext() if arithmetic == "ball" else pytest.warns(fts.PrecisionWarning):
        values = [solution.evaluate("x", 0.3, lam=0.2, dps=30) for solution in (exact, other)]
    assert abs(values[0] - values[1]) < error


@pytest.mark.parametrize("unit, words", [
    (sp.Integer(10)**400, "about 1.0e\\+400, beyond the floats"),
    (sp.Rational(1, 10**400), "about 1.0e-400, beyond the floats"),
    (sp.sqrt(sp.Symbol("a")), "contains a; give it a number")])
def test_a_unit_that_is_no_float(unit, words):
    with pytest.raises(fts.InputError, match=words):
        float_unit("the problem", unit)


def test_a_unit_as_a_float():
    assert float_unit("the problem", sp.cbrt(3)) == pytest.approx(3**(1 / 3), rel=1e-15)
    assert float_unit("the problem", -2) == -2
