"""What a caller may give: numbers, checked and named in one place."""

from __future__ import annotations

import operator
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import numpy as np
from flint import fmpq
from mpmath import isfinite
from mpmath.libmp import (
    from_float,
    from_str,
    repr_dps,
    round_nearest,
    to_float,
    to_rational,
    to_str,
)

from .aliases import Array, Exact
from .errors import InputError

__all__ = ["decimal", "labelled", "rational", "real", "scalar", "scalars", "whole"]


def decimal(x: Exact) -> fmpq:
    """A number that a user gives, as an exact ``fmpq``: a binary one is the decimal it is read as.

    That is the shortest decimal that rounds to it, as Python prints a float.  For the bits of a
    computed float take :func:`rational`.

    >>> decimal(0.3), decimal("0.3"), decimal(1/3)
    (3/10, 3/10, 3333333333333333/10000000000000000)
    """
    if hasattr(x, "_mpf_") and isfinite(x):                        # mpmath or a SymPy Float
        short = to_float(x._mpf_)
        double = getattr(x, "_prec", 53) >= 53 and from_float(short) == x._mpf_
        x = short if double else _shortest(x)
    return rational(str(x) if isinstance(x, (float, np.floating)) and np.isfinite(x) else x)


def _shortest(x: Any) -> str:
    """The shortest decimal that rounds to a number at its own precision."""
    bits = max(getattr(x, "_prec", 0), x._mpf_[3])
    texts = (to_str(x._mpf_, digits) for digits in range(1, repr_dps(bits) + 1))
    found: str = next(t for t in texts if from_str(t, bits, round_nearest) == x._mpf_)
    return found


def rational(x: Exact) -> fmpq:
    """``x`` as an exact ``fmpq``: int, Fraction, decimal, SymPy rational, or float bit by bit.

    >>> rational("0.1"), rational(0.5)
    (1/10, 1/2)
    """
    if isinstance(x, fmpq):
        return x
    if hasattr(x, "_mpf_"):                                        # mpmath or a SymPy Float
        x = Fraction(*to_rational(x._mpf_)) if isfinite(x) else float(x)
    try:
        f = Fraction(x)
    except (TypeError, ValueError, ArithmeticError):
        raise InputError(f"{x!r} is not a rational number; give an int, a Fraction, a decimal "
                         "string or a SymPy Rational") from None
    return fmpq(int(f.numerator), int(f.denominator))


def real(name: str, value: Any) -> Array:
    """``value`` as a float array, all finite.

    >>> real("t", [0, 1])
    array([0., 1.])
    """
    try:
        if np.asarray(value).dtype == bool:
            raise TypeError
        array = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"{name}={value!r} is not a real number or an array of them") from None
    if not np.isfinite(array).all():
        raise InputError(f"{name} contains a value that is NaN or infinite; give finite numbers")
    return array


def scalar(name: str, value: Any) -> float:
    """``value`` as one float, finite.

    >>> scalar("lam", "0.5")
    0.5
    """
    array = real(name, value)
    if array.ndim:
        raise InputError(f"{name}={value!r}: give one number at a time")
    return float(array)


def scalars(values: Mapping[str, Any]) -> dict[str, float]:
    """One float for each name."""
    return {name: scalar(name, value) for name, value in values.items()}


def whole(name: str, value: Any, least: int = 0, most: int | None = None) -> int:
    """``value`` as an int from ``least`` to ``most``.

    >>> whole("order", 7)
    7
    """
    try:
        number = operator.index(value)
    except TypeError:
        number = least - 1
    if number < least or isinstance(value, bool) or most is not None and number > most:
        room = f"of at least {least}" if most is None else f"from {least} to {most}"
        raise InputError(f"{name}={value!r}: give a whole number {room}")
    return number


def labelled(name: str, value: Any) -> Mapping[Any, Any]:
    """``value`` as a mapping from labels, as pictures take it.

    >>> labelled("curves", {"sine": [0, 1]})
    {'sine': [0, 1]}
    """
    if not isinstance(value, Mapping):
        raise InputError(f"{name} is of type {type(value).__name__}; give a dict from each label "
                         f"to what is drawn, such as {name}={{'series': …}}")
    return value
