"""Every page of the built book: nothing from outside, a clean console, explorers alive, no barrier.

The book must be built (`make book`); where it is not, these tests are skipped, in continuous
integration they fail.
"""

import re

import pytest
from browser.pages import ROOT, missing, served

BUILT = ROOT / "_build" / "html"
WIDGET_CODE = ("requirejs", "html-manager", "anywidget")
PARTS = 4               # so that no process is left with all pages at the end


def pages():
    return sorted(page.relative_to(BUILT).as_posix() for page in BUILT.rglob("*.html")
                  if "_static" not in page.parts)


@pytest.fixture(scope="module", autouse=True)
def built():
    if not (BUILT / "index.html").exists():
        missing("the book is not built (make book)")


@pytest.fixture(scope="module")
def site():
    with served(BUILT) as address:
        yield address


def stands_alone(page, name):
    """All explorers show something, nothing came from outside, the console is clean."""
    if name == "index.html":                                # it leads to another page at once
        page.wait_for_url("**/book/index.html")
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


def fits_a_phone(page, name):
    page.set_viewport_size({"width": 390, "height": 844})
    assert page.evaluate("document.documentElement.scrollWidth") <= 390, name


@pytest.mark.parametrize("part", range(PARTS))
def test_every_page_stands_alone_over_http(visit, site, part):
    for name in pages()[part::PARTS]:
        page = visit(f"{site}/{name}")
        stands_alone(page, name)
        page.context.close()


@pytest.mark.parametrize("part", range(PARTS))
def test_every_page_stands_alone_from_disk_without_a_serious_barrier(visit, audit, part):
    """In light and in dark; and, but for slides, no page is wider than a phone."""
    found = {}
    for name in pages()[part::PARTS]:
        page = visit(f"{BUILT.as_uri()}/{name}", color_scheme="light")
        stands_alone(page, name)
        page.wait_for_function("window.MathJax?.startup?.promise.then(() => true) ?? true")
        page.add_style_tag(content="* { transition: none !important; }")
        found[name, "light"] = audit(page)
        page.emulate_media(color_scheme="dark")                 # which changes nothing but colours
        page.wait_for_timeout(300)
        found[name, "dark"] = audit(page, "color-contrast")
        if "-slides" not in name:
            fits_a_phone(page, name)
        page.context.close()
    assert {page: faults for page, faults in found.items() if faults} == {}


def test_every_page_names_its_icon_and_title(visit):
    """A page without an icon makes browsers ask the server's root for one, now and then in vain."""
    for name in pages():
        text = (BUILT / name).read_text(encoding="utf-8")
        icon = re.search(r'<link rel="icon" href="([^"]+)"', text)[1]
        assert (BUILT / name).parent.joinpath(icon).is_file(), name
        assert re.search(r"<title>[^<]+</title>", text), name
    page = visit(f"{BUILT.as_uri()}/index.html")
    page.wait_for_url("**/book/index.html")
    assert "og:title" in (BUILT / "index.html").read_text(encoding="utf-8")


def test_every_slide_says_what_it_is_about(visit):
    """Each has a heading and something below it."""
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
