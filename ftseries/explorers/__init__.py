"""Explorers: pictures that move with their sliders, in a notebook and in the built page alike.

Each function returns an ipywidgets layout to be shown by the cell that calls it.  The browser
evaluates the series itself, so an explorer works with no kernel, no server and no network.
"""

from .coefficients import coefficients
from .convergence import convergence
from .cubic import cubic
from .figure_eight import figure_eight
from .mathieu import mathieu
from .stability import stability

__all__ = ["coefficients", "convergence", "cubic", "figure_eight", "mathieu", "stability"]
