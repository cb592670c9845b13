r"""Values of a solution: its truncated series summed at numbers.

The methods of this class belong to :class:`ftseries.Solution`; the sums are those of
:mod:`ftseries.evaluation`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import cached_property, lru_cache, partial
from typing import TYPE_CHECKING, Any, TypeAlias

import mpmath
import numpy as np
import sympy as sp
from flint import fmpq

from . import evaluation
from .aliases import Array, ArrayLike, Coefficients, Mode, Number, Real
from .arguments import computed, scalars, whole
from .conversion import at, float_unit, to_float, to_mpf
from .errors import InputError, PrecisionWarning
from .problem import Scalar

if TYPE_CHECKING:
    from .problem import Problem

__all__ = ["Values"]

#: the values of free parameters, hashable
Point: TypeAlias = tuple[tuple[str, float], ...]


class Values:
    """A solution's coefficients as tables of floats, and its unknowns at numbers."""

    def __init__(self, problem: Problem, arithmetic: str, order: int, coefficients: Coefficients,
                 precision: int | None = None) -> None:
        self.problem, self.arithmetic, self.order = problem, arithmetic, order
        self.coefficients, self.precision = coefficients, precision
        self._table = lru_cache(maxsize=64)(self._make_table)
        self._scale = lru_cache(maxsize=64)(self._make_scale)

    def evaluate(self, name: str, t: ArrayLike | None = None, *positional: Any,
                 lam: ArrayLike | None = None, dps: int | None = None, derivative: int = 0,
                 **parameters: ArrayLike) -> Real:
        """The value of an unknown at times t and parameter λ.

        Parameters
        ----------
        name : str
            A field (then ``t`` is needed) or a scalar.
        t : array_like
            Times; the phase is ωt where the problem has an unknown frequency.
        lam : array_like
            The series parameter, given by its name; broadcasts with ``t``.
        dps : int, optional
            Decimal digits; the result then consists of mpmath numbers.  Python prints as many of
            them as ``mpmath.mp.dps`` says; ``mpmath.nstr(value, dps)`` shows all.  A float is the
            decimal that it looks like, ``lam=0.1`` is a tenth; of mpmath's numbers all bits count.
        derivative : int
            Of a field, its derivative of this order in the time t, for example 1 for the velocity.
        **parameters
            Values of the problem's free parameters, for example ``mu=-0.3``.

        Returns
        -------
        float, numpy.ndarray, or mpmath numbers

        Warns
        -----
        ConvergenceWarning
            λ lies outside the radius of convergence that the coefficients suggest; or, also with
            few coefficients, the terms of the last orders are not small.
        PrecisionWarning
            ``dps`` asks for more digits than the coefficients have.

        Examples
        --------
        >>> import ftseries as fts
        >>> sol = fts.solve(fts.CubicOscillator(a=1), order=24)
        >>> round(sol.evaluate("omega", lam=0.5), 13), sol.evaluate("x", [0.0, 0.1], lam=0.5).shape
        (3.4458763864723, (2,))
        >>> round(sol.evaluate("x", 0.3, lam=0.5, derivative=1), 10)                 # x'(0.3)
        -1.3518076837
        """
        evaluation.check_lam(self.problem, name, t, positional, lam)
        t = evaluation.times(self.problem, name, t, derivative)
        self._check_parameters(parameters)
        values = evaluation.broadcastable(t=t, lam=lam, **parameters)
        if dps is not None:
            return self._evaluate_mp(name, t, lam, dps, derivative, parameters)
        time, lam = values.pop("t"), values.pop("lam")
        if all(v.ndim == 0 for v in values.values()):
            point = tuple((k, float(v)) for k, v in values.items())
            result = self._evaluate(name, time, lam, derivative, point)
        else:
            result = self._evaluate_many(name, time, lam, derivative, values)
        return result[()] if np.ndim(result) else float(result)

    def table(self, name: str, **parameters: float) -> dict[Mode, list[float]]:
        """``{(sine, n): [A_{n,0}, A_{n,1}, …]}`` as floats in the paper's units."""
        evaluation.unknown(self.problem, name)
        self._check_parameters(parameters)
        table = self._table(name, tuple(scalars(parameters).items()))
        units = [float_unit(self.problem, self.problem.unit(name, m)) if any(column) else 1.0
                 for m, column in enumerate(zip(*table.values()))]
        return {mode: (row * units).tolist() for mode, row in table.items()}

    def _check_parameters(self, parameters: Mapping[str, Any]) -> None:
        wanted = set(self.problem.parameters)
        if set(parameters) != wanted:
            needs = ", ".join(f"{p}=…" for p in sorted(wanted)) or "no parameters besides t and lam"
            given = ", ".join(sorted(parameters)) or "none"
            raise InputError(f"{self.problem!r} needs {needs}; given: {given}")

    def _point(self, parameters: Mapping[str, Any]) -> list[fmpq]:
        """The values of the free parameters, in their order, as rationals."""
        return [computed(parameters[p]) for p in self.problem.parameters]

    def _make_table(self, name: str, parameters: Point) -> dict[Mode, Array]:
        """The coefficients in the solver's units, in which they grow least."""
        table: dict[Mode, Array] = {}
        point = self._point(dict(parameters))
        for m, row in enumerate(self.coefficients[name]):
            for mode, number in row.items():
                try:
                    value = to_float(at(number, point))
                except OverflowError:
                    raise InputError(f"the coefficients of {name!r} leave the floats at order {m} "
                                     f"of λ; truncate({m - 1}), or measure λ in another unit"
                                     ) from None
                table.setdefault(mode, np.zeros(self.order + 1))[m] = value
        return table

    def _amplitudes(self, name: str, lam: Array, parameters: Point) -> dict[Mode, Real]:
        """``{mode: A_n(λ)}`` in the paper's units."""
        table = self._table(name, parameters)
        return {mode: self._scale(name) * amplitude for mode, amplitude in
                evaluation.amplitudes(table, lam / self._lam_scale).items()}

    @cached_property
    def _lam_scale(self) -> float:
        return float_unit(self.problem, self.problem.lam_scale)

    def _make_scale(self, name: str) -> float:
        return float_unit(self.problem, self.problem.scale(name))

    @cached_property
    def _given(self) -> dict[str, int]:
        """How many orders of each unknown the seed gives."""
        return {name: len(rows) for name, rows in self.problem.first_coefficients().items()}

    def _summed(self, name: str) -> list[str]:
        """The unknowns whose series enter the value of one: a field has the frequency with it."""
        frequency = self.problem.frequency
        alone = isinstance(self.problem.unknowns[name], Scalar) or not frequency
        return [name] if alone else [name, str(frequency)]

    def _doubt(self, name: str, lam: ArrayLike, parameters: Point) -> str | None:
        """Why the truncated sum may be no approximation at λ, or None."""
        reasons = (evaluation.doubt(self._table(which, parameters), which, lam, self._given[which],
                                    self._lam_scale) for which in self._summed(name))
        return next(filter(None, reasons), None)

    def _evaluate(self, name: str, t: Array, lam: Array, order: int, parameters: Point) -> Real:
        if reason := self._doubt(name, lam, parameters):
            evaluation.warn(reason)
        amplitude, *frequency = (self._amplitudes(which, lam, parameters)
                                 for which in self._summed(name))
        if isinstance(self.problem.unknowns[name], Scalar):
            return amplitude.get((0, 0), np.zeros(lam.shape))
        omega = frequency[0][0, 0] if frequency else 1.0
        return evaluation.motion(amplitude, t + 0 * lam, omega, order)

    def _evaluate_many(self, name: str, t: Array, lam: Array, order: int,
                       values: dict[str, Array]) -> Array:
        arrays = np.broadcast_arrays(t, lam, *values.values())
        result = np.empty(arrays[0].shape)
        points = np.stack([a.ravel() for a in arrays[2:]], axis=1)
        unique, where = np.unique(points, axis=0, return_inverse=True)
        for i, point in enumerate(unique):
            here = (where.ravel() == i).reshape(result.shape)
            result[here] = self._evaluate(name, arrays[0][here], arrays[1][here], order,
                                          tuple(zip(values, map(float, point))))
        return result

    def _evaluate_mp(self, name: str, t: Any, lam: Any, dps: int, order: int,
                     parameters: Mapping[str, Any]) -> Any:
        known = {"float": 15, "ball": int((self.precision or 0) * math.log10(2))}
        if whole("dps", dps, 1) > known.get(self.arithmetic, dps):
            evaluation.warn(f"dps={dps}: in {self.arithmetic} arithmetic the coefficients have "
                            f"{known[self.arithmetic]} digits, and the rest is noise; solve with "
                            "arithmetic='exact' for more", PrecisionWarning)
        if any(np.ndim(value) for value in parameters.values()):
            raise InputError(f"with dps, give one value of {', '.join(parameters)} at a time")
        floats = tuple((k, float(v)) for k, v in parameters.items())
        if reason := self._doubt(name, np.asarray(lam, dtype=float), floats):
            evaluation.warn(reason)
        point = self._point(parameters)

        def rows(which: str) -> evaluation.MpTable:
            table: evaluation.MpTable = {}
            for m, row in enumerate(self.coefficients[which]):
                unit = sp.lambdify((), sp.sympify(self.problem.unit(which, m)), "mpmath")
                for mode, number in row.items():
                    table.setdefault(mode, [mpmath.mpf] * (self.order + 1))[m] = partial(
                        _product, unit, at(number, point))
            return table

        table, *frequency = (rows(which) for which in self._summed(name))
        return evaluation.mp_evaluate(table, frequency[0][0, 0] if frequency else None,
                                      t, lam, dps, order)


def _product(unit: Callable[[], Any], number: Number) -> Any:
    """A coefficient as an mpmath number at the working precision."""
    return unit() * to_mpf(number)
