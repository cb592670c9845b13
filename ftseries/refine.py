"""Polish: from a truncated series to a periodic solution accurate to rounding.

At a fixed λ the Fourier coefficients are found by Newton's method on the equations of
:mod:`ftseries.collocation`.  It begins with few modes, whose decay says how many are needed for the
last ones to be negligible.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from .aliases import Array, ArrayLike, Modes, Real
from .arguments import real, scalar
from .collocation import Collocation, fixed_modes
from .conversion import float_unit
from .errors import InputError, SolveError
from .evaluation import check_lam, motion, times
from .problem import Scalar

if TYPE_CHECKING:
    from .problem import Problem

__all__ = ["Orbit", "Unresolved", "refine", "residuals"]

_FIRST_MODES, _MOST_MODES, _MOST_ROUGH = 24, 1024, 120
_MARGIN = 8
_NEGLIGIBLE, _ROUGH = 1e-15, 1e-7           # of the last modes, against the largest one
_UNRESOLVED = 1e-6                          # of the last ones, where there are very many
_REST = 1e-3                                # of F, against its terms: an orbit leaves rounding


class Unresolved(SolveError):
    """A solution with too many modes."""


class Orbit:
    """One periodic solution at a number λ; it evaluates like a solution.

    Attributes
    ----------
    lam : float
        The value of λ, solved for when the problem's condition was asked.
    coefficients : dict
        ``{name: {(sine, n): float}}`` in the paper's units.
    residual : float
        The largest absolute value of the residuals on the grid, in the solver's units.
    steps : int
        Newton steps taken.
    parameters : dict
        Values of the problem's free parameters.
    """

    def __init__(self, problem: Problem, lam: float, coefficients: dict[str, Modes],
                 residual: float = np.nan, steps: int = 0,
                 parameters: Mapping[str, float] | None = None) -> None:
        self.problem, self.lam, self.coefficients = problem, lam, coefficients
        self.parameters, self.residual, self.steps = parameters or {}, residual, steps

    def __repr__(self) -> str:
        return (f"<Orbit of {self.problem!r} at λ = {self.lam:.15g}, residual {self.residual:.1e}, "
                f"{self.steps} steps>")

    def evaluate(self, name: str, t: ArrayLike | None = None, *positional: Any, lam: Any = None,
                 derivative: int = 0) -> Real:
        """The value of an unknown, or a derivative in t, as :meth:`ftseries.Solution.evaluate`.

        ``lam`` may be given as to a solution, but an orbit has only its own.

        >>> import ftseries as fts
        >>> orbit = fts.solve(fts.CubicOscillator(a=1), order=12).refine(0.5)
        >>> abs(orbit.evaluate("x", 0, derivative=1)) < 1e-12              # at rest at t = 0
        True
        """
        check_lam(self.problem, name, t, positional, self.lam)
        if lam is not None and not np.allclose(real("lam", lam), self.lam, rtol=1e-12, atol=0):
            raise InputError(f"lam={lam!r}: this orbit has λ = {self.lam!r}; refine the series at "
                             "another λ for another orbit")
        t = real("t", times(self.problem, name, t, derivative))
        amplitude = self.coefficients[name]
        if isinstance(self.problem.unknowns[name], Scalar):
            return float(amplitude.get((0, 0), 0.0))
        frequency = self.problem.frequency
        omega = self.coefficients[frequency].get((0, 0), 0.0) if frequency else 1.0
        value = motion(amplitude, t, omega, derivative)
        return value if np.ndim(value) else float(value)

    def refine(self, problem: Problem | None = None, lam: float | None = None) -> Orbit:
        """The periodic solution next to this one, by Newton's method.

        Parameters
        ----------
        problem : Problem, optional
            A neighbouring problem with the same unknowns, to follow a family; left out, the same.
        lam : float, optional
            λ; left out, it is solved for from the problem's condition.

        Returns
        -------
        Orbit

        Examples
        --------
        From gravitation to the logarithmic potential:

        >>> import ftseries as fts
        >>> orbit = fts.solve(fts.FigureEight(), order=6).refine()
        >>> round(orbit.refine(fts.FigureEight(exponent=0)).lam, 12)
        2.038129972545
        """
        return self._refined(problem or self.problem, lam, _NEGLIGIBLE)

    def rough(self, lam: float) -> Orbit:
        """The same problem's solution at λ to some digits, as a step towards another."""
        return self._refined(self.problem, lam, _ROUGH)

    def _refined(self, problem: Problem, lam: float | None, negligible: float) -> Orbit:
        condition = lam is None
        if problem.unknowns.keys() != self.problem.unknowns.keys():
            raise InputError(f"{problem!r} has the unknowns {', '.join(problem.unknowns)}, but "
                             f"this is an orbit with {', '.join(self.problem.unknowns)}; give a "
                             "problem with the same unknowns")
        units, old = ({name: float_unit(each, each.scale(name)) for name in each.unknowns}
                      for each in (problem, self.problem))
        unit = float_unit(problem, problem.lam_scale)
        guess = {name: {mode: c / old[name] for mode, c in modes.items()}
                 for name, modes in self.coefficients.items()}
        start = scalar("lam", self.lam if condition else lam)
        found, modes, residual, steps = refine(problem, guess, start / unit, condition,
                                               self.parameters, negligible)
        modes = {name: {mode: units[name] * c for mode, c in row.items()}
                 for name, row in modes.items()}
        return Orbit(problem, found * unit, modes, residual, steps, self.parameters)


