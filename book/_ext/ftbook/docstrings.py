"""Docstrings are written for readers of code: modules have names, a bar in a formula is a bar.

reStructuredText would take ``|x|`` for the name of a substitution; here its bars are escaped,
except where a docstring shows code, a literal or a displayed formula.
"""

import re

QUOTED = re.compile(r"(``.*?``|:\w+:`.*?`)")


def name_module(app, what, name, obj, options, lines):
    """Handler of ``autodoc-process-docstring``: the text on a module begins with its name."""
    if what == "module":
        lines[:0] = [f".. rubric:: {name}", ""]


def escape_bars(app, what, name, obj, options, lines):
    """Handler of ``autodoc-process-docstring``: change ``lines`` in place."""
    formula = False
    for number, line in enumerate(lines):
        indented = not line.strip() or line.startswith(" ")
        formula = line.lstrip().startswith(".. math::") or (formula and indented)
        if not formula and not line.lstrip().startswith((">>>", "...")):
            parts = QUOTED.split(line)
            parts[::2] = [part.replace("|", r"\|") for part in parts[::2]]
            lines[number] = "".join(parts)
