"""Pictures of the cubic oscillator: the paper's figures 1 to 3, coefficients, frequency, errors.

Lengths are in the unit of a, times in that of 1/√a. `sol` is a solution of `CubicOscillator` whose
a is a number; the exact motion is that of `ftseries.references`.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from ..aliases import ArrayLike
from ..errors import ConvergenceWarning, InputError
from ..precision import working
from ..references import cubic, weierstrass
from . import style

if TYPE_CHECKING:
    from ..solution import Solution

__all__ = ["potential", "oscillation", "difference", "coefficients", "frequency", "largest_error"]


def potential(ax: Axes, lam: float, a: float = 1) -> None:
    """V(x) of (C1), the energy (C2) and the turning points; the paper's figure 1.

    >>> from matplotlib.figure import Figure
    >>> ax = Figure().subplots()
    >>> potential(ax, 0.5)
    >>> ax.get_xlabel(), ax.get_ylabel()
    ('$x$', '$V(x)$')
    """
    left, right = cubic.turning_points(lam, a)
    energy = cubic.energy(lam, a) + 0.0                     # no "-0" in the legend
    x = np.linspace(left - 0.7 * a, 2.2 * a, 401)
    ax.plot(x, cubic.potential(x, lam, a), label="$V(x)$", color=style.BLUE, linestyle="-")
    ax.axhline(energy, color=style.GREY, linewidth=0.8, linestyle=":")
    inside = np.linspace(left, right, 101)
    ax.plot(inside, np.full(101, energy), label=f"motion, $E = {energy:g}$",
            color=style.VERMILION, linestyle="-", linewidth=3)
    ax.fill_between(inside, cubic.potential(inside, lam, a), energy, color=style.VERMILION,
                    alpha=0.2, linewidth=0)
    ax.plot([left, right], [energy, energy], "o", label="turning points", color=style.VERMILION)
    for point, name, side in ((left, "min", -1), (right, "max", 1)):
        ax.annotate(rf"$x_{{\mathrm{{{name}}}}} = {point:g}$", (point, energy),
                    xytext=(8 * side, -18), textcoords="offset points",
                    horizontalalignment="right" if side < 0 else "left")
    ax.plot([2 * a], [energy], "s", label="$x = 2a$, the third root", color=style.GREEN)
    ax.set(xlabel="$x$", ylabel="$V(x)$", xlim=(left - 1.5 * a, 2.3 * a))   # room for x_min
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)


def oscillation(ax: Axes, sol: Solution, lam: float, periods: float = 2) -> None:
    """x(t) by the series and by (C12); the paper's figure 2."""
    t = _times(sol, lam, periods, 240)
    for level in cubic.turning_points(lam, _a(sol)):
        ax.axhline(level, color=style.GREY, linewidth=0.8, linestyle=":")
    ax.plot(t, sol.evaluate("x", t, lam=lam), label=f"series of order {sol.order}",
            color=style.VERMILION, linestyle="-", linewidth=3.5, alpha=0.7)
    ax.plot(t, _exact(t, sol, lam, 20).astype(float), label=r"exact, $\wp(t - u_1)$",
            color=style.BLUE, linestyle=style.LINES[1], linewidth=1.6)
    ax.set(xlabel="$t$", ylabel="$x(t)$")
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)


def difference(ax: Axes, sol: Solution, lam: float, dps: int | None = None,
               periods: float = 2) -> None:
    """Series minus (C12); the paper's figure 3.

    Without `dps` the series is summed in double precision, whose rounding is then all one sees;
    with it, both are computed to `dps` decimal digits and only rounded to be drawn.
    """
    t = _times(sol, lam, periods, 120)
    if dps is None:
        error = sol.evaluate("x", t, lam=lam) - _exact(t, sol, lam, 20).astype(float)
    else:
        error = (sol.evaluate("x", t, lam=lam, dps=dps) - _exact(t, sol, lam, dps)).astype(float)
    ax.plot(t, error, color=style.GREEN if dps else style.VERMILION, linestyle="-", linewidth=1.2,
            label=f"{dps} digits" if dps else "double precision")
    ax.set(xlabel="$t$", ylabel=f"$x_{{{sol.order}}}(t) - x(t)$")
    ax.legend(loc="lower right", bbox_to_anchor=(1, 1))


