"""A real browser, a small book with all explorers, and a watch on what its pages do.

The small book is built by Jupyter Book from ``minibook/`` with the settings of the real one. Where
no Chromium is installed these tests are skipped, in continuous integration (CI=true) they fail.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from browser import deck
from browser.pages import NAMES, ROOT, Explorer, Watched, missing, served
from ftbook import web

HERE = Path(__file__).parent
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
QUIET = (
    "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync",
    "--disable-background-networking", "--disable-component-update",
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",     # there is no outside
)


@pytest.fixture(scope="session")
def browser():
    path = os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)
    if path is None:
        missing("no Chromium is installed (Debian: apt install chromium; or set CHROMIUM)")
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        missing("playwright is not installed (pip install -e .[browser])")
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=path, args=list(QUIET))
        yield chromium
        chromium.close()


@pytest.fixture(scope="session")
def minibook(tmp_path_factory):
    """The folder of the built small book: index, explorers, faults, deck."""
    folder = tmp_path_factory.mktemp("minibook")
    shutil.copytree(HERE / "minibook", folder, dirs_exist_ok=True)
    deck.write(folder / "book" / "deck.ipynb")
    for name in ("_config.yml", "requirements.lock", "book/_ext", "book/static", "book/templates",
                 "book/web", "book/assets", "book/references.bib"):
        (folder / name).symlink_to(ROOT / name)
    fetched = ROOT / "_build" / "web" / web.version()       # else the build brings them
    if fetched.exists():
        (folder / "_build" / "web").mkdir(parents=True)
        (folder / "_build" / "web" / web.version()).symlink_to(fetched)
    build = [Path(sys.executable).with_name("jupyter-book"), "build", "-W", "-n", "--keep-going"]
    done = subprocess.run([*build, folder], capture_output=True, text=True, check=False, cwd=folder)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder / "_build" / "html" / "book"


@pytest.fixture(scope="session", params=["http", "file"])
def address(request, minibook):
    """The small book's address, over http and straight from the disk."""
    if request.param == "file":
        yield minibook.as_uri()
    else:
        with served(minibook.parent) as site:
            yield f"{site}/book"


@pytest.fixture(scope="session")
def disk(minibook):
    return minibook.as_uri()


@pytest.fixture
def visit(browser):
    """``visit(url, **options)``: a page in a fresh profile; at the end it must have been clean.

    ``clean=False`` leaves the console out of this. Other options go to the browser's context.
    """
    contexts, pages = [], []

    def open_page(url, clean=True, **options):
        options = {"viewport": {"width": 1200, "height": 900}, **options}
        context = browser.new_context(**options)
        contexts.append(context)
        page = context.new_page()
        home = "file:///" if url.startswith("file:") else "/".join(url.split("/")[:3]) + "/"
        watched = Watched(page, home)
        if clean:
            pages.append(watched)
        page.on("console", watched.hear)
        page.on("pageerror", watched.fail)
        context.on("request", lambda request: watched.asked.append(request.url))
        page.goto(url)
        page.watched = watched
        return page

    yield open_page
    said = [list(watched.said) for watched in pages]    # closing breaks off what still loads
    outside = [watched.outside for watched in pages]
    for context in contexts:
        context.close()
    assert not any(said), said
    assert not any(outside), outside


@pytest.fixture(scope="session")
def audit(tmp_path_factory):
    """``audit(page)``: what axe-core (from npm, as package-lock.json says) finds serious.

    ``audit(page, "color-contrast")`` asks this rule alone.
    """
    folder = tmp_path_factory.mktemp("axe")
    for name in ("package.json", "package-lock.json", ".npmrc"):
        shutil.copy(HERE / name, folder)
    web.run_npm("ci", "--ignore-scripts", work=folder)
    script = (folder / "node_modules" / "axe-core" / "axe.min.js").read_text(encoding="utf-8")

    def run(page, *rules):
        page.evaluate(script)
        options = {"resultTypes": ["violations"], "preload": False}
        if rules:
            options["runOnly"] = {"type": "rule", "values": list(rules)}
        result = page.evaluate("options => axe.run(document, options)", options)
        return [(fault["id"], [node["html"][:200] for node in fault["nodes"]][:3])
                for fault in result["violations"] if fault["impact"] in ("serious", "critical")]
    return run


@pytest.fixture
def explorer(visit, disk):
    """``explorer(name, **options)``: one explorer of the small book's page, ready to be used."""
    def find(name, url=f"{disk}/explorers.html", **options):
        return Explorer(visit(url, **options), NAMES.index(name))
    return find
