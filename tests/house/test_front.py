"""The way into the book: front page, preface, first chapter; what the preface shows is so."""

import doctest
from pathlib import Path

import nbformat
import yaml

ROOT = Path(__file__).parents[2]


def test_the_arrows_lead_from_the_front_page_by_the_preface_to_the_idea():
    toc = yaml.safe_load((ROOT / "_toc.yml").read_text(encoding="utf-8"))
    pages = [page["file"] for part in toc["parts"] for page in part["chapters"]]
    assert [toc["root"], *pages[:2]] == ["book/index", "book/preface", "book/idea"]
    last = {page["file"] for page in toc["parts"][-1]["chapters"]}
    assert {"book/notation", "book/lecturers"} <= last


def test_the_front_page_shows_no_code():
    front = nbformat.read(ROOT / "book" / "index.ipynb", as_version=4)
    code = [cell for cell in front.cells if cell.cell_type == "code"]
    assert len(code) == 3
    assert all({"remove-cell", "remove-input"} & set(cell.metadata["tags"]) for cell in code)


def test_the_preface_shows_what_its_lines_print():
    failed, tried = doctest.testfile(str(ROOT / "book" / "preface.md"), module_relative=False)
    assert tried == 3 and failed == 0
