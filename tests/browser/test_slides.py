"""A deck in a browser, without a network: cut as its cells say, formulas and explorer alive."""

import pytest
from browser.pages import Explorer


@pytest.fixture
def deck(visit, address):
    page = visit(f"{address}/deck-slides.html", viewport={"width": 1280, "height": 720})
    page.wait_for_function("window.Reveal && Reveal.isReady()")
    return page


def go(page, *keys):
    for key in keys:
        page.keyboard.press(key)
    return page.locator(".slides section.present:not(.stack)")


def test_cells_are_what_they_say(deck):
    assert deck.evaluate("Reveal.getTotalSlides()") == 5
    shape = deck.evaluate(
        "Reveal.getHorizontalSlides().map(slide => slide.querySelectorAll('section').length)")
    assert shape == [0, 2, 0, 0]
    assert "Left out" not in deck.locator(".slides").text_content()
    assert deck.locator(".slides .fragment").count() == 1


def test_keys_lead_through_the_deck(deck):
    assert "A deck" in go(deck).inner_text()
    slide = go(deck, "ArrowRight")
    assert "A formula" in slide.inner_text()
    fragment = slide.locator(".fragment")
    assert "visible" not in fragment.get_attribute("class")
    go(deck, "Space")
    assert "visible" in fragment.get_attribute("class")
    assert "Every order has one solution." in go(deck, "Space").inner_text()
    assert "present" in go(deck, "End").get_attribute("class")
    assert "42" in go(deck).inner_text() and "print" in go(deck).inner_text()


def test_formulas_are_set_and_keep_their_tags(deck):
    assert deck.locator(".slides mjx-container").count() >= 2
    slide = go(deck, "ArrowRight")
    box = slide.locator("mjx-container[display=true]").bounding_box()
    assert box["height"] > 20 and box["width"] > 200


def test_references_stay_in_the_deck_or_lead_to_the_page(deck):
    links = {link.inner_text(): link for link in go(deck, "ArrowRight", "ArrowDown", "ArrowDown")
             .locator("a").all()}
    assert links["(D1)"].get_attribute("href") == "#eq-deck"
    assert links["(D2)"].get_attribute("href") == "deck.html#eq-left-out"
    assert links["Theorem 1"].get_attribute("href") == "#thm-deck"
    links["(D1)"].click()
    assert "A formula" in go(deck).inner_text()


def test_notes_are_for_the_speaker_alone(deck):
    notes = deck.locator("aside.notes")
    assert notes.count() == 1 and not notes.is_visible()
    assert "Welcome everybody" in deck.evaluate("Reveal.getSlideNotes()")


def test_speaker_sees_the_notes_and_the_next_slide(deck):
    with deck.expect_popup() as opened:
        go(deck, "s")
    window = opened.value
    notes = window.locator(".speaker-controls-notes .value")
    notes.filter(has_text="Welcome everybody").wait_for()
    assert notes.locator("svg").count() == 1 and notes.locator("math").count() == 0
    upcoming = window.frame_locator("#upcoming-slide iframe")
    upcoming.locator("section.present").first.wait_for()        # before, it misses what is sent
    go(deck, "ArrowRight")
    assert "A formula" in go(deck).inner_text()
    upcoming.locator(".fragment.visible").wait_for()            # what comes next on this slide
    upcoming.get_by_role("heading", name="A formula").wait_for()


def test_explorer_takes_the_keys_while_it_has_the_focus(deck):
    slide = go(deck, *["ArrowRight"] * 4)                   # one is for the fragment
    shown = Explorer(deck, 0)
    before, pixels = shown.status, shown.pictures()
    shown.handle("λ").press("ArrowRight")
    assert "λ = 1.01" in shown.status and "λ = 1.01" not in before
    assert shown.pictures() != pixels
    assert slide.locator(".ft-explorer").count() == 1       # and the deck has not moved
    assert slide.locator(".cell_input").count() == 0
    deck.keyboard.press("Escape")
    assert "42" in go(deck, "ArrowRight").inner_text()


def test_page_has_a_button_that_opens_the_deck(visit, address):
    page = visit(f"{address}/deck.html")
    assert page.locator("a.btn", has_text="Slides").get_attribute("href") == "deck-slides.html"
    plain = visit(f"{address}/index.html")
    assert plain.locator("a.btn", has_text="Slides").count() == 0


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_no_serious_barrier(visit, disk, audit, theme):
    page = visit(f"{disk}/deck-slides.html", color_scheme=theme)
    page.wait_for_function("window.Reveal && Reveal.isReady()")
    for _ in range(6):
        page.keyboard.press("Space")
        page.wait_for_timeout(500)              # fragments fade in
        assert audit(page) == []
