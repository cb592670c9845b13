r"""The book on paper: what LaTeX needs besides what Sphinx gives it.

Formulas keep the tags of the paper, chapters, figures and exercises have the numbers that they have
on the pages, figures leave room for text, and an explorer is a picture with a link to its page.
"""

import re
import unicodedata

from docutils import nodes
from sphinx import addnodes

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
    preface = document.next_node(nodes.section)
    preface.insert(1, nodes.raw("", r"\ftpreface{Preface}", format="latex"))
    for formula in [*document.findall(nodes.math), *document.findall(nodes.math_block)]:
        _set_bars(formula)
    for formula in document.findall(nodes.math_block):
        _set_tag(formula)
    for output in document.findall(nodes.container):
        if output.get("nb_element") == "cell_code_output":
            for formula in output.findall(nodes.math_block):
                _fit(formula)
    for number in list(document.findall(addnodes.number_reference)):
        _name_exercise(number, getattr(app.env, "sphinx_exercise_registry", {}))
    for image in document.findall(nodes.image):
        image.setdefault("width", WIDTH)
    for file in document.findall(addnodes.start_of_file):
        depth = NUMBERED if app.env.toc_secnumbers.get(file["docname"], {}).get("") else PLAIN
        file.insert(0, nodes.raw("", rf"\setcounter{{secnumdepth}}{{{depth}}}", format="latex"))


def _name_exercise(number, exercises):
    """sphinx-exercise gives LaTeX another label than the one that Sphinx refers to by number."""
    label = number.get("refid") or number.get("refuri", "").partition("#")[2]
    if label in exercises:
        link = rf"\hyperref[exercise:{label}]{{{number.astext()}}}"
        number.replace_self(nodes.raw("", link, format="latex"))


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
