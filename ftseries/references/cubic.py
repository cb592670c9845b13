"""The oscillator in a cubic potential, solved exactly by Jacobi's elliptic functions.

A unit mass moves in the potential V of (C1) with the energy E of (C2), that is by

    x'² = P(x) = 4 (x - 2a)(x + a - λ)(x + a + λ)                                         (C3)

between -a - λ and -a + λ, starting at t = 0 from -a + λ. Put x = -a - λ + 2λ s². The factors of P
become x + a + λ = 2λ s², x + a - λ = -2λ (1 - s²), 2a - x = (3a + λ)(1 - m s²), and (C3) turns into

    s'² = (3a + λ)(1 - s²)(1 - m s²),      m = 2λ / (3a + λ),

the equation of s = sn(√(3a + λ) t + K | m). A quarter period on, sn is cd = cn/dn, hence

    x(t) = -a - λ + 2λ cd²(√(3a + λ) t | m),       ω = π √(3a + λ) / K(m).

The Fourier series of sn² in powers of the nome q(m) (Whittaker and Watson, section 22.735) gives

    x(t) = Σ A_n cos(nωt),  A_0 = 2a - (3a + λ) E(m)/K(m),  A_n = -2 ω² n (-q)ⁿ / (1 - q²ⁿ).

The second argument of elliptic functions is the parameter m = k², as in SciPy and mpmath. To change
the sign of λ is to shift t by half a period, so all this holds for -3a < λ < 3a; at λ = ±3a the
period is infinite. Functions broadcast over NumPy arrays; with `dps`, the number of decimal digits,
they take single numbers (or strings of digits) and return mpmath numbers.
"""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
from scipy import integrate, special

from ftseries.aliases import Array
from ftseries.arguments import real, whole
from ftseries.errors import InputError
from ftseries.references._digits import in_digits, number

__all__ = [
    "elliptic_parameter", "energy", "fourier_coefficient", "frequency", "invariants", "period",
    "period_by_quadrature", "polynomial", "position", "potential", "turning_points", "velocity",
]


def potential(x: Any, lam: Any, a: Any = 1) -> Any:
    """V(x) of (C1), in any arithmetic.

    >>> potential(-1.5, 0.5) == potential(-0.5, 0.5) == energy(0.5)
    True
    """
    return 2 * x * (3 * a**2 + lam**2) - 2 * x**3


def energy(lam: Any, a: Any = 1) -> Any:
    """E of (C2), in any arithmetic."""
    return -4 * a * (a - lam) * (a + lam)


def polynomial(x: Any, lam: Any, a: Any = 1) -> Any:
    """P(x) of (C3), in any arithmetic: the square of the speed at x."""
    return 4 * (x - 2 * a) * (x - lam + a) * (x + lam + a)


def invariants(lam: Any, a: Any = 1) -> Any:
    """g2 and g3 of (C11), in any arithmetic: P(x) = 4x³ - g2 x - g3.

    >>> invariants(0.5)
    (13.0, 6.0)
    """
    return 4 * (3 * a**2 + lam**2), 8 * (a**3 - a * lam**2)


def turning_points(lam: Any, a: Any = 1) -> Any:
    """x_min and x_max, where the velocity vanishes (for λ > 0), in any arithmetic."""
    return -a - lam, -a + lam


def elliptic_parameter(lam: Any, a: Any = 1) -> Any:
    """m = k² = 2λ/(3a + λ), in any arithmetic.

    >>> from fractions import Fraction
    >>> elliptic_parameter(Fraction(1, 2))
    Fraction(2, 7)
    """
    return 2 * lam / (3 * a + lam)


def frequency(lam: Any, a: Any = 1, dps: int | None = None) -> Any:
    """ω = π √(3a + λ)/K(m), as (C9b) gives it; with `dps`, λ may be complex, |λ| < 3a.

    >>> mpmath.nstr(frequency("0.5", dps=25), 25)
    '3.445876386472259725766553'
    """
    if dps is not None:
        return in_digits(dps, lambda: _frequency(*_numbers(lam, a)))
    lam, a = _reals(lam, a)
    return np.pi * np.sqrt(3 * a + abs(lam)) / special.ellipk(elliptic_parameter(abs(lam), a))


def period(lam: Any, a: Any = 1, dps: int | None = None) -> Any:
    """T = 2π/ω = 2 K(m)/√(3a + λ), equation (C9b).

    >>> mpmath.nstr(period("0.5", dps=22), 22)
    '1.823392542996019014655'
    """
    if dps is not None:
        return in_digits(dps, lambda: 2 * mpmath.pi / _frequency(*_numbers(lam, a)))
    return 2 * np.pi / frequency(lam, a)


