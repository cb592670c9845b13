r"""What all explorers share: packed series, the view that evaluates them, controls, picture.

An explorer is a *layout* (:class:`Explorer`, an ipywidgets box) of *controls* (ipywidgets) and
one *view* (:class:`View`, an anywidget).  Controls and view are linked in the browser, so that they
work with and without a kernel.  The view carries the coefficients of a solution and evaluates

.. math::  u(t; λ) = \sum_n A_n(λ) \cos nωt + B_n(λ) \sin nωt, \qquad A_n(λ) = \sum_m A_{n,m} λ^m,

in JavaScript (``js/series.js``), as :mod:`ftseries.evaluation` does in Python.

How to write one::

    class CubicView(View):
        scripts = ("cubic.js",)                 # after the shared ones; see js/view.js
        lam = traitlets.Float(1.0).tag(sync=True)

    view = CubicView(data=pack(sol, "x", "omega"), order=24)
    slider = link(FloatSlider(description="λ", min=0, max=3), view, "lam")
    Explorer([slider], view, picture=figure_function, alt="What the picture shows")

Packed format, one entry of ``view.data`` for each unknown, decoded by ``Series`` in js/series.js::

    {"order": highest Taylor order,
     "rows": [[sine, n, k, m, step, count], …],
     "values": base64 of the little-endian float64 numbers of all rows, one after the other}

A row holds the coefficients of λ^m, λ^(m+step), … (``count`` of them) of cos nωt or sin nωt, times
the power k of the problem's parameter (0 where it has none).  Floats are exact to the last bit, and
NaN survives: the page says what is wrong instead of failing to load.
"""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Callable, Mapping, Sequence
from functools import reduce
from importlib import resources
from math import gcd
from typing import Any

import anywidget
import ipywidgets
import numpy as np
import traitlets
from matplotlib.figure import Figure

from ..aliases import Json
from ..conversion import float_unit, to_float
from ..errors import InputError
from ..figures import style
from ..solution import Solution

__all__ = ["Explorer", "View", "bundle", "link", "pack", "packed", "picture"]

SHARED = ("series.js", "axes.js", "plot.js", "view.js")
_IMPORT = re.compile(r"^import [^;]*;\n", re.MULTILINE)
_EXPORT = re.compile(r"^export (?!default)", re.MULTILINE)
_COMMENT = re.compile(r"^ *//.*\n", re.MULTILINE)


def bundle(*names: str) -> str:
    """The scripts ``js/<name>`` as one module: a widget's module cannot import its neighbours.

    Each script is a module of its own, for editors; here its imports and comments are dropped, and
    its exports but the default one become plain names.
    """
    folder = resources.files(__package__) / "js"
    texts = [(folder / name).read_text(encoding="utf-8") for name in names]
    return "\n".join(_EXPORT.sub("", _IMPORT.sub("", _COMMENT.sub("", text))) for text in texts)


class View(anywidget.AnyWidget):
    """The part of an explorer that draws; subclasses name their scripts and add traits.

    Attributes
    ----------
    data : dict
        Packed series, by unknown; see :func:`pack`.
    order : int
        The Taylor order at which all series are cut.
    scripts : tuple of str
        Files in ``js/``; the last one has ``export default {render: …}``.
    """

    scripts: tuple[str, ...] = ()
    data = traitlets.Dict().tag(sync=True)
    order = traitlets.Int(0).tag(sync=True)

    def __init_subclass__(cls, **kwargs: Any) -> None:
        if "scripts" in cls.__dict__:
            cls._esm = bundle(*SHARED, *cls.scripts)
            cls._css = (resources.files(__package__) / "js" / "explorers.css").read_text("utf-8")
        super().__init_subclass__(**kwargs)

    def __init__(self, **traits: Any) -> None:
        try:
            super().__init__(**traits)
        except traitlets.TraitError as error:
            raise InputError(str(error)) from None


