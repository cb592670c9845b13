"""Monodromy matrices by power series, and what is published about the eight's.

Hill's equation (M1) is ψ'' = Q(x) ψ with an entire Q: power series about any x, whose coefficients
obey (n + 1)(n + 2) ψ_{n+2} = Σ Q_j ψ_{n-j}, converge everywhere. Short steps need few terms.

The eight: the recurrences of `three_bodies` for the Taylor coefficients in time are differentiated
by the initial values. After T/3 the bodies have changed places, state(T/3) = P state(0), so that
the variational matrix Y obeys Y(T) = (P⁻¹ Y(T/3))³: a third of a period is enough. Coordinates are
x_1, y_1, …, x_3, y_3 and then the velocities in the same order.

C. Simó (Celestial Mechanics, Contemporary Mathematics 292, 2002, pages 209-228) gives the rotation
numbers of the multipliers exp(±2πiν) that are not 1.
"""

from __future__ import annotations

import math
from typing import Any

import mpmath
import numpy as np

from ftseries.arguments import MOST_DPS, whole
from ftseries.errors import InputError
from ftseries.precision import working
from ftseries.references import newton
from ftseries.references._digits import GUARD, number

__all__ = ["ROTATION_NUMBERS", "figure_eight_monodromy", "hill_monodromy"]

ROTATION_NUMBERS = (0.00842272, 0.29809253)
ORDER, TOLERANCE = 24, 1e-18  # of the Taylor series in time
STEPS, MOST_TERMS = 6, 400  # steps per unit of x; terms of one power series


def hill_monodromy(a: Any, lam: Any, mu: Any = 0, end: Any = None, dps: int = 30) -> Any:
    """The matrix of ψ, ψ' at x = `end` (π if left out) from ψ, ψ' at 0, to `dps` digits.

    >>> mpmath.nprint(hill_monodromy(a="0.25", lam=0, dps=15).apply(mpmath.chop), 12)
    [ 0.0  2.0]
    [-0.5  0.0]
    """
    with working(digits=whole("dps", dps, 1, MOST_DPS) + GUARD):
        a, lam, mu = number("a", a), number("lam", lam), number("mu", mu)
        end = +mpmath.pi if end is None else number("end", end)
        steps = max(1, math.ceil(abs(end) * STEPS))
        matrix = mpmath.eye(2)
        for i in range(steps):
            matrix = _hill_step(a, lam, mu, i * end / steps, end / steps) * matrix
        return matrix


def _hill_step(a: Any, lam: Any, mu: Any, x: Any, step: Any) -> Any:
    """The same from x to x + step."""
    q, power, matrix, small = [], step, mpmath.eye(2), mpmath.mpf(10) ** -(mpmath.mp.dps + 5)
    matrix[0, 1] = step
    columns, quiet = [[mpmath.mpf(1), mpmath.mpf(0)], [mpmath.mpf(0), mpmath.mpf(1)]], 0
    for n in range(MOST_TERMS):
        turn = n * mpmath.pi / 2  # the nth derivative of a cosine
        q.append((lam**2 * 2**n * mpmath.cos(2 * x + turn)
                  + lam**4 * mu * 4**n * mpmath.cos(4 * x + turn)) / mpmath.factorial(n)
                 - (a if n == 0 else 0))
        size = 0
        for j, c in enumerate(columns):
            c.append(mpmath.fdot(q, c[n::-1]) / ((n + 1) * (n + 2)))
            term = c[-1] * power
            matrix[0, j] += term * step
            matrix[1, j] += (n + 2) * term
            size = max(size, (n + 2) * abs(term))
        quiet, power = quiet + 1 if size < small else 0, power * step
        if quiet == 4:
            return matrix
    raise InputError("a, lam or mu is too large for these power series.")


