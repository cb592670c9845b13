"""Pictures of the chapter on convergence: ratios, singularities, errors against order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ..aliases import ArrayLike
from ..analysis import domb_sykes
from ..arguments import labelled
from .style import BLUE, COLOURS, GREEN, GREY, LINES, PURPLE, VERMILION

__all__ = ["ratios", "approach", "plane", "radius", "oscillation", "errors"]

_MARKS = ("o", "s", "^", "D")


def ratios(left: Axes, right: Axes, sequences: Mapping[str, Sequence[Any]], limit: float) -> None:
    """The plot of Domb and Sykes on ``left``, the exponents that single ratios give on ``right``.

    Points c_k/c_{k-1} over 1/k, one set for each of the ``sequences``, a dict from a label to
    coefficients; and k (1 - c_k/(limit c_{k-1})) - 1, which tends to s, with the known ``limit``.

    >>> from matplotlib.figure import Figure
    >>> left, right = Figure().subplots(1, 2)
    >>> ratios(left, right, {"logarithm": [1.0, 1 / 2, 1 / 3, 1 / 4]}, 1)
    >>> right.lines[0].get_ydata().round(12).tolist()
    [-0.5, -0.333333333333, -0.25]
    """
    for (label, c), colour, mark in zip(labelled("sequences", sequences).items(), COLOURS, _MARKS,
                                        strict=False):
        x, y = np.transpose(domb_sykes(c))
        look: dict[str, Any] = {"color": colour, "marker": mark, "ms": 5, "mfc": "none",
                                "ls": "none"}
        left.plot(x, y, label=label, **look)
        right.plot(x, (1 - y / limit) / x - 1, label=label, **look)
    left.axhline(limit, color=GREY, ls=":", lw=1.2)
    right.axhline(0, color=GREY, ls=":", lw=1.2)
    left.set(xlabel="$1/k$", ylabel="$c_k/c_{k-1}$", xlim=(0, None))
    right.set(xlabel="$1/k$", ylabel="exponent $s$ from one ratio", xlim=(0, 0.35),
              ylim=(-0.1, 0.25))
    left.legend()


def approach(ax: Axes, distance: ArrayLike, errors: Any, label: str) -> None:
    """Errors over the distance from a singularity, both logarithmic; ``errors``: dict of arrays."""
    for (name, values), colour, line, mark in zip(labelled("errors", errors).items(), COLOURS,
                                                  LINES, _MARKS, strict=False):
        ax.loglog(distance, np.maximum(values, 1e-17), color=colour, ls=line, marker=mark, ms=4,
                  label=name)
    ax.invert_xaxis()
    ax.set(xlabel=label, ylabel="error")
    ax.legend()


def plane(ax: Axes, singularities: Sequence[complex], poles: ArrayLike = (),
          inside: Mapping[str, complex] | None = None, span: float | None = None,
          label: str = "$z$") -> None:
    """The complex plane with poles, singularities, and the circle through the nearest of them.

    ``inside`` maps labels to further points, such as the physical value.
    """
    turn = np.exp(1j * np.linspace(0, 2 * np.pi, 361))
    circle = abs(singularities[0]) * turn
    ax.plot(circle.real, circle.imag, color=GREY, lw=1.2, ls="-", label="circle of convergence")
    poles = np.asarray(poles, dtype=complex)
    ax.plot(poles.real, poles.imag, "x", color=BLUE, ms=5, ls="none", label="Padé poles")
    places = np.asarray(singularities, dtype=complex)
    ax.plot(places.real, places.imag, "o", color=VERMILION, ms=9, mfc="none", mew=2, ls="none",
            label="branch points")
    inside = labelled("inside", inside or {})
    for (name, z), mark in zip(inside.items(), ("*", "P"), strict=False):
        ax.plot([z.real], [z.imag], mark, color=GREEN, ms=12, ls="none", label=name)
    span = span or 1.6 * abs(singularities[0])
    ax.set(xlim=(-span, span), ylim=(-span, span), aspect="equal", xlabel=f"Re {label}",
           ylabel=f"Im {label}")
    ax.legend(loc="center left", bbox_to_anchor=(1, 0.5))


def radius(ax: Axes, mu: ArrayLike, values: ArrayLike, errors: Any, known: ArrayLike) -> None:
    """Radius of convergence over μ with error bars; ``known``: (μ, radius) from elsewhere."""
    ax.errorbar(mu, values, yerr=errors, color=BLUE, marker="o", ms=4, lw=1.5, capsize=3,
                label="from the series")
    ax.plot(*np.transpose(known), "s", color=VERMILION, ms=9, mfc="none", mew=2, ls="none",
            label="double eigenvalue")
    ax.set(xlabel=r"$\mu$", ylabel=r"radius of convergence in $\lambda$", ylim=(0, None))
    ax.legend()


def oscillation(ax: Axes, orders: ArrayLike, seen: ArrayLike,
                predicted: tuple[ArrayLike, ArrayLike]) -> None:
    """A scaled error over the order: points, and the curve that the branch points predict."""
    ax.plot(*predicted, color=VERMILION, ls="-", lw=1.5, label="predicted period")
    ax.plot(orders, seen, "o", color=BLUE, ms=5, ls="none", label="seen")
    ax.axhline(0, color=GREY, lw=0.8)
    ax.set(xlabel="order $n$", ylabel=r"$(\lambda_n-\lambda_0)\,(\rho/\lambda_0)^n\,(n/2)^{3/2}$")
    ax.legend()


def errors(ax: Axes, curves: Mapping[str, tuple[ArrayLike, ArrayLike]],
           label: str = "largest distance") -> None:
    """Errors over the order; ``curves`` maps a label to (orders, errors)."""
    for (name, (orders, values)), colour, line, mark in zip(
            labelled("curves", curves).items(), (BLUE, VERMILION, GREEN, PURPLE), LINES, _MARKS,
            strict=False):
        ax.semilogy(orders, values, color=colour, ls=line, marker=mark, ms=4, label=name)
    ax.set(xlabel="order $n$", ylabel=label)
    ax.legend()
