"""Executed notebooks are reused only while the package is the same."""

from types import SimpleNamespace

import pytest
from ftbook import cache


@pytest.fixture
def root(tmp_path):
    (tmp_path / "ftseries" / "explorers").mkdir(parents=True)
    (tmp_path / "benchmarks").mkdir()
    (tmp_path / "ftseries" / "solver.py").write_text("ORDER = 1\n")
    (tmp_path / "requirements.lock").write_text("numpy==2.4.6\n")
    return tmp_path


@pytest.mark.parametrize(
    ("name", "counts"),
    [
        ("ftseries/solver.py", True),
        ("ftseries/explorers/eight.js", True),
        ("requirements.lock", True),
        ("benchmarks/results.json", True),
        ("ftseries/solver.pyc", False),
        ("README.md", False),
    ],
)
def test_fingerprint_sees_what_the_notebooks_import(root, name, counts):
    before = cache.fingerprint(root)
    (root / name).write_text("changed\n")
    assert (cache.fingerprint(root) != before) == counts


def test_older_caches_are_dropped_and_the_current_one_is_kept(root):
    app = SimpleNamespace(srcdir=root, outdir=root / "_build" / "html")
    config = SimpleNamespace()
    cache.key_by_package(app, config)
    first = config.nb_execution_cache_path
    cache.key_by_package(app, config)
    assert config.nb_execution_cache_path == first
    (root / "ftseries" / "solver.py").write_text("ORDER = 2\n")
    cache.key_by_package(app, config)
    assert config.nb_execution_cache_path != first
    assert len(list((root / "_build" / ".jupyter_cache").iterdir())) == 1
