"""Solutions as JSON files: exact numbers as strings, floats as shortest round-trip decimals.

Format 1: ``{"format": "ftseries", "version": 1, "problem": {"name", "arguments"}, "arithmetic",
"order", "precision", "coefficients": {unknown: [[[sine, n, number], …] for each Taylor order]},
"sha256"}``, see :mod:`ftseries.jsonfile`.  A rational is "p/q", a polynomial a dict from exponents
"i,j" to rationals, a ball the four integers [midpoint mantissa, exponent, radius mantissa,
exponent]; FLINT reads the radius back with an upward rounding of 2^-30, so the ball still encloses
what it did.  What is read has to satisfy the first orders of the problem's equations, so that a
class that was changed since does not get the coefficients of another problem.
"""

from __future__ import annotations

import inspect
import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, TypeAlias

from flint import arb, ctx, fmpq, fmpq_mpoly

from . import jsonfile
from .aliases import Coefficients, FilePath, Json, Number
from .arguments import rational
from .conversion import at
from .errors import FileError, InputError
from .grid import FloatRing
from .laurent import BallRing, PolynomialRing
from .problem import Problem
from .stages import contradiction

if TYPE_CHECKING:
    from .solution import Solution

__all__ = ["save", "read", "encoded", "decoded"]

#: problem, arithmetic, order, coefficients and precision of a solution
Contents: TypeAlias = tuple[Problem, str, int, Coefficients, int | None]

_KIND = "ftseries"
#: how many orders of λ are checked when a file is read, and the bits for it
_CHECKED, _BITS = 8, 256


def save(solution: Solution, path: FilePath) -> None:
    """Write a solution; the file appears complete or not at all.

    Raises
    ------
    FileError
        The folder does not exist or cannot be written; the problem does not say how to make it
        again, see :meth:`ftseries.Problem.arguments`.
    """
    _check_arguments(type(solution.problem))
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
        problem = _made(Problem.classes[name], arguments)
    elif (not isinstance(problem, Problem) or type(problem).__name__ != name
          or problem.arguments() != arguments):
        inner = ", ".join(f"{key}={value}" for key, value in arguments.items())
        raise FileError(f"the file holds a solution of {name}({inner}), not of {problem!r}")
    arithmetic, order = data["arithmetic"], data["order"]
    coefficients = decoded(data["coefficients"], problem, arithmetic)
    for unknown, rows in coefficients.items():
        if len(rows) != order + 1:
            raise InputError(f"{unknown} has {len(rows)} Taylor orders instead of {order + 1}")
    _check_equations(problem, arithmetic, coefficients, data["precision"])
    return problem, arithmetic, order, coefficients, data["precision"]


class _BallsAt(BallRing):
    """Balls, with a number in the place of each free parameter."""

    def __init__(self, point: dict[str, fmpq]) -> None:
        self.point, self.names = point, tuple(point)

    def parameter(self, name: str) -> arb:
        return self.number(self.point[name])


def _check_arguments(kind: type[Problem]) -> None:
    """Refuse a constructor with arguments that :meth:`Problem.arguments` does not know."""
    def owner(name: str) -> int:
        return next(i for i, cls in enumerate(kind.__mro__) if name in vars(cls))
    names = list(inspect.signature(kind).parameters)
    if names and owner("__init__") < owner("arguments"):
        values = ", ".join(f"{name!r}: self.{name}" for name in names)
        raise FileError(f"a solution of {kind.__name__} cannot be saved, because it does not say "
                        f"which {', '.join(names)} it was made with; define its method arguments, "
                        f"such as def arguments(self): return {{{values}}}")


def _made(kind: type[Problem], arguments: dict[str, Json]) -> Problem:
    try:
        inspect.signature(kind).bind(**arguments)
    except TypeError as error:
        inner = ", ".join(f"{key}={value}" for key, value in arguments.items())
        raise FileError(f"{kind.__name__}({inner}) cannot be made again ({error}); give "
                        "load(path, problem=…)") from None
    return kind(**arguments)


def _check_equations(problem: Problem, arithmetic: str, coefficients: Coefficients,
                     precision: int | None) -> None:
    """Refuse coefficients that contradict the first orders of the equations."""
    first = {name: rows[:_CHECKED + 1] for name, rows in coefficients.items()}
    top = min(map(len, first.values())) - 1
    ring = FloatRing(degree=top + problem.ahead, order=top) if arithmetic == "float" else \
        _BallsAt({name: fmpq(i + 3, 10) for i, name in enumerate(problem.parameters)})
    point = list(ring.point.values()) if isinstance(ring, _BallsAt) else []
    with ctx.workprec(precision or _BITS):
        known = {name: [{mode: ring.number(at(c, point)) for mode, c in row.items()}
                        for row in rows] for name, rows in first.items()}
        found = contradiction(problem, ring, known, top)
    if found:
        equation, order = found
        raise FileError(f"the coefficients in the file contradict equation {equation} of "
                        f"{problem!r} at order {order} of λ, so they were saved for other "
                        "equations; load them with those, or solve again")


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
