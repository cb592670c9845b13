"""Draw the picture of the README, book/assets/eight.svg: three bodies on the eight.

    python tools/draw_eight.py
"""

from pathlib import Path

import matplotlib as mpl
from matplotlib.figure import Figure

import ftseries as fts
from ftseries.figures import figure_eight, style

PATH = Path(__file__).parents[1] / "book" / "assets" / "eight.svg"


def draw(path=PATH):
    """Write the picture to ``path``; the same bytes each time."""
    sol = fts.solve(fts.FigureEight(), order=200, arithmetic="float")
    lam = fts.figure_eight.closure_zero(sol)
    with style.context(), mpl.rc_context({"svg.hashsalt": "eight"}):
        fig = Figure(figsize=(6.4, 2.6))
        figure_eight.emblem(fig.subplots(), lambda t: fts.figure_eight.positions(sol, t, lam))
        fig.savefig(path, metadata={"Date": None, "Creator": None})


if __name__ == "__main__":
    draw()