def figure_eight_monodromy(state: Any = None, exponent: float = 1) -> Any:
    """The eight's monodromy matrix over 2π, 12 × 12, from Newton's equations alone, in float64.

    `state` is r(0) and v(0), of shape (2, 3), of a choreography under the force d^{-(α+1)} with α
    the `exponent`; left out, the figure eight of gravitation.

    >>> m = figure_eight_monodromy()
    >>> turn = np.sort(abs(np.angle(np.linalg.eigvals(m)))) / (2 * np.pi)
    >>> turn[-4:].round(8)
    array([0.00842272, 0.00842272, 0.29809253, 0.29809253])
    """
    state = newton.figure_eight_state() if state is None else np.asarray(state)
    state = np.stack([state.real, state.imag], axis=-1)
    change, now, end = np.eye(12).reshape(2, 3, 2, 12), 0.0, 2 * np.pi / 3
    while now < end:
        r, dr = _taylor(state[0], state[1], change[0], change[1], -(exponent + 2) / 2)
        last = [(k, max(abs(c[k]).max() for c in (r, dr))) for k in (ORDER - 1, ORDER)]
        step = min([end - now] + [(TOLERANCE / size) ** (1 / k) for k, size in last])
        now = now + step if step < end - now else end
        state, change = _sum(r, step), _sum(dr, step)
    back = np.zeros((12, 12))  # P⁻¹: body 1 has gone to the place of 3, 2 to that of 1, 3 to 2
    for body, place in enumerate((2, 0, 1)):
        for k in range(2):
            for half in (0, 6):
                back[half + 2 * place + k, half + 2 * body + k] = 1
    return np.linalg.matrix_power(back @ change.reshape(12, 12), 3)


def _sum(c: Any, t: Any) -> Any:
    """Position and velocity at t."""
    k = np.arange(len(c)).reshape(-1, *(1,) * (c.ndim - 1))
    return np.stack([(c * t**k).sum(0), (k[1:] * c[1:] * t ** (k[1:] - 1)).sum(0)])


def _taylor(position: Any, velocity: Any, d_position: Any, d_velocity: Any, p: float) -> Any:
    """Coefficients of r, of shape (ORDER + 1, 3, 2), and of dr by 12 parameters, (…, 3, 2, 12)."""
    r, u = (np.zeros((ORDER + 1, 3, 2)) for _ in range(2))
    s, w = (np.zeros((ORDER + 1, 3)) for _ in range(2))
    dr, du = (np.zeros((ORDER + 1, 3, 2, 12)) for _ in range(2))
    ds, dw = (np.zeros((ORDER + 1, 3, 12)) for _ in range(2))
    r[:2], dr[:2] = (position, velocity), (d_position, d_velocity)
    for k in range(ORDER - 1):
        u[k], du[k] = (c[k] - np.roll(c[k], -1, axis=0) for c in (r, dr))
        s[k] = (u[: k + 1] * u[k::-1]).sum((0, 2))
        ds[k] = 2 * (u[: k + 1, ..., None] * du[k::-1]).sum((0, 2))
        if k == 0:
            w[0], dw[0] = s[0] ** p, p * s[0, :, None] ** (p - 1) * ds[0]
        else:
            j = np.arange(1, k + 1)[:, None]
            w[k] = (((p + 1) * j - k) * s[1 : k + 1] * w[:k][::-1]).sum(0) / (k * s[0])
            j = j[..., None]
            both = ds[1 : k + 1] * w[:k][::-1, :, None] + s[1 : k + 1, :, None] * dw[:k][::-1]
            dw[k] = (((p + 1) * j - k) * both).sum(0) / k - ds[0] * w[k, :, None]
            dw[k] /= s[0, :, None]
        pull = (w[: k + 1, :, None] * u[k::-1]).sum(0)
        d_pull = (dw[: k + 1, :, None] * u[k::-1, ..., None]
                  + w[: k + 1, :, None, None] * du[k::-1]).sum(0)
        for c, force in ((r, pull), (dr, d_pull)):
            c[k + 2] = (np.roll(force, 1, axis=0) - force) / ((k + 1) * (k + 2))
    return r, dr
