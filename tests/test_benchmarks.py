"""The peers that the benchmarks measure give right results: a fair comparison needs no less."""

import numpy as np
import orbits
import plain_sympy
import pytest
import sympy as sp
from sample_problems import Duffing

import ftseries as fts
from ftseries.references import newton


def cosines(f):
    """{n: the coefficient of cos nτ}."""
    return {n: c * (2 if n else 1) for n, c in plain_sympy.modes(f).items() if n >= 0 and c != 0}


def test_plain_sympy_finds_the_coefficients_of_the_eight():
    solution = fts.solve(fts.FigureEight(), 7)
    for name, rows in zip(("r", "phi"), plain_sympy.eight(7), strict=True):
        for m, row in enumerate(rows):
            expected = {n: solution.coefficient(name, n, m) for n in range(m + 1)}
            unit = sp.cbrt(3) if name == "r" else 1
            assert cosines(row) == {n: c / unit for n, c in expected.items() if c != 0}


def test_plain_sympy_finds_the_coefficients_of_duffing():
    """ε = λ², and x = λ u."""
    solution = fts.solve(Duffing(), 7)
    rows, square = plain_sympy.duffing(3)
    lam = sp.Symbol("lambda")
    omega = sum(solution.coefficient("omega", m) * lam**m for m in range(7))
    assert [sp.expand(omega**2).coeff(lam, 2 * k) for k in range(4)] == square
    for k, row in enumerate(rows):
        expected = {n: solution.coefficient("x", n, 2 * k + 1, sine=False)
                    for n in range(2 * k + 2)}
        assert cosines(row) == {n: c for n, c in expected.items() if c != 0}


@pytest.mark.parametrize("method", [
    lambda t: orbits.shooting(orbits.runge_kutta, t), orbits.collocation],
    ids=["shooting", "collocation"])
def test_orbits(method):
    """DOP853 with a tolerance of 1e-13 keeps twelve digits over a period."""
    t = np.linspace(0, 2 * np.pi, 25)
    assert np.abs(method(t) - newton.figure_eight(t)).max() < 1e-11


def test_orbit_of_heyoka():
    pytest.importorskip("heyoka", reason="needs the extra 'bench'")
    t = np.linspace(0, 2 * np.pi, 25)
    found = orbits.shooting(orbits.taylor(), t)
    assert np.abs(found - newton.figure_eight(t)).max() < 1e-12
