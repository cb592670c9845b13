r"""The limit cycle of van der Pol, x″ + x = ε (1 - x²) x′, by integration.

Formula.  A motion that starts at rest at x = a > 0 comes to rest half an oscillation later at
x = -b(a).  The equation does not change under x → -x, so the cycle is the solution of b(a) = a, and
consists of this half and its mirror image.  The phase τ = ωt is counted so that

.. math::  \int_0^{2π} x \sin τ \, dτ = 0, \qquad \int_0^{2π} x \cos τ \, dτ > 0.

The step from a to b(a) is integrated by the Runge-Kutta method of Dormand and Prince of order 8.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import root_scalar

from ftseries.aliases import ArrayLike
from ftseries.arguments import real, scalar
from ftseries.errors import InputError

__all__ = ["LimitCycle"]

LARGEST = 20.0
_POINTS = 2048                       # over half a period; the mean by the trapezoidal rule


class LimitCycle:
    """The periodic motion for one ε.

    Parameters
    ----------
    eps : float
        ε, from 0 to 20; 0 is the limit, the circle of radius 2.

    Attributes
    ----------
    omega : float
        The frequency.
    amplitude : float
        The largest x.

    Examples
    --------
    >>> cycle = LimitCycle(1.0)
    >>> round(cycle.omega, 10), round(cycle.amplitude, 10)
    (0.9429558474, 2.0086198609)
    """

    def __init__(self, eps: float) -> None:
        self.eps = scalar("eps", eps)
        if not 0 <= self.eps <= LARGEST:
            raise InputError(f"eps={eps!r}: give a number from 0 to {LARGEST:g}")
        self.amplitude = 2.0 if self.eps == 0 else float(root_scalar(
            lambda a: a + self._half(a).y[0, -1], x0=2.0, x1=2.02, xtol=1e-14).root)
        self._path = self._half(self.amplitude)
        self.omega = float(np.pi / self._path.t[-1])
        tau = np.pi * np.arange(_POINTS) / _POINTS
        self._start = 0.0
        self._start = float(np.angle(np.mean(self(tau) * np.exp(-1j * tau))))

    def __repr__(self) -> str:
        return f"<limit cycle at ε = {self.eps:g}, ω = {self.omega:.10g}>"

    def __call__(self, tau: ArrayLike) -> Any:
        """x at phases τ."""
        return self._at(tau)[0]

    def speed(self, tau: ArrayLike) -> Any:
        """dx/dt at phases τ."""
        return self._at(tau)[1]

    def _at(self, tau: ArrayLike) -> Any:
        halves, rest = np.divmod(real("tau", tau) - self._start, np.pi)
        return (-1) ** (halves % 2) * self._path.sol(rest.ravel() / self.omega).reshape(
            2, *rest.shape)

    def _half(self, a: float) -> Any:
        def rest(t: float, q: Any) -> Any:
            return q[1]
        rest.terminal, rest.direction = True, 1  # type: ignore[attr-defined]   # for SciPy
        return solve_ivp(lambda t, q: [q[1], self.eps * (1 - q[0]**2) * q[1] - q[0]],
                         (0, 10 + 2 * self.eps), [a, -1e-300], events=rest, dense_output=True,
                         method="DOP853", rtol=1e-13, atol=1e-14)
