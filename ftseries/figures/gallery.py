"""The pictures of the chapters "Your own equation" and "Gallery"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes

from ..aliases import ArrayLike
from ..arguments import labelled
from .style import COLOURS, GREY, LINES

__all__ = ["curves", "orbits", "plane"]


def curves(ax: Axes, x: ArrayLike, named: Mapping[str, ArrayLike],
           points: Sequence[tuple[float, float]] = (), xlabel: str = "λ",
           ylabel: str = "frequency ω") -> None:
    """Functions of one variable, and points that were found by other means.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
    x : array_like
    named : dict
        Label to the values at ``x``.
    points : sequence of (x, y)
        Drawn as rings, on top.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = Figure().add_subplot()
    >>> curves(ax, [0, 1], {"a": [1, 2]}, points=[(1, 2)])
    >>> len(ax.lines)
    2
    """
    for (label, y), colour, line in zip(labelled("named", named).items(), COLOURS, LINES):
        ax.plot(x, y, label=label, color=colour, linestyle=line)
    if points:
        ax.plot(*zip(*points), "o", mfc="none", mec=GREY, ms=8, mew=1.5, label="integration")
    ax.set(xlabel=xlabel, ylabel=ylabel)
    ax.legend()


def orbits(ax: Axes, named: Mapping[str, tuple[ArrayLike, ArrayLike]], xlabel: str = "x",
           ylabel: str = "y", equal: bool = True) -> None:
    """Closed curves in a plane, each a pair of arrays, with its label.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = Figure().add_subplot()
    >>> t = np.linspace(0, 2 * np.pi)
    >>> orbits(ax, {"circle": (np.cos(t), np.sin(t))})
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['circle']
    """
    for (label, (x, y)), colour, line in zip(labelled("named", named).items(), COLOURS, LINES):
        ax.plot(x, y, label=label, color=colour, linestyle=line)
    ax.set(xlabel=xlabel, ylabel=ylabel)
    if equal:
        ax.set_aspect("equal", adjustable="datalim")
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)


def plane(ax: Axes, places: Sequence[complex], radius: float, label: str) -> None:
    """Singularities in a complex plane, with the circle of convergence.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = Figure().add_subplot()
    >>> plane(ax, [1 + 1j, 1 - 1j], 2**0.5, "z")
    >>> [len(line.get_xdata()) for line in ax.lines[:2]]          # the circle, the crosses
    [361, 2]
    """
    turn = np.linspace(0, 2 * np.pi, 361)
    ax.plot(radius * np.cos(turn), radius * np.sin(turn), color=COLOURS[1], linestyle=LINES[1])
    ax.plot(np.real(places), np.imag(places), "X", color=COLOURS[0], ms=10)
    ax.axhline(0, color=GREY, linewidth=0.6)
    ax.axvline(0, color=GREY, linewidth=0.6)
    ax.set(xlabel=f"Re {label}", ylabel=f"Im {label}", aspect="equal")
