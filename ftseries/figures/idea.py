"""The pictures of the chapter "The idea"."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from ..aliases import Array, ArrayLike
from ..arguments import whole
from ..errors import ConvergenceWarning
from .style import COLOURS, GREY, LINES

if TYPE_CHECKING:
    from ..solution import Solution

__all__ = ["coefficient_triangle", "period_error"]


def coefficient_triangle(ax: Axes, sol: Solution, name: str, order: int) -> None:
    """Which A_{n,m} an unknown has: a disc for each, the larger the larger |A_{n,m}|.

    Crosses mark the places with n ≤ m whose coefficient is zero.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
    sol : Solution
    name : str
        An unknown field.
    order : int
        Taylor orders 0 to ``order`` are drawn, at most those of ``sol``.

    Examples
    --------
    >>> import ftseries as fts
    >>> from matplotlib.figure import Figure
    >>> ax = Figure().add_subplot()
    >>> coefficient_triangle(ax, fts.solve(fts.CubicOscillator(), 4), "x", 4)
    >>> [len(marks.get_offsets()) for marks in ax.collections]    # places n ≤ m, with and without
    [9, 6]
    """
    order = whole("order", order, most=sol.order)
    size = {(m, n): abs(row[m]) for (_, n), row in sol.table(name).items()
            for m in range(order + 1) if row[m]}
    empty = [(m, n) for m in range(order + 1) for n in range(m + 1) if (m, n) not in size]
    decades = np.log10(list(size.values()))
    area = 12 + 260 * (decades - decades.min()) / max(np.ptp(decades), 1e-300)
    m, n = np.transpose(list(size))
    ax.scatter(m, n, s=area, color=COLOURS[1], alpha=0.85, zorder=3)
    m, n = np.transpose(empty)
    ax.scatter(m, n, s=14, color=GREY, marker="x", linewidths=0.8)
    ax.plot([0, order], [0, order], color=COLOURS[0], linestyle=LINES[1], linewidth=1.2)
    ax.annotate("$n = m$", (0.72 * order, 0.72 * order), (-8, 8), textcoords="offset points",
                ha="right", color=COLOURS[0])
    ax.set(xlabel="Taylor order $m$ (power of λ)", ylabel="Fourier order $n$ (of cos $nωt$)",
           aspect="equal")
    ax.xaxis.set_major_locator(MaxNLocator(integer=True))
    ax.yaxis.set_major_locator(MaxNLocator(integer=True))


def period_error(ax: Axes, sol: Solution, exact: Callable[[Array], Array], lam: ArrayLike,
                 orders: Sequence[int]) -> None:
    """Relative error of the period 2π/ω over λ, one curve for each truncation.

    Errors below the rounding unit of float64 are drawn at that unit.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
    sol : Solution
        With the unknown scalar ``omega`` and the unknown field ``x``.
    exact : callable
        Period of the motion that starts at rest from x(0), for an array of x(0).
    lam : array_like
        Positive values of the series parameter.
    orders : iterable of int
        Taylor orders to cut at.

    Examples
    --------
    >>> import ftseries as fts
    >>> from ftseries.references import cubic
    >>> from matplotlib.figure import Figure
    >>> ax = Figure().add_subplot()
    >>> sol = fts.solve(fts.CubicOscillator(), 8)
    >>> period_error(ax, sol, lambda x0: cubic.period(x0 + 1), [0.5, 1], [4, 8])
    >>> four, eight = (line.get_ydata() for line in ax.lines)
    >>> bool((eight < four).all())
    True
    """
    for number, order in enumerate(orders):
        cut = sol.truncate(order)
        with warnings.catch_warnings():                         # the error is what is shown
            warnings.simplefilter("ignore", ConvergenceWarning)
            period = 2 * np.pi / cut.evaluate("omega", lam=lam)
            start = sol.evaluate("x", 0.0, lam=lam)
        error = np.maximum(abs(period / exact(start) - 1), np.finfo(float).eps)
        ax.semilogy(lam, error, label=f"order {order}", color=COLOURS[number % 4],
                    linestyle=LINES[number % 4])
    ax.set(xlabel="amplitude λ of the first harmonic", ylabel="relative error of the period")
    ax.grid(True)
    ax.legend()
