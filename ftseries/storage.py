"""Solutions as JSON files: exact numbers as strings, floats as shortest round-trip decimals.

Format 1: ``{"format": "ftseries", "version": 1, "problem": {"name", "arguments"}, "arithmetic",
"order", "precision", "coefficients": {unknown: [[[sine, n, number], …] for each Taylor order]},
"sha256"}``, see :mod:`ftseries.jsonfile`.  A rational is "p/q", a polynomial a dict from exponents
"i,j" to rationals, a ball the four integers [midpoint mantissa, exponent, radius mantissa,
exponent]; FLINT reads the radius back with an upward rounding of 2^-30, so the ball still encloses
what it did.

What is read has to be a solution of its problem, so that neither a class that was changed since nor
an altered file gives the coefficients of another one.  Checked are the types and ranges, that each
coefficient belongs to the ansatz, that the first ones are those of the seed, and that they solve
the equations at every order: exactly, within balls, or up to the rounding of floats, see
:mod:`ftseries.verification`.
"""

from __future__ import annotations

import inspect
import json
import math
import os
import re
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

from flint import arb, fmpq, fmpq_mpoly, fmpz

from . import jsonfile
from .aliases import Coefficients, FilePath, Json, Mode, Modes, Number
from .arguments import shown, whole
from .errors import FileError, FTSeriesError, InputError
from .laurent import PolynomialRing
from .problem import Problem
from .verification import fault

if TYPE_CHECKING:
    from .solution import Solution

__all__ = ["save", "read", "encoded", "decoded"]

#: problem, arithmetic, order, coefficients and precision of a solution
Contents: TypeAlias = tuple[Problem, str, int, Coefficients, int | None]

_KIND = "ftseries"
#: Fourier and Taylor orders, bits, and digits of an exact number that a file may ask for
_ORDERS, _BITS, _DIGITS = 1000, 100_000, 100_000
#: mantissa and exponent of a ball's midpoint, and of its radius
_BALL = ("-?[0-9]{1,100000}", "-?[0-9]{1,12}", "[0-9]{1,20}", "-?[0-9]{1,12}")


def save(solution: Solution, path: FilePath) -> None:
    """Write a solution; the file appears complete or not at all.

    Raises
    ------
    FileError
        The folder does not exist or cannot be written; the problem does not say how to make it
        again, see :meth:`ftseries.Problem.arguments`; the solution has orders above 1000 or more
        than 100000 bits.
    """
    problem = solution.problem
    _check_arguments(type(problem))
    _check_size(problem, solution.order, solution.precision)
    arguments = _plain(problem)
    data = {
        "problem": {"name": type(problem).__name__, "arguments": arguments},
        "arithmetic": solution.arithmetic, "order": solution.order,
        "precision": solution.precision,
        "coefficients": encoded(solution.coefficients),
    }
    try:
        jsonfile.write(path, _KIND, data)
    except ValueError:
        raise FileError(f"cannot write {os.fspath(path)!r}: a coefficient of {solution!r} is not "
                        "finite; truncate the solution before it") from None


def read(path: FilePath, problem: Problem | None = None) -> Contents:
    """What :class:`ftseries.Solution` is made of, from a file written by :func:`save`."""
    data = jsonfile.read(path, _KIND, "a saved ftseries solution", "save the solution again")
    try:
        return _contents(data, problem)
    except FileError:
        raise
    except Exception as error:             # whatever a constructor makes of a stranger's arguments
        reason = f"{error} is missing" if isinstance(error, KeyError) else shown(error)
        if isinstance(error, FTSeriesError) or type(error) in (TypeError, ValueError):
            reason = " ".join(str(error).split())
        reason = reason if len(reason) < 500 else f"{reason[:400]} … {reason[-60:]}"
        raise FileError(f"{os.fspath(path)!r} is damaged: {reason}; save the solution again"
                        ) from None


