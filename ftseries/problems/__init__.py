"""The problems of the paper, each declared the way its section states it, and their relatives."""

from .cubic import CubicOscillator
from .figure_eight import FigureEight, LemniscateEight, PlanarEight
from .mathieu import GeneralizedMathieu

__all__ = ["CubicOscillator", "GeneralizedMathieu", "FigureEight", "LemniscateEight",
           "PlanarEight"]
