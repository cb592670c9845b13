"""Numbers, of the rings and of users, as SymPy numbers, floats, mpmath numbers and balls."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import mpmath
import sympy as sp
from flint import arb, fmpq

from .aliases import Expr, Number
from .arguments import DIGITS, decimal, shown
from .errors import InputError
from .precision import working

__all__ = ["to_sympy", "to_float", "to_ball", "in_fractions", "at", "symbolic", "numeric_unit",
           "float_unit"]


def to_sympy(number: Number, names: Sequence[str | Expr]) -> Expr:
    """A rational, or a polynomial in the parameters ``names``, as a SymPy expression."""
    if isinstance(number, fmpq):
        return sp.Rational(int(number.p), int(number.q))
    symbols = [sp.Symbol(name) if isinstance(name, str) else name for name in names]
    return sp.Add(*(sp.Rational(int(c.p), int(c.q)) * sp.prod(map(sp.Pow, symbols, exponents))
                    for (_, *exponents), c in number.to_dict().items()))


def in_fractions(e: Expr) -> Expr:
    """A SymPy expression with each of its decimals as the fraction that it looks like.

    >>> in_fractions(0.3 * sp.Symbol("x"))
    3*x/10
    """
    e = e.xreplace({x: to_sympy(decimal(x), ()) for x in e.atoms(sp.Float)})
    if any(max(x.p.bit_length(), x.q.bit_length()) > DIGITS * math.log2(10)
           for x in e.atoms(sp.Rational)):
        raise InputError(f"{shown(e)} contains a number of more than {DIGITS} digits; give shorter "
                         "numbers")
    return e


def symbolic(x: Any) -> Expr:
    """A number, or a SymPy expression as it is; a float is the decimal that it looks like.

    >>> from flint import fmpq
    >>> symbolic(0.1), symbolic(fmpq(1, 3)), symbolic(sp.sqrt(2))
    (1/10, 1/3, sqrt(2))
    """
    if isinstance(x, sp.Expr):
        return in_fractions(x)
    try:
        if isinstance(x, (bool, sp.Basic)):
            raise InputError
        return to_sympy(decimal(x), ())
    except InputError as error:
        why = f" ({error})" if error.args else ""
        raise InputError(f"{shown(x)} is not a number or a SymPy expression{why}") from None


def to_float(number: Number) -> float:
    """The nearest float."""
    return int(number.p) / int(number.q) if isinstance(number, fmpq) else float(number)


def numeric_unit(problem: Any, unit: Any) -> Expr:
    """A unit of a problem; refuses a symbol in it."""
    unit = sp.sympify(unit)
    if unit.free_symbols:
        raise InputError(f"{problem!r} contains {unit.free_symbols.pop()}; give it a number to "
                         "evaluate, or solve with arithmetic='exact' for its coefficients")
    return unit


def float_unit(problem: Any, unit: Any) -> float:
    """The same as a float; refuses also what is beyond the floats."""
    unit = numeric_unit(problem, unit)
    with working():                                                 # SymPy computes with mpmath
        value = float(unit)
    if not 0 < abs(value) < math.inf:
        raise InputError(f"{problem!r} has a unit of about {mpmath.nstr(unit.evalf(), 2)}, beyond "
                         "the floats; take exact coefficients and evaluate(…, dps=…)")
    return value


def to_ball(unit: Expr) -> arb:
    """A SymPy number as a ball that encloses it, at the precision in force."""
    if unit.is_Rational:
        return arb(int(unit.p)) / int(unit.q)
    if unit.is_Pow:
        return to_ball(unit.base) ** to_ball(unit.exp)
    if unit.is_Mul:
        product = arb(1)
        for factor in unit.args:
            product *= to_ball(factor)
        return product
    if unit.is_Add:
        return sum(map(to_ball, unit.args), arb(0))
    if unit in (sp.pi, sp.E):
        return arb.pi() if unit is sp.pi else arb.const_e()
    if isinstance(unit, (sp.exp, sp.log, sp.sin, sp.cos, sp.tan)):
        value: arb = getattr(to_ball(unit.args[0]), type(unit).__name__)()
        return value
    raise InputError(f"the number {unit} is not made of rationals, π, powers and elementary "
                     "functions; give its digits")


def at(number: Number, point: Sequence[fmpq]) -> Number:
    """The value of a coefficient where the parameters have the values ``point``."""
    return number(fmpq(0), *point) if hasattr(number, "context") else number
