"""How a page is cut into slides."""

import json
from types import SimpleNamespace

import pytest
from docutils import nodes
from ftbook import slides
from sphinx_proof.nodes import theorem_node


def mark(kind):
    return nodes.comment("", slides.MARK + kind)


def text(words):
    return nodes.paragraph("", words)


def code(kind=None, tags=()):
    source = nodes.container("", text("print()"), nb_element="cell_code_source")
    metadata = {"tags": list(tags)} | ({"slideshow": {"slide_type": kind}} if kind else {})
    return nodes.container("", source, text("output"), nb_element="cell_code",
                           cell_metadata=metadata)


def page(*parts):
    title = nodes.title("", "Chapter")
    return nodes.section("", mark("slide"), nodes.section("", title, *parts, ids=["chapter"]))


def shown(doctree):
    return [[section.astext() for section in stack] for stack in slides.deck(doctree)]


def test_cells_begin_continue_and_leave_slides():
    doctree = page(mark("-"), text("a"), mark(""), text("left out"), mark("subslide"), text("b"),
                   code("-"), text("of no cell"), code(),
                   mark("slide"), text("c"), mark(""), text("d"))
    assert shown(doctree) == [["Chapter\n\na", "Chapter\n\nb\n\noutput"], ["Chapter\n\nc"]]


def test_code_is_shown_only_where_it_is_asked_for():
    assert shown(page(code("slide"), code("slide", ["slide-code"]))) == [
        ["Chapter"], ["Chapter\n\noutput"], ["Chapter\n\nprint()\n\noutput"]]


def test_notes_and_fragments_are_wrapped():
    (section,), = slides.deck(page(mark("notes"), text("say"), mark("fragment"), text("then")))
    assert [node.astext() for node in section.findall(nodes.raw)] == [
        '<aside class="notes">', "</aside>"]
    assert [node.astext() for node in section.findall(nodes.container)] == ["then"]


def test_slides_are_named_after_the_sections_they_begin():
    doctree = page(mark("slide"), text("a"), mark("subslide"), text("b"))
    again = [title for stack in slides.deck(doctree) for section in stack
             for title in section.findall(nodes.title) if "again" in title["classes"]]
    assert [title["anchor"] for title in again] == ["#chapter", "#chapter"]
    names = [section["ids"] for stack in slides.deck(doctree) for section in stack]
    assert names == [["chapter"], ["slide-2-1"], ["slide-2-2"]]


def test_titles_that_the_page_has_given_are_not_given_again():
    written = nodes.warning("", nodes.title("", "Warning"), text("Mind the gap."))
    own = nodes.admonition("", nodes.title("", "A gap"), text("Mind it."))
    theorem = theorem_node("", nodes.title("", "Small"), text("So it is."))
    (section,), = slides.deck(page(mark("slide"), written, own, theorem))[1:]
    assert section.astext() == "\n\n".join([
        "Chapter", "Mind the gap.", "A gap", "Mind it.", "Small", "So it is."])


def test_the_page_itself_is_left_as_it_was():
    doctree = page(code("slide"), mark("fragment"), nodes.section("", text("inner")))
    before = doctree.pformat()
    slides.deck(doctree)
    assert doctree.pformat() == before


def test_a_page_without_slides_has_no_deck():
    assert slides.deck(nodes.section("", nodes.title("", "Page"), text("a"), code())) == []


@pytest.mark.parametrize("source", [["# A\n", "b"], "# A\nb"])
def test_marks_are_added_to_notebooks_with_slides_alone(source):
    app = SimpleNamespace(env=SimpleNamespace(doc2path=lambda name: f"{name}.ipynb"))
    cells = [{"cell_type": "markdown", "metadata": {}, "source": source},
             {"cell_type": "code", "metadata": {}, "source": "1"}]
    content = [json.dumps({"cells": cells})]
    slides.mark_cells(app, "page", content)
    assert json.loads(content[0])["cells"] == cells
    cells[1]["metadata"]["slideshow"] = {"slide_type": "slide"}
    content = [json.dumps({"cells": cells})]
    slides.mark_cells(app, "page", content)
    marked = json.loads(content[0])["cells"]
    assert marked[0]["source"] == f"+++ {slides.MARK}\n# A\nb" and marked[1] == cells[1]
