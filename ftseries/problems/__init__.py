"""The problems of the paper, each declared the way its section states it."""

from .cubic import CubicOscillator
from .figure_eight import FigureEight
from .mathieu import GeneralizedMathieu

__all__ = ["CubicOscillator", "GeneralizedMathieu", "FigureEight"]
