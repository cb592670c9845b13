"""One accurate orbit of the eight: positions at a hundred times, error against time."""

import numpy as np
import orbits
import pytest

import ftseries as fts
from ftseries.figure_eight import closure_zero, positions
from ftseries.references import newton

TIMES = np.linspace(0, 2 * np.pi, 101)
TRUTH = newton.figure_eight(TIMES)

pytestmark = pytest.mark.benchmark(group="one orbit of the eight")


def error(found):
    """The largest distance of a body from where shooting in higher order puts it."""
    return np.abs(found - TRUTH).max()


def series(order, arithmetic="float"):
    return fts.solve(fts.FigureEight(), order, arithmetic, progress=False)


@pytest.mark.parametrize("order", [6, 12, 24, 48, 100, 200, 400])
def bench_series(measure, order):
    def run():
        solution = series(order)
        return positions(solution, TIMES, closure_zero(solution))
    measure(run, error, method="series", order=order)


@pytest.mark.parametrize("order", [12, 24, 36, 48])
def bench_resummed(measure, order):
    def run():
        summed = series(order, "exact").resum()
        return positions(summed, TIMES, closure_zero(summed, (2.0, 2.2)))
    measure(run, error, method="series, resummed", order=order)


@pytest.mark.parametrize("order", [6])
def bench_refined(measure, order):
    def run():
        orbit = series(order).refine()
        return positions(orbit, TIMES, orbit.lam)
    measure(run, error, method="series, refined", order=order)


def bench_shooting(measure):
    measure(lambda: orbits.shooting(orbits.runge_kutta, TIMES), error,
            method="shooting, DOP853 of SciPy")


def bench_heyoka(measure):
    orbits.taylor()
    measure(lambda: orbits.shooting(orbits.taylor(), TIMES), error, method="shooting, heyoka")


def bench_heyoka_compiled(measure):
    """As at the first time in a process."""
    from heyoka import llvm_state

    def run():
        orbits.taylor.cache_clear()
        llvm_state.clear_memcache()
        return orbits.shooting(orbits.taylor(), TIMES)
    measure(run, error, method="shooting, heyoka, with compilation")


def bench_collocation(measure):
    measure(lambda: orbits.collocation(TIMES), error, method="collocation")
