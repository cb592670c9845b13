"""GitHub's workflows: they do what `make` does, where the book promises that it works."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).parents[2]
PATHS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
TARGETS = set(re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE))


def read(path):
    """The workflow, and its steps but for those of the job that types what the README says."""
    flow = yaml.safe_load(path.read_text(encoding="utf-8"))
    steps = [step for name, job in flow["jobs"].items() if name != "readme"
             for step in job["steps"]]
    return flow, steps


@pytest.mark.parametrize("path", PATHS, ids=lambda path: path.name)
def test_steps_call_make_and_pinned_actions_only(path):
    flow, steps = read(path)
    assert flow["permissions"].get("contents") == "read"        # and no more by default
    for step in steps:
        if "run" in step:
            command, target = step["run"].split()[:2]
            assert command == "make" and (target in TARGETS or target == "${{"), step
        else:
            assert re.search(r"@(v\d+|release/v\d+)$", step["uses"]), step


def test_the_commands_of_the_readme_are_run_as_they_stand():
    """All but the last one, which opens JupyterLab."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    block = text.partition("Without make, in a virtual environment:\n\n")[2].partition("\n\n")[0]
    *commands, last = [line.partition("#")[0].strip() for line in block.splitlines()]
    assert last == "jupyter lab book" and commands[-1] == "pytest" and len(commands) == 4
    flow, _ = read(ROOT / ".github" / "workflows" / "test.yml")
    runs = [step["run"].splitlines() for step in flow["jobs"]["readme"]["steps"] if "run" in step]
    assert runs[0] == commands
    assert runs[1][-1].endswith(".venv/bin/python tour.py") and ".venv/bin/python tour.py" in text


def test_the_tour_is_cut_out_of_the_readme(tmp_path):
    """By the command of the workflow: the same lines that test_readme executes."""
    if not shutil.which("sed"):
        pytest.skip("there is no sed")
    flow, _ = read(ROOT / ".github" / "workflows" / "test.yml")
    cut = flow["jobs"]["readme"]["steps"][-1]["run"].splitlines()[0]
    shutil.copy(ROOT / "README.md", tmp_path)
    subprocess.run(cut, shell=True, check=True, cwd=tmp_path)
    (tour,) = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text("utf-8"), re.DOTALL)
    assert (tmp_path / "tour.py").read_text("utf-8") == tour


def test_weekly_targets_exist_and_failures_open_an_issue():
    flow, steps = read(ROOT / ".github" / "workflows" / "weekly.yml")
    assert set(flow["jobs"]["check"]["strategy"]["matrix"]["target"]) <= TARGETS
    assert flow["permissions"]["issues"] == "write"
    assert steps[-1]["if"] == "failure()" and "issues.create" in steps[-1]["with"]["script"]


def test_every_promised_system_and_python_is_tested():
    flow, _ = read(ROOT / ".github" / "workflows" / "test.yml")
    matrix = flow["jobs"]["package"]["strategy"]["matrix"]
    assert {name.split("-")[0] for name in matrix["os"]} == {"ubuntu", "macos", "windows"}
    assert matrix["python"] == ["3.11", "3.12", "3.13", "3.14"]


def test_only_the_publishing_job_may_ask_for_an_identity():
    flow, _ = read(ROOT / ".github" / "workflows" / "release.yml")
    assert "id-token" not in flow["permissions"]
    assert "permissions" not in flow["jobs"]["build"]
    assert flow["jobs"]["publish"]["permissions"] == {"id-token": "write"}
