"""The eight alive: three bodies on their orbit, with nothing to set. For the front page."""

from __future__ import annotations

import ipywidgets
import numpy as np
import traitlets
from matplotlib.axes import Axes

from ..figures.style import BODIES, GREY
from ..problems import FigureEight
from ..problems.figure_eight import closure_zero, positions
from ..solver import solve
from .base import Explorer, View, link, pack, picture

__all__ = ["AliveView", "alive"]


class AliveView(View):
    """Three bodies and their trails on a lying eight, at the λ of the true motion.

    Attributes
    ----------
    lam : float
    playing : bool
        Switched on by the page, unless the reader prefers reduced motion.
    """

    scripts = ("figure_eight_scene.js", "eight.js", "alive.js")
    lam = traitlets.Float(2.0).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)


def alive(order: int = 100) -> Explorer:
    """Three bodies that chase one another along the eight, by the series of an order.

    Parameters
    ----------
    order : int
        Of the series, in floating-point arithmetic.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> round(alive(order=30).view.lam, 6)
    2.076071
    """
    solution = solve(FigureEight(), order=order, arithmetic="float")
    lam = closure_zero(solution)
    view = AliveView(data=pack(solution, "r", "phi"), order=order, lam=lam)
    controls = [link(ipywidgets.ToggleButton(description="Play"), view, "playing")]

    def draw(ax: Axes) -> None:
        orbit = 1j * positions(solution, np.linspace(0, 2 * np.pi, 241), lam)[0]
        ax.plot(orbit.real, orbit.imag, color=GREY, lw=1.2, ls="-")
        for body, colour in zip(1j * positions(solution, 0.6, lam), BODIES, strict=True):
            ax.plot(body.real, body.imag, "o", color=colour, ms=15)
        ax.set(aspect="equal")
        ax.margins(0.05, 0.15)
        ax.axis("off")

    return Explorer(controls, view, picture(draw),
                    "Three equal bodies chase one another along one closed curve, an eight.")
