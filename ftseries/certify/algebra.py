r"""A rigorous sequence algebra: Fourier sums with a bound on what is missing.

Formula.  For f = Σ A_n cos nτ + B_n sin nτ and a weight ν ≥ 1 let

.. math::  \|f\|_ν = \sum_n (|A_n| + |B_n|)\, ν^n .

Because cos a cos b = (cos(a-b) + cos(a+b))/2 and likewise for sines, ‖fg‖ ≤ ‖f‖ ‖g‖: the
functions of finite norm are a Banach algebra, and ‖f‖ bounds |f| everywhere.  An
:class:`Enclosure` (c, δ) stands for all f with ‖f - c‖ ≤ δ, where c is a finite sum whose
coefficients are balls.

The negative powers of a function w > 0 come from an approximation v of w^{-1/2}: with ε = 1 - v²w,

.. math::  w^{-p/2} = v^p (1 - ε)^{-p/2}, \qquad
           \|(1-ε)^{-p/2} - 1\| \le (1 - \|ε\|)^{-p/2} - 1 \quad\text{if } \|ε\| < 1.

Then w > 0 and v has no zero; v(0) > 0 makes v^p (1 - ε)^{-p/2} the positive root for odd p.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import reduce
from typing import TYPE_CHECKING, Any

from flint import arb, ctx

from .. import arguments
from ..errors import InputError
from ..laurent import BallRing
from .balls import NotProved

if TYPE_CHECKING:
    from ..trig import Trig

__all__ = ["Enclosure", "given", "largest_of", "negative_power", "norm", "truncate", "upper",
           "written"]

RING = BallRing()


def given(name: str, value: Any) -> arb:
    """A ball that contains a number, taken by its decimals: "0.1" and 0.1 are a tenth.

    >>> given("nu", "1.02").str(5, radius=False)
    '1.0200'
    """
    try:
        return arb(arguments.decimal(value))
    except InputError as error:
        raise InputError(f"{name}={arguments.shown(value)} is not a number ({error})") from None


def written(name: str, value: Any) -> str:
    """The same number as a decimal text, for a certificate; refuses what is none, such as 1/3.

    >>> written("nu", 1.02), written("lam", "2.50"), written("lam", 30)
    ('1.02', '2.5', '30')
    """
    given(name, value)
    x = arguments.decimal(value)
    places = next((n for n in range(arguments.DIGITS) if 10**n % x.q == 0), None)
    if places is None:
        raise InputError(f"{name}={value} is not a decimal; give one, such as "
                         f"{float(x.p) / float(x.q):.6g}")
    text: str = (abs(x.p) * 10**places // x.q).str().rjust(places + 1, "0")
    return "-" * bool(x < 0) + text[:len(text) - places] + "." * bool(places) \
        + text[len(text) - places:]


def upper(x: arb | int) -> arb:
    """The upper end of a ball, as an exact number."""
    return x.abs_upper() if isinstance(x, arb) else arb(x)


def largest_of(values: Iterable[arb]) -> arb:
    """An upper bound of all of them, as an exact number."""
    return reduce(lambda a, b: upper(a.max(b)), values, arb(0))


def norm(trig: Trig, nu: arb) -> arb:
    """A bound of ‖·‖_ν of a finite sum."""
    total = arb(0)
    for (_, n), c in trig.modes().items():
        total += upper(c) * nu**n
    return upper(total)


def truncate(trig: Trig, top: int, nu: arb) -> tuple[Trig, arb]:
    """(sum of the modes up to ``top``, norm of the rest)."""
    modes = trig.modes()
    rest = {mode: c for mode, c in modes.items() if mode[1] > top}
    return (RING.from_modes({mode: c for mode, c in modes.items() if mode[1] <= top}),
            norm(RING.from_modes(rest), nu))


def negative_power(w: Any, p: int, root: Any, one: Any) -> Any:
    """w^{-p/2} in any Banach algebra, from ``root`` close to w^{-1/2}; the formula above."""
    defect = (one + root * root * w * -1).norm()
    if not defect < 1:
        raise NotProved(f"not proved: ‖1 - v²w‖ = {float(defect):.3g} is not below 1; give "
                        "more modes or a better approximation")
    power = root
    for _ in range(p - 1):
        power = power * root
    return power.widened(power.norm() * ((1 - defect) ** (-arb(p) / 2) - 1))


class Enclosure:
    """All functions within ``radius`` of the finite sum ``center``, in the norm with weight ν."""

    def __init__(self, center: Trig, radius: Any, nu: arb) -> None:
        self.center, self.radius, self.nu = center, upper(radius), nu

    def norm(self) -> arb:
        return upper(norm(self.center, self.nu) + self.radius)

    def __add__(self, other: Enclosure) -> Enclosure:
        return Enclosure(self.center + other.center, self.radius + other.radius, self.nu)

    def __mul__(self, other: Enclosure | arb | float) -> Enclosure:
        if not isinstance(other, Enclosure):
            number = other if isinstance(other, arb) else arb(other)
            return Enclosure(self.center.scale(number), self.radius * upper(number), self.nu)
        radius = (norm(self.center, self.nu) * other.radius
                  + norm(other.center, self.nu) * self.radius + self.radius * other.radius)
        return Enclosure(self.center * other.center, radius, self.nu)

    def widened(self, error: Any) -> Enclosure:
        return Enclosure(self.center, self.radius + error, self.nu)

    def cut(self, top: int) -> Enclosure:
        """The same set, or a larger one, with a center of at most ``top`` modes."""
        center, rest = truncate(self.center, top, self.nu)
        return Enclosure(center, self.radius + rest, self.nu)

    def negative_power(self, p: int, v: Trig) -> Enclosure:
        """w^{-p/2} of this w, from an approximation ``v`` (a finite sum) of w^{-1/2}.

        Raises
        ------
        NotProved
            v is too poor: ‖1 - v²w‖ is not below 1.
        """
        one = Enclosure(RING.from_modes({(0, 0): arb(1)}), 0, self.nu)
        power: Enclosure = negative_power(self, p, Enclosure(v, 0, self.nu), one)
        if not sum((c for (sine, _), c in v.modes().items() if not sine), arb(0)) > 0:
            raise NotProved("not proved: v(0) > 0, so v may approximate the negative root")
        return power

    def cos_sin(self, top: int) -> list[Enclosure]:
        """cos and sin of it, by Taylor's series in the algebra, with at most ``top`` modes."""
        size, k, bound = self.norm(), 0, arb(1)
        term = Enclosure(RING.from_modes({(0, 0): arb(1)}), 0, self.nu)
        sums = [term * 0, term * 0]
        while not (k > 2 * size and bound < arb(2) ** -ctx.prec):    # bound = ‖f‖^k / k!
            sums[k % 2] += term * (-1 if k % 4 > 1 else 1)
            k += 1
            term = (term * self).cut(top) * (1 / arb(k))
            bound = upper(bound * size / k)
        return [Enclosure(s.center, s.radius + 2 * bound, self.nu) for s in sums]
