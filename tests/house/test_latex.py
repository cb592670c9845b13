"""The book on paper: tags, wide outputs, links to explorers, plain and numbered chapters."""

from types import SimpleNamespace

import pytest
from docutils import nodes
from docutils.utils import new_document
from ftbook import latex
from ftbook.fallback import IMAGE, WIDGET
from sphinx import addnodes
from sphinx.builders.latex.nodes import thebibliography
from sphinx_exercise.nodes import exercise_node, solution_node


def app(**numbers):
    return SimpleNamespace(
        srcdir=".", builder=SimpleNamespace(format="latex"),
        env=SimpleNamespace(docname="book/page", toc_secnumbers=numbers))


def book(*parts):
    preface = nodes.section("", nodes.title("", "Preface"), nodes.paragraph("", "Text."))
    document = new_document("book")
    document += [preface, *parts]
    return document


@pytest.mark.parametrize(("before", "after"), [
    (r"x = 1 \tag{C3}", r"\begin{equation*}\begin{split}x = 1\end{split}\tag{C3}\end{equation*}"),
    (r"x \tag{E_{\lambda}} = 1",
     r"\begin{equation*}\begin{split}x  = 1\end{split}\tag{E_{\lambda}}\end{equation*}"),
    ("x = 1", "x = 1"),
])
def test_tags_stand_outside_split(before, after):
    formula = nodes.math_block("", before)
    latex.prepare(app(), book(formula), "book/preface")
    assert formula.astext() == after and bool(formula.get("nowrap")) == (before != after)


@pytest.mark.parametrize("before", ["Z\u0304 = 1", r"\|A F(ū)\|"])
def test_bars_are_set_by_tex(before):
    formula = nodes.math("", before)
    latex.prepare(app(), book(nodes.paragraph("", "", formula)), "book/preface")
    assert formula.astext() in (r"\bar{Z} = 1", r"\|A F(\bar{u})\|")


def test_what_a_cell_prints_fits_the_line():
    formula = nodes.math_block("", "x = 1")
    output = nodes.container("", formula, nb_element="cell_code_output")
    latex.prepare(app(), book(output), "book/preface")
    assert formula.astext() == r"\ftfit{\begin{split}x = 1\end{split}}"


def test_links_to_exercises_lead_to_their_labels():
    book_app = app()
    book_app.env.sphinx_exercise_registry = {"ex-a": {}}
    links = [addnodes.number_reference("", "1.2", refuri="%book/a#ex-a"),
             nodes.reference("", "", nodes.emphasis("", " A title"), refid="ex-a"),
             addnodes.number_reference("", "1.3", refuri="%book/a#fig-a")]
    paragraph = nodes.paragraph("", "", *links)
    latex.prepare(book_app, book(paragraph), "book/preface")
    assert paragraph.astext() == (
        r"\hyperref[exercise:ex-a]{1.2} \hyperref[exercise:ex-a]{A title}1.3")
    assert paragraph[-1] is links[-1]


def test_proofs_stand_without_a_box():
    text = nodes.paragraph("", "Proof. Let x = 1. Then", nodes.math("", "x"))
    proof = nodes.container("", nodes.admonition("", text, classes=["proof"]))
    latex.prepare(app(), book(proof), "book/preface")
    assert [type(node).__name__ for node in proof] == ["paragraph", "raw"]
    assert proof[0][0].astext() == "Proof. " and isinstance(proof[0][0], nodes.emphasis)
    assert proof[0].astext().startswith("Proof. Let x = 1. Then")


def test_solutions_stand_without_a_box_and_exercises_with_their_first_lines():
    code = nodes.literal_block("", "1 + 1")
    solution = solution_node("", nodes.title("", "Solution to ", nodes.math("", "x")),
                             nodes.section("", code), label="s")
    exercise = exercise_node("", nodes.title("", "Exercise"), label="e")
    part = nodes.container("", exercise, solution)
    latex.prepare(app(), book(part), "book/preface")
    assert [type(node).__name__ for node in part] == [
        "raw", "exercise_node", "raw", "paragraph", "literal_block", "raw"]
    assert "needspace" in part[0].astext() and "needspace" in part[2].astext()
    assert part[3].astext() == "Solution to x" and part[4] is code


def test_the_bibliography_stands_in_its_place():
    entries = thebibliography()
    page = addnodes.start_of_file("", nodes.section("", nodes.title("", "References")),
                                  docname="book/references")
    document = book(page, entries)
    latex.prepare(app(), document, "book/preface")
    assert page[-1] is entries and document[-1] is page
    assert "book/references::doc" in page[1].astext()


def test_chapters_are_numbered_as_on_the_pages():
    files = [addnodes.start_of_file("", nodes.section(), docname=name) for name in ("a", "b")]
    document = book(*files)
    latex.prepare(app(a={"": (1,)}, b={}), document, "book/preface")
    first = [file[0].astext() for file in files]
    assert first == [r"\setcounter{secnumdepth}{2}", r"\setcounter{secnumdepth}{-2}"]


def test_pictures_leave_room_but_keep_a_width_of_their_own():
    pictures = nodes.image(uri="a.png"), nodes.image(uri="b.png", width="3cm")
    latex.prepare(app(), book(*pictures), "book/preface")
    assert [picture["width"] for picture in pictures] == [latex.WIDTH, "3cm"]


def test_other_builders_are_left_alone():
    pages = app()
    pages.builder.format = "html"
    document = book(nodes.math_block("", r"x \tag{A}"))
    before = document.pformat()
    latex.prepare(pages, document, "book/preface")
    assert document.pformat() == before


@pytest.mark.parametrize("site", ["https://example.org/book/", ""])
def test_an_explorer_is_a_picture_with_a_link(monkeypatch, site):
    monkeypatch.setenv("FTSERIES_SITE", site)
    kinds = [nodes.container(mime_type=kind) for kind in (WIDGET, IMAGE)]
    output = nodes.container("", nodes.container("", *kinds, nb_element="mime_bundle"))
    document = book(output)
    latex.add_links(app(), document)
    assert isinstance(output[1], addnodes.only) and output[1]["expr"] == "latex"
    assert "book/page.html" in output[1].astext()
    links = [link["refuri"] for link in output[1].findall(nodes.reference)]
    assert links == ([f"{site}book/page.html"] if site else [])
