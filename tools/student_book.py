"""The book without solutions: sources, notebooks and pages, for a class that is to find them.

    python tools/student_book.py [folder]

copies what the book is made of to ``folder`` (default ``_build/student``) and leaves out every
solution: the directives ``solution`` and ``solution-start`` to ``solution-end`` of text cells and
pages, and the code cells with the tag ``solution``. The page for lecturers and the paragraphs that
lead to it stay away as well. What is left is a book of its own, which ``jupyter-book build`` builds
and whose notebooks a class can be given.
"""

import re
import shutil
import sys
from pathlib import Path

import nbformat

ROOT = Path(__file__).parents[1]
COPIED = ("_config.yml", "_toc.yml", "requirements.lock", "requirements.txt", "pyproject.toml",
          "LICENSE", "LICENSE-TEXT", "CITATION.cff", ".dockerignore", "book", "ftseries",
          "benchmarks")
README = """\
# Fourier-Taylor series

The book for a class, without solutions. With Python 3.11 or later, in this folder:

    python3 -m venv .venv && . .venv/bin/activate
    pip install -r requirements.txt
    jupyter lab book          # read and change the notebooks
    jupyter-book build .      # then open _build/html/index.html

Code: MIT licence (LICENSE). Text and figures: CC BY 4.0 (LICENSE-TEXT). How to cite: CITATION.cff.
"""
LEFT_OUT = shutil.ignore_patterns("__pycache__", ".ipynb_checkpoints", "node_modules")

FENCE = re.compile(r"^(?P<fence>`{3,}|:{3,})\{(?P<name>solution(?:-start|-end)?)\}")


def without_solutions(text, inside=False):
    """``(text without solutions, whether a solution is still open at its end)``.

    >>> without_solutions("Ask.\\n\\n```{solution} ex-a\\nAnswer.\\n```\\n\\nGo on.")
    ('Ask.\\n\\nGo on.', False)
    """
    kept, fence = [], None
    for line in text.split("\n"):
        if fence:                                     # inside a directive that is left out
            if re.fullmatch(rf"{fence[0]}{{{len(fence)},}}\s*", line):
                fence = None
        elif match := FENCE.match(line):
            fence = match["fence"]
            if match["name"] != "solution":
                inside = match["name"] == "solution-start"
        elif not inside:
            kept.append(line)
    return re.sub(r"\n{3,}", "\n\n", "\n".join(kept)).strip(), inside


def strip_notebook(notebook):
    """Leave the solutions out of a notebook, in place."""
    kept, inside = [], False
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            before = cell.source
            cell.source, inside = without_solutions(cell.source, inside)
            if cell.source or not before:
                kept.append(cell)
        elif not inside and "solution" not in cell.metadata.get("tags", []):
            kept.append(cell)
    if inside:
        raise ValueError("a solution-start without its solution-end")
    notebook.cells = kept


def make(folder):
    """Write the book without solutions to ``folder``; what was there before is replaced."""
    for name in COPIED:
        source, target = ROOT / name, folder / name
        if source.is_dir():
            shutil.rmtree(target, ignore_errors=True)
            shutil.copytree(source, target, ignore=LEFT_OUT)
        elif source.exists():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, target)
    for path in sorted((folder / "book").glob("*.ipynb")):
        notebook = nbformat.read(path, as_version=4)
        strip_notebook(notebook)
        nbformat.write(notebook, path)
    (folder / "README.md").write_text(README, encoding="utf-8")
    (folder / "book" / "lecturers.md").unlink(missing_ok=True)
    contents = folder / "_toc.yml"
    lines = contents.read_text(encoding="utf-8").splitlines(keepends=True)
    contents.write_text("".join(x for x in lines if "lecturers" not in x), encoding="utf-8")
    for path in sorted((folder / "book").glob("*.md")):
        before = path.read_text(encoding="utf-8")
        paragraphs = without_solutions(before)[0].split("\n\n")
        after = "\n\n".join(text for text in paragraphs if "{doc}`lecturers`" not in text) + "\n"
        if after != before:
            path.write_text(after, encoding="utf-8")
    fetched = ROOT / "_build" / "web"                 # scripts of the pages, if they are there
    if fetched.exists():
        shutil.copytree(fetched, folder / "_build" / "web", dirs_exist_ok=True)


if __name__ == "__main__":
    make(Path(sys.argv[1]) if sys.argv[1:] else ROOT / "_build" / "student")
