"""The pictures of the figure eight show the orbit, its triangle, the zeros and the distances."""

import xml.etree.ElementTree as ET

import draw_eight
import numpy as np
import pytest
from matplotlib.figure import Figure

import ftseries as fts
from ftseries import figure_eight as eight
from ftseries.figures import figure_eight as pictures
from ftseries.figures import style
from ftseries.references import newton

PAPER_LAM = 2.07552  # (E7)


@pytest.fixture(scope="module")
def sol():
    return fts.solve(fts.FigureEight(), order=30)


@pytest.fixture
def ax():
    with style.context():
        figure = Figure()
        yield figure.subplots()
        figure.canvas.draw()


def curves(ax):
    """Every line as complex numbers x + iy."""
    return [np.asarray(x, float) + 1j * np.asarray(y, float)
            for x, y in (line.get_data() for line in ax.lines)]


def labelled(ax, label):
    (line,) = (line for line in ax.lines if line.get_label() == label)
    return line.get_data()


def test_choreography_joins_the_line_and_the_isosceles_triangle(ax):
    pictures.choreography(ax, newton.figure_eight)
    orbit, line, *dots = curves(ax)[:9]
    triangle = dots.pop(3)
    assert np.ptp(orbit.real) > 3 * np.ptp(orbit.imag)                   # lying
    # Rounding of the reference is 1e-14.
    assert abs(line[0] + line[1]) < 1e-13 and abs(line[2]) < 1e-13
    sides = abs(np.diff(triangle))                                       # 1'2', 2'3', 3'1'
    assert abs(sides[0] - sides[2]) < 1e-13 and sides[1] < sides[0] / 2
    assert np.allclose(np.ravel(dots), [*line[:3], *triangle[:3]], rtol=0, atol=0)
    names = [text.get_text() for text in ax.texts if text.arrow_patch is None]
    assert names == ["$1$", "$2$", "$3$", "$1'$", "$2'$", "$3'$"]
    colours = [line.get_color() for line in ax.lines if line.get_marker() == "o"]
    assert colours == [*style.BODIES, *style.BODIES]
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("$x$", "$y$")


def test_choreography_shows_where_the_bodies_go(ax):
    pictures.choreography(ax, newton.figure_eight)
    bodies, velocity = (-1j * newton.figure_eight(0.0, d) for d in (0, 1))
    ends = [complex(*text.xy) for text in ax.texts if text.arrow_patch is not None]
    turn = np.angle((np.array(ends) - bodies) / velocity)
    assert abs(turn).max() < 0.2                        # the chord of a short arc


def test_orbits_are_closed_and_upright(ax, sol):
    t = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    orbit = eight.positions(sol, t, PAPER_LAM)[2]
    pictures.orbits(ax, {"ours": orbit, "true": newton.figure_eight(t)[2]})
    first, second = curves(ax)
    assert first[0] == first[-1] and np.ptp(first.imag) > 3 * np.ptp(first.real)
    assert np.allclose(first, second, rtol=0, atol=1.6e-3)               # the paper's distance
    assert ax.get_aspect() == 1


def test_closure_crosses_zero_at_the_printed_value(ax, sol):
    lam = np.linspace(0, 2.4, 241)
    pictures.closure(ax, sol, range(8, 31, 2), lam)
    assert len(ax.lines) == 12 + 1                                       # and the axis
    for order in (8, 30):
        x, y = labelled(ax, f"order {order}")
        crossing = np.flatnonzero(y[:-1] * y[1:] < 0)[0]
        zero = np.interp(0, -y[crossing:crossing + 2], x[crossing:crossing + 2])
        assert abs(zero - PAPER_LAM) < 2.5e-3                            # scatter of (E7)
        assert abs(y[0] - 3 * 3 ** (1 / 3)) < 1e-14
    (inset,) = ax.child_axes
    low, high = inset.get_xlim()
    assert low < PAPER_LAM < high


def test_zeros_show_what_they_are_given(ax):
    found = {6: 2.09531, 8: 2.07759}
    pictures.zeros(ax, found, PAPER_LAM, newton.figure_eight_lambda())
    x, y = labelled(ax, r"$\lambda_n$")
    assert dict(zip(x, y, strict=True)) == found
    heights = {line.get_label(): line.get_ydata()[0] for line in ax.lines}
    assert heights[r"mean $\lambda_1$"] == PAPER_LAM
    assert round(heights[r"true orbit $\lambda_0$"], 5) == 2.07568


