"""The eigenvalue b_1(q) of Mathieu's equation on a grid of q = λ²/2."""

import numpy as np
import pytest
from scipy.linalg import eigvals_banded
from scipy.special import mathieu_b

import ftseries as fts
from ftseries.references import mathieu

Q = np.linspace(0, 2.5, 2000)
#: every hundredth point
SAMPLE = slice(0, len(Q), 100)

pytestmark = pytest.mark.benchmark(group="eigenvalues of Mathieu's equation")


@pytest.fixture(scope="module")
def truth():
    return np.array([float(mathieu.eigenvalue(np.sqrt(2 * q), dps=25)) for q in Q[SAMPLE]])


@pytest.fixture
def compare(measure, truth):
    def run(function, **what):
        measure(function, lambda a: np.abs(a[SAMPLE] - truth).max(), **what)
    return run


@pytest.mark.parametrize("order", [24, 48, 99])
def bench_series(compare, order):
    """The solve is not part of it; it is done once for all grids."""
    solution = fts.solve(fts.GeneralizedMathieu(mu=0), order)
    compare(lambda: solution.evaluate("a", lam=np.sqrt(2 * Q)), method="series", order=order)


def bench_series_solved(compare):
    compare(lambda: fts.solve(fts.GeneralizedMathieu(mu=0), 99, "float").evaluate(
        "a", lam=np.sqrt(2 * Q)), method="series, with its solve", order=99)


def bench_resummed(compare):
    summed = fts.solve(fts.GeneralizedMathieu(mu=0), 48).resum()
    summed.approximants("a")
    compare(lambda: summed.evaluate("a", lam=np.sqrt(2 * Q)), method="series, resummed", order=48)


def bench_scipy(compare):
    compare(lambda: mathieu_b(1, Q), method="mathieu_b of SciPy")


@pytest.mark.parametrize("size", [4, 8, 12])
def bench_hill(compare, size):
    """Modes sin x, sin 3x, …: squares on the diagonal, q beside it, and 1 - q first."""
    def run():
        band = np.empty((2, size))
        values = []
        for q in Q:
            band[0], band[1] = (2 * np.arange(size) + 1.0)**2, q
            band[0, 0] -= q
            values.append(eigvals_banded(band, lower=True, select="i", select_range=(0, 0))[0])
        return np.array(values)
    compare(run, method="Hill's matrix, eigvals_banded", size=size)
