"""Pictures of the chapter on the figure eight: orbits, closure, zeros, distances.

Points of the plane are complex numbers x + iy; positions have the shape (3,) + t.shape, as
:func:`ftseries.figure_eight.positions` and :func:`ftseries.references.newton.figure_eight` give
them.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection

from ..aliases import Array, ArrayLike, ComplexArray
from ..arguments import labelled
from ..errors import ConvergenceWarning
from ..problems import figure_eight as eight
from .style import BLUE, COLOURS, GREEN, GREY, LINES, VERMILION

if TYPE_CHECKING:
    from ..solution import Solution

__all__ = ["choreography", "orbits", "closure", "zeros", "distance", "head_to_tail", "drift",
           "convergence", "emblem"]

PERIOD = np.linspace(0, 2 * np.pi, 1201)


def choreography(ax: Axes, positions: Callable[[Any], ComplexArray]) -> None:
    """The eight lying, as in the paper's first figure, with the bodies at t = 0 and t = 2π/12.

    ``positions`` is a function of time that gives the three upright positions.
    """
    _orbit(ax, _lying(positions, PERIOD)[2], color=GREY, lw=1.2)
    for t, prime, line in ((0, "", LINES[1]), (np.pi / 6, "'", LINES[2])):
        bodies = _lying(positions, t)
        _orbit(ax, bodies[[0, 1, 2, 0]], color=BLUE if prime else VERMILION, ls=line)
        for number, (z, colour) in enumerate(zip(bodies, COLOURS, strict=False), 1):
            ax.plot(z.real, z.imag, "o", color=colour, ms=9, mfc="none" if prime else colour)
            away = 16 * (z / abs(z) if abs(z) > 1e-6 else 1j)
            ax.annotate(f"${number}{prime}$", (z.real, z.imag), (away.real, away.imag),
                        textcoords="offset points", ha="center", va="center")
    ax.margins(0.1, 0.25)
    _plane(ax, "$y$", "$-x$")


def orbits(ax: Axes, curves: Mapping[str, ComplexArray]) -> None:
    """Upright orbits on top of one another; ``curves`` maps labels to closed curves."""
    for (label, z), colour, line in zip(labelled("curves", curves).items(),
                                        (BLUE, VERMILION, GREEN), LINES, strict=False):
        _orbit(ax, np.append(z, z[0]), color=colour, ls=line, label=label)
    _plane(ax, "$x$", "$y$")
    ax.set_xticks([-0.3, 0, 0.3])
    ax.legend(loc="center left", bbox_to_anchor=(1, 0.5))


def closure(ax: Axes, sol: Solution, orders: Sequence[int], lam: Array) -> None:
    """S_x(λ) at the values ``lam`` for ``sol`` cut at several orders; an inset shows the zero."""
    inset = ax.inset_axes((0.13, 0.12, 0.5, 0.4))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ConvergenceWarning)   # the curves go past the radius
        curves = [(n, eight.closure(sol.truncate(n), lam)) for n in orders]
    first, last = min(orders), max(orders)
    looks = {first: (VERMILION, LINES[1], 2), last: (BLUE, LINES[0], 2)}
    for n, values in curves:
        colour, line, width = looks.get(n, (GREY, LINES[0], 0.8))
        for part in (ax, inset):
            part.plot(lam, values, color=colour, ls=line, lw=width,
                      label=f"order {n}" if n in looks else None)
    for part in (ax, inset):
        part.axhline(0, color=GREY, lw=0.8, ls=":")
    inset.set(xlim=(2.06, 2.09), ylim=(-0.05, 0.05))
    inset.tick_params(labelsize=8)
    inset.spines[["top", "right"]].set_visible(True)
    ax.indicate_inset_zoom(inset, edgecolor=GREY)
    ax.set(xlabel=r"$\lambda$", ylabel=r"$S_x(\lambda)$", xlim=(lam[0], lam[-1]), ylim=(-2.5, 4.7))
    ax.legend(loc="upper right")


def zeros(ax: Axes, found: Mapping[int, float], mean: float, limit: float) -> None:
    """Zeros λ_n over the order n (``found``: dict from n to λ_n), their mean and their limit."""
    ax.axhline(mean, color=VERMILION, ls=LINES[1], lw=1.2, label="mean $\\lambda_1$")
    ax.axhline(limit, color=GREEN, ls=LINES[2], lw=1.5, label=r"true orbit $\lambda_0$")
    ax.plot(list(found), list(found.values()), "o-", color=BLUE, lw=1, label=r"$\lambda_n$")
    ax.set(xlabel="order $n$", ylabel=r"$\lambda_n$", xticks=list(found)[::2])
    ax.legend()


def distance(ax: Axes, t: Any, gap: Array) -> None:
    """A distance over one period, in thousandths."""
    ax.plot(t, 1e3 * gap, color=BLUE)
    ax.set(xlabel="$t$", ylabel=r"distance $\times\,10^{3}$", xlim=(t[0], t[-1]), ylim=(0, None))
    ax.set_xticks(np.linspace(0, 2 * np.pi, 7),
                  ["0", *(f"${n}\\pi/3$" if n > 1 else r"$\pi/3$" for n in range(1, 6)), r"$2\pi$"])


def head_to_tail(ax: Axes, relative: ComplexArray, origin: complex = 0) -> None:
    """r_12, r_23, r_31 (``relative``) one after the other from ``origin``, and the gap S."""
    corners = origin + np.concatenate([[0], np.cumsum(relative)])
    labels = ((r"$\mathbf{r}_{12}$", (-14, 0)), (r"$\mathbf{r}_{23}$", (0, 9)),
              (r"$\mathbf{r}_{31}$", (15, 0)))
    for start, end, colour, (name, place) in zip(corners, corners[1:], COLOURS, labels,
                                                 strict=False):
        _arrow(ax, start, end, colour)
        middle = (start + end) / 2
        ax.annotate(name, (middle.real, middle.imag), place,
                    textcoords="offset points", ha="center", va="center")
    ax.plot([corners[0].real, corners[3].real], [corners[0].imag, corners[3].imag], color=GREY,
            ls=LINES[2], label=r"gap $\mathbf{S}$")


def drift(ax: Axes, lam: Array, spreads: Mapping[str, ArrayLike]) -> None:
    """What Newton's equations conserve, and how much it varies over a period, for each λ.

    ``spreads`` maps a name to values over ``lam``.
    """
    for (name, values), colour, line in zip(labelled("spreads", spreads).items(), COLOURS, LINES,
                                            strict=False):
        ax.semilogy(lam, values, color=colour, ls=line, label=name)
    ax.set(xlabel=r"$\lambda$", ylabel="greatest minus least value in a period",
           xlim=(lam[0], lam[-1]))
    ax.legend()


def convergence(ax: Axes, orders: Sequence[int], errors: ArrayLike) -> None:
    """|λ_n - λ_0| over the order n."""
    ax.semilogy(orders, errors, ".", color=BLUE)
    ax.set(xlabel="order $n$", ylabel=r"$|\lambda_n-\lambda_0|$", xlim=(0, None))


def emblem(ax: Axes, positions: Callable[[Any], ComplexArray]) -> None:
    """Three bodies on the lying eight, each with a fading trail, without axes."""
    _orbit(ax, _lying(positions, PERIOD)[2], color=GREY, lw=1.5)
    tail = np.linspace(-0.9, 0.25, 60)
    bodies = _lying(positions, tail)
    for path, colour in zip(bodies, COLOURS, strict=False):
        points = np.stack([path.real, path.imag], axis=1)
        pieces = list(np.stack([points[:-1], points[1:]], axis=1))
        ax.add_collection(LineCollection(pieces, colors=colour,
                                         linewidths=np.linspace(1.5, 7, len(tail) - 1),
                                         alpha=np.linspace(0, 0.8, len(tail) - 1)))
        ax.plot(*points[-1], "o", color=colour, ms=18)
    ax.set(aspect="equal")
    ax.margins(0.05, 0.15)
    ax.set_axis_off()


def _lying(positions: Callable[[Any], ComplexArray], t: Any) -> ComplexArray:
    """Turned clockwise by a right angle."""
    return -1j * positions(t)


def _orbit(ax: Axes, z: ComplexArray, **look: Any) -> None:
    ax.plot(z.real, z.imag, **look)


def _plane(ax: Axes, x: str, y: str) -> None:
    ax.set(xlabel=x, ylabel=y, aspect="equal")


def _arrow(ax: Axes, start: complex, end: complex, colour: str) -> None:
    ax.plot(end.real, end.imag, alpha=0)                    # lets the axes grow to hold the arrow
    ax.annotate("", (end.real, end.imag), (start.real, start.imag),
                arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 2, "shrinkA": 0,
                            "shrinkB": 0})
