"""House style of the pictures: readable on white and on dark pages, and by colour-blind readers.

The background is transparent, text and axes are of a middle grey. Lines take the four colours of
Okabe and Ito's palette that stand out from white and from the dark page alike, each with a line
style of its own, so that no picture depends on colour alone.
"""

from __future__ import annotations

from typing import Any

import matplotlib as mpl
from cycler import cycler

__all__ = ["VERMILION", "BLUE", "GREEN", "PURPLE", "COLOURS", "BODIES", "LINES", "GREY", "RC",
           "use", "context"]

VERMILION, BLUE, GREEN, PURPLE = COLOURS = ("#D55E00", "#0072B2", "#009E73", "#CC79A7")
#: the bodies 1, 2, 3, in every picture and explorer
BODIES = (VERMILION, BLUE, GREEN)
#: line styles that go with the colours, in the same order
LINES = ("-", (0, (5, 2)), (0, (1, 1.3)), (0, (6, 1.5, 1, 1.5)))
#: text, axes, ticks, thin lines that guide the eye
GREY = "#777777"
_PANE = (0.47, 0.47, 0.47, 0.08)

#: Matplotlib's parameters for every picture
RC: dict[Any, Any] = {
    "figure.figsize": (6.4, 4.0),
    "figure.dpi": 150,
    "figure.facecolor": "none",
    "figure.constrained_layout.use": True,
    "savefig.facecolor": "none",
    "savefig.dpi": "figure",
    "axes.facecolor": "none",
    "axes.edgecolor": GREY,
    "axes.labelcolor": GREY,
    "axes.titlecolor": GREY,
    "axes.prop_cycle": cycler(color=COLOURS) + cycler(linestyle=LINES),
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.formatter.limits": (-3, 4),
    "axes.formatter.use_mathtext": True,
    "axes3d.xaxis.panecolor": _PANE,
    "axes3d.yaxis.panecolor": _PANE,
    "axes3d.zaxis.panecolor": _PANE,
    "font.size": 11,
    "grid.color": GREY,
    "grid.alpha": 0.3,
    "image.cmap": "cividis",
    "legend.frameon": False,
    "legend.handlelength": 2.8,
    "lines.linewidth": 2.0,
    "text.color": GREY,
    "xtick.color": GREY,
    "ytick.color": GREY,
}


def use() -> None:
    """Draw all later figures of this session in the house style; a notebook's first step.

    >>> use()
    >>> mpl.rcParams["axes.edgecolor"] == GREY
    True
    >>> mpl.rcdefaults()
    """
    mpl.rcParams.update(RC)


def context() -> Any:
    """The house style inside a ``with`` block only.

    >>> with context():
    ...     mpl.rcParams["figure.facecolor"]
    'none'
    """
    return mpl.rc_context(RC)
