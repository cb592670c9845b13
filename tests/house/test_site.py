"""Where the book is published, and with what it was built."""

from importlib.metadata import version
from types import SimpleNamespace

import pytest
from docutils import nodes
from ftbook import docstrings, downloads, site, versions


@pytest.mark.parametrize(("repository", "address"), [
    ("https://github.com/Someone/ftseries", "https://someone.github.io/ftseries"),
    ("https://gitlab.com/someone/ftseries", None), (None, None),
])
def test_address_of_the_pages_of_a_repository(repository, address):
    assert site.pages_address(repository) == address


def test_environment_comes_first(monkeypatch, tmp_path):
    monkeypatch.setenv("FTSERIES_REPOSITORY", "https://github.com/someone/ftseries")
    monkeypatch.setenv("FTSERIES_SITE", "https://example.org/book/")
    config = SimpleNamespace()
    site.add_address(SimpleNamespace(srcdir=tmp_path), config)
    assert config.html_baseurl == config.ogp_site_url == "https://example.org/book/"
    monkeypatch.delenv("FTSERIES_SITE")
    assert site.address(tmp_path) == "https://someone.github.io/ftseries"
    monkeypatch.setenv("FTSERIES_SITE", "")
    assert site.address(tmp_path) is None


def test_versions_are_those_installed():
    found = dict(versions.versions())
    assert found["numpy"] == version("numpy") and found["jupyter-book"] == version("jupyter-book")
    assert "pytest" not in found                    # tests are no part of the pages


def test_what_was_made_for_download_is_listed_and_copied(tmp_path):
    app = SimpleNamespace(srcdir=tmp_path, outdir=tmp_path / "html",
                          builder=SimpleNamespace(format="html"))
    app.outdir.mkdir()
    env = SimpleNamespace(app=app, docname="book/page", note_reread=lambda: None)
    directive = SimpleNamespace(env=env, parse_inline=lambda text: ([nodes.Text(text)], []))
    (paragraph,) = downloads.Downloads.run(directive)
    assert "make site" in paragraph.astext()
    folder = tmp_path / "_build" / "download"
    folder.mkdir(parents=True)
    (folder / "book.pdf").write_bytes(b"0" * 1_500_000)
    (items,) = downloads.Downloads.run(directive)
    (link,) = items.findall(nodes.reference)
    assert link["refuri"] == "../download/book.pdf" and "1.5 MB" in items.astext()
    downloads.copy(app, RuntimeError())
    assert not (app.outdir / "download").exists()
    downloads.copy(app, None)
    assert (app.outdir / "download" / "book.pdf").stat().st_size == 1_500_000


def test_modules_have_their_names_above_their_texts():
    lines = ["A first line."]
    docstrings.name_module(None, "function", "ftseries.solve", None, None, lines)
    assert lines == ["A first line."]
    docstrings.name_module(None, "module", "ftseries.trig", None, None, lines)
    assert lines == [".. rubric:: ftseries.trig", "", "A first line."]
