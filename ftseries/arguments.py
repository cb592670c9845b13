"""What a caller may give: numbers, checked and named in one place.

A number is read exactly by :func:`decimal`, as a float by :func:`real`.  Both take what Python,
NumPy, pandas, SymPy, mpmath and FLINT call a real number, and refuse what only looks like one:
complex numbers, times, masked values, balls with a radius.
"""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb, arf, fmpq, fmpz
from mpmath import isfinite, mpf
from mpmath.libmp import (
    from_float,
    from_str,
    prec_to_dps,
    repr_dps,
    round_nearest,
    to_float,
    to_rational,
    to_str,
)

from .aliases import Array, Exact
from .errors import InputError

__all__ = ["DIGITS", "MOST_BITS", "MOST_DERIVATIVES", "MOST_DPS", "computed", "decimal",
           "labelled", "objects", "quotient", "rational", "real", "scalar", "scalars", "shown",
           "whole"]

#: digits that a number may have, and the power of ten in which it may be written
DIGITS = 1000
#: decimal digits, bits and derivatives that a value can be asked with
MOST_DPS, MOST_BITS, MOST_DERIVATIVES = 100_000, 2**20, 100
#: what NumPy and Python would turn into a real number, although it is none
_UNREAL = (bool, np.bool_, complex, np.complexfloating, np.datetime64, np.timedelta64)


def decimal(x: Exact) -> fmpq:
    """A number that a user gives, as an exact ``fmpq``: a binary one is the decimal it is read as.

    That is the shortest decimal that rounds to it, as Python prints a float.  For the bits of a
    computed float take :func:`rational`.

    >>> decimal(0.3), decimal("0.3"), decimal(1/3)
    (3/10, 3/10, 3333333333333333/10000000000000000)
    """
    x = _inside(x)
    if _is_mpf(x) and isfinite(x):
        _check_power(x, sum(x._mpf_[2:]) / math.log2(10))
        short = to_float(x._mpf_)
        double = getattr(x, "_prec", 53) >= 53 and from_float(short) == x._mpf_
        x = short if double else _shortest(x)
    number = rational(str(x) if isinstance(x, (float, np.floating)) and np.isfinite(x) else x)
    if max(number.p.bit_length(), number.q.bit_length()) > DIGITS * math.log2(10):
        raise InputError(f"{shown(x)} has more than {DIGITS} digits; give a shorter number")
    return number


def computed(x: Exact) -> fmpq:
    """The same, but a number of mpmath by its bits: it comes from a computation, such as λ + 2⁻⁹⁹.

    >>> from mpmath import mpf
    >>> computed(0.1), computed(mpf(0.1)) == fmpq(*(0.1).as_integer_ratio())
    (1/10, True)
    """
    return rational(x) if isinstance(x, mpf) else decimal(x)


def _inside(x: Any) -> Any:
    """The number in an array of no dimensions."""
    return x[()] if isinstance(x, np.ndarray) and not x.ndim and not np.ma.is_masked(x) else x


def _is_mpf(x: Any) -> bool:
    """A number of mpmath or a SymPy Float; balls of FLINT would pass for one, too."""
    return hasattr(x, "_mpf_") and not isinstance(x, (arb, arf))


def _shortest(x: Any) -> str:
    """The shortest decimal that rounds to a number at its own precision."""
    bits = max(getattr(x, "_prec", 0), x._mpf_[3])
    texts = (to_str(x._mpf_, digits) for digits in range(prec_to_dps(bits), repr_dps(bits) + 1))
    found: str = next(t for t in texts if from_str(t, bits, round_nearest) == x._mpf_)
    return found


def rational(x: Exact) -> fmpq:
    """``x`` as an exact ``fmpq``: int, Fraction, decimal, SymPy rational, or float bit by bit.

    >>> rational("0.1"), rational(0.5)
    (1/10, 1/2)
    """
    if isinstance(x, fmpq):
        return x
    try:
        f = _fraction(x)
    except InputError:
        raise
    except (TypeError, ValueError, ArithmeticError):
        raise InputError(f"{shown(x)} is not a rational number; give an int, a Fraction, a decimal "
                         "string or a SymPy Rational") from None
    return fmpq(int(f.numerator), int(f.denominator))


def quotient(x: fmpq) -> float:
    """The nearest float of a number in the equations or in a series."""
    try:
        return int(x.p) / int(x.q)
    except OverflowError:
        raise InputError(f"a coefficient or a number of the equations, {shown(x)}, is beyond the "
                         "floats; solve with arithmetic='exact' or 'ball', or measure in another "
                         "unit") from None


