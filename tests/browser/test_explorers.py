"""Explorers in the built page, without a kernel: they render, controls work, numbers agree."""

import importlib
import re

import numpy as np
import pytest
from browser.pages import NAMES, Explorer

import ftseries as fts
from ftseries.references import cubic, mathieu
from ftseries.references.floquet import ROTATION_NUMBERS
from ftseries.references.van_der_pol import LimitCycle

pytestmark = pytest.mark.filterwarnings("ignore::ftseries.ConvergenceWarning")

CASES = 6           # random states of each explorer
TOLERANCE = 1e-10   # what the page promises; it shows 13 digits


def test_every_explorer_renders(visit, address):
    page = visit(f"{address}/explorers.html")
    explorers = [Explorer(page, number) for number in range(len(NAMES))]
    assert page.locator(".ft-explorer").count() == len(NAMES)
    assert page.locator(".ft-error").count() == 0
    for explorer in explorers:
        assert re.search("=|order|orbit", explorer.status)
        assert all(len(picture) > 2000 for picture in explorer.pictures())     # not blank
    assert page.locator("mjx-container").count() > 0                        # formulas beside them


@pytest.mark.parametrize("name, control, key, trace", [
    ("cubic", "λ", "ArrowRight", "λ = 1.01"), ("cubic", "order", "ArrowRight", "order 13"),
    ("cubic", "order", "ArrowLeft", "order 11"), ("cubic", "λ", "Home", "λ = 0.00"),
    ("mathieu", "λ", "ArrowLeft", "λ = 1.99"), ("mathieu", "μ", "ArrowRight", "μ = −0.29"),
    ("mathieu", "order", "End", "order 99"),
    ("figure_eight", "λ", "Home", "λ = 0.000"), ("figure_eight", "order", "ArrowRight", "order 13"),
    ("coefficients", "order", "ArrowLeft", "order 23"),
    ("bands", "λ", "End", "λ = 2.40"), ("bands", "order", "ArrowLeft", "order 98"),
    ("secular", "λ", "ArrowRight", "λ = 0.51"), ("rolling", "λ", "End", "stays on the top"),
    ("rolling", "order", "ArrowRight", "order 8"),
    ("closing", "λ", "Home", "λ = 0.000"), ("wheels", "λ", "Home", "λ = 0.000"),
    ("van_der_pol", "ε", "ArrowRight", "ε = 2.05"),
    ("van_der_pol", "order", "ArrowRight", "order 32"),
    ("force_exponent", "α", "ArrowRight", "α = 1.01"), ("force_exponent", "α", "Home", "α = −0.50"),
])
def test_sliders_change_state_and_picture(explorer, name, control, key, trace):
    shown = explorer(name)
    before, pixels = shown.status, shown.pictures()
    shown.handle(control).press(key)
    assert trace in shown.status and trace not in before
    assert not pixels or shown.pictures() != pixels


def test_screen_readers_hear_the_shown_value(explorer):
    """noUiSlider alone would say 1.0 and 1.0099999999999998."""
    shown = explorer("cubic")
    handle = shown.handle("λ")
    handle.press("ArrowRight")
    shown.settle()
    assert handle.get_attribute("aria-valuenow") == handle.get_attribute("aria-valuetext") == "1.01"


def test_sliders_can_be_dragged(visit, address):
    """By mouse, over http and from the disk."""
    shown = Explorer(visit(f"{address}/explorers.html"), NAMES.index("cubic"))
    before = shown.value("λ")
    box = shown.handle("λ").bounding_box()
    middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    shown.page.mouse.move(*middle)
    shown.page.mouse.down()
    shown.page.mouse.move(middle[0] + 60, middle[1], steps=4)
    shown.page.mouse.up()
    assert shown.value("λ") > before
    assert f"λ = {shown.value('λ'):.2f}" in shown.status


def test_time_slider_moves_the_particle(explorer):
    shown = explorer("cubic")
    pixels = shown.pictures()
    shown.handle("t").press("PageUp")
    t = shown.value("t")
    assert t > 0 and f"x({t:.2f}), series" in shown.readings
    assert shown.pictures() != pixels


def test_play_and_pause(explorer):
    """The button says what it does: Play becomes Pause, and needs no other sign."""
    shown = explorer("cubic")
    shown.button("Play").click()
    shown.until(lambda: shown.value("t") > 0.1)
    assert shown.button("Play").count() == 0
    assert shown.button("Pause").get_attribute("aria-pressed") is None
    shown.button("Pause").click()
    shown.settle()
    assert shown.button("Play").count() == 1
    stopped = shown.value("t")
    shown.page.wait_for_timeout(400)
    assert shown.value("t") == stopped


