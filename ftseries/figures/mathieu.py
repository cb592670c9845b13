"""Pictures of the generalized Mathieu equation, section 3 of the paper.

x is in radians; a and the potential are energies, in the unit in which a free particle of wave
number n has the energy n². `sol` is a solution of `GeneralizedMathieu` with symbolic μ; what it is
compared with is computed by `ftseries.references.mathieu`.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.ticker import FuncFormatter

from ..aliases import Array, ArrayLike, Real
from ..errors import ConvergenceWarning
from ..evaluation import amplitudes
from ..references import mathieu
from .style import BLUE, GREEN, GREY, LINES, PURPLE, VERMILION

if TYPE_CHECKING:
    from ..solution import Solution

__all__ = ["potential", "well", "bands", "error", "reach", "eigenvalue", "error_map", "numerical",
           "psi", "difference"]


def potential(ax: Axes, points: Sequence[tuple[float, float]]) -> None:
    """The potential λ² cos 2x + λ⁴ μ cos 4x, one line for each (λ, μ) of `points`.

    >>> from matplotlib.figure import Figure
    >>> ax = Figure().subplots()
    >>> potential(ax, [(2, 0), (2, -0.3)])
    >>> float(ax.lines[0].get_ydata().max())
    4.0
    """
    x = np.linspace(-np.pi, np.pi, 401)
    for lam, mu in points:
        ax.plot(x, lam**2 * np.cos(2 * x) + lam**4 * mu * np.cos(4 * x), label=_place(lam, mu))
    _angles(ax, -1, 1, 0.5)
    ax.set_ylabel("potential")
    _legend_above(ax, len(points))


def well(ax: Axes, lam: float, mu: float) -> None:
    r"""The potential at one (λ, μ), the energy a, and ψ by the Hill matrix drawn on this level.

    >>> from matplotlib.figure import Figure
    >>> ax = Figure().subplots()
    >>> well(ax, 1, 0)
    >>> [line.get_label() for line in ax.lines]
    ['potential', 'energy $a$', '$\\psi$, on this level']
    """
    x = np.linspace(-np.pi, np.pi, 401)
    shape = lam**2 * np.cos(2 * x) + lam**4 * mu * np.cos(4 * x)
    a, psi = mathieu.eigenvalue(lam, mu), mathieu.eigenfunction(x, lam, mu)
    ax.plot(x, shape, color=GREY, linestyle="-", label="potential")
    ax.axhline(a, color=VERMILION, linestyle=LINES[1], linewidth=1.5, label="energy $a$")
    ax.plot(x, a + 0.2 * np.ptp(shape) * psi / abs(psi).max(), color=BLUE, linestyle="-",
            label=r"$\psi$, on this level")
    _angles(ax, -1, 1, 0.5)
    ax.set_ylabel("energy")
    _legend_above(ax, 3)


def bands(ax: Axes, lam: Array, edges: Sequence[Array],
          points: Sequence[tuple[float, float]] = ()) -> None:
    """Bands of energy over λ between the first and second, third and fourth, … of the ``edges``.

    ``points`` are marks at some (λ, a).
    """
    for k, (low, high) in enumerate(zip(edges[::2], edges[1::2], strict=False)):
        ax.fill_between(lam, low, high, color=GREEN, alpha=0.4, linewidth=0,
                        label=None if k else "bands")
    for edge in edges:
        ax.plot(lam, edge, color=GREEN, linestyle="-", linewidth=1)
    for x, y in points:
        ax.plot(x, y, "o", color=BLUE, markeredgecolor="white", markersize=9, label="$a$")
    ax.set(xlabel=r"$\lambda$", ylabel="$a$", xlim=(lam[0], lam[-1]))
    ax.legend(loc="lower left")


def error(sol: Solution, lam: Any, mu: Any) -> Real:
    """|a - a of the Hill matrix| for arrays lam, mu that broadcast.

    >>> import ftseries as fts
    >>> bool(error(fts.solve(fts.GeneralizedMathieu(), order=20), 1, -0.3) < 1e-7)
    True
    """
    return abs(_eigenvalue(sol, lam, mu) - mathieu.eigenvalue(lam, mu))


def reach(sol: Solution, mu: Any, tolerance: float = 1e-3, largest: float = 3.0,
          step: float = 0.02) -> Array:
    """For each μ of an array, the λ up to which the series' a has an error below `tolerance`.

    The place is found on a grid of the given step, and in between by a straight line in log error;
    `largest` stands for everything from there on.

    >>> import ftseries as fts
    >>> reach(fts.solve(fts.GeneralizedMathieu(), order=20), [0.0, 0.2]).round(1)
    array([2.4, 1.7])
    """
    lam = np.arange(step, largest + step / 2, step)
    excess = np.log(error(sol, lam, np.asarray(mu)[:, None]) / tolerance + 1e-300)
    place = np.full(len(excess), largest)
    for i, row in enumerate(excess):
        above = np.flatnonzero(row > 0)
        if above.size:
            after = max(above[0], 1)
            place[i] = lam[after] - step * row[after] / (row[after] - row[after - 1])
    return place


def eigenvalue(ax: Any, sol: Solution, points: Sequence[tuple[float, float]] = (),
               largest: float = 0.4, tolerance: float = 1e-3) -> None:
    """The paper's figure 4: a(λ, μ) as a surface, on a three-dimensional Axes.

    The surface covers |μ| ≤ `largest` and ends where the error exceeds `tolerance`. The line on it
    is SciPy's eigenvalue of the ordinary Mathieu equation, μ = 0; marks are the series' eigenvalues
    at the (λ, μ) of `points`.
    """
    mu = np.linspace(-largest, largest, 81)
    edge = reach(sol, mu, tolerance)
    lam = np.linspace(0, 1, 61)[:, None] * edge
    a = _eigenvalue(sol, lam, mu)
    ax.computed_zorder = False
    ax.plot_surface(lam, np.broadcast_to(mu, lam.shape), a, cmap="cividis", rcount=61, ccount=81,
                    linewidth=0, antialiased=False, zorder=1)
    ordinary = np.linspace(0, edge[len(mu) // 2], 101)
    ax.plot(ordinary, 0 * ordinary, mathieu.mathieu_b(ordinary), color=VERMILION, linestyle="-",
            linewidth=3, zorder=3, label=r"ordinary Mathieu equation, $\mu = 0$")
    for number, (x, y) in enumerate(points):
        ax.plot([x], [y], [float(_eigenvalue(sol, x, y))], "o", color=BLUE, markeredgecolor="white",
                markersize=9, zorder=4 + number, label=_place(x, y))
    ax.set(xlabel=r"$\lambda$", ylabel=r"$\mu$", xlim=(0, float(edge.max())))
    ax.set_zlabel("$a$")
    ax.locator_params("x", nbins=4)
    ax.locator_params("y", nbins=5)
    ax.view_init(elev=22, azim=-50)
    ax.set_box_aspect((1.25, 1.25, 1))
    ax.legend(loc="upper center", ncols=2)


def error_map(ax: Axes, sol: Solution, points: Sequence[tuple[float, float]] = (),
              radius: float | None = None, closed: float | None = None,
              largest: float = 0.5) -> None:
    """The error of a over the plane (λ, μ), with the line where it is 1e-3.

    `points` get marks, as does a known `radius` of convergence at μ = 0; `closed` is the μ of a
    case in closed form, such as ``Fraction(-1, 32)``.
    """
    lam, mu = np.linspace(0, 3, 151), np.linspace(-largest, largest, 121)
    values = np.clip(error(sol, lam, mu[:, None]), 1e-16, 1)
    image = ax.pcolormesh(lam, mu, values, norm=LogNorm(1e-16, 1), cmap="cividis",
                          shading="gouraud", rasterized=True)
    ax.plot(reach(sol, mu), mu, color="black", linestyle="-", linewidth=1.5)
    if closed is not None:
        ax.axhline(float(closed), color="white", linestyle=LINES[2], linewidth=1.5)
        ax.annotate(rf"$\mu = {closed}$", (0.05, float(closed)), xytext=(0, -5), color="white",
                    textcoords="offset points", verticalalignment="top")
    if radius is not None:
        ax.plot([radius], [0], "s", color=VERMILION, markeredgecolor="white", markersize=9,
                label=r"radius of convergence, $\mu = 0$")
    for x, y in points:
        ax.plot([x], [y], "o", color=BLUE, markeredgecolor="white", markersize=9,
                label=_place(x, y))
    ax.set(xlabel=r"$\lambda$", ylabel=r"$\mu$", xlim=(0, 3), ylim=(-largest, largest))
    _legend_above(ax, 2)
    bar = ax.figure.colorbar(image, ax=ax, label="error of $a$", ticks=10.0 ** np.arange(-16, 1, 4))
    bar.outline.set_edgecolor(GREY)


def numerical(sol: Solution, x: ArrayLike, lam: Any, mu: Any) -> Real:
    """The paper's numerical solution: (M1) integrated with the series' own a, ψ(0) = 0 and ψ'(0).

    Parameters
    ----------
    sol : Solution
        Of the generalized Mathieu equation, μ symbolic.
    x : array_like
        Points, in radians.
    lam, mu : float

    Returns
    -------
    numpy.ndarray
        ψ at the points.

    Examples
    --------
    >>> import ftseries as fts
    >>> sol = fts.solve(fts.GeneralizedMathieu(), order=30)
    >>> bool(abs(numerical(sol, 1.0, 1, -0.3) - sol.evaluate("psi", 1.0, lam=1, mu=-0.3)) < 1e-8)
    True
    """
    amplitude = amplitudes(sol.table("psi", mu=mu), lam)
    slope = float(sum(n * value for (_, n), value in amplitude.items()))
    return mathieu.integrate(x, _eigenvalue(sol, lam, mu), lam, mu, (0, slope))[0]


def psi(ax: Axes, sol: Solution, lam: Any, mu: Any, periods: int = 1) -> None:
    """The paper's figure 5: ψ(x), numerical solution as a full line, series dashed."""
    x = _points(periods)
    ax.axhline(0, color=GREY, linestyle="-", linewidth=0.8)
    ax.plot(x, numerical(sol, x, lam, mu), color=VERMILION, linestyle="-", linewidth=3.5,
            alpha=0.7, label="numerical solution")
    ax.plot(x, sol.evaluate("psi", x, lam=lam, mu=mu), color=BLUE, linestyle=LINES[1],
            label=f"series of order {sol.order}")
    _angles(ax, 0, 2 * periods, _tick(periods))
    ax.set_ylabel(r"$\psi(x)$")
    _legend_above(ax, 2)


