"""Three bodies on Bernoulli's lemniscate, in closed form by Jacobi's elliptic functions.

T. Fujiwara, H. Fukuda and H. Ozaki (J. Phys. A 36, 2003, 2791) found that bodies of mass 1 at
q(t - T/3), q(t + T/3), q(t) with

    q(t) = (sn t + i sn t cn t)/(1 + cn² t),   k² = (2 + √3)/4,   T = 4K(k),

obey the equations of motion of the pair potential ½ ln d - (√3/24) d². Time is measured here in
T/2π, so that the period is 2π, and the eight stands upright, as in the other chapters: q is turned
to -i times its conjugate.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.special import ellipj, ellipk

from ftseries.arguments import real

__all__ = ["MODULUS", "PERIOD", "attraction", "bodies", "lam"]

MODULUS = (2 + np.sqrt(3)) / 4
PERIOD = float(4 * ellipk(MODULUS))


def bodies(t: Any) -> Any:
    """The positions, complex of shape (3,) + t.shape.

    >>> bool(abs(bodies(0.3).sum()) < 1e-14)                                # the centre of mass
    True
    >>> z = bodies(0.3)[2]                                                  # (x² + y²)² = y² - x²
    >>> bool(abs(abs(z) ** 4 - z.imag**2 + z.real**2) < 1e-15)
    True
    """
    t = real("t", t)
    times = np.stack([t - 2 * np.pi / 3, t + 2 * np.pi / 3, t]) * PERIOD / (2 * np.pi)
    sn, cn, _, _ = ellipj(times, MODULUS)
    return -1j * np.conj((sn + 1j * sn * cn) / (1 + cn**2))


def attraction(distance: Any) -> Any:
    """The force that pulls two bodies together, in the time in which the period is 2π."""
    return (PERIOD / (2 * np.pi)) ** 2 * (1 / (2 * distance) - np.sqrt(3) / 12 * distance)


def lam() -> float:
    """λ of (E_lambda): 1/π times the integral of φ_12(t) cos t over a period.

    >>> round(lam(), 12)
    2.08303940439
    """
    t = 2 * np.pi * np.arange(4096) / 4096
    one, two, _ = bodies(t)
    phi = np.angle(one - two)
    return float(abs(2 * np.mean(phi * np.cos(t))))