def test_distance_is_in_thousandths(ax, sol):
    t = np.linspace(0, 2 * np.pi, 241)
    gap = np.linalg.norm(eight.positions(sol, t, PAPER_LAM) - newton.figure_eight(t), axis=0)
    pictures.distance(ax, t, gap)
    (curve,) = curves(ax)
    assert 1.6 <= curve.imag.max() < 1.7                                 # printed: 1.6e-3
    assert ax.get_xlim() == (0, 2 * np.pi)


def test_chain_of_vectors_leaves_the_gap(ax):
    """r_23, r_12, r_31 in this order, the gap centred."""
    pictures.head_to_tail(ax, np.array([1 + 1j, 1 - 1j, -1.5]), "a title")
    gap, *_ = curves(ax)
    assert np.allclose(gap, [-0.25, 0.25])
    arrows = [text for text in ax.texts if text.arrow_patch is not None]
    assert [arrow.xy for arrow in arrows] == [(0.75, -1), (1.75, 0), (0.25, 0)]
    assert ax.get_title() == "a title"


@pytest.mark.parametrize("body", [False, True])
def test_arrows_lead_to_the_point_of_the_orbit(ax, sol, body):
    t, lam = 0.7, 2.0
    pictures.wheels(ax, eight.expanded(sol), lam, t, body=body)
    tip = curves(ax)[-1][0]
    expected = eight.positions(sol, t, lam)[2] if body else eight.relative(sol, t, lam)[0]
    assert abs(tip - expected) < 3e-3                   # what the second expansion leaves out
    ends = [text.xy for text in ax.texts if text.arrow_patch is not None]
    assert complex(*ends[-1]) == tip


def test_lengths_show_the_constant_arrow_vanish(ax, sol):
    lams = np.linspace(0, 2.2, 23)
    pictures.lengths(ax, eight.expanded(sol), lams, 1.0)
    _, still = labelled(ax, "$n=0$")
    assert still[0] == 3 ** (1 / 3) and (still[:-2] > 0).all() and still[-1] < 0
    _, turning = labelled(ax, r"$n=\pm1$")
    assert turning[0] == 0 and (np.diff(turning[:20]) > 0).all()


def test_drift_and_convergence_are_logarithmic(ax):
    pictures.drift(ax, [0.5, 1, 2], {"energy": [1, 1e-2, 1e-4]})
    x, y = labelled(ax, "energy")
    assert np.array_equal(x, [0.5, 1, 2]) and np.array_equal(y, [1, 1e-2, 1e-4])
    assert ax.get_yscale() == "log"
    ax.clear()
    pictures.convergence(ax, [6, 8], [1e-2, 1e-3])
    assert ax.get_yscale() == "log" and ax.get_xlabel() and ax.get_ylabel()


def test_emblem_puts_each_body_on_the_eight_at_the_end_of_its_trail(ax):
    pictures.emblem(ax, newton.figure_eight)
    orbit, *bodies = curves(ax)
    for body, trail in zip(bodies, ax.collections, strict=True):
        # Between two of 1200 samples of the curve lie 2π/1200 · speed, about 0.007.
        assert abs(orbit - body).min() < 0.007
        last = trail.get_segments()[-1][-1]
        assert body[0] == last[0] + 1j * last[1]
    assert not ax.axison


@pytest.mark.parametrize("draw, stored", [
    (draw_eight.draw, "assets/eight.svg"), (draw_eight.draw_icon, "static/icon.svg")])
def test_stored_pictures_are_those_that_the_tool_draws(tmp_path, draw, stored):
    draw(tmp_path / "fresh.svg")
    fresh, stored = numbers(tmp_path / "fresh.svg"), numbers(draw_eight.BOOK / stored)
    # Six decimals are written; a point of a picture needs fewer on other machines.
    assert fresh.shape == stored.shape and abs(fresh - stored).max() < 1e-3


def numbers(path):
    """All coordinates of an SVG's paths."""
    words = " ".join(node.get("d", "") for node in ET.parse(path).iter()).split()
    return np.array([float(word) for word in words if word[-1].isdigit()])
