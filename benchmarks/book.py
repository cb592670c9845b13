"""How long the book takes to build and to test, and how its pages do in a browser.

    make bench-book

runs both builds and the tests, and writes benchmarks/book.json.
"""

import json
import os
import platform
import subprocess
import time
from pathlib import Path

import pages

ROOT = Path(__file__).parents[1]
STEPS = {"cold build, every notebook executed": ["make", "strict-book"],
         "warm build, nothing changed": ["make", "book"],
         "unit tests and doctests": ["make", "unit"],
         "every notebook, executed and compared": ["make", "notebooks-tested"]}


def seconds(command):
    start = time.perf_counter()
    subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    return round(time.perf_counter() - start, 1)


def megabytes(site):
    total = sum(path.stat().st_size for path in site.rglob("*") if path.is_file())
    return round(total / 1e6, 1)


def main():
    times = {name: seconds(command) for name, command in STEPS.items()}
    found = {"machine": {"cores": os.cpu_count(), "python": platform.python_version()},
             "seconds": times, "megabytes": megabytes(ROOT / "_build" / "html"),
             "pages": pages.measure()}
    target = Path(__file__).with_name("book.json")
    target.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    print(target.read_text())


if __name__ == "__main__":
    main()
