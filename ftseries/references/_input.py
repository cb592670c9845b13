"""What the references accept: finite numbers, checked and named in one place."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np

from ftseries.aliases import Array
from ftseries.errors import InputError

GUARD = 10
"""Decimal digits carried beyond those asked for."""


def real(name: str, value: Any) -> Array:
    """`value` as a float64 array; refused unless every entry is a finite real number.

    >>> real("t", [0, 1])
    array([0., 1.])
    """
    try:
        array = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"{name} must be real numbers, not {value!r}.") from None
    if not np.all(np.isfinite(array)):
        raise InputError(f"{name} must be finite: remove the NaN or infinite entries.")
    return array


def number(name: str, value: Any) -> Any:
    """`value` as an mpmath number at the working precision; a string gives all its digits.

    >>> number("lam", "0.5")
    mpf('0.5')
    """
    try:
        converted = mpmath.mpmathify(value)
        finite = mpmath.isfinite(converted)
    except (TypeError, ValueError):
        raise InputError(f"{name} must be a number or its digits, not {value!r}.") from None
    if not finite:
        raise InputError(f"{name} must be finite, not {value!r}.")
    return converted


def digits(dps: Any) -> int:
    """`dps` as the number of decimal digits asked for, an integer of at least 1."""
    if isinstance(dps, bool) or not isinstance(dps, (int, np.integer)) or dps < 1:
        raise InputError(f"dps must be a number of decimal digits, an integer >= 1, not {dps!r}.")
    return int(dps)


def order(name: str, value: Any) -> int:
    """`value` as a non-negative integer."""
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or value < 0:
        raise InputError(f"{name} must be an integer >= 0, not {value!r}.")
    return int(value)


def in_digits(dps: Any, function: Callable[..., Any], *arguments: Any) -> Any:
    """`function(*arguments)` with guard digits, rounded to `dps` decimal digits.

    >>> mpmath.nstr(in_digits(20, mpmath.sqrt, 2), 20)
    '1.4142135623730950488'
    """
    with mpmath.workdps(digits(dps)):
        return mpmath.workdps(dps + GUARD, normalize_output=True)(function)(*arguments)
