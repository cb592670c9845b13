r"""Bands, gaps and edges of Hill's equation (M1), ψ'' = (-a + λ² cos 2x + λ⁴ μ cos 4x) ψ.

Formula.  M is the monodromy matrix of (ψ, ψ') over π, and D = tr M the discriminant.  |D| < 2 is a
band, where all solutions are bounded; |D| > 2 a gap, where they grow exponentially; |D| = 2 an
edge, with a periodic solution.  Differentiating Y' = A Y by a gives dM/da, hence dD/da.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..aliases import Array, ArrayLike, Real
from ..arguments import scalars
from ..errors import InputError
from .variation import Monodromy, monodromy, safe

__all__ = ["Hill", "hill"]

_EDGE = 4                                    # |D| - 2 below so many errors is not told from zero


@dataclass(frozen=True, eq=False)
class Hill(Monodromy):
    """Monodromy of (M1) in ψ, ψ'; ``slope`` is the derivative of the matrix by the eigenvalue a."""

    slope: np.ndarray

    @property
    def discriminant(self) -> float:
        """D = tr M: below 2 in modulus inside a band, above in a gap, ±2 on an edge."""
        return float(np.trace(self.matrix))

    @property
    def discriminant_slope(self) -> float:
        """dD/da."""
        return float(np.trace(self.slope))

    @property
    def place(self) -> str:
        """"band", "gap", or "edge" if |D| cannot be told from 2 within the error."""
        excess = abs(self.discriminant) - 2
        if abs(excess) <= _EDGE * self.error:
            return "edge"
        return "gap" if excess > 0 else "band"

    @property
    def rate(self) -> float:
        """Real part σ of the exponent, per unit of x: a solution grows like exp(σx) in a gap."""
        return float(np.arccosh(max(abs(self.discriminant) / 2, 1)) / self.period)

    @property
    def angle(self) -> float:
        """Turn θ of the beating in a band, from the nearer edge, in radians per unit of x."""
        return float(np.arccos(min(abs(self.discriminant) / 2, 1)) / self.period)

    def departure(self, k: ArrayLike) -> Real:
        """After k periods, the departure of the solution that would be periodic at the edge.

        Relative to it, to leading order in the distance from the edge: cosh(kσT) - 1 in a gap,
        1 - cos(kθT) in a band; both begin with the square of k.
        """
        k = np.asarray(k) * self.period
        return np.cosh(k * self.rate) - np.cos(k * self.angle)

    @property
    def jordan(self) -> Any:
        """At an edge: M ∓ 1, which is zero or nilpotent; elsewhere None."""
        if self.place != "edge":
            return None
        return self.matrix - np.sign(self.discriminant) * np.eye(2)


def hill(a: float, lam: float, mu: float = 0.0, period: float = np.pi) -> Hill:
    """The monodromy of ψ'' = (-a + λ² cos 2x + λ⁴ μ cos 4x) ψ over π, or a multiple of it.

    Examples
    --------
    Without a potential M is the turn by √a π; a = 4 is an edge at which the gap is closed, M = 1:

    >>> round(hill(0.25, lam=0).discriminant, 12) + 0.0, hill(0.25, lam=0).place
    (0.0, 'band')
    >>> at = hill(4, lam=0)
    >>> at.place, np.allclose(at.jordan, 0, rtol=0, atol=1e-11)
    ('edge', True)
    """
    a, lam, mu, period = scalars({"a": a, "lam": lam, "mu": mu, "period": period}).values()
    turns = round(period / np.pi)
    if turns < 1 or abs(period / np.pi - turns) > 1e-12:
        raise InputError(f"period={period:g}: give π or a multiple of it")

    block = np.zeros((4, 4))                 # of (Y, dY/da): the second is driven by the first
    block[0, 1], block[2, 3], block[3, 0] = 1, 1, -1

    def linear(x: float) -> Array:
        block[1, 0] = block[3, 2] = (-a + lam**2 * math.cos(2 * x)
                                     + lam**4 * mu * math.cos(4 * x))
        return block

    both, change = monodromy(linear, period, 4)
    matrix = both[:2, :2]
    return Hill(matrix, period, safe(matrix, change[:2, :2]), both[2:, :2])
