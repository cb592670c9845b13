r"""A solution summed by Padé approximants instead of truncated.

Formula.  Mode n of an unknown is Λ^first Σ_k c_k z^k with z = Λ^step (see
:meth:`ftseries.Solution.sequence`); the sum is replaced by its diagonal Padé approximant in z.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import arb, ctx

from .aliases import ArrayLike, Column, Mode, Real
from .analysis import Estimate, pade
from .arguments import real, scalar, scalars
from .conversion import float_unit, to_ball
from .errors import InputError
from .evaluation import SMALL, check_lam, motion, times, unknown, warn
from .problem import Scalar

if TYPE_CHECKING:
    from .analysis import Pade
    from .quality import Quality
    from .solution import Solution

__all__ = ["Resummed", "at_phase", "uncertainty"]

#: coefficients of a mode that are used when they are floats: more would fit their rounding
_FLOAT_TERMS = 100
#: which sums are compared: (i, j) are i and j coefficients short
_PAIRS = ((0, 1), (0, 2), (2, 3), (2, 4))


class Resummed:
    """Padé approximants of all modes; evaluates like the solution they come from.

    Attributes
    ----------
    problem : Problem
    order : int
        The Taylor order of the coefficients used.
    """

    def __init__(self, solution: Quality, parameters: Mapping[str, float], drop: int = 0) -> None:
        self.solution, self.parameters, self.drop = solution, parameters, drop
        self.problem, self.order = solution.problem, solution.order
        self._modes: dict[str, dict[Mode, tuple[int, int, Pade]]] = {}
        self._fewer: Resummed | None = None

    def __repr__(self) -> str:
        return f"<Padé sum of {self.solution!r}>"

    def approximants(self, name: str) -> dict[Mode, tuple[int, int, Pade]]:
        """``{(sine, n): (step, first, Pade)}`` of one unknown."""
        if name not in self._modes:
            unknown(self.problem, name)
            found = {mode for row in self.solution.coefficients[name] for mode in row}
            self._modes[name] = {}
            for sine, n in sorted(found, key=lambda mode: mode[::-1]):
                step, first, c = self.solution.sequence(name, n, bool(sine), **self.parameters)
                if any(isinstance(x, float) for x in c):
                    c = c[:_FLOAT_TERMS]
                c = c[:max(len(c) - self.drop, 1)]
                self._modes[name][sine, n] = step, first, pade(c)
        return self._modes[name]

    def fewer(self) -> Resummed:
        """The same with one coefficient less in each mode, to compare with."""
        if self._fewer is None:
            self._fewer = Resummed(self.solution, self.parameters, self.drop + 1)
        return self._fewer

    def defects(self) -> dict[Column, list[complex]]:
        """``{(name, sine, n): poles in z}`` of the approximants with spurious pole-zero pairs."""
        return {(name, *mode): spurious for name in self.problem.unknowns
                for mode, (_, _, approximant) in self.approximants(name).items()
                if (spurious := approximant.defects())}

    def amplitudes(self, name: str, lam: ArrayLike) -> dict[Mode, Real]:
        """``{(sine, n): A_n(λ)}`` in the paper's units."""
        lam = real("lam", lam) / float_unit(self.problem, self.problem.lam_scale)
        unit = float_unit(self.problem, self.problem.scale(name))
        return {mode: unit * lam**first * approximant(lam**step)
                for mode, (step, first, approximant) in self.approximants(name).items()}

    def evaluate(self, name: str, t: ArrayLike | None = None, *positional: Any,
                 lam: Any = None, derivative: int = 0) -> Real:
        """The value of an unknown, or a derivative in t, as :meth:`ftseries.Solution.evaluate`.

        Warns
        -----
        ConvergenceWarning
            The truncated series is no approximation at λ, and :meth:`error` is not small either.
        """
        check_lam(self.problem, name, t, positional, lam)
        t = real("t", times(self.problem, name, t, derivative))
        sums = {which: self.amplitudes(which, lam) for which in self.solution._summed(name)}
        self._refuse_poles(name, sums[name], lam)
        if self.solution._doubt(name, lam, tuple(scalars(self.parameters).items())):
            for which, amplitude in sums.items():
                self._doubt(which, amplitude, lam)
        amplitude, *frequency = sums.values()
        if isinstance(self.problem.unknowns[name], Scalar):
            value = amplitude[0, 0]
        else:
            omega = frequency[0][0, 0] if frequency else 1.0
            value = motion(amplitude, t + 0 * real("lam", lam), omega, derivative)
        return value if np.ndim(value) else float(value)

    def _doubt(self, name: str, amplitude: Mapping[Mode, Real], lam: ArrayLike) -> None:
        """Warn where the error of the sum is not small."""
        error, size = self.error(name, lam), sum(map(np.abs, amplitude.values()))
        if np.any(error > SMALL * size):
            worst = np.argmax(error - SMALL * size)
            at, error, size = (np.ravel(a)[worst] for a in (real("lam", lam), error, size))
            warn(f"the Padé sum of {name!r} is not determined at λ = {at:g}: its error() there is "
                 f"{error:.2g}, its size {size:.2g}; take a higher order or a smaller λ")

    def error(self, name: str, lam: ArrayLike) -> Real:
        """Σ_n of the uncertainty of A_n(λ): an estimate, not a bound; see :func:`uncertainty`.

        Near a pole of an approximant it is large.
        """
        sums = [padé.amplitudes(name, lam) for padé in self._poorer()]
        self._refuse_poles(name, sums[0], lam)
        changes = [sum(abs(a - other[mode]) for mode, a in first.items())
                   for first, other in ((sums[i], sums[j]) for i, j in _PAIRS)]
        error = uncertainty(*changes)
        return error if np.ndim(error) else float(error)

    def estimate(self, quantity: Callable[[Resummed], float]) -> Estimate:
        """``quantity`` of this sum with its uncertainty.

        Parameters
        ----------
        quantity : callable
            Takes a sum such as this one and returns a float.

        Returns
        -------
        Estimate
            Its error is an estimate, not a bound; see :func:`uncertainty`.

        Examples
        --------
        The physical λ of the figure eight, where S = 0:

        >>> import ftseries as fts
        >>> padé = fts.solve(fts.FigureEight(), order=40).resum()
        >>> lam = padé.estimate(fts.figure_eight.closure_zero)
        >>> abs(lam.value - 2.0756839088491) < lam.error < 1e-2
        True
        """
        values = [float(quantity(padé)) for padé in self._poorer()]
        return Estimate(values[0], float(uncertainty(*(abs(values[i] - values[j])
                                                       for i, j in _PAIRS))))

    def _poorer(self) -> list[Resummed]:
        """This sum and those with one to four coefficients less in each mode."""
        sums = [self]
        for _ in range(4):
            sums.append(sums[-1].fewer())
        return sums

    def _refuse_poles(self, name: str, amplitude: Mapping[Mode, Real], lam: ArrayLike) -> None:
        if not all(np.isfinite(a).all() for a in amplitude.values()):
            raise InputError(f"λ = {lam!r} is a pole of a Padé approximant of {name!r}; change λ "
                             "or the order")


