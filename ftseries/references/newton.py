"""The figure eight of three bodies from Newton's equations (E0), by shooting and integration alone.

Chenciner and Montgomery (Annals of Mathematics 152, 2000) print initial values of the eight lying
along the x-axis, computed by C. Simó: r_3 = 0, r_1 = -r_2 and v_1 = v_2 = -v_3/2, and the period T.
Here the eight stands upright and its period is 2π: lengths are multiplied by (2π/T)^(2/3),
velocities by (2π/T)^(-1/3) (Kepler's third law), and x and y change places. The bodies keep their
numbers. Then r_12 = r_1 - r_2 is the r e^{iφ} of the paper with φ_12 = λ cos t + …, and

    r_1(t) = r_3(t - 2π/3),   r_2(t) = r_3(t + 2π/3),
    r_23(t) = r_12(t - 2π/3),   r_31(t) = r_12(t + 2π/3).

*Published* values are used as printed. The others are refined: Newton's method varies r_1 and v_3
until at t = 2π/12 body 1 crosses the y-axis horizontally and the other two are mirror images with
the velocities of a mirror that reverses time: x_1 = 0, y_1' = 0, y_2 = y_3, x_2' = x_3'.
Reflections carry this arc over the whole period, and its samples give the Fourier coefficients

    r_3(t) = Σ c_n sin(nt),   c_n real (that is x_3) for even n, imaginary (i y_3) for odd n.
"""

from __future__ import annotations

from collections import namedtuple
from contextlib import AbstractContextManager, nullcontext
from functools import lru_cache, partial
from typing import Any

import mpmath
import numpy as np

from ftseries.arguments import MOST_DERIVATIVES, MOST_DPS, real, whole
from ftseries.precision import working
from ftseries.references._digits import GUARD, number
from ftseries.references.three_bodies import (
    angular_momentum,
    energy,
    integrate,
    integrate_taylor,
    newton_residual,
)

__all__ = [
    "PERIOD", "POSITION_1", "VELOCITY_3", "angular_momentum", "energy", "figure_eight",
    "figure_eight_coefficients", "figure_eight_lambda", "figure_eight_state", "newton_residual",
    "published_figure_eight", "published_state",
]

POSITION_1 = 0.97000436 - 0.24308753j
VELOCITY_3 = -0.93240737 - 0.86473146j
PERIOD = 6.32591398


def published_state() -> Any:
    """r(0) and v(0), of shape (2, 3), upright and with period 2π, from the digits printed."""
    scale = 2 * np.pi / PERIOD
    upright = 1j * np.conj([POSITION_1 * scale ** (2 / 3), VELOCITY_3 * scale ** (-1 / 3)])
    return _state(*upright)


def published_figure_eight(t: Any) -> Any:
    """The positions, of shape (3,) + t.shape, that follow from the published digits by DOP853.

    >>> gap = published_figure_eight(2 * np.pi) - published_figure_eight(0)
    >>> bool(1e-9 < abs(gap).max() < 1e-7)  # eight digits do not close the curve better
    True
    """
    return integrate(t, *published_state())[0]


def figure_eight_state(dps: int | None = None) -> Any:
    """r(0) and v(0), of shape (2, 3), refined to rounding: complex128, or mpmath numbers by `dps`.

    >>> bool(abs(figure_eight_state() - published_state()).max() < 1e-8)
    True
    """
    return _state(*_refined(dps))


def figure_eight_coefficients(dps: int | None = None) -> Any:
    """The Fourier coefficients c_0, c_1, … of r_3, as many as the precision can tell from zero.

    >>> abs(figure_eight_coefficients()[:6]).round(4)
    array([0.    , 1.0959, 0.3373, 0.    , 0.0557, 0.0253])
    """
    return _coefficients(dps).copy()


def figure_eight(t: Any, derivative: int = 0, dps: int | None = None) -> Any:
    """The positions, or their time derivatives, complex of shape (3,) + t.shape, at all times t.

    Positions are accurate to 1e-14, or to `dps` digits in arrays of mpmath numbers; a derivative
    loses nearly two digits.

    >>> abs(figure_eight(np.pi / 6)).round(4)  # body 1 at the end of the eight, 2 and 3 alike
    array([1.0761, 0.6385, 0.6385])
    """
    derivative, c = whole("derivative", derivative, most=MOST_DERIVATIVES), _coefficients(dps)
    with _precision(dps):
        pi, sin, _, _, times = _arithmetic(dps)
        shifts = np.array([-1, 1, 0]) * (2 * pi / 3)
        n = np.arange(len(c))
        phase = np.multiply.outer(n, np.add.outer(shifts, times("t", t))) + derivative * pi / 2
        return np.tensordot(c * n**derivative, sin(phase), 1)


