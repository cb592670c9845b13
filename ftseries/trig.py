r"""One Taylor order of a Fourier-Taylor series: a finite Fourier sum.

Index convention and formula.  A sum

.. math::  f(τ) = \sum_{n \ge 0} A_n \cos nτ + \sum_{n \ge 1} B_n \sin nτ

is split into at most four *parts*, one for each **kind** = (parity of n) + 2·(0 cosine, 1 sine):

====  ===========  ======================
kind  modes        symmetries
====  ===========  ======================
0     cos, n even  even in τ, period π
1     cos, n odd   even in τ, antiperiod π
2     sin, n even  odd in τ, period π
3     sin, n odd   odd in τ, antiperiod π
====  ===========  ======================

The kind of a product is the exclusive or of the kinds of its factors, so symmetries cost nothing
to keep and absent parts cost nothing at all.  A mode is named ``(sine, n)`` with sine 0 or 1.

What a part holds is the business of a :class:`Ring`: Laurent polynomials in e^{iτ} for exact
numbers and balls (:mod:`ftseries.laurent`), values on a grid for floats (:mod:`ftseries.grid`).
"""

from __future__ import annotations

from .aliases import Exact, Expr, Modes, Multiplier, Number, Part, Parts, Term, Terms
from .arguments import rational
from .errors import InputError, NonAnalyticError

__all__ = ["Trig", "Ring", "Table"]


class Trig:
    """A finite Fourier sum: ``parts`` maps a kind to the ring's data for it."""

    __slots__ = ("ring", "parts")

    def __init__(self, ring: Ring, parts: Parts) -> None:
        self.ring, self.parts = ring, parts

    def __add__(self, other: Trig) -> Trig:
        if not (self.parts and other.parts):
            return self if self.parts else other
        parts = dict(self.parts)
        for kind, b in other.parts.items():
            parts[kind] = self.ring.add(parts[kind], b) if kind in parts else b
        return Trig(self.ring, parts)

    def __mul__(self, other: Trig) -> Trig:
        return self.ring.convolve([self], [other], 0, 0, 0)

    def scale(self, number: Number) -> Trig:
        """The sum times a number of the ring."""
        return Trig(self.ring, {k: self.ring.scale(p, number) for k, p in self.parts.items()})

    def multiply_modes(self, multiplier: Multiplier) -> Trig:
        """The sum with every e^{inτ} replaced by (a + ib) e^{inτ}, (a, b) = multiplier(n, ring)."""
        parts: Parts = {}
        for kind, part in self.parts.items():
            for new, image in self.ring.multiply_modes(kind, part, multiplier):
                parts[new] = self.ring.add(parts[new], image) if new in parts else image
        return Trig(self.ring, parts)

    def modes(self) -> Modes:
        """The non-zero coefficients as a dict ``{(sine, n): number}``."""
        return self.ring.modes(self.parts)

    # The first coefficient of a power, exponential, sine, cosine -- where Taylor recurrences start.
    def constant(self, what: str) -> Number:
        """The value of a sum that is a constant; ``what`` names the operation that needs one."""
        modes = self.modes()
        size = self.ring.size(modes)
        if any(mode != (0, 0) and not self.ring.negligible(c, size) for mode, c in modes.items()):
            raise NonAnalyticError(f"{what} needs an argument that is constant at λ = 0, but it "
                                   "oscillates there; expand about a constant state")
        return modes.get((0, 0), self.ring.number(0))

    def power(self, alpha: Exact) -> Trig:
        value = self.constant(f"the power {alpha}")
        if self.ring.is_zero(value):
            raise NonAnalyticError(f"the power {alpha} of a quantity that vanishes at λ = 0 is not "
                                   "analytic there, so no Fourier-Taylor series exists; choose "
                                   "other variables")
        return self.ring.from_modes({(0, 0): self.ring.root(value, alpha)})

    def exp(self) -> Trig:
        if not self.ring.is_zero(self.constant("exp")):
            raise NonAnalyticError("exp, sin and cos need an argument that is zero at λ = 0; "
                                   "split its constant off by an addition theorem")
        return self.ring.from_modes({(0, 0): self.ring.number(1)})

    def sincos(self) -> tuple[Trig, Trig]:
        return self.ring.from_modes({}), self.exp()


