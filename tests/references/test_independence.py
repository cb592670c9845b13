"""The references share no code with what they check."""

import ast
from pathlib import Path

import pytest

import ftseries.references

FILES = sorted(Path(ftseries.references.__file__).parent.glob("*.py"))


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.name)
def test_only_arguments_errors_types_locks_and_other_references_are_imported(file):
    imported = set()
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            assert node.level == 0, "relative imports hide what is imported"
            imported |= {f"{node.module}.{name.name}" for name in node.names}
        elif isinstance(node, ast.Import):
            imported |= {name.name for name in node.names}
    ours = {name for name in imported if name.split(".")[0] == "ftseries"}
    allowed = ("ftseries.arguments.", "ftseries.errors.", "ftseries.references.",
               "ftseries.aliases.", "ftseries.precision.")
    assert all(name.startswith(allowed) for name in ours)


def test_the_files_are_found():
    assert {"cubic.py", "mathieu.py", "newton.py"} <= {file.name for file in FILES}
