"""Every page of the built book: nothing from outside, a clean console, explorers alive, no barrier.

The book must be built (`make book`); where it is not, these tests are skipped, in continuous
integration they fail.
"""

import re

import pytest
from browser.pages import ROOT, missing, served

BUILT = ROOT / "_build" / "html"
WIDGET_CODE = ("requirejs", "html-manager", "anywidget")


def pages():
    return sorted(page.relative_to(BUILT).as_posix() for page in BUILT.rglob("*.html")
                  if "_static" not in page.parts)


@pytest.fixture(scope="module", params=["http", "file"])
def book(request):
    if not (BUILT / "index.html").exists():
        missing("the book is not built (make book)")
    if request.param == "file":
        yield BUILT.as_uri()
    else:
        with served(BUILT) as site:
            yield site


def test_every_page_stands_alone(visit, book):
    for name in pages():
        page = visit(f"{book}/{name}")
        page.wait_for_load_state("load")
        wanted = page.locator("script[type='application/vnd.jupyter.widget-view+json']").count()
        page.wait_for_function(
            "wanted => document.querySelectorAll('.ft-explorer').length >= wanted && "
            "[...document.querySelectorAll('.ft-explorer')].every(box => "
            "box.querySelector('.ft-error, .ft-status:not(:empty)'))", arg=wanted, timeout=60_000)
        assert page.locator(".ft-error").count() == 0, name
        loads = any(code in url for url in page.watched.asked for code in WIDGET_CODE)
        assert loads == (wanted > 0), name
        assert page.watched.outside == [], name
        assert page.watched.said == [], name
        if "-slides" not in name:
            page.set_viewport_size({"width": 390, "height": 844})          # of a phone
            assert page.evaluate("document.documentElement.scrollWidth") <= 390, name
        page.context.close()


def test_every_page_names_its_icon_and_title(visit):
    """A page without an icon makes browsers ask the server's root for one, now and then in vain."""
    if not (BUILT / "index.html").exists():
        missing("the book is not built (make book)")
    for name in pages():
        text = (BUILT / name).read_text(encoding="utf-8")
        icon = re.search(r'<link rel="icon" href="([^"]+)"', text)[1]
        assert (BUILT / name).parent.joinpath(icon).is_file(), name
        assert re.search(r"<title>[^<]+</title>", text), name
    page = visit(f"{BUILT.as_uri()}/index.html")
    page.wait_for_url("**/book/preface.html")
    assert "og:title" in (BUILT / "index.html").read_text(encoding="utf-8")


def test_every_slide_says_what_it_is_about(visit):
    """Each has a heading and something below it."""
    if not (BUILT / "index.html").exists():
        missing("the book is not built (make book)")
    for name in [name for name in pages() if name.endswith("-slides.html")]:
        page = visit(f"{BUILT.as_uri()}/{name}")
        page.wait_for_function("window.Reveal && Reveal.isReady()", timeout=60_000)
        slides = page.evaluate("""Reveal.getSlides().map((slide) => ({
            heading: slide.querySelector("h1, h2, h3, h4")?.textContent ?? "",
            parts: [...slide.children].filter((part) => !part.matches("h1, h2, h3, h4, aside")
                && (part.textContent.trim() || part.querySelector("img, svg, canvas"))).length,
        }))""")
        assert 10 <= len(slides) <= 30, (name, len(slides))
        for number, slide in enumerate(slides, 1):
            assert slide["heading"] and slide["parts"], (name, number, slide)
        page.context.close()


@pytest.mark.parametrize("part", range(4))
def test_no_page_has_a_serious_barrier(visit, audit, part):
    """In light and in dark; each part has every fourth page."""
    if not (BUILT / "index.html").exists():
        missing("the book is not built (make book)")
    found = {}
    for name in pages()[part::4]:
        page = visit(f"{BUILT.as_uri()}/{name}", color_scheme="light")
        page.wait_for_load_state("load")
        page.wait_for_timeout(1500)
        for theme in ("light", "dark"):
            page.emulate_media(color_scheme=theme)
            page.wait_for_timeout(500)
            found[name, theme] = audit(page)
        page.context.close()
    assert {page: faults for page, faults in found.items() if faults} == {}
