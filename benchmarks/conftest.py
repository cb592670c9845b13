"""How the benchmarks measure, and what of it goes into results.json."""

import time
from importlib.metadata import version

import pytest

PACKAGES = ["numpy", "scipy", "sympy", "python-flint", "heyoka", "asymptotics"]
#: seconds that the rounds of one case should take together, and above which one run is enough
BUDGET, LONG = 1.0, 2.5


@pytest.fixture
def measure(benchmark):
    """``measure(function, error=…, **what)``: repeat a function, keep its result's error.

    The first call is a warm-up; it is the only one where it takes long.
    """
    def run(function, error=None, **what):
        start = time.perf_counter()
        result = function()
        once = time.perf_counter() - start
        if once > LONG:
            benchmark.pedantic(time.sleep, (0,), rounds=1)       # registers the case
            what |= {"seconds": once}
        else:
            rounds = max(3, min(25, int(BUDGET / once)))
            result = benchmark.pedantic(function, rounds=rounds)
        benchmark.extra_info.update(what)
        if error is not None:
            benchmark.extra_info["error"] = float(error(result))
        return result
    return run


def pytest_benchmark_update_json(config, benchmarks, output_json):
    """Keep what the chapter shows: machine, versions, and of each case median and spread."""
    machine = output_json["machine_info"]
    cases = []
    for case in output_json["benchmarks"]:
        stats, info = case["stats"], case["extra_info"]
        seconds = info.pop("seconds", None)
        cases.append({
            "group": case["group"], **info,
            "median": seconds or stats["median"],
            "spread": None if seconds else stats["iqr"],
            "rounds": 1 if seconds else stats["rounds"],
        })
    output_json.clear()
    output_json.update({
        "machine": {"processor": machine["cpu"].get("brand_raw", machine["machine"]),
                    "cores": machine["cpu"].get("count"), "system": machine["system"],
                    "python": machine["python_version"]},
        "versions": {name: version(name) for name in PACKAGES},
        "cases": cases,
    })