def period_by_quadrature(lam: Any, a: Any = 1) -> Any:
    """T of (C9a): the integral of 2/√P between the turning points, without elliptic functions.

    The inverse square roots at both ends are the weight of QUADPACK's rule QAWS. Needs λ ≠ 0.
    """
    def integral(lam: Any, a: Any) -> Any:
        rule = {"weight": "alg", "wvar": (-0.5, -0.5), "epsabs": 0, "epsrel": 1e-13}
        smooth = lambda x: 1 / np.sqrt(4 * (2 * a - x))  # noqa: E731
        return 2 * integrate.quad(smooth, *turning_points(lam, a), **rule)[0]
    lam, a = _reals(lam, a)
    if not np.all(lam):
        raise InputError("lam must not be 0: without motion the integral (C9a) has no interval.")
    return np.vectorize(integral, otypes=[float])(abs(lam), a)[()]


def position(t: Any, lam: Any, a: Any = 1, dps: int | None = None) -> Any:
    """x(t) by Jacobi functions; t, lam and a broadcast, or are single numbers with `dps`.

    >>> position([0, period(0.5) / 2], 0.5)
    array([-0.5, -1.5])
    """
    if dps is not None:
        return in_digits(dps, lambda: _position(number("t", t), *_numbers(lam, a)))
    lam, a = _reals(lam, a)
    sn, cn, dn = _jacobi(t, lam, a)
    return -a - abs(lam) + 2 * abs(lam) * np.where(lam < 0, sn, cn / dn) ** 2


def velocity(t: Any, lam: Any, a: Any = 1) -> Any:
    """dx/dt by SciPy's Jacobi functions; t, lam and a broadcast."""
    lam, a = _reals(lam, a)
    sn, cn, dn = _jacobi(t, lam, a)
    m = elliptic_parameter(abs(lam), a)
    slope = np.where(lam < 0, sn * cn * dn, (m - 1) * sn * cn / dn**3)
    return 4 * abs(lam) * np.sqrt(3 * a + abs(lam)) * slope


def fourier_coefficient(n: int, lam: Any, a: Any = 1, dps: int | None = None) -> Any:
    """A_n, the coefficient of cos(nωt) in x(t); with `dps`, λ may be complex, |λ| < 3a.

    >>> mpmath.nstr(fourier_coefficient(1, "0.5", dps=20), 20)
    '0.4993381024431779361'
    """
    n = whole("n", n)
    if dps is not None:
        return in_digits(dps, lambda: _fourier_coefficient(n, *_numbers(lam, a)))
    lam, a = _reals(lam, a)
    m = elliptic_parameter(abs(lam), a)
    if n == 0:
        return 2 * a - (3 * a + abs(lam)) * special.ellipe(m) / special.ellipk(m)
    q = -np.sign(lam) * np.exp(-np.pi * special.ellipkm1(m) / special.ellipk(m))
    return -2 * frequency(lam, a) ** 2 * n * q**n / (1 - q ** (2 * n))


def _frequency(lam: Any, a: Any) -> Any:
    return mpmath.pi * mpmath.sqrt(3 * a + lam) / mpmath.ellipk(elliptic_parameter(lam, a))


def _position(t: Any, lam: Any, a: Any) -> Any:
    cd = mpmath.ellipfun("cd", mpmath.sqrt(3 * a + lam) * t, m=elliptic_parameter(lam, a))
    x = -a - lam + 2 * lam * cd**2
    return x if any(map(mpmath.im, (t, lam))) else mpmath.re(x)


def _fourier_coefficient(n: int, lam: Any, a: Any) -> Any:
    m = elliptic_parameter(lam, a)
    if n == 0:
        return 2 * a - (3 * a + lam) * mpmath.ellipe(m) / mpmath.ellipk(m)
    q = -mpmath.qfrom(m=m)
    return -2 * _frequency(lam, a) ** 2 * n * q**n / (1 - q ** (2 * n))


def _jacobi(t: Any, lam: Any, a: Any) -> Any:
    angle = np.sqrt(3 * a + abs(lam)) * real("t", t)
    return special.ellipj(angle, elliptic_parameter(abs(lam), a))[:3]


def _reals(lam: Any, a: Any) -> tuple[Array, Array]:
    lam, a = real("lam", lam), real("a", a)
    _oscillates(np.all(a > 0) and np.all(abs(lam) < 3 * a))
    return lam, a


def _numbers(lam: Any, a: Any) -> Any:
    lam, a = number("lam", lam), number("a", a)
    _oscillates(mpmath.im(a) == 0 and a.real > 0 and abs(lam) < 3 * a.real)
    return lam, a


def _oscillates(inside: Any) -> None:
    if not inside:
        raise InputError("lam and a must satisfy a > 0 and |lam| < 3a: nothing oscillates beyond.")
