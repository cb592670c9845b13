"""What every formula of a problem may do: the operators, once for all kinds of functions.

A problem is declared once, and its equations are run over different functions of τ and λ: series
(:mod:`ftseries.series`), samples at a number λ (:mod:`ftseries.sampling`), power series at a
number τ (:mod:`ftseries.phases`).  A kind says how it adds, multiplies and raises to a power; what
follows from these is here.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any, Self, cast

from flint import fmpq
from sympy import SympifyError

from .aliases import Exact
from .arguments import decimal
from .errors import InputError

__all__ = ["Function"]


class NotSymPy(InputError, SympifyError):  # type: ignore[misc]   # SymPy has no types
    """SymPy's own numbers step back at this one, so that Rational(1, 3) * x is a function."""

    __str__ = ValueError.__str__


def _refusal(sentence: str, error: type[InputError] = InputError) -> Callable[..., Any]:
    def refuse(self: Function, *_: Any) -> Any:
        raise error(sentence)
    return refuse


class Function(ABC):
    """A function of τ and λ in a formula; ``expansion`` makes constants, λ and known functions."""

    expansion: Any

    @abstractmethod
    def _sum(self, other: Self) -> Self: ...

    @abstractmethod
    def _product(self, other: Self) -> Self: ...

    @abstractmethod
    def _multiple(self, number: Exact) -> Self:
        """The function times a number."""

    @abstractmethod
    def _power(self, alpha: fmpq) -> Self:
        """The power with an exponent that is no positive integer."""

    def _function(self, x: Any) -> Self:
        """``x``, a function of the same kind or a number, as a function."""
        return cast(Self, x) if isinstance(x, Function) else cast(Self, self.expansion.constant(x))

    def __add__(self, other: Any) -> Self:
        return self._sum(self._function(other))

    __radd__ = __add__

    def __neg__(self) -> Self:
        return self._multiple(-1)

    def __sub__(self, other: Any) -> Self:
        return self + -self._function(other)

    def __rsub__(self, other: Any) -> Self:
        return self._function(other) + -self

    def __mul__(self, other: Any) -> Self:
        return self._product(self._function(other)) if isinstance(other, Function) \
            else self._multiple(other)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Self:
        if isinstance(other, Function):
            return self * self._function(other)**-1
        number = decimal(other)
        if number == 0:
            raise InputError("a series is divided by the number zero")
        return self._multiple(1 / number)

    def __rtruediv__(self, other: Any) -> Self:
        return cast(Self, self**-1 * other)

    def __pow__(self, alpha: Exact) -> Self:
        alpha = decimal(alpha)
        if alpha.q == 1 and alpha > 0:
            if alpha == 1:
                return self
            half = self ** int(alpha.p // 2)
            return half * half * self if alpha.p % 2 else half * half
        return self._function(1) if alpha == 0 else self._power(alpha)

    @abstractmethod
    def diff(self, times: int = 1) -> Self:
        """The derivative d/dτ, or one of higher order."""

    @abstractmethod
    def shift(self, fraction: Exact) -> Self:
        """The function at τ + 2π·fraction, for a rational fraction of a period."""

    @abstractmethod
    def neighbours(self, bodies: int = 3) -> Self:
        """The sum of the function at τ + 2πj/bodies, j = 1 … bodies-1: what the others of a
        choreography contribute.  Mode n is multiplied by bodies - 1 if bodies divides n, else
        by -1, so it is rational although the single shifts are not."""

    @abstractmethod
    def sin(self) -> Self: ...

    @abstractmethod
    def cos(self) -> Self: ...

    @abstractmethod
    def exp(self) -> Self: ...

    # What Python offers to numbers, and a function cannot be asked.
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
