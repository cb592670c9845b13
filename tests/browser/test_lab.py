"""The same explorers in a running JupyterLab with a kernel: Python and the page stay in step."""

import json
import re
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import nbformat
import pytest
from browser.pages import Explorer

CELLS = [
    "import ftseries as fts\nfrom ftseries import explorers\nshown = explorers.cubic()\nshown",
    "explorers.mathieu(stored=20)",
    "explorers.figure_eight(stored=20)",
    "explorers.coefficients(fts.solve(fts.FigureEight(), order=12), 'r')",
    "print('state', round(shown.view.lam, 9), shown.view.order, shown.controls['order'].value)",
    "shown.view.lam, shown.controls['order'].value = 2.0, 20",
    "shown.view.data = {}",
]
QUIET = ["--ServerApp.open_browser=False", "--ServerApp.port=0", "--allow-root",
         "--LabApp.news_url=None", "--IdentityProvider.token=test",
         "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate"]


@pytest.fixture(scope="module")
def lab(browser, tmp_path_factory):
    """The address of a notebook with all explorers, opened in JupyterLab."""
    folder = tmp_path_factory.mktemp("lab")
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in CELLS])
    notebook.metadata["kernelspec"] = {"display_name": "Python 3", "name": "python3"}
    nbformat.write(notebook, folder / "notebook.ipynb")
    program = Path(sys.executable).with_name("jupyter-lab")
    command = [program, *QUIET, f"--ServerApp.root_dir={folder}"]
    log = folder / "log"
    with log.open("w") as file, subprocess.Popen(command, stdout=file, stderr=file) as server:
        try:
            yield f"{_address(server, log)}lab/tree/notebook.ipynb?token=test&reset"
        finally:
            server.terminate()


def _address(server, log):
    for _ in range(120):
        found = re.search(r"http://127\.0\.0\.1:\d+/", log.read_text())
        if found and server.poll() is None:
            with urllib.request.urlopen(f"{found[0]}api/status?token=test") as answer:
                assert json.load(answer)["kernels"] == 0
            return found[0]
        time.sleep(0.5)
    pytest.fail(f"JupyterLab did not start: {log.read_text()}")


def test_explorers_with_a_kernel(visit, lab):
    page = visit(lab, clean=False, viewport={"width": 1100, "height": 2400})
    cells = page.locator(".jp-Notebook .jp-CodeCell")
    cells.first.wait_for(timeout=90_000)
    page.locator(".jp-Notebook-ExecutionIndicator[data-status=idle]").wait_for(timeout=90_000)
    cells.first.click()

    def run(number):
        prompt = cells.nth(number).locator(".jp-InputPrompt")
        for _ in range(10):                         # Lab drops keys while its kernel connects
            if (answer := page.locator(".jp-Dialog .jp-mod-accept")).count():
                answer.first.click()                # or asks which kernel is meant
            cells.nth(number).locator(".cm-content").click()
            page.keyboard.press("Shift+Enter")
            page.wait_for_timeout(2000)
            if prompt.inner_text() != "[ ]:":
                break
        cells.nth(number).locator(f".jp-InputPrompt:text-is('[{number + 1}]:')").wait_for(
            timeout=60_000)

    for number in range(4):
        run(number)
    shown = [Explorer(page, number) for number in range(4)]
    for explorer in shown:
        assert "order" in explorer.status
    assert page.locator(".ft-error").count() == 0

    first = shown[0]
    first.handle("λ").press("ArrowRight")           # from the page to Python
    first.handle("order").press("ArrowRight")
    assert "order 13, λ = 1.01" in first.status
    run(4)
    assert cells.nth(4).locator(".jp-OutputArea").inner_text().split("state ")[1].split() == [
        "1.01", "13", "13"]
    paper = "box => getComputedStyle(box).backgroundColor"
    light, pixels = first.box.evaluate(paper), first.pictures()
    page.evaluate("document.body.dataset.jpThemeLight = 'false'")   # as Lab's dark theme does
    assert first.pictures() != pixels and first.box.evaluate(paper) != light

    run(5)                                          # from Python to the page
    assert "order 20, λ = 2.00" in first.status
    assert (first.value("λ"), first.value("order")) == (2, 20)
    run(6)                                          # an empty model, said in its place
    first.box.get_by_role("alert").wait_for()
    assert "The series of x is empty" in first.box.inner_text()
    assert "order 12" in shown[1].status
    assert page.watched.outside == []
    assert not [text for text in page.watched.said if "ft-" in text or "anywidget" in text]
