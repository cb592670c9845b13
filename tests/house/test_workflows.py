"""GitHub's workflows: they do what `make` does, where the book promises that it works."""

import re
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).parents[2]
PATHS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
TARGETS = set(re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE))


def read(path):
    flow = yaml.safe_load(path.read_text(encoding="utf-8"))
    steps = [step for job in flow["jobs"].values() for step in job["steps"]]
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
