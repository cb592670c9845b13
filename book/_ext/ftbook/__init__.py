"""The book's own Sphinx extension: repository links, local web files, a cache that notices.

``links``  launch buttons and repository links, when the repository's address is known;
``web``    MathJax and the widget code, from npm and PyPI into the built book;
``cache``  executed notebooks are reused only while the package is unchanged;
``docstrings``  bars in the formulas of docstrings;
``folds``  what the buttons of folded cells say;
``fallback``  a picture in the place of an explorer, for readers without JavaScript;
``latex``  the book on paper;
``site``  the address of the published book, and its front page;
``punctuation``  no line begins with a comma;
``slides``  each chapter as a deck;
``versions``  what the pages were built with;
``downloads``  links to the PDF and the figures, where they were made;
``bibliography``  its entries as items of a list.
"""

from docutils import nodes

from ftbook import (
    bibliography,
    cache,
    docstrings,
    downloads,
    fallback,
    folds,
    latex,
    links,
    punctuation,
    site,
    slides,
    versions,
    web,
)


def setup(app):
    app.connect("config-inited", links.add_repository)
    app.connect("config-inited", site.add_address)
    app.connect("config-inited", cache.key_by_package)
    app.connect("builder-inited", web.add_web_files)
    app.connect("autodoc-process-docstring", docstrings.name_module)
    app.connect("autodoc-process-docstring", docstrings.escape_bars)
    app.connect("builder-inited", latex.number_like_pages, priority=600)
    app.connect("doctree-read", latex.add_links, priority=200)
    app.connect("doctree-read", folds.name_buttons)
    app.connect("env-check-consistency", latex.number_figures)
    app.connect("doctree-resolved", latex.prepare)
    app.connect("doctree-resolved", punctuation.glue)
    app.connect("source-read", slides.mark_cells)
    app.connect("html-page-context", folds.say_what_is_shown)
    app.connect("html-page-context", site.tidy_tags, priority=600)
    app.connect("html-page-context", site.keep_first, priority=700)
    app.connect("html-page-context", slides.cut, priority=600)
    app.connect("html-collect-pages", site.add_front)
    app.connect("html-collect-pages", slides.write)
    app.connect("doctree-read", fallback.add_pictures, priority=100)
    app.connect("build-finished", downloads.copy)
    app.add_directive("built-with", versions.BuiltWith)
    app.add_directive("downloads", downloads.Downloads)
    entry = (bibliography.visit_citation, bibliography.depart_citation)
    app.add_node(nodes.citation, override=True, html=entry)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
