"""Executed notebooks are kept as long as the package they import is the same.

Jupyter Book's cache knows a notebook by its cells alone. Here it lives in a folder named after
the contents of the package and of the lock file, so a changed solver executes everything again.
"""

import hashlib
import shutil
from pathlib import Path

SUFFIXES = {".py", ".js", ".css", ".json"}


def fingerprint(root):
    """Hexadecimal hash of the package, the benchmarks' results and the lock file in ``root``."""
    sources = [path for path in (root / "ftseries").rglob("*") if path.suffix in SUFFIXES]
    sources += (root / "benchmarks").glob("*.json")
    digest = hashlib.sha256()
    for path in [*sorted(sources), root / "requirements.lock"]:
        digest.update(f"{path.relative_to(root).as_posix()}\0".encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def key_by_package(app, config):
    """Point the notebook cache to the folder of this state of the package; drop older ones."""
    caches = Path(app.outdir).parent / ".jupyter_cache"
    current = caches / fingerprint(Path(app.srcdir))
    for old in caches.glob("*"):
        if old != current:
            shutil.rmtree(old) if old.is_dir() else old.unlink()
    current.mkdir(parents=True, exist_ok=True)
    config.nb_execution_cache_path = str(current)
