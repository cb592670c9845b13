r"""The book on paper: what LaTeX needs besides what Sphinx gives it.

Formulas keep the tags of the paper, chapters, figures and exercises have the numbers that they have
on the pages, figures leave room for text, and an explorer is a picture with a link to its page.
Proofs and solutions stand without a box, so that what they hold can go on over the page.
"""

import re
import unicodedata

from docutils import nodes
from sphinx import addnodes
from sphinx.builders.latex.nodes import thebibliography
from sphinx_exercise.nodes import is_exercise_node, solution_node

from ftbook import site
from ftbook.fallback import IMAGE, WIDGET

TAG = re.compile(r"\\tag\*?\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}")
BAR = "\N{COMBINING MACRON}"
WIDTH = "78%"           # of the text, for pictures that have no width of their own
PLAIN, NUMBERED = -2, 2     # deepest numbered level: none, sections of chapters


def number_like_pages(app):
    """Handler of ``builder-inited``: exercises are counted by chapter, not by section."""
    if app.builder.format == "latex":
        app.config.numfig_secnum_depth = 1


def number_figures(app, env):
    """Handler of ``env-check-consistency``, after the counting: LaTeX counts parts as a level."""
    if app.builder.format == "latex":
        app.config.numfig_secnum_depth = 2


def add_links(app, document):
    """Handler of ``doctree-read``: on paper, below an explorer's picture, where it is alive."""
    for bundle in list(document.findall(nodes.container)):
        kinds = {part.get("mime_type") for part in bundle.findall(nodes.container)}
        if bundle.get("nb_element") == "mime_bundle" and {WIDGET, IMAGE} <= kinds:
            link = _link(site.address(app.srcdir), f"{app.env.docname}.html")
            place = bundle.parent
            place.insert(place.index(bundle) + 1, addnodes.only("", link, expr="latex"))


def _link(address, page):
    text = nodes.emphasis("", "A picture of an explorer that is alive on the page ")
    text += nodes.reference("", page, refuri=f"{address}/{page}") if address else nodes.Text(page)
    text += nodes.Text(" of the book.")
    return nodes.paragraph("", "", text)


def prepare(app, document, docname):
    """Handler of ``doctree-resolved``, for the whole book as one document."""
    if app.builder.format != "latex":
        return
    front = document.next_node(nodes.section)
    front.insert(1, _raw(rf"\ftpreface{{{front.next_node(nodes.title).astext()}}}"))
    _place_bibliography(document)
    for proof in [box for box in document.findall(nodes.admonition) if "proof" in box["classes"]]:
        _unbox_proof(proof)
    for solution in list(document.findall(solution_node)):
        _unbox_solution(solution)
    for exercise in list(document.findall(is_exercise_node)):
        exercise.parent.insert(exercise.parent.index(exercise), _needs(7))
    for formula in [*document.findall(nodes.math), *document.findall(nodes.math_block)]:
        _set_bars(formula)
    for formula in document.findall(nodes.math_block):
        _set_tag(formula)
    for output in document.findall(nodes.container):
        if output.get("nb_element") == "cell_code_output":
            for formula in output.findall(nodes.math_block):
                _fit(formula)
    for link in list(document.findall(nodes.reference)):
        _link_exercise(link, getattr(app.env, "sphinx_exercise_registry", {}))
    for image in document.findall(nodes.image):
        image.setdefault("width", WIDTH)
    for file in document.findall(addnodes.start_of_file):
        depth = NUMBERED if app.env.toc_secnumbers.get(file["docname"], {}).get("") else PLAIN
        file.insert(0, _raw(rf"\setcounter{{secnumdepth}}{{{depth}}}"))


def _raw(code):
    return nodes.raw("", code, format="latex")


def _place_bibliography(document):
    """Sphinx puts it at the end of the book, and leaves an empty page in its place."""
    for entries in list(document.findall(thebibliography)):
        for file in document.findall(addnodes.start_of_file):
            if file["docname"].endswith("references"):
                entries.parent.remove(entries)
                file[:] = [_raw(rf"\phantomsection\label{{{file['docname']}::doc}}"), entries]


def _unbox_proof(box):
    """*Proof.* and an end mark instead of a box without a title."""
    text = box.next_node(nodes.Text)
    word, dot, rest = text.partition(". ")
    text.parent.replace(text, [nodes.emphasis("", word + dot), nodes.Text(rest)])
    box.replace_self([*box.children, _raw(r"\ftqed")])


def _unbox_solution(box):
    """A heading, and what was in the box."""
    for section in list(box.findall(nodes.section)):
        section.replace_self(section.children)
    title, *parts = box.children
    heading = nodes.paragraph("", "", nodes.strong("", "", *title.children))
    box.replace_self([_needs(4), heading, *parts, _raw(r"\bigskip")])


def _needs(lines):
    """A new page, unless there is room for so many lines."""
    return _raw(f"\n\\par\\needspace{{{lines}\\baselineskip}}\n")


def _link_exercise(link, exercises):
    """sphinx-exercise gives LaTeX another label than the one that Sphinx refers to."""
    label = link.get("refid") or link.get("refuri", "").partition("#")[2]
    if label in exercises:
        words = link.next_node(nodes.Text)
        if words.startswith(" "):                       # which LaTeX drops at the start of a link
            words.parent.replace(words, nodes.Text(words.lstrip()))
            link.parent.insert(link.parent.index(link), nodes.Text(" "))
        link.replace_self([_raw(rf"\hyperref[exercise:{label}]{{"), *link.children, _raw("}")])


def _set_bars(formula):
    """Docstrings write a bar as Unicode does, which the mathematical fonts lack."""
    letters = unicodedata.normalize("NFD", formula.astext())
    if BAR in letters:
        formula[:] = [nodes.Text(re.sub(rf"(.){BAR}", r"\\bar{\1}", letters))]


def _set_tag(formula):
    r"""Sphinx sets a formula inside ``split``, where LaTeX allows no ``\tag``."""
    text = formula.astext()
    if not formula.get("nowrap") and (tag := TAG.search(text)):
        body = TAG.sub("", text).strip()
        formula[:] = [nodes.Text(
            rf"\begin{{equation*}}\begin{{split}}{body}\end{{split}}{tag[0]}\end{{equation*}}")]
        formula["nowrap"] = True


def _fit(formula):
    """What SymPy prints cannot break lines: a formula that is too wide is set smaller."""
    if not formula.get("nowrap"):
        formula[:] = [nodes.Text(rf"\ftfit{{\begin{{split}}{formula.astext()}\end{{split}}}}")]
        formula["nowrap"] = True
