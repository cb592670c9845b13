"""``built-with``: a directive that lists the versions with which these pages were built.

Only what the package and the book ask for by name is listed; requirements.lock has all the rest.
"""

import datetime
import platform
from importlib import metadata

from docutils import nodes
from packaging.requirements import Requirement
from sphinx.util.docutils import SphinxDirective


def versions(package="ftseries", extra="book"):
    """``[(name, version)]`` of Python, a package, and what it needs directly, with an extra.

    >>> [name for name, _ in versions()][:2]
    ['Python', 'ftseries']
    """
    needs = [Requirement(text) for text in metadata.requires(package)]
    names = sorted({need.name for need in needs
                    if need.marker is None or need.marker.evaluate({"extra": extra})})
    found = [(name, metadata.version(name)) for name in [package, *names]]
    return [("Python", platform.python_version()), *found]


class BuiltWith(SphinxDirective):
    """A table of names and versions, and the day of the build."""

    def run(self):
        self.env.note_reread()
        body = nodes.tbody("", *(_row(*pair) for pair in versions()))
        head = nodes.thead("", _row("package", "version"))
        columns = [nodes.colspec(colwidth=1), nodes.colspec(colwidth=1)]
        table = nodes.table("", nodes.tgroup("", *columns, head, body, cols=2))
        day = datetime.date.today().isoformat()
        system = f"{platform.system()}, {platform.machine()}"
        return [nodes.paragraph("", f"Last built on {day} ({system}) with"), table]


def _row(*texts):
    return nodes.row("", *(nodes.entry("", nodes.paragraph("", text)) for text in texts))
