"""The small explorers of the chapters mathieu and figure_eight: bands, closing, wheels."""

import numpy as np
import pytest

import ftseries as fts
from ftseries import explorers
from ftseries.explorers import base
from ftseries.explorers.bands import BandsView
from ftseries.explorers.closing import ClosingView
from ftseries.explorers.wheels import WheelsView
from ftseries.references import mathieu

eight = fts.figure_eight


@pytest.mark.parametrize("name", ["bands", "closing", "wheels"])
def test_it_is_still_in_python_and_has_a_picture(name):
    explorer = getattr(explorers, name)()
    assert not explorer.view.playing and "Play" in explorer.controls
    assert explorer.controls["λ"].value == explorer.view.lam
    bundle, metadata = explorer._repr_mimebundle_()
    assert bundle["image/png"].startswith("iVBOR") and metadata["image/png"]["alt"] == explorer.alt


@pytest.mark.parametrize("make", [
    lambda: explorers.bands(lam=2.5), lambda: explorers.bands(order=1),
    lambda: explorers.closing(lam=2.3), lambda: explorers.wheels(lam=-0.1)])
def test_values_outside_the_sliders_are_refused(make):
    with pytest.raises(fts.InputError, match="choose a value in this range"):
        make()


def test_bands_are_those_of_the_hill_matrix(run_javascript):
    view = explorers.bands(mu=0.1).view
    found = np.array(run_javascript(
        "output = input.lams.map((lam) => bandsAt(input.bands.lam, input.bands.edges, lam));",
        {"bands": view.bands, "lams": [0, 0.61, 1.7, 2.39]}, *base.SHARED, *BandsView.scripts))
    for lam, stripes in zip((0, 0.61, 1.7, 2.39), found, strict=True):
        edges = mathieu.band_edges(lam, 0.1)
        # linear between values of λ 1/40 apart: a'' (1/40)²/8, and four digits
        np.testing.assert_allclose(stripes.ravel()[:5], edges, rtol=0, atol=2e-3)


def test_the_dragged_end_finds_its_lambda(run_javascript):
    view = explorers.closing(order=60).view
    found = run_javascript("""
        const eight = new Eight(new Series(input.data.r, "r"), new Series(input.data.phi, "phi"));
        output = input.gaps.map((S) => lambdaOf(eight, 60, eight.zero(60), S));
        """, {"data": view.data, "gaps": [5, 3, 1.5, 0.3, 0]}, *base.SHARED, *ClosingView.scripts)
    solution = fts.solve(fts.FigureEight(), order=60)
    assert found[0] == 0
    gaps = [eight.closure(solution, lam) for lam in found[1:]]
    np.testing.assert_allclose(gaps, [3, 1.5, 0.3, 0], rtol=0, atol=4e-3)     # λ to 0.001


@pytest.mark.parametrize("lam, t", [(0.3, 0.2), (1.4, 3.0), (2.0, 5.1)])
def test_arrows_lead_to_r_12_and_to_body_3(run_javascript, lam, t):
    solution = eight.expanded(fts.solve(fts.FigureEight(), order=60))
    found = run_javascript("""
        const wheels = new Wheels(new Series(input.data.x, "x"), new Series(input.data.y, "y"));
        wheels.set(input.lam, 60);
        output = [wheels.tip(wheels.relative(input.t)), wheels.tip(wheels.body(input.t)),
                  [wheels.length(0), wheels.length(3)]];
        """, {"data": explorers.wheels().view.data, "lam": lam, "t": t}, *base.SHARED,
        *WheelsView.scripts)
    relative, body = np.array(found[:2]) @ [1, 1j]
    assert abs(relative - eight.relative(solution, t, lam)[0]) < 1e-10
    assert abs(body - eight.positions(solution, t, lam)[2]) < 1e-10
    assert abs(3 * found[2][0] - eight.closure(solution, lam)) < 1e-10 and found[2][1] == 0


def test_the_gap_of_a_period_is_told(run_javascript):
    """Eight.gaps: the least and the greatest |S| of a truncation."""
    view = explorers.figure_eight(stored=12).view
    found = run_javascript("""
        const eight = new Eight(new Series(input.r, "r"), new Series(input.phi, "phi"));
        output = eight.gaps(2.0, 12);
        """, view.data, *base.SHARED, *ClosingView.scripts)
    solution = fts.solve(fts.FigureEight(), order=12)
    t = np.linspace(0, 2 * np.pi, 240, endpoint=False)
    sizes = abs(eight.relative(solution, t, 2.0).sum(axis=0))
    assert np.allclose(found, [sizes.min(), sizes.max()], rtol=0, atol=1e-12)
    assert sizes.max() > 1.01 * sizes.min()


def test_names_leave_the_gap_its_place(run_javascript):
    """No name of an arrow is written over the name of the gap."""
    found = run_javascript("""
        const written = [];
        const context = {
          save() {}, restore() {}, strokeText() {},
          fillText(text, x, y) { written.push([text, x, y]); },
        };
        const eight = new Eight(new Series(input.r, "r"), new Series(input.phi, "phi"));
        output = [];
        for (let i = 0; i < 60; i++) {
          for (const lam of [1, 1.5, 1.7, 1.9]) {
            const relatives = eight.set(lam, 60).relatives(i / 10);
            const places = corners(relatives, bodiesOf(relatives));
            const chain = places.map(([x, y]) => [180 * x, -180 * y]);
            written.length = 0;
            drawNames(context, { color: (name) => name }, chain, 1);
            const [, gx, gy] = written.at(-1);
            for (const [, x, y] of written.slice(0, -1)) {
              output.push(Math.abs(x - gx) < 45 && Math.abs(y - gy) < 12);
            }
          }
        }""", explorers.figure_eight().view.data, *base.SHARED, *ClosingView.scripts)
    assert len(found) == 720 and not any(found)
