"""The oscillator in a cubic potential through Weierstrass's ℘, equations (C10) and (C12), in any
number of digits.

(C3) reads x'² = 4x³ - g2 x - g3 (C11), the differential equation of ℘, so x(t) = ℘(t - u₁) once u₁
is an argument at which ℘ takes the value x(0) = -a + λ: the sum of both half-periods. Nothing of
the Jacobi functions of `cubic` is used here; ℘ is built from theta functions, the half-periods from
arithmetic-geometric means, both out of g2 and g3 alone.
"""

from __future__ import annotations

from typing import Any

import mpmath

from ftseries.errors import InputError
from ftseries.references._digits import in_digits, number
from ftseries.references.cubic import invariants

__all__ = ["position", "shift", "weierstrass_p"]


def weierstrass_p(z: Any, g2: Any, g3: Any, dps: int | None = 30) -> Any:
    """℘(z; g2, g3) for real g2³ > 27 g3² and complex z (DLMF 23.6.5).

    >>> mpmath.nstr(mpmath.chop(weierstrass_p(shift("0.5"), 13, 6)), 15)
    '-0.5'
    """
    return in_digits(dps, lambda: _p(number("z", z), number("g2", g2), number("g3", g3)))


def shift(lam: Any, a: Any = 1, dps: int | None = 30) -> Any:
    """u₁ of (C10), for 0 < λ < 3a: minus the real half-period plus the imaginary one.

    >>> mpmath.nstr(shift("0.5"), 12)
    '(-0.911696271498 + 1.1208810036j)'
    """
    return in_digits(dps, lambda: _shift(*_invariants(lam, a)))


def position(t: Any, lam: Any, a: Any = 1, dps: int | None = 30) -> Any:
    """x(t) = ℘(t - u₁; g2, g3) of (C12), for real t and 0 < λ < 3a.

    >>> mpmath.nstr(position(0, "0.5"), 20)
    '-0.5'
    """
    def value() -> Any:
        g2, g3 = _invariants(lam, a)
        return _p(number("t", t) - _shift(g2, g3), g2, g3).real
    return in_digits(dps, value)


def _p(z: Any, g2: Any, g3: Any) -> Any:
    omega1, omega3, e1 = _half_periods(g2, g3)
    q, scale = mpmath.exp(1j * mpmath.pi * omega3 / omega1).real, mpmath.pi / (2 * omega1)
    ratio = mpmath.jtheta(2, scale * z, q) / mpmath.jtheta(1, scale * z, q)
    return e1 + (scale * mpmath.jtheta(3, 0, q) * mpmath.jtheta(4, 0, q) * ratio) ** 2


def _shift(g2: Any, g3: Any) -> Any:
    omega1, omega3, _ = _half_periods(g2, g3)
    return omega3 - omega1


def _half_periods(g2: Any, g3: Any) -> Any:
    """ω₁ > 0, ω₃ on the positive imaginary axis (DLMF 23.22.1), and the largest root e1."""
    if not (mpmath.im(g2) == mpmath.im(g3) == 0 and g2**3 > 27 * g3**2):
        raise InputError("g2 and g3 must be real with g2³ > 27 g3²: ℘ needs three real roots here.")
    roots = mpmath.polyroots([4, 0, -g2, -g3], maxsteps=200, extraprec=4 * mpmath.mp.prec)
    e3, e2, e1 = sorted(map(mpmath.re, roots))
    omega1 = mpmath.pi / (2 * mpmath.agm(mpmath.sqrt(e1 - e3), mpmath.sqrt(e1 - e2)))
    omega3 = mpmath.pi / (2 * mpmath.agm(mpmath.sqrt(e1 - e3), mpmath.sqrt(e2 - e3))) * 1j
    return omega1, omega3, e1


def _invariants(lam: Any, a: Any) -> Any:
    lam, a = number("lam", lam), number("a", a)
    if not (mpmath.im(lam) == mpmath.im(a) == 0 and 0 < lam < 3 * a):
        raise InputError("lam and a must satisfy 0 < lam < 3a: (C12) oscillates only there.")
    return invariants(lam, a)
