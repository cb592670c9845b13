"""The picture of the chapter "The idea"."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes

from ..aliases import Array, ArrayLike
from ..errors import ConvergenceWarning
from .style import COLOURS, LINES

if TYPE_CHECKING:
    from ..solution import Solution

__all__ = ["period_error"]


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