def encoded(coefficients: Coefficients) -> Json:
    """Coefficients as plain JSON values."""
    return {name: [[[*mode, _encode(c)] for mode, c in sorted(row.items())] for row in rows]
            for name, rows in coefficients.items()}


def decoded(coefficients: Json, problem: Problem, arithmetic: str) -> Coefficients:
    """The coefficients again, of the unknowns of the problem."""
    decode = {"exact": _polynomial(problem.parameters) if problem.parameters else _rational,
              "float": _float, "ball": _ball}[arithmetic]
    if set(coefficients) != set(problem.unknowns):
        raise ValueError(f"it has coefficients of {shown(sorted(coefficients))}, but the unknowns "
                         f"of {shown(problem)} are {', '.join(problem.unknowns)}")
    return {name: [_row(name, row, decode) for row in coefficients[name]]
            for name in problem.unknowns}


def _row(name: str, row: Sequence[Any], decode: Callable[[Any], Number]) -> Modes:
    modes = {(sine, n): decode(c) for sine, n, c in row}
    if len(modes) < len(row) or not all(type(i) is int for mode in modes for i in mode):
        raise ValueError(f"a mode of {name} occurs twice, or is not two integers")
    return modes


def _contents(data: dict[str, Json], problem: Problem | None) -> Contents:
    name, arguments = data["problem"]["name"], data["problem"]["arguments"]
    if problem is None:
        if name not in Problem.classes:
            raise FileError(f"the file holds a solution of {shown(name)}, which is not known here; "
                            "import its class or give load(path, problem=…)")
        problem = _made(Problem.classes[name], arguments)
    elif (not isinstance(problem, Problem) or type(problem).__name__ != name
          or _plain(problem) != arguments):
        raise FileError(f"the file holds a solution of {_call(name, arguments)}, not of "
                        f"{shown(problem)}")
    arithmetic, order, precision = data["arithmetic"], data["order"], data["precision"]
    if arithmetic not in ("exact", "float", "ball") or (problem.parameters
                                                        and arithmetic != "exact"):
        raise ValueError(f"arithmetic={shown(arithmetic)} is none that {shown(problem)} can have")
    if (precision is not None) != (arithmetic == "ball"):
        raise ValueError(f"precision={shown(precision)} in {arithmetic} arithmetic")
    precision = precision if precision is None else whole("precision", precision, 2)
    order = whole("order", order)
    _check_size(problem, order, precision)
    for unknown, rows in data["coefficients"].items():
        if len(rows) != order + 1:
            raise InputError(f"{unknown} has {len(rows)} Taylor orders instead of {order + 1}")
    coefficients = decoded(data["coefficients"], problem, arithmetic)
    _check_ansatz(problem, coefficients)
    if reason := fault(problem, arithmetic, coefficients, precision):
        raise FileError(f"the coefficients in the file {reason}, so they were saved for other "
                        "equations; load them with those, or solve again")
    return problem, arithmetic, order, coefficients, precision


def _plain(problem: Problem) -> dict[str, Json]:
    """The arguments of a problem as they come back from a file."""
    arguments = problem.arguments()
    try:
        plain: dict[str, Json] = json.loads(json.dumps(arguments, allow_nan=False))
    except (TypeError, ValueError, RecursionError):
        raise FileError(f"the arguments of {type(problem).__name__} are not plain JSON values; "
                        "make its method 'arguments' return such") from None
    return plain


# --- what a file may not hold -------------------------------------------------------------------

def _check_size(problem: Problem, order: int, precision: int | None) -> None:
    if order + problem.ahead > _ORDERS or (precision or 0) > _BITS:
        raise FileError(f"{shown(problem)} to order {order} of λ has Fourier orders up to "
                        f"{order + problem.ahead}" + f" and {precision} bits" * bool(precision)
                        + f"; files hold Fourier orders up to {_ORDERS} and up to {_BITS} bits")


