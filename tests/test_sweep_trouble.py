"""Sweeps in trouble: whatever one value does, the others keep their solutions."""

import os
import signal
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from types import SimpleNamespace

import pytest
from distributed import Client, LocalCluster

import ftseries as fts


class NeedsTwo(Exception):
    """Pickles, but cannot be read again: pickle calls it with one argument."""

    def __init__(self, first, second):
        super().__init__(f"{first} and {second}")


class Sticky(Exception):
    """Cannot be pickled."""

    def __reduce__(self):
        raise TypeError("not me")


class Mute(Exception):
    """Cannot even be printed."""

    def __str__(self):
        raise ValueError


class Barb(fts.CubicOscillator):
    """A problem that pickles, but cannot be read again."""

    def __setstate__(self, state):
        raise NeedsTwo("a", "b")


class Thorn:
    """A value of this kind."""

    def __setstate__(self, state):
        raise NeedsTwo("a", "b")

    def __getstate__(self):
        return 1


TROUBLE = {
    "two arguments": (lambda: NeedsTwo("a", "b"), "NeedsTwo: a and b"),
    "sticky": (Sticky, "Sticky: "), "mute": (Mute, "Mute"),
    "exit": (lambda: SystemExit(3), "SystemExit: 3"),
    "generator": (GeneratorExit, "GeneratorExit"), "plain": (lambda: OSError(5, "no"), "no"),
}


def make(value):
    if isinstance(value, str):
        if value == "barb":
            return Barb(1)
        raise TROUBLE[value][0]()
    return fts.CubicOscillator(value)


def check(found, names):
    for value, one in zip([*names, 4, 1], found, strict=True):
        if value in names:
            assert not one and one.value == value and isinstance(one.error, Exception)
            repr(one.error)
            assert type(one.error).__name__ in repr(one)
        else:
            assert one.coefficient("omega", 0) ** 2 == 12 * value


@pytest.fixture(scope="module")
def processes():
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as executor:
        yield executor


@pytest.mark.parametrize("name", TROUBLE)
def test_any_exception_stays_its_own(processes, name):
    """In this process, in threads, and in others, where it has to travel."""
    here = fts.sweep(make, [name, 4, 1], 2)
    with ThreadPoolExecutor(1) as threads:
        for found in (here, fts.sweep(make, [name, 4, 1], 2, executor=threads)):
            check(found, [name])
    there = fts.sweep(make, [name, 4, 1], 2, executor=processes)
    check(there, [name])
    if name not in ("mute", "sticky"):
        assert TROUBLE[name][1] in str(there[0].error)


def test_a_solution_that_cannot_travel_stays_its_own(processes):
    found = fts.sweep(make, ["barb", 4, 1], 2, executor=processes)
    check(found, ["barb"])
    assert "NeedsTwo: a and b" in str(found[0].error)


def test_a_value_that_cannot_travel_stays_its_own(processes):
    thorn = Thorn()
    found = fts.sweep(make, [thorn, 4, 1], 2, executor=processes)
    check(found, [thorn])
    found = fts.sweep(make, [lambda: 1, 4], 2, executor=processes)
    assert not found[0] and found[1].coefficient("omega", 0) ** 2 == 48


def test_a_function_that_cannot_travel(processes):
    with pytest.raises(fts.InputError, match="cannot be sent to other processes .* in a module$"):
        fts.sweep(lambda a: fts.CubicOscillator(a), [1], 2, executor=processes)


def test_if_nothing_is_solved_the_mistake_is_raised(processes):
    with pytest.raises(RuntimeError, match="NeedsTwo: a and b"):
        fts.sweep(make, ["two arguments"], 2, executor=processes)
    with pytest.raises(RuntimeError, match="SystemExit: 3"):
        fts.sweep(make, ["exit"], 2)


def interrupts(value):
    raise KeyboardInterrupt


def test_an_interruption_is_raised():
    with pytest.raises(KeyboardInterrupt):
        fts.sweep(interrupts, [1, 2], 2)


def ends(value):
    if value == 1:
        os._exit(1)
    return fts.CubicOscillator(value)


