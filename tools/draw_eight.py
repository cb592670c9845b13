"""Draw the picture of the README: three bodies on the eight, book/assets/eight.svg.

    python tools/draw_eight.py
"""

from pathlib import Path

import matplotlib as mpl
import matplotlib.pyplot as plt

import ftseries as fts
from ftseries.figures import figure_eight, style

PATH = Path(__file__).parents[1] / "book" / "assets" / "eight.svg"


def draw(path=PATH):
    sol = fts.solve(fts.FigureEight(), order=200, arithmetic="float")
    lam = fts.figure_eight.closure_zero(sol)
    mpl.use("svg")
    with style.context(), mpl.rc_context({"svg.hashsalt": "eight"}):
        fig, ax = plt.subplots(figsize=(6.4, 2.6))
        figure_eight.emblem(ax, lambda t: fts.figure_eight.positions(sol, t, lam))
        fig.savefig(path, metadata={"Date": None, "Creator": None})
        plt.close(fig)


if __name__ == "__main__":
    draw()
