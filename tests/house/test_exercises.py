"""Each chapter has its exercises, each exercise its mark and its solution; two pages about them."""

import re
from pathlib import Path

import nbformat
import pytest
import yaml

ROOT = Path(__file__).parents[2]
MARKS = ("✍", "⌨", "★")


def chapters():
    """The notebooks of the numbered part of the table of contents."""
    toc = yaml.safe_load((ROOT / "_toc.yml").read_text(encoding="utf-8"))
    (numbered,) = [part for part in toc["parts"] if part.get("numbered")]
    return [chapter["file"] for chapter in numbered["chapters"]]


def text(chapter):
    """The text cells of a chapter."""
    cells = nbformat.read(ROOT / f"{chapter}.ipynb", as_version=4).cells
    return "\n".join(cell.source for cell in cells if cell.cell_type == "markdown")


def exercises(chapter):
    """``[(label, title, first line)]``, in order."""
    found = re.findall(r"^`{3,}\{exercise\} *(.*)\n:label: (\S+)\n+(.*)$", text(chapter), re.M)
    return [(label, title, line) for title, label, line in found]


@pytest.mark.parametrize("chapter", chapters())
def test_at_least_eight_exercises_each_with_title_and_mark(chapter):
    found = exercises(chapter)
    assert len(found) >= 8
    for _, title, line in found:
        assert title.startswith(MARKS) or line.startswith(MARKS)
        assert title.strip("".join(MARKS) + " ")


@pytest.mark.parametrize("chapter", chapters())
def test_every_exercise_has_one_folded_solution(chapter):
    solved = re.findall(r"^`{3,}\{solution(?:-start)?\} (\S+)\n:class: dropdown$",
                        text(chapter), re.M)
    assert sorted(solved) == sorted(label for label, _, _ in exercises(chapter))


def test_lecturers_call_exercises_by_their_titles():
    page = (ROOT / "book/lecturers.md").read_text(encoding="utf-8")
    titles = {label: title.strip("".join(MARKS) + " ")
              for chapter in chapters() for label, title, _ in exercises(chapter)}
    named = re.findall(r"\{numref\}`([^`<]+) \(\{number\}\) <(ex-[\w-]+)>`", page)
    assert len(named) > 20
    assert {label: name for name, label in named}.items() <= titles.items()


def test_lecturers_find_every_exercise_once_and_under_its_sign():
    page = (ROOT / "book/lecturers.md").read_text(encoding="utf-8")
    table = page.partition("## Which exercises fit where")[2].partition("\n## ")[0]
    columns = [[], [], [], []]
    for row in re.findall(r"^\| \{doc\}.*$", table, re.M):
        for column, cell in zip(columns, row.split("|")[2:6], strict=True):
            column += re.findall(r"<(ex-[\w-]+)>", cell)
    found = {chapter: exercises(chapter) for chapter in chapters()}
    signs = {label: title[0] for listed in found.values() for label, title, _ in listed}
    assert sorted(sum(columns, [])) == sorted(signs)
    for column, sign in zip(columns, ("✍", "⌨", "✍", "★"), strict=True):
        assert {signs[label] for label in column} == {sign}


def test_a_glossary_entry_has_at_most_two_sentences():
    page = (ROOT / "book/glossary.md").read_text(encoding="utf-8")
    entries = re.findall(r"^\S.*\n((?: {2}.+\n)+)", page.partition(":sorted:")[2], re.M)
    assert len(entries) > 40
    assert not [entry for entry in entries if len(re.findall(r"[.?](?=\s|$)", entry)) > 2]
