"""Explorers: pictures that move with their sliders, in a notebook and in the built page alike.

Each function returns an ipywidgets layout to be shown by the cell that calls it.  The browser
evaluates the series itself, so an explorer works with no kernel, no server and no network.
"""

from .alive import alive
from .bands import bands
from .closing import closing
from .coefficients import coefficients
from .convergence import convergence
from .cubic import cubic
from .figure_eight import figure_eight
from .force_exponent import force_exponent
from .mathieu import mathieu
from .rolling import rolling
from .secular import secular
from .stability import stability
from .van_der_pol import van_der_pol
from .wheels import wheels

__all__ = ["alive", "bands", "closing", "coefficients", "convergence", "cubic", "figure_eight",
           "force_exponent", "mathieu", "rolling", "secular", "stability", "van_der_pol",
           "wheels"]
