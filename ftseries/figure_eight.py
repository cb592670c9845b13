"""The figure eight in one place: the three bodies, the closure, and its certified digits."""

from .certify.digits import digits, load_digits, thousand_digits
from .problems.figure_eight import FigureEight, closure, closure_zero, positions, relative

__all__ = ["FigureEight", "closure", "closure_zero", "digits", "load_digits", "positions",
           "relative", "thousand_digits"]