def difference(ax: Axes, sol: Solution, lam: Any, mu: Any, periods: int = 1) -> None:
    """The paper's figure 6: δψ(x), series minus numerical solution, over whole periods."""
    x = _points(periods)
    delta = sol.evaluate("psi", x, lam=lam, mu=mu) - numerical(sol, x, lam, mu)
    ax.axhline(0, color=GREY, linestyle="-", linewidth=0.8)
    ax.plot(x, delta, color=GREEN if periods == 1 else PURPLE, linestyle="-")
    _angles(ax, 0, 2 * periods, _tick(periods))
    ax.set_ylabel(r"$\delta\psi(x)$")


def _eigenvalue(sol: Solution, lam: Any, mu: Any) -> Real:
    """The series' a; these pictures look beyond its radius of convergence on purpose."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ConvergenceWarning)
        return sol.evaluate("a", lam=lam, mu=mu)


def _points(periods: int) -> Array:
    return np.linspace(0, 2 * np.pi * periods, 200 * periods + 1)


def _place(lam: Any, mu: Any) -> str:
    return rf"$\lambda = {lam:g},\ \mu = {mu:g}$"


def _legend_above(ax: Axes, columns: int) -> None:
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=columns)


def _tick(periods: int) -> Any:
    """The distance of ticks in units of π: not more than ten of them."""
    return 0.5 if periods == 1 else 2 * -(-periods // 10)


def _angles(ax: Axes, low: float, high: float, step: float) -> None:
    """The x axis from low·π to high·π, with ticks step·π apart."""
    def label(value: float, _: Any) -> str:
        number = round(value / np.pi, 6)
        shown = {0: "0", 1: r"$\pi$", -1: r"$-\pi$", 0.5: r"$\pi/2$", -0.5: r"$-\pi/2$",
                 1.5: r"$3\pi/2$"}
        return shown.get(number, rf"${number:g}\pi$")
    ax.set(xlabel="$x$", xlim=(low * np.pi, high * np.pi))
    ax.set_xticks(np.arange(low, high + step / 2, step) * np.pi)
    ax.xaxis.set_major_formatter(FuncFormatter(label))
