"""Figures as files: one SVG and one PNG for each named figure, from the notebook's own cell."""

import xml.etree.ElementTree as ET

import draw_figures as tool
import nbformat
import pytest
from nbformat import v4

PLOT = "import matplotlib.pyplot as plt\nplt.plot([1, 2])\nplt.show()"


def notebook(path, *cells):
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    cells = [v4.new_code_cell(source, metadata={"mystnb": {"figure": {
        "name": name, "caption": "A line\n  that rises."}}}) for source, name in cells]
    nbformat.write(v4.new_notebook(cells=cells, metadata={"kernelspec": kernel}), path)
    return path


def test_named_figures_are_drawn_in_both_formats(tmp_path, capsys):
    path = notebook(tmp_path / "a.ipynb", (PLOT, "fig-line"), (PLOT, None))
    before = path.read_bytes()
    assert tool.main([str(path), "--folder", str(tmp_path / "out")]) == 0
    assert sorted(file.name for file in (tmp_path / "out").iterdir()) == [
        "fig-line.png", "fig-line.svg", "index.md"]
    assert (tmp_path / "out" / "index.md").read_text(encoding="utf-8") == (
        "- **fig-line** (a): A line that rises.\n")
    assert (tmp_path / "out" / "fig-line.png").read_bytes().startswith(b"\x89PNG")
    assert ET.parse(tmp_path / "out" / "fig-line.svg").getroot().tag.endswith("svg")
    assert path.read_bytes() == before and "a.ipynb: fig-line" in capsys.readouterr().out


def test_a_figure_without_its_picture_is_refused(tmp_path):
    path = notebook(tmp_path / "a.ipynb", ("1 + 1", "fig-none"))
    with pytest.raises(ValueError, match="fig-none shows 0 pictures"):
        tool.draw(path, tmp_path / "out")


def test_notebooks_without_figures_are_not_executed(tmp_path):
    assert tool.draw(notebook(tmp_path / "a.ipynb", ("1 / 0", None)), tmp_path / "out") == []
