"""The normal form of notebooks: execution is repeatable to the byte, faults are named."""

import nbformat
import normalise_notebooks as tool
import pytest
from nbformat import v4

NOISY = """
import ipywidgets, matplotlib.pyplot as plt
plt.plot([1, 2])
plt.show()
display(object(), ipywidgets.interact(lambda n: print(n), n=3))
"""


def write(path, *sources):
    notebook = v4.new_notebook(cells=[v4.new_code_cell(source) for source in sources])
    nbformat.write(notebook, path)
    return path


def test_noisy_notebook_is_stored_byte_for_byte_the_same(tmp_path, capsys):
    path = write(tmp_path / "noisy.ipynb", NOISY, NOISY)
    assert tool.main([str(path), "--check"]) == 1
    assert tool.main([str(path)]) == 0
    first = path.read_bytes()
    assert b"image/png" in first and b"widget-view" in first
    assert tool.main([str(path)]) == 0
    assert path.read_bytes() == first
    assert tool.main([str(path), "--check"]) == 0
    assert "FAILED" in capsys.readouterr().out.splitlines()[0]


def test_check_executes_and_changes_nothing(tmp_path, capsys):
    path = write(tmp_path / "fresh.ipynb", "1 + 1")
    before = path.read_bytes()
    assert tool.main([str(path), "--check"]) == 1
    assert path.read_bytes() == before
    assert "not executed once each" in capsys.readouterr().out


def test_failing_cell_is_reported_and_the_file_kept(tmp_path, capsys):
    path = write(tmp_path / "broken.ipynb", "1 / 0")
    before = path.read_bytes()
    assert tool.main([str(path)]) == 1
    assert path.read_bytes() == before
    assert "ZeroDivisionError" in capsys.readouterr().out


def test_stored_error_is_a_fault_unless_it_is_meant():
    notebook = v4.new_notebook(cells=[v4.new_code_cell("1 / 0", execution_count=1)])
    notebook.cells[0].outputs = [v4.new_output("error", ename="ZeroDivisionError")]
    assert list(tool.faults(notebook)) == ["cell 1 stores the error ZeroDivisionError"]
    notebook.cells[0].metadata["tags"] = ["raises-exception"]
    assert list(tool.faults(notebook)) == []


@pytest.mark.parametrize("damage", [b"", b'{"cells": [', b"\xff\xfe"])
def test_damaged_file_is_reported(tmp_path, capsys, damage):
    path = tmp_path / "damaged.ipynb"
    path.write_bytes(damage)
    assert tool.main([str(path), "--check"]) == 1
    assert "FAILED" in capsys.readouterr().out


def test_notebooks_that_use_the_package_install_it_on_colab(tmp_path, capsys):
    path = write(tmp_path / "user.ipynb", "import ftseries", "1 + 1")
    assert tool.main([str(path)]) == 0
    first, *others = nbformat.read(path, as_version=4).cells
    assert first.source == tool.COLAB and first.metadata["tags"] == ["remove-cell"]
    assert [cell.source for cell in others] == ["import ftseries", "1 + 1"]
    before = path.read_bytes()
    assert tool.main([str(path)]) == 0 and path.read_bytes() == before
    write(path, "import ftseries")
    assert tool.main([str(path), "--check"]) == 1
    assert "install the package on Colab" in capsys.readouterr().out
