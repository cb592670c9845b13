"""The book's own Sphinx extension: repository links, local web files, a cache that notices.

``links``  launch buttons and repository links, when the repository's address is known;
``web``    MathJax and the widget code, from npm and PyPI into the built book;
``cache``  executed notebooks are reused only while the package is unchanged;
``docstrings``  bars in the formulas of docstrings.
"""

from ftbook import cache, docstrings, links, web


def setup(app):
    app.connect("config-inited", links.add_repository)
    app.connect("config-inited", cache.key_by_package)
    app.connect("builder-inited", web.add_web_files)
    app.connect("autodoc-process-docstring", docstrings.escape_bars)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
