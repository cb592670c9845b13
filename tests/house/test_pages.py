"""Folded cells say what is behind them; formulas keep the signs that follow them."""

from types import SimpleNamespace

import pytest
from docutils import nodes
from docutils.utils import new_document
from ftbook import folds, punctuation, slides
from myst_nb.sphinx_ import HideCodeCellNode


def page(*parts):
    document = new_document("page")
    document += nodes.section("", *parts, ids=["page"])
    return document


@pytest.mark.parametrize(("mode", "words"), [("input", "the code"), ("all", "the check")])
def test_the_button_names_code_or_check(mode, words):
    cell = nodes.container("", hide_mode=mode, cell_metadata={}, prompt_show="?", prompt_hide="?")
    folds.name_buttons(None, page(cell))
    assert (cell["prompt_show"], cell["prompt_hide"]) == (f"Show {words}", f"Hide {words}")


def test_a_text_of_its_own_stays():
    own = {"mystnb": {"code_prompt_show": "Look"}}
    cell = nodes.container("", hide_mode="all", cell_metadata=own, prompt_show="Look")
    plain = nodes.container("", nb_element="cell_code")
    folds.name_buttons(None, page(cell, plain))
    assert cell["prompt_show"] == "Look" and "prompt_show" not in plain


def test_slides_have_the_result_of_a_folded_cell_and_no_button():
    source = nodes.container("", nodes.paragraph("", "x = 1"), nb_element="cell_code_source")
    fold = HideCodeCellNode("", source, prompt_show="Show", prompt_hide="Hide")
    cell = nodes.container("", fold, nodes.paragraph("", "result"), nb_element="cell_code",
                           cell_metadata={"slideshow": {"slide_type": "slide"}})
    ((section,),) = slides.deck(page(nodes.title("", "Chapter"), cell))
    assert not list(section.findall(HideCodeCellNode))
    assert "result" in section.astext() and "x = 1" not in section.astext()


@pytest.mark.parametrize(("after", "glued", "rest"), [
    (", and", "x,", " and"), (".)", "x.)", ""), (" and", None, " and"), ("-fold", None, "-fold")])
def test_a_sign_stays_with_its_formula(after, glued, rest):
    paragraph = nodes.paragraph("", "", nodes.Text("If "), nodes.math("", "x"), nodes.Text(after))
    html = SimpleNamespace(builder=SimpleNamespace(format="html"))
    punctuation.glue(html, page(paragraph), "book/page")
    assert paragraph.astext() == f"If x{after}"
    found = [node.astext() for node in paragraph.findall(nodes.inline)]
    assert found == ([glued] if glued else [])
    assert paragraph[-1].astext() == rest


def test_equal_texts_are_not_confused():
    parts = [part for name in "xy" for part in (nodes.math("", name), nodes.Text(", "))]
    paragraph = nodes.paragraph("", "", *parts)
    html = SimpleNamespace(builder=SimpleNamespace(format="html"))
    punctuation.glue(html, page(paragraph), "book/page")
    assert paragraph.astext() == "x, y, " and len(list(paragraph.findall(nodes.inline))) == 2


def test_paper_is_left_alone():
    paragraph = nodes.paragraph("", "", nodes.math("", "x"), nodes.Text(","))
    before = paragraph.pformat()
    punctuation.glue(SimpleNamespace(builder=SimpleNamespace(format="latex")), page(paragraph), "a")
    assert paragraph.pformat() == before


def test_the_button_of_a_fold_is_called_what_it_shows():
    context = {"body": '<summary aria-label="Toggle hidden content"><p>Show the code</p>'}
    folds.say_what_is_shown(None, "", "", context, None)
    assert context["body"] == "<summary><p>Show the code</p>"
    folds.say_what_is_shown(None, "", "", {}, None)
