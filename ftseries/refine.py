r"""Polish: from a truncated series to a periodic solution accurate to rounding.

Formula.  At a fixed λ the unknown Fourier coefficients c solve F(c) = 0, the modes of the problem's
own residual.  Newton's step J δ = -F is solved by least squares, because the equations may be
dependent (in the eight, S'' = 0 makes one redundant).  The columns of J come from complex steps,

.. math::  J_k = \mathrm{Im}\, F(c + i h e_k) / h, \qquad h = 10^{-30},

which have no cancellation.  More modes are taken until the last ones are negligible.
"""

import numpy as np

from .errors import SolveError
from .evaluation import fourier_sum
from .problem import Scalar
from .sampling import Sampled, Samples

__all__ = ["Orbit", "refine", "residuals"]

_STEP = 1e-30
_FIRST_MODES, _MOST_MODES = 48, 1024
_MORE_ROWS = 5                              # more equations than modes hold the last modes down
_MOST_STEPS = 30


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
    """

    def __init__(self, problem, lam, coefficients, residual, steps):
        self.problem, self.lam, self.coefficients = problem, lam, coefficients
        self.residual, self.steps = residual, steps

    def __repr__(self):
        return (f"<Orbit of {self.problem!r} at λ = {self.lam:.15g}, residual {self.residual:.1e}, "
                f"{self.steps} steps>")

    def evaluate(self, name, t=None, *, lam=None):
        """The value of an unknown at times t; ``lam`` is there for callers that pass it."""
        amplitude = self.coefficients[name]
        if isinstance(self.problem.unknowns[name], Scalar):
            return amplitude[0, 0]
        omega = (self.coefficients[self.problem.frequency][0, 0] if self.problem.frequency else 1.0)
        return fourier_sum(amplitude, omega * np.asarray(t, dtype=float))


class Collocation:
    """The residual's modes as a function of the free modes up to N and of λ."""

    def __init__(self, problem, top, parameters):
        self.problem, self.top, self.parameters = problem, top, parameters
        self.columns = [(name, *mode) for name, unknown in problem.unknowns.items()
                        for mode in unknown.columns(top)]
        self.points = 4 * top
        tau = Samples(self.points).tau
        n = np.arange(top + _MORE_ROWS)
        self.modes = [(sine, k) for sine in (0, 1) for k in n]
        cos, sin = np.cos(np.outer(n, tau)), np.sin(np.outer(n, tau))
        n = n[:, None]
        #: the modes on the grid, with their first and second derivatives: (3, modes, points)
        self.waves = np.stack([np.concatenate(pair) for pair in (
            (cos, sin), (-n * sin, n * cos), (-n**2 * cos, -n**2 * sin))])
        self.basis = {name: np.stack([self._wave(mode) * (name == own)
                                      for own, *mode in self.columns], axis=1)
                      for name in problem.unknowns}
        self.fixed = {name: [(m, c * self._wave(mode)) for m, mode, c in _fixed(problem, name)]
                      for name in problem.unknowns}

    def _wave(self, mode):
        return self.waves[:, self.modes.index(tuple(mode))]

    def unknowns(self, x, lam):
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

    def __call__(self, x, lam, condition=False):
        """F: the projections of the residuals on all modes, and the condition where asked."""
        parameter, unknowns = self.unknowns(x, lam)
        shape = x.shape[:-1] + (self.points,)
        values = [_product(np.broadcast_to(r.values, shape), self.waves[0].T) * (2 / self.points)
                  for r in self.problem.equations(parameter, **unknowns).values()]
        if condition:
            values.append(self.problem.condition(parameter, **unknowns).values.mean(
                axis=-1, keepdims=True))
        return np.concatenate(values, axis=-1)

    def newton(self, x, lam, condition):
        """(x, λ, steps) with steps of Newton's method until rounding stops them."""
        size, before = len(x) + condition, np.inf
        steps = 1j * _STEP * np.eye(size)
        for step in range(1, _MOST_STEPS + 1):
            trial = np.append(x, lam) if condition else x
            if before > 1e-2:                            # close by, the last matrix will do
                moved = trial + steps
                matrix = self(moved[:, :len(x)],
                              moved[:, -1] if condition else np.full(size, lam + 0j),
                              condition).imag.T / _STEP
                rows = np.abs(matrix).max(axis=1) > 1e-13 * np.abs(matrix).max()
                inverse = np.linalg.pinv(matrix[rows])
            delta = inverse @ -self(x, np.asarray(lam), condition)[rows]
            x = x + delta[:len(x)]
            lam = lam + delta[-1] if condition else lam
            change = np.abs(delta).max()
            if not np.isfinite(change) or (step > 6 and change > before > 1e-6):
                break
            if change < 1e-15 * np.abs(x).max() or (change < 1e-12 and change > before / 4):
                return x, float(lam), step
            before = change
        raise SolveError(f"Newton's method does not converge at λ = {float(lam):g}: the series is "
                         "too poor a first guess there; take a higher order or a smaller λ")


def _product(a, real):
    """a @ real, the real and imaginary part of a apart."""
    return a.real @ real + 1j * (a.imag @ real) if np.iscomplexobj(a) else a @ real


def _fixed(problem, name):
    """(m, mode, coefficient) of the modes that the seed gives completely."""
    return [(m, mode, float(c.p) / float(c.q))
            for m, row in enumerate(problem.first_coefficients()[name]) for mode, c in row.items()
            if problem.unknowns[name].is_fixed(mode)]


def refine(problem, first_guess, lam, condition=False, parameters=None):
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
    highest = max((n for modes in first_guess.values() for _, n in modes), default=0)
    top, total, guess = max(_FIRST_MODES, highest + 2), 0, first_guess
    while True:
        system = Collocation(problem, top, parameters)
        x = np.array([guess[name].get(tuple(mode), 0.0) for name, *mode in system.columns])
        x, lam, steps = system.newton(x, lam, condition)
        total += steps
        guess = {name: {} for name in problem.unknowns}
        for (name, *mode), value in zip(system.columns, x):
            guess[name][tuple(mode)] = value
        tail = max((abs(c) for modes in guess.values() for (_, n), c in modes.items()
                    if n > top - 4), default=0.0)
        if tail < 1e-15 * np.abs(x).max() or top >= _MOST_MODES:
            break
        top += top // 2
    for modes in guess.values():                        # rounding noise is not a mode
        for mode in [mode for mode, c in modes.items() if abs(c) < 1e-17 * np.abs(x).max()]:
            del modes[mode]
    for name in guess:
        guess[name] |= {mode: c * lam**m for m, mode, c in _fixed(problem, name)}
    return lam, guess, max(residuals(problem, guess, lam, parameters).values()), total


def residuals(problem, coefficients, lam, parameters=None):
    """The largest absolute residual of each equation on a grid, ``{equation: float}``.

    ``coefficients`` are ``{name: {(sine, n): float}}`` at ``lam``, in the solver's units.
    """
    top = max((n for modes in coefficients.values() for _, n in modes), default=0) + 1
    system = Collocation(problem, max(top, _FIRST_MODES // 2), parameters)
    x = np.array([coefficients[name].get(tuple(mode), 0.0) for name, *mode in system.columns])
    parameter, unknowns = system.unknowns(x, np.asarray(lam))
    return {name: float(np.abs(r.values).max())
            for name, r in problem.equations(parameter, **unknowns).items()}
