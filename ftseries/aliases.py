"""Names for the types that signatures share.

SymPy and mpmath have no types of their own, so their expressions and numbers are ``Any`` here, as
is what depends on the arithmetic: the rings decide what a number and a part are.
"""

import os
from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Array", "ArrayLike", "Column", "ComplexArray", "Coefficients", "Exact", "Expr",
           "FilePath", "Function", "Json", "Mode", "Modes", "Multiplier", "Number", "Part",
           "Parts", "Real", "Row", "Term", "Terms", "Vector"]

#: float64, complex128, and what is one or the other
Array: TypeAlias = NDArray[np.float64]
ComplexArray: TypeAlias = NDArray[np.complex128]
#: a float, or an array of them
Real: TypeAlias = Any
#: a number of a ring: fmpq, fmpq_mpoly, arb or float
Number: TypeAlias = Any
#: what a ring keeps of one kind of modes; by kind
Part: TypeAlias = Any
Parts: TypeAlias = dict[int, Part]
#: one Taylor coefficient, a Trig or a Dual; those of one series, a list or a GridTable
Term: TypeAlias = Any
Terms: TypeAlias = Any
#: a rational given by hand: int, Fraction, decimal text, SymPy Rational, float
Exact: TypeAlias = Any
#: a SymPy expression
Expr: TypeAlias = Any
#: a Series or a Sampled: they have the same operations, so one declaration serves both
Function: TypeAlias = Any
#: (sine, n), and coefficients by mode; the Taylor coefficients of unknowns, by name
Mode: TypeAlias = tuple[int, int]
Modes: TypeAlias = dict[Mode, Number]
Coefficients: TypeAlias = dict[str, list[Modes]]
#: (unknown, sine, n), (number of the equation, sine, n), and numbers by one of them
Column: TypeAlias = tuple[str, int, int]
Row: TypeAlias = tuple[int, int, int]
Vector: TypeAlias = dict[Any, Number]
#: (a, b) for mode n: e^{inτ} becomes (a + ib) e^{inτ}
Multiplier: TypeAlias = Callable[[int, Any], tuple[Any, Any]]
#: plain JSON values
Json: TypeAlias = Any
FilePath: TypeAlias = str | os.PathLike[str]
