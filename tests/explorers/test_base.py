"""What all explorers share, seen from Python: packing, links, fallback pictures, refusals."""

import json
import re
import shutil
from pathlib import Path

import anywidget
import ipywidgets
import pytest
from ipywidgets.embed import dependency_state

import ftseries as fts
from ftseries import explorers
from ftseries.explorers import base


def eight(order=12):
    return fts.solve(fts.FigureEight(), order=order)


MAKE = {
    "alive": lambda: explorers.alive(order=20),
    "secular": explorers.secular,
    "rolling": explorers.rolling,
    "cubic": lambda: explorers.cubic(stored=24),
    "mathieu": lambda: explorers.mathieu(stored=16),
    "figure_eight": lambda: explorers.figure_eight(stored=20),
    "force_exponent": explorers.force_exponent,
    "coefficients": lambda: explorers.coefficients(eight(), "r"),
    "convergence": lambda: explorers.convergence(eight(24), order=20),
    "stability": explorers.stability,
    "van_der_pol": explorers.van_der_pol,
    "bands": lambda: explorers.bands(stored=99),
    "closing": lambda: explorers.closing(order=30),
    "wheels": lambda: explorers.wheels(order=20),
}


@pytest.fixture(scope="module", params=sorted(MAKE))
def explorer(request):
    return MAKE[request.param]()


def test_every_explorer_is_made_here():
    assert sorted(MAKE) == sorted(explorers.__all__)


def test_controls_are_linked_in_the_browser(explorer):
    """One LinkModel for each control: the page needs no kernel."""
    state = dependency_state([explorer], drop_defaults=False)
    links = [model["state"] for model in state.values() if model["model_name"] == "LinkModel"]
    reference = f"IPY_MODEL_{explorer.view.model_id}"
    for name, control in explorer.controls.items():
        assert name == control.description != ""
        ends = [[link["source"], link["target"]] for link in links
                if link["source"][0] == f"IPY_MODEL_{control.model_id}"]
        assert [target[0] for _, target in ends] == [reference], name
        assert getattr(explorer.view, ends[0][1][1]) == control.value


def test_the_page_gets_one_module_and_no_address(explorer):
    script = explorer.view._esm
    assert not re.search(r"^(import|export (?!default))", script, re.MULTILINE)
    assert len(re.findall(r"^export default", script, re.MULTILINE)) == 1
    assert not re.search(r"https?:", script + explorer.view._css)


def test_the_module_is_javascript(run_javascript, explorer):
    assert run_javascript("output = 1;", None, *base.SHARED, *explorer.view.scripts) == 1


def test_every_script_is_a_module_of_its_own(run_javascript, tmp_path):
    """Its imports exist under their names."""
    scripts = Path(base.__file__).parent / "js"
    shutil.copytree(scripts, tmp_path, dirs_exist_ok=True)
    (tmp_path / "package.json").write_text('{"type": "module"}')
    found = run_javascript("""
        output = [];
        for (const url of input) output.push(Object.keys(await import(url)).length);
        """, [file.as_uri() for file in sorted(tmp_path.glob("*.js"))])
    assert len(found) >= 10 and all(found)


@pytest.mark.parametrize("axis, texts", [
    ({"range": [0, 6]}, ["0", "2", "4", "6"]),
    ({"range": [-0.5, 0.5]}, ["−0.4", "−0.2", "0.0", "0.2", "0.4"]),
    ({"range": [1e-16, 30], "log": True}, ["10⁻¹⁵", "10⁻¹⁰", "10⁻⁵", "10⁰"]),
])
def test_ticks_are_round(run_javascript, axis, texts):
    assert run_javascript("output = ticks(input, 4).map(({ text }) => text);", axis,
                          "axes.js") == texts


@pytest.mark.parametrize("value, text", [
    (0, "0"), (2.9e-8, "3e-8"), (0.0123, "0.01"), (-0.5, "−0.5"), (12345.0, "1e4"),
])
def test_short_numbers(run_javascript, value, text):
    assert run_javascript("output = short(input, 1);", value, "axes.js") == text


def test_a_picture_stands_in(explorer):
    data, metadata = explorer._repr_mimebundle_()
    assert metadata["image/png"]["alt"] == explorer.alt != ""
    assert data["image/png"].startswith("iVBORw0KGgo")
    assert not re.search(r"0x[0-9a-f]+", data["text/plain"])
    assert "application/vnd.jupyter.widget-view+json" in data
    assert explorer.picture() == explorer.picture()


def test_weight_of_a_page(explorer):
    """Everything a page carries for one explorer, in its file; 130 kB is a small picture."""
    state = dependency_state([explorer], drop_defaults=False)
    assert len(json.dumps(state)) < 130_000


def test_nan_coefficients_reach_the_page_as_valid_json():
    """JSON has no NaN: one in a trait would break every widget of the page."""
    packed = base.packed({(0, 0, 0): {0: float("nan")}}, 2)
    assert json.loads(json.dumps(packed, allow_nan=False)) == packed


def test_a_view_without_scripts_is_an_anywidget():
    assert issubclass(base.View, anywidget.AnyWidget)
    assert base.View(order=3).order == 3


@pytest.mark.parametrize("make, message", [
    (lambda: explorers.cubic(lam=4.0), r"λ = 4.0 is outside 0.0 … 3.5"),
    (lambda: explorers.cubic(lam=float("nan")), r"λ = nan is outside"),
    (lambda: explorers.cubic(order=1), r"order = 1 is outside 2 … 60"),
    (lambda: explorers.cubic(order=61), r"order = 61 is outside 2 … 60"),
    (lambda: explorers.cubic(order="12"), r"order"),
    (lambda: explorers.mathieu(mu=0.7), r"μ = 0.7 is outside -0.5 … 0.5"),
    (lambda: explorers.mathieu(lam="2"), r"lam"),
    (lambda: explorers.coefficients(eight(), "x"), r"'x' is not an unknown"),
    (lambda: explorers.coefficients(eight(), "r", order=13), r"order = 13 is outside 0 … 12"),
    (lambda: explorers.coefficients(eight(), "r", mu=1), r"needs no parameters"),
    (lambda: explorers.coefficients(None, "r"), r"None is not a solution"),
    (lambda: base.pack(3, "x"), r"3 is not a solution"),
    (lambda: base.pack(eight(), "x"), r"'x' is not an unknown"),
])
def test_refusals(make, message):
    with pytest.raises(fts.FTSeriesError, match=message):
        make()


def test_link_ties_a_control():
    view = base.View(order=3)
    slider = base.link(ipywidgets.IntSlider(description="order", max=9), view, "order")
    assert slider.value == 3
