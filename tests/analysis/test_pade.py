"""Padé approximants: defining property, known functions, singular blocks, defects, poles."""

import hypothesis.strategies as st
import numpy as np
import pytest
from flint import arb, fmpq, fmpq_poly
from hypothesis import given

from ftseries import InputError
from ftseries.analysis import pade

LOG = [fmpq(0)] + [fmpq((-1) ** (k + 1), k) for k in range(1, 61)]            # ln(1 + z)


@given(st.lists(st.fractions(-3, 3, max_denominator=7), min_size=3, max_size=13))
def test_defining_property(values):
    """q f - p = O(z^{L+M+1}) with the degrees that were found, and q(0) = 1."""
    c = [fmpq(v.numerator, v.denominator) for v in values]
    approximant = pade(c)
    p, q = (np.array([float(x) for x in part]) for part in approximant.exact)
    order = sum(approximant.degrees) + 1
    product = np.convolve(q, np.array(values, float))[:order]
    product[:len(p)] -= p[:order]
    scale = 1 + np.abs(q).max() * np.abs(np.array(values, float)).max()
    assert q[0] == 1 and np.abs(product).max() < 1e-10 * scale
    assert approximant.asked == ((len(c) - 1) - (len(c) - 1) // 2, (len(c) - 1) // 2)


@given(p=st.lists(st.integers(-5, 5), min_size=1, max_size=4),
       q=st.lists(st.integers(-5, 5), min_size=0, max_size=3))
def test_rational_functions_come_back(p, q):
    """Also where their degrees are lower than asked: then the table has a singular block."""
    p, q = fmpq_poly(p), fmpq_poly([1] + q)
    c = [x for x in series(p, q, 13)]
    found = pade(c)
    for z in (0.11, -0.07, 0.05j):
        exact = (np.polyval([float(x) for x in p.coeffs()[::-1]], z)
                 / np.polyval([float(x) for x in q.coeffs()[::-1]], z))
        assert abs(found(z) - exact) < 1e-13 * (1 + abs(exact))


def series(p, q, terms):
    c = []
    for k in range(terms):
        c.append(p[k] - sum((q[j] * c[k - j] for j in range(1, min(k, q.degree()) + 1)), fmpq(0)))
    return c


def test_beyond_the_radius():
    """ln(1 + z) has radius 1; [30/30] gives 12 digits at z = 5 and 20 + i, by NumPy's logarithm."""
    approximant = pade(LOG)
    assert abs(approximant(5.0) - np.log(6)) < 1e-12
    assert abs(approximant(2 + 1j) - np.log(3 + 1j)) < 1e-13
    assert np.abs(approximant(np.array([0.5, 1.0])) - np.log([1.5, 2])).max() < 1e-12


def test_poles_of_a_logarithm_lie_on_its_cut():
    poles = pade(LOG[:21]).poles()
    assert len(poles) == 10 and np.abs(poles.imag).max() < 1e-12 and poles.real.max() < -1


def test_singular_block_is_reported():
    geometric = pade([fmpq(1)] * 12)
    assert geometric.degrees == (6, 1) and geometric.asked == (6, 5)
    assert "singular block" in repr(geometric) and geometric.poles() == pytest.approx([1])
    assert "singular block" in repr(pade([1.0] * 12))                # floats that are exact
    assert "singular" not in repr(pade(LOG))


def test_defects_of_rounding_are_found():
    """Noise of 1e-10 on a geometric series: one pole is real, the others are met by zeros."""
    noise = np.random.default_rng(1).normal(size=21)
    approximant = pade(list(0.5 ** np.arange(21) * (1 + 1e-10 * noise)))
    true = [pole for pole in approximant.poles() if abs(pole - 2) < 1e-6]
    defects = approximant.defects()
    assert len(true) == 1 and len(defects) >= 8
    assert true[0] not in defects
    assert abs(approximant(1.0) - 2) < 1e-8


def test_clean_approximant_has_no_defects():
    assert pade(LOG[:21]).defects() == []


def test_a_pole_is_infinite():
    assert pade([fmpq(1, 2**k) for k in range(6)])(2.0) == np.inf


def test_one_number_loses_no_digits_to_cancellation():
    """(1 - z)^{-1/2} far beyond its circle, on the other side: digits cancel in q, not here."""
    c = [fmpq(1)]
    for k in range(1, 81):
        c.append(c[-1] * fmpq(2 * k - 1, 2 * k))
    approximant = pade(c)
    assert abs(approximant(-3.0) - 0.5) < 1e-15
    assert abs(approximant(-8.0) * 3 - 1) < 1e-14


def test_balls_and_floats():
    assert abs(pade([arb(x) for x in LOG])(1.0) - np.log(2)) < 1e-15
    assert abs(pade([float(int(x.p) / int(x.q)) for x in LOG[:21]])(1.0) - np.log(2)) < 1e-13


@pytest.mark.parametrize("arguments, word", [
    (([],), "coefficients"), (([1.0, 2.0], 1, 1), "coefficients"), (([1.0, 2.0], -1, 1), "needs"),
    (([1.0, 2.0], 3), "needs"), (([1.0, float("nan"), 2.0],), "finite"), ((["x", "y"],), "real"),
])
def test_what_has_no_approximant_is_refused(arguments, word):
    with pytest.raises(InputError, match=word):
        pade(*arguments)
