"""A small explorer of the cubic oscillator: a particle, and the series that loses it at the rim."""

from __future__ import annotations

import ipywidgets
import traitlets
from matplotlib.axes import Axes

from ..figures import cubic as figures
from ..problems import CubicOscillator
from ..solver import solve
from .base import Explorer, View, link, pack, picture

__all__ = ["RollingView", "rolling"]

HIGHEST = 24    # order


class RollingView(View):
    """The particle in its well, exactly and by the series, and the frequency over λ.

    Attributes
    ----------
    lam : float
        Half the distance of the turning points, 3 at the separatrix.
    playing : bool
        Time runs; the page starts it and goes through some λ until the reader takes a control.
    """

    scripts = ("elliptic.js", "rolling.js")
    lam = traitlets.Float(0.5).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)


def rolling(lam: float = 0.5, order: int = 6) -> Explorer:
    """Let the particle roll in the cubic well, with λ up to the separatrix at 3.

    Parameters
    ----------
    lam : float
        The λ shown first, from 0.1 to 3.
    order : int
        Of the series, from 2 to 24.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> explorer = rolling(order=12)
    >>> explorer.controls["λ"].value, explorer.view.order
    (0.5, 12)
    """
    solution = solve(CubicOscillator(a=1), order=HIGHEST)
    view = RollingView(data=pack(solution, "x", "omega"), order=order, lam=lam)
    controls = [
        link(ipywidgets.FloatSlider(description="λ", min=0.1, max=3, step=0.01), view, "lam"),
        link(ipywidgets.IntSlider(description="order", min=2, max=HIGHEST, step=2), view, "order"),
        link(ipywidgets.ToggleButton(description="Play"), view, "playing"),
    ]

    def draw(left: Axes, right: Axes) -> None:
        figures.potential(left, lam)
        figures.frequency(right, solution, (order,))

    return Explorer(controls, view, picture(draw, 2),
                    f"Left, the well with the particle's energy at λ = {lam:g}; right, the "
                    f"frequency over λ, exactly and by the series of order {order}, which misses "
                    "the fall to zero at λ = 3.")