def test_grow_fills_the_triangle(explorer):
    shown = explorer("coefficients")
    shown.handle("order").press("Home")
    assert "to order 0: 1 coefficient" in shown.status
    shown.button("Grow").click()
    shown.page.wait_for_function("order => order.getAttribute('aria-valuenow') >= 2",
                                 arg=shown.handle("order").element_handle())


def test_map_takes_lambda_and_mu(explorer):
    shown = explorer("mathieu")
    picture = shown.box.get_by_role("img", name="Map over λ and μ")
    box = picture.bounding_box()
    picture.click(position={"x": 0.5 * box["width"], "y": 0.3 * box["height"]})
    assert 0.9 < shown.value("λ") < 2 and 0 < shown.value("μ") < 0.5
    assert f"λ = {shown.value('λ'):.2f}, μ = {shown.value('μ'):.2f}" in shown.status


def test_the_button_of_the_eight_closes_the_chain(explorer):
    shown = explorer("figure_eight")
    shown.button("Set λ = λₙ").click()
    zero = fts.figure_eight.closure_zero(fts.solve(fts.FigureEight(), order=12))
    shown.until(lambda: abs(shown.number("Sₓ")) < TOLERANCE)            # λ glides
    assert abs(shown.number("λ₁₂") - zero) < TOLERANCE
    assert f"λ = {zero:.3f}" in shown.status


@pytest.mark.parametrize("name, moving", [("bands", "λ"), ("closing", None), ("wheels", None)])
def test_a_small_explorer_plays_until_it_is_touched(explorer, name, moving):
    shown = explorer(name)
    pixels, before = shown.pictures(), shown.value("λ")
    shown.until(lambda: shown.pictures() != pixels)
    assert (shown.value("λ") != before) == bool(moving) and shown.button("Pause").count() == 1
    shown.handle("λ").press("ArrowLeft")
    shown.settle()
    still = shown.pictures()
    shown.page.wait_for_timeout(500)
    assert shown.pictures() == still and shown.button("Play").count() == 1
    shown.button("Play").click()
    shown.until(lambda: shown.pictures() != still)


@pytest.mark.parametrize("name", ["bands", "closing", "wheels"])
def test_a_small_explorer_rests_for_those_who_ask_for_it(explorer, name):
    shown = explorer(name, reduced_motion="reduce")
    pixels = shown.pictures()
    shown.page.wait_for_timeout(800)
    assert shown.pictures() == pixels and shown.button("Play").count() == 1
    shown.button("Play").click()
    shown.until(lambda: shown.pictures() != pixels)


@pytest.mark.parametrize("name", ["secular", "rolling"])
def test_the_first_explorers_play_until_they_are_touched(explorer, name):
    shown = explorer(name)
    pixels = shown.pictures()
    shown.until(lambda: shown.pictures() != pixels)
    assert shown.button("Pause").count() == 1
    shown.handle("λ").press("ArrowRight")
    shown.settle()
    still = shown.pictures()
    shown.page.wait_for_timeout(500)
    assert shown.pictures() == still and shown.button("Play").count() == 1


@pytest.mark.parametrize("name", ["alive", "secular", "rolling"])
def test_the_first_explorers_rest_for_those_who_ask_for_it(explorer, name):
    shown = explorer(name, reduced_motion="reduce")
    pixels = shown.pictures()
    shown.page.wait_for_timeout(800)
    assert shown.pictures() == pixels
    shown.button("Play").click()
    shown.until(lambda: shown.pictures() != pixels)
    shown.button("Pause").click()
    shown.settle()
    still = shown.pictures()
    shown.page.wait_for_timeout(500)
    assert name == "secular" or shown.pictures() == still       # the pen shows the whole at once


def test_the_triangle_grows_alone_until_a_place_is_touched(explorer):
    shown = explorer("growing")
    shown.until(lambda: "to order 5" in shown.status)
    shown.box.get_by_role("gridcell").first.click()
    stopped = shown.value("order")
    shown.page.wait_for_timeout(1500)
    assert shown.value("order") == stopped
    resting = explorer("growing", reduced_motion="reduce")
    assert "to order 11" in resting.status


