"""The book without solutions has all of the book but the solutions."""

import re
from pathlib import Path

import nbformat
import pytest
import student_book as tool
from nbformat import v4

BOOK = Path(__file__).parents[2] / "book"
FENCED = "Ask.\n\n{fence}{{solution}} ex-a\n:class: dropdown\n\nAnswer.\n{fence}\n\nGo on."


@pytest.mark.parametrize("fence", ["```", "````", ":::"])
def test_a_solution_goes_and_the_rest_stays(fence):
    assert tool.without_solutions(FENCED.format(fence=fence)) == ("Ask.\n\nGo on.", False)


def test_a_solution_may_hold_other_directives():
    text = "````{solution} ex-a\n```{math}\nx\n```\nAnswer.\n````\n\n```{exercise} B\nAsk.\n```"
    assert tool.without_solutions(text) == ("```{exercise} B\nAsk.\n```", False)


def test_everything_between_start_and_end_goes():
    cells = [v4.new_markdown_cell("Ask.\n\n```{solution-start} ex-a\n```\nOne."),
             v4.new_code_cell("answer = 1"), v4.new_markdown_cell("Two."),
             v4.new_markdown_cell("Three.\n\n```{solution-end}\n```\n\nGo on."),
             v4.new_code_cell("kept = 2"),
             v4.new_code_cell("a = 3", metadata={"tags": ["solution"]})]
    notebook = v4.new_notebook(cells=cells)
    tool.strip_notebook(notebook)
    assert [cell.source for cell in notebook.cells] == ["Ask.", "Go on.", "kept = 2"]


def test_a_solution_without_an_end_is_refused():
    notebook = v4.new_notebook(cells=[v4.new_markdown_cell("```{solution-start} ex-a\n```")])
    with pytest.raises(ValueError, match="solution-end"):
        tool.strip_notebook(notebook)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("student")
    tool.make(folder)
    return folder


def test_no_file_of_the_class_holds_a_solution(folder):
    """What a solution is, is found here another way: by the tags, and by line after line."""
    secrets, public = set(), set()
    for path in BOOK.glob("*.ipynb"):
        inside = False
        for cell in nbformat.read(path, as_version=4).cells:
            if cell.cell_type == "code":
                if "solution" in cell.metadata.get("tags", []):
                    secrets.add(max(cell.source.splitlines(), key=len))
                else:
                    public |= set(cell.source.splitlines())
                continue
            for line in cell.source.splitlines():
                if re.match(r"`{3,}\{solution", line):
                    inside = "end" not in line
                elif inside and len(line) > 60:
                    secrets.add(line)
                elif re.match(r"`{3,}$", line):
                    inside = False
    secrets -= public
    assert len(secrets) > 50
    texts = {path: "\n".join(cell.source for cell in nbformat.read(path, as_version=4).cells)
             for path in (folder / "book").glob("*.ipynb")}
    texts |= {path: path.read_text("utf-8") for path in (folder / "book").glob("*.md")}
    for path, text in texts.items():
        assert "{solution" not in text, path.name
        assert not [line for line in secrets if line in text], path.name


def test_every_exercise_and_every_figure_is_there(folder):
    def asked(book):
        text = "".join(path.read_text("utf-8") for path in sorted(book.glob("*.ipynb")))
        return re.findall(r":label: (ex-[\w-]+)", text), re.findall(r'"name": "(fig-[\w-]+)"', text)
    assert asked(folder / "book") == asked(BOOK)
    assert (folder / "book" / "_ext" / "ftbook").is_dir() and (folder / "_toc.yml").exists()


def test_the_class_has_instructions_that_work_and_nothing_for_lecturers(folder):
    readme = (folder / "README.md").read_text(encoding="utf-8")
    assert "make" not in readme and "requirements.txt" in readme
    assert (folder / "requirements.txt").exists() and (folder / ".dockerignore").exists()
    pages = [*(folder / "book").glob("*.md"), *(folder / "book").glob("*.ipynb")]
    assert not [page.name for page in pages if page.stem == "lecturers"]
    for page in [*pages, folder / "_toc.yml"]:
        assert "lecturers" not in page.read_text(encoding="utf-8"), page.name
    preface = (folder / "book" / "preface.md").read_text(encoding="utf-8")
    assert preface.startswith("---") and "## For whom" in preface
