"""What is left out of a sum, from its last terms: against sums that are known."""

from math import comb, exp, inf, log

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ftseries.doubt import Place, Terms, digits, front, nonzero
from ftseries.evaluation import motion


def algebraic(p, order, radius=1.0):
    """The coefficients of (1 - λ/R)^p."""
    row = [1.0]
    for k in range(order):
        row.append(-row[-1] * (p - k) / (k + 1) / radius)
    return row


def doubted(row, lam, **what):
    return Place(["x"], [Terms({(0, 0): row}, **what)], lam, 0.0).doubt()


@pytest.mark.parametrize("p", [-2.5, -1, -0.5, 0.5, 1.5])
@pytest.mark.parametrize("order", [3, 4, 6, 10, 20, 60])
@pytest.mark.parametrize("lam", [0.1, 0.5, 0.8, 0.95])
def test_what_is_left_out_is_covered(p, order, lam):
    """And by no more than 12 times.  A line does not see the curve of m^{-p} in few terms."""
    row = algebraic(p, order + 2000)
    true = abs(sum(c * lam**m for m, c in enumerate(row) if m > order))
    estimate = Terms({(0, 0): row[:order + 1]}).left_out(lam)
    assert true < estimate * (1 if order >= 10 else 2.5)
    assert estimate < 12 * true or order < 10 or lam > 0.9


@pytest.mark.parametrize("step, first", [(1, 0), (2, 0), (2, 1), (3, 0), (4, 2)])
@pytest.mark.parametrize("order", range(1, 24))
def test_terms_that_do_not_fall_are_a_doubt_at_every_order(step, first, order):
    """Σ z^k, z = λ^step, and zeros between: nothing is known before the second term."""
    row = [float(m % step == first and m >= first) for m in range(order + 1)]
    found = doubted(row, 3 ** (1 / step), given=first + 1)
    if order < step + first:
        assert "only the first terms are known" in found
    else:
        assert "last terms of 'x' do not fall" in found or "outside the radius" in found
        assert (doubted(row, 0.05 ** (1 / step), given=first + 1) is None) == (
            order >= 2 * step + first)                       # of two terms, 5 % is too much
    assert doubted(row, 0.0) is None


def test_a_doubt_names_the_radius_or_the_share():
    row = [comb(2 * k, k) / 4**k for k in range(40)]                     # 1/√(1 - λ)
    assert "λ = 2 lies outside" in doubted(row, 2.0) and "near 1" in doubted(row, 2.0)
    assert doubted(row, 0.5) is None
    assert "may change 'x' by" in doubted(row, -0.97)


def test_dips_do_not_count():
    """Σ cos(mφ) λ^m, from a pair of complex poles: what is left out of it is below Σ λ^m."""
    row = [np.cos(0.9 * m) for m in range(41)]
    assert min(abs(c) for c in row[-6:]) < 0.13
    assert 0.8**41 < Terms({(0, 0): row}).left_out(0.8) < 20 * 0.8**41


@pytest.mark.parametrize("row", [[], [0.0] * 9, [1.0], [1.0, 0.0, 0.0], [0.0, 2.0]])
def test_fewer_than_two_terms_tell_nothing(row):
    table = {(0, 0): row} if row else {}
    assert Terms(table).left_out(0.1) == inf and Terms(table).left_out(0) == 0
    assert Terms(table, ended=True).left_out(0.1) == 0


def test_terms_given_by_hand_tell_nothing():
    assert Terms({(0, 0): [1.0, 0.1, 0.01]}, given=3).left_out(0.1) == inf
    assert Terms({(0, 0): [1.0, 0.1, 0.01]}, given=2).left_out(0.1) < 1e-3


def test_terms_beyond_all_floats():
    assert doubted([1.0] * 10, 1e300) is not None


def test_rounding_between_terms_is_no_term():
    row = [0.5**m if m % 2 == 0 else 1e-17 for m in range(21)]
    assert nonzero(np.array(row)).tolist() == list(range(0, 21, 2))
    clean = [c * (m % 2 == 0) for m, c in enumerate(row)]
    assert Terms({(0, 0): row}).left_out(1.0) == Terms({(0, 0): clean}).left_out(1.0)


@given(st.lists(st.floats(-200, 200), min_size=1, max_size=30), st.floats(-5, 5))
def test_what_is_rounding_does_not_depend_on_the_unit(logs, slope):
    """λ in another unit multiplies c_m by e^{sm}: a straight line more in log c_m."""
    one = np.array([exp(y) for y in logs])
    other = np.array([exp(y + slope * m) for m, y in enumerate(logs)])
    differ = set(nonzero(one)) ^ set(nonzero(other))
    assert not differ or len(logs) > 2                       # ends are always kept
    assert {0, len(logs) - 1} <= set(nonzero(one))


@given(st.floats(-0.5, 0.5), st.floats(-0.5, 0.5), st.integers(0, 2), st.floats(0, 200))
def test_errors_of_the_amplitudes_and_of_the_frequency_reach_the_value(da, dw, order, t):
    """Against a motion that is changed: to first order in the errors, which are 1e-9."""
    table, omega = {(0, 0): [0.3], (0, 1): [1.0], (1, 2): [0.5]}, 1.7
    terms = [Terms(table, derivative=order), Terms({(0, 0): [omega]})]
    place = Place(["x", "omega"], terms, 1.0, omega * t)
    own = 1e-9 * abs(da) * 3 * 2**order
    bound = sum(place.relative([own, 1e-9 * abs(dw)])) * omega**order * place.sizes[0]
    before, after = ({mode: row[0] + shift for mode, row in table.items()}
                     for shift in (0, 1e-9 * da))
    change = motion(after, t, omega + 1e-9 * dw, order) - motion(before, t, omega, order)
    assert abs(change) <= bound * (1 + 1e-5) + 1e-13         # rounding: 2⁻⁵³ · ωt · Σ n|A_n|


def test_where_terms_cancel_floats_lose_digits():
    """e^{-30} = 9e-14 is what is left of terms of 10¹² and less, which have 16 digits."""
    row = np.cumprod([1.0] + [-1 / m for m in range(1, 200)])
    far, near = (Place(["x"], [Terms({(0, 0): row})], lam, 0.0) for lam in (30.0, 1.0))
    assert digits(far.rounding(0.0)) == 0 and digits(near.rounding(0.0)) == 15
    assert near.doubt() is None


def test_digits():
    assert [digits(x) for x in (1e-3, 2e-3, 0.9, 5.0, inf, float("nan"))] == [3, 2, 0, 0, 0, 0]


@given(st.lists(st.tuples(st.integers(-4, 4), st.integers(-4, 4)), max_size=40))
def test_no_pair_exceeds_the_front(pairs):
    lam, t = (np.array([float(p[i]) for p in pairs]) for i in (0, 1))
    found = front(lam, t)
    assert all(any(a * b >= 0 and abs(b) >= abs(a) and late >= abs(time) for b, late in found)
               for a, time in zip(lam, t))
    assert {(b, late) for b, late in found} <= {(a, abs(time)) for a, time in zip(lam, t)}


def test_a_long_front_is_thinned():
    lam = np.linspace(0.001, 1, 1000)
    assert len(front(lam, 1 / lam)) == 64 and front(lam, 1 / lam)[0] == (1.0, 1.0)
    assert log(front(lam, 1 / lam)[-1][1]) == pytest.approx(log(1000))
