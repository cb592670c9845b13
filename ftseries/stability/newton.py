r"""Newton's variational equations along a periodic motion of equal masses in the plane.

Formula.  With r_ij = r_i - r_j = d e, |e| = 1, and η_ij = η_i - η_j a disturbance η of a motion r
under an attraction F(d) between each two bodies, F = d^{-2} in (E0), obeys

.. math::  \ddot η_i = \sum_{j \ne i} \left( -\frac{F(d)}{d}\, η_{ij}
           + \Big( \frac{F(d)}{d} - F'(d) \Big) (e · η_{ij})\, e \right).

Each symmetry gives an eigenvector e of the monodromy matrix, M e = e, and its conserved quantity
the left eigenvector (J e)^T: eight multipliers 1, in Jordan blocks.  They are split off first.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from scipy.linalg import eig, null_space, orth

from ..aliases import Array, ComplexArray
from ..arguments import scalar
from ..errors import InputError
from .variation import Monodromy, monodromy, safe, symplectic

__all__ = ["Bodies", "bodies"]

#: an attraction as a function of the distance
Force: TypeAlias = Callable[[Any], Any]

_SAMPLES = 512                               # of the positions over one period


@dataclass(frozen=True, eq=False)
class Bodies(Monodromy):
    """Monodromy of n bodies of mass 1 in the plane, in x_1, y_1, …, x_n, y_n and their velocities.

    Attributes
    ----------
    symmetries : numpy.ndarray
        Four columns e with M e = e: shifts along x and y, shift of time, rotation.
    scaling : numpy.ndarray
        The disturbance towards other sizes where F(d) is a power d^{-(α+1)}: w = (2r, -αv), and
        Kepler's third law is M w = w - (α+2) T e_time.
    defect : float
        Largest entry of M e - e over the symmetries; zero along a solution of Newton's equations.
    """

    symmetries: np.ndarray
    scaling: np.ndarray
    defect: float

    @property
    def basis(self) -> Any:
        """Orthonormal columns: disturbances that change no integral, without the symmetries.

        The gradients of momentum, energy and angular momentum are the (J e)^T, left eigenvectors
        of M; the columns span their common kernel up to the e.
        """
        forced = orth(self.symmetries, rcond=1e-6)
        kernel = null_space((symplectic(len(self.matrix)) @ forced).T)
        return kernel @ null_space(forced.T @ kernel, rcond=1e-6)

    @property
    def essential(self) -> Any:
        """M on `basis`, modulo the symmetries: 4 × 4 for the eight, free of Jordan blocks."""
        return self.basis.T @ self.matrix @ self.basis

    def rotation_numbers(self) -> tuple[Array, Array]:
        """(ν, errors): 0 ≤ ν ≤ 1/2 of the essential multipliers exp(±2πiν), ascending.

        The error is the multipliers' condition number times ``error`` and ``defect``.

        Raises
        ------
        InputError
            A multiplier lies off the unit circle by more than its error: the orbit is unstable.
        """
        values, left, right = eig(self.essential, left=True)
        condition = 1 / np.abs((left.conj() * right).sum(axis=0))
        errors = condition * (self.error + self.defect)
        if np.any(np.abs(np.abs(values) - 1) > errors):
            raise InputError(f"multipliers {np.round(values, 6)} lie off the unit circle: the "
                             "orbit is unstable and has no rotation numbers; see essential")
        turn = np.abs(np.angle(values)) / (2 * np.pi)
        order = np.argsort(turn)[::2]
        return turn[order], errors[order] / (2 * np.pi)


def gravity(distance: Any) -> Any:
    """Newton's attraction between two bodies of mass 1."""
    return distance**-2


def bodies(positions: Callable[[Array], ComplexArray], period: float = 2 * np.pi,
           force: Force = gravity) -> Bodies:
    """The monodromy of Newton's variational equations along a periodic motion.

    Parameters
    ----------
    positions : callable
        Times of shape (N,) to complex x + iy of shape (n, N): n bodies of mass 1, smooth, periodic.
    period : float
    force : callable
        The attraction F as a function of the distance, analytic: it is called with complex arrays.

    Raises
    ------
    InputError
        The motion has more Fourier modes than can be told apart, or two bodies meet.

    Examples
    --------
    >>> import ftseries as fts
    >>> orbit = fts.solve(fts.FigureEight(), order=6).refine()
    >>> m = bodies(lambda t: fts.figure_eight.positions(orbit, t, orbit.lam))
    >>> m.rotation_numbers()[0].round(8)                            # both real: linearly stable
    array([0.00842272, 0.29809253])
    """
    period = scalar("period", period)
    samples = np.asarray(positions(period * np.arange(_SAMPLES) / _SAMPLES))
    if (samples.ndim != 2 or len(samples) < 2 or samples.shape[-1] != _SAMPLES
            or not np.isfinite(samples).all()):
        raise InputError("positions(t) must be finite complex numbers of shape (bodies,) + t.shape"
                         " for two bodies or more")
    modes = np.fft.fft(samples) / _SAMPLES
    size = np.abs(modes).max()
    if np.abs(modes[:, _SAMPLES // 3:-_SAMPLES // 3]).max() > 1e-11 * size:
        raise InputError("positions are not smooth and periodic over this period: their Fourier "
                         f"coefficients do not end before order {_SAMPLES // 3}")
    keep = np.abs(modes).max(axis=0) > 1e-17 * size
    modes, rate = modes[:, keep], 2j * np.pi * np.fft.fftfreq(_SAMPLES, period / _SAMPLES)[keep]
    if np.abs(samples[:, None] - samples)[~np.eye(len(samples), dtype=bool)].min() <= 1e-6 * size:
        raise InputError("two of the bodies meet: the force has no direction there")

    n = 2 * len(modes)
    block = np.block([[np.zeros((n, n)), np.eye(n)], [np.zeros((n, 2 * n))]])

    def linear(t: float) -> Array:
        block[n:, :n] = _tidal(modes @ np.exp(rate * t), force)
        return block

    matrix, change = monodromy(linear, period, 2 * n)
    r, v, acceleration = (modes @ rate**k for k in range(3))
    one = np.ones_like(r)
    alpha = -1 - _slope(force, 1.0) / force(1.0)
    symmetries = np.stack([_state(one, 0 * r), _state(1j * one, 0 * r), _state(v, acceleration),
                           _state(1j * r, 1j * v)], axis=1)
    return Bodies(matrix, period, safe(matrix, change), symmetries, _state(2 * r, -alpha * v),
                  float(np.abs(matrix @ symmetries - symmetries).max()))


def _state(position: ComplexArray, velocity: ComplexArray) -> Array:
    return np.concatenate([position, velocity]).view(float)


def _slope(force: Force, distance: Any) -> Any:
    """F', without cancellation."""
    return np.imag(force(distance + 1e-30j)) / 1e-30


def _tidal(r: ComplexArray, force: Force) -> Any:
    """The matrix of derivatives of the accelerations by the positions."""
    u = r[:, None] - r
    np.fill_diagonal(u, 1)
    d = np.abs(u)[..., None, None]
    e = np.stack([u.real, u.imag], axis=-1) / d[..., 0]
    along = e[..., :, None] * e[..., None, :]
    pull = force(d) / d * (np.eye(2) - along) + _slope(force, d) * along
    pull[np.diag_indices(len(r))] = 0
    pull[np.diag_indices(len(r))] = -pull.sum(axis=1)
    return pull.swapaxes(1, 2).reshape(2 * len(r), -1)
