"""The pictures of the cubic oscillator carry the numbers of the references."""

import matplotlib
import mpmath
import numpy as np
import pytest
import sympy as sp
from matplotlib.figure import Figure

import ftseries as fts
from ftseries.figures import cubic as pictures
from ftseries.figures import style
from ftseries.references import cubic, cubic_taylor


@pytest.fixture(scope="module")
def sol():
    return fts.solve(fts.CubicOscillator(a=1), order=24)


@pytest.fixture
def ax():
    with style.context():
        return Figure().subplots()


def curve(ax, label):
    """Data of the line whose label is `label`, or begins with it and goes on after a comma."""
    found = [line for line in ax.lines if line.get_label().split(",")[0] == label]
    assert len(found) == 1, [line.get_label() for line in ax.lines]
    return found[0].get_data()


@pytest.mark.parametrize(("lam", "a"), [(0.5, 1), (1.5, 2), (2.9, 1)])
def test_potential(ax, lam, a):
    pictures.potential(ax, lam, a)
    x, v = curve(ax, "$V(x)$")
    # (C1) in its factored form: V = E - P/2
    factored = cubic.energy(lam, a) - cubic.polynomial(x, lam, a) / 2
    np.testing.assert_allclose(v, factored, rtol=0, atol=1e-11)
    left, right = -a - lam, -a + lam
    assert x[0] < left and x[-1] > 2 * a
    for label in ("motion", "turning points"):
        x, v = curve(ax, label)
        assert (x[0], x[-1]) == (left, right)
        assert set(v) == {cubic.energy(lam, a)}
    x, v = curve(ax, "$x = 2a$")
    assert x == [2 * a]
    assert cubic.potential(x[0], lam, a) == pytest.approx(v[0], abs=1e-12)


@pytest.mark.parametrize(("lam", "a"), [(0.5, 1), (1.0, 2)])
def test_oscillation(ax, lam, a):
    pictures.oscillation(ax, fts.solve(fts.CubicOscillator(a=a), order=24), lam, periods=1.5)
    for label in ("series of order 24", "exact"):
        t, x = curve(ax, label)
        assert t[0] == 0 and t[-1] == pytest.approx(1.5 * cubic.period(lam, a), rel=1e-14)
        # rounding of numbers below 4, a few dozen operations
        np.testing.assert_allclose(x, cubic.position(t, lam, a), rtol=0, atol=2e-14)


def test_oscillation_shows_a_poor_series_as_it_is(ax, sol):
    pictures.oscillation(ax, sol.truncate(2), 1.5)
    t, x = curve(ax, "series of order 2")
    omega = 2 * np.sqrt(3) - 1.5**2 * np.sqrt(3) / 24  # (C7b)
    by_hand = -1 + 1.5 * np.cos(omega * t) + 1.5**2 / 12 * (1 - np.cos(2 * omega * t))  # (C7a)
    np.testing.assert_allclose(x, by_hand, rtol=0, atol=1e-13)
    assert np.abs(x - curve(ax, "exact")[1]).max() > 0.1


def test_difference_in_double_precision_is_rounding(ax, sol):
    pictures.difference(ax, sol, 0.5)
    _, error = curve(ax, "double precision")
    assert 1e-17 < np.abs(error).max() < 5e-15  # the paper's bound


def test_difference_in_40_digits_is_the_truncation(ax, sol):
    pictures.difference(ax, sol, 0.5, dps=40)
    t, error = curve(ax, "40 digits")
    assert error[0] == 0
    for k in (17, 50, 101):
        with mpmath.workdps(40):
            time = 2 * cubic.period("0.5", dps=40) * k / 120
            exact = cubic.position(time, "0.5", dps=40)
            series = sol.evaluate("x", time, lam="0.5", dps=40)
            assert error[k] == pytest.approx(float(series - exact), rel=1e-12, abs=0)
            longer = fts.solve(sol.problem, order=28).evaluate("x", time, lam="0.5", dps=40)
        # the next four Taylor orders explain all but a part of the order (1/6)^4 of it
        assert error[k] == pytest.approx(float(series - longer), rel=0.01, abs=0)


