"""The pictures of the stability chapter show what their captions say."""

import numpy as np
import pytest
from matplotlib.figure import Figure

import ftseries as fts
from ftseries import stability
from ftseries.figures import stability as pictures
from ftseries.references import mathieu, newton

LAM, MU = 2, -0.3


@pytest.fixture(scope="module")
def sol():
    return fts.solve(fts.GeneralizedMathieu(), order=99)


@pytest.fixture(scope="module")
def eight():
    return stability.bodies(newton.figure_eight)


def axes(n=1):
    return Figure().subplots(1, n)


def test_discriminant_shades_the_band_below_its_edge():
    ax = axes()
    edge = mathieu.eigenvalue(1, MU)
    pictures.discriminant(ax, 1, MU, (0, 1), {"a_0": edge - 0.5, "b_1": edge})
    curve, *_, mark = ax.lines
    assert curve.get_xdata()[[0, -1]].tolist() == [0, 1]
    assert mark.get_xdata()[0] == edge and mark.get_ydata()[0] == -2
    (band,) = ax.patches
    assert band.get_x() == edge - 0.5 and band.get_width() == pytest.approx(0.5)
    assert ax.get_xlabel() and ax.get_ylabel() and ax.get_legend()


def test_crossing_puts_the_orders_on_their_sides(sol):
    ax = axes()
    pictures.crossing(ax, sol, LAM, MU, (79, 99))
    below, above = (line for line in ax.lines if line.get_marker() in "ov")
    assert below.get_xdata()[0] < 0 < below.get_ydata()[0]
    assert above.get_xdata()[0] > 0 > above.get_ydata()[0]


def test_growth_follows_its_law(sol):
    ax = axes()
    pictures.growth(ax, sol, LAM, MU, (99,), periods=12)
    law, points = ax.lines
    expected = np.interp(points.get_xdata(), law.get_xdata(), law.get_ydata())
    ratio = points.get_ydata() / expected
    assert np.all(abs(ratio[5:] - 1) < 0.05) and abs(ratio[-1] - 1) < abs(ratio[5] - 1)
    assert ax.get_yscale() == "log"


def test_largest_differences_begin_with_the_papers_figure(sol):
    assert pictures.largest_differences(sol, LAM, MU, 1)[0] == pytest.approx(0.0104, abs=1e-4)


def test_on_edge_shows_the_slopes():
    k = np.arange(1, 11)
    ax = axes()
    pictures.on_edge(ax, k**2, k, 1.01 * k**2, 1.01 * k)
    for line, slope in zip(ax.lines[1::2], (2, 1)):
        np.testing.assert_allclose(np.diff(np.log(line.get_ydata()))
                                   / np.diff(np.log(line.get_xdata())), slope)
    assert ax.get_xscale() == ax.get_yscale() == "log" and ax.get_legend()


def test_multipliers_lie_on_the_circle_in_both_panels(eight):
    left, right = axes(2)
    pictures.multipliers(left, right, eight)
    marks = left.lines[1]
    np.testing.assert_allclose(np.hypot(*marks.get_data()), 1, rtol=0, atol=1e-10)
    low, high = right.get_ylim()
    inside = (low < marks.get_ydata()) & (marks.get_ydata() < high)
    assert inside.sum() == 2 and len(inside) == 4


def test_follow_agrees_with_the_monodromy_matrix(eight):
    disturbance = 1e-5 * eight.basis[:, 0]
    found = pictures.follow(newton.figure_eight_state(), disturbance, 2 * np.pi, 3)
    linear = [np.linalg.norm(np.linalg.matrix_power(eight.matrix, k) @ disturbance)
              for k in range(4)]
    np.testing.assert_allclose(found, linear, rtol=1e-2)  # second order, 1e-5 times some hundreds


def test_disturbed_draws_points_and_law():
    ax = axes()
    pictures.disturbed(ax, {"one": np.array([2.0, 4.0])}, {"one": np.array([1.0, 3.0])})
    points, law = ax.lines
    assert list(points.get_ydata()) == [1, 2] and list(law.get_ydata()) == [1, 3]
