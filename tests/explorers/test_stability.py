"""js/stability.js against power series in 30 digits; controls and picture."""

import json

import numpy as np
import pytest

from ftseries import InputError
from ftseries.explorers.stability import StabilityView, stability
from ftseries.references import floquet

FILES = ("series.js", "plot.js", "view.js", "stability.js")


def test_monodromy_matrix(run_javascript):
    """Relative to the largest element, which reaches some thousands."""
    random = np.random.default_rng(4)
    places = np.stack([random.uniform(-8, 12, 8), random.uniform(0, 3, 8),
                       random.uniform(-0.5, 0.5, 8)], axis=1).round(3)
    found = run_javascript("output = input.map((place) => monodromy(...place));",
                           places.tolist(), *FILES)
    for place, values in zip(places, found):
        exact = np.array(floquet.hill_monodromy(*place).tolist(), dtype=float).ravel()
        assert np.abs(np.array(values) - exact).max() < 1e-10 * max(1, np.abs(exact).max())


def test_multipliers_solve_the_quadratic_equation(run_javascript):
    found = run_javascript("output = input.map(multipliers);", [-3, -2, -1, 0, 1.5, 2, 7], *FILES)
    for d, pair in zip([-3, -2, -1, 0, 1.5, 2, 7], found):
        first, second = (complex(*value) for value in pair)
        assert first * second == pytest.approx(1, abs=1e-14)
        assert first + second == pytest.approx(d, abs=1e-14)
        assert abs(first) >= abs(second) * (1 - 1e-14)


def test_explorer_has_its_controls_and_a_picture():
    explorer = stability(a=1.0, lam=1.5, mu=0.1)
    assert {name: control.value for name, control in explorer.controls.items()} == {
        "a": 1.0, "λ": 1.5, "μ": 0.1}
    assert explorer.picture()[:4] == b"\x89PNG"
    assert "a = 1" in explorer.alt and json.dumps(explorer.alt)


def test_values_outside_are_refused():
    with pytest.raises(InputError, match="outside"):
        stability(a=40)
    with pytest.raises(InputError):
        StabilityView(a="x")
