r"""A problem at a number λ as a system of equations for its Fourier coefficients.

Formula.  The unknown Fourier coefficients c solve F(c) = 0, the modes of the problem's own
residual.  Newton's step J δ = -F is solved by least squares, because the equations may be dependent
(in the eight, S'' = 0 makes one redundant).  The columns of J come from complex steps,

.. math::  J_k = \mathrm{Im}\, F(c + i h e_k) / h, \qquad h = 10^{-30},

which have no cancellation.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .aliases import Array, Mode, Modes
from .errors import SolveError
from .sampling import Sampled, Samples

if TYPE_CHECKING:
    from .problem import Problem

__all__ = ["Collocation", "fixed_modes"]

_STEP = 1e-30
_MORE_ROWS = 5                              # more equations than modes hold the last modes down
_MOST_STEPS = 30
#: a step, against the largest unknown, below which it is rounding that stops Newton's method, and
#: one that an unknown may make which is zero but for rounding
_STALLED, _ROUNDING = 1e-8, 1e-14


class Collocation:
    """The residual's modes as a function of the free modes up to N and of λ."""

    def __init__(self, problem: Problem, top: int, parameters: Mapping[str, float] | None) -> None:
        self.problem, self.top, self.parameters = problem, top, parameters
        self.columns = [(name, *mode) for name, unknown in problem.unknowns.items()
                        for mode in unknown.columns(top)]
        self.points = 4 * top
        tau = Samples(self.points).tau
        self.modes = [(sine, k) for sine in (0, 1) for k in range(top + _MORE_ROWS)]
        n = np.arange(top + _MORE_ROWS)[:, None]
        cos, sin = np.cos(n * tau), np.sin(n * tau)
        #: the modes on the grid, with their first and second derivatives: (3, modes, points)
        self.waves = np.stack([np.concatenate(pair) for pair in (
            (cos, sin), (-n * sin, n * cos), (-n**2 * cos, -n**2 * sin))])
        self.basis = {name: np.stack([self._wave((sine, k)) * (name == own)
                                      for own, sine, k in self.columns], axis=1)
                      for name in problem.unknowns}
        self.fixed = {name: [(m, c * self._wave(mode)) for m, mode, c in fixed_modes(problem, name)]
                      for name in problem.unknowns}

    def _wave(self, mode: Mode) -> NDArray[Any]:
        return self.waves[:, self.modes.index(mode)]

    def unknowns(self, x: NDArray[Any], lam: NDArray[Any]) -> tuple[Sampled, dict[str, Sampled]]:
        """The unknowns on the grid, for x of shape (…, columns) and λ of shape (…)."""
        samples = Samples(self.points, lam, self.parameters)
        result = {}
        for name in self.problem.unknowns:
            values = []
            for i, basis in enumerate(self.basis[name]):
                total = _product(x, basis)
                for m, wave in self.fixed[name]:
                    total = total + lam[..., None]**m * wave[i]
                values.append(total)
            result[name] = Sampled(samples, values[0], values[1:])
        return samples.lam, result

    def __call__(self, x: NDArray[Any], lam: NDArray[Any], condition: bool = False) -> NDArray[Any]:
        """F: the projections of the residuals on all modes, and the condition where asked."""
        parameter, unknowns = self.unknowns(x, lam)
        shape = x.shape[:-1] + (self.points,)
        values = [_product(np.broadcast_to(r.values, shape), self.waves[0].T) * (2 / self.points)
                  for r in self.problem.residuals(parameter, unknowns).values()]
        if condition:
            values.append(self.problem.condition(parameter, **unknowns).values.mean(
                axis=-1, keepdims=True))
        return np.concatenate(values, axis=-1)

    def vector(self, coefficients: Mapping[str, Modes]) -> Array:
        """The free modes, in the order of the columns."""
        return np.array([coefficients[name].get((sine, n), 0.0) for name, sine, n in self.columns])

    def _matrix(self, x: Array, lam: float, condition: bool) -> Array:
        """The derivatives of F, by an imaginary step; λ is the last unknown with the condition."""
        moved = x + 1j * _STEP * np.eye(len(x))
        at = moved[:, -1] if condition else np.full(len(x), lam + 0j)
        matrix: Array = self(moved[:, :-1] if condition else moved, at, condition).imag.T / _STEP
        return matrix

    def _steady(self, x: Array, delta: Array) -> bool:
        """Whether every unknown has nearly stopped to change, not only the largest one."""
        names = np.array([name for name, *_ in self.columns])
        least = _ROUNDING * np.abs(x).max()
        return all(np.abs(delta[:len(x)][names == name]).max()
                   <= 1e-6 * np.abs(x[names == name]).max() + least for name in set(names))

    def residuals(self, x: Array, lam: float) -> dict[str, float]:
        """The largest absolute residual of each equation on the grid."""
        parameter, unknowns = self.unknowns(x, np.asarray(lam))
        return {name: float(np.abs(r.values).max())
                for name, r in self.problem.residuals(parameter, unknowns).items()}

    @np.errstate(over="ignore", invalid="ignore")                # what is not finite is refused
    def newton(self, x: Array, lam: float, condition: bool) -> tuple[Array, float, int, float]:
        """(x, λ, steps, rest) by Newton's method, until rounding stops it.

        The rest is what F keeps, against the terms of F: with too few modes it need not be small.
        """
        start, before = lam, np.inf
        for step in range(1, _MOST_STEPS + 1):
            trial = np.append(x, lam) if condition else x
            if before > 1e-2:                            # close by, the last matrix will do
                matrix = self._matrix(trial, lam, condition)
                if not np.isfinite(matrix).all():
                    break
                rows = np.abs(matrix).max(axis=1) > 1e-13 * np.abs(matrix).max()
                inverse = np.linalg.pinv(matrix[rows])
            delta = inverse @ -self(x, np.asarray(lam), condition)[rows]
            x = x + delta[:len(x)]
            lam = lam + delta[-1] if condition else lam
            change = np.abs(delta).max()
            if not np.isfinite(change) or (step > 6 and change > before > 1e-6):
                break
            largest = np.abs(x).max(initial=0.0)
            if change <= 1e-15 * largest or (change < _STALLED * largest and change > before / 4):
                if not self._steady(x, delta):
                    break
                rest = np.abs(self(x, np.asarray(lam), condition)).max()
                end = np.append(x, lam) if condition else x
                terms = (np.abs(self._matrix(end, lam, condition)) @ np.abs(end)).max()
                return x, float(lam), step, float(rest / terms if terms else rest)
            before = change
        raise SolveError(f"Newton's method does not converge at λ = {start:g}: the series is too "
                         "poor a first guess there; take a higher order or a smaller λ")


def _product(a: NDArray[Any], real: Array) -> NDArray[Any]:
    """a @ real, the real and imaginary part of a apart."""
    return a.real @ real + 1j * (a.imag @ real) if np.iscomplexobj(a) else a @ real


def fixed_modes(problem: Problem, name: str) -> list[tuple[int, Mode, float]]:
    """(m, mode, coefficient) of the modes that the seed gives completely."""
    return [(m, mode, float(c.p) / float(c.q))
            for m, row in enumerate(problem.first_coefficients()[name]) for mode, c in row.items()
            if problem.unknowns[name].is_fixed(mode)]