def test_coefficients(ax, sol):
    pictures.coefficients(ax, sol)
    size = ax.images[0].get_array()
    assert size.shape == (25, 25)
    for n in range(25):
        exact = np.array([float(c) for c in cubic_taylor.fourier_taylor(n, 24)])
        shown = np.isfinite(np.ma.filled(size[n], np.nan))
        np.testing.assert_array_equal(shown, exact != 0)
        np.testing.assert_allclose(size[n][shown], np.log10(np.abs(exact[exact != 0])), rtol=1e-12)


def test_frequency(ax):
    solution = fts.solve(fts.CubicOscillator(a=2), order=24)
    pictures.frequency(ax, solution, (2, 24))
    ratio, omega = curve(ax, "exact")
    assert (ratio[0], ratio[-1], omega[-1]) == (0, 1, 0) and (np.diff(omega) <= 0).all()
    inside = ratio < 0.999                      # beyond, the last digit of the ratio decides
    exact = 2 * np.pi / cubic.period(6 * ratio[inside], 2)
    np.testing.assert_allclose(omega[inside], exact, rtol=1e-14)
    by_hand = np.sqrt(6) * (2 - ratio[:-1]**2 * 9 / 24)  # (C7b) with a = 2, λ = 6 ratio
    np.testing.assert_allclose(curve(ax, "order 2")[1], by_hand, rtol=1e-14)
    small = ratio[:-1] < 1 / 3
    np.testing.assert_allclose(curve(ax, "order 24")[1][small], omega[:-1][small], rtol=1e-13)


def test_largest_error(ax, sol):
    ratios = [0.1, 1 / 6]
    pictures.largest_error(ax, sol, (6, 24), ratios, samples=8, mark=1 / 6)
    assert ax.lines[-1].get_xdata()[0] == 1 / 6
    for order in (6, 24):
        shown_ratios, errors = curve(ax, f"order {order}")
        np.testing.assert_array_equal(shown_ratios, ratios)
        # the first Taylor order left out is order + 1
        assert np.log(errors[1] / errors[0]) / np.log(10 / 6) == pytest.approx(order + 1, abs=0.5)
    with mpmath.workdps(40):
        times = np.array([cubic.period("0.5", dps=40) * k / 8 for k in range(9)])
        series = sol.evaluate("x", times, lam="0.5", dps=40)
        exact = [cubic.position(time, "0.5", dps=40) for time in times]
        largest = float(max(abs(series - exact)))
    # 1/6 is a rounded number: λ differs from 1/2 by less than 1e-16, and the error grows like λ^25
    assert curve(ax, "order 24")[1][1] == pytest.approx(largest, rel=1e-13, abs=0)


def test_a_symbol_is_refused(ax):
    solution = fts.solve(fts.CubicOscillator(a=sp.Symbol("a", positive=True)), order=2)
    with pytest.raises(fts.FTSeriesError, match="a=a is a symbol"):
        pictures.oscillation(ax, solution, 0.5)


def _luminance(colour):
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4
              for c in matplotlib.colors.to_rgb(colour)]
    return np.dot([0.2126, 0.7152, 0.0722], linear)


@pytest.mark.parametrize("page", ["#ffffff", "#121212"])
def test_the_palette_stands_out_on_both_pages(page):
    """WCAG 2.1 asks a contrast of 3 of graphics (1.4.11) and of large text (1.4.3)."""
    for colour in (*style.COLOURS, style.GREY):
        light, dark = sorted((_luminance(colour), _luminance(page)), reverse=True)
        assert (light + 0.05) / (dark + 0.05) > 2.9, colour  # purple has 2.95 on white
