"""The explorer of the generalized Mathieu equation, section 3 of the paper."""

from __future__ import annotations

import warnings
from typing import Any

import ipywidgets
import numpy as np
import traitlets
from matplotlib.axes import Axes

from ..errors import ConvergenceWarning, FTSeriesError
from ..figures import mathieu as figures
from ..figures.style import GREY
from ..problems import GeneralizedMathieu
from ..references import mathieu as hill
from ..solver import solve
from .base import Explorer, View, link, pack, picture

__all__ = ["MathieuView", "mathieu", "region"]

WIDEST = 0.5    # |μ|, as in js/mathieu.js


class MathieuView(View):
    """Eigenvalue, map of (λ, μ), solution and difference for one λ, μ and order.

    ``region`` holds lists "mu" and "radius": the radius of convergence in λ at some μ.
    """

    scripts = ("hill.js", "mathieu.js")
    lam = traitlets.Float(2.0).tag(sync=True)
    mu = traitlets.Float(-0.3).tag(sync=True)
    region = traitlets.Dict().tag(sync=True)


def mathieu(order: int = 12, lam: float = 2.0, mu: float = -0.3, stored: int = 99) -> Explorer:
    """Explore the lowest odd solution of (M1): λ up to 3, |μ| up to 1/2, orders up to ``stored``.

    Parameters
    ----------
    order : int
        The order shown first.
    lam, mu : float
        The parameters shown first.
    stored : int
        The highest order that can be chosen.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> explorer = mathieu(order=20, mu=0.1)
    >>> explorer.controls["μ"].value, explorer.view.lam
    (0.1, 2.0)
    """
    solution = solve(GeneralizedMathieu(), order=stored)
    view = MathieuView(data=pack(solution, "psi", "a"), region=region(), order=order,
                       lam=lam, mu=mu)
    controls = [
        link(ipywidgets.FloatSlider(description="λ", max=3, step=0.01), view, "lam"),
        link(ipywidgets.FloatSlider(description="μ", min=-WIDEST, max=WIDEST, step=0.01),
             view, "mu"),
        link(ipywidgets.IntSlider(description="order", min=2, max=stored), view, "order"),
    ]

    def draw(left: Axes, right: Axes) -> None:
        x = np.linspace(0, 2 * np.pi, 181)
        exact, series = hill.eigenfunction(x, lam, mu), solution.truncate(order)
        figures.potential(left, [(lam, mu)])
        right.plot(x, exact, color=GREY, linewidth=5, alpha=0.5, label="Hill matrix")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ConvergenceWarning)
            values = series.evaluate("psi", x, lam=lam, mu=mu)
        right.plot(x, values, label=f"series of order {order}")
        right.set(xlabel="$x$", ylabel=r"$\psi(x)$")
        right.legend()

    return Explorer(controls, view, picture(draw, 2),
                    f"Left, the potential of (M1) at λ = {lam:g}, μ = {mu:g}; right, ψ(x) by the "
                    f"series of order {order} and by the Hill matrix.")


def region(points: int = 21, order: int = 99) -> Any:
    """The radius of convergence in λ of the eigenvalue for some μ: ``{"mu": […], "radius": […]}``.

    Examples
    --------
    >>> region(points=3)["mu"]
    [-0.5, 0.0, 0.5]
    >>> round(region(points=3)["radius"][1], 3)     # √(2 · 3.76995749), DLMF table 28.6.1
    2.746
    """
    found: dict[str, list[float]] = {"mu": [], "radius": []}
    for mu in np.linspace(-WIDEST, WIDEST, points).round(6).tolist():
        solution = solve(GeneralizedMathieu(mu=mu), order=order, arithmetic="float")
        try:
            radius = solution.radius_of_convergence("a").value
        except FTSeriesError:       # a value of μ without a clear radius: the line passes over it
            continue
        found["mu"].append(mu)
        found["radius"].append(round(float(radius), 4))
    return found
