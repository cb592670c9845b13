"""How long the book takes to build and to test, and how heavy its pages are.

    make bench-book

runs both builds and the tests, and writes benchmarks/book.json.
"""

import json
import os
import platform
import subprocess
import time
from pathlib import Path

ROOT = Path(__file__).parents[1]
STEPS = {"cold build, every notebook executed": ["make", "strict-book"],
         "warm build, nothing changed": ["make", "book"],
         "unit tests and doctests": ["make", "unit"]}


def seconds(command):
    start = time.perf_counter()
    subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    return round(time.perf_counter() - start, 1)


def weights(site):
    """Kilobytes of every page of the book, and of the whole site."""
    pages = {path.stem: round(path.stat().st_size / 1e3)
             for path in sorted((site / "book").glob("*.html"))}
    total = sum(path.stat().st_size for path in site.rglob("*") if path.is_file())
    return {"pages": pages, "site": round(total / 1e3)}


def main():
    times = {name: seconds(command) for name, command in STEPS.items()}
    found = {"machine": {"cores": os.cpu_count(), "python": platform.python_version()},
             "seconds": times, "kilobytes": weights(ROOT / "_build" / "html")}
    target = Path(__file__).with_name("book.json")
    target.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    print(target.read_text())


if __name__ == "__main__":
    main()
