"""What provers and checkers share: the word *not proved*, and balls as decimals for sentences."""

from __future__ import annotations

from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal
from math import inf, nextafter
from typing import Any

from flint import arb

from ..errors import FTSeriesError
from ..precision import working

__all__ = ["NotProved", "at_least", "at_most", "decimal", "power_of_ten"]


class NotProved(FTSeriesError):
    """The inequalities of a proof do not hold for these data; nothing is claimed."""


def at_most(x: Any, digits: int = 3) -> str:
    """A decimal not below x, to print an upper bound.

    >>> at_most(arb("1.231e-9")), at_least(arb("1.239e-9"))
    ('1.24e-09', '1.23e-09')
    """
    return _decimal(nextafter(float(x), inf), digits, ROUND_CEILING)


def at_least(x: Any, digits: int = 3) -> str:
    """A decimal not above x, to print a lower bound."""
    return _decimal(nextafter(float(x), -inf), digits, ROUND_FLOOR)


def _decimal(x: float, digits: int, rounding: str) -> str:
    d = Context(prec=digits, rounding=rounding).create_decimal(Decimal(x))
    return f"{float(d):.{digits}g}"


def decimal(x: arb, n: int) -> str:
    """The first n digits after the point of every number in a ball, truncated, not rounded.

    Raises
    ------
    NotProved
        The numbers in the ball do not agree in them.

    Examples
    --------
    >>> from flint import arb
    >>> decimal(-arb(2).sqrt(), 5), decimal(arb("0.123456", "1e-9"), 4)
    ('-1.41421', '0.1234')
    >>> decimal(arb("0.125", "1e-9"), 3)
    Traceback (most recent call last):
        ...
    ftseries.certify.balls.NotProved: not proved: 3 digits of [0.12500000 +/- 1.01e-9]
    """
    with working(bits=int((n + 40) * 3.33)):
        whole = (abs(x) * arb(10)**n).floor().unique_fmpz()
    if whole is None:
        raise NotProved(f"not proved: {n} digits of {x.str(10)}")
    text = whole.str().rjust(n + 1, "0")
    return ("-" if whole and x < 0 else "") + f"{text[:-n]}.{text[-n:]}"


def power_of_ten(x: arb) -> str:
    """The power of ten not below x > 0, for numbers too small for a float.

    >>> power_of_ten(arb("1.2e-1007"))
    '1e-1006'
    """
    with working(bits=64):
        return f"1e{(x.log() / arb(10).log()).upper().ceil().unique_fmpz()}"
