"""Newton's equations (E0) of three bodies of mass 1 in the plane, and two ways to integrate them.

Positions and velocities are complex numbers x + iy; the first axis, of length 3, numbers the
bodies, further axes are times. The gravitational constant is 1. With an `exponent` α other than 1
the force between two bodies at distance d is d^{-(α+1)} instead.

`integrate` is SciPy's Runge-Kutta method DOP853. `integrate_taylor` shares nothing with it: it
expands the motion in powers of time, in float64 or with any number of digits. For each pair let
u = r_i - r_j, s = |u|², w = s^p with p = -(α+2)/2, so that s w' = p s' w. The coefficients of t^k
follow from

    s_k = Σ u_j·u_{k-j},   w_k = 1/(k s_0) Σ_{j≥1} ((p + 1) j - k) s_j w_{k-j},
    (k + 1)(k + 2) r_{k+2} = -Σ w_j u_{k-j}, summed over both partners of a body.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
from scipy.integrate import solve_ivp

from ftseries.arguments import MOST_DPS, real, whole
from ftseries.errors import InputError
from ftseries.precision import working
from ftseries.references._digits import GUARD, number

__all__ = [
    "accelerations", "angular_momentum", "energy", "integrate", "integrate_taylor",
    "newton_residual",
]

TOLERANCES = {"rtol": 3e-14, "atol": 1e-16, "max_step": 0.02}  # of DOP853 and its dense output


def accelerations(positions: Any, exponent: float = 1) -> Any:
    """The right-hand sides of (E0), in the shape of `positions`.

    >>> accelerations(np.array([-1, 0, 1]))  # 1 + 1/4 towards the middle
    array([ 1.25,  0.  , -1.25])
    """
    u = _pairs(positions)
    pull = u / _apart(abs(u)) ** (exponent + 2)
    return np.roll(pull, 1, axis=0) - pull


def newton_residual(positions: Any, second_derivatives: Any) -> Any:
    """`second_derivatives` minus the right-hand sides of (E0): zero along a solution."""
    return np.asarray(second_derivatives) - accelerations(positions)


def energy(positions: Any, velocities: Any) -> Any:
    """½ Σ |v|² - Σ 1/r_ij.

    >>> float(energy([-1, 0, 1], [0, 0, 0]))
    -2.5
    """
    distances = _apart(abs(_pairs(positions)))
    return (abs(np.asarray(velocities)) ** 2).sum(0) / 2 - (1 / distances).sum(0)


def angular_momentum(positions: Any, velocities: Any) -> Any:
    """Σ (x v_y - y v_x).

    >>> float(angular_momentum([-1, 0, 1], [-2j, 0, 2j]))
    4.0
    """
    return (np.conj(positions) * np.asarray(velocities)).sum(0).imag


def integrate(t: Any, positions: Any, velocities: Any, exponent: float = 1) -> Any:
    """Positions and velocities at the real times t, in one array of shape (2, 3) + t.shape.

    `positions` and `velocities`, of shape (3,), hold at time 0; t may be negative. Steps are short
    and local errors near rounding.

    >>> turn = np.exp(2j * np.pi / 3) ** np.arange(3)  # Lagrange: ω² = 1/√3 at distance 1
    >>> r, v = integrate(1.0, turn, 1j * turn / 3**0.25)
    >>> np.allclose(r, turn * np.exp(1j / 3**0.25), rtol=0, atol=1e-13)
    True
    """
    def run(times: Any, start: Any) -> Any:
        if times[-1] == 0:
            return start[..., None]

        def slope(_: float, state: Any) -> Any:
            return np.concatenate([state[3:], accelerations(state[:3], exponent)])
        path = solve_ivp(slope, (0, times[-1]), start.ravel(), "DOP853", t_eval=times, **TOLERANCES)
        if not path.success:
            raise InputError(f"These bodies cannot be followed to the end: {path.message}")
        return path.y.reshape(2, 3, -1)
    return _both_directions(run, real("t", t), _state(positions, velocities).astype(complex))


def integrate_taylor(t: Any, positions: Any, velocities: Any, dps: int | None = None,
                     exponent: float = 1) -> Any:
    """The same by Taylor series; with `dps` to that many digits, in arrays of mpmath numbers.

    The order grows with the digits; the step follows from the last coefficients of each expansion.
    """
    if dps is None:
        state = _state(positions, velocities).astype(complex)
        return _both_directions(_taylor_run(24, 1e-18, exponent), real("t", t), state)
    with working(digits=whole("dps", dps, 1, MOST_DPS) + GUARD):
        run = _taylor_run(dps + 20, mpmath.mpf(10) ** -(dps + GUARD), exponent)
        times = _map(lambda x: number("t", x), t)
        return _both_directions(run, times, _map(mpmath.mpc, _state(positions, velocities)))


def _both_directions(run: Callable[[Any, Any], Any], t: Any, state: Any) -> Any:
    """`run` towards positive times and, with velocities reversed, towards negative ones."""
    values, flat = np.empty((2, 3, t.size), state.dtype), t.ravel()
    for sign, side in ((1, flat >= 0), (-1, flat < 0)):
        if np.any(side):
            mirror = np.array([1, sign])[:, None, None]
            times, back = np.unique(sign * flat[side], return_inverse=True)
            values[..., side] = mirror * run(times, mirror[..., 0] * state)[..., back]
    return values.reshape((2, 3, *t.shape))


def _taylor_run(order: int, tolerance: Any, exponent: float) -> Callable[[Any, Any], Any]:
    def run(times: Any, start: Any) -> Any:
        pieces, now = [], 0 * times[0]
        while True:
            c = _taylor_coefficients(start[0], start[1], order, exponent)
            last = [(k, max(abs(c[k]).flat)) for k in (order - 1, order)]
            step = min((tolerance / size) ** (1 / k) for k, size in last if size)
            if not step > 1e-9:
                raise InputError("These bodies cannot be followed to the end: two of them collide.")
            pieces.append(_horner(c, times[(now <= times) & (times < now + step)] - now))
            if times[-1] < now + step:
                return np.concatenate(pieces, axis=-1)
            start, now = _horner(c, np.array([step]))[..., 0], now + step
    return run


def _taylor_coefficients(positions: Any, velocities: Any, order: int, exponent: float) -> Any:
    """The coefficients of t^0, …, t^order, real, of shape (order + 1, 3, 2), from complex ones."""
    parts = np.array([[_REAL(z), _IMAG(z)] for z in (positions, velocities)]).swapaxes(1, 2)
    kind = float if positions.dtype == complex else object
    r, u = (np.zeros((order + 1, 3, 2), kind) for _ in range(2))
    s, w = (np.zeros((order + 1, 3), kind) for _ in range(2))
    r[:2] = parts
    p = -(exponent + 2) / 2
    for k in range(order - 1):
        u[k] = _pairs(r[k])
        s[k] = (u[: k + 1] * u[k::-1]).sum((0, 2))
        if k == 0:
            w[0] = _apart(s[0]) ** p
        else:
            j = np.arange(1, k + 1)[:, None]
            w[k] = (((p + 1) * j - k) * s[1 : k + 1] * w[:k][::-1]).sum(0) / (k * s[0])
        pull = (w[: k + 1, :, None] * u[k::-1]).sum(0)
        r[k + 2] = (np.roll(pull, 1, axis=0) - pull) / ((k + 1) * (k + 2))
    return r


def _horner(c: Any, t: Any) -> Any:
    """Positions and velocities at the times t of one expansion: complex, shape (2, 3) + t.shape."""
    value = slope = 0 * t
    for k in range(len(c) - 1, -1, -1):
        slope = slope * t + value
        value = value * t + c[k][..., None]
    return np.stack([part[:, 0] + 1j * part[:, 1] for part in (value, slope)])


def _pairs(positions: Any) -> Any:
    """r_12, r_23, r_31."""
    positions = np.asarray(positions)
    return positions - np.roll(positions, -1, axis=0)


def _apart(distances: Any) -> Any:
    if np.any(distances == 0):
        raise InputError("positions must be three different points: Newton's force is infinite.")
    return distances


def _state(positions: Any, velocities: Any) -> Any:
    if np.shape(positions) != (3,) or np.shape(velocities) != (3,):
        raise InputError("positions and velocities must each be three complex numbers.")
    state = np.array([positions, velocities])
    try:
        finite = np.isfinite(state.astype(complex)).all()
    except (TypeError, ValueError):
        finite = False
    if not finite:
        raise InputError("positions and velocities must be finite complex numbers.")
    return state


def _map(function: Callable[[Any], Any], array: Any) -> Any:
    return np.asarray(np.frompyfunc(function, 1, 1)(np.asarray(array, object)), object)


_REAL, _IMAG = (np.frompyfunc(part, 1, 1) for part in (lambda z: z.real, lambda z: z.imag))
