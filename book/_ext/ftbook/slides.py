"""Each chapter as slides, beside its page: ``cubic.html`` and ``cubic-slides.html``.

The cells themselves say what a deck shows, by the metadata that Jupyter gives them under
``slideshow``, ``slide_type``: a cell begins a ``slide`` or, below it, a ``subslide``, appears on it
as a ``fragment``, goes on (``-``), or is what the speaker says (``notes``). Other cells are left
out, and so is the code of a cell without the tag ``slide-code``. A slide that begins no section has
the heading of the one that it is in. A deck is cut from the page as Sphinx resolved it: the same
outputs, explorers, and numbers of equations, figures and theorems.
References to what the deck leaves out lead to the page.
"""

import json

from docutils import nodes
from docutils.utils import new_document
from myst_nb.sphinx_ import HideCodeCellNode, NbMetadataCollector

SHOWN = ("slide", "subslide", "fragment", "notes", "-")
MARK = "slide_type:"
#: boxes whose titles are their kinds: the writer of a page adds these
NAMED = (nodes.attention, nodes.caution, nodes.danger, nodes.error, nodes.hint, nodes.important,
         nodes.note, nodes.tip, nodes.warning)


def slide_type(metadata):
    """What a cell is in its deck; the empty string: it is left out."""
    kind = metadata.get("slideshow", {}).get("slide_type", "")
    return kind if kind in SHOWN else ""


def mark_cells(app, docname, source):
    """Handler of ``source-read``: a block break at the top of each text cell says what it is.

    The document tree knows the metadata of code cells only.
    """
    if not str(app.env.doc2path(docname)).endswith(".ipynb"):
        return
    notebook = json.loads(source[0])
    if any(slide_type(cell["metadata"]) for cell in notebook["cells"]):
        for cell in notebook["cells"]:
            if cell["cell_type"] == "markdown":
                mark = f"+++ {MARK}{slide_type(cell['metadata'])}\n"
                cell["source"] = mark + "".join(cell["source"])
        source[0] = json.dumps(notebook)


def cells(doctree):
    """``[(slide type, parts)]`` of a page's cells in order, with its sections opened."""
    found = [("", [])]

    def walk(parent):
        for node in parent.children:
            if isinstance(node, nodes.comment) and node.astext().startswith(MARK):
                found.append((node.astext().removeprefix(MARK), []))
            elif isinstance(node, nodes.section):
                walk(node)
            elif isinstance(node, nodes.container) and node.get("nb_element") == "cell_code":
                found.extend([(slide_type(node["cell_metadata"]), [node]), ("", [])])
            else:
                found[-1][1].append(node)

    walk(doctree)
    return [(kind, parts) for kind, parts in found if kind and parts]


def deck(doctree):
    """The slides of a page: a list of stacks, each a list of sections; empty if it has none."""
    stacks = []
    for kind, parts in cells(doctree):
        if kind == "slide" or not stacks:
            stacks.append([])
        if kind in ("slide", "subslide") or not stacks[-1]:
            heading = [] if isinstance(parts[0], nodes.title) else _heading_again(parts[0])
            stacks[-1].append(nodes.section("", *heading, ids=[_anchor(parts, stacks)]))
        copies = [_for_slides(part) for part in parts]
        if kind == "notes":
            copies = [nodes.raw("", '<aside class="notes">', format="html"), *copies,
                      nodes.raw("", "</aside>", format="html")]
        elif kind == "fragment":
            copies = [nodes.container("", *copies, classes=["fragment"])]
        stacks[-1][-1] += copies
    return stacks


def _anchor(parts, stacks):
    """Id of a new slide: that of the section of the page that it begins, else a new one."""
    if isinstance(parts[0], nodes.title):
        return parts[0].parent["ids"][0]
    return f"slide-{len(stacks)}-{len(stacks[-1]) + 1}"


def _heading_again(part):
    """The title of the page's section that holds a part: a slide without one of its own has it."""
    while (part := part.parent) is not None:
        if isinstance(part, nodes.section) and isinstance(part.children[0], nodes.title):
            title = part.children[0].deepcopy()
            title["classes"].append("again")
            title["anchor"] = "#" + part["ids"][0]
            return [title]
    return []


def _for_slides(original):
    """A part of the page without code, and without sections: reveal.js takes those for slides."""
    part = original.deepcopy()
    if isinstance(part, nodes.title):
        part["anchor"] = "#" + original.parent["ids"][0]
    for fold in list(part.findall(HideCodeCellNode)):
        fold.replace_self(fold.children)
    if "slide-code" not in part.get("cell_metadata", {}).get("tags", []):
        for code in list(part.findall(nodes.container)):
            if code.get("nb_element") == "cell_code_source":
                code.parent.remove(code)
    for section in list(part.findall(nodes.section)):
        section.replace_self(nodes.container("", *section.children))
    for box in part.findall(lambda node: isinstance(node, NAMED)):
        if isinstance(box[0], nodes.title):
            del box[0]                  # the page's writer put it there, the deck's does so again
    return part


def _lead_to_page(stacks, page):
    """Links to places on the page that the deck leaves out become links to the page."""
    sections = [section for stack in stacks for section in stack]
    here = {name for section in sections for node in section.findall(nodes.Element)
            for name in node.get("ids", [])}
    for section in sections:
        for link in section.findall(nodes.reference):
            name = link.get("refid") or link.get("refuri", "").removeprefix("#")
            if ("refid" in link or link.get("refuri", "").startswith("#")) and name not in here:
                link.attributes.pop("refid", None)
                link["refuri"] = f"{page}#{name}"


def cut(app, pagename, templatename, context, doctree):
    """Handler of ``html-page-context``: the page's deck, and a button that opens it."""
    stacks = deck(doctree) if doctree is not None else []
    if not stacks:
        return
    builder = app.builder
    _lead_to_page(stacks, builder.get_relative_uri(f"{pagename}-slides", pagename))
    permalinks, builder.add_permalinks = builder.add_permalinks, False
    html = [[_html(builder, section) for section in stack] for stack in stacks]
    builder.add_permalinks = permalinks
    decks(app)[pagename] = {
        "title": context["title"], "stacks": html, "page": pagename,
        "mathjax": app.config.mathjax_path,
        "widgets": list(NbMetadataCollector.get_js_files(app.env, pagename).values()),
    }  # fmt: skip
    for button in context.get("header_buttons", []):
        if button.get("label") == "download-buttons":
            button["buttons"].append({
                "type": "link", "url": builder.get_relative_uri(pagename, f"{pagename}-slides"),
                "text": "Slides", "icon": "fas fa-desktop", "label": "slides-button",
                "tooltip": "Slides of this chapter"})


def _html(builder, section):
    for title in section.findall(nodes.title):
        numbers = builder.secnumbers
        if "anchor" in title and (number := numbers.get(title["anchor"], numbers.get(""))):
            title["secnumber"] = number
    document = new_document("slide", builder.docsettings)
    document += section
    translator = builder.create_translator(document, builder)
    document.walkabout(translator)
    return "".join(translator.fragment)


def decks(app):
    """``{page: context of its deck}`` of this build."""
    if not hasattr(app.builder, "ftbook_decks"):
        app.builder.ftbook_decks = {}
    return app.builder.ftbook_decks


def write(app):
    """Handler of ``html-collect-pages``: the decks as pages of their own."""
    for pagename, context in decks(app).items():
        yield f"{pagename}-slides", context, "slides.html"
