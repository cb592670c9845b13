"""A real browser, a small book with all explorers, and a watch on what its pages do.

The small book is built by Jupyter Book from ``minibook/`` with the settings of the real one. Where
no Chromium is installed these tests are skipped, in continuous integration (CI=true) they fail.
"""

import contextlib
import functools
import http.server
import os
import shutil
import subprocess
import sys
import threading
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from ftbook import web

ROOT = Path(__file__).parents[2]
HERE = Path(__file__).parent
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
QUIET = (
    "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync",
    "--disable-background-networking", "--disable-component-update",
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",     # there is no outside
)
# html-manager's JSON schema validator says this about html-manager's own schema, once a schema.
KNOWN = ("strict mode: use allowUnionTypes",)


def missing(what):
    """Skip, or fail in continuous integration."""
    if os.environ.get("CI") == "true":
        pytest.fail(f"{what}: continuous integration must not go without the browser tests")
    pytest.skip(f"{what}: the browser tests do not run")


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
    """The folder of the built small book: index, explorers, faults, plain."""
    folder = tmp_path_factory.mktemp("minibook")
    shutil.copytree(HERE / "minibook", folder, dirs_exist_ok=True)
    shutil.copy(ROOT / "_config.yml", folder)
    for name in ("_ext", "static", "web", "references.bib"):
        (folder / "book" / name).symlink_to(ROOT / "book" / name)
    cache = ROOT / "_build" / "web"
    if not (cache / web.version()).exists():
        web.fetch(cache)
    (folder / "_build").mkdir()
    (folder / "_build" / "web").symlink_to(cache)
    build = [sys.executable, "-m", "jupyter_book", "build", "-W", "-n", "--keep-going", folder]
    done = subprocess.run(build, capture_output=True, text=True, check=False, cwd=folder)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder / "_build" / "html" / "book"


@contextlib.contextmanager
def served(folder):
    """The address at which a folder is served over http."""
    class Handler(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *args):
            pass

    handler = functools.partial(Handler, directory=str(folder))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


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


@dataclass
class Watched:
    """A page, with what it wrote to the console and what it asked for."""

    page: object
    home: str
    said: list = field(default_factory=list)
    asked: list = field(default_factory=list)

    def is_local(self, url):
        return url.startswith((self.home, "blob:", "data:", "about:"))

    @property
    def outside(self):
        return [url for url in self.asked if not self.is_local(url)]


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
        page.on("console", lambda message: watched.said.append(f"{message.type}: {message.text}")
                if message.type in ("warning", "error")
                and not message.text.startswith(KNOWN) else None)
        page.on("pageerror", lambda error: watched.said.append(f"error: {error}"))
        context.on("request", lambda request: watched.asked.append(request.url))
        page.goto(url)
        page.watched = watched
        return page

    yield open_page
    for context in contexts:
        context.close()
    for watched in pages:
        assert watched.said == []
        assert watched.outside == []


@pytest.fixture
def explorer(visit, disk):
    """``explorer(name, **options)``: one explorer of the small book's page, ready to be used."""
    def find(name, url=f"{disk}/explorers.html", **options):
        return Explorer(visit(url, **options), NAMES.index(name))
    return find


NAMES = ("cubic", "mathieu", "figure_eight", "coefficients")    # their order on the page


class Explorer:
    """One explorer on a page: its controls by name, its state, its numbers."""

    def __init__(self, page, number):
        self.page = page
        self.box = page.locator(".ft-explorer").nth(number)
        self.box.locator(".ft-status:not(:empty)").wait_for()
        self.box.scroll_into_view_if_needed()

    @property
    def status(self):
        self.page.wait_for_timeout(200)         # the announcement is at most 0.1 s late
        return self.box.locator(".ft-status").inner_text()

    @property
    def note(self):
        self.page.wait_for_timeout(100)
        return self.box.locator(".ft-note").text_content()

    @property
    def readings(self):
        """``{name: text}`` of the numbers below the pictures."""
        self.page.wait_for_timeout(100)
        return dict(self.box.locator(".ft-readings").evaluate(
            "list => [...list.children].map(pair => [...pair.children].map(x => x.textContent))"))

    def number(self, name):
        return float(self.readings[name].replace("−", "-"))

    def pictures(self):
        """The pixels of all canvases."""
        self.page.wait_for_timeout(100)
        return self.box.locator("canvas").evaluate_all("all => all.map(c => c.toDataURL())")

    def handle(self, name):
        return self.box.get_by_role("slider", name=name, exact=True)

    def value(self, name):
        return float(self.handle(name).get_attribute("aria-valuenow"))

    def button(self, name):
        return self.box.get_by_role("button", name=name)

    def type(self, name, text):
        readout = self.box.get_by_role("textbox", name=f"{name}, typed")
        readout.click()
        self.page.keyboard.press("Control+a")
        self.page.keyboard.type(str(text))
        self.page.keyboard.press("Enter")
