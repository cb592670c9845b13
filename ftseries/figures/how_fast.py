"""Pictures of how_fast: time over the order, error over time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from matplotlib.axes import Axes
from matplotlib.ticker import ScalarFormatter

from ..arguments import labelled
from .style import COLOURS, LINES

__all__ = ["growth", "trade"]

_MARKS = "os^Dvx*"


def growth(ax: Axes, curves: Mapping[str, Sequence[tuple[float, float]]], label: str) -> None:
    """Seconds over the order, both logarithmic; ``curves`` maps methods to (order, seconds).

    >>> from matplotlib.figure import Figure
    >>> ax = Figure().subplots()
    >>> growth(ax, {"exact": [(10, 0.01), (100, 2.0)]}, "Taylor order")
    >>> ax.get_xscale(), len(ax.lines)
    ('log', 1)
    """
    for (name, points), colour, line, mark in zip(labelled("curves", curves).items(), COLOURS,
                                                  LINES, _MARKS, strict=False):
        ax.loglog(*zip(*points, strict=True), color=colour, ls=line, marker=mark, ms=5, label=name)
    ax.set_xscale("log", base=2)
    ax.set(xlabel=label, ylabel="seconds")
    ax.xaxis.set_major_formatter(ScalarFormatter())
    ax.legend(loc="center left", bbox_to_anchor=(1, 0.5))


def trade(ax: Axes, curves: Mapping[str, Sequence[tuple[float, float]]]) -> None:
    """Error over seconds, both logarithmic; ``curves`` maps methods to (seconds, error).

    Several points of one method, at several orders or tolerances, are joined.

    >>> from matplotlib.figure import Figure
    >>> ax = Figure().subplots()
    >>> trade(ax, {"series": [(0.01, 1e-3), (0.1, 1e-6)], "shooting": [(0.1, 1e-13)]})
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['series', 'shooting']
    """
    for i, (name, points) in enumerate(labelled("curves", curves).items()):
        colour, mark = COLOURS[i % len(COLOURS)], _MARKS[i % len(_MARKS)]
        ax.loglog(*zip(*points, strict=True), color=colour, marker=mark, ms=6, label=name,
                  ls=LINES[i % len(LINES)] if len(points) > 1 else "none")
    ax.set(xlabel="seconds", ylabel="largest error")
    ax.legend(loc="center left", bbox_to_anchor=(1, 0.5))
