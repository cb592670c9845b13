"""Execute notebooks and store them in normal form: a second run changes no byte.

    python tools/normalise_notebooks.py                  execute and store all of book/
    python tools/normalise_notebooks.py book/idea.ipynb  only this one
    python tools/normalise_notebooks.py --check          execute nothing, refuse what is not normal

Normal form keeps sources, outputs and tags. It has no times, no widget state, no addresses of
objects and no Python version; cells are named by their contents and numbered in order. The first
code cell, which no page shows, installs the package where a reader opens the notebook on Colab.
"""

import argparse
import hashlib
import re
import sys
import time
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

ROOT = Path(__file__).parents[1]
TIMEOUT = 600  # seconds for one cell
KEPT_METADATA = ("jupytext", "kernelspec", "language_info", "myst")
WIDGET_VIEW = "application/vnd.jupyter.widget-view+json"
ADDRESS = re.compile(r"\b0x[0-9a-fA-F]{6,}\b")
COLAB = """\
import sys

if "google.colab" in sys.modules:  # elsewhere the package is already there
    %pip install --quiet ftseries
    from google.colab import output

    output.enable_custom_widget_manager()"""
KERNEL = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}


def normalise(notebook):
    """Bring a notebook into normal form, in place, without executing it."""
    notebook.nbformat, notebook.nbformat_minor = 4, 5
    notebook.metadata = nbformat.from_dict(
        {key: value for key, value in notebook.metadata.items() if key in KEPT_METADATA}
    )
    notebook.metadata["kernelspec"] = KERNEL
    notebook.metadata.setdefault("language_info", {"name": "python"}).pop("version", None)
    used = set()
    for cell in notebook.cells:
        cell["id"] = _fresh_id(cell, used)
        for noise in ("execution", "collapsed", "scrolled", "trusted"):
            cell.metadata.pop(noise, None)
        for number, output in enumerate(cell.get("outputs", [])):
            _normalise_output(output, f"{cell['id']}-{number}")


def add_installation(notebook):
    """Put the cell for Colab before the first code cell of a notebook that uses the package."""
    if _lacks_installation(notebook):
        cell = nbformat.v4.new_code_cell(COLAB, metadata={"tags": ["remove-cell"]})
        notebook.cells.insert(notebook.cells.index(_code(notebook)[0]), cell)


def _code(notebook):
    return [cell for cell in notebook.cells if cell.cell_type == "code" and cell.source.strip()]


def _lacks_installation(notebook):
    cells = _code(notebook)
    return any("ftseries" in cell.source for cell in cells) and cells[0].source != COLAB


def faults(notebook):
    """Sentences that say why a notebook is not fit to be stored; none if it is."""
    cells = _code(notebook)
    if _lacks_installation(notebook):
        yield "its first code cell does not install the package on Colab"
    if [cell.execution_count for cell in cells] != list(range(1, len(cells) + 1)):
        yield "its cells were not executed once each, in order"
    for cell in cells:
        for output in cell.outputs:
            meant = "raises-exception" in cell.metadata.get("tags", [])
            if output.output_type == "error" and not meant:
                yield f"cell {cell.execution_count} stores the error {output.ename}"


def execute(notebook, folder, *arguments):
    """Run all cells in place, in a fresh kernel with ``arguments`` that starts in ``folder``."""
    for cell in notebook.cells:
        if cell.cell_type == "code":
            cell.outputs, cell.execution_count = [], None
    NotebookClient(
        notebook,
        kernel_name="python3",
        timeout=TIMEOUT,
        resources={"metadata": {"path": str(folder)}},
        record_timing=False,
        coalesce_streams=True,
        extra_arguments=["--IPKernelApp.log_level=ERROR", *arguments],
    ).execute()


def _fresh_id(cell, used):
    """Cell id from the cell's contents: moving other cells does not change it."""
    base = hashlib.sha256(f"{cell.cell_type}\0{cell.source}".encode()).hexdigest()[:8]
    name, number = base, 1
    while name in used:
        number += 1
        name = f"{base}-{number}"
    used.add(name)
    return name


def _normalise_output(output, name):
    if "text" in output:
        output["text"] = ADDRESS.sub("0x0", output["text"])
    data = output.get("data", {})
    for mime, value in data.items():
        if isinstance(value, str) and mime.startswith("text/"):
            data[mime] = ADDRESS.sub("0x0", value)
    if WIDGET_VIEW in data:
        data[WIDGET_VIEW]["model_id"] = name


def _store_or_check(path, check):
    """One word on what became of a notebook; ValueError if it is not fit to be stored."""
    before = path.read_text(encoding="utf-8")
    notebook = nbformat.reads(before, as_version=4)
    if not check:
        add_installation(notebook)
        execute(notebook, path.parent)
    normalise(notebook)
    if sentences := list(faults(notebook)):
        raise ValueError("; ".join(sentences))
    after = nbformat.writes(notebook) + "\n"
    if after == before:
        return "unchanged"
    if check:
        raise ValueError("it is not in normal form")
    path.write_text(after, encoding="utf-8")
    return "changed"


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("notebooks", nargs="*", type=Path, help="default: all of book/")
    parser.add_argument("--check", action="store_true", help="execute and change nothing")
    options = parser.parse_args(arguments)
    paths = options.notebooks or sorted((ROOT / "book").glob("*.ipynb"))
    failed = 0
    for number, path in enumerate(paths, 1):
        print(f"[{number}/{len(paths)}] {path.name}", end=" ", flush=True)
        start = time.perf_counter()
        try:
            outcome = _store_or_check(path, options.check)
        except (ValueError, OSError, CellExecutionError, TimeoutError) as error:
            failed += 1
            outcome = f"FAILED: {error}"
        print(f"{outcome} ({time.perf_counter() - start:.1f} s)", flush=True)
    if failed:
        print(f"{failed} of {len(paths)} failed; `make notebooks` executes and normalises them")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
