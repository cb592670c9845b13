"""The small explorers of the front page, "The idea" and the cubic: alive, secular, rolling."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import ftseries as fts
from ftseries import explorers
from ftseries.explorers import base
from ftseries.explorers.alive import AliveView
from ftseries.explorers.rolling import RollingView
from ftseries.explorers.secular import HardSpring, SecularView, exact, taylor


@pytest.mark.parametrize("name", ["alive", "secular", "rolling"])
def test_it_is_still_in_python_and_has_a_picture(name):
    explorer = getattr(explorers, name)()
    assert not explorer.view.playing and "Play" in explorer.controls
    bundle, metadata = explorer._repr_mimebundle_()
    assert bundle["image/png"].startswith("iVBOR") and metadata["image/png"]["alt"] == explorer.alt


@pytest.mark.parametrize("make", [
    lambda: explorers.secular(lam=0.95), lambda: explorers.rolling(lam=3.1),
    lambda: explorers.rolling(order=26)])
def test_values_outside_the_sliders_are_refused(make):
    with pytest.raises(fts.InputError, match="choose a value in this range"):
        make()


def test_the_exact_motion_is_that_of_the_hard_spring():
    t = np.linspace(0, 60, 31)
    run = solve_ivp(lambda t, y: [y[1], -y[0] - y[0]**3], (0, 60), [0.7, 0], "DOP853", t_eval=t,
                    rtol=1e-13, atol=1e-14)
    assert abs(run.y[0] - exact(t, 0.7)).max() < 1e-9       # 60 units of time at 1e-13 a step


def test_the_taylor_series_is_that_of_the_fourier_taylor_series_torn_apart():
    """Their difference to the order 3 in λ: halving λ makes it 2^5 times smaller."""
    sol, t = fts.solve(HardSpring(), order=5), np.linspace(0, 3, 7)
    large, small = (abs(taylor(t, lam) - sol.evaluate("x", t, lam=lam)).max()
                    for lam in (0.02, 0.01))
    assert abs(np.log2(large / small) - 5) < 0.01


def test_secular_agrees_with_python(run_javascript):
    places = [(0.3, 0.0), (0.5, 17.3), (0.9, 59.0)]
    found = run_javascript(
        "output = input.map(([lam, t]) => [exactly(t, lam), byTaylor(t, lam)]);", places,
        *base.SHARED, *SecularView.scripts)
    expected = [(exact(t, lam), taylor(t, lam)) for lam, t in places]
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)


def test_the_tour_of_the_particle_ends_before_the_separatrix(run_javascript):
    tour, largest = run_javascript("output = [TOUR, LARGEST];", None, *base.SHARED,
                                   *RollingView.scripts)
    assert tour == sorted(tour) and tour[0] == explorers.rolling().view.lam
    assert tour[-1] < largest == 3


def test_the_eight_of_the_front_page_is_that_of_newton(run_javascript):
    view = explorers.alive().view
    found = np.array(run_javascript("""
        const eight = new Eight(new Series(input.data.r, "r"), new Series(input.data.phi, "phi"));
        output = bodiesOf(eight.set(input.lam, 100).relatives(0.6)).map(lying);
        """, {"data": view.data, "lam": view.lam}, *base.SHARED, *AliveView.scripts))
    newton = 1j * fts.references.newton.figure_eight(0.6)
    assert abs(found @ [1, 1j] - newton).max() < 1e-4       # order 100: λ to 4e-6
