"""The explorer of the figure eight, section 4 of the paper: three bodies and their chain."""

from __future__ import annotations

import warnings
from typing import Any

import ipywidgets
import numpy as np
import traitlets
from matplotlib.axes import Axes

from ..errors import ConvergenceWarning, InputError
from ..figures.style import BLUE, BODIES, GREEN, GREY, PURPLE
from ..problems import FigureEight
from ..problems.figure_eight import closure, closure_zero, positions, relative
from ..references import newton
from ..solver import solve
from .base import Explorer, View, link, pack, packed, picture

__all__ = ["FigureEightView", "figure_eight"]

RANGE = (0.0, 2.3)  # of λ, as in js/figure_eight.js
PERIOD = np.linspace(0, 2 * np.pi, 241)


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

    scripts = ("figure_eight_scene.js", "eight.js", "figure_eight.js")
    lam = traitlets.Float(2.0).tag(sync=True)
    t = traitlets.Float(0.0).tag(sync=True)
    speed = traitlets.Float(1.0).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)
    closing = traitlets.Bool(False).tag(sync=True)
    clock = traitlets.Float(0.0).tag(sync=True)


def figure_eight(order: int = 12, lam: float = 1.7, t: float = 0.6, stored: int = 60) -> Explorer:
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

    Raises
    ------
    InputError
        ``order``, ``lam`` or ``t`` lies outside its slider.

    Examples
    --------
    >>> explorer = figure_eight(order=6, lam=2.0, stored=12)
    >>> explorer.view.order, explorer.controls["λ"].value, explorer.controls["order"].max
    (6, 2.0, 12)
    """
    for name, value, low, high in (("order", order, 2, stored), ("lam", lam, *RANGE),
                                   ("t", t, 0, 2 * np.pi)):
        if not low <= value <= high:
            raise InputError(f"{name}={value!r}: give a number from {low} to {high:g}")
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

    def draw(left: Axes, right: Axes) -> None:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ConvergenceWarning)
            _bodies(left, shown, lam, t)
            _closure(right, shown, lam)

    return Explorer(controls, view, picture(draw, 2),
                    f"Left, the three bodies at t = {t:g} on the orbit of order {order} at "
                    f"λ = {lam:g}, and the three relative vectors head to tail, which leave a gap "
                    "S; right, the gap against λ, with its zero.")


def _orbit(order: int) -> Any:
    """r_3 of Newton's equations, packed as sine series "x" and "y" that do not depend on λ."""
    parts = {"x": newton.figure_eight_coefficients().real,
             "y": newton.figure_eight_coefficients().imag}
    return {name: packed({(1, n, 0): {0: c} for n, c in enumerate(part)}, order)
            for name, part in parts.items()}


def _bodies(ax: Axes, sol: Any, lam: float, t: float) -> None:
    """The bodies on their orbit; r_23, r_12, r_31 head to tail, the gap centred on body 3."""
    bodies, (r_12, r_23, r_31) = positions(sol, t, lam), relative(sol, t, lam)
    S = r_12 + r_23 + r_31
    corners = bodies[2] - S / 2 + np.cumsum([0, r_23, r_12, r_31])
    truth, orbit = newton.figure_eight(PERIOD)[2], positions(sol, PERIOD, lam)[0]
    ax.plot(truth.real, truth.imag, color=GREY, lw=1, ls="--", label="Newton’s orbit")
    ax.plot(orbit.real, orbit.imag, color=GREY, lw=0.8, ls="-")
    ax.plot(corners[[0, 3]].real, corners[[0, 3]].imag, color=PURPLE, lw=8, ls="-",
            alpha=0.45, label="gap $S$")
    links = ((0, BODIES[1], "$r_{23}$"), (1, BODIES[0], "$r_{12}$"), (2, BODIES[2], "$r_{31}$"))
    for k, colour, name in links:
        start, end = corners[k:k + 2]
        ax.annotate("", (end.real, end.imag), (start.real, start.imag), arrowprops={
            "arrowstyle": "-|>", "color": colour, "lw": 1.8, "shrinkA": 0, "shrinkB": 0})
        place, inside = 0.65 * start + 0.35 * end, np.delete(corners, [k, k + 1]).mean()
        normal = 1j * (end - start) / abs(end - start)
        away = 13 * normal * np.sign(((place - inside) * normal.conjugate()).real)
        ax.annotate(name, (place.real, place.imag), (away.real, away.imag),
                    textcoords="offset points", ha="center", va="center")
    for number, (body, colour) in enumerate(zip(bodies, BODIES, strict=True), 1):
        ax.plot(body.real, body.imag, "o", color=colour, ms=13)
        ax.annotate(str(number), (body.real, body.imag), ha="center", va="center", color="white",
                    size=9, weight="bold")
    half = 0.15 + max(abs(corners.real).max(), 1.0)
    ax.set(xlabel="$x$", ylabel="$y$", aspect="equal", xlim=(-half, half))
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, fontsize=8, handlelength=2)


def _closure(ax: Axes, sol: Any, lam: float) -> None:
    values = np.linspace(*RANGE, 93)
    ax.plot(values, closure(sol, values), color=BLUE, ls="-")
    ax.axhline(0, color=GREY, lw=0.8, ls="-")
    zero = closure_zero(sol)
    ax.plot(zero, 0, "o", color=GREEN, label=rf"zero, $\lambda$ = {zero:.5f}")
    ax.plot(lam, closure(sol, lam), "s", color=PURPLE, label=rf"$\lambda$ = {lam:g}")
    ax.set(xlabel=r"$\lambda$", ylabel="$S_x$", xlim=RANGE)
    ax.legend()
