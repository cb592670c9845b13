"""Picture of the chapter on digits: how fast the coefficients fall, and how fast the errors do."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from ..aliases import ArrayLike
from .style import BLUE, GREY, VERMILION

__all__ = ["decay", "passes"]


def decay(ax: Axes, n: ArrayLike, logarithms: ArrayLike, slope: float, digits: float) -> None:
    """Decimal logarithms of Fourier coefficients over n, the line of their slope, a level wanted.

    ``slope`` in digits per harmonic, positive; ``digits`` is the level.

    >>> from matplotlib.figure import Figure
    >>> ax = Figure().subplots()
    >>> decay(ax, [1, 100, 200], [0, -21.5, -43], 0.215, 40)
    >>> len(ax.lines)
    3
    """
    n, logarithms = np.asarray(n), np.asarray(logarithms)
    ax.plot(n, logarithms, ".", color=BLUE, ms=3, ls="none", label=r"$\log_{10}|c_n|$")
    ax.plot(n, -slope * n, color=VERMILION, ls=(0, (5, 3)), lw=1.5,
            label=f"slope $-{slope:.3f}$")
    ax.axhline(-digits, color=GREY, ls=":", lw=1.2)
    ax.set(xlabel="harmonic $n$", ylabel="power of ten", xlim=(0, None))
    ax.legend(loc="upper right")


def passes(ax: Axes, errors: Sequence[float], gain: float) -> None:
    """Decimal logarithms of the error after each pass, and a line that gains ``gain`` a pass."""
    k = np.arange(len(errors))
    ax.plot(k, errors, "o", color=BLUE, ms=5, ls="none", label="error")
    ax.plot(k, errors[0] - gain * k, color=VERMILION, ls=(0, (5, 3)), lw=1.5,
            label=f"{gain:.1f} digits a pass")
    ax.set(xlabel="pass", ylabel="power of ten", xlim=(-0.5, None))
    ax.xaxis.set_major_locator(MaxNLocator(integer=True))
    ax.legend(loc="upper right")
