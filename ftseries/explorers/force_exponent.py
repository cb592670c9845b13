"""The explorer of the force exponent: how the eight deforms, and where it is stable."""

from __future__ import annotations

from functools import cache
from typing import Any

import ipywidgets
import numpy as np
import traitlets
from matplotlib.axes import Axes
from numpy.polynomial import chebyshev

from ..aliases import Array
from ..figures.style import BLUE, GREEN, GREY, VERMILION
from ..problems import PlanarEight
from ..solver import solve
from .base import Explorer, View, link, packed, picture

__all__ = ["ForceExponentView", "force_exponent"]

RANGE = (-0.5, 2.0)                          # of α, as in js/force_exponent.js
NODES = 25                                   # of the Chebyshev interpolation in α
SMALL = 1e-13                                # modes below it are left out


class ForceExponentView(View):
    """The eight at one exponent; ``data`` holds Chebyshev instead of Taylor coefficients.

    "x" and "y" are r_12 = x + iy, "lam" is λ, all as functions of α on ``RANGE``.
    """

    scripts = ("choreography.js", "force_exponent.js")
    alpha = traitlets.Float(1.0).tag(sync=True)
    t = traitlets.Float(0.0).tag(sync=True)


def force_exponent(alpha: float = 1.0, t: float = 0.6) -> Explorer:
    """Explore the eights of all forces d^{-(α+1)}: their shapes, λ, and rotation numbers.

    The page carries the orbits at 25 Chebyshev nodes and interpolates; it integrates the
    variational equations itself.

    Parameters
    ----------
    alpha : float
        The exponent shown first, between -1/2 and 2.
    t : float
        The time shown first, between 0 and 2π.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> explorer = force_exponent(alpha=0.5)
    >>> explorer.controls["α"].value, explorer.view.data["lam"]["order"]
    (0.5, 24)
    """
    tables = family()
    view = ForceExponentView(data={name: packed(table, NODES - 1)
                                   for name, table in tables.items()},
                             alpha=alpha, t=t, order=NODES - 1)
    controls = [
        link(ipywidgets.FloatSlider(description="α", min=RANGE[0], max=RANGE[1], step=0.01),
             view, "alpha"),
        link(ipywidgets.FloatSlider(description="t", min=0, max=2 * np.pi, step=0.01), view, "t"),
    ]

    def draw(left: Axes, right: Axes) -> None:
        period = np.linspace(0, 2 * np.pi, 361)
        left.plot(*plane(bodies(tables, 1.0, period)[0]), color=GREY, lw=1, ls="--",
                  label="gravitation")
        left.plot(*plane(bodies(tables, alpha, period)[0]), label=rf"$\alpha$ = {alpha:g}")
        for z, colour in zip(bodies(tables, alpha, t), (BLUE, VERMILION, GREEN), strict=True):
            left.plot(*plane(z), "o", color=colour)
        left.set(xlabel="$x$", ylabel="$y$", aspect="equal")
        left.legend(loc="lower right", fontsize=8)
        values = np.linspace(*RANGE, 101)
        right.plot(values, [at(tables["lam"], a)[0, 0] for a in values])
        right.plot(alpha, at(tables["lam"], alpha)[0, 0], "o")
        right.set(xlabel=r"$\alpha$", ylabel=r"$\lambda$")

    return Explorer(controls, view, picture(draw, 2),
                    f"Left, the eight of the force with exponent α = {alpha:g} and its bodies at "
                    f"t = {t:g}, with the eight of gravitation; right, λ over α.")


@cache
def family() -> dict[str, Any]:
    """``{name: {(sine, n, 0): {k: coefficient of the Chebyshev polynomial T_k}}}`` over ``RANGE``.

    Every node is refined from its neighbour, beginning with gravitation.
    """
    places = np.sort(chebyshev.chebpts1(NODES))
    exponents = np.round((RANGE[1] - RANGE[0]) / 2 * (places + 1) + RANGE[0], 12)
    start = solve(PlanarEight(), order=12).refine()
    orbits = {}
    for side in (exponents[exponents >= 1], exponents[exponents < 1][::-1]):
        orbit = start
        for alpha in side:
            orbits[alpha] = orbit = orbit.refine(PlanarEight(float(alpha)))
    rows: dict[Any, Any] = {name: {} for name in ("x", "y", "lam")}
    times = 2 * np.pi * np.arange(2048) / 2048
    for i, alpha in enumerate(exponents):
        orbit = orbits[alpha]
        problem: Any = orbit.problem
        phi = np.angle(problem.vector(orbit, times, orbit.lam))
        modes = {"lam": {(0, 0): 2 * np.mean(phi * np.cos(times))}, **orbit.coefficients}
        for name, found in modes.items():
            for mode, value in found.items():
                if abs(value) > SMALL:
                    rows[name].setdefault((*mode, 0), np.zeros(NODES))[i] = value
    matrix = np.linalg.inv(chebyshev.chebvander(places, NODES - 1))
    return {name: {mode: dict(enumerate(matrix @ row)) for mode, row in found.items()}
            for name, found in rows.items()}


def at(table: Any, alpha: float) -> dict[tuple[int, int], float]:
    """The interpolated amplitudes ``{(sine, n): number}`` at an exponent."""
    u = 2 * (alpha - RANGE[0]) / (RANGE[1] - RANGE[0]) - 1
    return {mode[:2]: float(chebyshev.chebval(u, list(row.values())))
            for mode, row in table.items()}


def bodies(tables: Any, alpha: float, t: Any) -> Any:
    """The three positions, complex of shape (3,) + t.shape."""
    amplitudes = {name: at(tables[name], alpha) for name in ("x", "y")}

    def vector(times: Array) -> Any:
        x, y = (sum(a * np.cos(n * times) for (_, n), a in amplitudes[name].items())
                for name in ("x", "y"))
        return x + 1j * y
    r_12, r_23, r_31 = (vector(np.asarray(t) + k * 2 * np.pi / 3) for k in (0, -1, 1))
    return np.stack([r_12 - r_31, r_23 - r_12, r_31 - r_23]) / 3


def plane(z: Any) -> tuple[Any, Any]:
    return z.real, z.imag
