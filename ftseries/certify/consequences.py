r"""What an enclosure of the figure eight says about λ₀, the initial values and a given series.

Formula.  Let the true Z = r_12/3^{1/3} be within d of Z̄ in the norm of
:mod:`ftseries.certify.algebra`.  Then \|Z(t) - Z̄(t)\| ≤ d at all times, and with s = ‖W^{-1/2}‖

.. math::  |\arg Z - \arg Z̄| \le \arcsin(d s) \le \frac{d s}{1 - d s}, \qquad
           |Z'(t) - Z̄'(t)| \le d\, \sup_n n ν^{-n} \le \frac{d}{e \ln ν}.

λ₀ is the amplitude of cos t in φ = arg Z; that of sin t in φ' = (X Y' - Y X')/W is -λ₀.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from flint import acb, arb

from ..aliases import Modes
from ..errors import InputError
from ..series import DERIVATIVES
from .algebra import RING, Enclosure, upper
from .balls import NotProved

if TYPE_CHECKING:
    from ..trig import Trig

__all__ = ["distance_from", "initial_values", "lambda_zero"]

ROOM = 1 + arb(2) ** -10            # of the radii, so that others may check them


def lambda_zero(x: Enclosure, y: Enclosure, v: Trig, distance: arb) -> arb:
    """A ball around λ₀, from Z̄ = x + iy, v ≈ W^{-1/2} and the distance d."""
    w = x * x + y * y
    derivative = [Enclosure(part.center.multiply_modes(DERIVATIVES[1]), 0, part.nu)
                  for part in (x, y)]
    rate = (x * derivative[1] + y * derivative[0] * -1) * w.negative_power(2, v)
    angle = distance * w.negative_power(1, v).norm()
    if not angle < arb("0.5"):
        raise NotProved("not proved: the orbit may pass through a collision")
    error = rate.radius / w.nu + 4 / arb.pi() * angle / (1 - angle)
    slope: arb = rate.center.modes()[1, 1]
    return arb(0, upper(error * ROOM)) - slope


def initial_values(u: Mapping[int, Any], distance: arb, nu: arb) -> list[tuple[acb, ...]]:
    """Positions and velocities of the bodies at t = 0, as two triples of complex balls."""
    unit = arb(3).root(3)
    errors = distance, distance / (arb(1).exp() * nu.log())
    result = []
    for order in (0, 1):
        pairs = {}
        for name, turn in (("12", 0), ("23", -1), ("31", 1)):          # Z at 0, -2π/3, 2π/3
            parts = [arb(0), arb(0)]
            for n, c in u.items():
                angle = 2 * arb.pi() * n * turn / 3
                parts[n % 2] += c * (-n * angle.sin() if order else angle.cos())
            pairs[name] = acb(*parts)
        error = arb(0, upper(2 * errors[order] * unit / 3 * ROOM))
        bodies = (pairs["12"] - pairs["31"], pairs["23"] - pairs["12"], pairs["31"] - pairs["23"])
        result.append(tuple(z * unit / 3 + acb(error, error) for z in bodies))
    return result


def distance_from(orbit: Any, lam: float, x: Enclosure, y: Enclosure, top: int, low: arb,
                  high: arb) -> arb:
    """A bound of ‖r e^{iφ}/3^{1/3} - Z̄‖ for the given coefficients of r and φ, taken as exact.

    Raises
    ------
    NotProved
        The given sum is outside the ball in which the true eight is unique.
    """
    r, phi = (Enclosure(_sum(orbit, name, lam), 0, x.nu).cut(top) for name in ("r", "phi"))
    c, s = phi.cos_sin(top)
    gaps = [(r * wave + part * -1).norm() for wave, part in ((c, x), (s, y))]
    distance = upper(gaps[0] + gaps[1])
    if not low + distance < high - distance:
        raise NotProved(f"not proved: the given r e^{{iφ}} is {float(distance):.3g} away from its "
                        "symmetric part, in which an eight was found; it is not a figure eight")
    return distance


def _sum(orbit: Any, name: str, lam: float) -> Trig:
    """The Fourier sum of r/3^{1/3} or φ at λ, with balls for coefficients."""
    rows = getattr(orbit, "coefficients", None)
    if rows is not None and isinstance(rows[name], list):               # a series
        total: Modes = {}
        power = arb(1)
        for row in rows[name]:
            for mode, c in row.items():
                total[mode] = total.get(mode, arb(0)) + _number(c) * power
            power = power * arb(lam)
        return RING.from_modes(total)
    unit = arb(3).root(3) if name == "r" else arb(1)
    amplitudes = rows[name] if rows is not None else orbit.amplitudes(name, lam)
    if not amplitudes:
        raise InputError(f"{orbit!r} has no coefficients of {name!r}")
    return RING.from_modes({mode: arb(float(c)) / unit for mode, c in amplitudes.items()})


def _number(c: Any) -> arb:
    return arb(c) if isinstance(c, float) else RING.number(c)
