"""The book's own Sphinx extension: repository links, local web files, a cache that notices.

``links``  launch buttons and repository links, when the repository's address is known;
``web``    MathJax and the widget code, from npm and PyPI into the built book;
``cache``  executed notebooks are reused only while the package is unchanged;
``docstrings``  bars in the formulas of docstrings;
``fallback``  a picture in the place of an explorer, for readers without JavaScript;
``bibliography``  its entries as items of a list.
"""

from docutils import nodes

from ftbook import bibliography, cache, docstrings, fallback, links, web


def setup(app):
    app.connect("config-inited", links.add_repository)
    app.connect("config-inited", cache.key_by_package)
    app.connect("builder-inited", web.add_web_files)
    app.connect("autodoc-process-docstring", docstrings.escape_bars)
    app.connect("doctree-read", fallback.add_pictures, priority=100)
    entry = (bibliography.visit_citation, bibliography.depart_citation)
    app.add_node(nodes.citation, override=True, html=entry)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
