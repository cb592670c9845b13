r"""A solved problem: coefficients, evaluation, truncation.

Index convention and formula.  ``coefficients[name][m]`` is the Taylor coefficient of order m of an
unknown as a dict ``{(sine, n): number}``, in the solver's units (see ``Problem.unit``):

.. math::  u(t; λ) = \sum_m λ^m\, \mathrm{unit}(m) \sum_n (A_{n,m} \cos nωt + B_{n,m} \sin nωt).

Zero coefficients are left out; a scalar keeps its number under (0, 0).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache, partial
from typing import TYPE_CHECKING, Any, TypeAlias

import mpmath
import numpy as np
import sympy as sp
from flint import arb, ctx, fmpq

from . import display, evaluation, storage
from .aliases import Array, ArrayLike, Coefficients, FilePath, Mode, Number, Real
from .arguments import rational, scalars, whole
from .conversion import at, to_ball, to_float, to_mpf, to_sympy
from .errors import InputError
from .problem import Field, Scalar
from .quality import Quality

if TYPE_CHECKING:
    from .problem import Problem

__all__ = ["Solution", "load"]

#: the values of free parameters, hashable
Values: TypeAlias = tuple[tuple[str, float], ...]


class Solution(Quality):
    """The truncated Fourier-Taylor series of every unknown; made by :func:`ftseries.solve`.

    Attributes
    ----------
    problem : Problem
    arithmetic : str
        "exact", "float" or "ball".
    order : int
        The highest Taylor order.
    coefficients : dict
        As in the module's formula.
    precision : int or None
        Bits, in ball arithmetic.
    """

    def __init__(self, problem: Problem, arithmetic: str, order: int, coefficients: Coefficients,
                 precision: int | None = None) -> None:
        self.problem, self.arithmetic, self.order = problem, arithmetic, order
        self.coefficients, self.precision = coefficients, precision
        self._table = lru_cache(maxsize=64)(self._make_table)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickled like a saved file, so that solutions travel between processes."""
        return _restored, (self.problem, self.arithmetic, self.order,
                           storage.encoded(self.coefficients), self.precision)

    def __repr__(self) -> str:
        bits = f", precision={self.precision}" if self.precision else ""
        return f"<Solution of {self.problem!r}, order {self.order}, {self.arithmetic}{bits}>"

    def coefficient(self, name: str, *orders: int, sine: bool | None = None) -> Any:
        """One coefficient: ``coefficient("x", n, m)`` of a field, ``coefficient("omega", m)``.

        Parameters
        ----------
        name : str
            An unknown of the problem.
        *orders : int
            Fourier order n and Taylor order m; for a scalar unknown the Taylor order alone.
        sine : bool, optional
            Choose sine or cosine where the unknown has both.

        Returns
        -------
        SymPy expression, float, or python-flint ball, by arithmetic.

        Examples
        --------
        >>> import ftseries as fts
        >>> sol = fts.solve(fts.FigureEight(), order=4)
        >>> sol.coefficient("r", 4, 4), sol.coefficient("phi", 3, 3)          # (E6c), (E6d)
        (3**(1/3)/256, -1/48)
        """
        unknown = self._unknown(name)
        scalar = isinstance(unknown, Scalar)
        if len(orders) != (1 if scalar else 2):
            raise InputError(f"{name!r} takes {'its Taylor order m' if scalar else 'n and m'}: "
                             f"coefficient({name!r}, {'m' if scalar else 'n, m'}), not {orders!r}")
        n, m = [0, *(whole("order", order) for order in orders)][-2:]
        if m > self.order:
            raise InputError(f"{name!r} is known to order {self.order}, not to {m}; solve again "
                             f"with order={m}")
        if isinstance(unknown, Field) and sine is None:
            if unknown.series == "both" and n:
                raise InputError(f"{name!r} has cosines and sines; say sine=True or sine=False")
            sine = unknown.series == "sin"
        return self._in_unit(name, m, self.coefficients[name][m].get((int(bool(sine)), n)))

    def evaluate(self, name: str, t: ArrayLike | None = None, *, lam: ArrayLike,
                 dps: int | None = None, **parameters: ArrayLike) -> Real:
        """The value of an unknown at times t and parameter λ.

        Parameters
        ----------
        name : str
            A field (then ``t`` is needed) or a scalar.
        t : array_like
            Times; the phase is ωt where the problem has an unknown frequency.
        lam : array_like
            The series parameter; broadcasts with ``t``.
        dps : int, optional
            Decimal digits; the result then consists of mpmath numbers.
        **parameters
            Values of the problem's free parameters, for example ``mu=-0.3``.

        Returns
        -------
        float, numpy.ndarray, or mpmath numbers

        Warns
        -----
        ConvergenceWarning
            λ lies outside the radius of convergence that the coefficients suggest.

        Examples
        --------
        >>> import ftseries as fts
        >>> sol = fts.solve(fts.CubicOscillator(a=1), order=24)
        >>> round(sol.evaluate("omega", lam=0.5), 13), sol.evaluate("x", [0.0, 0.1], lam=0.5).shape
        (3.4458763864723, (2,))
        """
        unknown = self._unknown(name)
        if isinstance(unknown, Scalar):
            if t is not None:
                raise InputError(f"{name!r} does not depend on time; leave t out")
            t = 0
        elif t is None:
            raise InputError(f"{name!r} depends on time: evaluate({name!r}, t, lam=…)")
        self._check_parameters(parameters)
        values = evaluation.broadcastable(t=t, lam=lam, **parameters)
        if dps is not None:
            return self._evaluate_mp(name, t, lam, dps, parameters)
        t, lam = values.pop("t"), values.pop("lam")
        if all(v.ndim == 0 for v in values.values()):
            result = self._evaluate(name, t, lam, tuple((k, float(v)) for k, v in values.items()))
        else:
            result = self._evaluate_many(name, t, lam, values)
        return result[()] if np.ndim(result) else float(result)

    def truncate(self, order: int) -> Solution:
        """The same solution cut at a lower Taylor order."""
        order = whole("order", order)
        if order > self.order:
            raise InputError(f"cannot cut at order {order}: the solution ends at {self.order}")
        return Solution(self.problem, self.arithmetic, order,
                        {name: rows[:order + 1] for name, rows in self.coefficients.items()},
                        self.precision)

    def to_latex(self, name: str, order: int | None = None) -> str:
        """The series of one unknown as LaTeX, cut at Taylor order ``order``."""
        return display.to_latex(self, name, min(self.order, 6) if order is None else order)

    def _repr_latex_(self) -> str:
        return display.summary(self)

    def save(self, path: FilePath) -> None:
        """Write the solution as JSON; see :func:`ftseries.storage.save`."""
        storage.save(self, path)

    def table(self, name: str, **parameters: float) -> dict[Mode, list[float]]:
        """``{(sine, n): [A_{n,0}, A_{n,1}, …]}`` as floats in the paper's units."""
        self._unknown(name)
        self._check_parameters(parameters)
        values = tuple(scalars(parameters).items())
        return {mode: list(row) for mode, row in self._table(name, values).items()}

    def _unknown(self, name: str) -> Field | Scalar:
        try:
            return self.problem.unknowns[name]
        except (KeyError, TypeError):
            raise InputError(f"{name!r} is not an unknown of {self.problem!r}; it has "
                             f"{', '.join(map(repr, self.problem.unknowns))}") from None

    def _check_parameters(self, parameters: Mapping[str, Any]) -> None:
        wanted = set(self.problem.parameters)
        if set(parameters) != wanted:
            needs = ", ".join(f"{p}=…" for p in sorted(wanted)) or "no parameters besides t and lam"
            given = ", ".join(sorted(parameters)) or "none"
            raise InputError(f"{self.problem!r} needs {needs}; given: {given}")

    def _point(self, parameters: Mapping[str, Any]) -> list[fmpq]:
        """The values of the free parameters, in their order, as rationals."""
        return [rational(parameters[p]) for p in self.problem.parameters]

    def _in_unit(self, name: str, m: int, number: Number | None) -> Any:
        """A solver's number (or None for zero) in the paper's unit and the caller's type."""
        unit = sp.sympify(self.problem.unit(name, m))
        if self.arithmetic == "exact":
            return sp.S.Zero if number is None else unit * to_sympy(number, self.problem.parameters)
        if unit.free_symbols:
            raise InputError(f"{self.problem!r} has a symbol in its unit; give it a value, or "
                             "solve with arithmetic='exact'")
        if self.arithmetic == "float":
            return 0.0 if number is None else float(unit) * number
        with ctx.workprec(self.precision or ctx.prec):
            return arb(0) if number is None else to_ball(unit) * number

    def _make_table(self, name: str, parameters: Values) -> dict[Mode, Array]:
        table: dict[Mode, Array] = {}
        point = self._point(dict(parameters))
        for m, row in enumerate(self.coefficients[name]):
            unit = sp.sympify(self.problem.unit(name, m))
            if unit.free_symbols:
                raise InputError(f"{self.problem!r} contains {unit.free_symbols.pop()}; give it a "
                                 "number to evaluate")
            unit = float(unit)
            for mode, number in row.items():
                table.setdefault(mode, np.zeros(self.order + 1))[m] = (
                    unit * to_float(at(number, point)))
        return table

    def _evaluate(self, name: str, t: Array, lam: Array, parameters: Values) -> Array:
        table = self._table(name, parameters)
        evaluation.warn_outside(table, name, lam)
        amplitude = evaluation.amplitudes(table, lam)
        if isinstance(self.problem.unknowns[name], Scalar):
            return amplitude.get((0, 0), np.zeros(lam.shape))
        if self.problem.frequency:
            frequency = self._table(self.problem.frequency, parameters)
            t = t * evaluation.amplitudes(frequency, lam)[0, 0]
        return evaluation.fourier_sum(amplitude, t + 0 * lam)

    def _evaluate_many(self, name: str, t: Array, lam: Array, values: dict[str, Array]) -> Array:
        arrays = np.broadcast_arrays(t, lam, *values.values())
        result = np.empty(arrays[0].shape)
        points = np.stack([a.ravel() for a in arrays[2:]], axis=1)
        unique, where = np.unique(points, axis=0, return_inverse=True)
        for i, point in enumerate(unique):
            here = (where.ravel() == i).reshape(result.shape)
            result[here] = self._evaluate(name, arrays[0][here], arrays[1][here],
                                          tuple(zip(values, map(float, point))))
        return result

    def _evaluate_mp(self, name: str, t: Any, lam: Any, dps: int,
                     parameters: Mapping[str, Any]) -> Any:
        dps = whole("dps", dps, 1)
        if any(np.ndim(value) for value in parameters.values()):
            raise InputError(f"with dps, give one value of {', '.join(parameters)} at a time")
        floats = tuple((k, float(v)) for k, v in parameters.items())
        evaluation.warn_outside(self._table(name, floats), name, np.asarray(lam, dtype=float))
        point = self._point(parameters)

        def rows(which: str) -> evaluation.MpTable:
            table: evaluation.MpTable = {}
            for m, row in enumerate(self.coefficients[which]):
                unit = sp.lambdify((), sp.sympify(self.problem.unit(which, m)), "mpmath")
                for mode, number in row.items():
                    table.setdefault(mode, [mpmath.mpf] * (self.order + 1))[m] = partial(
                        _product, unit, at(number, point))
            return table

        frequency = self.problem.frequency
        if isinstance(self.problem.unknowns[name], Scalar):
            frequency = None
        return evaluation.mp_evaluate(rows(name), rows(frequency)[0, 0] if frequency else None,
                                      t, lam, dps)


def _product(unit: Callable[[], Any], number: Number) -> Any:
    """A coefficient as an mpmath number at the working precision."""
    return unit() * to_mpf(number)


def _restored(problem: Problem, arithmetic: str, order: int, coefficients: Any,
              precision: int | None) -> Solution:
    return Solution(problem, arithmetic, order,
                    storage.decoded(coefficients, problem, arithmetic), precision)


def load(path: FilePath, problem: Problem | None = None) -> Solution:
    """Read a solution written by :meth:`Solution.save`.

    Parameters
    ----------
    path : str or path
    problem : Problem, optional
        Needed when the problem's class has not been imported or cannot be made from its
        ``arguments()``.

    Raises
    ------
    FileError
        The file is missing, damaged, or of another kind.

    Examples
    --------
    >>> import ftseries as fts, os, tempfile
    >>> sol = fts.solve(fts.GeneralizedMathieu(), order=9)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = os.path.join(folder, "mathieu.json")
    ...     sol.save(file)
    ...     fts.load(file).coefficients == sol.coefficients
    True
    """
    return Solution(*storage.read(path, problem))
