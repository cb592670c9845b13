"""What the browser tests know about pages: how to serve, watch and use them."""

import contextlib
import functools
import http.server
import os
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

# html-manager's JSON schema validator says this about html-manager's own schema, once a schema.
KNOWN = ("strict mode: use allowUnionTypes",)
# The explorers of minibook/book/explorers.md, in the order of the page.
NAMES = ("cubic", "mathieu", "figure_eight", "coefficients", "convergence", "stability",
         "van_der_pol", "force_exponent", "bands", "closing", "wheels",
         "alive", "secular", "rolling", "growing")


def missing(what):
    """Skip, or fail in continuous integration."""
    if os.environ.get("CI") == "true":
        pytest.fail(f"{what}: continuous integration must not go without the browser tests")
    pytest.skip(f"{what}: the browser tests do not run")


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


# A page took longer than 2 s to begin: only a kernel's messages would wait for it, and a script
# that fails is told in other words, on the console.
LATE = "[anywidget] Failed to initialize model."


@dataclass
class Watched:
    """A page, with what it wrote to the console and what it asked for."""

    page: object
    home: str
    said: list = field(default_factory=list)
    asked: list = field(default_factory=list)

    def hear(self, message):
        url = message.location["url"]
        if message.type in ("warning", "error") and not message.text.startswith(KNOWN):
            self.said.append(f"{message.type}: {message.text} ({url})")

    def fail(self, error):
        if LATE not in str(error):
            self.said.append(f"error: {error}")

    def is_local(self, url):
        return url.startswith((self.home, "blob:", "data:", "about:"))

    @property
    def outside(self):
        return [url for url in self.asked if not self.is_local(url)]


class Explorer:
    """One explorer on a page: its controls by name, its state, its numbers."""

    def __init__(self, page, number):
        self.page = page
        self.box = page.locator(".ft-explorer").nth(number)
        self.box.locator(".ft-status:not(:empty)").wait_for()
        self.box.scroll_into_view_if_needed()

    def settle(self):
        """Wait until what was done is drawn, and announced: at most 0.1 s after its frame."""
        self.page.evaluate("""new Promise(done => requestAnimationFrame(
            () => requestAnimationFrame(() => setTimeout(done, 150))))""")

    def until(self, holds, seconds=60):
        """Wait until something holds that takes its time: a motion, a glide."""
        end = time.monotonic() + seconds
        while not holds():
            assert time.monotonic() < end, "it took too long"
            self.settle()

    @property
    def status(self):
        self.settle()
        return self.box.locator(".ft-status").inner_text()

    @property
    def note(self):
        self.settle()
        return self.box.locator(".ft-note").text_content()

    @property
    def readings(self):
        """``{name: text}`` of the numbers below the pictures."""
        self.settle()
        return dict(self.box.locator(".ft-readings").evaluate(
            "list => [...list.children].map(pair => [...pair.children].map(x => x.textContent))"))

    def number(self, name):
        return float(self.readings[name].replace("−", "-"))

    def pictures(self):
        """The pixels of all canvases."""
        self.settle()
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
