"""Solutions as JSON files: exact numbers as strings, floats as shortest round-trip decimals.

Format 1: ``{"format": "ftseries", "version": 1, "problem": {"name", "arguments"}, "arithmetic",
"order", "precision", "coefficients": {unknown: [[[sine, n, number], …] for each Taylor order]},
"sha256"}``, see :mod:`ftseries.jsonfile`.  A rational is "p/q", a polynomial a dict from exponents
"i,j" to rationals, a ball the four integers [midpoint mantissa, exponent, radius mantissa,
exponent]; FLINT reads the radius back with an upward rounding of 2^-30, so the ball still encloses
what it did.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, TypeAlias

from flint import arb, fmpq, fmpq_mpoly

from . import jsonfile
from .aliases import Coefficients, FilePath, Json, Number
from .arguments import rational
from .errors import FileError, InputError
from .laurent import PolynomialRing
from .problem import Problem

if TYPE_CHECKING:
    from .solution import Solution

__all__ = ["save", "read", "encoded", "decoded"]

#: problem, arithmetic, order, coefficients and precision of a solution
Contents: TypeAlias = tuple[Problem, str, int, Coefficients, int | None]

_KIND = "ftseries"


def save(solution: Solution, path: FilePath) -> None:
    """Write a solution; the file appears complete or not at all.

    Raises
    ------
    FileError
        The folder does not exist or cannot be written.
    """
    data = {
        "problem": {"name": type(solution.problem).__name__,
                    "arguments": solution.problem.arguments()},
        "arithmetic": solution.arithmetic, "order": solution.order,
        "precision": solution.precision,
        "coefficients": encoded(solution.coefficients),
    }
    try:
        jsonfile.write(path, _KIND, data)
    except (TypeError, ValueError):
        raise FileError(f"cannot write {os.fspath(path)!r}: the arguments of {solution.problem!r} "
                        "are not plain JSON values; make its method 'arguments' return such"
                        ) from None


def read(path: FilePath, problem: Problem | None = None) -> Contents:
    """What :class:`ftseries.Solution` is made of, from a file written by :func:`save`."""
    data = jsonfile.read(path, _KIND, "a saved ftseries solution", "save the solution again")
    try:
        return _contents(data, problem)
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError) as error:
        raise FileError(f"{os.fspath(path)!r} is damaged: {error}; save the solution again"
                        ) from None


def encoded(coefficients: Coefficients) -> Json:
    """Coefficients as plain JSON values."""
    return {name: [[[*mode, _encode(c)] for mode, c in sorted(row.items())] for row in rows]
            for name, rows in coefficients.items()}


def decoded(coefficients: Json, problem: Problem, arithmetic: str) -> Coefficients:
    """The coefficients again; what belongs to no unknown of the problem is not read."""
    decode = {"exact": _polynomial(problem.parameters) if problem.parameters else _rational,
              "float": float, "ball": _ball}[arithmetic]
    return {name: [{(sine, n): decode(c) for sine, n, c in row} for row in coefficients[name]]
            for name in problem.unknowns}


def _contents(data: dict[str, Json], problem: Problem | None) -> Contents:
    name, arguments = data["problem"]["name"], data["problem"]["arguments"]
    if problem is None:
        if name not in Problem.classes:
            raise FileError(f"the file holds a solution of {name!r}, which is not known here; "
                            "import its class or give load(path, problem=…)")
        problem = Problem.classes[name](**arguments)
    elif (not isinstance(problem, Problem) or type(problem).__name__ != name
          or problem.arguments() != arguments):
        inner = ", ".join(f"{key}={value}" for key, value in arguments.items())
        raise FileError(f"the file holds a solution of {name}({inner}), not of {problem!r}")
    arithmetic, order = data["arithmetic"], data["order"]
    coefficients = decoded(data["coefficients"], problem, arithmetic)
    for unknown, rows in coefficients.items():
        if len(rows) != order + 1:
            raise InputError(f"{unknown} has {len(rows)} Taylor orders instead of {order + 1}")
    return problem, arithmetic, order, coefficients, data["precision"]


def _encode(number: Number) -> Json:
    if isinstance(number, float):
        return number
    if isinstance(number, fmpq):
        return str(number)
    if isinstance(number, arb):
        return [str(x) for part in (number.mid(), number.rad()) for x in part.man_exp()]
    return {",".join(str(e) for e in exponents[1:]): str(c)
            for exponents, c in number.to_dict().items()}


def _rational(text: str) -> fmpq:
    if not isinstance(text, str):
        raise ValueError(f"{text!r} is not an exact number")
    return rational(text)


def _ball(parts: list[str]) -> arb:
    m, e, r, f = (int(x) for x in parts)
    return arb((m, e), (r, f))


def _polynomial(names: Sequence[str]) -> Callable[[dict[str, str]], fmpq_mpoly]:
    ring = PolynomialRing(names)

    def decode(terms: dict[str, str]) -> fmpq_mpoly:
        return ring.context.from_dict({(0, *map(int, exponents.split(","))): rational(c)
                                       for exponents, c in terms.items()})
    return decode
