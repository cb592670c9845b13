"""Explorers for everyone: keyboard, phone, themes, reduced motion, an audit by axe-core."""

import re

import pytest
from browser.pages import NAMES, Explorer

PAGES = ("index", "explorers", "faults")
THEMES = ("light", "dark")


def ready(page):
    """All explorers of the page, when each shows its state or says why it cannot."""
    page.wait_for_function(
        "[...document.querySelectorAll('.ft-explorer')].every(box => "
        "box.querySelector('.ft-error, .ft-status:not(:empty)'))"
        " && document.readyState === 'complete'")
    page.wait_for_timeout(300)
    return page


@pytest.mark.parametrize("theme", THEMES)
@pytest.mark.parametrize("name", PAGES)
def test_audit(visit, disk, audit, name, theme):
    page = ready(visit(f"{disk}/{name}.html", color_scheme=theme))
    if name != "index":
        page.locator(".ft-explorer").first.wait_for()
    assert audit(page) == []


@pytest.mark.parametrize("number, name", list(enumerate(NAMES)))
def test_keyboard_reaches_every_control(visit, disk, number, name):
    """Tab alone; each focus is visible."""
    page = ready(visit(f"{disk}/explorers.html", reduced_motion="reduce"))
    box = page.locator(".ft-explorer").nth(number)
    controls = box.locator(".noUi-handle, .widget-readout, button, select")
    wanted = controls.count()
    controls.first.focus()
    page.keyboard.press("Shift+Tab")
    reached = set()
    for _ in range(wanted + 3):
        page.keyboard.press("Tab")
        focused = page.evaluate(
            "box => { const e = document.activeElement, s = getComputedStyle(e);"
            " return box.contains(e) ? [e.getAttribute('aria-label') ?? e.textContent,"
            " e.tagName + e.className, s.outlineStyle, parseFloat(s.outlineWidth)] : null; }",
            box.element_handle())
        if focused:
            label, kind, style, width = focused
            assert label.strip() and style != "none" and width >= 2, focused
            reached.add((label, kind))
    triangle = name in ("coefficients", "growing")                 # one cell of it is reached too
    assert len(reached) == wanted + triangle


def test_keyboard_works_the_button(explorer):
    shown = explorer("cubic")
    shown.button("Play").focus()
    shown.page.keyboard.press("Space")
    shown.until(lambda: shown.value("t") > 0)
    shown.page.keyboard.press("Space")
    shown.settle()
    stopped = shown.value("t")
    shown.page.wait_for_timeout(400)
    assert shown.value("t") == stopped


def test_arrow_keys_walk_the_triangle(explorer):
    shown = explorer("coefficients")
    label = "document.activeElement.getAttribute('aria-label')"
    shown.box.get_by_role("gridcell", name="r, n = 2, m = 6:").focus()
    walk = {"ArrowRight": "n = 2, m = 8", "ArrowUp": "n = 4, m = 8", "ArrowLeft": "n = 4, m = 6",
            "ArrowDown": "n = 2, m = 6", "End": "m = 24", "Home": "m = "}
    for key, place in walk.items():
        shown.page.keyboard.press(key)
        assert place in shown.page.evaluate(label), key
    assert shown.box.locator("[tabindex='0'][role=gridcell]").count() == 1


def test_roles_names_and_announcement(visit, disk):
    page = ready(visit(f"{disk}/explorers.html"))
    for number in range(len(NAMES)):
        shown = Explorer(page, number)
        assert shown.box.get_by_role("status").count() == 1
        for handle in shown.box.locator(".noUi-handle").all():
            assert handle.get_attribute("role") == "slider" and handle.get_attribute("aria-label")
        for picture in shown.box.locator("canvas").all():
            assert picture.get_attribute("role") == "img" and picture.get_attribute("aria-label")
        assert shown.box.locator("[title=null]").count() == 0


@pytest.mark.parametrize("width", [360, 390])
def test_phone(visit, disk, width):
    """Nothing is wider than the phone, sliders are long enough for a thumb, a touch moves them."""
    page = ready(visit(f"{disk}/explorers.html", viewport={"width": width, "height": 740},
                       has_touch=True, is_mobile=True, device_scale_factor=2))
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    for number in range(len(NAMES)):
        shown = Explorer(page, number)
        for part in shown.box.locator("canvas, .ft-controls > *, .ft-readings, .ft-triangle").all():
            box = part.bounding_box()
            assert box["x"] >= 0 and box["x"] + box["width"] <= width + 0.5
        for slider in shown.box.locator(".noUi-target").all():
            assert slider.bounding_box()["width"] > 100
    shown = Explorer(page, 0)
    track = shown.box.locator(".noUi-target").first.bounding_box()
    page.touchscreen.tap(track["x"] + 0.8 * track["width"], track["y"] + track["height"] / 2)
    assert 2.5 < shown.value("λ") < 3.1 and f"λ = {shown.value('λ'):.2f}" in shown.status


def test_on_a_phone_the_controls_stay_in_sight(visit, disk):
    page = ready(visit(f"{disk}/explorers.html", viewport={"width": 360, "height": 740}))
    controls, picture = page.locator(".ft-controls").first, page.locator("canvas").nth(2)
    picture.evaluate("canvas => canvas.scrollIntoView({ block: 'center' })")
    page.wait_for_timeout(300)
    box, below = controls.bounding_box(), picture.bounding_box()
    assert 0 <= box["y"] < 120 and box["y"] + box["height"] < below["y"] + below["height"] / 2


def rgb(text):
    return [int(part) for part in re.findall(r"\d+", text)[:3]]


def test_dark_theme(visit, disk):
    """The page's button changes the theme; paper, ink and the drawn pictures follow."""
    page = ready(visit(f"{disk}/explorers.html", color_scheme="light"))
    shown = Explorer(page, 0)
    style = "box => [getComputedStyle(box).backgroundColor, getComputedStyle(box).color]"
    paper, ink = map(rgb, shown.box.evaluate(style))
    assert min(paper) > 240 and max(ink) < 60
    pixels = shown.pictures()
    page.evaluate("document.documentElement.dataset.theme = 'dark'")
    shown.settle()
    paper, ink = map(rgb, shown.box.evaluate(style))
    assert max(paper) < 60 and min(ink) > 200
    assert all(new != old for new, old in zip(shown.pictures(), pixels, strict=True))


def test_the_system_s_dark_theme(visit, disk):
    page = ready(visit(f"{disk}/explorers.html", color_scheme="dark"))
    box = page.locator(".ft-explorer").first
    assert max(rgb(box.evaluate("box => getComputedStyle(box).backgroundColor"))) < 60


@pytest.mark.parametrize("motion, moves", [("reduce", False), ("no-preference", True)])
def test_reduced_motion(explorer, motion, moves):
    """The eight starts moving by itself, but not for readers who asked for rest."""
    shown = explorer("figure_eight", reduced_motion=motion)
    before = shown.readings["r₁"]
    if moves:
        shown.until(lambda: shown.readings["r₁"] != before)
    else:
        shown.page.wait_for_timeout(800)
        assert shown.readings["r₁"] == before
