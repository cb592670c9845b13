"""A small explorer of the hard spring: a secular term against the Fourier-Taylor series."""

from __future__ import annotations

import warnings
from typing import Any

import ipywidgets
import numpy as np
import traitlets
from matplotlib.axes import Axes
from scipy.special import ellipj

from ..aliases import Function
from ..errors import ConvergenceWarning
from ..figures.style import BLUE, GREY, VERMILION
from ..problem import Field, Problem, Scalar
from ..solver import solve
from .base import Explorer, View, link, pack, picture

__all__ = ["HardSpring", "SecularView", "exact", "secular", "taylor"]

END = 60.0      # of the time axis, as in js/secular.js
LARGEST = 0.9   # of λ; the series of ω has the radius 1


class HardSpring(Problem):
    """The energy law of x'' + x + x³ = 0, in which λ is the largest displacement."""

    unknowns = {"x": Field("cos", modes="odd", powers="odd"), "omega": Scalar("even")}
    seed = {"x": [{}, {1: 1}], "omega": [1]}
    frequency = "omega"

    def equations(  # type: ignore[override]     # the unknowns by name
            self, lam: Function, x: Function, omega: Function) -> dict[str, Function]:
        """ω² x'² = (λ² - x²) (1 + (λ² + x²)/2)."""
        return {"energy": omega**2 * x.diff()**2
                - (lam**2 - x**2) * (1 + (lam**2 + x**2) / 2)}


def taylor(t: Any, lam: float) -> Any:
    """The plain Taylor series in λ to the order 3, with its secular term -3/8 λ³ t sin t.

    >>> float(taylor(0.0, 0.5))
    0.5
    """
    return (lam * np.cos(t) - 3 / 8 * lam**3 * t * np.sin(t)
            + lam**3 * (np.cos(3 * t) - np.cos(t)) / 32)


def exact(t: Any, lam: float) -> Any:
    """λ cn(√(1 + λ²) t | m) with m = λ²/(2 + 2λ²).

    >>> float(exact(0.0, 0.5))
    0.5
    """
    return lam * ellipj(np.sqrt(1 + lam**2) * t, lam**2 / (2 + 2 * lam**2))[1]


class SecularView(View):
    """x(t) exactly, by the Taylor and by the Fourier-Taylor series, for one λ.

    Attributes
    ----------
    lam : float
        The largest displacement.
    playing : bool
        A pen draws the curves; switched on by the page until the reader takes a control.
    """

    scripts = ("elliptic.js", "secular.js")
    lam = traitlets.Float(0.5).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)


def secular(lam: float = 0.5, order: int = 3) -> Explorer:
    """Compare the Taylor series of order 3 with the Fourier-Taylor series, over ten periods.

    Parameters
    ----------
    lam : float
        The largest displacement shown first, up to 0.9.
    order : int
        Of the Fourier-Taylor series.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> explorer = secular(lam=0.3)
    >>> explorer.controls["λ"].value, explorer.view.order
    (0.3, 3)
    """
    solution = solve(HardSpring(), order=order)
    view = SecularView(data=pack(solution, "x", "omega"), order=order, lam=lam)
    controls = [
        link(ipywidgets.FloatSlider(description="λ", max=LARGEST, step=0.01), view, "lam"),
        link(ipywidgets.ToggleButton(description="Play"), view, "playing"),
    ]

    def draw(ax: Axes) -> None:
        t = np.linspace(0, END, 1201)
        ax.plot(t, exact(t, lam), color=GREY, ls="-", lw=4, alpha=0.5, label="exact")
        ax.plot(t, taylor(t, lam), color=VERMILION, ls="-", lw=1.4, label="Taylor")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ConvergenceWarning)      # both series are cut
            values = solution.evaluate("x", t, lam=lam)
        ax.plot(t, values, color=BLUE, ls="--", lw=1.6, label="Fourier-Taylor")
        ax.set(xlabel="$t$", ylabel="$x(t)$", ylim=(-2.2 * lam, 2.2 * lam))
        ax.legend(ncols=3, loc="lower center", bbox_to_anchor=(0.5, 1.0))

    return Explorer(controls, view, picture(draw),
                    f"An oscillation of amplitude {lam:g} over ten periods. The Taylor series of "
                    "order 3 swings ever wider and leaves the picture; the Fourier-Taylor series "
                    "of the same order stays on the exact curve.")
