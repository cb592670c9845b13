"""Fourier-Taylor series: periodic solutions as Fourier series whose coefficients are Taylor series.

    import ftseries as fts
    sol = fts.solve(fts.CubicOscillator(a=1), order=24)
    sol.evaluate("x", 0.1, lam=0.5)

The method is that of H.-J. Schmidt and T. Bröcker, "Fourier-Taylor series for the figure eight
solution of the three body problem"; equation numbers in the docstrings are those of the paper.
"""

from . import figure_eight
from .errors import (
                     ContradictionError,
                     ConvergenceWarning,
                     FaultError,
                     FileError,
                     FTSeriesError,
                     InputError,
                     NonAnalyticError,
                     PrecisionError,
                     PrecisionWarning,
                     SolveError,
                     UndeterminedError,
)
from .problem import Field, Problem, Scalar
from .problems import CubicOscillator, FigureEight, GeneralizedMathieu
from .series import cos, exp, sin
from .solution import Solution, load
from .solver import solve
from .sweep import sweep
from .symbolic import Equations

__version__ = "0.1.0"

__all__ = ["solve", "sweep", "Solution", "load", "Problem", "Equations", "Field", "Scalar",
           "CubicOscillator", "GeneralizedMathieu", "FigureEight", "figure_eight", "sin", "cos",
           "exp", "FTSeriesError", "InputError", "NonAnalyticError", "SolveError",
           "UndeterminedError", "ContradictionError", "FaultError", "FileError",
           "PrecisionError", "ConvergenceWarning", "PrecisionWarning"]
