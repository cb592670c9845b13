"""Where the built book is published, if anywhere: for links from paper and for social cards.

The address is the environment variable FTSERIES_SITE, or else the GitHub Pages of the repository
that ``links`` finds. There, the first page stands under its own title and card.
"""

import os
import re

from ftbook import links


def pages_address(repository):
    """Address of a GitHub repository's pages, or None.

    >>> pages_address("https://github.com/Someone/ftseries")
    'https://someone.github.io/ftseries'
    >>> pages_address("https://gitlab.com/someone/ftseries") is None
    True
    """
    match = re.fullmatch(r"https://github\.com/([\w-]+)/([\w.-]+)", repository or "")
    return f"https://{match[1].lower()}.github.io/{match[2]}" if match else None


def address(folder):
    """Public address of the book whose sources are in ``folder``, without a slash, or None."""
    if "FTSERIES_SITE" in os.environ:
        return os.environ["FTSERIES_SITE"].rstrip("/") or None
    return pages_address(links.find_repository(str(folder)))


def add_address(app, config):
    """Handler of ``config-inited``: canonical links and social cards name the address."""
    if found := address(app.srcdir):
        config.html_baseurl = config.ogp_site_url = f"{found}/"


def tidy_tags(app, pagename, templatename, context, doctree):
    """Handler of ``html-page-context``: items of a list that end with a semicolon need no comma."""
    context["metatags"] = context.get("metatags", "").replace(";, ", "; ")


def keep_first(app, pagename, templatename, context, doctree):
    """Handler of ``html-page-context``, after all tags are there: what ``add_front`` will need."""
    if pagename == app.config.root_doc:
        app.builder.ftbook_front = {key: context[key] for key in ("title", "metatags")}


def add_front(app):
    """Handler of ``html-collect-pages``: ``index.html`` leads to the book's first page.

    Jupyter Book writes such a page only where there is none: without a title, language or icon.
    """
    if hasattr(app.builder, "ftbook_front") and app.config.root_doc != "index":
        yield "index", app.builder.ftbook_front, "front.html"
