"""Solutions as JSON files: exact numbers as strings, floats as shortest round-trip decimals.

Format 1: ``{"format": "ftseries", "version": 1, "problem": {"name", "arguments"}, "arithmetic",
"order", "precision", "coefficients": {unknown: [[[sine, n, number], …] for each Taylor order]},
"sha256"}``, the last one of everything else, so that no damage goes unnoticed.
A rational is "p/q", a polynomial a dict from exponents "i,j" to rationals, a ball the four integers
[midpoint mantissa, exponent, radius mantissa, exponent]; FLINT reads the radius back with an upward
rounding of 2^-30, so the ball still encloses what it did.
"""

import hashlib
import json
import os

from flint import arb, fmpq

from .errors import FileError, InputError
from .laurent import PolynomialRing
from .problem import Problem
from .trig import rational

__all__ = ["save", "read", "encoded", "decoded"]


def save(solution, path):
    """Write a solution; the file appears complete or not at all.

    Raises
    ------
    FileError
        The folder does not exist or cannot be written.
    """
    data = {
        "format": "ftseries", "version": 1,
        "problem": {"name": type(solution.problem).__name__,
                    "arguments": solution.problem.arguments()},
        "arithmetic": solution.arithmetic, "order": solution.order,
        "precision": solution.precision,
        "coefficients": encoded(solution.coefficients),
    }
    path = os.fspath(path)
    try:
        text = json.dumps(data | {"sha256": _digest(data)})
    except (TypeError, ValueError):
        raise FileError(f"cannot write {path!r}: the arguments of {solution.problem!r} are not "
                        "plain JSON values; make its method 'arguments' return such") from None
    temporary = f"{path}.{os.getpid()}.part"
    try:
        with open(temporary, "w", encoding="utf-8") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except OSError as error:
        raise FileError(f"cannot write {path!r}: {error.strerror}; choose another place") from error
    finally:
        if os.path.exists(temporary):
            os.unlink(temporary)


def _digest(data):
    return hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()


def read(path, problem=None):
    """What :class:`ftseries.Solution` is made of, from a file written by :func:`save`."""
    path = os.fspath(path)
    try:
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
    except OSError as error:
        raise FileError(f"cannot read {path!r}: {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise FileError(f"{path!r} is damaged or not JSON ({error}); save it again") from None
    if not isinstance(data, dict) or data.get("format") != "ftseries":
        raise FileError(f"{path!r} is not a saved ftseries solution")
    if data.get("version") != 1:
        raise FileError(f"{path!r} has format version {data.get('version')!r}; this reads 1")
    if data.pop("sha256", None) != _digest(data):
        raise FileError(f"{path!r} is damaged: its contents do not match their checksum; save the "
                        "solution again")
    try:
        return _contents(data, problem)
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError) as error:
        raise FileError(f"{path!r} is damaged: {error}; save the solution again") from None


def encoded(coefficients):
    """Coefficients as plain JSON values."""
    return {name: [[[*mode, _encode(c)] for mode, c in sorted(row.items())] for row in rows]
            for name, rows in coefficients.items()}


def decoded(coefficients, problem, arithmetic):
    """The coefficients again; what belongs to no unknown of the problem is not read."""
    decode = {"exact": _polynomial(problem.parameters) if problem.parameters else _rational,
              "float": float, "ball": _ball}[arithmetic]
    return {name: [{(sine, n): decode(c) for sine, n, c in row} for row in coefficients[name]]
            for name in problem.unknowns}


def _contents(data, problem):
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


def _encode(number):
    if isinstance(number, float):
        return number
    if isinstance(number, fmpq):
        return str(number)
    if isinstance(number, arb):
        return [str(x) for part in (number.mid(), number.rad()) for x in part.man_exp()]
    return {",".join(str(e) for e in exponents[1:]): str(c)
            for exponents, c in number.to_dict().items()}


def _rational(text):
    if not isinstance(text, str):
        raise ValueError(f"{text!r} is not an exact number")
    return rational(text)


def _ball(parts):
    m, e, r, f = (int(x) for x in parts)
    return arb((m, e), (r, f))


def _polynomial(names):
    ring = PolynomialRing(names)

    def decode(terms):
        return ring.context.from_dict({(0, *map(int, exponents.split(","))): rational(c)
                                       for exponents, c in terms.items()})
    return decode
