"""Explorers: pictures that move with their sliders, in a notebook and in the built page alike.

Each function returns an ipywidgets layout to be shown by the cell that calls it.  The browser
evaluates the series itself, so an explorer works with no kernel, no server and no network.
"""

from .bands import bands
from .closing import closing
from .coefficients import coefficients
from .convergence import convergence
from .cubic import cubic
from .figure_eight import figure_eight
from .force_exponent import force_exponent
from .mathieu import mathieu
from .stability import stability
from .van_der_pol import van_der_pol
from .wheels import wheels

__all__ = ["bands", "closing", "coefficients", "convergence", "cubic", "figure_eight",
           "force_exponent", "mathieu", "stability", "van_der_pol", "wheels"]
