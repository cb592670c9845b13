"""A hundred thousand values x(t; λ) of the cubic oscillator."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import ftseries as fts
from ftseries.references import cubic

LAM = np.linspace(0, 0.7, 1000)[:, None]
TIMES = np.linspace(0, 2, 100)

pytestmark = pytest.mark.benchmark(group="a hundred thousand evaluations")


@pytest.fixture(scope="module")
def truth():
    return cubic.position(TIMES, LAM)


@pytest.mark.parametrize("order", [10, 20, 40])
def bench_series(measure, truth, order):
    """The solve is part of it."""
    measure(lambda: fts.solve(fts.CubicOscillator(), order, "float").evaluate("x", TIMES, lam=LAM),
            lambda x: np.abs(x - truth).max(), method="series", order=order)


@pytest.mark.parametrize("tolerance", [1e-4, 1e-8, 1e-12])
def bench_integration(measure, truth, tolerance):
    """x'' = 6 x² - 2 (3 + λ²), from the turning point, anew for each λ; for every 25th λ."""
    some = LAM[::25, 0]

    def run():
        return np.stack([solve_ivp(lambda t, y, lam=lam: (y[1], 6 * y[0]**2 - 6 - 2 * lam**2),
                                   (0, TIMES[-1]), (lam - 1, 0), "DOP853", t_eval=TIMES,
                                   rtol=tolerance, atol=tolerance / 100).y[0] for lam in some])
    measure(run, lambda x: np.abs(x - truth[::25]).max(),
            method="integration, DOP853 of SciPy", tolerance=tolerance, share=len(some) / len(LAM))


def bench_closed_form(measure, truth):
    """The Jacobi elliptic functions of SciPy; this is also what the errors are measured by."""
    measure(lambda: cubic.position(TIMES, LAM), method="Jacobi functions of SciPy")
