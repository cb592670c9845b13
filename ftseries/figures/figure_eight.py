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
from ..evaluation import amplitudes
from ..problems import figure_eight as eight
from .style import BLUE, BODIES, COLOURS, GREEN, GREY, LINES, PURPLE, VERMILION

if TYPE_CHECKING:
    from ..solution import Solution

__all__ = ["choreography", "orbits", "closure", "zeros", "distance", "head_to_tail", "wheels",
           "lengths", "drift", "convergence", "emblem"]

PERIOD = np.linspace(0, 2 * np.pi, 1201)
ARROWS = {0: PURPLE, 1: BLUE, 2: VERMILION, 4: GREEN}   # by n, as in js/wheels.js


def choreography(ax: Axes, positions: Callable[[Any], ComplexArray]) -> None:
    """The eight lying, as in the paper's figure 7, with the bodies at t = 0 and t = 2π/12.

    ``positions`` is a function of time that gives the three upright positions.  Arrows at t = 0
    show where the bodies go.
    """
    _orbit(ax, _lying(positions, PERIOD)[2], color=GREY, lw=1.2)
    for t, prime, line in ((0, "", LINES[1]), (np.pi / 6, "'", LINES[2])):
        bodies = _lying(positions, t)
        _orbit(ax, bodies[[0, 1, 2, 0]], color=GREY, ls=line, lw=1.5)
        for number, (z, colour) in enumerate(zip(bodies, BODIES, strict=True), 1):
            ax.plot(z.real, z.imag, "o", color=colour, ms=9, mfc="none" if prime else colour)
            away = 16 * (z / abs(z) if abs(z) > 1e-6 else 1j)
            ax.annotate(f"${number}{prime}$", (z.real, z.imag), (away.real, away.imag),
                        textcoords="offset points", ha="center", va="center")
    for now, later, colour in zip(*_lying(positions, np.array([0, 0.14])).T, BODIES, strict=True):
        _arrow(ax, now, now + 0.2 * (later - now) / abs(later - now), colour)
    ax.margins(0.1, 0.25)
    _plane(ax)


def orbits(ax: Axes, curves: Mapping[str, ComplexArray]) -> None:
    """Upright orbits on top of one another; ``curves`` maps labels to closed curves."""
    for (label, z), colour, line in zip(labelled("curves", curves).items(),
                                        (BLUE, VERMILION, GREEN), LINES, strict=False):
        _orbit(ax, np.append(z, z[0]), color=colour, ls=line, label=label)
    _plane(ax)
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


def head_to_tail(ax: Axes, relative: ComplexArray, title: str = "") -> None:
    """r_23, r_12, r_31 head to tail (``relative`` = r_12, r_23, r_31), the gap S in the middle."""
    r_12, r_23, r_31 = relative
    S = relative.sum()
    corners = -S / 2 + np.cumsum([0, r_23, r_12, r_31])
    ax.plot(corners[[0, 3]].real, corners[[0, 3]].imag, color=PURPLE, ls="-", lw=7, alpha=0.5)
    names = (r"$\mathbf{r}_{23}$", r"$\mathbf{r}_{12}$", r"$\mathbf{r}_{31}$")
    for start, end, name in zip(corners, corners[1:], names, strict=False):
        _arrow(ax, start, end, GREY)
        place, aside = 0.65 * start + 0.35 * end, 11j * (end - start) / abs(end - start)
        if ((place - corners.mean()) / aside).real < 0:
            aside = -aside
        ax.annotate(name, (place.real, place.imag), (aside.real, aside.imag),
                    textcoords="offset points", ha="center", va="center")
    ax.set(aspect="equal", title=title)
    ax.margins(0.1)
    ax.set_axis_off()


def wheels(ax: Axes, sol: Solution, lam: float, t: float, body: bool = False) -> None:
    """Rotating arrows that lead to r_12, or with ``body`` to body 3, each on its wheel.

    ``sol`` is a solution that :func:`ftseries.figure_eight.expanded` has made.
    """
    curve = (eight.positions(sol, PERIOD, lam)[2] if body else eight.relative(sol, PERIOD, lam)[0])
    _orbit(ax, curve, color=GREY, lw=1.2, ls="-")
    tip = 0j
    for n, c in sorted(_modes(sol, lam).items()):
        arms: list[complex] = [c]
        if body:
            d = -2 / 3 * np.sin(2 * np.pi * n / 3) * c / 2j
            arms = [d * np.exp(1j * n * t), -d * np.exp(-1j * n * t)] if n else []
        elif n:
            arms = [c / 2 * np.exp(1j * n * t), c / 2 * np.exp(-1j * n * t)]
        for arm in arms:
            if n:
                _orbit(ax, tip + abs(arm) * np.exp(1j * PERIOD), color=GREY, lw=0.5, ls="-")
            _arrow(ax, tip, tip + arm, ARROWS.get(n, GREY))
            tip += arm
    ax.plot(tip.real, tip.imag, "o", color=GREY)
    _plane(ax)


def lengths(ax: Axes, sol: Solution, lams: Array, lam: float) -> None:
    """The lengths of the first of these arrows, with their signs, over λ; a mark at one ``lam``."""
    modes = [_modes(sol, value) for value in lams]
    for (n, colour), line in zip(ARROWS.items(), LINES, strict=False):
        values = [abs(row[n] / 2) if n else row[n].real for row in modes]
        ax.plot(lams, values, color=colour, ls=line, label=rf"$n=\pm{n}$" if n else "$n=0$")
    ax.axhline(0, color=GREY, lw=0.8, ls="-")
    ax.axvline(lam, color=GREY, lw=0.8, ls=":")
    ax.set(xlabel=r"$\lambda$", ylabel="length")
    ax.legend()


def _modes(sol: Solution, lam: float) -> dict[int, complex]:
    """c_n = X_n + i Y_n of r_12 = Σ c_n cos nt at one λ."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ConvergenceWarning)
        parts = [(1, amplitudes(sol.table("x"), lam)), (1j, amplitudes(sol.table("y"), lam))]
    return {n: unit * complex(value) for unit, part in parts for (_, n), value in part.items()}


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
    for path, colour in zip(bodies, BODIES, strict=True):
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


def _plane(ax: Axes) -> None:
    ax.set(xlabel="$x$", ylabel="$y$", aspect="equal")


def _arrow(ax: Axes, start: complex, end: complex, colour: str) -> None:
    ax.plot(end.real, end.imag, alpha=0)                    # lets the axes grow to hold the arrow
    ax.annotate("", (end.real, end.imag), (start.real, start.imag),
                arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 2, "shrinkA": 0,
                            "shrinkB": 0})
