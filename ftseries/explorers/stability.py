"""The explorer of Floquet's theory: the multipliers of (M1) on the unit circle and off it."""

from __future__ import annotations

import ipywidgets
import numpy as np
import traitlets
from matplotlib.axes import Axes

from .. import stability as floquet
from .base import Explorer, View, link, picture

__all__ = ["StabilityView", "stability"]

LOWEST, HIGHEST, LARGEST, WIDEST = -8.0, 12.0, 3.0, 0.5     # a, λ, |μ|, as in js/stability.js


class StabilityView(View):
    """Discriminant, multipliers and the odd solution for one a, λ, μ."""

    scripts = ("stability.js",)
    a = traitlets.Float(2.9).tag(sync=True)
    lam = traitlets.Float(2.0).tag(sync=True)
    mu = traitlets.Float(-0.3).tag(sync=True)


def stability(a: float = 2.9, lam: float = 2.0, mu: float = -0.3) -> Explorer:
    """Explore Hill's equation (M1): the multipliers as a moves through bands and gaps.

    Parameters
    ----------
    a : float
        The a shown first, between -8 and 12.
    lam, mu : float
        The parameters shown first, up to 3 and 1/2.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> explorer = stability(a=1.5)
    >>> explorer.controls["a"].value, explorer.view.lam
    (1.5, 2.0)
    """
    view = StabilityView(a=a, lam=lam, mu=mu)
    controls = [
        link(ipywidgets.FloatSlider(description="a", min=LOWEST, max=HIGHEST, step=0.01),
             view, "a"),
        link(ipywidgets.FloatSlider(description="λ", max=LARGEST, step=0.01), view, "lam"),
        link(ipywidgets.FloatSlider(description="μ", min=-WIDEST, max=WIDEST, step=0.01),
             view, "mu"),
    ]

    def draw(left: Axes, right: Axes) -> None:
        energies = np.linspace(LOWEST, HIGHEST, 81)
        left.plot(energies, [floquet.hill(e, lam, mu).discriminant for e in energies])
        for level in (-2, 2):
            left.axhline(level, linewidth=0.8)
        left.set(xlabel="$a$", ylabel="discriminant $D$", ylim=(-5, 5))
        turn = np.linspace(0, 2 * np.pi, 181)
        right.plot(np.cos(turn), np.sin(turn), linewidth=0.8)
        rho = floquet.hill(a, lam, mu).multipliers
        right.plot(rho.real, rho.imag, "o")
        right.set(xlabel="real part", ylabel="imaginary part", aspect="equal")

    return Explorer(controls, view, picture(draw, 2),
                    f"Left, the discriminant of (M1) against a at λ = {lam:g}, μ = {mu:g}; right, "
                    f"the two multipliers at a = {a:g} and the unit circle.")
