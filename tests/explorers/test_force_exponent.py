"""js/choreography.js and js/force_exponent.js against orbits and multipliers in Python."""

import importlib

import numpy as np
import pytest

import ftseries as fts
from ftseries import InputError, stability
from ftseries.explorers import force_exponent
from ftseries.problems import figure_eight as eight

module = importlib.import_module("ftseries.explorers.force_exponent")
FILES = ("series.js", "axes.js", "plot.js", "view.js", "choreography.js", "force_exponent.js")
FAMILY = """
    const part = (name) => new Series(input.data[name], name);
    const family = new Family(part("x"), part("y"), part("lam"));"""
EXPONENTS = ("-1/2", "-2/5", "0", "1/3", "9/10", "1", "13/10", "7/4", "2")


@pytest.fixture(scope="module")
def explorer():
    return force_exponent()


@pytest.fixture(scope="module")
def truths():
    """Refined orbits in polar coordinates: the explorer's are Cartesian, and interpolated."""
    orbit = first = fts.solve(fts.FigureEight(), order=12).refine()
    found = {}
    for exponent in sorted(EXPONENTS, key=lambda x: abs(float(fts.FigureEight(x).exponent) - 1)):
        below = fts.FigureEight(exponent).exponent < 1
        near = min(found, key=lambda x: abs(fts.FigureEight(x).exponent
                                            - fts.FigureEight(exponent).exponent), default=None)
        orbit = (found[near] if near else first).refine(fts.FigureEight(exponent))
        assert below or orbit.lam >= first.lam - 1e-13
        found[exponent] = orbit
    return found


def exponents(truths):
    return [float(orbit.problem.exponent) for orbit in truths.values()]


def test_orbits_and_lambda(run_javascript, explorer, truths):
    """The interpolation falls off like 2.76^-25 = 1e-11 of modes that are of order one."""
    t = [0.0, 0.7, 2.9]
    found = run_javascript(FAMILY + """
        output = input.alphas.map((alpha) => [family.lam(alpha), family.closest(alpha),
          input.t.map((t) => family.bodies(alpha, t))]);
        """, {"data": explorer.view.data, "alphas": exponents(truths), "t": t}, *FILES)
    for orbit, (lam, closest, places) in zip(truths.values(), found, strict=True):
        assert abs(lam - orbit.lam) < 1e-9
        expected = eight.positions(orbit, np.array(t), orbit.lam)
        assert np.abs((np.array(places) @ [1, 1j]).T - expected).max() < 1e-9
        distance = abs(eight.relative(orbit, np.linspace(0, 2 * np.pi, 2001), orbit.lam)).min()
        assert closest == pytest.approx(distance, abs=1e-6)


def test_python_interpolates_alike(truths):
    t = np.linspace(0, 6, 30)
    for orbit in truths.values():
        gap = (module.bodies(module.family(), float(orbit.problem.exponent), t)
               - eight.positions(orbit, t, orbit.lam))
        assert np.abs(gap).max() < 1e-9


def test_multipliers(run_javascript, explorer, truths):
    """A third of a period by Runge and Kutta's fourth order against twelve equations by DOP853."""
    found = run_javascript(FAMILY + """
        output = input.alphas.map((alpha) => family.multipliers(alpha, 480));
        """, {"data": explorer.view.data, "alphas": exponents(truths)}, *FILES)
    for orbit, values in zip(truths.values(), found, strict=True):
        alpha = float(orbit.problem.exponent)
        motion = stability.bodies(lambda t, o=orbit: eight.positions(o, t, o.lam),
                                  force=lambda d, a=alpha: d**-(a + 1))
        rho = np.linalg.eigvals(motion.essential)
        for re, im in values:
            value = complex(re, im)
            # 4e-3 near multipliers that coincide, as the two 1s of α = 2 do
            assert min(abs(rho - value)) < (4e-3 if alpha == 2 else 1e-6) * max(1, abs(value))


def test_multipliers_of_known_traces(run_javascript):
    """p of a third: 2 is ρ = 1, 1 is exp(iπ/3) whose cube is -1, 2.5 is 2, cube 8."""
    found = run_javascript("output = input.map((p) => multiplier([p, 0]));",
                           [2, 1, 2.5, -2.5, 0], *FILES)
    values = np.array(found) @ [1, 1j]
    assert np.abs(values.real - [1, -1, 8, -8, 0]).max() < 1e-14
    assert np.abs(np.abs(values) - [1, 1, 8, 8, 1]).max() < 1e-14


def test_explorer_has_its_controls_and_a_picture():
    explorer = force_exponent(alpha=0.25, t=1.5)
    assert {name: control.value for name, control in explorer.controls.items()} == {
        "α": 0.25, "t": 1.5}
    assert explorer.picture()[:4] == b"\x89PNG"
    assert "α = 0.25" in explorer.alt


@pytest.mark.parametrize("values", [{"alpha": 3}, {"alpha": -0.6}, {"t": 7}])
def test_values_outside_are_refused(values):
    with pytest.raises(InputError, match="outside"):
        force_exponent(**values)
