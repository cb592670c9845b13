"""js/hill.js against the Hill matrix and the Mathieu functions of ftseries.references."""

import numpy as np
import pytest

from ftseries import explorers
from ftseries.explorers import base
from ftseries.explorers.mathieu import region
from ftseries.references import mathieu


@pytest.fixture(scope="module")
def places():
    random = np.random.default_rng(6)
    lam = np.concatenate([random.uniform(0.01, 3, 300), [0.01, 3, 3, 3]])
    mu = np.concatenate([random.uniform(-0.5, 0.5, 300), [0, 0, 0.5, -0.5]])
    return lam, mu


def test_eigenvalue_and_coefficients(run_javascript, places):
    lam, mu = places
    found = run_javascript("output = input.map(([lam, mu]) => { const { a, c } = lowest(lam, mu); "
                           "return [a, ...c]; });", np.transpose(places).tolist(), "hill.js")
    found = np.array(found)
    c = mathieu.sine_coefficients(lam, mu)
    size = min(c.shape[1], found.shape[1] - 1)
    assert np.abs(found[:, 0] - mathieu.eigenvalue(lam, mu)).max() < 1e-12
    assert np.abs(found[:, 1:size + 1] - c[:, :size]).max() < 1e-12
    assert np.abs(found[:, size + 1:]).max(initial=0) < 1e-12


def test_ordinary_mathieu_equation(run_javascript):
    lam = np.linspace(0, 3, 31)
    found = run_javascript("output = input.map((lam) => lowest(lam, 0).a);", lam.tolist(),
                           "hill.js")
    assert np.abs(found - mathieu.mathieu_b(lam)).max() < 1e-12


def test_eigenfunction(run_javascript):
    x = np.linspace(0, 7, 29)
    found = run_javascript("output = eigenfunction(input, lowest(2, -0.3).c);", x.tolist(),
                           "hill.js")
    assert np.abs(found - mathieu.eigenfunction(x, 2, -0.3)).max() < 1e-12


def test_region_is_that_of_the_known_radius():
    """At μ = 0 the radius in |q| is 3.7699574940, DLMF table 28.6.1."""
    found = region(points=5)
    assert found["mu"] == [-0.5, -0.25, 0.0, 0.25, 0.5]
    assert found["radius"][2] == round(float(np.sqrt(2 * 3.7699574940)), 4)


def test_edge_interpolates(run_javascript):
    found = run_javascript("""
        const region = { mu: [-1, 0, 2], radius: [3, 1, 5] };
        output = [-1, -0.5, 0, 1, 2].map((mu) => edge(region, mu));
        """, None, *base.SHARED, "hill.js", "mathieu.js")
    assert found == [3, 2, 1, 3, 5]


def test_colours_are_matplotlibs(run_javascript):
    from matplotlib import colormaps

    errors = np.geomspace(1e-15, 1, 9)
    found = run_javascript("output = input.map((error) => colour(error));", [0, *errors, 1e3],
                           *base.SHARED, "hill.js", "mathieu.js")
    expected = 255 * colormaps["cividis"](np.linspace(0, 1, 9))[:, :3]
    assert np.abs(np.array(found[1:-1]) - expected).max() < 1
    assert found[0] == found[1] and found[-2] == found[-1]


def test_controls():
    controls = explorers.mathieu(stored=20).controls
    assert list(controls) == ["λ", "μ", "order"]
    assert (controls["λ"].value, controls["μ"].value) == (2.0, -0.3)
