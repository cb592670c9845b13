"""The triangle of coefficients: its texts are the solution's exact numbers."""

import numpy as np
import pytest
import sympy as sp

import ftseries as fts
from ftseries import explorers
from ftseries.explorers import base


def read(text):
    """A displayed number as SymPy reads it."""
    for sign, code in {"∛3": "3**Rational(1,3)", "√6": "sqrt(6)", "√3": "sqrt(3)", "^": "**",
                       "·": "*", "−": "-", "μ": "mu"}.items():
        text = text.replace(sign, code)
    return sp.sympify(text)


@pytest.mark.parametrize("problem, name, order, parameters", [
    (fts.FigureEight(), "r", 14, {}), (fts.FigureEight(), "phi", 13, {}),
    (fts.CubicOscillator(a=1), "x", 12, {}), (fts.CubicOscillator(a=1), "omega", 12, {}),
    (fts.CubicOscillator(a=2), "omega", 8, {}),
    (fts.GeneralizedMathieu(), "psi", 11, {"mu": 0.2}),
    (fts.GeneralizedMathieu(), "a", 12, {"mu": 0.2}),
])
def test_texts_are_the_exact_numbers(problem, name, order, parameters):
    solution = fts.solve(problem, order=order)
    view = explorers.coefficients(solution, name, **parameters).view
    table = solution.table(name, **parameters)
    assert len(view.texts) == sum(np.count_nonzero(row) for row in table.values())
    for place, text in view.texts.items():
        _, n, m = map(int, place.split(","))
        exact = solution.coefficient(name, *((m,) if view.scalar else (n, m)))
        assert sp.simplify(read(text) - exact) == 0, text


def test_values_are_the_table(run_javascript):
    solution = fts.solve(fts.GeneralizedMathieu(), order=9)
    view = explorers.coefficients(solution, "psi", mu=-0.3).view
    found = run_javascript("""
        const { modes } = new Series(input.psi, "psi");
        output = modes.map(({ sine, n, taylor }) => [sine, n, ...taylor]);
        """, view.data, "series.js")
    table = solution.table("psi", mu=-0.3)
    assert {(sine, n): row for sine, n, *row in found} == {k: list(v) for k, v in table.items()}


@pytest.mark.parametrize("arithmetic, options", [("float", {}), ("ball", {"precision": 80})])
def test_other_arithmetics(arithmetic, options):
    solution = fts.solve(fts.FigureEight(), order=6, arithmetic=arithmetic, **options)
    texts = explorers.coefficients(solution, "r").view.texts
    assert float(sp.sympify(texts["0,2,6"].strip("[]").split(" ")[0])) == pytest.approx(
        5 * 3 ** (1 / 3) / 4096, rel=1e-14)


def test_long_numbers_lose_their_middle():
    view = explorers.coefficients(fts.solve(fts.FigureEight(), order=40), "r").view
    longest = max(view.texts.values(), key=len)
    assert "…" in longest and longest.endswith("characters)") and len(longest) < 200


def test_controls():
    explorer = explorers.coefficients(fts.solve(fts.FigureEight(), order=8), "phi", order=3)
    assert list(explorer.controls) == ["order", "Grow"]
    assert isinstance(explorer, base.Explorer)
    assert explorer.controls["order"].value == explorer.view.order == 3