def test_a_broken_pool_is_named():
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as executor:
        found = fts.sweep(ends, [1, 4, 9], 2, executor=executor)
        assert not any(found)
        assert "BrokenProcessPool: a worker ended without an answer" in repr(found[2])
        assert "__main__" in repr(found[2]) and "\n" not in repr(found[2])
        again = fts.sweep(ends, [4], 2, executor=executor)             # it is broken already
        assert "sweep them again with a new one" in repr(again[0])


@pytest.mark.parametrize("kind", [ThreadPoolExecutor, ProcessPoolExecutor])
def test_an_executor_that_was_shut_down(kind):
    executor = kind(1)
    executor.shutdown()
    with pytest.raises(fts.InputError, match="takes no more tasks .* give a new one$"):
        fts.sweep(fts.CubicOscillator, [1], 2, executor=executor)


@pytest.mark.parametrize("options, words", [
    ({"arithmatic": "float"}, "'arithmatic' is no option of solve; it has arithmetic, precision"),
    ({"problem": 1}, "'problem' is no option"), ({"order": "x"}, "order='x'"),
])
def test_a_misspelt_option(options, words):
    with pytest.raises(fts.InputError, match=words):
        fts.sweep(fts.CubicOscillator, [1], **({"order": 2} | options))


TABLE = SimpleNamespace(columns=["a", "b"], __iter__=lambda: iter("ab"))


@pytest.mark.parametrize("values, words", [
    (TABLE, r"one column of it, table\['a'\]"), ({"a": 1}, r"list\(values.values\(\)\)"),
    ("12", r"\['12'\]"), (b"12", r"\[b'12'\]"), (None, r"\[None\]"),
])
def test_what_is_no_list_of_values(values, words):
    with pytest.raises(fts.InputError, match=f"not a list of values; give one, such as .*{words}"):
        fts.sweep(fts.CubicOscillator, values, 2)


def test_a_table_of_pandas():
    pandas = pytest.importorskip("pandas", reason="pandas is not among the requirements")
    table = pandas.DataFrame({"a": [1.0, 4.0]})
    with pytest.raises(fts.InputError, match="DataFrame, not a list of values"):
        fts.sweep(fts.CubicOscillator, table, 2)
    assert all(fts.sweep(fts.CubicOscillator, table["a"], 2))


SLOW = """
import sys, time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
import ftseries as fts

def slow(value):
    time.sleep(0.5)
    return fts.CubicOscillator(value)

if __name__ == "__main__":
    with getattr(sys.modules[__name__], sys.argv[1])(2) as executor:
        executor.submit(int).result()
        print("ready", flush=True)
        fts.sweep(slow, [1] * 60, 2, executor=executor)
"""


@pytest.mark.skipif(os.name != "posix", reason="signals of Windows are others")
@pytest.mark.parametrize("kind", ["ProcessPoolExecutor", "ThreadPoolExecutor"])
def test_an_interrupted_sweep_does_not_work_on(tmp_path, kind):
    """60 values of half a second on two workers: after Ctrl-C those that wait are cancelled."""
    script = tmp_path / "slow.py"
    script.write_text(SLOW)
    run = subprocess.Popen([sys.executable, script, kind], stdout=subprocess.PIPE,
                           stderr=subprocess.PIPE, text=True)
    assert run.stdout.readline() == "ready\n"
    time.sleep(1)
    start = time.monotonic()
    run.send_signal(signal.SIGINT)
    _, error = run.communicate(timeout=60)
    assert "KeyboardInterrupt" in error and run.returncode != 0
    assert time.monotonic() - start < 10                                # of 15 s for all of them


def test_on_two_processes_of_dask():
    """Scheduler and workers as Dask starts them by itself; a busy machine needs up to 20 s."""
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
                      ) as cluster, Client(cluster, timeout=120) as client:
        client.wait_for_workers(2, timeout=120)
        found = fts.sweep(fts.CubicOscillator, [1, 0, 4], 4, executor=client.get_executor())
        pids = set(client.run(os.getpid).values())
    assert [bool(sol) for sol in found] == [True, False, True]
    assert found[2].coefficient("omega", 0) ** 2 == 48
    assert len(pids) == 2 and os.getpid() not in pids
