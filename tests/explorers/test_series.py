"""js/series.js evaluates what Python evaluates, and says what it cannot show."""

import numpy as np
import pytest

import ftseries as fts
from ftseries.explorers import base

pytestmark = pytest.mark.filterwarnings("ignore::ftseries.ConvergenceWarning")

CASES = 60
TOLERANCE = 1e-10       # what the page promises; rounding alone is some 1e-13
EVALUATE = """
const series = new Series(input.packed, "u");
const frequency = input.frequency && new Series(input.frequency, "ω");
output = input.cases.map(([lam, order, t, mu]) => {
  series.setParameter(mu);
  const amplitudes = series.amplitudes(lam, order);
  const tau = frequency ? frequency.scalar(lam, order) * t : t;
  const slope = series.slope(amplitudes, [tau])[0];
  return [series.at(amplitudes, tau), series.scalar(lam, order), slope];
});
"""


@pytest.fixture(scope="module")
def solutions():
    return {"x": fts.solve(fts.CubicOscillator(a=1), order=60),
            "psi": fts.solve(fts.GeneralizedMathieu(), order=60),
            "r": fts.solve(fts.FigureEight(), order=60)}


def cases(largest_lam, largest_mu):
    random = np.random.default_rng(3)
    return [(float(random.uniform(0, largest_lam)), int(random.integers(1, 61)),
             float(random.uniform(-10, 10)), float(random.uniform(-largest_mu, largest_mu)))
            for _ in range(CASES)]


@pytest.mark.parametrize("problem, name, largest", [
    ("x", "x", (3.5, 0)), ("psi", "psi", (2.5, 0.5)), ("r", "r", (2.3, 0)), ("r", "phi", (2.3, 0)),
])
def test_fields_agree_with_python(run_javascript, solutions, problem, name, largest):
    solution, places = solutions[problem], cases(*largest)
    packed = base.pack(solution, *solution.problem.unknowns)
    found = run_javascript(EVALUATE, {"packed": packed[name], "frequency": packed.get("omega"),
                                      "cases": places}, "series.js")
    for (lam, order, t, mu), (value, _, slope) in zip(places, found, strict=True):
        parameters = {"mu": mu} if solution.problem.parameters else {}
        cut = solution.truncate(order)
        expected = cut.evaluate(name, t, lam=lam, **parameters)
        assert abs(value - expected) < TOLERANCE * max(1, abs(expected))
        w = cut.evaluate("omega", lam=lam) if "omega" in packed else 1.0
        step = 1e-4 / w       # five points: the error is step⁴/30 times a fifth derivative
        near = cut.evaluate(name, t + step * np.array([-2, -1, 1, 2]), lam=lam, **parameters)
        derivative = near @ [1, -8, 8, -1] / (12 * step * w)
        assert abs(slope - derivative) < 1e-6 * (1 + np.abs(near).max())


@pytest.mark.parametrize("problem, name, largest",
                         [("x", "omega", (3.5, 0)), ("psi", "a", (2.5, 0.5))])
def test_scalars_agree_with_python(run_javascript, solutions, problem, name, largest):
    solution, places = solutions[problem], cases(*largest)
    found = run_javascript(EVALUATE, {"packed": base.pack(solution, name)[name], "cases": places},
                           "series.js")
    for (lam, order, _, mu), (_, value, _) in zip(places, found, strict=True):
        parameters = {"mu": mu} if solution.problem.parameters else {}
        expected = solution.truncate(order).evaluate(name, lam=lam, **parameters)
        assert abs(value - expected) < TOLERANCE * max(1, abs(expected))


def test_packing_loses_no_bit(run_javascript, solutions):
    table = solutions["r"].table("phi")
    found = run_javascript("""
        output = new Series(input, "phi").modes.map(({ sine, n, taylor }) => [sine, n, ...taylor]);
        """, base.pack(solutions["r"], "phi")["phi"], "series.js")
    assert {(sine, n): row for sine, n, *row in found} == {k: list(v) for k, v in table.items()}


def test_modes_of_both_kinds(run_javascript):
    """1 + 2 cos t + 3 λ sin t - λ² sin 2t, at two phases."""
    table = {(0, 0, 0): {0: 1.0}, (0, 1, 0): {0: 2.0}, (1, 1, 0): {1: 3.0}, (1, 2, 0): {2: -1.0}}
    found = run_javascript("""
        const u = new Series(input, "u");
        output = [0.3, 1.7].map((tau) => u.at(u.amplitudes(0.5, 2), tau));
        """, base.packed(table, 2), "series.js")
    t = np.array([0.3, 1.7])
    assert np.allclose(found, 1 + 2 * np.cos(t) + 1.5 * np.sin(t) - np.sin(2 * t) / 4, rtol=1e-14)


def test_an_order_beyond_the_stored_is_the_highest_stored(run_javascript, solutions):
    found = run_javascript("""
        const omega = new Series(input, "omega");
        output = [omega.scalar(1, 60), omega.scalar(1, 400)];
        """, base.pack(solutions["x"], "omega")["omega"], "series.js")
    assert found[0] == found[1]


NOTHING = {"order": 3, "rows": [], "values": ""}


@pytest.mark.parametrize("packed, complaint", [
    (None, "The series of u is empty: there is nothing to show."),
    (NOTHING, "The series of u is empty: there is nothing to show."),
    (base.packed({(0, 0, 0): {0: 1.0, 1: float("nan")}}, 3),
     "The coefficients of u contain NaN or infinite numbers."),
    (base.packed({(0, 0, 0): {0: float("inf")}}, 3),
     "The coefficients of u contain NaN or infinite numbers."),
    (base.packed({(0, 0, 0): {0: 1.0}}, 3) | {"rows": [[0, 0, 0, 0, 1, 2]]},
     "The coefficients of u are incomplete."),
    (base.packed({(0, 0, 0): {0: 1.0, 9: 1.0}}, 3), "The coefficients of u are incomplete."),
])
def test_what_cannot_be_shown_is_said(run_javascript, packed, complaint):
    found = run_javascript("""
        try {
          new Series(input, "u");
        } catch (error) {
          output = [error instanceof Complaint, error.message];
        }""", packed, "series.js")
    assert found == [True, complaint]