def _fraction(x: Any) -> Fraction | fmpq:
    x = _inside(x)
    if isinstance(x, (np.timedelta64, np.ma.MaskedArray)):
        raise TypeError
    if isinstance(x, str):
        _check_text(x)
    elif isinstance(x, Decimal) and x.is_finite():
        _check_power(x, x.adjusted())
    elif _is_mpf(x):
        if not isfinite(x):
            raise ValueError
        _check_power(x, sum(x._mpf_[2:]) / math.log2(10))
        return Fraction(*to_rational(x._mpf_))
    elif isinstance(x, (arb, arf)):
        mantissa, exponent = _exactly(x).man_exp()
        _check_power(x, int(exponent) / math.log2(10))
        return fmpq(mantissa) * fmpq(2) ** int(exponent)
    elif isinstance(x, fmpz):
        return fmpq(x)
    elif isinstance(x, np.floating):
        return Fraction(*x.as_integer_ratio())
    return Fraction(x)


def _check_text(text: str) -> None:
    """Refuse a number whose digits or power of ten would take all memory."""
    digits = text.replace("_", "")
    powers = re.findall(r"e([-+]?\d{1,9})", digits.lower())
    if any(len(run) > DIGITS for run in re.findall(r"\d+", digits)):
        raise InputError(f"{shown(text)} has more than {DIGITS} digits; give a shorter number")
    for power in powers:
        _check_power(text, int(power))


def _check_power(x: Any, power: float) -> None:
    if abs(power) > DIGITS:
        raise InputError(f"{shown(x)} is beyond 10^±{DIGITS}; give a number of moderate size")


def _exactly(x: Any) -> Any:
    """The midpoint of a ball without a radius."""
    if isinstance(x, arb) and not x.is_exact():
        raise InputError(f"{shown(x)} is a ball with a radius, not a number; give one number in "
                         "it, such as its midpoint .mid()")
    return x


def shown(x: Any) -> str:
    """``repr(x)`` for one sentence: on one line, cut when it is long, and of anything.

    >>> shown([0.5, 1]), len(shown(10**5000)) < 100
    ('[0.5, 1]', True)
    """
    try:
        text = " ".join(repr(x).split())
    except Exception:                                        # an integer of more than 4300 digits
        text = f"<{type(x).__name__}, too long to print>"
    return text if len(text) <= 200 else f"{text[:90]} … {text[-20:]}"


def real(name: str, value: Any) -> Array:
    """``value`` as a float array, all finite.

    >>> real("t", [0, 1])
    array([0., 1.])
    """
    try:
        array = _floats(value)
    except InputError as error:
        raise InputError(f"{name}: {error}") from None
    except OverflowError:
        raise InputError(f"{name}={shown(value)} is beyond the floats; give numbers up to 1e308 in "
                         "size") from None
    except (TypeError, ValueError, ZeroDivisionError):
        raise InputError(f"{name}={shown(value)} is not a real number or an array of them"
                         ) from None
    if not np.isfinite(array).all():
        raise InputError(f"{name} contains a value that is NaN or infinite; give finite numbers")
    return array


def objects(name: str, value: Any) -> Any:
    """``value`` as an array of the numbers that it holds, none of them masked."""
    try:
        _check_mask(value)
    except InputError as error:
        raise InputError(f"{name}: {error}") from None
    return np.asarray(value, object)


def _check_mask(value: Any) -> None:
    if np.ma.is_masked(value) or isinstance(value, (list, tuple)) and any(
            map(np.ma.is_masked, value)):
        raise InputError("some of its entries are masked; give those that are not, such as "
                         "x.compressed()")


def _floats(value: Any) -> Array:
    _check_mask(value)
    array = np.asarray(value)
    if array.dtype.kind not in "iuf":
        return np.array([_float(x) for x in array.ravel()], dtype=float).reshape(array.shape)
    with np.errstate(over="ignore"):
        floats = array.astype(float)
    if (np.isinf(floats) & np.isfinite(array)).any():              # long doubles
        raise OverflowError
    return floats


def _float(x: Any) -> float:
    if isinstance(x, _UNREAL):
        raise TypeError
    if x is None:
        return math.nan
    if isinstance(x, str) and "/" in x:
        x = Fraction(x)
    number = float(_exactly(x))
    if math.isinf(number) and (x != number if not isinstance(x, str) else re.search(r"\d", x)):
        raise OverflowError
    return number


def scalar(name: str, value: Any) -> float:
    """``value`` as one float, finite.

    >>> scalar("lam", "0.5")
    0.5
    """
    array = real(name, value)
    if array.ndim:
        raise InputError(f"{name}={shown(value)}: give one number at a time")
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
        raise InputError(f"{name}={shown(value)}: give a whole number {room}")
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
