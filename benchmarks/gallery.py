"""Order, error and time of every equation of the gallery, as a Markdown table.

    python benchmarks/gallery.py

Runs the chapter book/gallery.ipynb without its pictures, so that equations, orders and errors are
those of the chapter, and then solves each problem again until RUNS runs or SECONDS are over. Times
are those of the processor, so that other work of the computer does not count.
"""

import io
import json
import statistics
import time
from contextlib import redirect_stdout
from pathlib import Path

import matplotlib as mpl

import ftseries as fts

CHAPTER = Path(__file__).parents[1] / "book" / "gallery.ipynb"
RUNS, SECONDS = 15, 10.0
TIMED_APART = {                 # not in the table of the chapter
    "Van der Pol, exactly to ε²⁴": lambda names: names["van_der_pol"],
    "Duffing, order 24": lambda names: names["duffing"].truncate(24),
}


def chapter():
    """The names that the chapter's cells define."""
    mpl.use("Agg")
    names = {}
    cells = json.loads(CHAPTER.read_text(encoding="utf-8"))["cells"]
    for cell in cells:
        source = "".join(cell["source"])
        if cell["cell_type"] == "code" and not source.startswith("explorers."):
            with redirect_stdout(io.StringIO()):
                exec(compile(source, CHAPTER.name, "exec"), names)
            mpl.pyplot.close("all")
    return names


def seconds(sol):
    """The median processor time of solving again what gave this solution; the number of runs."""
    options = {"precision": sol.precision} if sol.precision else {}
    times = []
    while len(times) < RUNS and (len(times) < 3 or sum(times) < SECONDS):
        start = time.process_time()
        fts.solve(sol.problem, order=sol.order, arithmetic=sol.arithmetic, progress=False,
                  **options)
        times.append(time.process_time() - start)
    return statistics.median(times), len(times)


def main():
    names = chapter()
    rows = [(name, sol, f"{error:.1e}" if error else "0") for name, sol, _, error, _ in
            names["report"]]
    rows += [(name, find(names), "") for name, find in TIMED_APART.items()]
    known = {}
    print("| equation | order | arithmetic | error | median time | runs |")
    print("|---|--:|---|--:|--:|--:|")
    for name, sol, error in rows:
        key = id(sol)
        median, runs = known[key] = known.get(key) or seconds(sol)
        print(f"| {name} | {sol.order} | {sol.arithmetic} | {error} | {1000 * median:.3g} ms | "
              f"{runs} |", flush=True)


if __name__ == "__main__":
    main()
