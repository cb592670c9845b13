"""A small explorer of the eight: three arrows head to tail, which the reader closes by λ."""

from __future__ import annotations

import ipywidgets
import traitlets
from matplotlib.axes import Axes

from ..figures import figure_eight as figures
from ..problems import FigureEight
from ..problems.figure_eight import closure_zero, relative
from ..solver import solve
from .base import Explorer, View, link, pack, picture

__all__ = ["ClosingView", "closing"]

LARGEST = 2.2   # of λ, as in js/closing.js


class ClosingView(View):
    """The chain of relative vectors, with a handle on its open end.

    Attributes
    ----------
    lam, t : float
    playing : bool
        The time goes on; switched on by the page until the reader takes a control.
    """

    scripts = ("figure_eight_scene.js", "eight.js", "closing.js")
    lam = traitlets.Float(1.4).tag(sync=True)
    t = traitlets.Float(0.5).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)


def closing(lam: float = 1.4, order: int = 100) -> Explorer:
    """Close the chain r_23, r_12, r_31 by dragging its open end, or the slider of λ.

    Parameters
    ----------
    lam : float
        The λ shown first, up to 2.2.
    order : int
        Of the series, in floating-point arithmetic.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> explorer = closing(order=30)
    >>> explorer.controls["λ"].value, explorer.view.order
    (1.4, 30)
    """
    solution = solve(FigureEight(), order=order, arithmetic="float")
    view = ClosingView(data=pack(solution, "r", "phi"), order=order, lam=lam)
    controls = [
        link(ipywidgets.FloatSlider(description="λ", max=LARGEST, step=0.001,
                                    readout_format=".3f"), view, "lam"),
        link(ipywidgets.ToggleButton(description="Play"), view, "playing"),
    ]

    def draw(*axes: Axes) -> None:
        for ax, value in zip(axes, (lam, 1.8, closure_zero(solution)), strict=True):
            figures.head_to_tail(ax, relative(solution, view.t, value), rf"$\lambda={value:.3f}$")

    return Explorer(controls, view, picture(draw, 3),
                    "The three relative vectors head to tail, for three values of λ. The end of "
                    "the last misses the start of the first by a horizontal gap, which shrinks "
                    "from left to right; the third chain is a closed triangle.")