def _check_ansatz(problem: Problem, coefficients: Coefficients) -> None:
    """Refuse a coefficient that the seed gives otherwise, or that the ansatz leaves out."""
    seed = problem.first_coefficients()
    for name, rows in coefficients.items():
        for m, row in enumerate(rows):
            first = seed[name][m] if m < len(seed[name]) else None
            if first is not None and not _agree(row, first):
                raise FileError(f"the coefficients of {name} at order {m} of λ are not those of "
                                f"the seed of {shown(problem)}, so they were saved for another "
                                "seed; load them with that, or solve again")
            foreign = [] if first is not None else [
                mode for mode in row if not _possible(problem, name, mode, m)]
            if foreign:
                raise FileError(f"the file has the mode (sine, n) = {foreign[0]} of {name} at "
                                f"order {m} of λ, which the ansatz of {shown(problem)} leaves out")


def _agree(row: Modes, first: Mapping[Mode, Any]) -> bool:
    """Are these the coefficients of the seed, as the arithmetic holds them?"""
    def same(c: Number, q: Any) -> bool:
        if isinstance(c, arb):
            return bool((c * q.q - q.p).contains(0))
        return bool(c == (int(q.p) / int(q.q) if isinstance(c, float) else q))
    return row.keys() == first.keys() and all(same(row[mode], q) for mode, q in first.items())


def _possible(problem: Problem, name: str, mode: Mode, m: int) -> bool:
    unknown = problem.unknowns[name]
    return (unknown.has(mode) and not unknown.is_fixed(mode)
            and problem.allowed(name, mode[1], m))


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
        raise FileError(f"{_call(kind.__name__, arguments)} cannot be made again ({error}); give "
                        "load(path, problem=…)") from None
    return kind(**arguments)


def _call(name: str, arguments: Json) -> str:
    """How a problem would be made, for a sentence."""
    inner = ", ".join(f"{key}={value}" for key, value in arguments.items())
    return f"{name}({inner if len(inner) < 200 else inner[:200] + '…'})"


# --- numbers ------------------------------------------------------------------------------------

def _encode(number: Number) -> Json:
    if isinstance(number, float):
        return number
    if isinstance(number, fmpq):
        return str(number)
    if isinstance(number, arb):
        return [str(x) for part in (number.mid(), number.rad()) for x in part.man_exp()]
    return {",".join(str(e) for e in exponents[1:]): str(c)
            for exponents, c in number.to_dict().items()}


def _rational(text: Any) -> fmpq:
    if not isinstance(text, str) or not re.fullmatch(r"-?[0-9]+(/[0-9]*[1-9][0-9]*)?", text):
        raise ValueError(f"{shown(text)} is not an exact number")
    if len(text) > _DIGITS:
        raise ValueError(f"{shown(text)} has more than {_DIGITS} digits")
    p, _, q = text.partition("/")
    return fmpq(fmpz(p), fmpz(q or 1))


def _float(number: Any) -> float:
    if not isinstance(number, float) or not math.isfinite(number):
        raise ValueError(f"{shown(number)} is not a float")
    return number


def _ball(parts: Any) -> arb:
    if not isinstance(parts, list) or not all(
            isinstance(x, str) and re.fullmatch(form, x)
            for x, form in zip(parts, _BALL)) or len(parts) != 4:
        raise ValueError(f"{shown(parts)} is not a ball of four integers")
    m, e, r, f = map(fmpz, parts)
    return arb((m, e), (r, f))


def _polynomial(names: Sequence[str]) -> Callable[[Any], fmpq_mpoly]:
    ring = PolynomialRing(names)
    form = ",".join(["(0|[1-9][0-9]{0,5})"] * len(names))

    def decode(terms: Any) -> fmpq_mpoly:
        if not isinstance(terms, dict) or not all(re.fullmatch(form, key) for key in terms):
            raise ValueError(f"{shown(terms)} is not a polynomial in {', '.join(names)}")
        return ring.context.from_dict({(0, *map(int, exponents.split(","))): _rational(c)
                                       for exponents, c in terms.items()})
    return decode
