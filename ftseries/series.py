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

from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING, Any, TypeAlias

from flint import fmpq
from sympy import SympifyError

from .aliases import Exact, Function, Multiplier, Number, Term
from .arguments import decimal
from .errors import InputError

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["Series", "exp", "sin", "cos"]

#: what stands beside a series in a formula: another one, or a number
Operand: TypeAlias = "Series | Exact"

#: orders from either end of a Cauchy sum that are summed anew after a change
WINDOW = 3


class NotSymPy(InputError, SympifyError):  # type: ignore[misc]   # SymPy has no types
    """SymPy's own numbers step back at this one, so that Rational(1, 3) * x is a series."""

    __str__ = ValueError.__str__


def _refusal(sentence: str, error: type[InputError] = InputError) -> Callable[..., Any]:
    def refuse(self: Series, *_: Any) -> Any:
        raise error(sentence)
    return refuse


class Series:
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

    def __add__(self, other: Operand) -> Series:
        return Sum(self, self._series(other))

    __radd__ = __add__

    def __neg__(self) -> Series:
        return self * -1

    def __sub__(self, other: Operand) -> Series:
        return self + -self._series(other)

    def __rsub__(self, other: Operand) -> Series:
        return self._series(other) + -self

    def __mul__(self, other: Operand) -> Series:
        return Product(self, other) if isinstance(other, Series) else Multiple(self, decimal(other))

    __rmul__ = __mul__

    def __truediv__(self, other: Operand) -> Series:
        if isinstance(other, Series):
            return self * other**-1
        number = decimal(other)
        if number == 0:
            raise InputError("a series is divided by the number zero")
        return Multiple(self, 1 / number)

    def __rtruediv__(self, other: Operand) -> Series:
        return self**-1 * other

    def __pow__(self, alpha: Exact) -> Series:
        alpha = decimal(alpha)
        if alpha.q == 1 and alpha > 0:
            if alpha == 1:
                return self
            half = self ** int(alpha.p // 2)
            return half * half * self if alpha.p % 2 else half * half
        return self._series(1) if alpha == 0 else Power(self, alpha)

    def diff(self, times: int = 1) -> Series:
        """The derivative d/dτ, or one of higher order."""
        if times not in DERIVATIVES:
            raise InputError(f"a derivative of order {times!r} is not offered; use 1 or 2")
        return ModeMultiple(self, DERIVATIVES[times])

    def shift(self, fraction: Exact) -> Series:
        """The series at τ + 2π·fraction, for a rational fraction of a period."""
        fraction = decimal(fraction)
        return ModeMultiple(self, lambda n, ring: ring.turn(fraction * n))

    def neighbours(self, bodies: int = 3) -> Series:
        """The sum of the series at τ + 2πj/bodies, j = 1 … bodies-1: what the others of a
        choreography contribute.  Mode n is multiplied by bodies - 1 if bodies divides n, else
        by -1, so it is rational although the single shifts are not."""
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
        return pairs[self]

    def _series(self, x: Operand) -> Series:
        return x if isinstance(x, Series) else self.expansion.constant(x)

    # What Python offers to numbers, and a series cannot be asked.
    __xor__ = __rxor__ = _refusal("^ is no power in Python; write x**3")
    __abs__ = _refusal("|x| has no Fourier-Taylor series; write a formula that is analytic, such "
                       "as x**2")
    __lt__ = __le__ = __gt__ = __ge__ = _refusal(
        "a series is neither large nor small, so equations cannot hold if, max or min of one; "
        "write formulas that are analytic")
    __float__ = __complex__ = _sympy_ = _refusal(
        "functions of math and SymPy do not know series; use ftseries.sin, ftseries.cos, "
        "ftseries.exp, and powers such as x**Fraction(1, 2)", NotSymPy)
    sqrt = log = tan = sinh = cosh = tanh = _refusal(
        "of NumPy's functions, a series knows sin, cos and exp; write the others by these and by "
        "powers, such as x**Fraction(1, 2) for a root")


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


def sin(u: Function) -> Function:
    """sin u of a series that vanishes at λ = 0."""
    return u.sin()


def cos(u: Function) -> Function:
    """cos u of a series that vanishes at λ = 0."""
    return u.cos()


def exp(u: Function) -> Function:
    """exp u of a series that vanishes at λ = 0."""
    return u.exp()
