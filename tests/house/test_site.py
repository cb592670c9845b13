"""Where the book is published, and with what it was built."""

from importlib.metadata import version
from types import SimpleNamespace

import pytest
from ftbook import site, versions


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
