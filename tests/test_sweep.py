"""Families in bulk: in this process, in others, on a cluster."""

import logging
import os
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context

import pytest
from distributed import Client, LocalCluster

import ftseries as fts

VALUES = [1, 0, 4, -1, 9]


def expected(found):
    assert [bool(f) for f in found] == [True, False, True, False, True]
    for value, sol in zip(VALUES, found):
        if sol:
            assert sol.coefficient("omega", 0) ** 2 == 12 * value
    assert [f.value for f in found if not f] == [0, -1]
    assert all(isinstance(f.error, fts.InputError) for f in found if not f)
    assert repr(found[3]).startswith("<no solution at -1: InputError: ")


def test_in_order_and_without_losing_the_others():
    expected(fts.sweep(fts.CubicOscillator, VALUES, order=4, progress=False))


def test_in_other_processes():
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as executor:
        expected(fts.sweep(fts.CubicOscillator, VALUES, 4, executor=executor, progress=False))


def test_in_threads_with_options():
    with ThreadPoolExecutor(2) as executor:
        found = fts.sweep(fts.GeneralizedMathieu, [0, 0.25], 12, executor=executor,
                          arithmetic="float")
    assert [sol.arithmetic for sol in found] == ["float", "float"]
    assert found[1].problem.arguments() == fts.GeneralizedMathieu(0.25).arguments()


@pytest.fixture(scope="module")
def dask():
    """The executor of a Dask cluster on this machine: scheduler and two workers.

    They speak over TCP, so that everything is pickled as between machines, but they are threads of
    this process, because starting others takes long on a busy machine.
    """
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=False, protocol="tcp://",
                      dashboard_address=None, silence_logs=logging.CRITICAL) as cluster, \
            Client(cluster) as client:
        yield client.get_executor()


def test_on_a_local_dask_cluster(dask):
    expected(fts.sweep(fts.CubicOscillator, VALUES, 4, executor=dask, progress=False))


def test_on_dask_in_floats_and_with_equations(dask):
    """Solutions and problems travel both ways; the values are those found here."""
    found = fts.sweep(duffing, [1, 2, 3], 30, executor=dask, progress=False, arithmetic="float")
    here = fts.sweep(duffing, [1, 2, 3], 30, progress=False, arithmetic="float")
    assert [sol.coefficients for sol in found] == [sol.coefficients for sol in here]
    assert "Equations" in repr(found[0].problem)


def test_a_mistake_on_a_dask_worker_loses_only_its_value(dask):
    found = fts.sweep(sometimes_broken, [4, 1], 2, executor=dask, progress=False)
    assert found[0].coefficient("omega", 0) ** 2 == 48
    assert isinstance(found[1].error, ZeroDivisionError)


def sometimes_broken(value):
    if value == 1:
        raise ZeroDivisionError("a mistake in the caller's own function")
    return fts.CubicOscillator(value)


def duffing(stiffness):
    return fts.Equations("x'' + x + k*x**3 = 0", parameters={"k": stiffness}, frequency="omega",
                         unknowns={"x": fts.Field("cos", fixed=(1,)), "omega": fts.Scalar()})


def test_equations_travel_between_processes():
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as executor:
        found = fts.sweep(duffing, [1, 2], 4, executor=executor, progress=False)
    assert [8 * sol.coefficient("omega", 2) for sol in found] == [3, 6]


def dies(value):
    if value == 1:
        os._exit(1)
    return fts.CubicOscillator(value)


def test_a_worker_that_dies_is_reported():
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as executor:
        found = fts.sweep(dies, [4, 1], 2, executor=executor, progress=False)
    assert not found[1]
    assert found[1].value == 1
    assert "BrokenProcessPool" in repr(found[1])


class Slow(Executor):
    """Futures that :func:`concurrent.futures.as_completed` does not know."""

    def submit(self, function, *arguments):
        future = Future()
        future.set_result(function(*arguments))
        foreign = type("Foreign", (), {"result": lambda self: future.result()})()
        return foreign


def test_futures_of_another_library():
    expected(fts.sweep(fts.CubicOscillator, VALUES, 4, executor=Slow(), progress=False))


def broken(value):
    raise ZeroDivisionError("a mistake in the caller's own function")


def test_a_mistake_in_the_function_is_not_hidden_as_a_missing_solution():
    with pytest.raises(ZeroDivisionError):
        fts.sweep(broken, [1], 2, progress=False)


@pytest.mark.parametrize("where", [None, ThreadPoolExecutor(1)])
def test_a_mistake_at_one_value_does_not_lose_the_others(where):
    found = fts.sweep(sometimes_broken, [1, 4], 2, executor=where, progress=False)
    assert repr(found[0]).startswith("<no solution at 1: ZeroDivisionError: ")
    assert found[1].coefficient("omega", 0) ** 2 == 48
    with pytest.raises(ZeroDivisionError):
        fts.sweep(sometimes_broken, [1], 2, executor=where, progress=False)


@pytest.mark.parametrize("make, values, message", [
    (fts.CubicOscillator(1), [1], r"make_problem=CubicOscillator\(a=1\) is not a function"),
    (fts.CubicOscillator, 1, r"values=1 is not a list of values; give one, such as \[1\]"),
])
def test_what_cannot_be_swept(make, values, message):
    with pytest.raises(fts.InputError, match=message):
        fts.sweep(make, values, 4)


def test_an_executor_without_submit():
    with pytest.raises(fts.InputError, match="executor=2 has no method submit; give one like"):
        fts.sweep(fts.CubicOscillator, [1], 2, executor=2)
