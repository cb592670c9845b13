"""Proofs by computer, on the ball arithmetic of FLINT.

Each theorem is one call that returns what was proved, or raises :class:`NotProved`.  It can be
saved as a certificate, which :func:`check` proves again with other code.
"""

from .algebra import Enclosure
from .balls import NotProved
from .checking import check
from .convergence import ConvergenceTheorem, prove_convergence
from .cubic import CubicTheorem, cubic_bound
from .digits import EightDigits, digits, load_digits, thousand_digits
from .eight import EightTheorem, prove_eight
from .mathieu import EigenvalueTheorem, mathieu_eigenvalue
from .newton_kantorovich import Bounds, radius

__all__ = ["Bounds", "ConvergenceTheorem", "CubicTheorem", "EigenvalueTheorem", "EightDigits",
           "EightTheorem", "Enclosure", "NotProved", "check", "cubic_bound", "digits",
           "load_digits", "mathieu_eigenvalue", "prove_convergence", "prove_eight", "radius",
           "thousand_digits"]
