"""Pictures of labelled data take a dict, and say so."""

import pytest
from matplotlib.figure import Figure

import ftseries as fts
from ftseries.figures import convergence, figure_eight, gallery, how_fast, stability


@pytest.mark.parametrize("draw, name", [
    (lambda ax, data: gallery.curves(ax, [0, 1], data), "named"),
    (lambda ax, data: gallery.orbits(ax, data), "named"),
    (lambda ax, data: convergence.ratios(ax, ax, data, 1), "sequences"),
    (lambda ax, data: convergence.approach(ax, [0, 1], data, "λ"), "errors"),
    (lambda ax, data: convergence.plane(ax, [1j], inside=data), "inside"),
    (lambda ax, data: convergence.errors(ax, data), "curves"),
    (lambda ax, data: how_fast.growth(ax, data, "order"), "curves"),
    (lambda ax, data: how_fast.trade(ax, data), "curves"),
    (lambda ax, data: figure_eight.orbits(ax, data), "curves"),
    (lambda ax, data: figure_eight.drift(ax, [0, 1], data), "spreads"),
    (lambda ax, data: stability.disturbed(ax, data, {}), "distances"),
])
def test_a_list_is_refused(draw, name):
    with pytest.raises(fts.InputError, match=f"^{name} is of type list; give a dict from each"):
        draw(Figure().add_subplot(), [[1.0, 2.0]])
