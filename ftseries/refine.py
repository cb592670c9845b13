r"""Polish: from a truncated series to a periodic solution accurate to rounding.

Formula.  At a fixed λ the unknown Fourier coefficients c solve F(c) = 0, the modes of the problem's
own residual.  Newton's step J δ = -F is solved by least squares, because the equations may be
dependent (in the eight, S'' = 0 makes one redundant).  The columns of J come from complex steps,

.. math::  J_k = \mathrm{Im}\, F(c + i h e_k) / h, \qquad h = 10^{-30},

which have no cancellation.  It begins with few modes, whose decay says how many are needed for the
last ones to be negligible.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .aliases import Array, ArrayLike, Mode, Modes, Real
from .arguments import real, scalar
from .errors import InputError, SolveError
from .evaluation import motion, times
from .problem import Scalar
from .sampling import Sampled, Samples

if TYPE_CHECKING:
    from .problem import Problem

__all__ = ["Orbit", "refine", "residuals"]

_STEP = 1e-30
_FIRST_MODES, _MOST_MODES = 24, 1024
_MARGIN = 8
_NEGLIGIBLE, _NOISE = 1e-15, 1e-17          # of a mode, against the largest one
_MORE_ROWS = 5                              # more equations than modes hold the last modes down
_MOST_STEPS = 30
#: what may be left of F, in modes beyond those known, against the largest terms of J c
_REST = 1e-3


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

    def evaluate(self, name: str, t: ArrayLike | None = None, *, lam: Any = None,
                 derivative: int = 0) -> Real:
        """The value of an unknown, or a derivative in t, as :meth:`ftseries.Solution.evaluate`.

        ``lam`` is there for callers that pass it.

        >>> import ftseries as fts
        >>> orbit = fts.solve(fts.CubicOscillator(a=1), order=12).refine(0.5)
        >>> abs(orbit.evaluate("x", 0, derivative=1)) < 1e-12              # at rest at t = 0
        True
        """
        t = real("t", times(self.problem, name, t, derivative))
        amplitude = self.coefficients[name]
        if isinstance(self.problem.unknowns[name], Scalar):
            return float(amplitude[0, 0])
        omega = self.coefficients[self.problem.frequency][0, 0] if self.problem.frequency else 1.0
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
        problem, condition = problem or self.problem, lam is None
        if problem.unknowns.keys() != self.problem.unknowns.keys():
            raise InputError(f"{problem!r} has the unknowns {', '.join(problem.unknowns)}, but "
                             f"this is an orbit with {', '.join(self.problem.unknowns)}; give a "
                             "problem with the same unknowns")
        units = {name: float(problem.scale(name)) for name in problem.unknowns}
        unit = float(problem.lam_scale)
        old = {name: float(self.problem.scale(name)) for name in self.problem.unknowns}
        guess = {name: {mode: c / old[name] for mode, c in modes.items()}
                 for name, modes in self.coefficients.items()}
        start = scalar("lam", self.lam if condition else lam)
        found, modes, residual, steps = refine(problem, guess, start / unit, condition,
                                               self.parameters)
        modes = {name: {mode: units[name] * c for mode, c in row.items()}
                 for name, row in modes.items()}
        return Orbit(problem, found * unit, modes, residual, steps, self.parameters)


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
        self.fixed = {name: [(m, c * self._wave(mode)) for m, mode, c in _fixed(problem, name)]
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

    def residuals(self, x: Array, lam: float) -> dict[str, float]:
        """The largest absolute residual of each equation on the grid."""
        parameter, unknowns = self.unknowns(x, np.asarray(lam))
        return {name: float(np.abs(r.values).max())
                for name, r in self.problem.residuals(parameter, unknowns).items()}

    @np.errstate(over="ignore", invalid="ignore")                # what is not finite is refused
    def newton(self, x: Array, lam: float, condition: bool) -> tuple[Array, float, int]:
        """(x, λ, steps) with steps of Newton's method until rounding stops them."""
        start, size, before = lam, len(x) + condition, np.inf
        steps = 1j * _STEP * np.eye(size)
        for step in range(1, _MOST_STEPS + 1):
            trial = np.append(x, lam) if condition else x
            if before > 1e-2:                            # close by, the last matrix will do
                moved = trial + steps
                matrix = self(moved[:, :len(x)],
                              moved[:, -1] if condition else np.full(size, lam + 0j),
                              condition).imag.T / _STEP
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
            if change < 1e-15 * np.abs(x).max() or (change < 1e-10 and change > before / 4):
                rest = np.abs(self(x, np.asarray(lam), condition)).max()
                if rest <= _REST * (np.abs(matrix) @ np.abs(trial)).max():
                    return x, float(lam), step
                break
            before = change
        raise SolveError(f"Newton's method does not converge at λ = {start:g}: the series is too "
                         "poor a first guess there; take a higher order or a smaller λ")


def _product(a: NDArray[Any], real: Array) -> NDArray[Any]:
    """a @ real, the real and imaginary part of a apart."""
    return a.real @ real + 1j * (a.imag @ real) if np.iscomplexobj(a) else a @ real


def _fixed(problem: Problem, name: str) -> list[tuple[int, Mode, float]]:
    """(m, mode, coefficient) of the modes that the seed gives completely."""
    return [(m, mode, float(c.p) / float(c.q))
            for m, row in enumerate(problem.first_coefficients()[name]) for mode, c in row.items()
            if problem.unknowns[name].is_fixed(mode)]


def refine(problem: Problem, first_guess: dict[str, Modes], lam: float, condition: bool = False,
           parameters: Mapping[str, float] | None = None
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

    Returns
    -------
    tuple
        (λ, coefficients, residual, steps), all in the solver's units.
    """
    total, guess = 0, first_guess
    top = max(_FIRST_MODES, _last(_sizes(guess), _NOISE) + 2)
    while True:
        system = Collocation(problem, top, parameters)
        x, lam, steps = system.newton(system.vector(guess), lam, condition)
        total += steps
        guess = {name: {} for name in problem.unknowns}
        for (name, sine, n), value in zip(system.columns, x):
            guess[name][sine, n] = float(value)
        sizes = _sizes(guess)
        if _last(sizes, _NEGLIGIBLE) <= top - 4 or top >= _MOST_MODES:
            break
        top = _more(sizes)
    for modes in guess.values():                        # rounding noise is not a mode
        for mode in [mode for mode, c in modes.items() if abs(c) < _NOISE * sizes.max()]:
            del modes[mode]
    for name in guess:
        guess[name] |= {mode: c * lam**m for m, mode, c in _fixed(problem, name)}
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


def _more(sizes: Array) -> int:
    """How many modes are needed, if they go on to decay as in the upper half of those known."""
    top = len(sizes) - 1
    middle, tail = (sizes[end - 5:end + 1].max() for end in (top // 2, top))
    decay = 2 * math.log(max(middle / tail, 1 + 1e-9)) / top
    more = math.log(tail / (_NEGLIGIBLE * sizes.max())) / decay
    return min(_MOST_MODES, top + math.ceil(min(more, 2 * top)) + _MARGIN)


def residuals(problem: Problem, coefficients: dict[str, Modes], lam: float,
              parameters: Mapping[str, float] | None = None) -> dict[str, float]:
    """The largest absolute residual of each equation on a grid, ``{equation: float}``.

    ``coefficients`` are ``{name: {(sine, n): float}}`` at ``lam``, in the solver's units.
    """
    top = max((n for modes in coefficients.values() for _, n in modes), default=0) + 1
    system = Collocation(problem, max(top, _FIRST_MODES), parameters)
    return system.residuals(system.vector(coefficients), lam)
