"""What a sequence of Taylor coefficients says of its function; no Fourier sums, no problems.

:mod:`~ftseries.analysis.singularities` finds the nearest singularities, their type and the radius
of convergence; :mod:`~ftseries.analysis.pade` sums beyond it; :mod:`~ftseries.analysis.maps`
changes the variable.
"""

from .maps import compose, euler_map, revert
from .pade import Pade, pade
from .singularities import (
    Estimate,
    FewError,
    Singularity,
    certain,
    domb_sykes,
    nearest_singularities,
    root_test,
    thin,
)

__all__ = ["Estimate", "FewError", "Pade", "Singularity", "certain", "compose", "domb_sykes",
           "euler_map", "nearest_singularities", "pade", "revert", "root_test", "thin"]
