"""A small explorer of the generalized Mathieu equation: ψ in its potential, the bands, the edge."""

from __future__ import annotations

import ipywidgets
import numpy as np
import traitlets
from matplotlib.axes import Axes

from ..figures import mathieu as figures
from ..problems import GeneralizedMathieu
from ..references import mathieu as hill
from ..solver import solve
from .base import Explorer, View, link, pack, picture

__all__ = ["BandsView", "bands"]

LARGEST = 2.4   # of λ


class BandsView(View):
    """ψ on the level of its energy, and the bands over λ with a dot at the eigenvalue.

    Attributes
    ----------
    lam, mu : float
    playing : bool
        λ goes to and fro; switched on by the page until the reader takes a control.
    radius : float
        The radius of convergence in λ at this μ.
    bands : dict
        "lam": values of λ; "edges": the five lowest edges at each of them.
    """

    scripts = ("hill.js", "bands.js")
    lam = traitlets.Float(1.0).tag(sync=True)
    mu = traitlets.Float(0.0).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)
    radius = traitlets.Float(0.0).tag(sync=True)
    bands = traitlets.Dict().tag(sync=True)


def bands(order: int = 99, lam: float = 1.2, mu: float = -0.3, stored: int = 99) -> Explorer:
    """See ψ, the potential and the bands at one μ while λ moves; orders up to ``stored``.

    Parameters
    ----------
    order : int
        The order shown first.
    lam : float
        The λ shown first, up to 2.4.
    mu : float
        The strength of the second harmonic.
    stored : int
        The highest order that can be chosen.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> explorer = bands(order=20)
    >>> explorer.controls["order"].max, round(explorer.view.radius, 3)
    (99, 2.123)
    """
    solution = solve(GeneralizedMathieu(mu=mu), order=stored, arithmetic="float")
    lams = np.linspace(0, LARGEST, 97)
    edges = hill.band_edges(lams, mu).T
    view = BandsView(
        data=pack(solution, "psi", "a"), order=order, lam=lam, mu=mu,
        radius=float(solution.radius_of_convergence("a").value),
        bands={"lam": lams.tolist(), "edges": edges.round(4).tolist()})
    controls = [
        link(ipywidgets.FloatSlider(description="λ", max=LARGEST, step=0.01), view, "lam"),
        link(ipywidgets.IntSlider(description="order", min=2, max=stored), view, "order"),
        link(ipywidgets.ToggleButton(description="Play"), view, "playing"),
    ]

    def draw(left: Axes, right: Axes) -> None:
        figures.well(left, lam, mu)
        figures.bands(right, lams, edges, [(lam, float(hill.eigenvalue(lam, mu)))])

    return Explorer(controls, view, picture(draw, 2),
                    f"Left, the potential of (M1) at λ = {lam:g}, μ = {mu:g}, with ψ on the "
                    "level of its energy a; right, the bands of energy over λ, with the "
                    "eigenvalue on the upper edge of the lowest one.")