class Explorer(ipywidgets.VBox):  # type: ignore[misc]     # ipywidgets has no types
    """Controls above a view, with a picture for where no JavaScript runs, such as print.

    Parameters
    ----------
    controls : list of ipywidgets.Widget
        Already linked; see :func:`link`.
    view : View
    picture : function
        Returns the bytes of a PNG file (see the function of this name); called when the explorer
        is displayed.
    alt : str
        What the picture shows, in words.
    """

    def __init__(self, controls: Sequence[Any], view: View, picture: Callable[[], bytes],
                 alt: str) -> None:
        self.view, self.picture, self.alt = view, picture, alt
        self.controls = {control.description: control for control in controls}
        row = ipywidgets.Box(controls)
        row.add_class("ft-controls")
        super().__init__([row, view])
        self.add_class("ft-explorer")

    def __repr__(self) -> str:
        return f"Explorer. {self.alt}"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        bundle = super()._repr_mimebundle_(**kwargs)
        bundle["text/plain"] = repr(self)
        bundle["image/png"] = base64.b64encode(self.picture()).decode()
        return bundle, {"image/png": {"alt": self.alt}}


def picture(draw: Callable[..., None], panels: int = 1) -> Callable[[], bytes]:
    """A function that draws ``panels`` axes side by side in the book's style, as a PNG file.

    Examples
    --------
    >>> picture(lambda axes: axes.plot([0, 1]))()[:4]
    b'\\x89PNG'
    """
    def png() -> bytes:
        file = io.BytesIO()
        with style.context():
            figure = Figure(figsize=(2 + 3.6 * panels, 3.6), layout="constrained")
            draw(*figure.subplots(1, panels, squeeze=False)[0])
            figure.savefig(file, format="png", dpi=120, metadata={"Software": None})
        return file.getvalue()
    return png


def link(control: Any, view: View, trait: str) -> Any:
    """Give ``control`` the value of the view's trait and tie both in the browser.

    Raises
    ------
    InputError
        The value is beyond the control's range.
    """
    control.value = value = getattr(view, trait)
    if control.value != value:
        raise InputError(f"{control.description} = {value!r} is outside {control.min} … "
                         f"{control.max}; choose a value in this range")
    control.tooltip = control.description       # without it, pages show the word "null"
    ipywidgets.jslink((control, "value"), (view, trait))
    return control


def pack(solution: Solution, *names: str) -> dict[str, Json]:
    """``{name: packed series}`` of a solution's unknowns, for ``View.data``.

    Examples
    --------
    >>> import ftseries as fts
    >>> pack(fts.solve(fts.GeneralizedMathieu(), order=6), "a")["a"]["rows"]
    [[0, 0, 0, 0, 2, 4], [0, 0, 1, 6, 1, 1]]
    """
    if not isinstance(solution, Solution):
        raise InputError(f"{solution!r} is not a solution; make one with ftseries.solve")
    return {name: packed(_table(solution, name), solution.order) for name in names}


def packed(table: Mapping[tuple[int, int, int], Mapping[int, float]], order: int) -> Json:
    """A table ``{(sine, n, k): {m: coefficient of λ^m}}`` in the packed format."""
    rows, values = [], []
    for (sine, n, k), row in sorted(table.items()):
        powers = sorted(m for m, value in row.items() if value != 0)
        if not powers:
            continue
        step = reduce(gcd, (m - powers[0] for m in powers)) or 1
        filled = range(powers[0], powers[-1] + 1, step)
        rows.append([sine, n, k, powers[0], step, len(filled)])
        values += [row.get(m, 0.0) for m in filled]
    data = np.array(values, dtype="<f8").tobytes()
    return {"order": order, "rows": rows, "values": base64.b64encode(data).decode()}


def _table(solution: Solution, name: str) -> dict[tuple[int, int, int], dict[int, float]]:
    """``{(sine, n, k): {m: float}}``: the coefficients of λ^m μ^k cos nωt, in the paper's units."""
    if len(solution.problem.parameters) > 1:
        raise InputError(f"{solution.problem!r} has several parameters; give all but one a value")
    if not solution.problem.parameters:
        return {(*mode, 0): dict(enumerate(row)) for mode, row in solution.table(name).items()}
    table: dict[tuple[int, int, int], dict[int, float]] = {}
    for m, row in enumerate(solution.coefficients[name]):
        unit = float_unit(solution.problem, solution.problem.unit(name, m))
        for mode, polynomial in row.items():
            for (_, k), number in polynomial.to_dict().items():
                table.setdefault((*mode, int(k)), {})[m] = unit * to_float(number)
    return table
