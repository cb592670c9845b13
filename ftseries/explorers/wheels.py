"""A small explorer of the eight: rotating arrows, as long as power series in λ say, draw it."""

from __future__ import annotations

import ipywidgets
import numpy as np
import traitlets
from matplotlib.axes import Axes

from ..figure_eight import expanded
from ..figures import figure_eight as figures
from ..problems import FigureEight
from ..solver import solve
from .base import Explorer, View, link, pack, picture

__all__ = ["WheelsView", "wheels"]

LARGEST = 2.2   # of λ, as in js/wheels.js


class WheelsView(View):
    """The arrows of r_12 and of body 3, and their lengths over λ.

    Attributes
    ----------
    lam, t : float
    playing : bool
        The time goes on; switched on by the page until the reader takes a control.
    """

    scripts = ("wheels.js",)
    lam = traitlets.Float(2.076).tag(sync=True)
    t = traitlets.Float(0.4).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)


def wheels(lam: float = 2.076, order: int = 60) -> Explorer:
    """Watch rotating arrows draw the vector r_12 and the orbit of body 3, for λ up to 2.2.

    Parameters
    ----------
    lam : float
        The λ shown first.
    order : int
        Of the series.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> explorer = wheels(order=12)
    >>> explorer.view.data["x"]["rows"][0]                  # the arrow that does not turn
    [0, 0, 0, 0, 2, 7]
    """
    solution = expanded(solve(FigureEight(), order=order))
    view = WheelsView(data=pack(solution, "x", "y"), order=order, lam=lam)
    controls = [
        link(ipywidgets.FloatSlider(description="λ", max=LARGEST, step=0.001,
                                    readout_format=".3f"), view, "lam"),
        link(ipywidgets.ToggleButton(description="Play"), view, "playing"),
    ]

    def draw(*axes: Axes) -> None:
        figures.wheels(axes[0], solution, lam, view.t)
        figures.wheels(axes[1], solution, lam, view.t, body=True)
        figures.lengths(axes[2], solution, np.linspace(0, LARGEST, 89), lam)

    return Explorer(controls, view, picture(draw, 3),
                    f"Arrows one after the other at λ = {lam:g}: left, they lead from the origin "
                    "to a point of the arc on which the vector from body 2 to body 1 swings; in "
                    "the middle, to a point of the eight; right, their lengths over λ.")
