"""``downloads``: a directive that links what `make site` puts beside the pages: PDF, figures.

The files are in ``_build/download`` when the pages are built, and are copied to the pages' folder.
"""

import os
import shutil
from pathlib import Path

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

NONE = ("These pages were built without the PDF and the archive of all figures; `make site` adds "
        "both, and links them here.")


def files(app):
    """What there is to download, in order."""
    folder = Path(app.srcdir, "_build", "download")
    return sorted(folder.iterdir()) if folder.is_dir() else []


class Downloads(SphinxDirective):
    """A list of links, or a sentence that says how to make what they would lead to."""

    def run(self):
        self.env.note_reread()
        found = files(self.env.app)
        if not found:
            words, _ = self.parse_inline(NONE)
            return [nodes.paragraph("", "", *words)]
        up = "../" * self.env.docname.count("/")
        items = [nodes.list_item("", nodes.paragraph("", "", nodes.reference(
            "", file.name, refuri=f"{up}download/{file.name}"), nodes.Text(f", {_size(file)}")))
            for file in found]
        return [nodes.bullet_list("", *items)]


def _size(file):
    return f"{os.path.getsize(file) / 1e6:.1f} MB"


def copy(app, exception):
    """Handler of ``build-finished``."""
    if exception is None and app.builder.format == "html":
        for file in files(app):
            target = Path(app.outdir, "download")
            target.mkdir(exist_ok=True)
            shutil.copy(file, target)
