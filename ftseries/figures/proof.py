"""Picture of the chapter on proofs: the terms of a series that is proved to converge."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from ..certify.convergence import ConvergenceTheorem
from .style import COLOURS, GREY, LINES

__all__ = ["terms"]

_LABELS = {"r": r"$r$", "phi": r"$\varphi$"}


def terms(ax: Axes, theorem: ConvergenceTheorem, radius: float) -> None:
    """Sums of |coefficients| at each power of μ, and what is proved of all of them together.

    The dash-dotted line falls like (κ/radius)^{2m}.

    >>> import ftseries as fts
    >>> from matplotlib.figure import Figure
    >>> series = fts.solve(fts.FigureEight(), order=30, arithmetic="float")
    >>> ax = Figure().subplots()
    >>> terms(ax, fts.certify.prove_convergence(series, lam=1, modes=15), 2.2095)
    >>> len(ax.lines)
    4
    """
    for (name, sizes), colour, line in zip(theorem.sizes.items(), COLOURS, LINES, strict=False):
        values = np.array([float(x.mid()) for x in sizes])
        ax.semilogy(values, color=colour, ls=line, label=_LABELS[name])
        last = len(values) - 1
    m = np.arange(1, last + 1)
    ax.semilogy(m, m**-1.5 * (float(theorem.lam) / radius) ** (2 * m), color=GREY, ls="-.", lw=1.2,
                label=r"$m^{-3/2}(\kappa/\varrho)^{2m}$")
    ax.axhline(float(max(theorem.rest.values(), key=float)), color=GREY, ls=":", lw=1.2,
               label="proved bound of all that is missing")
    ax.set(xlabel=r"power $m$ of $\mu$", ylabel=r"sum of $|$coefficients$|$")
    ax.legend()
