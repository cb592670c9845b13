"""The triangle of coefficients of any solution, order by order."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import ipywidgets
import numpy as np
import traitlets
from matplotlib.axes import Axes

from ..aliases import Mode
from ..errors import InputError
from ..problem import Scalar
from ..solution import Solution
from .base import Explorer, View, link, packed, picture

__all__ = ["CoefficientsView", "coefficients"]

LONGEST = 160       # characters of an exact number; longer ones lose their middle digits
SIGNS = {"**(1/3)": "^(1/3)", "**": "^", "*": " · ", "-": "−", "mu": "μ", "omega": "ω", "psi": "ψ",
         "phi": "φ"}


class CoefficientsView(View):
    """Cells (n, m): size and sign by colour, the exact number of the chosen one as text.

    ``texts`` maps "sine,n,m" to the exact number; ``alone`` lets the page start the growth, until
    the reader takes a control.
    """

    scripts = ("coefficients.js",)
    name = traitlets.Unicode().tag(sync=True)
    label = traitlets.Unicode().tag(sync=True)
    scalar = traitlets.Bool(False).tag(sync=True)
    texts = traitlets.Dict().tag(sync=True)
    alone = traitlets.Bool(False).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)


def coefficients(solution: Solution, name: str, order: int | None = None, alone: bool = False,
                 **parameters: float) -> Explorer:
    """Explore the coefficients A_{n,m} of one unknown of a solution as the order grows.

    Parameters
    ----------
    solution : Solution
    name : str
        An unknown of its problem.
    order : int, optional
        The order shown first; the solution's own by default.
    alone : bool
        Whether the triangle grows by itself until the reader takes a control.
    **parameters
        Values of the problem's free parameters, for the colours.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> import ftseries as fts
    >>> explorer = coefficients(fts.solve(fts.FigureEight(), order=6), "r")
    >>> explorer.view.texts["0,2,6"]                                                   # (E6b)
    '5 · ∛3/4096'
    """
    if not isinstance(solution, Solution):
        raise InputError(f"{solution!r} is not a solution; make one with ftseries.solve")
    table = solution.table(name, **parameters)
    scalar = isinstance(solution.problem.unknowns[name], Scalar)
    rows = {(*mode, 0): dict(enumerate(row)) for mode, row in table.items()}
    texts = {f"{sine},{n},{m}": _text(solution, name, scalar, sine, n, m)
             for (sine, n), row in table.items() for m in np.flatnonzero(row).tolist()}
    order = solution.order if order is None else order
    view = CoefficientsView(data={name: packed(rows, solution.order)}, name=name, label=_sign(name),
                            scalar=scalar, texts=texts, order=order, alone=alone)
    controls = [
        link(ipywidgets.IntSlider(description="order", min=0, max=solution.order), view, "order"),
        link(ipywidgets.ToggleButton(description="Grow"), view, "playing"),
    ]
    return Explorer(controls, view, picture(lambda ax: _draw(ax, table, solution.order)),
                    f"The coefficients of {name} to order {solution.order}: a triangle over Taylor "
                    "order m and Fourier order n, coloured by size.")


def _text(solution: Solution, name: str, scalar: bool, sine: int, n: int, m: int) -> str:
    orders = (m,) if scalar else (n, m)
    number = solution.coefficient(name, *orders, **({} if scalar else {"sine": bool(sine)}))
    return _short(_sign(repr(number) if isinstance(number, float) else str(number)))


def _sign(text: str) -> str:
    text = re.sub(r"\bsqrt\((\w+)\)", r"√\1", re.sub(r"\b3\*\*\(1/3\)", "∛3", text))
    for code, sign in SIGNS.items():
        text = text.replace(code, sign)
    return text


def _short(text: str) -> str:
    if len(text) <= LONGEST:
        return text
    half = LONGEST // 2
    return f"{text[:half]} … {text[-half:]} ({len(text)} characters)"


def _draw(axes: Axes, table: Mapping[Mode, Any], order: int) -> None:
    size = np.full((max(n for _, n in table) + 1, order + 1), np.nan)
    for (_, n), row in table.items():
        row, known = np.asarray(row), np.flatnonzero(row)
        size[n, known] = np.fmax(size[n, known], np.log10(np.abs(row[known])))
    image = axes.imshow(size, origin="lower", aspect="auto")
    axes.figure.colorbar(image, ax=axes, label=r"$\log_{10}$ of the size")
    axes.set(xlabel="Taylor order $m$", ylabel="Fourier order $n$")