def uncertainty(first: Real, second: Real, third: Real, fourth: Real) -> Real:
    """An error from four changes of a sum: the last two coefficients, and the two before them.

    If the changes c, c' fall geometrically, by r = c/c', what is left out is c r/(1 - r); the error
    is that or c, whichever is larger.

    >>> uncertainty(1e-3, 1e-3, 4e-3, 2e-3), round(uncertainty(9e-3, 9e-3, 1e-2, 1e-2), 3)
    (np.float64(0.001), np.float64(0.081))
    """
    last, before = np.maximum(first, second), np.maximum(third, fourth)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.clip(np.nan_to_num(last / before), 0, 0.95)
    return last * np.maximum(1, ratio / (1 - ratio))


def at_phase(solution: Solution, name: str, tau: float, slope: bool = False) -> list[arb]:
    """The Taylor coefficients in λ of u(τ; λ) at one phase τ, as balls.

    Mode n of a solution begins at λ^n, so that high modes have few coefficients, and their Padé
    approximants are poor.  At a fixed phase all orders are there; see
    :func:`ftseries.analysis.pade`.

    Parameters
    ----------
    solution : Solution
        Of a problem without free parameters.
    name : str
        A field.
    tau : float
    slope : bool
        Of ∂u/∂τ instead.

    Examples
    --------
    >>> import ftseries as fts
    >>> sol = fts.solve(fts.CubicOscillator(a=1), order=2)
    >>> [float(c) for c in at_phase(sol, "x", 0.0)] == [
    ...     sum(float(sol.coefficient("x", n, m)) for n in range(m + 1)) for m in range(3)]
    True
    """
    if solution.problem.parameters:
        raise InputError(f"{solution.problem!r} has free parameters; give them values")
    if isinstance(unknown(solution.problem, name), Scalar):
        raise InputError(f"{name!r} does not depend on the phase; ask for a field")
    with ctx.workprec(solution.precision or 256):
        phase, series = arb(scalar("tau", tau)), []
        for m, row in enumerate(solution.coefficients[name]):
            total = arb(0)
            for (sine, n), number in row.items():
                wave = (n * phase).sin() if sine != slope else (n * phase).cos()
                total += arb(number) * wave * ((1 if sine else -1) * n if slope else 1)
            series.append(total * to_ball(solution.problem.unit(name, m)))
        return series
