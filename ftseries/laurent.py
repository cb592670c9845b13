r"""Exact and rigorous rings: a finite Fourier sum as a Laurent polynomial.

Index convention and formula.  With z = e^{iτ} and w = z², a part (see :mod:`ftseries.trig`) is a
triple (d, p, c) standing for

.. math::  z^{-d} p(w) / c \text{ (cosine kinds)}, \qquad i z^{-d} p(w) / c \text{ (sine kinds)},

where the polynomial p has degree at most d and d has the parity of n.  So for n > 0 the
coefficients of w^{(d+n)/2} and w^{(d-n)/2} in p/c are both A_n/2, or -B_n/2 and B_n/2, and a
product of Fourier sums is a product of FLINT polynomials.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from typing import TypeAlias

import sympy as sp
from flint import (
    Ordering,
    arb,
    arb_poly,
    fmpq,
    fmpq_mpoly,
    fmpq_mpoly_ctx,
    fmpq_poly,
    fmpz,
    fmpz_poly,
)

from .aliases import Exact, Expr, Modes, Multiplier, Number, Part, Parts
from .arguments import rational
from .conversion import to_sympy
from .errors import InputError
from .trig import Ring

__all__ = ["RationalRing", "PolynomialRing", "SurdRing", "BallRing"]

#: no number in a memory has a root of this degree
_DEGREE = 2**31
#: terms (p, q, weight) of a sum of products
Products: TypeAlias = list[tuple[Part, Part, Number]]


class _LaurentRing(Ring):
    """Parts are triples (d, p, c); only the rational ring has c other than 1."""

    #: the part of the constant 1
    one: Part

    def coefficients(self, part: Part) -> Iterable[tuple[int, Number]]:
        """Pairs (i, coefficient of w^i in p/c)."""
        raise NotImplementedError

    def pack(self, d: int, values: dict[int, Number]) -> Part:
        """The part with these coefficients of w^i."""
        raise NotImplementedError

    def raise_degree(self, p: Part, i: int) -> Part:
        """p · w^i."""
        raise NotImplementedError

    def modes(self, parts: Parts) -> Modes:
        out: Modes = {}
        for kind, part in parts.items():
            sine, d = kind >> 1, part[0]
            for i, value in self.coefficients(part):
                n = 2 * i - d
                if n >= 0 and not self.is_zero(value):
                    out[sine, n] = value if n == 0 else -2 * value if sine else 2 * value
        return out

    def part(self, kind: int, modes: dict[int, Number]) -> Part:
        sine, d = kind >> 1, max(modes)
        values = {}
        for n, value in modes.items():
            if n == 0:
                values[d // 2] = value
            else:
                half = value * self.number(fmpq(1, 2))
                values[(d + n) // 2] = -half if sine else half
                values[(d - n) // 2] = half
        return self.pack(d, values)

    def multiply_modes(self, kind: int, part: Part,
                       multiplier: Multiplier) -> list[tuple[int, Part]]:
        d = part[0]
        stay: dict[int, Number] = {}
        swap: dict[int, Number] = {}
        for i, value in self.coefficients(part):
            a, b = multiplier(2 * i - d, self)
            if a:
                stay[i] = value * a
            if b:
                swap[i] = value * -b if kind & 2 else value * b
        return [(new, self.pack(d, values)) for new, values in ((kind, stay), (kind ^ 2, swap))
                if values]

    def add(self, a: Part, b: Part) -> Part:
        one = self.one
        return self.dot([(a, one, 1), (b, one, 1)])

    def scale(self, part: Part, number: Number) -> Part:
        return part[0], part[1] * self.number(number), 1

    def dot(self, terms: Products) -> Part:
        """Σ weight · p · q over the terms (p, q, weight), all of one kind."""
        top = max(p[0] + q[0] for p, q, _ in terms)
        total = None
        for (d, p, _), (e, q, _), weight in terms:
            product = p * q
            if weight != 1:
                product *= self.number(weight)
            if d + e != top:
                product = self.raise_degree(product, (top - d - e) // 2)
            total = product if total is None else total + product
        return top, total, 1


class RationalRing(_LaurentRing):
    """Exact rational numbers: FLINT integer polynomials over one common denominator."""

    name = "exact"
    one = (0, fmpz_poly([1]), fmpz(1))

    def number(self, x: Exact) -> fmpq:
        return rational(x)

    def coefficients(self, part: Part) -> Iterable[tuple[int, Number]]:
        return ((i, fmpq(value, part[2])) for i, value in enumerate(part[1].coeffs()))

    def pack(self, d: int, values: dict[int, Number]) -> Part:
        return self.reduced(d, fmpq_poly([values.get(i, 0) for i in range(d + 1)]))

    def reduced(self, d: int, q: fmpq_poly) -> Part:
        return d, q.numer(), q.denom()

    def add(self, a: Part, b: Part) -> Part:
        (d, p, c), (e, q, f) = (a, b) if a[0] >= b[0] else (b, a)
        q = q.left_shift((d - e) // 2) if d != e else q
        return self.reduced(d, fmpq_poly(p, c) + fmpq_poly(q, f))

    def scale(self, part: Part, number: Number) -> Part:
        d, p, c = part
        return self.reduced(d, fmpq_poly(p, c) * rational(number))

    def multiply_modes(self, kind: int, part: Part,
                       multiplier: Multiplier) -> list[tuple[int, Part]]:
        d, p, c = part
        values = p.coeffs()
        real, imaginary = zip(*(multiplier(2 * i - d, self) for i in range(len(values) or 1)))
        sign = -1 if kind & 2 else 1
        images = [(kind, [v * a for v, a in zip(values, real)]),
                  (kind ^ 2, [v * (sign * b) for v, b in zip(values, imaginary)])]
        return [(new, (d, fmpz_poly(image), c)) for new, image in images if any(image)]

    def root(self, value: fmpq, alpha: Exact) -> fmpq:
        alpha = rational(alpha)
        degree = int(alpha.q)
        if value == 1:
            return value
        if degree > 1:
            roots = [part.root(degree) for part in (value.p, value.q)] \
                if value > 0 and degree < _DEGREE else None
            if not roots or fmpq(*roots) ** degree != value:
                raise InputError(f"({value})^({alpha}) is not rational; choose units in which the "
                                 "value at λ = 0 has a rational power")
            value = fmpq(*roots)
        return value ** int(alpha.p)

    def dot(self, terms: Products) -> Part:
        top = max(p[0] + q[0] for p, q, _ in terms)
        scales = [fmpq(1, p[2] * q[2]) * weight for p, q, weight in terms]
        common = reduce(fmpz.lcm, (s.q for s in scales))
        total = fmpz_poly()
        for ((d, p, _), (e, q, _), _), s in zip(terms, scales):
            product = p * q * (s.p * (common // s.q))
            total += product.left_shift((top - d - e) // 2) if d + e != top else product
        return self.reduced(top, fmpq_poly(total, common))


class PolynomialRing(_LaurentRing):
    """Polynomials with rational coefficients in parameters: names, or SymPy expressions.

    FLINT knows ASCII names only, so that its variables are numbered, whatever the parameters are.
    """

    name = "exact"

    def __init__(self, names: Sequence[str | Expr]) -> None:
        self.names = tuple(names)
        self.context = fmpq_mpoly_ctx.get(["w", *(f"p{i}" for i in range(len(self.names)))],
                                          Ordering.lex)
        self.w, *self.parameters = self.context.gens()
        self.one = (0, self.context.constant(1), 1)

    def number(self, x: Exact) -> fmpq_mpoly:
        if isinstance(x, type(self.w)):
            return x
        return self.context.constant(rational(x))

    def parameter(self, name: str | Expr) -> fmpq_mpoly:
        return self.parameters[self.names.index(name)]

    def written(self, number: fmpq_mpoly) -> str:
        return str(to_sympy(number, self.names))

    def coefficients(self, part: Part) -> Iterable[tuple[int, Number]]:
        rows: dict[int, dict[tuple[int, ...], fmpq]] = {}
        for (i, *rest), c in part[1].to_dict().items():
            rows.setdefault(i, {})[(0, *rest)] = c
        return ((i, self.context.from_dict(terms)) for i, terms in rows.items())

    def pack(self, d: int, values: dict[int, Number]) -> Part:
        total = self.context.constant(0)
        for i, value in values.items():
            total += self.number(value) * self.w**i
        return d, total, 1

    def raise_degree(self, p: fmpq_mpoly, i: int) -> fmpq_mpoly:
        return p * self.w**i

    def root(self, value: fmpq_mpoly, alpha: Exact) -> fmpq_mpoly:
        if not value.is_constant():
            raise InputError("a power of an expression that depends on a parameter at λ = 0 is not "
                             "a polynomial; give the parameter a value")
        return self.number(RationalRing().root(fmpq(value.leading_coefficient()), alpha))


class SurdRing(PolynomialRing):
    """The same over the field Q(√3): what thirds and twelfths of a period ask for.

    √3 is a further variable s, and every result is reduced modulo s² - 3.
    """

    def __init__(self, names: Sequence[str | Expr] = ()) -> None:
        super().__init__((*names, sp.sqrt(3)))
        self.surd = self.parameters[-1]
        self.relation = self.surd**2 - 3

    def turn(self, fraction: Exact) -> tuple[Number, Number]:
        half, side = self.number(fmpq(1, 2)), self.surd * fmpq(1, 2)
        one, zero = self.number(1), self.number(0)
        cosines = [one, side, half, zero, -half, -side, -one, -side, -half, zero, half, side]
        twelfths = 12 * rational(fraction)
        if twelfths.q != 1:
            return super().turn(fraction)
        i = int(twelfths.p)
        return cosines[i % 12], cosines[(i - 3) % 12]

    def pack(self, d: int, values: dict[int, Number]) -> Part:
        return self.reduced(super().pack(d, values))

    def scale(self, part: Part, number: Number) -> Part:
        return self.reduced(super().scale(part, number))

    def dot(self, terms: Products) -> Part:
        return self.reduced(super().dot(terms))

    def reduced(self, part: Part) -> Part:
        d, p, c = part
        return d, p % self.relation, c


class BallRing(_LaurentRing):
    """Real balls of FLINT: midpoint and radius, rounded outwards at the precision in force."""

    name = "ball"
    one = (0, arb_poly([1]), 1)

    def number(self, x: Exact) -> arb:
        if isinstance(x, arb):
            return x
        x = rational(x)
        return arb(x.p) / x.q if x.q != 1 else arb(x.p)

    def coefficients(self, part: Part) -> Iterable[tuple[int, Number]]:
        return enumerate(part[1].coeffs())

    def pack(self, d: int, values: dict[int, Number]) -> Part:
        return d, arb_poly([values.get(i, 0) for i in range(d + 1)]), 1

    def raise_degree(self, p: arb_poly, i: int) -> arb_poly:
        return p.left_shift(i)

    def root(self, value: arb, alpha: Exact) -> arb:
        alpha = rational(alpha)
        root = value ** arb(alpha)
        if not root.is_finite():
            raise InputError(f"({value})^({alpha}), a root of a negative number or a power of a "
                             "ball with zero inside, is not real and finite; raise the precision")
        return root

    def turn(self, fraction: Exact) -> tuple[Number, Number]:
        fraction = 2 * rational(fraction)
        return arb.cos_pi_fmpq(fraction), arb.sin_pi_fmpq(fraction)

    def negligible(self, number: arb, scale: float) -> bool:
        return number.contains(0)
