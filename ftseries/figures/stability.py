"""Pictures of the chapter on stability.

`sol` is a solution of `GeneralizedMathieu` with symbolic μ, `m` the monodromy of the figure eight
from `ftseries.stability.bodies`; motions are integrated by SciPy with the accelerations of
`ftseries.references.three_bodies`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from scipy.integrate import solve_ivp

from .. import stability
from ..aliases import Array, Real
from ..arguments import labelled
from ..references import mathieu, three_bodies
from . import mathieu as waves
from .style import BLUE, COLOURS, GREEN, GREY, LINES, PURPLE, VERMILION

if TYPE_CHECKING:
    from ..solution import Solution

__all__ = ["discriminant", "crossing", "largest_differences", "growth", "on_edge", "multipliers",
           "follow", "disturbed"]


def discriminant(ax: Axes, lam: float, mu: float, span: tuple[float, float], edges: Any) -> None:
    """D(a) over `span`; `edges` = {name: a} in ascending order, bands between 1st and 2nd, …"""
    a = np.linspace(*span, 121)
    ax.plot(a, [stability.hill(value, lam, mu).discriminant for value in a], color=BLUE,
            linestyle="-")
    for level in (-2, 2):
        ax.axhline(level, color=GREY, linestyle=LINES[1], linewidth=0.8)
    values = list(edges.values())
    for i, (low, high) in enumerate(zip(values[::2], [*values[1::2], span[1]])):
        ax.axvspan(low, high, color=GREEN, alpha=0.25, linewidth=0, label="_" * (i > 0) + "band")
    for i, (name, value) in enumerate(edges.items()):
        level = 2 * np.sign(stability.hill(value, lam, mu).discriminant)
        ax.plot([value], [level], "o", color=VERMILION, markersize=6)
        ax.annotate(f"${name}$", (value, level), xytext=(10 * (-1) ** (i + 1), 6 * level / 2),
                    textcoords="offset points", horizontalalignment="center",
                    verticalalignment="center")
    ax.set(xlabel="$a$", ylabel="discriminant $D$", xlim=span, ylim=(-4, 4))
    ax.legend(loc="lower center")


def crossing(ax: Axes, sol: Solution, lam: float, mu: float, orders: Sequence[int]) -> None:
    """The same at the edge b_1, enlarged: D + 2 at the eigenvalues of truncations of `sol`."""
    edge = mathieu.eigenvalue(lam, mu)
    values = np.array([sol.truncate(n).evaluate("a", lam=lam, mu=mu) - edge for n in orders])
    reach = 1.25 * abs(values).max() * np.array([-1, 1])
    ax.axhspan(0, -100 * reach[0], color=GREEN, alpha=0.15, linewidth=0)
    slope = stability.hill(edge, lam, mu).discriminant_slope
    ax.plot(reach, slope * reach, color=GREY, linestyle=LINES[1], label="tangent")
    for n, value, colour, mark in zip(orders, values, (BLUE, GREEN, PURPLE, VERMILION), "ovs^"):
        ax.plot([value], [stability.hill(edge + value, lam, mu).discriminant + 2], mark,
                color=colour, markersize=8, label=f"order {n}")
    ax.axhline(0, color=GREY, linestyle="-", linewidth=0.8)
    ax.set(xlabel="$a$ of the series $-\\ a$ exact", ylabel="$D + 2$", xlim=reach,
           ylim=1.1 * abs(slope) * reach)
    ax.legend()


def largest_differences(sol: Solution, lam: float, mu: float, periods: int) -> Real:
    """max |δψ| over each period of 2π: series minus the integration with the series' own a.

    >>> import ftseries as fts
    >>> sol = fts.solve(fts.GeneralizedMathieu(), order=40)
    >>> largest_differences(sol, 1, -0.3, 3).shape
    (3,)
    """
    x = np.linspace(0, 2 * np.pi * periods, 120 * periods + 1)
    delta = sol.evaluate("psi", x, lam=lam, mu=mu) - waves.numerical(sol, x, lam, mu)
    return abs(delta[1:]).reshape(periods, 120).max(axis=1)


def growth(ax: Axes, sol: Solution, lam: float, mu: float, orders: Sequence[int],
           periods: int = 40) -> None:
    """|δψ| over many periods with the law predicted from the discriminant, one pair for each order.

    Points are the largest |δψ| of each period, near its last maximum of |ψ| at 3π/2, and the law
    is taken there.
    """
    k = np.arange(1, periods + 1)
    size = abs(sol.evaluate("psi", np.linspace(0, np.pi, 200), lam=lam, mu=mu)).max()
    for n, colour, mark in zip(orders, COLOURS, "os"):
        part = sol.truncate(n)
        at = stability.hill(part.evaluate("a", lam=lam, mu=mu), lam, mu, 2 * np.pi)
        dense = np.linspace(0.75, periods, 40 * periods)
        ax.plot(dense, size * at.departure(dense - 0.25), color=colour, linestyle=LINES[1],
                linewidth=1.2, label=f"law, order {n} ({at.place})")
        ax.plot(k, largest_differences(part, lam, mu, periods), mark, color=colour, markersize=4.5,
                label=rf"$\delta\psi$, order {n}")
    ax.set(xlabel=r"periods of $2\pi$", ylabel=r"largest $|\delta\psi|$ of a period", yscale="log",
           xlim=(0, periods + 0.5), ylim=(1e-3, None))
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, fontsize=9)


def on_edge(ax: Axes, quadratic: Any, linear: Any, quadratic_law: Any, linear_law: Any) -> None:
    """Departures after 1, 2, … periods, log-log: wrong in the 30th digit of a, or of ψ(0)."""
    k = np.arange(1, len(quadratic) + 1)
    for values, law, colour, mark, name in (
            (quadratic, quadratic_law, VERMILION, "o", "$a$ rounded to 30 digits"),
            (linear, linear_law, BLUE, "s", r"$\psi(0) = 10^{-30}$, $a$ exact")):
        ax.plot(k, law, color=colour, linestyle=LINES[1], linewidth=1.2)
        ax.plot(k, values, mark, color=colour, markersize=4.5, label=name)
    ax.set(xlabel=r"periods of $2\pi$", ylabel="departure from the periodic solution",
           xscale="log", yscale="log")
    ax.legend()


def multipliers(left: Axes, right: Axes, m: Any) -> None:
    """The twelve multipliers on the unit circle, and what is near 1 enlarged."""
    turn = np.exp(2j * np.pi * np.linspace(0, 1, 721))
    essential = np.linalg.eigvals(m.essential)
    for ax in (left, right):
        ax.plot(turn.real, turn.imag, color=GREY, linestyle="-", linewidth=0.8)
        ax.plot(essential.real, essential.imag, "o", color=BLUE, markersize=8,
                label="four that nothing forces")
        ax.plot([1], [0], "s", color=VERMILION, markersize=8, label="1, eightfold")
        ax.set(xlabel="real part", aspect="equal")
    left.set(ylabel="imaginary part", xlim=(-1.2, 1.2), ylim=(-1.2, 1.2))
    near = 1.3 * abs(essential.imag).min()
    right.set(xlim=(1 - 1.6 * near, 1 + 0.4 * near), ylim=(-near, near))
    right.locator_params("x", nbins=3)
    left.legend(loc="center", fontsize=9)


def follow(start: Any, disturbance: Any, period: float, periods: int,
           tolerance: float = 1e-11) -> Any:
    """The distance from the undisturbed state after 0, 1, …, `periods` periods.

    `start` (positions and velocities, complex, shape (2, 3)) repeats itself after `period`;
    `disturbance` has the real coordinates of `ftseries.stability.Bodies`.

    >>> from ftseries.references import newton
    >>> bool(follow(newton.figure_eight_state(), np.zeros(12), 2 * np.pi, 2).max() < 1e-7)
    True
    """
    def slope(_: float, y: Array) -> Array:
        return np.concatenate([y[3:], three_bodies.accelerations(y[:3])])

    begin = np.asarray(start).ravel()
    times = period * np.arange(periods + 1)
    path = solve_ivp(slope, (0, times[-1]), begin + np.asarray(disturbance, float).view(complex),
                     "DOP853", t_eval=times, rtol=tolerance, atol=tolerance / 10)
    return np.sqrt((abs(path.y - begin[:, None]) ** 2).sum(axis=0))


def disturbed(ax: Axes, distances: Mapping[str, Array],
              predicted: Mapping[str, Array]) -> None:
    """Distance over the first disturbance against periods, one line for each entry of a dict.

    `predicted` has the same names: the linear law, drawn dashed.
    """
    distances = labelled("distances", distances)
    for (name, values), colour, mark in zip(distances.items(), COLOURS, "os^v"):
        k = np.arange(len(values))
        ax.plot(k, values / values[0], mark, color=colour, markersize=3.5, label=name)
        ax.plot(k, predicted[name] / predicted[name][0], color=colour, linestyle=LINES[1],
                linewidth=1)
    ax.set(xlabel="periods", ylabel="distance over first distance", yscale="log")
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, fontsize=9)
