"""The explorer of convergence: poles of Padé approximants, the circle, the error by order."""

from __future__ import annotations

from typing import Any

import ipywidgets
import numpy as np
import traitlets
from matplotlib.axes import Axes

from .. import analysis
from ..errors import InputError
from ..problems import FigureEight
from ..problems.figure_eight import is_gravitational
from ..references import newton
from ..solution import Solution
from ..solver import solve
from .base import Explorer, View, link, picture

__all__ = ["ConvergenceView", "convergence"]

FIRST = 8                       # the lowest order shown
WINDOW = 9.0                    # half the width of the part of the plane that is shown


class ConvergenceView(View):
    """Poles and zeros in the plane of z = λ², and the closure at the true λ₀, by Taylor order."""

    scripts = ("convergence.js",)
    radius = traitlets.Float().tag(sync=True)
    physical = traitlets.Float().tag(sync=True)
    orders: traitlets.List[Any] = traitlets.List().tag(sync=True)
    poles: traitlets.List[Any] = traitlets.List().tag(sync=True)
    zeros: traitlets.List[Any] = traitlets.List().tag(sync=True)
    plain: traitlets.List[Any] = traitlets.List().tag(sync=True)
    resummed: traitlets.List[Any] = traitlets.List().tag(sync=True)


def convergence(sol: Solution, order: int = 40) -> Explorer:
    """Explore how the closure S(λ) of the eight converges, plain and by Padé approximants.

    Parameters
    ----------
    sol : Solution
        An exact solution of FigureEight, of order 24 at least; its order is the highest shown.
    order : int
        The Taylor order shown first.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> import ftseries as fts
    >>> explorer = convergence(fts.solve(fts.FigureEight(), order=40), order=24)
    >>> explorer.controls["order"].max, explorer.view.order
    (40, 24)
    """
    if (not isinstance(sol, Solution) or not is_gravitational(sol)
            or sol.arithmetic != "exact" or sol.order < 24):
        raise InputError(f"{sol!r}: give an exact solution of FigureEight, of order 24 or more")
    if order not in range(FIRST, sol.order + 1):
        raise InputError(f"order={order!r}: the explorer shows orders {FIRST} to {sol.order}")
    data = _by_order(sol)
    view = ConvergenceView(order=order - order % 2, **data)
    controls = [link(ipywidgets.IntSlider(description="order", min=FIRST, max=sol.order, step=2),
                     view, "order")]

    def draw(left: Axes, right: Axes) -> None:
        i = data["orders"].index(view.order)
        turn = np.linspace(0, 2 * np.pi, 181)
        left.plot(data["radius"] * np.cos(turn), data["radius"] * np.sin(turn), linewidth=0.8)
        for name, marker in (("poles", "x"), ("zeros", "o")):
            points = np.array(data[name][i]).reshape(-1, 2)
            left.plot(*points.T, marker, linestyle="none", fillstyle="none", label=name)
        left.set(xlim=(-WINDOW, WINDOW), ylim=(-WINDOW, WINDOW), aspect="equal",
                 xlabel=r"Re $\lambda^2$", ylabel=r"Im $\lambda^2$")
        right.semilogy(data["orders"], data["plain"], label="truncated")
        right.semilogy(data["orders"], data["resummed"], "--", label="Padé")
        right.axvline(view.order, linewidth=0.8)
        right.set(xlabel="Taylor order", ylabel=r"$|S(\lambda_0)|$")
        left.legend()
        right.legend()

    return Explorer(controls, view, picture(draw, 2),
                    f"Left, poles and zeros of the Padé approximant of S in the plane of λ² at "
                    f"order {view.order}, with the circle of convergence; right, the error of S at "
                    "the true λ by order, truncated and by Padé approximants.")


def _by_order(sol: Solution) -> Any:
    """All that the page shows, for every second order; S in units of S(0)."""
    _, _, c = sol.expand(sol.problem.condition)
    z = newton.figure_eight_lambda() ** 2
    numbers = np.array([float(int(x.p) / int(x.q)) for x in c])
    partial = np.abs(np.cumsum(numbers * z ** np.arange(len(numbers))))
    far = solve(FigureEight(), 200, arithmetic="float").expand(sol.problem.condition)[2]
    orders = list(range(FIRST, sol.order + 1, 2))
    approximants = [analysis.pade(c[:n // 2 + 1]) for n in orders]
    return {
        "radius": float(analysis.nearest_singularities(far)[0].radius.value),
        "physical": z, "orders": orders,
        "poles": [_inside(p.poles()) for p in approximants],
        "zeros": [_inside(p.zeros()) for p in approximants],
        "plain": [float(partial[n // 2]) for n in orders],
        "resummed": [float(abs(p(z))) for p in approximants],
    }


def _inside(points: Any) -> Any:
    return [[float(p.real), float(p.imag)] for p in points
            if max(abs(p.real), abs(p.imag)) <= WINDOW]
