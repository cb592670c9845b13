"""Draw three bodies on the eight, for the README and the social cards, and the pages' icon.

    python tools/draw_eight.py
"""

from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

import ftseries as fts
from ftseries.figures import figure_eight, style

BOOK = Path(__file__).parents[1] / "book"
NAMELESS = {".svg": {"Date": None, "Creator": None}, ".png": {"Software": None}}


def draw(path=BOOK / "assets" / "eight.svg"):
    """Write the picture to ``path``; the same bytes each time."""
    with style.context():
        fig = Figure(figsize=(6.4, 2.6))
        figure_eight.emblem(fig.subplots(), positions)
        save(fig, path)


def draw_icon(path=BOOK / "static" / "icon.svg"):
    """Write a square with the leaning eight to ``path``."""
    fig = Figure(figsize=(1, 1), facecolor="none")
    ax = fig.add_axes((0.08, 0.08, 0.84, 0.84))
    orbit, bodies = positions(np.linspace(0, 2 * np.pi, 121))[2], positions(0.25)
    for z, look in ((orbit, {"lw": 6, "color": style.BLUE}),
                    (bodies, {"ls": "", "marker": "o", "ms": 14, "color": style.VERMILION})):
        z = z * np.exp(-0.25j * np.pi)
        ax.plot(z.real, z.imag, clip_on=False, **look)
    ax.set(aspect="equal")
    ax.set_axis_off()
    save(fig, path)


def positions(t):
    sol = fts.solve(fts.FigureEight(), order=200, arithmetic="float")
    return fts.figure_eight.positions(sol, t, fts.figure_eight.closure_zero(sol))


def save(fig, path):
    with mpl.rc_context({"svg.hashsalt": "eight"}):
        fig.savefig(path, metadata=NAMELESS[path.suffix])


if __name__ == "__main__":
    draw()
    draw(BOOK / "assets" / "eight.png")
    draw_icon()
