"""The explorer of the figure eight, section 4 of the paper: three bodies and their closing chain."""

import warnings

import ipywidgets
import numpy as np
import traitlets

from ..errors import ConvergenceWarning
from ..figures import figure_eight as figures
from ..problems import FigureEight
from ..problems.figure_eight import closure, closure_zero, positions
from ..references.newton import figure_eight_coefficients
from ..solver import solve
from .base import Explorer, View, link, pack, packed, picture

__all__ = ["FigureEightView", "figure_eight"]

RANGE = (0.0, 2.3)  # of λ, as in js/figure_eight.js


class FigureEightView(View):
    """Bodies, trails, the chain of relative vectors, and S_x(λ) with its zero.

    Attributes
    ----------
    lam, t : float
        The series parameter and the time; setting ``t`` stops the motion there.
    speed : float
        Units of t in a second.
    playing : bool
        Switched on by the page unless the reader prefers reduced motion.
    closing : bool
        Set to True, it moves λ to the zero λ_n of this order and falls back to False.
    clock : float
        The last value of ``t`` that the running motion reported.
    """

    scripts = ("figure_eight_scene.js", "figure_eight.js")
    lam = traitlets.Float(2.0).tag(sync=True)
    t = traitlets.Float(0.0).tag(sync=True)
    speed = traitlets.Float(1.0).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)
    closing = traitlets.Bool(False).tag(sync=True)
    clock = traitlets.Float(0.0).tag(sync=True)


def figure_eight(order=12, lam=1.7, t=0.6, stored=60):
    """Explore the figure eight: λ from 0 past the zero of S_x, orders up to ``stored``.

    The relative vectors are laid head to tail; where they close, and only there, the bodies of
    (E4a) obey Newton's equations.

    Parameters
    ----------
    order : int
        The order shown first.
    lam : float
        The λ shown first.
    t : float
        The time shown first, between 0 and 2π.
    stored : int
        The highest order that can be chosen.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> explorer = figure_eight(order=6, lam=2.0, stored=12)
    >>> explorer.view.order, explorer.controls["λ"].value, explorer.controls["order"].max
    (6, 2.0, 12)
    """
    solution = solve(FigureEight(), order=stored)
    view = FigureEightView(data=pack(solution, "r", "phi") | _orbit(stored), order=order, lam=lam,
                           t=t, clock=t)
    controls = [
        link(ipywidgets.FloatSlider(description="λ", min=RANGE[0], max=RANGE[1], step=0.001,
                                    readout_format=".3f"), view, "lam"),
        link(ipywidgets.IntSlider(description="order", min=2, max=stored), view, "order"),
        link(ipywidgets.FloatSlider(description="t", min=0, max=2 * np.pi, step=0.01), view, "t"),
        link(ipywidgets.FloatSlider(description="speed", min=0.1, max=3, step=0.1,
                                    readout_format=".1f"), view, "speed"),
        link(ipywidgets.ToggleButton(description="Play"), view, "playing"),
        link(ipywidgets.ToggleButton(description="Set λ = λₙ",
                                     tooltip="Closes the chain: λ becomes the zero of Sₓ"),
             view, "closing"),
    ]
    shown = solution.truncate(order)

    def draw(left, right):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ConvergenceWarning)
            _bodies(left, shown, lam)
            _closure(right, shown, lam)

    return Explorer(controls, view, picture(draw, 2),
                    f"Left, the three bodies at t = 0 on the orbit of order {order} at λ = {lam:g}, "
                    "and the three relative vectors head to tail, which leave a gap S; right, the "
                    "gap against λ, with its zero.")


def _orbit(order):
    """r_3 of Newton's equations, packed as two sine series "x" and "y" that do not depend on λ."""
    table = list(enumerate(figure_eight_coefficients()))
    return {name: packed({(1, n, 0): {0: part} for n, c in table if (part := getattr(c, attribute))},
                         order)
            for name, attribute in (("x", "real"), ("y", "imag"))}


def _bodies(ax, sol, lam):
    bodies, S = positions(sol, 0.0, lam), closure(sol, lam)
    orbit = positions(sol, np.linspace(0, 2 * np.pi, 241), lam)[0]
    ax.plot(orbit.real, orbit.imag, color=figures.GREY, lw=1)
    r_12, r_23, r_31 = bodies - np.roll(bodies, -1) + S / 3
    figures.head_to_tail(ax, [r_12, r_23, r_31], origin=-S / 2)
    for body, colour in zip(bodies, figures.COLOURS, strict=False):
        ax.plot(body.real, body.imag, "o", color=colour, ms=9)
    ax.set(xlabel="$x$", ylabel="$y$", aspect="equal")
    ax.margins(0.1)
    ax.legend()


def _closure(ax, sol, lam):
    values = np.linspace(*RANGE, 93)
    ax.plot(values, closure(sol, values), color=figures.BLUE)
    ax.axhline(0, color=figures.GREY, lw=0.8)
    zero = closure_zero(sol)
    ax.plot(zero, 0, "o", color=figures.GREEN, label=rf"zero, $\lambda$ = {zero:.5f}")
    ax.plot(lam, closure(sol, lam), "s", color=figures.VERMILION, label=rf"$\lambda$ = {lam:g}")
    ax.set(xlabel=r"$\lambda$", ylabel="$S_x$", xlim=RANGE)
    ax.legend()
