"""Repository links: the buttons appear for addresses that a reader can open, else they do not."""

import subprocess
from types import SimpleNamespace

import pytest
from ftbook import links


@pytest.mark.parametrize(
    "remote",
    [
        "https://github.com/someone/ftseries.git",
        "https://github.com/someone/ftseries/",
        "https://someone:secret@github.com/someone/ftseries.git",
        "git@github.com:someone/ftseries.git",
        "ssh://git@github.com:22/someone/ftseries.git",
        "  https://GitHub.com/someone/ftseries\n",
    ],
)
def test_equivalent_remotes_give_one_public_address(remote):
    assert links.public_address(remote) == "https://github.com/someone/ftseries"


@pytest.mark.parametrize(
    "remote",
    [
        "",
        "/srv/git/ftseries.git",
        "file:///srv/git/ftseries.git",
        "../ftseries",
        "C:/ftseries/main",
        "https://example.org/someone/ftseries.git",
        "https://github.com.example.org/someone/ftseries",
        "https://github.com/someone",
    ],
)
def test_other_remotes_give_none(remote):
    assert links.public_address(remote) is None


def test_environment_comes_before_the_remote(tmp_path, monkeypatch):
    monkeypatch.delenv("FTSERIES_REPOSITORY", raising=False)
    assert links.find_repository(str(tmp_path)) is None
    subprocess.run(["git", "init", "-q", tmp_path], check=True)
    assert links.find_repository(str(tmp_path)) is None
    remote = "git@gitlab.com:group/part/ftseries.git"
    subprocess.run(["git", "-C", tmp_path, "remote", "add", "origin", remote], check=True)
    assert links.find_repository(str(tmp_path)) == "https://gitlab.com/group/part/ftseries"
    monkeypatch.setenv("FTSERIES_REPOSITORY", "https://github.com/someone/ftseries")
    assert links.find_repository(str(tmp_path)) == "https://github.com/someone/ftseries"
    monkeypatch.setenv("FTSERIES_REPOSITORY", "")
    assert links.find_repository(str(tmp_path)) is None


@pytest.mark.parametrize(("host", "colab"), [("github.com", True), ("gitlab.com", False)])
def test_colab_opens_notebooks_of_github_alone(monkeypatch, host, colab):
    monkeypatch.setenv("FTSERIES_REPOSITORY", f"https://{host}/someone/ftseries")
    config = SimpleNamespace(html_theme_options={})
    links.add_repository(SimpleNamespace(srcdir="."), config)
    buttons = config.html_theme_options["launch_buttons"]
    assert buttons["binderhub_url"] and bool(buttons["colab_url"]) == colab
