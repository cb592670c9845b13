"""The pictures of the Mathieu chapter show what their captions say."""

from fractions import Fraction

import numpy as np
import pytest
from matplotlib.figure import Figure
from scipy.special import iv, mathieu_b

import ftseries as fts
from ftseries.figures import mathieu as pictures
from ftseries.references import mathieu

LAM, MU = 2, -0.3
CLOSED = Fraction(-1, 32)  # here a = 1 - λ²/2 - λ⁴/32 and ψ is proportional to exp(-z cos 2x) sin x


@pytest.fixture(scope="module")
def sol():
    return fts.solve(fts.GeneralizedMathieu(), order=99)


def closed_psi(x, lam):
    """The closed form with z = λ²/8; the coefficient of sin x in it is I_0(z) + I_1(z)."""
    z = lam**2 / 8
    return lam * np.exp(-z * np.cos(2 * x)) * np.sin(x) / (iv(0, z) + iv(1, z))


def drawn(function, *arguments, **keywords):
    """The Axes that a picture leaves, after it has really been drawn."""
    three = {"projection": "3d"} if function is pictures.eigenvalue else {}
    figure = Figure()
    axes = figure.subplots(subplot_kw=three)
    function(axes, *arguments, **keywords)
    figure.canvas.draw()
    return axes


@pytest.mark.filterwarnings("error")
def test_every_picture_has_labelled_axes_and_legend(sol):
    place = [(LAM, MU)]
    for axes, entries in [
        (drawn(pictures.potential, [(2, 0), (2, -0.3)]), 2),
        (drawn(pictures.eigenvalue, sol, place), 2),
        (drawn(pictures.error_map, sol, place, radius=2.7, closed=CLOSED), 2),
        (drawn(pictures.psi, sol, LAM, MU), 2),
        (drawn(pictures.difference, sol, LAM, MU), 0),
    ]:
        assert axes.get_xlabel() and axes.get_ylabel()
        legend = axes.get_legend()
        assert (len(legend.get_texts()) if legend else 0) == entries
        assert not hasattr(axes, "get_zlabel") or axes.get_zlabel() == "$a$"


def test_legends_name_bands_and_dot_once_and_what_is_in_the_well():
    lam = np.linspace(0, 1, 5)
    edges = np.arange(5.0)[:, None] + 0 * lam
    for axes, names in [(drawn(pictures.bands, lam, edges, [(0.5, 1)]), ["bands", "$a$"]),
                        (drawn(pictures.well, 1.2, MU),
                         ["potential", "energy $a$", r"$\psi$, on this level"])]:
        assert [text.get_text() for text in axes.get_legend().get_texts()] == names


def test_error_is_that_of_the_closed_form(sol):
    """At μ = -1/32 the series of a ends, so its error is rounding of the size of a (here ≤ 6)."""
    lam = np.linspace(0, 3, 13)
    assert np.all(pictures.error(sol, lam, float(CLOSED)) < 1e-13)
    ends = mathieu.eigenvalue(lam, float(CLOSED)) - (1 - lam**2 / 2 - lam**4 / 32)
    assert np.all(abs(ends) < 1e-13)


def test_reach_is_where_the_error_passes_the_tolerance(sol):
    mu = np.array([-0.3, 0.0, 0.3])
    edge = pictures.reach(sol, mu)
    np.testing.assert_allclose(pictures.error(sol, edge, mu), 1e-3, rtol=0.1)  # log interpolation
    assert np.all(pictures.error(sol, 0.98 * edge, mu) < 1e-3)
    assert np.all(pictures.reach(sol, mu, tolerance=1e-6) < edge)
    assert pictures.reach(sol, [float(CLOSED)], largest=2.5) == 2.5  # no error at all there


@pytest.mark.filterwarnings("ignore::ftseries.ConvergenceWarning")
def test_the_border_has_a_tooth_where_the_error_changes_its_sign(sol):
    mu = np.linspace(-0.26, -0.22, 17)
    edge = pictures.reach(sol, mu)
    signs = np.sign(sol.evaluate("a", lam=edge, mu=mu) - mathieu.eigenvalue(edge, mu))
    (change,) = np.flatnonzero(np.diff(signs))
    assert edge.argmax() in (change, change + 1)


