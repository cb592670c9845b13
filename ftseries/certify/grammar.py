r"""The grammar of certificates: what each entry must look like before anybody computes with it.

============  =================================================================
``whole``     a JSON integer within limits, not a float or a truth value
``rational``  ``"p"`` or ``"p/q"`` in lowest terms, q > 1
``decimal``   ``"2"`` or ``"1.02"``: no sign, no exponent, a digit on both sides
``dyadic``    ``"m e"`` for m 2^e with an odd m; ``"0 0"``
``ball``      two of them, midpoint and radius, the radius not negative
``cut``       ``"-1.2929"``: a decimal cut after n digits; zero has no sign
============  =================================================================

Every number has one form, but for zeros at the end of a decimal; digits are ASCII, lengths are
bounded.  Anything else raises ValueError.
"""

from __future__ import annotations

import re
from typing import Any

from flint import arb, fmpq, fmpz

from ..aliases import Json

__all__ = ["MOST_BITS", "ball", "cut", "decimal", "dyadic", "entries", "exactly", "integers",
           "modes", "rational", "record", "whole"]

MOST_BITS = 20000                   # of a certificate's arithmetic
_LONG, _SHORT = 50000, 5000         # characters of any number; of a decimal
_WHOLE = r"-?[1-9][0-9]*|0"


def whole(value: Json, least: int, most: int) -> int:
    """An integer.

    >>> whole(7, 0, 9)
    7
    """
    if type(value) is not int or not least <= value <= most:
        raise ValueError(f"{_shown(value)} is not a whole number from {least} to {most}")
    return value


def rational(value: Json, longest: int = _LONG) -> fmpq:
    """An exact rational number.

    >>> rational("-3/10")
    -3/10
    """
    p, _, q = _matched(value, f"({_WHOLE})(/[1-9][0-9]*)?", "p/q", longest).partition("/")
    number = fmpq(fmpz(p), fmpz(q or 1))
    if str(number) != value:
        raise ValueError(f"{_shown(value)} is not in lowest terms")
    return number


def decimal(value: Json) -> arb:
    """A ball around a decimal."""
    return arb(_matched(value, r"(0|[1-9][0-9]*)(\.[0-9]+)?", "a decimal such as 1.02", _SHORT))


def dyadic(value: Json) -> tuple[fmpz, int]:
    """(m, e).

    >>> dyadic("-3 5")
    (-3, 5)
    """
    text = _matched(value, r"-?[1-9][0-9]* (-?[1-9][0-9]{0,5}|0)|0 0", "m e, for m 2^e", _LONG)
    m, e = text.split(" ")
    mantissa = fmpz(m)
    if mantissa % 2 == 0 and text != "0 0":
        raise ValueError(f"{_shown(value)} has an even mantissa")
    return mantissa, int(e)


def exactly(value: Json) -> fmpq:
    """m 2^e as a rational number."""
    mantissa, exponent = dyadic(value)
    return fmpq(mantissa) * fmpq(2) ** exponent


def ball(value: Json) -> tuple[arb, arb]:
    """(midpoint, radius), both exact."""
    mid, radius = (arb(dyadic(x)) for x in entries(value, 2, 2))
    if radius < 0:
        raise ValueError("the radius of a ball is negative")
    return mid, radius


def cut(value: Json, digits: int) -> tuple[bool, fmpz]:
    """(is there a sign, the digits without the point as an integer).

    >>> cut("-1.29", 2)
    (True, 129)
    """
    text = _matched(value, rf"-?(0|[1-9][0-9]*)\.[0-9]{{{digits}}}", f"cut after {digits} digits",
                    _LONG)
    number = fmpz(text.lstrip("-").replace(".", ""))
    if text[0] == "-" and number == 0:
        raise ValueError("zero has no sign")
    return text[0] == "-", number


def entries(value: Json, least: int, most: int) -> list[Json]:
    """A list of so many entries."""
    if type(value) is not list or not least <= len(value) <= most:
        raise ValueError(f"a list of {least} to {most} entries is missing")
    return value


def integers(value: Json, most: int, bits: int) -> list[int]:
    """A list of at most ``most`` integers below 2^bits in size."""
    return [whole(c, -2**bits, 2**bits) for c in entries(value, 0, most)]


def modes(value: Json, top: int) -> dict[int, Any]:
    """{n: what follows n}, from rows [n, …] with rising n from 0 to ``top``."""
    rows = [entries(row, 2, MOST_BITS) for row in entries(value, 1, top + 1)]
    numbers = [whole(row[0], 0, top) for row in rows]
    if any(a >= b for a, b in zip(numbers, numbers[1:])):
        raise ValueError("the modes do not rise")
    return {n: row[1:] for n, row in zip(numbers, rows)}


def record(value: Json, names: str) -> dict[str, Json]:
    """An object with these entries, and no other."""
    if type(value) is not dict or value.keys() != set(names.split()):
        raise ValueError(f"its entries are not {names}")
    return value


def _matched(value: Json, pattern: str, what: str, longest: int) -> str:
    if type(value) is not str or len(value) > longest or not re.fullmatch(pattern, value, re.ASCII):
        raise ValueError(f"{_shown(value)} is not {what}, in at most {longest} characters")
    return value


def _shown(value: Json) -> str:
    if isinstance(value, (list, dict)) or type(value) is int and abs(value) > 2**64:
        return "an entry"
    text = ascii(value)
    return text if len(text) < 40 else f"{text[:40]}…"
