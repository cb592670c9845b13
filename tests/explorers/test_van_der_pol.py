"""js/limit_cycle.js and js/van_der_pol.js against Python's limit cycle and Padé approximants."""

import base64
import importlib

import numpy as np
import pytest

from ftseries import InputError
from ftseries.explorers import van_der_pol
from ftseries.references.van_der_pol import LimitCycle

module = importlib.import_module("ftseries.explorers.van_der_pol")
pytestmark = pytest.mark.filterwarnings("ignore::ftseries.ConvergenceWarning")

SHARED = ("series.js", "axes.js", "plot.js", "view.js", "limit_cycle.js")
FILES = (*SHARED, "van_der_pol.js")
TOLERANCE = 1e-10                   # what the page promises


@pytest.fixture(scope="module")
def explorer():
    return van_der_pol(eps=2.5, order=24)


@pytest.fixture(scope="module")
def sol():
    return module.solution(65)


def test_the_integrated_cycle(run_javascript):
    """A Taylor method against Runge and Kutta's; at ε = 10 a jump takes 1/50 of the period."""
    values, phases = [0, 0.05, 0.5, 1, 2.5, 5, 10], np.linspace(-1, 7, 33)
    found = run_javascript("""
        output = input[0].map((eps) => {
          const cycle = limitCycle(eps);
          return [cycle.omega, cycle.amplitude, input[1].map(cycle.at)];
        });""", [values, phases.tolist()], *SHARED)
    for eps, (omega, amplitude, states) in zip(values, found):
        cycle = LimitCycle(eps)
        assert abs(omega - cycle.omega) < TOLERANCE
        assert abs(amplitude - cycle.amplitude) < TOLERANCE
        x, v = np.array(states).T
        assert np.abs(x - cycle(phases)).max() < TOLERANCE * (1 + eps)
        assert np.abs(v - cycle.speed(phases)).max() < TOLERANCE * (1 + eps)**2


def test_the_pade_approximants(run_javascript, explorer, sol):
    """Bit for bit the same coefficients: what is left is rounding, relative to each value."""
    places = [[n, eps] for n in module.ORDERS for eps in (0, 0.7, 1.85, 2.5, 4, 10)]
    found = run_javascript("""
        output = input.places.map(([n, eps]) => resum(decoded(input.pades[n], n), eps));
        """, {"pades": explorer.view.pades, "places": places}, *FILES)
    approximants = {n: module.approximants(sol, n) for n in module.ORDERS}
    for (n, eps), page in zip(places, found):
        for mine, theirs in zip(module.resum(approximants[n], eps), page.values()):
            assert np.allclose(theirs, mine, rtol=TOLERANCE, atol=TOLERANCE)


@pytest.mark.parametrize("eps, bound", [(1, 1e-10), (1.8, 1e-5), (3, 0.05), (5, 0.3)])
def test_pade_goes_on_where_the_series_fails(sol, eps, bound):
    """The radius of convergence is 1.85: order 32 against the integrated cycle."""
    cycle, tau = LimitCycle(eps), np.linspace(0, np.pi, 49)
    omega, x, v = module.resum(module.approximants(sol, 32), eps)
    assert abs(omega - cycle.omega) < bound
    assert np.abs(x - cycle(tau)).max() < bound
    assert np.median(np.abs(v - cycle.speed(tau))) < bound
    plain = abs(sol.evaluate("omega", lam=eps**0.5) - cycle.omega)
    assert (plain > 1) == (eps > 1.85)


def test_the_mirror_image_is_the_second_quarter(sol):
    """x(π - τ; ε) = -x(τ; -ε), checked against approximants made at those phases."""
    from ftseries.analysis import pade
    from ftseries.resum import at_phase
    _, x, _ = module.resum(module.approximants(sol, 24), 2.0)
    for i in (0, 7, 20):
        tau = np.pi - module.PHASES[i]
        direct = pade(at_phase(sol, "y", tau)[1:50:2])(2.0)
        assert x[48 - i] == pytest.approx(direct, abs=1e-9)


def test_series_are_those_of_the_package(run_javascript, explorer, sol):
    eps = 1.3
    found = run_javascript("""
        const [x, omega] = ["x", "omega"].map((name) => new Series(input[name], name));
        output = [omega.scalar(1.3, 24), x.at(x.amplitudes(1.3, 24), 0.7)];
        """, explorer.view.data, "series.js")
    cut = sol.truncate(49)
    w = cut.evaluate("omega", lam=eps**0.5)
    assert abs(found[0] - w) < TOLERANCE
    assert abs(found[1] - cut.evaluate("y", 0.7 / w, lam=eps**0.5) / eps**0.5) < TOLERANCE


@pytest.mark.parametrize("spoil", [
    lambda parts: {},
    lambda parts: parts | {"slope": ""},
    lambda parts: parts | {"x": parts["x"][:40]},
    lambda parts: parts | {"omega": base64.b64encode(np.full(6, np.nan).tobytes()).decode()},
])
def test_approximants_that_cannot_be_shown(run_javascript, explorer, spoil):
    parts = spoil(explorer.view.pades["8"])
    found = run_javascript("""
        try {
          decoded(input, 8);
        } catch (error) {
          output = [error instanceof Complaint, error.message];
        }""", parts, *FILES)
    assert found == [True, "The Padé approximants of order 8 are missing or not finite."]


def test_controls_and_picture(explorer):
    assert {name: control.value for name, control in explorer.controls.items()} == {
        "ε": 2.5, "order": 24, "Padé": True}
    assert explorer.view.nearest == 3.4202
    assert explorer.picture()[:4] == b"\x89PNG"
    assert "ε = 2.5" in explorer.alt
    assert van_der_pol(eps=0, order=8, resummed=False).picture()[:4] == b"\x89PNG"


@pytest.mark.parametrize("options, message", [
    ({"eps": 11}, "ε = 11.0 is outside 0.0 … 10.0"), ({"order": 7}, "order=7: .* 8, 16, 24, 32"),
    ({"order": 25}, "order=25: .* 8, 16, 24, 32"), ({"eps": "a"}, "eps"),
])
def test_refusals(options, message):
    with pytest.raises(InputError, match=message):
        van_der_pol(**options)
