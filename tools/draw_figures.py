"""All figures of the book as files, SVG and PNG, named as the book refers to them.

    python tools/draw_figures.py                    all of book/, to _build/figures/
    python tools/draw_figures.py book/idea.ipynb    those of this notebook

The notebooks themselves draw them: each is executed with both formats switched on, and nothing of
it is stored but the pictures of the cells that carry the name of a figure. ``index.md`` says what
each of them shows.
"""

import argparse
import base64
import sys
from pathlib import Path

import nbformat
import normalise_notebooks

ROOT = Path(__file__).parents[1]
TARGET = ROOT / "_build" / "figures"
FORMATS = ("svg", "png")


def named(notebook):
    """``{name of a figure: its cell}``."""
    cells = {cell.metadata.get("mystnb", {}).get("figure", {}).get("name"): cell
             for cell in notebook.cells if cell.cell_type == "code"}
    return {name: cell for name, cell in cells.items() if name}


def draw(path, folder):
    """Execute a notebook and write its figures to ``folder``; their names."""
    notebook = nbformat.read(path, as_version=4)
    figures = named(notebook)
    if figures:
        normalise_notebooks.execute(
            notebook, path.parent, *(f"--InlineBackend.figure_formats={kind}" for kind in FORMATS))
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "index.md").open("a", encoding="utf-8") as index:
        for name, cell in figures.items():
            caption = " ".join(cell.metadata["mystnb"]["figure"].get("caption", "").split())
            index.write(f"- **{name}** ({path.stem}): {caption}\n")
    for name, cell in figures.items():
        pictures = [output.data for output in cell.outputs if "image/png" in output.get("data", {})]
        if len(pictures) != 1:
            raise ValueError(f"{path.name}: the cell of {name} shows {len(pictures)} pictures")
        (folder / f"{name}.svg").write_text(pictures[0]["image/svg+xml"], encoding="utf-8")
        (folder / f"{name}.png").write_bytes(base64.b64decode(pictures[0]["image/png"]))
    return sorted(figures)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("notebooks", nargs="*", type=Path, help="default: all of book/")
    parser.add_argument("--folder", type=Path, default=TARGET, help="default: _build/figures")
    options = parser.parse_args(arguments)
    (options.folder / "index.md").unlink(missing_ok=True)
    for path in options.notebooks or sorted((ROOT / "book").glob("*.ipynb")):
        names = draw(path, options.folder)
        print(f"{path.name}: {', '.join(names) or 'no figures'}", flush=True)
    print(f"The figures are in {options.folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