def test_the_secular_term_leaves_and_the_other_series_stays(explorer):
    """Against SciPy's integrator and SymPy's coefficients, by way of ftseries.explorers.secular."""
    module = importlib.import_module("ftseries.explorers.secular")
    sol = fts.solve(module.HardSpring(), order=3)
    shown = explorer("secular", reduced_motion="reduce")
    for lam in (0.2, 0.5, 0.83):
        shown.type("λ", lam)
        assert abs(shown.number("x(60), exact") - module.exact(60, lam)) < TOLERANCE
        assert abs(shown.number("x(60), Taylor") - module.taylor(60, lam)) < TOLERANCE
        series = sol.evaluate("x", 60, lam=lam)
        assert abs(shown.number("x(60), Fourier-Taylor") - series) < TOLERANCE


def test_the_series_loses_the_particle_near_the_top(explorer):
    shown = explorer("rolling", reduced_motion="reduce")
    sol = fts.solve(fts.CubicOscillator(), order=24)
    assert "the series holds" in shown.status
    shown.type("λ", 2.8)
    assert "runs ahead" in shown.status
    assert abs(shown.number("ω, exact") - cubic.frequency(2.8)) < TOLERANCE
    series = sol.truncate(6).evaluate("omega", lam=2.8)
    assert abs(shown.number("ω, series") - series) < TOLERANCE
    shown.type("λ", 2)
    shown.type("order", 24)
    assert "the series holds" in shown.status


def test_the_open_end_is_dragged_until_the_chain_closes(explorer):
    """The end follows the mouse, and is caught where the other end is."""
    shown = explorer("closing", reduced_motion="reduce")
    assert "stays open" in shown.status
    box = shown.box.get_by_role("img").bounding_box()
    middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    shown.page.mouse.move(middle[0] + 60, middle[1])
    shown.page.mouse.down()
    shown.settle()
    half_open = shown.value("λ")
    shown.page.mouse.move(middle[0] + 3, middle[1], steps=4)
    shown.page.mouse.up()
    zero = fts.figure_eight.closure_zero(fts.solve(fts.FigureEight(), 100, "float"))
    assert 1.4 < half_open < zero and "the chain closes" in shown.status
    assert shown.value("λ") == round(zero, 3)


def test_the_arrow_that_does_not_turn_is_gone_where_the_chain_closes(explorer):
    shown = explorer("wheels", reduced_motion="reduce")
    assert "λ = 2.076" in shown.status and "it is gone" in shown.status
    shown.type("λ", 1)
    assert "a third of the gap" in shown.status


def test_the_dot_leaves_the_edge_where_the_order_does_not_suffice(explorer):
    shown = explorer("bands", reduced_motion="reduce")
    shown.type("λ", 2)
    assert "on the edge of the band" in shown.status
    shown.type("order", 9)
    assert "this order is not enough" in shown.status
    shown.type("λ", 2.4)
    shown.type("order", 99)
    assert "no order helps" in shown.status


def test_past_the_radius_the_wave_of_mathieu_is_not_drawn_as_walls(explorer):
    """At λ = 3 order 99 the sum is 1e9 times too large: no curve, and the state says why."""
    shown = explorer("mathieu")
    shown.type("order", 99)
    shown.type("λ", 3)
    assert "outside the radius" in shown.status
    columns = shown.box.locator("canvas").nth(2).evaluate("""canvas => {
      const { width, height } = canvas;
      const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
      let most = 0;
      for (let x = 0; x < width; x++) {
        let blue = 0;
        for (let y = 0; y < height; y++) {
          const [r, g, b] = data.slice(4 * (x + width * y), 4 * (x + width * y) + 3);
          if (r < 40 && g > 80 && b > 140) blue++;
        }
        most = Math.max(most, blue / height);
      }
      return most;
    }""")
    assert columns == 0


def states(*ranges):
    random = np.random.default_rng(11)
    return [[round(float(random.uniform(*ends)), 2) for ends in ranges]
            + [int(random.integers(2, 61))] for _ in range(CASES)]


def test_cubic_agrees_with_python(explorer):
    solution = fts.solve(fts.CubicOscillator(a=1), order=60)
    shown = explorer("cubic")
    for lam, t, order in states((0, 3), (0, 6)):
        for name, value in (("λ", lam), ("t", t), ("order", order)):
            shown.type(name, value)
        cut = solution.truncate(order)
        w, x = cut.evaluate("omega", lam=lam), cut.evaluate("x", t, lam=lam)
        assert abs(shown.number("ω, series") - w) < TOLERANCE
        assert abs(shown.number(f"x({t:.2f}), series") - x) < TOLERANCE
        assert abs(shown.number("ω, exact") - cubic.frequency(lam)) < TOLERANCE
        assert abs(shown.number(f"x({t:.2f}), exact") - cubic.position(t, lam)) < TOLERANCE
        assert shown.status.startswith(f"order {order}, λ = {lam:.2f}, largest error")


