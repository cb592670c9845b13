"""The explorer of the cubic oscillator, section 2 of the paper, in units in which a = 1."""

from __future__ import annotations

import ipywidgets
import traitlets
from matplotlib.axes import Axes

from ..figures import cubic as figures
from ..problems import CubicOscillator
from ..solver import solve
from .base import Explorer, View, link, pack, picture

__all__ = ["CubicView", "cubic"]

END = 6.0   # of the time axis, as in js/cubic.js


class CubicView(View):
    """Potential, motion, difference and phase portrait for one λ, order and time."""

    scripts = ("elliptic.js", "cubic.js")
    lam = traitlets.Float(1.0).tag(sync=True)
    t = traitlets.Float(0.0).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)


def cubic(order: int = 12, lam: float = 1.0, stored: int = 60) -> Explorer:
    """Explore the cubic oscillator: λ from 0 past 3a, orders up to ``stored``.

    Parameters
    ----------
    order : int
        The order shown first.
    lam : float
        The λ/a shown first.
    stored : int
        The highest order that can be chosen.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> explorer = cubic(order=24, lam=0.5)
    >>> explorer.view.order, explorer.controls["λ"].value
    (24, 0.5)
    """
    solution = solve(CubicOscillator(a=1), order=stored)
    view = CubicView(data=pack(solution, "x", "omega"), order=order, lam=lam)
    controls = [
        link(ipywidgets.FloatSlider(description="λ", min=0, max=3.5, step=0.01), view, "lam"),
        link(ipywidgets.IntSlider(description="order", min=2, max=stored), view, "order"),
        link(ipywidgets.FloatSlider(description="t", min=0, max=END, step=0.01), view, "t"),
        link(ipywidgets.ToggleButton(description="Play"), view, "playing"),
    ]

    def draw(left: Axes, right: Axes) -> None:
        figures.potential(left, lam)
        figures.oscillation(right, solution.truncate(order), lam)

    return Explorer(controls, view, picture(draw, 2),
                    f"Left, the cubic potential with the energy at λ = {lam:g}; right, x(t) by the "
                    f"series of order {order} and exactly.")