class Ring:
    """Arithmetic of finite Fourier sums; subclasses say what a number and a part are."""

    #: the free parameters, which :class:`ftseries.laurent.PolynomialRing` carries
    names: tuple[str | Expr, ...] = ()
    #: is the residual decided exactly (or by balls), or up to rounding?
    exact = True

    def number(self, x: Exact) -> Number:
        """A rational as a number of the ring."""
        raise NotImplementedError

    def written(self, number: Number) -> str:
        """A number as messages write it."""
        return str(number)

    def part(self, kind: int, modes: dict[int, Number]) -> Part:
        """The data of the modes ``{n: number}`` of one kind."""
        raise NotImplementedError

    def modes(self, parts: Parts) -> Modes:
        """The non-zero coefficients in all parts."""
        raise NotImplementedError

    def add(self, a: Part, b: Part) -> Part:
        raise NotImplementedError

    def scale(self, part: Part, number: Number) -> Part:
        raise NotImplementedError

    def multiply_modes(self, kind: int, part: Part,
                       multiplier: Multiplier) -> list[tuple[int, Part]]:
        """The parts (kind, data) that :meth:`Trig.multiply_modes` makes of one."""
        raise NotImplementedError

    def root(self, value: Number, alpha: Exact) -> Number:
        """A number to a rational power."""
        raise NotImplementedError

    def dot(self, terms: list[tuple[Part, Part, Number]]) -> Part:
        """Σ weight · p · q over the terms (p, q, weight), all of one kind."""
        raise NotImplementedError

    def parameter(self, name: str) -> Number:
        """A free parameter as a number of the ring."""
        raise NotImplementedError

    def from_modes(self, modes: Modes) -> Trig:
        """The :class:`Trig` with the given ``{(sine, n): number}``."""
        kinds: dict[int, dict[int, Number]] = {}
        for (sine, n), value in modes.items():
            kinds.setdefault(n % 2 + 2 * sine, {})[n] = value
        return Trig(self, {k: self.part(k, m) for k, m in kinds.items()})

    def table(self) -> Terms:
        """An empty table of Taylor coefficients."""
        return Table()

    def is_zero(self, number: Number) -> bool:
        return bool(number == 0)

    def size(self, modes: Modes) -> float:
        """A scale for :meth:`negligible`: the largest of these coefficients."""
        return 1

    def turn(self, fraction: Exact) -> tuple[Number, Number]:
        """(cos, sin) of that fraction of a full turn, where the ring has them."""
        quarters = 4 * rational(fraction)
        if quarters.q != 1:
            raise InputError(f"a shift by {fraction} of a period multiplies some mode by an "
                             "irrational number, but every solve begins in exact arithmetic; use "
                             "the sum over all shifts of a choreography, Series.neighbours, or "
                             "for twelfths declare the problem with surd = True")
        return ((1, 0), (0, 1), (-1, 0), (0, -1))[int(quarters.p) % 4]

    def negligible(self, number: Number, scale: float) -> bool:
        """Is this number of a residual zero?  ``scale`` is the size of the terms behind it."""
        return bool(number == 0)

    def convolve(self, a: Terms, b: Terms, k: int, lo: int, hi: int, alpha: int = 1,
                 beta: int = 0) -> Trig:
        """The Cauchy sum Σ_{j=lo}^{hi} (alpha + beta j) a_j b_{k-j} of two tables."""
        pairs: dict[int, list[tuple[Part, Part, Number]]] = {}
        fold = a is b and not beta and lo + hi == k     # a square: take each pair once, twice
        for j in range(lo, (k // 2 if fold else hi) + 1):
            u, v = a[j].parts, b[k - j].parts
            if not (u and v):
                continue
            weight = alpha + beta * j
            if fold and 2 * j != k:
                weight = 2 * weight
            for ku, p in u.items():
                for kv, q in v.items():
                    sign = -weight if ku & kv & 2 else weight       # i·i = -1
                    pairs.setdefault(ku ^ kv, []).append((p, q, sign))
        return Trig(self, {kind: self.dot(terms) for kind, terms in pairs.items()})


class Table(list[Term]):
    """The Taylor coefficients 0, 1, 2, … of a series, as :class:`Trig`."""

    def cut(self, k: int) -> None:
        del self[k:]
