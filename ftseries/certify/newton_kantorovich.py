r"""The Newton-Kantorovich theorem with a radii polynomial.

Theorem.  Let F be twice differentiable near ū, A injective, and

.. math::  \|A F(ū)\| \le Y, \quad \|I - A\,DF(ū)\| \le Z_1, \quad
           \|A\,(DF(ū + h) - DF(ū))\| \le Z_2 \|h\| \text{ for } \|h\| \le r_*.

If p(r) = Y - (1 - Z_1) r + Z_2 r²/2 ≤ 0 and Z_1 + Z_2 r < 1 for some r ≤ r_*, then F has a zero
within r of ū, and no other one within any R ≤ r_* with Z_1 + Z_2 R < 1.  For T(u) = u - A F(u) maps
the ball of radius r into itself, since ‖T(ū + h) - ū‖ ≤ Y + Z_1 r + Z_2 r²/2 ≤ r, and contracts
the ball of radius R by the factor Z_1 + Z_2 R.  Every inequality is decided with balls.

Why A is injective when it is a finite block a and an invertible tail: Z_1 < 1 makes A DF(ū)
invertible, so A is onto, so a is onto, and a square matrix that is onto is injective.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb

from .algebra import upper
from .balls import NotProved

__all__ = ["Bounds", "radius"]

#: room left in both radii, so that others may check them with bounds rounded differently
MARGIN = arb(2) ** -10


@dataclass(frozen=True)
class Bounds:
    """The constants Y, Z₁, Z₂ of a proof, valid up to the radius r*."""

    y: arb
    z1: arb
    z2: arb
    largest: arb


def radius(bounds: Bounds) -> tuple[arb, arb]:
    """The interval (r₋, r₊) of radii for which the theorem holds, as exact numbers.

    r₋ says how close the true solution is, r₊ how far it is alone.

    Examples
    --------
    >>> from flint import arb
    >>> low, high = radius(Bounds(arb("1e-3"), arb("0.1"), arb(1), arb("0.5")))
    >>> 0.00111 < low < 0.00112, high == 0.5
    (True, True)

    Raises
    ------
    NotProved
        No such radius; the message shows the constants.
    """
    y, z1, z2 = upper(bounds.y), upper(bounds.z1), upper(bounds.z2)
    shown = f"Y = {float(y):.3g}, Z₁ = {float(z1):.3g}, Z₂ = {float(z2):.3g}"
    gain = 1 - z1
    if not gain > 0:
        raise NotProved(f"not proved: {shown}; Z₁ must be below 1")
    discriminant = gain**2 - 2 * y * z2
    if not discriminant > 0:
        raise NotProved(f"not proved: {shown}; (1 - Z₁)² is not above 2 Y Z₂")
    low = upper(2 * y / (gain + discriminant.sqrt()) * (1 + MARGIN))
    high = bounds.largest
    if z2 > 0:
        limit = (gain / z2 * (1 - MARGIN)).lower()
        high = limit if limit < high else high
    if not (low < high and y - gain * low + z2 * low**2 / 2 <= 0 and z1 + z2 * high < 1):
        raise NotProved(f"not proved: {shown}; the radius {float(low):.3g} exceeds r* = "
                        f"{float(bounds.largest):.3g}")
    return low, high
