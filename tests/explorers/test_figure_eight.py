"""The explorer of the figure eight: JavaScript and Python give the same numbers."""

import numpy as np
import pytest

import ftseries as fts
from ftseries.explorers import base
from ftseries.explorers.figure_eight import RANGE, FigureEightView, figure_eight
from ftseries.references import newton

CASES = 40


@pytest.fixture(scope="module")
def explorer():
    return figure_eight(stored=60)


@pytest.fixture(scope="module")
def solution():
    return fts.solve(fts.FigureEight(), order=60)


@pytest.fixture
def javascript(run_javascript):
    """``javascript(script, data)``: the script, run after the explorer's own."""
    return lambda script, data: run_javascript(script, data, *base.SHARED,
                                               *FigureEightView.scripts)


@pytest.fixture(scope="module")
def cases():
    random = np.random.default_rng(8)
    return [(float(random.uniform(*RANGE)), int(random.integers(1, 61)),
             float(random.uniform(0, 2 * np.pi))) for _ in range(CASES)]


EIGHT = """
const eight = new Eight(new Series(input.data.r, "r"), new Series(input.data.phi, "phi"));
"""


@pytest.mark.filterwarnings("ignore::ftseries.ConvergenceWarning")
def test_positions_and_closure_agree_with_python(javascript, explorer, solution, cases):
    found = javascript(EIGHT + """
        output = input.cases.map(([lam, order, t]) => ({
          S: eight.closure(lam, order),
          bodies: bodiesOf(eight.set(lam, order).relatives(t)),
        }));""", {"data": explorer.view.data, "cases": cases})
    for (lam, order, t), values in zip(cases, found, strict=True):
        cut = solution.truncate(order)
        bodies = np.array(values["bodies"]) @ [1, 1j]
        assert abs(bodies - fts.figure_eight.positions(cut, t, lam)).max() < 1e-10
        assert abs(values["S"] - fts.figure_eight.closure(cut, lam)) < 1e-10


def test_zeros_agree_with_python(javascript, explorer, solution):
    orders = [1, 2, 3, 6, 12, 17, 30, 45, 60]
    found = javascript(EIGHT + "output = input.orders.map((order) => eight.zero(order));",
                       {"data": explorer.view.data, "orders": orders})
    for order, zero in zip(orders, found, strict=True):
        assert abs(zero - fts.figure_eight.closure_zero(solution.truncate(order))) < 1e-10


def test_without_a_zero_the_search_says_so(javascript, explorer):
    """At order 0 the chain is a straight line for every λ."""
    found = javascript(EIGHT + "output = String(eight.zero(0));", {"data": explorer.view.data})
    assert found == "NaN"


def test_the_orbit_is_body_1_and_the_background_newtons_body_3(javascript, explorer, solution):
    found = javascript(EIGHT + """
        const newton = (name) => Array.from(samples(new Series(input.data[name], name)));
        const { orbit } = eight.set(input.lam, 60).motion();
        output = {
          grid: Array.from(GRID),
          orbit: [Array.from(orbit.x), Array.from(orbit.y)],
          truth: [newton("x"), newton("y")],
        };
        """, {"data": explorer.view.data, "lam": 2.0})
    t = np.array(found["grid"])
    orbit, truth = ([1, 1j] @ np.array(found[name]) for name in ("orbit", "truth"))
    assert abs(orbit - fts.figure_eight.positions(solution, t, 2.0)[0]).max() < 1e-10
    assert abs(truth - newton.figure_eight(t)[2]).max() < 1e-10


@pytest.mark.parametrize("lam, order, t", [(0.0, 60, 1.0), (1.3, 12, 0.7), (2.2, 6, 3.0)])
def test_corners_miss_the_bodies_by_sixths_of_the_gap(javascript, explorer, lam, order, t):
    """By (E4a), for a chain r_23, r_12, r_31 whose gap is centred on body 3."""
    found = javascript(EIGHT + """
        const relatives = eight.set(input.lam, input.order).relatives(input.t);
        const bodies = bodiesOf(relatives);
        output = { S: gap(relatives), bodies, corners: corners(relatives, bodies) };
        """, {"data": explorer.view.data, "lam": lam, "order": order, "t": t})
    bodies, S = np.array(found["bodies"]), np.array(found["S"])
    expected = bodies[[2, 1, 0, 2]] + np.multiply.outer([-1 / 2, -1 / 6, 1 / 6, 1 / 2], S)
    assert abs(np.array(found["corners"]) - expected).max() < 1e-12


def test_the_chain_closes_at_the_zero(javascript, explorer):
    """S is constant in the limit only: at order 60 and λ_60 it stays below 1e-4, S_x(0) is zero."""
    found = javascript(EIGHT + """
        const zero = eight.zero(60);
        eight.set(zero, 60);
        const sizes = Array.from(GRID, (t) => Math.hypot(...gap(eight.relatives(t))));
        output = [Math.max(...sizes), eight.closure(zero, 60)];
        """, {"data": explorer.view.data})
    assert found[0] < 1e-4
    assert abs(found[1]) < 1e-13


def test_the_sentence_tells_the_closure_from_the_gap(javascript, explorer, solution):
    """At order 13, λ = 2.3, |S_x(0)| is below the least |S|: S has a y, too."""
    text = javascript(EIGHT + """
        output = describe(13, 2.3, eight.closure(2.3, 13), eight.gaps(2.3, 13));
        """, {"data": explorer.view.data})
    times = np.linspace(0, 2 * np.pi, 240, endpoint=False)
    with pytest.warns(fts.ConvergenceWarning):
        S = fts.figure_eight.relative(solution.truncate(13), times, 2.3).sum(axis=0)
    assert abs(S[0].real) < abs(S).min()
    assert (f"Sₓ = −{-S[0].real:.3f} at t = 0, gap between {abs(S).min():.3f} and "
            f"{abs(S).max():.3f} in a period") in text


def test_controls_are_tied_to_the_view(explorer):
    view, controls = explorer.view, explorer.controls
    assert set(controls) == {"λ", "order", "t", "speed", "Play", "Set λ = λₙ"}
    assert (controls["λ"].min, controls["λ"].max) == RANGE
    assert (controls["order"].min, controls["order"].max) == (2, 60)
    assert controls["t"].value == view.t == view.clock
    assert not view.playing


def test_picture_without_javascript(explorer):
    bundle, metadata = explorer._repr_mimebundle_()
    assert metadata["image/png"]["alt"] == explorer.alt
    assert bundle["image/png"].startswith("iVBOR")


@pytest.mark.parametrize("spoil, complaint", [
    (lambda data: {}, "The series of r is empty"),
    (lambda data: data | {"phi": {"order": 4, "rows": [], "values": ""}},
     "The series of phi is empty"),
    (lambda data: data | {"r": base.packed({(0, 0, 0): {0: float("nan")}}, 4)},
     "The coefficients of r contain NaN"),
])
def test_bad_data_is_said_in_a_sentence(javascript, explorer, spoil, complaint):
    found = javascript("""
        try {
          const stage = { series: (name) => new Series(input.data[name], name) };
          build(stage);
        } catch (error) {
          output = [error instanceof Complaint, error.message];
        }""", {"data": spoil(explorer.view.data)})
    assert found[0] and found[1].startswith(complaint)


@pytest.mark.parametrize("values", [{"order": 13}, {"order": 1}, {"lam": 2.4}, {"t": -0.1},
                                    {"lam": float("nan")}])
def test_values_outside_the_sliders_are_refused(values):
    with pytest.raises(fts.InputError, match=f"{next(iter(values))}=.* give a number from"):
        figure_eight(stored=12, **values)