def test_mathieu_agrees_with_python(explorer):
    solution = fts.solve(fts.GeneralizedMathieu(), order=60)
    shown = explorer("mathieu")
    for lam, mu, order in states((0.1, 2.5), (-0.5, 0.5)):
        for name, value in (("λ", lam), ("μ", mu), ("order", order)):
            shown.type(name, value)
        cut = solution.truncate(order)
        a, psi = cut.evaluate("a", lam=lam, mu=mu), cut.evaluate("psi", np.pi / 2, lam=lam, mu=mu)
        assert abs(shown.number("a, series") - a) < TOLERANCE * max(1, abs(a))
        assert abs(shown.number("ψ(π/2), series") - psi) < TOLERANCE * max(1, abs(psi))
        assert abs(shown.number("a, Hill matrix") - mathieu.eigenvalue(lam, mu)) < TOLERANCE
        exact = mathieu.eigenfunction(np.pi / 2, lam, mu)
        assert abs(shown.number("ψ(π/2), Hill matrix") - exact) < TOLERANCE


def test_eight_agrees_with_python(explorer):
    solution = fts.solve(fts.FigureEight(), order=60)
    shown = explorer("figure_eight", reduced_motion="reduce")
    for lam, t, order in states((0, 2.3), (0, 6)):
        order += order % 2
        for name, value in (("λ", lam), ("t", t), ("order", order)):
            shown.type(name, value)
        cut = solution.truncate(order)
        assert abs(shown.number("Sₓ") - fts.figure_eight.closure(cut, lam)) < TOLERANCE
        readings = shown.readings
        bodies = fts.figure_eight.positions(cut, t, lam)
        for number, body in zip("₁₂₃", bodies, strict=True):
            text = readings[f"r{number}"].replace("−", "-").replace(" ", "").replace("i", "j")
            assert abs(complex(text) - body) < 1e-3


def test_van_der_pol_agrees_with_python(explorer):
    """Inside the radius and beyond it: integrated, by the series and by Padé."""
    module = importlib.import_module("ftseries.explorers.van_der_pol")
    solution, shown = module.solution(65), explorer("van_der_pol")
    for eps, order in ((0.5, 8), (1.8, 32), (3, 24), (7.25, 16), (10, 8)):
        shown.type("ε", eps)
        shown.type("order", order)
        plain = solution.truncate(2 * order + 1).evaluate("omega", lam=eps**0.5)
        better, _, _ = module.resum(module.approximants(solution, order), eps)
        exact = LimitCycle(eps).omega
        assert abs(shown.number("ω, integrated") - exact) < TOLERANCE
        assert abs(shown.number("ω, series") - plain) < TOLERANCE * max(1, abs(plain))
        assert abs(shown.number("ω, Padé") - better) < TOLERANCE
        assert shown.readings["radius, |ε²|"] == "3.4202"
        assert ("inside" if eps < 1.85 else "beyond") in shown.status


def test_pade_can_be_switched_off(explorer):
    """Beyond the radius the reader is told why the series fails."""
    shown = explorer("van_der_pol")
    assert "by Padé" in shown.status and shown.note == ""
    pixels = shown.pictures()
    shown.button("Padé").click()
    assert "by Padé" not in shown.status and "switch Padé on" in shown.note
    assert shown.readings["ω, Padé"] == "off" and shown.pictures() != pixels
    shown.type("ε", 1)
    assert shown.note == ""


def test_the_frequency_takes_epsilon(explorer):
    shown = explorer("van_der_pol")
    picture = shown.box.get_by_role("img", name="The frequency over ε, with")
    box = picture.bounding_box()
    picture.click(position={"x": 0.55 * box["width"], "y": 0.5 * box["height"]})
    assert 4 < shown.value("ε") < 6 and f"ε = {shown.value('ε'):.2f}" in shown.status