def refine(problem: Problem, first_guess: dict[str, Modes], lam: float, condition: bool = False,
           parameters: Mapping[str, float] | None = None, negligible: float = _NEGLIGIBLE
           ) -> tuple[float, dict[str, Modes], float, int]:
    """Newton's method from a truncated series.

    Parameters
    ----------
    problem : Problem
    first_guess : dict
        ``{name: {(sine, n): float}}`` in the solver's units.
    lam : float
        λ in the solver's units.
    condition : bool
        Solve for λ as well, so that the problem's ``condition`` has mean zero.
    parameters : dict, optional
        Values of free parameters.
    negligible : float
        What the last modes may be, against the largest one.

    Returns
    -------
    tuple
        (λ, coefficients, residual, steps), all in the solver's units.
    """
    total, guess, start = 0, first_guess, lam
    noise, most = negligible / 100, _MOST_MODES if negligible < _ROUGH else _MOST_ROUGH
    top = min(most, max(_FIRST_MODES, _last(_sizes(guess), noise) + 2))
    while True:
        system = Collocation(problem, top, parameters)
        x, lam, steps, rest = system.newton(system.vector(guess), lam, condition)
        total += steps
        guess = {name: {} for name in problem.unknowns}
        for (name, sine, n), value in zip(system.columns, x):
            guess[name][sine, n] = float(value)
        sizes = _sizes(guess)
        if _last(sizes, negligible) <= top - 4 or top >= most:
            break
        top = min(most, _more(sizes, negligible))
    if _last(sizes, _UNRESOLVED) > top - 4:
        raise Unresolved(f"at λ = {start:g} the solution has more than {top} modes: it is close to "
                         "a collision or to the end of its family; take another λ")
    if not rest < _REST:
        raise SolveError(f"no periodic solution was found at λ = {start:g}: the series is too poor "
                         "a first guess there; take a higher order or a smaller λ")
    for modes in guess.values():                        # rounding noise is not a mode
        for mode in [mode for mode, c in modes.items() if abs(c) < noise * sizes.max()]:
            del modes[mode]
    for name in guess:
        guess[name] |= {mode: c * lam**m for m, mode, c in fixed_modes(problem, name)}
    return lam, guess, max(system.residuals(x, lam).values()), total


def _sizes(guess: Mapping[str, Modes]) -> Array:
    """The largest coefficient of each Fourier order, over all unknowns."""
    sizes = np.zeros(1 + max((n for modes in guess.values() for _, n in modes), default=0))
    for modes in guess.values():
        for (_, n), c in modes.items():
            sizes[n] = max(sizes[n], abs(c))
    return sizes


def _last(sizes: Array, small: float) -> int:
    """The last Fourier order that is not ``small`` against the largest one."""
    return int(max(np.flatnonzero(sizes > small * sizes.max()), default=0))


def _more(sizes: Array, negligible: float) -> int:
    """How many modes are needed, if they go on to decay as in the upper half of those known."""
    top = len(sizes) - 1
    middle, tail = (sizes[end - 5:end + 1].max() for end in (top // 2, top))
    decay = 2 * math.log(max(middle / tail, 1 + 1e-9)) / top
    more = math.log(tail / (negligible * sizes.max())) / decay
    return min(_MOST_MODES, top + math.ceil(min(more, 2 * top)) + _MARGIN)


def residuals(problem: Problem, coefficients: dict[str, Modes], lam: float,
              parameters: Mapping[str, float] | None = None) -> dict[str, float]:
    """The largest absolute residual of each equation on a grid, ``{equation: float}``.

    ``coefficients`` are ``{name: {(sine, n): float}}`` at ``lam``, in the solver's units.
    """
    top = max((n for modes in coefficients.values() for _, n in modes), default=0) + 1
    system = Collocation(problem, max(top, _FIRST_MODES), parameters)
    return system.residuals(system.vector(coefficients), lam)
