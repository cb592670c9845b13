r"""Floquet theory: what becomes of a small disturbance of a periodic solution.

Formula.  A disturbance Y obeys the variational equation Y' = A(t) Y with A(t + T) = A(t).  With
Y(0) = 1 the matrix M = Y(T) is the *monodromy matrix*; after k periods a disturbance is M^k times
the first.  Its eigenvalues ρ are the (characteristic) *multipliers*, log ρ / T the exponents, and
for ρ = exp(2πiν) on the unit circle ν is the *rotation number*.

Here A comes from Hill's equation (M1), or from Newton's equations (E0) along positions that are
given, for instance by a Fourier-Taylor series.  In both cases M is symplectic: M^T J M = J, det = 1.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import eig, null_space, orth

from .errors import InputError
from .trig import finite

__all__ = ["Monodromy", "Hill", "Bodies", "monodromy", "hill", "bodies"]

_FINE, _COARSE = 3e-14, 3e-13                # relative tolerances; DOP853 takes none below 2.3e-14
_SAMPLES = 512                               # of the positions over one period
_EDGE = 4                                    # |D| - 2 below so many errors is not told from zero


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
    def multipliers(self):
        """All eigenvalues, sorted by angle; in a Jordan block they lose half of their digits."""
        values = np.linalg.eigvals(self.matrix)
        return values[np.argsort(np.angle(values))]

    @property
    def determinant(self):
        """1 in exact arithmetic (Liouville's theorem)."""
        return float(np.linalg.det(self.matrix))


def monodromy(linear, period, size):
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
    period = float(finite("period", period))
    if period <= 0:
        raise InputError(f"period={period:g}: give a positive number")

    def run(tolerance):
        path = solve_ivp(lambda t, y: (linear(t) @ y.reshape(size, size)).ravel(), (0, period),
                         np.eye(size).ravel(), "DOP853", rtol=tolerance, atol=tolerance / 10)
        if not path.success:
            raise InputError(f"the variational equation cannot be integrated: {path.message}")
        return path.y[:, -1].reshape(size, size)

    fine = run(_FINE)
    return fine, np.abs(fine - run(_COARSE))


def _symplectic(size):
    """J, for positions followed by momenta."""
    half = np.eye(size // 2)
    return np.block([[0 * half, half], [-half, 0 * half]])


def _safe(matrix, change):
    """The largest change, or the departure of M^T J M from J if that is larger."""
    j = _symplectic(len(matrix))
    return float(max(change.max(), np.abs(matrix.T @ j @ matrix - j).max()))


@dataclass(frozen=True, eq=False)
class Hill(Monodromy):
    """Monodromy of (M1) in ψ, ψ'; ``slope`` is the derivative of the matrix by the eigenvalue a."""

    slope: np.ndarray

    @property
    def discriminant(self):
        """D = tr M: below 2 in modulus inside a band, above in a gap, ±2 on an edge."""
        return float(np.trace(self.matrix))

    @property
    def discriminant_slope(self):
        """dD/da."""
        return float(np.trace(self.slope))

    @property
    def place(self):
        """"band", "gap", or "edge" if |D| cannot be told from 2 within the error."""
        excess = abs(self.discriminant) - 2
        if abs(excess) <= _EDGE * self.error:
            return "edge"
        return "gap" if excess > 0 else "band"

    @property
    def rate(self):
        """Real part σ of the exponent, per unit of x: a solution grows like exp(σx) in a gap."""
        return float(np.arccosh(max(abs(self.discriminant) / 2, 1)) / self.period)

    @property
    def angle(self):
        """Turn θ in radians per unit of x of the beating in a band, measured from the nearer edge."""
        return float(np.arccos(min(abs(self.discriminant) / 2, 1)) / self.period)

    def departure(self, k):
        """After k periods, the departure of the solution that would be periodic at the edge.

        Relative to it, to leading order in the distance from the edge: cosh(kσT) - 1 in a gap,
        1 - cos(kθT) in a band; both begin with the square of k.
        """
        k = np.asarray(k) * self.period
        return np.cosh(k * self.rate) - np.cos(k * self.angle)

    @property
    def jordan(self):
        """At an edge: M ∓ 1, which is zero or nilpotent; elsewhere None."""
        if self.place != "edge":
            return None
        return self.matrix - np.sign(self.discriminant) * np.eye(2)


def hill(a, lam, mu=0.0, period=np.pi):
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
    a, lam, mu = (float(finite(key, v)) for key, v in (("a", a), ("lam", lam), ("mu", mu)))
    if round(period / np.pi) < 1 or abs(period / np.pi - round(period / np.pi)) > 1e-12:
        raise InputError(f"period={period:g}: give π or a multiple of it")

    block = np.zeros((4, 4))                 # of (Y, dY/da): the second is driven by the first
    block[0, 1], block[2, 3], block[3, 0] = 1, 1, -1

    def linear(x):
        block[1, 0] = block[3, 2] = (-a + lam**2 * math.cos(2 * x)
                                     + lam**4 * mu * math.cos(4 * x))
        return block

    both, change = monodromy(linear, period, 4)
    matrix = both[:2, :2]
    return Hill(matrix, float(period), _safe(matrix, change[:2, :2]), both[2:, :2])


@dataclass(frozen=True, eq=False)
class Bodies(Monodromy):
    """Monodromy of n bodies of mass 1 in the plane, in x_1, y_1, …, x_n, y_n and their velocities.

    Attributes
    ----------
    symmetries : numpy.ndarray
        Four columns e with M e = e: shifts along x and y, shift of time, rotation.
    scaling : numpy.ndarray
        The disturbance w = (2r, -v) towards other sizes: by Kepler's third law M w = w - 3T e_time.
    defect : float
        Largest entry of M e - e over the symmetries; zero along a solution of Newton's equations.
    """

    symmetries: np.ndarray
    scaling: np.ndarray
    defect: float

    @property
    def basis(self):
        """Orthonormal columns: disturbances that change no integral, without the symmetries.

        The gradients of momentum, energy and angular momentum are the (J e)^T, left eigenvectors
        of M; the columns span their common kernel up to the e.
        """
        forced = orth(self.symmetries)
        kernel = null_space((_symplectic(len(self.matrix)) @ forced).T)
        return kernel @ null_space(forced.T @ kernel, rcond=1e-6)

    @property
    def essential(self):
        """M on `basis`, modulo the symmetries: 4 × 4 for the eight, free of Jordan blocks."""
        return self.basis.T @ self.matrix @ self.basis

    def rotation_numbers(self):
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


def bodies(positions, period=2 * np.pi):
    """The monodromy of Newton's variational equations along a periodic motion.

    Parameters
    ----------
    positions : callable
        Times of shape (N,) to complex x + iy of shape (n, N): n bodies of mass 1, smooth, periodic.
    period : float

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
    samples = np.asarray(positions(float(finite("period", period)) * np.arange(_SAMPLES) / _SAMPLES))
    if samples.ndim != 2 or samples.shape[-1] != _SAMPLES or not np.isfinite(samples).all():
        raise InputError("positions(t) must be finite complex numbers of shape (bodies,) + t.shape")
    modes = np.fft.fft(samples) / _SAMPLES
    size = np.abs(modes).max()
    if np.abs(modes[:, _SAMPLES // 3:-_SAMPLES // 3]).max() > 1e-11 * size:
        raise InputError("positions are not smooth and periodic over this period: their Fourier "
                         f"coefficients do not end before order {_SAMPLES // 3}")
    keep = np.abs(modes).max(axis=0) > 1e-17 * size
    modes, rate = modes[:, keep], (2j * np.pi / period) * np.fft.fftfreq(_SAMPLES, 1 / _SAMPLES)[keep]
    if np.abs(samples[:, None] - samples)[~np.eye(len(samples), dtype=bool)].min() < 1e-6 * size:
        raise InputError("two of the bodies meet: Newton's force is infinite there")

    n = 2 * len(modes)
    block = np.block([[np.zeros((n, n)), np.eye(n)], [np.zeros((n, 2 * n))]])

    def linear(t):
        block[n:, :n] = _tidal(modes @ np.exp(rate * t))
        return block

    matrix, change = monodromy(linear, period, 2 * n)
    r, v, force = (modes @ rate**k for k in range(3))
    one = np.ones_like(r)
    symmetries = np.stack([_state(one, 0 * r), _state(1j * one, 0 * r), _state(v, force),
                           _state(1j * r, 1j * v)], axis=1)
    return Bodies(matrix, float(period), _safe(matrix, change), symmetries, _state(2 * r, -v),
                  float(np.abs(matrix @ symmetries - symmetries).max()))


def _state(position, velocity):
    return np.concatenate([position, velocity]).view(float)


def _tidal(r):
    """The matrix of derivatives of the accelerations by the positions."""
    u = r[:, None] - r
    np.fill_diagonal(u, 1)
    part = np.stack([u.real, u.imag], axis=-1)
    pull = (np.eye(2) - 3 * part[..., :, None] * part[..., None, :] / np.abs(u[..., None, None])**2
            ) / np.abs(u[..., None, None])**3
    pull[np.diag_indices(len(r))] = 0
    pull[np.diag_indices(len(r))] = -pull.sum(axis=1)
    return pull.swapaxes(1, 2).reshape(2 * len(r), -1)
