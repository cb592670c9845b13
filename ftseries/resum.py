r"""A solution summed by Padé approximants instead of truncated.

Formula.  Mode n of an unknown is Λ^first Σ_k c_k z^k with z = Λ^step (see
:meth:`ftseries.Solution.sequence`); the sum is replaced by its diagonal Padé approximant in z.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import arb

from .aliases import Array, ArrayLike, Column, Mode, Number, Real
from .analysis import Estimate, pade
from .arguments import real, scalar, scalars
from .conversion import float_unit, to_ball
from .errors import InputError, PrecisionWarning
from .evaluation import check_lam, motion, times, unknown, warn
from .precision import working
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
#: an error beyond this part of the sum is warned of
_SMALL = 0.01
#: an error is never below this part of the terms: rounding of floats
_ROUNDING = 2.0**-52
#: a ball with fewer bits is no coefficient
_BITS = 8
#: in which balls are moved by their radii
_MOST_BITS = 4000
#: zeros by which a series of one term counts as a constant
_CONSTANT = 8


class Resummed:
    """Padé approximants of all modes; evaluates like the solution they come from.

    Attributes
    ----------
    problem : Problem
    order : int
        The Taylor order of the coefficients used.
    """

    def __init__(self, solution: Quality, parameters: Mapping[str, float], drop: int = 0,
                 noise: bool = False) -> None:
        self.solution, self.parameters, self.drop, self.noise = solution, parameters, drop, noise
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
                c = self._known(name, n, c)
                c = c[:max(len(c) - self.drop, 1)]
                self._modes[name][sine, n] = step, first, pade(_noisy(c) if self.noise else c)
        return self._modes[name]

    def _known(self, name: str, n: int, c: list[Number]) -> list[Number]:
        """The coefficients of mode n before the first ball without digits."""
        known = next((k for k, x in enumerate(c)
                      if isinstance(x, arb) and x.rel_accuracy_bits() < _BITS and k), len(c))
        if known < len(c) and not (self.drop or self.noise):
            warn(f"only the first {known} of the {len(c)} coefficients of mode {n} of {name!r} are "
                 "used: the balls of the next have no digits; solve with a higher precision",
                 PrecisionWarning)
        return c[:known]

    def fewer(self) -> Resummed:
        """The same with one coefficient less in each mode, to compare with."""
        if self._fewer is None:
            self._fewer = Resummed(self.solution, self.parameters, self.drop + 1)
        return self._fewer

    @cached_property
    def noisy(self) -> Resummed:
        """The same with every coefficient moved by its own uncertainty, to compare with."""
        return Resummed(self.solution, self.parameters, noise=True)

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
        if self._to_be_checked(name, lam, sums):
            self._doubt(name, t, lam)
        amplitude, *frequency = sums.values()
        if isinstance(self.problem.unknowns[name], Scalar):
            value = amplitude[0, 0]
        else:
            omega = frequency[0][0, 0] if frequency else 1.0
            value = motion(amplitude, t + 0 * real("lam", lam), omega, derivative)
        return value if np.ndim(value) else float(value)

    def _to_be_checked(self, name: str, lam: ArrayLike,
                       sums: dict[str, dict[Mode, Real]]) -> bool:
        """Where the truncated series is good, and this sum the same, the error is not asked for."""
        point = tuple(scalars(self.parameters).items())
        if self.solution._doubt(name, lam, point):
            return True
        for which, amplitude in sums.items():
            plain = self.solution._amplitudes(which, real("lam", lam), point)
            if np.any(sum(abs(a - plain[mode]) for mode, a in amplitude.items())
                      > _SMALL * sum(map(np.abs, amplitude.values()))):
                return True
        return False

    def _doubt(self, name: str, t: Array, lam: ArrayLike) -> None:
        """Warn where the error of the sum is not small."""
        error = self.error(name, lam, np.abs(t).max(initial=0.0))
        size = sum(map(np.abs, self.amplitudes(name, lam).values()))
        if np.any(error > _SMALL * size):
            worst = np.argmax(np.nan_to_num(error - _SMALL * size, posinf=np.inf))
            at, error, size = (np.ravel(a + 0 * real("lam", lam))[worst]
                               for a in (real("lam", lam), error, size))
            warn(f"the Padé sum of {name!r} is not determined at λ = {at:g}: its error() there is "
                 f"{error:.2g}, its size {size:.2g}; take a higher order or a smaller λ")

    def error(self, name: str, lam: ArrayLike, t: float | None = None) -> Real:
        """Σ_n of the uncertainty of A_n(λ): an estimate, not a bound; see :func:`uncertainty`.

        It holds at a fixed phase ωt; with a time ``t``, that of the phase is in it as well.  Never
        below rounding, large near a pole of an approximant, infinite where one coefficient is all
        that is known.
        """
        amplitude = self.amplitudes(name, lam)
        self._refuse_poles(name, amplitude, lam)
        size = sum(map(np.abs, amplitude.values()))
        sums = [padé.amplitudes(name, lam) for padé in self._poorer()]
        changes = [sum(abs(a - other[mode]) for mode, a in first.items())
                   for first, other in ((sums[i], sums[j]) for i, j in _PAIRS)]
        noise = self.noisy.amplitudes(name, lam)
        error = (uncertainty(*changes) + sum(abs(a - noise[m]) for m, a in amplitude.items())
                 + self._unmatched(name, amplitude) + _ROUNDING * size)
        if t is not None and len(which := self.solution._summed(name)) > 1:
            turns = sum(n * abs(a) for (_, n), a in amplitude.items())
            error = error + abs(t) * self.error(which[1], lam) * turns
        return error if np.ndim(error) else float(error)

    def _unmatched(self, name: str, amplitude: Mapping[Mode, Real]) -> Real:
        """What no comparison shows: modes of one coefficient, and those beyond the last one."""
        lengths = {mode: approximant.known for mode, (_, _, approximant) in
                   self.approximants(name).items()}
        if not lengths:
            return np.inf if self.order < _CONSTANT else 0.0
        if max(lengths.values()) == 1:
            constant = isinstance(self.problem.unknowns[name], Scalar) and self.order >= _CONSTANT
            return 0.0 if constant else np.inf
        single = sum(abs(amplitude[mode]) for mode, known in lengths.items() if known == 1)
        return single + abs(amplitude[max(lengths, key=lambda mode: mode[1])]) * (
            max(n for _, n in lengths) > 0)

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
        error = float(uncertainty(*(abs(values[i] - values[j]) for i, j in _PAIRS)))
        error += abs(float(quantity(self.noisy)) - values[0]) + _ROUNDING * abs(values[0])
        known = max(approximant.known for name in self.problem.unknowns
                    for _, _, approximant in self.approximants(name).values())
        return Estimate(values[0], error if known > 1 else math.inf)

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


def _noisy(c: list[Number]) -> list[Number]:
    """Coefficients moved by their uncertainty, in alternating directions."""
    out: list[Number] = []
    with working(bits=_MOST_BITS):
        for k, x in enumerate(c):
            sign = 1 if k % 2 else -1
            if isinstance(x, arb):
                out.append(x.mid() + sign * x.rad())
            else:
                out.append(x * (1 + sign * 4 * 2.0**-53) if isinstance(x, float) else x)
    return out


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
    with working(bits=solution.precision or 256):
        phase, series = arb(scalar("tau", tau)), []
        for m, row in enumerate(solution.coefficients[name]):
            total = arb(0)
            for (sine, n), number in row.items():
                wave = (n * phase).sin() if sine != slope else (n * phase).cos()
                total += arb(number) * wave * ((1 if sine else -1) * n if slope else 1)
            series.append(total * to_ball(solution.problem.unit(name, m)))
        return series
