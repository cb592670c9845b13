r"""The monodromy matrix of a linear equation with periodic coefficients, and its error.

Formula.  A disturbance Y obeys the variational equation Y' = A(t) Y with A(t + T) = A(t).  With
Y(0) = 1 the matrix M = Y(T) is the *monodromy matrix*; after k periods a disturbance is M^k times
the first.  Its eigenvalues ρ are the (characteristic) *multipliers*, log ρ / T the exponents, and
for ρ = exp(2πiν) on the unit circle ν is the *rotation number*.  In a mechanical system M is
symplectic: M^T J M = J, det M = 1.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from ..aliases import Array, ComplexArray
from ..arguments import scalar
from ..errors import InputError

__all__ = ["Monodromy", "monodromy", "safe", "symplectic"]

_FINE, _COARSE = 3e-14, 3e-13                # relative tolerances; DOP853 takes none below 2.3e-14


@dataclass(frozen=True, eq=False)
class Monodromy:
    """A monodromy matrix with its error.

    Attributes
    ----------
    matrix : numpy.ndarray
    period : float
        T, in the equation's independent variable.
    error : float
        Largest change of an entry when the integrator's tolerance is relaxed tenfold, or the
        departure from symplecticity, whichever is larger: an estimate on the safe side.
    """

    matrix: np.ndarray
    period: float
    error: float

    @property
    def multipliers(self) -> ComplexArray:
        """All eigenvalues, sorted by angle; in a Jordan block they lose half of their digits."""
        values = np.linalg.eigvals(self.matrix)
        return values[np.argsort(np.angle(values))]

    @property
    def determinant(self) -> float:
        """1 in exact arithmetic (Liouville's theorem)."""
        return float(np.linalg.det(self.matrix))


def monodromy(linear: Callable[[float], Array], period: float, size: int) -> tuple[Array, Array]:
    """The monodromy matrix of Y' = linear(t) Y by the Runge-Kutta method DOP853.

    Parameters
    ----------
    linear : callable
        t to the matrix A(t), of shape (size, size).
    period : float
        T > 0.
    size : int

    Returns
    -------
    tuple
        (M, the changes of its entries when the tolerance is relaxed tenfold).

    Examples
    --------
    >>> turn = np.array([[0, 1], [-1, 0]])
    >>> m, change = monodromy(lambda t: turn, np.pi / 2, 2)
    >>> np.allclose(m, turn, rtol=0, atol=1e-12), bool(change.max() < 1e-11)
    (True, True)
    """
    period = scalar("period", period)
    if period <= 0:
        raise InputError(f"period={period:g}: give a positive number")

    def run(tolerance: float) -> Any:
        path = solve_ivp(lambda t, y: (linear(t) @ y.reshape(size, size)).ravel(), (0, period),
                         np.eye(size).ravel(), "DOP853", rtol=tolerance, atol=tolerance / 10)
        if not path.success:
            raise InputError(f"the variational equation cannot be integrated: {path.message}")
        return path.y[:, -1].reshape(size, size)

    fine = run(_FINE)
    return fine, np.abs(fine - run(_COARSE))


def symplectic(size: int) -> Array:
    """J, for positions followed by momenta."""
    half = np.eye(size // 2)
    return np.block([[0 * half, half], [-half, 0 * half]])


def safe(matrix: Array, change: Array) -> float:
    """The largest change, or the departure of M^T J M from J if that is larger."""
    j = symplectic(len(matrix))
    return float(max(change.max(), np.abs(matrix.T @ j @ matrix - j).max()))