def test_reach_stays_inside_the_radius_of_convergence_of_dlmf_28_6_1(sol):
    radius = np.sqrt(2 * 3.7699574940)
    low, high = (pictures.reach(sol.truncate(order), [0.0])[0] for order in (20, 99))
    assert low < high < radius < 1.02 * high


def test_eigenvalue_shows_the_ordinary_mathieu_curve(sol):
    line, mark = drawn(pictures.eigenvalue, sol, [(LAM, MU)]).lines
    lam, mu, a = line.get_data_3d()
    assert np.all(np.asarray(mu) == 0) and lam[0] == 0 and lam[-1] > 2.7
    np.testing.assert_allclose(a, mathieu_b(1, np.asarray(lam) ** 2 / 2), rtol=0, atol=1e-11)
    assert mark.get_data_3d()[2][0] == sol.evaluate("a", lam=LAM, mu=MU)      # in the surface


def test_numerical_follows_the_closed_form(sol):
    """Some 1e-12 of the integrator, times the growth of an error off the periodic solution."""
    x = np.linspace(-np.pi, 2 * np.pi, 31)
    found = pictures.numerical(sol, x, 1.7, float(CLOSED))
    np.testing.assert_allclose(found, closed_psi(x, 1.7), rtol=0, atol=1e-10)


def test_psi_shows_both_curves(sol):
    _, solid, dashed = drawn(pictures.psi, sol, LAM, MU).lines
    assert solid.get_linestyle() == "-" and dashed.get_linestyle() == "--"
    x = dashed.get_xdata()
    assert x[0] == 0 and x[-1] == pytest.approx(2 * np.pi)
    true = mathieu.eigenfunction(x, LAM, MU)
    assert np.max(abs(dashed.get_ydata() - true)) < 1e-5
    assert 1e-3 < np.max(abs(solid.get_ydata() - dashed.get_ydata())) < 0.02


def test_difference_grows_from_period_to_period(sol):
    line = drawn(pictures.difference, sol, LAM, MU, periods=5).lines[1]
    delta = abs(line.get_ydata())
    largest = [delta[200 * k:200 * k + 201].max() for k in range(5)]
    assert delta[0] == 0 and np.all(np.diff(largest) > 0) and largest[4] > 20 * largest[0]


def test_potential_is_that_of_the_equation():
    line = drawn(pictures.potential, [(1.5, 0.4)]).lines[0]
    x = line.get_xdata()
    psi, bend = (mathieu.eigenfunction(x, 1.5, 0.4, derivative=d) for d in (0, 2))
    a = mathieu.eigenvalue(1.5, 0.4)
    np.testing.assert_allclose((line.get_ydata() - a) * psi, bend, rtol=0, atol=1e-11)


def test_angles_are_labelled_in_multiples_of_pi():
    axes = drawn(pictures.potential, [(1, 0)])
    shown = [tick.get_text() for tick in axes.get_xticklabels()]
    assert shown == [r"$-\pi$", r"$-\pi/2$", "0", r"$\pi/2$", r"$\pi$"]


def test_well_shows_the_eigenfunction_on_its_level():
    potential, level, wave = drawn(pictures.well, LAM, MU).lines
    a = mathieu.eigenvalue(LAM, MU)
    assert set(level.get_ydata()) == {a}
    x, height = wave.get_xdata(), wave.get_ydata() - a
    true = mathieu.eigenfunction(x, LAM, MU)
    np.testing.assert_allclose(height / height.max(), true / true.max(), rtol=0, atol=1e-12)
    assert potential.get_ydata()[200] == pytest.approx(LAM**2 + LAM**4 * MU)


def test_bands_are_shaded_between_their_edges():
    lam = np.linspace(0, 2, 5)
    edges = mathieu.band_edges(lam, MU).T
    axes = drawn(pictures.bands, lam, edges, [(LAM, mathieu.eigenvalue(LAM, MU))])
    assert len(axes.collections) == 2 and len(axes.lines) == 6
    first = axes.collections[0].get_paths()[0].vertices
    assert first[:, 1].min() == edges[0].min() and first[:, 1].max() == edges[1].max()
