r"""Floquet theory: what becomes of a small disturbance of a periodic solution.

`hill` treats Hill's equation (M1), `bodies` Newton's equations (E0) along positions that are given,
for instance by a Fourier-Taylor series; `monodromy` any linear equation with periodic coefficients.
"""

from .hills_equation import Hill, hill
from .newton import Bodies, bodies
from .variation import Monodromy, monodromy

__all__ = ["Monodromy", "monodromy", "Hill", "hill", "Bodies", "bodies"]
