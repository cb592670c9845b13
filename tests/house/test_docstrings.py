"""Bars in the formulas of docstrings are escaped; code and displayed formulas stay."""

import pytest
from ftbook.docstrings import escape_bars


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("converges for |λ| < 3a", r"converges for \|λ\| < 3a"),
        ("    c_nk = δ(|n - k|, 2j)", r"    c_nk = δ(\|n - k\|, 2j)"),
        ("``a | b`` and |c|", r"``a | b`` and \|c\|"),
        (":math:`|x|` is |x|", r":math:`|x|` is \|x\|"),
        (">>> a | b", ">>> a | b"),
    ],
)
def test_line(before, after):
    lines = [before]
    escape_bars(None, "function", "f", None, None, lines)
    assert lines == [after]


def test_displayed_formula_ends_with_its_indentation():
    lines = [".. math::  |x|", "", "    + |y|", "", "then |z|"]
    escape_bars(None, "module", "m", None, None, lines)
    assert lines == [".. math::  |x|", "", "    + |y|", "", r"then \|z\|"]
