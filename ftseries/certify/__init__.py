"""Proofs by computer, on the ball arithmetic of FLINT.

Each theorem is one call that returns what was proved, or raises :class:`NotProved`.
"""

from .algebra import Enclosure, NotProved
from .eight import EightTheorem, prove_eight
from .newton_kantorovich import Bounds, radius

__all__ = ["Bounds", "EightTheorem", "Enclosure", "NotProved", "prove_eight", "radius"]
