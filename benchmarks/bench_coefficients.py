"""The time for coefficients: this package, plain SymPy, and the package ``asymptotics``."""

import plain_sympy
import pytest
from asymptotics import ODE

import ftseries as fts

EIGHT = {"exact": (10, 20, 30, 60, 100), "float": (25, 50, 100, 200, 400),
         "ball": (20, 40, 80, 120)}
DUFFING = {"u": fts.Field("cos", modes="odd", powers="odd", fixed=(1,)),
           "omega": fts.Scalar("even")}


@pytest.mark.benchmark(group="coefficients of the eight")
@pytest.mark.parametrize("arithmetic, order", [(a, n) for a, ns in EIGHT.items() for n in ns])
def bench_eight(measure, arithmetic, order):
    measure(lambda: fts.solve(fts.FigureEight(), order, arithmetic, progress=False),
            method=f"ftseries, {arithmetic}", order=order)


@pytest.mark.benchmark(group="coefficients of the eight")
@pytest.mark.parametrize("order", [3, 5, 7, 11, 15])
def bench_eight_sympy(measure, order):
    measure(lambda: plain_sympy.eight(order), method="plain SymPy", order=order)


@pytest.mark.benchmark(group="coefficients of Duffing's oscillator")
@pytest.mark.parametrize("order", [2, 4, 8, 12, 24, 48])
def bench_duffing(measure, order):
    """The order counts powers of ε = λ²; the equation is read from text each time."""
    measure(lambda: fts.solve(fts.Equations("u'' + u + u**3", DUFFING, frequency="omega"),
                              2 * order, progress=False),
            method="ftseries, exact", order=order)


@pytest.mark.benchmark(group="coefficients of Duffing's oscillator")
@pytest.mark.parametrize("order", [2, 4, 8, 12])
def bench_duffing_sympy(measure, order):
    measure(lambda: plain_sympy.duffing(order), method="plain SymPy", order=order)


@pytest.mark.benchmark(group="coefficients of Duffing's oscillator")
@pytest.mark.parametrize("order", [2, 4, 8, 12, 24])
def bench_duffing_asymptotics(measure, order):
    measure(lambda: ODE("u'' + u + eps*u**3", small_param="eps", dependent="u", independent="t",
                        conditions=["u(0) = 1", "u'(0) = 0"]).expand_lindstedt(order=order),
            method="asymptotics", order=order)
