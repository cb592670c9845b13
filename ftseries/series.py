r"""Fourier-Taylor series: one lazily evaluated order-k step for every operation.

Index convention and formula.  A series is

.. math::  u(τ; λ) = \sum_k λ^k u_k(τ), \qquad u_k = \sum_n A_{n,k} \cos nτ + B_{n,k} \sin nτ,

and ``u[k]`` is its Taylor coefficient u_k, a :class:`ftseries.trig.Trig`.  Every operation is a
node that gives its coefficient k from coefficients ≤ k of its operands:

=============  ==========================================================================
product        c_k = Σ_j a_j b_{k-j}
power w = u^α  k u_0 w_k = Σ_{j≥1} ((α+1) j - k) u_j w_{k-j}      (from u w' = α u' w)
e = exp u      k e_k = Σ_{j≥1} j u_j e_{k-j}
sin u, cos u   k s_k = Σ_{j≥1} j u_j c_{k-j},   k c_k = -Σ_{j≥1} j u_j s_{k-j}
=============  ==========================================================================

(Knuth, TAOCP 2, 4.7; the prime is d/dλ.)  A solver changes the last few coefficients of the
unknowns again and again.  :meth:`ftseries.expansion.Expansion.forget` makes every node drop what
depends on them; the *deep* part of each sum, which uses settled coefficients only, is kept, so that
a second look at an order costs a handful of products.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

from flint import fmpq

from .aliases import Exact, Multiplier, Number, Term
from .arguments import decimal
from .errors import InputError
from .function import Function

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["Series", "exp", "sin", "cos"]

#: orders from either end of a Cauchy sum that are summed anew after a change
WINDOW = 3


class Series(Function):
    """A Fourier-Taylor series; ``u[k]`` is the Taylor coefficient of order k."""

    def __init__(self, expansion: Expansion) -> None:
        self.expansion, self.ring = expansion, expansion.ring
        self.table = self.ring.table()
        expansion.nodes.append(self)

    def __getitem__(self, k: int) -> Term:
        while len(self.table) <= k:
            self.table.append(self.step(len(self.table)))
        return self.table[k]

    def step(self, k: int) -> Term:
        """Coefficient k from lower ones and from the operands."""
        raise NotImplementedError

    def forget(self, k: int) -> None:
        self.table.cut(k)

    def _sum(self, other: Series) -> Series:
        return Sum(self, other)

    def _product(self, other: Series) -> Series:
        return Product(self, other)

    def _multiple(self, number: Exact) -> Series:
        return Multiple(self, decimal(number))

    def _power(self, alpha: fmpq) -> Series:
        return Power(self, alpha)

    def diff(self, times: int = 1) -> Series:
        if times not in DERIVATIVES:
            raise InputError(f"a derivative of order {times!r} is not offered; use 1 or 2")
        return ModeMultiple(self, DERIVATIVES[times])

    def shift(self, fraction: Exact) -> Series:
        fraction = decimal(fraction)
        return ModeMultiple(self, lambda n, ring: ring.turn(fraction * n))

    def neighbours(self, bodies: int = 3) -> Series:
        return ModeMultiple(self, _neighbours(bodies))

    def sin(self) -> Series:
        return self._sincos()[0]

    def cos(self) -> Series:
        return self._sincos()[1]

    def exp(self) -> Series:
        return Exp(self)

    def _sincos(self) -> tuple[Series, Series]:
        pairs = self.expansion.pairs
        if self not in pairs:
            s, c = pairs[self] = SinCos(self, True), SinCos(self, False)
            s.partner, c.partner = c, s
        found: tuple[Series, Series] = pairs[self]
        return found


@cache
def _neighbours(bodies: int) -> Multiplier:
    return lambda n, ring: (bodies - 1 if n % bodies == 0 else -1, 0)


#: how d/dτ and d²/dτ² multiply the modes
DERIVATIVES = {1: lambda n, ring: (0, n), 2: lambda n, ring: (-n * n, 0)}


class Sum(Series):
    def __init__(self, a: Series, b: Series) -> None:
        super().__init__(a.expansion)
        self.a, self.b = a, b

    def step(self, k: int) -> Term:
        return self.a[k] + self.b[k]


class Multiple(Series):
    def __init__(self, a: Series, number: Number) -> None:
        super().__init__(a.expansion)
        self.a, self.number = a, self.ring.number(number)

    def step(self, k: int) -> Term:
        return self.a[k].scale(self.number)


class ModeMultiple(Series):
    """Every Fourier mode multiplied by a number of its own: d/dτ, shifts."""

    def __init__(self, a: Series, multiplier: Multiplier) -> None:
        super().__init__(a.expansion)
        self.a, self.multiplier = a, multiplier

    def step(self, k: int) -> Term:
        return self.a[k].multiply_modes(self.multiplier)


class Convolution(Series):
    """A node that needs Cauchy sums Σ_{j=first}^{k} (α + β j) a_j b_{k-j}."""

    def __init__(self, expansion: Expansion) -> None:
        super().__init__(expansion)
        self.deep: dict[int, Term] = {}

    def forget(self, k: int) -> None:
        super().forget(k)
        for key in [key for key in self.deep if key >= k + WINDOW]:
            del self.deep[key]

    def sum(self, a: Series, b: Series, k: int, first: int = 0, alpha: int = 1,
            beta: int = 0) -> Term:
        a[k], b[k - first]
        low, high = WINDOW, k - WINDOW
        if high < low:
            return self.ring.convolve(a.table, b.table, k, first, k, alpha, beta)
        if k not in self.deep:
            self.deep[k] = self.ring.convolve(a.table, b.table, k, low, high, alpha, beta)
            self.deep.pop(k - 3 * WINDOW, None)
        near = self.ring.convolve(a.table, b.table, k, first, low - 1, alpha, beta)
        far = self.ring.convolve(a.table, b.table, k, high + 1, k, alpha, beta)
        return self.deep[k] + near + far


class Product(Convolution):
    def __init__(self, a: Series, b: Series) -> None:
        super().__init__(a.expansion)
        self.a, self.b = a, b

    def step(self, k: int) -> Term:
        return self.sum(self.a, self.b, k)


class Power(Convolution):
    def __init__(self, u: Series, alpha: fmpq) -> None:
        super().__init__(u.expansion)
        self.u, self.alpha = u, alpha

    def step(self, k: int) -> Term:
        if k == 0:
            first = self.u[0].power(self.alpha)
            self.inverse = self.u[0].power(-1)
            return first
        p, q = int(self.alpha.p), int(self.alpha.q)
        if p == -q:
            return self.inverse * self.sum(self.u, self, k, 1, -1)
        total = self.sum(self.u, self, k, 1, -k * q, p + q)
        return (self.inverse * total).scale(self.ring.number(fmpq(1, k * q)))


class Exp(Convolution):
    def __init__(self, u: Series) -> None:
        super().__init__(u.expansion)
        self.u = u

    def step(self, k: int) -> Term:
        if k == 0:
            return self.u[0].exp()
        return self.sum(self.u, self, k, 1, 0, 1).scale(self.ring.number(fmpq(1, k)))


class SinCos(Convolution):
    """sin u or cos u; each keeps the other as ``partner``."""

    def __init__(self, u: Series, sine: bool) -> None:
        super().__init__(u.expansion)
        self.u, self.sine = u, sine
        self.partner: Series = self

    def step(self, k: int) -> Term:
        if k == 0:
            return self.u[0].sincos()[0 if self.sine else 1]
        sign = 1 if self.sine else -1
        return self.sum(self.u, self.partner, k, 1, 0, sign).scale(self.ring.number(fmpq(1, k)))


def sin(u: Any) -> Any:
    """sin u of a series that vanishes at λ = 0."""
    return u.sin()


def cos(u: Any) -> Any:
    """cos u of a series that vanishes at λ = 0."""
    return u.cos()


def exp(u: Any) -> Any:
    """exp u of a series that vanishes at λ = 0."""
    return u.exp()
