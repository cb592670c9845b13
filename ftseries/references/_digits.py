"""Numbers with any number of digits: how the references take them, and compute with them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
from flint import fmpq

from ftseries.arguments import MOST_DPS, decimal, shown, whole
from ftseries.errors import InputError
from ftseries.precision import working

GUARD = 10
"""Decimal digits carried beyond those asked for."""


def number(name: str, value: Any) -> Any:
    """`value` as an mpmath number at the working precision, a float as the decimal it looks like.

    >>> number("lam", "0.5")
    mpf('0.5')
    """
    try:
        converted = mpmath.mpmathify(value) if _inexact(value) else _quotient(decimal(value))
        finite = mpmath.isfinite(converted)
    except (TypeError, ValueError):
        raise InputError(f"{name}={shown(value)} is not a number, nor its digits") from None
    if not finite:
        raise InputError(f"{name} is NaN or infinite; give a finite number")
    return converted


def _inexact(value: Any) -> bool:
    """Is it a complex number, one of mpmath, or no number?"""
    return isinstance(value, (complex, np.complexfloating, mpmath.mpc, mpmath.mpf)) \
        or str(value).strip(" +-").lower() in ("nan", "inf", "infinity")


def _quotient(q: fmpq) -> Any:
    return mpmath.mpf(int(q.p)) / int(q.q)


def in_digits(dps: Any, function: Callable[..., Any], *arguments: Any) -> Any:
    """`function(*arguments)` with guard digits, rounded to `dps` decimal digits.

    >>> mpmath.nstr(in_digits(20, mpmath.sqrt, 2), 20)
    '1.4142135623730950488'
    """
    dps = whole("dps", dps, 1, MOST_DPS)
    with working(digits=dps):
        with working(digits=dps + GUARD):
            value = function(*arguments)
        return tuple(+x for x in value) if isinstance(value, tuple) else +value
