r"""Singularities and radius of convergence from Taylor coefficients.

Formula.  Near a singularity z_i many functions are A(z) (1 - z/z_i)^s + B(z) with A and B analytic;
s = 0 stands for a logarithm.  Such an f solves nearly a first-order differential equation with
polynomial coefficients,

.. math::  Q_1(z)\, z f'(z) + Q_0(z) f(z) = P(z) + O(z^{N+1}), \qquad Q_1(0) = 1,

a *differential approximant* (A. J. Guttmann, in Phase Transitions and Critical Phenomena 13, 1989).
The zeros z_i of Q_1 are its singularities, and s = -Q_0(z_i)/(z_i Q_1'(z_i)).  All coefficients but
the last 2 deg Q + 1 go into P: so deg Q = 1 continues the straight line in the plot of C. Domb and
M. F. Sykes (Proc. R. Soc. A 240 (1957) 214), and deg Q = 2 finds a complex pair.  Approximants of
many degrees are made; a singularity is a place on which most of them agree, and its error is what
they disagree by.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from flint import acb, acb_poly, arb, arb_mat

from ..aliases import Number
from ..errors import InputError
from ..precision import working

__all__ = ["Estimate", "FewError", "Singularity", "certain", "thin", "root_test", "domb_sykes",
           "nearest_singularities"]

#: degrees of Q; beyond the second list the zeros follow the rounding of floats
_DEGREES, _FLOAT_DEGREES = (1, 2, 3, 4, 6, 8, 10, 12, 14, 16, 18, 20), (1, 2, 3, 4, 5, 6, 8)
#: coefficients that are needed, and the error, as a part of the distance, where there are no more
_FEWEST, _UNKNOWN = 10, 0.1
#: an exponent is clear with this error; if it is not, the fits may agree on a place that is not one
_CLEAR = 0.01
#: of n coefficients, the ratio of the last ones moves a place by exponent/n; this allows for more
_LEVER = 2
#: each degree is fitted to the last coefficients, and with this many of them left out
_LEFT_OUT = (0, 1, 2)
_BITS = 700
#: bits that a ball must have to count
_DIGITS = 10
#: fits agree when their zeros are this close, relative to the distance from 0; if none do, this
_CLOSE, _CLOSE_ENOUGH = 0.02, 0.06
#: zeros are looked for between these multiples of the radius that the root test suggests
_NEAREST, _FARTHEST = 0.1, 1.6
#: the error given, in units of the distance within which half of the fits lie
_SAFETY = 5


class FewError(InputError):
    """Coefficients that show no singularity; more of them may."""


@dataclass(frozen=True)
class Estimate:
    """A number with the uncertainty that the spread of its own variants suggests."""

    value: float
    error: float

    def __str__(self) -> str:
        return f"{self.value:.12g} ± {self.error:.1e}"

    def __float__(self) -> float:
        return float(self.value)


@dataclass(frozen=True)
class Singularity:
    """A singularity (1 - z/location)^exponent; exponent 0 is a logarithm.

    The errors say how far half of the fits differ, with a factor of safety; where these do not
    agree on the exponent, the place's error allows for what another exponent would move it by, and
    for where fewer coefficients put it.  They are estimates.  At
    a singularity of another form, such as 1/log, the exponent is an effective one.
    """

    location: complex
    exponent: float
    error: float
    exponent_error: float

    @property
    def radius(self) -> Estimate:
        return Estimate(abs(self.location), self.error)


def thin(c: Sequence[Number]) -> tuple[int, int, list[Number]]:
    """(step, first, d): the coefficients without their regular zeros, c_{first + k step} = d_k.

    >>> thin([0, 1, 0, -2, 0, 3])
    (2, 1, [1, -2, 3])
    """
    support = [k for k, value in enumerate(c) if value != 0]
    if not support:
        raise InputError("all coefficients are zero; there is nothing to analyse")
    step = int(np.gcd.reduce([k - support[0] for k in support])) or 1
    return step, support[0], list(c[support[0]::step])


def certain(c: Sequence[Number]) -> list[Number]:
    """The coefficients before the first ball that has no digits.

    >>> from flint import arb
    >>> certain([1, arb(2, 1e-9), arb(3, 1), arb(4)])
    [1, [2.00000000 +/- 1.01e-9]]
    """
    poor = (k for k, x in enumerate(c)
            if isinstance(x, arb) and x.rel_accuracy_bits() < _DIGITS)
    return list(c[:next(poor, len(c))])


def root_test(c: Sequence[Number]) -> list[tuple[int, float]]:
    """Pairs (k, |c_k|^{-1/k}) for every non-zero coefficient but the first.

    >>> root_test([1, 2, 4, 8])
    [(1, 0.5), (2, 0.5), (3, 0.5)]
    """
    with working(bits=_BITS):
        return [(k, float(abs(x) ** (arb(-1) / k)))
                for k, x in enumerate(_numbers(c)) if k and x != 0]


def domb_sykes(c: Sequence[Number]) -> list[tuple[float, float]]:
    """The points (1/k, c_k/c_{k-1}) of the plot of Domb and Sykes, zeros left out.

    They tend to 1/z_0 with the slope -(s + 1)/z_0 where one singularity (1 - z/z_0)^s is nearest.

    >>> domb_sykes([1, 2, 4, 8])
    [(1.0, 2.0), (0.5, 2.0), (0.3333333333333333, 2.0)]
    """
    with working(bits=_BITS):
        c = _numbers(c)
        return [(1 / k, float(c[k] / c[k - 1]))
                for k in range(1, len(c)) if c[k] != 0 and c[k - 1] != 0]


def nearest_singularities(c: Sequence[Number]) -> list[Singularity]:
    """The singularities that the coefficients show, nearest first; of a pair, both.

    Parameters
    ----------
    c : sequence
        Taylor coefficients from order 0 on: floats, fmpq or balls, not regularly zero (see
        :func:`thin`).  Of balls those count that come before the first one without digits.

    Returns
    -------
    list of Singularity
        The first sets the radius of convergence; what lies beyond 1.6 radii is left out.

    Raises
    ------
    InputError
        Fewer than 10 coefficients, or no place on which the fits agree.

    Examples
    --------
    The square root sqrt(1 - z/2) has its branch point at 2:

    >>> from flint import fmpq
    >>> c = [fmpq(1)]
    >>> for k in range(1, 40):
    ...     c.append(c[-1] * fmpq(2 * k - 3, 4 * k))
    >>> (s,) = nearest_singularities(c)
    >>> round(s.location.real, 12), round(s.exponent, 12)
    (2.0, 0.5)
    """
    c = certain(c)
    if len(c) < _FEWEST:
        raise FewError(f"{len(c)} coefficients are too few to locate a singularity; give 10 of "
                       "them, not regularly zero")
    found = _located(c)
    if not found:
        raise FewError("no singularity fits these coefficients: give more of them, or their "
                       "function has none")
    shorter = [place for length in (5 * len(c) // 6, 25 * len(c) // 36) if length >= _FEWEST
               for place in _located(c[:length])]
    return [s if s.exponent_error < _CLEAR else replace(s, error=max(s.error, _moved(s, shorter)))
            for s in found]


def _located(c: Sequence[Number]) -> list[Singularity]:
    """The places on which the fits agree."""
    exact = not any(isinstance(x, float) or (isinstance(x, arb) and x.rel_accuracy_bits() < 150)
                    for x in c)
    degrees = _DEGREES if exact else _FLOAT_DEGREES
    with working(bits=_BITS):
        c = _numbers(c)
        scale = _rough_radius(c)
        c = [x * arb(scale) ** k for k, x in enumerate(c)]
        fits = [zeros for degree in degrees for left_out in _LEFT_OUT
                if len(c) - 2 - 2 * degree - left_out >= degree
                and (zeros := _fit(c[:len(c) - left_out], degree)) is not None]
    found = _agreed(fits, _CLOSE, len(c)) or _agreed(fits, _CLOSE_ENOUGH, len(c))
    return [Singularity(s.location * scale, s.exponent, s.error * scale, s.exponent_error)
            for s in found]


def _moved(s: Singularity, shorter: Sequence[Singularity]) -> float:
    """How far a place lies from where fewer coefficients put it, if that was believed sharp."""
    if not shorter:
        return _UNKNOWN * abs(s.location)
    before = min(shorter, key=lambda each: abs(each.location - s.location))
    distance = abs(before.location - s.location)
    return float(distance) if distance > before.error else 0.0


def _numbers(c: Sequence[Number]) -> list[arb]:
    try:
        c = [arb(x) for x in c]
    except (TypeError, ValueError):
        raise InputError("coefficients must be real: floats, fmpq or balls") from None
    if not all(x.is_finite() for x in c):
        raise InputError("coefficients must be finite; one of these is infinite or not a number")
    return c


def _rough_radius(c: Sequence[Number]) -> float:
    """The median of |c_k|^{-1/k} over the last third."""
    radii = [(abs(x).mid().log() / k) for k, x in enumerate(c)
             if k > 2 * len(c) // 3 and abs(x).mid() != 0]
    if not radii:
        raise InputError("the last third of the coefficients is zero: a polynomial has no "
                         "singularity")
    return float(np.exp(-np.median([float(x) for x in radii])))


def _fit(c: Sequence[Number], degree: int) -> Any:
    """The zeros z of Q_1 in the upper half plane as pairs (z, s); None where the balls say little.

    A singular system means that a lower degree is exact already; a change in the last bits makes
    it regular and moves only the superfluous zeros.
    """
    rows = range(len(c) - 2 * degree - 1, len(c))
    for change in (0, arb(2) ** (-_BITS // 3)):
        c = [(x * (1 + change * arb(k * k + 1).sin())).mid() for k, x in enumerate(c)]
        matrix = arb_mat([[c[k - j] * (k - j) for j in range(1, degree + 1)]
                          + [c[k - j] for j in range(degree + 1)] for k in rows])
        try:
            solution = matrix.solve(arb_mat([[-c[k] * k] for k in rows]))
            break
        except ZeroDivisionError:
            continue
    else:
        return None
    q = [solution[i, 0] for i in range(2 * degree + 1)]
    if any(x.rel_accuracy_bits() < 30 and x.abs_upper() > 1e-20 for x in q):
        return None
    q = [arb(0) if x.abs_upper() < 1e-25 else x.mid() for x in q]
    q1, q0 = acb_poly([arb(1), *q[:degree]]), acb_poly(q[degree:])
    slope, found = q1.derivative(), []
    for z in np.roots([float(a.real) for a in q1.coeffs()[::-1]]):
        if not (_NEAREST < abs(z) < _FARTHEST and z.imag > -1e-10):
            continue
        z = acb(complex(z))
        for _ in range(4):                                  # Newton's method
            z = (z - q1(z) / slope(z)).mid()
        exponent = -q0(z) / (z * slope(z))
        if z.is_finite() and exponent.is_finite():
            found.append((complex(z), complex(exponent)))
    return np.array(found, dtype=complex).reshape(-1, 2)


def _agreed(fits: Any, close: float, count: int) -> list[Singularity]:
    """Every place where half of the fits to so many coefficients have a zero."""
    candidates = []
    half = max(2, (len(fits) + 1) // 2)
    for z, s in np.concatenate([*fits, np.empty((0, 2))]):
        near = []
        for fit in fits:
            if len(fit):
                i = np.abs(fit[:, 0] - z).argmin()
                near.append((abs(fit[i, 0] - z), abs(fit[i, 1] - s)))
        near = sorted(near)[:half]
        if len(near) == half and near[-1][0] < close * abs(z):
            candidates.append((near[-1][0], max(change for _, change in near), complex(z), s))
    chosen: list[tuple[float, float, complex, complex]] = []
    for error, exponent_error, z, s in sorted(candidates, key=lambda c: c[:2]):
        if all(abs(z - other[2]) > 5 * close * abs(z) for other in chosen):
            chosen.append((error, exponent_error, z, s))
    result = []
    for error, exponent_error, z, s in sorted(chosen, key=lambda c: abs(c[2])):
        error = float(_SAFETY * error + 1e-15 * abs(z))
        exponent_error = float(_SAFETY * exponent_error + abs(s.imag) + 1e-15)
        places = [complex(z.real)] if abs(z.imag) <= error else [z, z.conjugate()]
        if exponent_error >= _CLEAR:
            error = max(error, _LEVER * exponent_error * abs(z) / count)
        result += [Singularity(place, float(s.real), error, exponent_error) for place in places]
    return result
