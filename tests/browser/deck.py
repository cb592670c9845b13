"""The small book's notebook with slides: what each cell is in the deck, and what it holds."""

import nbformat
from nbformat import v4

CELLS = [
    ("slide", "# A deck\n\n**You will see** one formula, one theorem, one explorer."),
    ("notes", "Welcome everybody to $\\lambda$."),
    ("slide", "## A formula\n\n(eq-deck)=\n$$ \\ddot x = -x + \\lambda x^2 \\tag{D1} $$"),
    ("fragment", "It is {ref}`(D1) <eq-deck>`."),
    (None, "Left out of the deck.\n\n(eq-left-out)=\n$$ a = b \\tag{D2} $$"),
    ("subslide", "```{prf:theorem} Small\n:label: thm-deck\n\nEvery order has one solution.\n```"),
    ("-", "By {ref}`(D1) <eq-deck>`, {ref}`(D2) <eq-left-out>` and {prf:ref}`thm-deck`."),
    (None, "from ftseries import explorers"),
    ("slide", "explorers.cubic(order=12, lam=1.0)"),
    ("slide", "print(6 * 7)"),
]


def write(path):
    """Store the notebook, without outputs; the code of its last cell is on its slide."""
    cells = []
    for kind, source in CELLS:
        code = source.startswith(("from", "explorers", "print"))
        cell = v4.new_code_cell(source) if code else v4.new_markdown_cell(source)
        if kind:
            cell.metadata["slideshow"] = {"slide_type": kind}
        cells.append(cell)
    cells[-1].metadata["tags"] = ["slide-code"]
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    nbformat.write(v4.new_notebook(cells=cells, metadata={"kernelspec": kernel}), path)