def test_force_exponent_agrees_with_python(explorer):
    """λ by Newton's method, the rotation numbers of gravitation as published."""
    shown = explorer("force_exponent")
    for nu, value in zip(("ν₁", "ν₂"), ROTATION_NUMBERS, strict=True):
        assert abs(shown.number(nu) - value) < 1e-7
    orbit = fts.solve(fts.FigureEight(), order=12).refine()
    for alpha, stable in (("0.9", True), ("0.5", False), ("0", False), ("-0.4", True)):
        orbit = orbit.refine(fts.FigureEight(alpha))
        shown.type("α", alpha)
        assert abs(shown.number("λ") - orbit.lam) < 1e-9
        assert ("linearly stable" in shown.status) == stable
        assert (shown.readings["ν₁"] == "none") != stable
    shown.type("α", 5)
    assert "α = 5 is outside -0.5 … 2; 2 is shown." in shown.note


def test_triangle_shows_the_exact_numbers(explorer):
    solution = fts.solve(fts.FigureEight(), order=24)
    shown = explorer("coefficients")
    cells = shown.box.get_by_role("gridcell")
    assert cells.count() == sum(np.count_nonzero(row) for row in solution.table("r").values())
    cell = shown.box.get_by_role("gridcell", name="r, n = 2, m = 6: 5 · ∛3/4096")    # (E6b)
    cell.hover()
    detail = shown.box.locator(".ft-detail")
    assert detail.inner_text() == "r2, 6 = 5 · ∛3/4096 ≈ 0.00176056"
    cells.last.focus()
    assert "≈" in detail.inner_text() and "r2, 6" not in detail.inner_text()


@pytest.mark.parametrize("control, typed, said, value", [
    ("λ", "9", "λ = 9 is outside 0 … 3.5; 3.5 is shown.", 3.5),
    ("λ", "-1", "λ = -1 is outside 0 … 3.5; 0 is shown.", 0),
    ("order", "400", "order = 400 is outside 2 … 60; 60 is shown.", 60),
    ("λ", "much", "“much” is not a number; λ stays as it was.", 1),
    ("λ", "0.5", "", 0.5),
])
def test_typed_values_are_clamped_and_said(explorer, control, typed, said, value):
    shown = explorer("cubic")
    shown.type(control, typed)
    assert said in shown.note and bool(said) == bool(shown.note.split("Past")[0])
    assert shown.value(control) == value


def test_past_the_separatrix_the_reader_is_told(explorer):
    shown = explorer("cubic")
    shown.type("λ", 3.2)
    assert "escapes" in shown.note and "no periodic solution" in shown.status
    shown.type("λ", 3)
    assert "escapes" not in shown.note and "largest error" in shown.status


def test_what_cannot_be_shown_says_so_in_its_place(visit, disk):
    page = visit(f"{disk}/faults.html")
    page.locator(".ft-status:not(:empty)").last.wait_for()
    errors = page.locator(".ft-explorer").evaluate_all(
        "all => all.map(box => box.querySelector('.ft-error')?.textContent ?? "
        "box.querySelector('.ft-note').textContent)")
    assert errors == [
        "This explorer cannot be shown. The coefficients of x contain NaN or infinite numbers.",
        "This explorer cannot be shown. The series of x is empty: there is nothing to show.",
        "Order 40 is not stored; order 10 is shown.",
        "λ = 7 is outside 0 … 3.5; 3.5 is shown. " + errors[3].partition("shown. ")[2],
        "This explorer cannot be shown. The coefficients of phi contain NaN or infinite numbers.",
        "This explorer cannot be shown. The coefficients of r contain NaN or infinite numbers.",
        "This explorer cannot be shown. The series of psi is empty: there is nothing to show.",
        "This explorer cannot be shown. The Padé approximants are missing.",
        "",
    ]
    well = Explorer(page, 8)                    # the rest of the page lives on
    well.handle("λ").press("ArrowRight")
    assert "λ = 1.01" in well.status


def test_pages_without_widgets_load_no_widget_code(visit, address):
    page = visit(f"{address}/index.html")
    page.locator("mjx-container").first.wait_for()
    asked = page.watched.asked
    assert any("mathjax" in url for url in asked)
    widget_code = ("require", "html-manager", "anywidget")
    assert not [url for url in asked if any(name in url for name in widget_code)]


def test_without_javascript_a_picture_stands_in(visit, disk):
    page = visit(f"{disk}/explorers.html", java_script_enabled=False)
    pictures = page.locator("noscript img")
    assert pictures.count() == len(NAMES)
    for number in range(len(NAMES)):
        assert pictures.nth(number).get_attribute("alt").startswith("Explorer. ")
        pictures.nth(number).scroll_into_view_if_needed()
        assert pictures.nth(number).evaluate("image => image.naturalWidth") > 400
