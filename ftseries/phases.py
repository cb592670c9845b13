r"""The equations at single phases τ, as power series in λ: what is solved is looked at afresh.

Formula.  At a number τ a Fourier-Taylor series is a power series in λ alone,

.. math::  u(τ; λ) = \sum_m λ^m \sum_n (A_{n,m} \cos nτ + B_{n,m} \sin nτ),

so the residuals of a problem are power series too, in FLINT's own arithmetic of them, with balls
for coefficients.  Derivatives in τ follow the rules of calculus from those of the unknowns; shifts
by a part of a period lead to further phases.  The first phase is τ = 1: e^i is transcendental, so a
Fourier sum with algebraic coefficients vanishes there only if all of them do.  Free parameters have
the values e^{-√2}, e^{-√3}, e^{-√5}, …, algebraically independent of e^i and of one another
(Lindemann and Weierstrass).

Rounding of floats is measured against what was added up: the spread of a function, log₂ of the
size of its terms by order, is that of its parts also where they cancel,

.. math::  (a b)_k:  \max_j \max(|a_j| \, \mathrm{spread}\, b_{k-j}, \;
                                 |b_j| \, \mathrm{spread}\, a_{k-j}),

and what a function g(a) does to the spread of a, g'(a) does likewise.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from flint import arb, arb_mat, arb_series, fmpq

from . import rounding
from .aliases import Array, Coefficients, Exact, Mode, Modes, Number
from .arguments import decimal
from .errors import InputError
from .function import Function
from .precision import working

if TYPE_CHECKING:
    from .problem import Problem

__all__ = ["Defect", "mode", "unsatisfied"]

#: bits at which exact coefficients, and floats, are put in; what they may at most become
_BITS = {"exact": 512, "float": 96, "ball": 128}
_MOST_BITS = 2**14
#: a residual of exact coefficients is zero if it is below this part of its terms
_EXACT = arb(2) ** -128
#: the same of floats
_FLOAT = arb(rounding.NEGLIGIBLE)


class Denser(Exception):
    """Shifts by a part 1/q of a period ask for q phases; the argument is q."""


class Phases:
    """``count`` phases 1 + 2πj/count, and series up to λ^top; it makes λ, parameters, waves."""

    def __init__(self, top: int, count: int, parameters: Sequence[str]) -> None:
        self.top, self.count = top, count
        self.tau = [1 + 2 * arb.pi() * fmpq(j, count) for j in range(count)]
        self.parameters = dict(zip(parameters, independent(len(parameters))))
        #: every function that was made, for the size of the terms
        self.made: list[AtPhases] = []
        self.lam = self._same(self.series([0, 1]))

    def series(self, coefficients: Sequence[Any]) -> arb_series:
        return arb_series(list(coefficients), self.top + 1)

    def zero(self) -> AtPhases:
        return self.constant(0)

    def constant(self, number: Exact) -> AtPhases:
        return self._constant(arb(decimal(number)))

    def _constant(self, number: arb) -> AtPhases:
        return self._same(self.series([number]))

    def _same(self, series: arb_series) -> AtPhases:
        """A function of λ alone."""
        return AtPhases(self, [series] * self.count, self.zero,
                        lambda: [_magnitude(series, self.top)] * self.count)

    def parameter(self, name: str) -> AtPhases:
        return self._constant(self.parameters[name])

    def cos(self, n: int) -> AtPhases:
        return self.polynomial([{(0, n): arb(1)}])

    def sin(self, n: int) -> AtPhases:
        return self.polynomial([{(1, n): arb(1)}])

    def polynomial(self, rows: Sequence[Modes]) -> AtPhases:
        """The series with the Taylor coefficients ``{(sine, n): number}``."""
        modes = sorted({mode for row in rows for mode in row})
        if not modes:
            return self.zero()
        where, point = {mode: i for i, mode in enumerate(modes)}, list(self.parameters.values())
        table: list[list[Number]] = [[0] * len(modes) for _ in rows]
        for line, row in zip(table, rows):
            for mode, c in row.items():
                line[where[mode]] = _ball(c, point) if point else c
        return self._waves(modes, arb_mat(table))

    def _waves(self, modes: list[Mode], matrix: arb_mat, times: int = 0) -> AtPhases:
        """Σ_n of cos nτ and sin nτ, or their derivatives, with the coefficients in ``matrix``."""
        waves = arb_mat([[n**times * _wave(n * tau, times - sine) for tau in self.tau]
                         for sine, n in modes])
        product = matrix * waves

        def spread() -> list[Array]:
            terms = [self.series([sum(abs(matrix[m, i]) * n**times for i, (_, n) in
                                      enumerate(modes)) for m in range(matrix.nrows())])]
            return [_magnitude(series, self.top) for series in terms * self.count]
        return AtPhases(self, [self.series([product[m, j] for m in range(matrix.nrows())])
                               for j in range(self.count)],
                        lambda: self._waves(modes, matrix, times + 1), spread)

    def sizes(self) -> list[arb]:
        """The largest term of each order of λ."""
        sizes = [arb(0)] * (self.top + 1)
        for function in self.made:
            for series in function.values:
                for k, c in enumerate(series.coeffs()):
                    sizes[k] = max(sizes[k], c.abs_upper())
        return sizes

    def spread(self) -> Array:
        """The largest term of each order, those that cancel among them."""
        largest = np.max([spread for function in self.made for spread in function.spread], axis=0)
        with np.errstate(over="ignore"):
            sizes: Array = np.exp2(largest)
        return sizes


class AtPhases(Function):
    """One function: a power series in λ at each phase, and what makes its derivative in τ."""

    def __init__(self, phases: Phases, values: Sequence[arb_series],
                 derivative: Callable[[], AtPhases], spread: Callable[[], list[Array]]) -> None:
        self.expansion, self.values = phases, list(values)
        self._derivative, self._spread = derivative, spread
        phases.made.append(self)

    def _new(self, values: Iterator[arb_series] | list[arb_series],
             derivative: Callable[[], AtPhases], spread: Callable[[], list[Array]]) -> AtPhases:
        return AtPhases(self.expansion, list(values), derivative, spread)

    @cached_property
    def slope(self) -> AtPhases:
        return self._derivative()

    @cached_property
    def magnitudes(self) -> list[Array]:
        """log₂ of the coefficients, at each phase."""
        return self._magnitudes(self.values)

    def _magnitudes(self, values: list[arb_series]) -> list[Array]:
        return [_magnitude(series, self.expansion.top) for series in values]

    @cached_property
    def spread(self) -> list[Array]:
        """log₂ of the size of the terms behind each coefficient, at each phase."""
        return list(map(np.maximum, self._spread(), self.magnitudes))

    def _sum(self, other: AtPhases) -> AtPhases:
        return self._new(map(_add, self.values, other.values), lambda: self.slope + other.slope,
                         lambda: list(map(np.maximum, self.spread, other.spread)))

    def _product(self, other: AtPhases) -> AtPhases:
        return self._new(map(_multiply, self.values, other.values),
                         lambda: self.slope * other + self * other.slope,
                         lambda: list(map(np.maximum, self._carry(other.magnitudes),
                                          other._carry(self.magnitudes))))

    def _carry(self, factors: list[Array]) -> list[Array]:
        """The spread of this function in its product with another."""
        return list(map(_largest_product, factors, self.spread))

    def _multiple(self, number: Exact) -> AtPhases:
        factor = arb(decimal(number))
        size = _log2(factor)
        return self._new([v * factor for v in self.values], lambda: self.slope * number,
                         lambda: [spread + size for spread in self.spread])

    def _power(self, alpha: fmpq) -> AtPhases:
        exponent, less = (int(a.p) if a.q == 1 else arb(a) for a in (alpha, alpha - 1))
        factor = arb(alpha)
        return self._new([v**exponent for v in self.values],
                         lambda: self ** (alpha - 1) * self.slope * alpha,
                         lambda: self._carry(
                             self._magnitudes([v**less * factor for v in self.values])))

    def exp(self) -> AtPhases:
        result = self._new([v.exp() for v in self.values], lambda: result * self.slope,
                           lambda: self._carry(result.magnitudes))
        return result

    def sin(self) -> AtPhases:
        return self._new([v.sin() for v in self.values], lambda: self.cos() * self.slope,
                         lambda: self._carry(self._magnitudes([v.cos() for v in self.values])))

    def cos(self) -> AtPhases:
        return self._new([v.cos() for v in self.values], lambda: self.sin() * self.slope * -1,
                         lambda: self._carry(self._magnitudes([v.sin() for v in self.values])))

    def diff(self, times: int = 1) -> AtPhases:
        return self.slope if times == 1 else self.slope.diff(times - 1)

    def shift(self, fraction: Exact) -> AtPhases:
        steps = decimal(fraction) * self.expansion.count
        if steps.q != 1:
            raise Denser(int((steps / self.expansion.count).q))
        first = int(steps.p) % self.expansion.count
        return self._new(self.values[first:] + self.values[:first],
                         lambda: self.slope.shift(fraction),
                         lambda: self.spread[first:] + self.spread[:first])

    def neighbours(self, bodies: int = 3) -> AtPhases:
        total = self.shift(fmpq(1, bodies))
        for j in range(2, bodies):
            total = total + self.shift(fmpq(j, bodies))
        return total


def _wave(angle: arb, quarters: int) -> arb:
    """cos(angle + π/2 · quarters)."""
    return (angle.cos(), -angle.sin(), -angle.cos(), angle.sin())[quarters % 4]


def _add(a: arb_series, b: arb_series) -> arb_series:
    return a + b


def _multiply(a: arb_series, b: arb_series) -> arb_series:
    return a * b


def _magnitude(series: arb_series, top: int) -> Array:
    """log₂ of the sizes of the coefficients up to λ^top; -inf of 0."""
    result = np.full(top + 1, -math.inf)
    for k, c in enumerate(series.coeffs()):
        result[k] = _log2(c)
    return result


def _log2(number: arb) -> float:
    size = number.abs_upper()
    if not size.is_finite():
        return math.inf
    man, exp = size.man_exp()
    return math.log2(int(man)) + int(exp) if man else -math.inf


def _largest_product(a: Array, b: Array) -> Array:
    """The logarithms max_j (a_j + b_{k-j})."""
    result = np.full(len(a), -math.inf)
    for j, size in enumerate(a):
        np.maximum(result[j:], size + b[:len(b) - j], out=result[j:])
    return result


def independent(count: int) -> list[arb]:
    """e^{-√2}, e^{-√3}, e^{-√5}, …"""
    primes = [p for p in range(2, 20 + 20 * count) if all(p % q for q in range(2, p))]
    return [(-arb(p).sqrt()).exp() for p in primes[:count]]


class Defect(NamedTuple):
    """A residual that does not vanish."""

    equation: str
    #: of λ
    order: int
    #: its size against the terms of that order
    share: float


def unsatisfied(problem: Problem, arithmetic: str, coefficients: Coefficients,
                shifts: Sequence[int] | None = None, precision: int | None = None) -> Defect | None:
    """The lowest residual that does not vanish, or None.

    Parameters
    ----------
    problem : Problem
    arithmetic : "exact", "float" or "ball"
        Which numbers the coefficients are.  A residual vanishes if its ball contains 0 and is
        narrower than 2^-128 of its terms (the bits are raised until it is); if it is below 1e-9 of
        its terms; or if its ball contains 0.
    coefficients : dict
        ``{name: [{(sine, n): number}, …]}``, all unknowns to the same order.
    shifts : sequence of int, optional
        s_e for each equation: coefficients up to order m determine its residual up to m + s_e.
    precision : int, optional
        Bits of balls.

    Examples
    --------
    >>> import ftseries as fts
    >>> problem = fts.CubicOscillator(a=1)
    >>> sol = fts.solve(problem, order=6)
    >>> unsatisfied(problem, "exact", sol.coefficients) is None
    True
    >>> sol.coefficients["x"][5][0, 1] += 1
    >>> unsatisfied(problem, "exact", sol.coefficients)[:2]
    ('(C3)', 6)
    """
    order = min(map(len, coefficients.values())) - 1
    top, bits = order + max(shifts or [0]), precision or _BITS[arithmetic]
    while bits <= max(_MOST_BITS, precision or 0):
        with working(bits=bits, terms=top + 1):
            phases, found = _residuals(problem, coefficients, top)
            bad, narrow = _first(phases, found, arithmetic, shifts or [0] * len(found), order)
        if bad or narrow:
            return bad
        bits *= 2
    raise InputError(f"{problem!r}: its residuals cannot be decided with {_MOST_BITS} bits; solve "
                     "to a lower order")


def mode(problem: Problem, coefficients: Coefficients, defect: Defect) -> Mode:
    """The largest Fourier mode (sine, n) of a residual that does not vanish."""
    count, bits = 4, _BITS["float"]
    while count < 4 * (defect.order + problem.ahead + 1):
        count *= 2
    count *= 3                                                     # shifts by thirds are on it
    with working(bits=bits, terms=defect.order + 1):
        _, found = _residuals(problem, coefficients, defect.order, count)
        values = [float(series[defect.order]) for series in found[defect.equation].values]
    n = np.arange(count // 2)
    modes = np.exp(-1j * n) * np.fft.rfft(values)[:count // 2]
    largest = int(np.argmax(abs(modes)))
    return int(abs(modes[largest].imag) > abs(modes[largest].real)), largest


def _residuals(problem: Problem, coefficients: Coefficients, top: int,
               count: int = 1) -> tuple[Phases, dict[str, AtPhases]]:
    try:
        phases = Phases(top, count, problem.parameters)
        unknowns = {name: phases.polynomial(rows) for name, rows in coefficients.items()}
        return phases, problem.residuals(phases.lam, unknowns)
    except Denser as denser:
        return _residuals(problem, coefficients, top, math.lcm(count, *denser.args))


def _first(phases: Phases, found: Mapping[str, AtPhases], arithmetic: str, shifts: Sequence[int],
           order: int) -> tuple[Defect | None, bool]:
    """The first residual that does not vanish; and whether the balls are narrow enough to say."""
    tops = [order + shift for shift in shifts]
    if arithmetic == "float":                          # the spread takes longer, and tells more
        return (_first_float(found, tops, phases.sizes())
                and _first_float(found, tops, rounding.sizes(phases.spread().tolist()))), True
    sizes, bad, narrow = phases.sizes(), [], True
    least = _EXACT * max(sizes)              # where all terms of an order vanish, rounding is left
    for (name, residual), top in zip(found.items(), tops):
        for series in residual.values:
            for k, c in enumerate(series.coeffs()[:top + 1]):
                narrow = narrow and (arithmetic == "ball"
                                     or not c.rad() > _EXACT * max(sizes[k], least))
                if not c.contains(0):
                    bad.append(Defect(name, k, float(abs(c) / sizes[k])))
                    break
    return min(bad, key=lambda defect: defect.order, default=None), narrow


def _first_float(found: Mapping[str, AtPhases], tops: Sequence[int],
                 sizes: Sequence[Any]) -> Defect | None:
    sizes = [arb(size) for size in sizes]
    bad = [Defect(name, k, float(abs(c) / sizes[k]))
           for (name, residual), top in zip(found.items(), tops) for series in residual.values
           for k, c in enumerate(series.coeffs()[:top + 1])
           if not (c.is_finite() and not abs(c) > _FLOAT * sizes[k])]
    return min(bad, key=lambda defect: defect.order, default=None)


def _ball(number: Number, point: Sequence[arb]) -> arb:
    """A coefficient as a ball, the free parameters at ``point``."""
    if not hasattr(number, "context"):
        return arb(number)
    total = arb(0)
    for (_, *exponents), c in number.to_dict().items():
        term = arb(c)
        for value, exponent in zip(point, exponents):
            term *= value**exponent
        total += term
    return total
