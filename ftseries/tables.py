r"""The coefficients of a solution at values of its parameters: in floats, in balls, and their ends.

The methods of this class belong to :class:`ftseries.Solution`.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Mapping
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from flint import arb, fmpq

from . import enclosure, evaluation
from .aliases import Array, Coefficients, Exact, Mode, Real
from .arguments import computed, scalars
from .conversion import at, float_unit, numeric_unit, to_ball, to_float
from .doubt import Terms, nonzero
from .errors import FTSeriesError, InputError
from .problem import Scalar
from .refine import residuals

if TYPE_CHECKING:
    from .problem import Problem

__all__ = ["Point", "Tables"]

#: the values of free parameters, hashable
Point: TypeAlias = tuple[tuple[str, float], ...]

#: a series has ended where so many orders, or gaps between the terms of others, are zero
_QUIET, _GAPS = 8, 4
#: a λ without meaning, at which the residual of a finite solution vanishes, within this part
_TRIAL, _VANISHES = 0.7371, 1e-11


class Tables:
    """A solution's coefficients, and what is known of their series."""

    def __init__(self, problem: Problem, arithmetic: str, order: int, coefficients: Coefficients,
                 precision: int | None = None) -> None:
        self.problem, self.arithmetic, self.order = problem, arithmetic, order
        self.coefficients, self.precision = coefficients, precision
        self._table = lru_cache(maxsize=64)(self._make_table)
        self._scale = lru_cache(maxsize=64)(self._make_scale)
        self._terms = lru_cache(maxsize=64)(self._make_terms)
        self._radii = lru_cache(maxsize=64)(self._make_radii)
        self._gap = lru_cache(maxsize=64)(self._find_gap)
        self._finite = lru_cache(maxsize=64)(self._is_finite)

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
            other = "" if all(unicodedata.is_normalized("NFKC", p) for p in parameters) else (
                "; names are written as Python writes them (NFKC)")
            raise InputError(f"{self.problem!r} needs {needs}; given: {given}{other}")

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

    def _make_radii(self, name: str, derivative: int) -> Array:
        """Σ_n n^derivative rad A_{n,m} of balls, by m."""
        return np.array([sum(n**derivative * float(arb(number).rad())
                             for (_, n), number in row.items()) for row in self.coefficients[name]])

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

    def _summed(self, name: str) -> list[str]:
        """The unknowns whose series enter the value of one: a field has the frequency with it."""
        frequency = self.problem.frequency
        alone = isinstance(self.problem.unknowns[name], Scalar) or not frequency
        return [name] if alone else [name, str(frequency)]

    def _sums(self, names: list[str], lam: Any, point: list[fmpq],
              read: Callable[[Exact], fmpq]) -> Any:
        """The series of an unknown and of the frequency at each λ, in balls."""
        unit = to_ball(numeric_unit(self.problem, self.problem.lam_scale))
        series = [enclosure.polynomials(self.coefficients[name], point, to_ball(
            numeric_unit(self.problem, self.problem.scale(name)))) for name in names]
        return np.frompyfunc(
            lambda x: enclosure.Sum.at(enclosure.ball(x, read) / unit, *series), 1, 1)(lam)

    # --- how a series goes on -------------------------------------------------------------------

    def _make_terms(self, name: str, derivative: int, parameters: Point) -> Terms:
        return Terms(self._certain(name, parameters), self._given[name],
                     self._has_ended(name, parameters), derivative)

    @cached_property
    def _given(self) -> dict[str, int]:
        """How many orders of each unknown the seed gives."""
        return {name: len(rows) for name, rows in self.problem.first_coefficients().items()}

    def _certain(self, name: str, parameters: Point) -> dict[Mode, Array]:
        """The table without the balls around 0, of which not even the sign is known."""
        table = self._table(name, parameters)
        if self.arithmetic != "ball":
            return table
        return {mode: np.array([c * (not row.get(mode, arb(0)).contains(0)) for c, row in
                                zip(column, self.coefficients[name])])
                for mode, column in table.items()}

    def _orders(self, name: str, parameters: Point) -> Any:
        """The Taylor orders at which there are terms."""
        columns = self._certain(name, parameters).values()
        return nonzero(sum(map(np.abs, columns), np.zeros(self.order + 1)))

    def _has_ended(self, name: str, parameters: Point) -> bool:
        """Are there no further terms: a long silence, or a finite solution of the equations?

        A ball around 0 may be a term.
        """
        orders = self._orders(name, parameters)
        if not orders.size and not self._stays_zero(parameters):
            return False
        last = int(orders[-1]) if orders.size else -1
        quiet = self.order - last
        later = (number for row in self.coefficients[name][last + 1:] for number in row.values())
        if orders.size > 2 and quiet < np.gcd.reduce(np.diff(orders)) or any(
                isinstance(number, arb) and number != 0 for number in later):
            return False
        gap = self._gap(parameters)
        return bool(gap) and quiet >= max(_QUIET, _GAPS * gap) or self._finite(parameters)

    def _find_gap(self, parameters: Point) -> int:
        """The largest gap between terms of any unknown that has at least three; 0 without one."""
        found = [self._orders(name, parameters) for name in self.problem.unknowns]
        return max((int(np.diff(orders).max()) for orders in found if orders.size > 2), default=0)

    def _stays_zero(self, parameters: Point) -> bool:
        """Do as many equations hold as there are unknowns without any term, whatever the others?

        Else such an unknown may begin at the next order.
        """
        zero = [name for name in self.problem.unknowns
                if not self._orders(name, parameters).size]
        sums = {name: {mode: 1.1 * a for mode, a in evaluation.amplitudes(
            self._table(name, parameters), _TRIAL).items()} for name in self.problem.unknowns}
        try:
            with np.errstate(all="ignore"):
                rest = list(residuals(self.problem, sums, _TRIAL, dict(parameters)).values())
        except FTSeriesError:
            return False
        return sum(each <= _VANISHES * max(rest) for each in rest) >= len(zero)

    def _is_finite(self, parameters: Point) -> bool:
        """Do the sums satisfy the equations as they are, and not if they are all changed a bit?"""
        sums = {name: evaluation.amplitudes(self._table(name, parameters), _TRIAL)
                for name in self.problem.unknowns}
        more = {name: {mode: 1.1 * a for mode, a in modes.items()} for name, modes in sums.items()}
        try:
            with np.errstate(all="ignore"):
                rest, moved = (max(residuals(self.problem, each, _TRIAL, dict(parameters)).values())
                               for each in (sums, more))
        except FTSeriesError:
            return False
        return rest <= _VANISHES * moved