def coefficients(ax: Axes, sol: Solution) -> None:
    """The size of every A_{n,m} of (C5a), by colour; coefficients that vanish are left blank."""
    table = sol.table("x")
    size = np.full((sol.order + 1, sol.order + 1), np.nan)
    for (_, n), row in table.items():
        found = np.flatnonzero(row)
        size[n, found] = np.log10(np.abs(row)[found])
    image = ax.imshow(size, origin="lower", aspect="equal")
    ax.figure.colorbar(image, ax=ax, label=r"$\log_{10}\,|A_{n,m}|$")
    ax.set(xlabel="Taylor order $m$", ylabel="Fourier order $n$")


def frequency(ax: Axes, sol: Solution, orders: Sequence[int]) -> None:
    """ω against λ/(3a): exact by (C9b), and the series cut at each of `orders`."""
    a = _a(sol)
    end = 1 - np.geomspace(1e-3, 1e-15, 60)             # it falls within less than a pixel
    lam = 3 * a * np.append(np.linspace(0, 0.998, 499), end)
    ax.plot(np.append(lam / (3 * a), 1), np.append(cubic.frequency(lam, a), 0), label="exact",
            color=style.GREY, linestyle="-", linewidth=3.5, alpha=0.6)
    for order, colour, line in zip(orders, style.COLOURS, style.LINES[1:] + style.LINES[:1]):
        with warnings.catch_warnings():                         # the curves go up to the radius
            warnings.simplefilter("ignore", ConvergenceWarning)
            values = sol.truncate(order).evaluate("omega", lam=lam)
        ax.plot(lam / (3 * a), values, label=f"order {order}", color=colour, linestyle=line)
    ax.set(xlabel=r"$\lambda / 3a$", ylabel=r"$\omega$", ylim=(0, None))
    ax.legend(loc="lower left")


def largest_error(ax: Axes, sol: Solution, orders: Sequence[int], ratios: ArrayLike,
                  dps: int | None = 40, samples: int = 16, mark: float | None = None) -> None:
    """The largest error of x(t) over one period against λ/(3a) = `ratios`, for some orders.

    It is computed with `dps` digits, from `samples` equal parts of the period.  A line stands at
    the ratio `mark`.
    """
    a = _a(sol)
    for order, colour, line, marker in zip(orders, style.COLOURS, style.LINES, "osd^"):
        short = sol.truncate(order)
        errors = []
        for lam in 3 * a * np.asarray(ratios, dtype=float):
            t = _times(sol, lam, 1, samples, dps)
            with warnings.catch_warnings():                     # the error is what is shown
                warnings.simplefilter("ignore", ConvergenceWarning)
                values = short.evaluate("x", t, lam=lam, dps=dps)
            errors.append(max(abs(values - _exact(t, sol, lam, dps))))
        ax.semilogy(ratios, np.array(errors, dtype=float), label=f"order {order}", color=colour,
                    linestyle=line, marker=marker, markersize=5)
    if mark is not None:
        ax.axvline(mark, color=style.GREY, linewidth=1, linestyle=":")
    ax.set(xlabel=r"$\lambda / 3a$", ylabel="largest error of $x(t)$ over one period")
    ax.legend(loc="lower right")


def _a(sol: Solution) -> float:
    a: Any = getattr(sol.problem, "a", None)
    try:
        return float(a)
    except TypeError:
        raise InputError(f"a={a} is a symbol: a picture needs a solution whose a is a "
                         "number, such as CubicOscillator(a=1)") from None


def _times(sol: Solution, lam: float, periods: float, parts: int,
           dps: int | None = None) -> NDArray[Any]:
    """`parts` + 1 equal steps from 0 to the end of `periods` exact periods."""
    if dps is None:
        return np.linspace(0, periods * cubic.period(lam, _a(sol)), parts + 1)
    with working(digits=dps):
        end = periods * cubic.period(lam, _a(sol), dps=dps)
        return np.array([end * k / parts for k in range(parts + 1)])


def _exact(t: Any, sol: Solution, lam: float, dps: int | None) -> NDArray[Any]:
    return np.array([weierstrass.position(s, lam, _a(sol), dps) for s in t])
