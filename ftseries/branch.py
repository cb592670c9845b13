r"""Branch points: complex λ at which two periodic solutions meet.

Formula.  Where two solutions of F(c, λ) = 0 meet, F's Jacobian J in the Fourier coefficients c is
singular.  So the branch point solves

.. math::  F(c, λ) = 0, \qquad J(c, λ)\, v = 0, \qquad \langle v_0, v \rangle = 1,

for c, λ and the direction v, here by Newton's method on the equations of
:mod:`ftseries.collocation`, at complex λ.  Near it c ≈ c_0 ± C v (λ_0 - λ)^{1/2}: the exponent is
1/2.  Nothing here uses Taylor coefficients but the first guess, so it tests their singularities.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .aliases import ComplexArray, Modes
from .collocation import Collocation
from .errors import SolveError

if TYPE_CHECKING:
    from .problem import Problem

__all__ = ["branch_point"]

_FIRST_MODES, _MOST_MODES = 40, 200
_STEPS, _ROUGH_STEPS = 8, 8
#: steps of the difference quotients along 1, i, -1, -i, whose errors are of fourth order
_STEP = 1e-3
_SHARP = 1e-9
#: a last step of λ beyond which Newton's method has lost its way
_LOST = 1e-2


def branch_point(problem: Problem, guess: dict[str, Modes], slope: dict[str, Modes], lam: complex,
                 parameters: dict[str, float] | None = None) -> tuple[complex, float]:
    """The complex λ near ``lam`` where two solutions meet, and its uncertainty.

    Parameters
    ----------
    problem : Problem
    guess, slope : dict
        ``{name: {(sine, n): complex}}``: a solution near ``lam``, and its change along λ.
    lam : complex
        In the solver's units, as all of this.
    parameters : dict, optional

    Returns
    -------
    tuple
        (λ, error), the error from a change of the number of modes.

    Raises
    ------
    SolveError
        No such place close by: the nearest singularity is of another kind.
    """
    start, top = lam, _FIRST_MODES
    before: complex | None = None
    while True:
        system = Collocation(problem, top, parameters)
        x, v = (np.array([part[name].get((sine, n), 0) for name, sine, n in system.columns],
                         dtype=np.complex128) for part in (guess, slope))
        last = top >= _MOST_MODES
        x, v, lam, change = _newton(system, x, v, lam, _STEPS if before is not None
                                    else _ROUGH_STEPS)
        if not np.isfinite(lam) or abs(lam - start) > 0.2 * abs(start):
            break
        if before is not None and change < _SHARP and abs(lam - before) < 1e3 * _SHARP:
            return lam, max(abs(lam - before), change, 1e-12)
        if last or change > _LOST:
            break
        before, top = lam, min(_MOST_MODES, top + top // 2)
        guess, slope = ({name: {(sine, n): value for (own, sine, n), value
                                in zip(system.columns, part) if own == name}
                         for name in problem.unknowns} for part in (x, v))
    raise SolveError(f"no two solutions meet near λ = {start:.3g}: the nearest singularity is of "
                     "another kind, or the series is too poor a first guess")


def _newton(system: Collocation, x: ComplexArray, v: ComplexArray, lam: complex,
            steps: int) -> tuple[ComplexArray, ComplexArray, complex, float]:
    """(x, v, λ, last change) after Newton's method on the extended equations."""
    size, normal = len(x), v.conj() / np.linalg.norm(v)
    v = v / (normal @ v)
    for _ in range(steps):
        residual, jacobian = system(x, np.asarray(lam)), _jacobian(system, x, lam)
        turn = (_jacobian(system, x + _STEP * v, lam)
                - _jacobian(system, x - _STEP * v, lam)) / (2 * _STEP)
        rows = len(residual)
        matrix = np.zeros((2 * rows + 1, 2 * size + 1), dtype=complex)
        matrix[:rows, :size], matrix[:rows, -1] = jacobian[:, :size], jacobian[:, -1]
        matrix[rows:-1, :size], matrix[rows:-1, -1] = turn[:, :size], turn[:, -1]
        matrix[rows:-1, size:-1], matrix[-1, size:-1] = jacobian[:, :size], normal
        right = np.concatenate([residual, jacobian[:, :size] @ v, [normal @ v - 1]])
        if not np.isfinite(matrix).all() or not np.isfinite(right).all():
            return x, v, np.nan, np.inf
        delta = np.linalg.lstsq(matrix, -right, rcond=1e-13)[0]
        x, v, lam = x + delta[:size], v + delta[size:-1], lam + delta[-1]
        if np.abs(delta).max() < 1e-12:
            break
    return x, v, complex(lam), float(abs(delta[-1]))


def _jacobian(system: Collocation, x: ComplexArray, lam: complex) -> ComplexArray:
    """The derivatives of F in every coefficient and in λ, as columns."""
    point, directions = np.append(x, lam), 1j ** np.arange(4)
    columns = []
    for direction in directions:
        moved = point + _STEP * direction * np.eye(len(point))
        columns.append(system(moved[:, :-1], moved[:, -1]) / direction)
    total: ComplexArray = np.sum(columns, axis=0)
    return total.T / (4 * _STEP)