def figure_eight_lambda(dps: int | None = None) -> Any:
    """λ of (E_lambda): 1/π times the integral of φ_12(t) cos t over a period.

    >>> round(figure_eight_lambda(), 13)
    2.0756839088491
    """
    r_3 = _samples(dps)
    third = len(r_3) // 3
    with _precision(dps):
        pi, _, cos, angle, _ = _arithmetic(dps)
        phi = angle(np.roll(r_3, third) - np.roll(r_3, -third))  # of r_12, always within ±2
        lam = 2 * np.mean(phi * cos(2 * pi * np.arange(len(r_3)) / len(r_3)))
        return float(lam) if dps is None else lam


def _state(position_1: Any, velocity_3: Any) -> Any:
    velocity_1 = -velocity_3 / 2
    positions = [position_1, -position_1, 0 * position_1]
    return np.array([positions, [velocity_1, velocity_1, velocity_3]])


def _mismatch(unknowns: Any, dps: int | None = None) -> Any:
    """What must vanish at t = 2π/12, for [x_1, y_1, x_3', y_3'] at t = 0."""
    start = _state(unknowns[0] + 1j * unknowns[1], unknowns[2] + 1j * unknowns[3])
    r, v = integrate_taylor(_arithmetic(dps).pi / 6, start[0], start[1], dps)
    return np.array([r[0].real, v[0].imag, (r[1] - r[2]).imag, (v[1] - v[2]).real])


@lru_cache
def _refined(dps: int | None) -> Any:
    """r_1(0) and v_3(0) by Newton's method with the derivative at the published values."""
    r, v = published_state()
    unknowns, step = np.array([r[0].real, r[0].imag, v[2].real, v[2].imag]), 1e-6 * np.eye(4)
    slope = [(_mismatch(unknowns + h) - _mismatch(unknowns - h)) / 2e-6 for h in step]
    inverse = np.linalg.inv(np.transpose(slope))
    with _precision(dps):
        small = 1e-14
        if dps is not None:
            small, inverse = mpmath.mpf(10) ** -dps, inverse.astype(object)
        while True:
            gap = _mismatch(unknowns, dps)
            unknowns = unknowns - inverse @ gap
            if max(abs(gap)) < small:
                return unknowns[0] + 1j * unknowns[1], unknowns[2] + 1j * unknowns[3]


@lru_cache
def _samples(dps: int | None) -> Any:
    """r_3 at equidistant times over one period, from all three bodies between 0 and 2π/12."""
    n = 3 + 3 * (dps or 14) // 4  # 6n harmonics, each smaller than the last by 0.227 digits
    i = np.arange(n + 1)
    with _precision(dps):
        start = figure_eight_state(dps)
        r = integrate_taylor(_arithmetic(dps).pi / 6 * i / n, start[0], start[1], dps)[0]
        values = np.empty(12 * n, r.dtype)
        values[i], values[2 * n - i], values[2 * n + i] = r[2], -np.conj(r[1]), np.conj(r[0])
        values[6 * n - np.arange(3 * n)] = -np.conj(values[: 3 * n])  # mirror at t = π/2
        values[6 * n + 1 :] = -values[1 : 6 * n][::-1]  # an odd function
    return values


@lru_cache
def _coefficients(dps: int | None) -> Any:
    samples = _samples(dps)
    size = len(samples)
    n, j = np.ogrid[: size // 2, :size]
    with _precision(dps):
        pi, sin, *_ = _arithmetic(dps)
        return 2 * (sin(2 * pi * np.arange(size) / size)[n * j % size] @ samples) / size


_Arithmetic = namedtuple("_Arithmetic", "pi sin cos angle times")
_FLOAT = _Arithmetic(np.pi, np.sin, np.cos, np.angle, real)


def _arithmetic(dps: int | None) -> _Arithmetic:
    """π, the elementary functions on arrays and the conversion of times, in one arithmetic."""
    if dps is None:
        return _FLOAT
    sin, cos, arg = (np.frompyfunc(f, 1, 1) for f in (mpmath.sin, mpmath.cos, mpmath.arg))
    exact = np.frompyfunc(partial(number, "t"), 1, 1)
    return _Arithmetic(+mpmath.pi, sin, cos, arg, lambda name, t: np.array(exact(t), object))


def _precision(dps: int | None) -> AbstractContextManager[Any]:
    return nullcontext() if dps is None else working(digits=whole("dps", dps, 1, MOST_DPS) + GUARD)
