r"""Change of the series variable: composition, reversion, Euler's transformation.

Formula.  Given f(z) = Σ c_k z^k and a map z = φ(w) with φ(0) = 0, the series of f(φ(w)) in w.
Euler's map w = z/(z + p) sends a singularity z = -p to infinity and the half plane Re z > -p/2 into
the unit disc, so that a series hindered by singularities on the left converges there.  Coefficients
are kept exact where all are; floats are taken into balls of many bits and come back as floats.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TypeAlias

from flint import arb, arb_series, fmpq, fmpq_series

from ..aliases import Exact, Number
from ..arguments import rational
from ..errors import InputError
from ..precision import working

__all__ = ["compose", "euler_map", "revert"]

_BITS = 1000
#: from coefficients to a series of FLINT, and back
Make: TypeAlias = Callable[[Sequence[Number]], Any]
Numbers: TypeAlias = Callable[[Any], list[Number]]


def compose(c: Sequence[Number], inner: Sequence[Number]) -> list[Number]:
    """The Taylor coefficients of f(φ(w)), as many as of f; ``inner`` are those of φ.

    >>> compose([1] * 8, [0, 1, 1])                               # 1/(1 - w - w²): Fibonacci
    [1, 1, 2, 3, 5, 8, 13, 21]
    """
    _check_start(inner, "the inner series")
    if not any(inner):
        return [c[0]] + [0 * x for x in c[1:]]
    with _series(len(c), c, inner) as (make, numbers):
        return numbers(make(c)(make(inner)))


def revert(c: Sequence[Number]) -> list[Number]:
    """The Taylor coefficients of the inverse function z(w) of w = Σ c_k z^k.

    >>> revert([0, 1, -1, 0, 0])                                  # w = z - z²: Catalan numbers
    [0, 1, 1, 2, 5]
    """
    _check_start(c, "a series to be reverted")
    if len(c) < 2 or c[1] == 0:
        raise InputError("a series to be reverted needs a coefficient of z that is not zero")
    with _series(len(c), c) as (make, numbers):
        return numbers(make(c).reversion())


def euler_map(c: Sequence[Number], p: Exact) -> tuple[list[Number], Callable[[Any], Any]]:
    """(d, w): the coefficients of f in Euler's variable w = z/(z + p), and w itself as a function.

    >>> d, w = euler_map([(-1) ** k for k in range(6)], 1)                # 1/(1 + z) = 1 - w
    >>> d, w(1.0)
    ([1, -1, 0, 0, 0, 0], 0.5)
    """
    p = rational(p)
    if p == 0:
        raise InputError("p=0: Euler's map needs the place -p of a singularity, not zero")
    scale = int(p.p) / int(p.q)
    inner = [fmpq(0)] + [p] * (len(c) - 1)                         # z = p w / (1 - w)
    return compose(c, inner), lambda z: z / (z + scale)


def _check_start(c: Sequence[Number], what: str) -> None:
    if not len(c) or c[0] != 0:
        raise InputError(f"{what} must vanish at 0: its first coefficient must be zero")


@contextmanager
def _series(length: int, *lists: Sequence[Number]) -> Iterator[tuple[Make, Numbers]]:
    """(from coefficients to a series, and back) in the arithmetic that holds all the lists."""
    exact = all(isinstance(x, (fmpq, int)) for c in lists for x in c)
    kind: Any = fmpq_series if exact else arb_series
    number: Any = fmpq if exact else arb
    floats = any(isinstance(x, float) for c in lists for x in c)
    with working(bits=_BITS, terms=max(length, 1)):
        yield (lambda c: kind([number(x) for x in c], prec=length),
               lambda s: [float(s[k]) if floats else s[k] for k in range(length)])
