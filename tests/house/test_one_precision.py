"""Only one module sets the precision of FLINT and mpmath, which all threads share."""

import ast
from pathlib import Path

import pytest

import ftseries

HOME = Path(ftseries.__file__).parent
MODULES = sorted(path for path in HOME.rglob("*.py") if path.name != "precision.py")
#: of both libraries: what makes a context of another precision, and what can be set
MANAGERS = {"workprec", "workdps", "extraprec", "extradps"}
SETTINGS = {"prec", "dps", "cap", "threads", "_prec", "_dps", "_cap", "default"}


def offences(source):
    """Lines that set a precision."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Attribute):
            stored = not isinstance(node.ctx, ast.Load)
            owner = ast.unparse(node.value).rpartition(".")[2]
            called = node.attr in MANAGERS or node.attr == "default" and owner == "ctx"
            if called or stored and owner in {"ctx", "mp"} and node.attr in SETTINGS:
                yield node.lineno
        elif isinstance(node, ast.ImportFrom) and node.module in {"mpmath", "flint"}:
            yield from (node.lineno for name in node.names if name.name in MANAGERS)
        elif isinstance(node, ast.Call) and ast.unparse(node.func) == "setattr":
            yield node.lineno


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(HOME)))
def test_no_other_module_sets_a_precision(path):
    lines = list(offences(path.read_text("utf-8")))
    assert not lines, f"{path.name}: use ftseries.precision.working in line {lines}"


@pytest.mark.parametrize("source", [
    "with ctx.workprec(100): pass", "with mpmath.workdps(5): pass", "ctx.prec = 5",
    "flint.ctx.cap, x = 5, 1", "mpmath.mp.dps += 3", "mp.prec = 9", "from mpmath import workprec",
    "f = mpmath.extraprec(5)(g)", "setattr(ctx, 'prec', 5)", "ctx.default()"])
def test_offences_are_found(source):
    assert list(offences(source)) == [1]
