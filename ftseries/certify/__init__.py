"""Proofs by computer, on the ball arithmetic of FLINT.

Each theorem is one call that returns what was proved, or raises :class:`NotProved`.  It can be
saved as a certificate, which :func:`check` proves again with other code.
"""

from .algebra import Enclosure, NotProved
from .checking import check
from .cubic import CubicTheorem, cubic_bound
from .eight import EightTheorem, prove_eight
from .mathieu import EigenvalueTheorem, mathieu_eigenvalue
from .newton_kantorovich import Bounds, radius

__all__ = ["Bounds", "CubicTheorem", "EightTheorem", "EigenvalueTheorem", "Enclosure", "NotProved",
           "check", "cubic_bound", "mathieu_eigenvalue", "prove_eight", "radius"]
