r"""A solution summed by Padé approximants instead of truncated.

Formula.  Mode n of an unknown is Λ^first Σ_k c_k z^k with z = Λ^step (see
:meth:`ftseries.Solution.sequence`); the sum is replaced by its diagonal Padé approximant in z.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import arb

from .aliases import Array, ArrayLike, Column, Mode, Number, Real
from .analysis import Estimate, certain, pade
from .arguments import real, scalar, scalars
from .conversion import at, float_unit, to_ball
from .errors import FTSeriesError, InputError, PrecisionWarning
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
#: which sums are compared: (i, j) are i and j coefficients short; the last ones, those before
_LAST, _BEFORE = ((0, 1), (0, 2)), ((2, 3), (2, 4))
#: a part of its size up to which the error of a sum is passed over in silence
_LIMIT = 0.01
#: the rounding of floats, and what a change of the coefficients within theirs counts
_ROUNDING, _SHAKEN = 2.0**-53, 3.0
#: in which balls are moved by their radii
_MOST_BITS = 4000


class Resummed:
    """Padé approximants of all modes; evaluates like the solution they come from.

    Attributes
    ----------
    problem : Problem
    order : int
        The Taylor order of the coefficients used.
    """

    def __init__(self, solution: Quality, parameters: Mapping[str, float], drop: int = 0,
                 shaken: bool = False) -> None:
        self.solution, self.parameters = solution, parameters
        self.drop, self.shaken = drop, shaken
        self.problem, self.order = solution.problem, solution.order
        self._modes: dict[str, dict[Mode, tuple[int, int, Pade]]] = {}
        self._others: dict[tuple[int, bool], Resummed] = {}
        self._asked: set[str] = set()

    def __repr__(self) -> str:
        return f"<Padé sum of {self.solution!r}>"

    def approximants(self, name: str) -> dict[Mode, tuple[int, int, Pade]]:
        """``{(sine, n): (step, first, Pade)}`` of one unknown.

        Of balls those coefficients are used that come before the first one without digits.
        """
        self._asked.add(name)
        if name not in self._modes:
            self._modes[name] = {mode: (step, first, pade(_shaken(c) if self.shaken else c))
                                 for mode, (step, first, c) in self._sequences(name).items()}
        return self._modes[name]

    def _sequences(self, name: str) -> dict[Mode, tuple[int, int, list[Number]]]:
        """``{(sine, n): (step, first, c)}``, the last coefficients dropped; lost modes left out."""
        kind = unknown(self.problem, name)
        found = {mode for row in self.solution.coefficients[name] for mode in row}
        rows = {(sine, n): self.solution.sequence(name, n, bool(sine), **self.parameters)
                for sine, n in sorted(found, key=lambda mode: mode[::-1])}
        common = min((step for step, _, c in rows.values() if len(certain(c)) > 1 and any(c[1:])),
                     default=1)
        result = {}
        for mode, (step, first, c) in rows.items():
            if not any(c[1:]):                                  # one coefficient tells no step
                step, c = common, c[::common]
            if len(good := certain(c)) < len(c) and not (self.drop or self.shaken):
                warn(f"only the first {len(good)} of the {len(c)} coefficients of mode {mode[1]} "
                     f"of {name!r} are used: the balls of the next have no digits; solve with a "
                     "larger precision", PrecisionWarning)
            c = good
            if any(isinstance(x, float) for x in c):
                c = c[:_FLOAT_TERMS]
            if not kind.is_fixed(mode):
                c = c[:max(len(c) - self.drop, 0)]
            if c:
                result[mode] = step, first, c
        return result

    def _other(self, drop: int, shaken: bool = False) -> Resummed:
        """The same with fewer coefficients in each mode, or with other ones within their errors."""
        key = drop, shaken
        if key not in self._others:
            self._others[key] = self if key == (self.drop, self.shaken) else Resummed(
                self.solution, self.parameters, drop, shaken)
        return self._others[key]

    def defects(self) -> dict[Column, list[complex]]:
        """``{(name, sine, n): poles in z}`` of the approximants with spurious pole-zero pairs."""
        return {(name, *mode): spurious for name in self.problem.unknowns
                for mode, (_, _, approximant) in self.approximants(name).items()
                if (spurious := approximant.defects())}

    def amplitudes(self, name: str, lam: ArrayLike) -> dict[Mode, Real]:
        """``{(sine, n): A_n(λ)}`` in the paper's units."""
        lam = self._variable(lam)
        unit = float_unit(self.problem, self.problem.scale(name))
        return {mode: unit * lam**first * approximant(lam**step)
                for mode, (step, first, approximant) in self.approximants(name).items()}

    def _variable(self, lam: ArrayLike) -> Array:
        """λ in the solver's unit."""
        return real("lam", lam) / float_unit(self.problem, self.problem.lam_scale)

    def evaluate(self, name: str, t: ArrayLike | None = None, *positional: Any,
                 lam: Any = None, derivative: int = 0) -> Real:
        """The value of an unknown, or a derivative in t, as :meth:`ftseries.Solution.evaluate`.

        Warns
        -----
        ConvergenceWarning
            :meth:`error` is above a hundredth of the size of the unknown.
        """
        check_lam(self.problem, name, t, positional, lam)
        t = real("t", times(self.problem, name, t, derivative))
        amplitude, *frequency = (self.amplitudes(which, lam)
                                 for which in self.solution._summed(name))
        self._refuse_poles(name, amplitude, lam)
        self._doubt(name, amplitude, lam, t, derivative)
        if isinstance(self.problem.unknowns[name], Scalar):
            value = amplitude.get((0, 0), 0.0 * real("lam", lam))
        else:
            omega = frequency[0].get((0, 0), 0.0) if frequency else 1.0
            value = motion(amplitude, t + 0 * real("lam", lam), omega, derivative)
        return value if np.ndim(value) else float(value)

    def _doubt(self, name: str, amplitude: Mapping[Mode, Real], lam: ArrayLike, t: Real,
               derivative: int) -> None:
        """Warn where the error of the sum is not small."""
        lam, t = np.broadcast_arrays(real("lam", lam), np.max(np.abs(t), initial=0.0))
        size = _weighted(amplitude, derivative)
        error = self._error(name, lam, t, derivative)
        if np.any(error > _LIMIT * size):
            worst = np.argmax(np.nan_to_num(error) - _LIMIT * size)
            at, error, size = (np.ravel(a)[worst] for a in np.broadcast_arrays(lam, error, size))
            warn(f"the Padé sum of {name!r} is not determined at λ = {at:g}: its error() there is "
                 f"{error:.2g}, its size {size:.2g}; take a higher order or a smaller λ")

    def error(self, name: str, lam: ArrayLike, t: ArrayLike | None = None) -> Real:
        r"""The uncertainty of the sum: an estimate, not a bound; see :func:`uncertainty`.

        At a fixed phase it is that of Σ_n |A_n(λ)|: what the sum changes by with fewer
        coefficients in each mode, and with other ones within their balls or rounding, never below
        rounding; infinite where no two terms are known.  Near a pole of an approximant it is large.

        Parameters
        ----------
        name : str
        lam : array_like
        t : array_like, optional
            Of a field at these times, |t| δω Σ_n n |A_n(λ)| is added, where δω is the error of the
            frequency.
        """
        time = real("t", times(self.problem, name, 0 if t is None else t, 0)
                    if not isinstance(unknown(self.problem, name), Scalar) else 0)
        self._refuse_poles(name, self.amplitudes(name, lam), lam)
        error = self._error(name, lam, time, 0)
        return error if np.ndim(error) else float(error)

    def _error(self, name: str, lam: ArrayLike, t: Real, derivative: int) -> Real:
        """Of the k-th derivative in τ, relative to it that in t."""
        error = self._own_error(name, lam, derivative)
        amplitude = self.amplitudes(name, lam)
        for frequency in self.solution._summed(name)[1:]:
            off = self._own_error(frequency, lam, 0)
            omega = np.abs(self.amplitudes(frequency, lam).get((0, 0), 0.0))
            with np.errstate(all="ignore"):
                turn = derivative * _weighted(amplitude, derivative) / omega
                late = np.abs(t) * (off + 2 * _ROUNDING * omega) * _weighted(
                    amplitude, derivative + 1)
                error = error + np.where(t == 0, 0, late) + (off * turn if derivative else 0)
        return error

    def _own_error(self, name: str, lam: ArrayLike, derivative: int) -> Real:
        """The error of the amplitudes, n^derivative times that of mode n."""
        if not self._known(name):
            return np.inf + 0 * real("lam", lam)
        sums = [self._other(self.drop + short).amplitudes(name, lam) for short in range(5)]
        known = sum(map(bool, sums))
        last, before = ([_change(sums[i], sums[j], derivative) for i, j in pairs if j < known]
                        for pairs in (_LAST, _BEFORE))
        error = uncertainty(last, before, _weighted(sums[0], derivative))
        rough = sum(n**derivative * np.abs(a) * self.approximants(name)[sine, n][2].rounding(
            self._variable(lam) ** self.approximants(name)[sine, n][0])
            for (sine, n), a in sums[0].items())
        if self.solution.arithmetic != "exact":
            shaken = self._other(self.drop, shaken=True).amplitudes(name, lam)
            rough = rough + _SHAKEN * _change(sums[0], shaken, derivative)
        return error + rough

    def _known(self, name: str) -> bool:
        """Are there terms of two orders, or is it known that there are no more?"""
        point = self.solution._point(self.parameters)
        if self.solution._has_ended(name, tuple(scalars(self.parameters).items())):
            return True
        return sum(any(at(c, point) for c in row.values())
                   for row in self.solution.coefficients[name]) > 1

    def estimate(self, quantity: Callable[[Resummed], float]) -> Estimate:
        """``quantity`` of this sum with its uncertainty.

        Parameters
        ----------
        quantity : callable
            Takes a sum such as this one and returns a float.

        Returns
        -------
        Estimate
            Its error is an estimate, not a bound; see :func:`uncertainty`.  It is infinite where
            fewer coefficients leave nothing to compare with.

        Examples
        --------
        The physical λ of the figure eight, where S = 0:

        >>> import ftseries as fts
        >>> padé = fts.solve(fts.FigureEight(), order=40).resum()
        >>> lam = padé.estimate(fts.figure_eight.closure_zero)
        >>> abs(lam.value - 2.0756839088491) < lam.error < 1e-2
        True
        """
        self._asked.clear()
        values = [float(quantity(self))]
        for short in range(1, 5):
            poorer = self._other(self.drop + short)
            if not all(self._known(name) and poorer._sequences(name) for name in self._asked):
                break
            try:
                values.append(float(quantity(poorer)))
            except FTSeriesError:
                break
        if len(values) < 2:
            return Estimate(values[0], np.inf)
        last, before = ([abs(values[i] - values[j]) for i, j in pairs if j < len(values)]
                        for pairs in (_LAST, _BEFORE))
        error = uncertainty(last, before, abs(values[0]))
        rough = _ROUNDING * abs(values[0])
        if self.solution.arithmetic != "exact":
            rough += _SHAKEN * abs(values[0] - float(quantity(self._other(self.drop, True))))
        return Estimate(values[0], float(error + rough))

    def _refuse_poles(self, name: str, amplitude: Mapping[Mode, Real], lam: ArrayLike) -> None:
        if not all(np.isfinite(a).all() for a in amplitude.values()):
            raise InputError(f"λ = {lam!r} is a pole of a Padé approximant of {name!r}; change λ "
                             "or the order")


def uncertainty(last: Sequence[Real], before: Sequence[Real], size: Real) -> Real:
    """An error from the changes of a sum by its last two coefficients, and by the two before them.

    If the larger changes c, c' fall geometrically, by r = c/c', what is left out is c r/(1 - r);
    the error is that or c, whichever is larger.  Where no change before is known, c' is the size.

    >>> uncertainty([1e-3, 1e-3], [4e-3, 2e-3], 1), round(uncertainty([9e-3], [1e-2], 1), 3)
    (np.float64(0.001), np.float64(0.081))
    """
    c, above = (np.max([0 * size, *changes], axis=0) for changes in (last, before))
    above = np.where(above == 0, size, above)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.clip(np.nan_to_num(c / above), 0, 0.95)
    return c * np.maximum(1, ratio / (1 - ratio))


def _change(first: Mapping[Mode, Real], other: Mapping[Mode, Real], derivative: int) -> Real:
    """Σ n^derivative of the changes of the amplitudes, also of those that only one sum has."""
    return sum(n**derivative * np.abs(first.get((sine, n), 0.0) - other.get((sine, n), 0.0))
               for sine, n in first.keys() | other.keys())


def _weighted(amplitude: Mapping[Mode, Real], derivative: int) -> Real:
    """Σ n^derivative |A_n|."""
    return sum((n**derivative * np.abs(a) for (_, n), a in amplitude.items()), np.float64(0.0))


def _shaken(c: Sequence[Number]) -> list[Number]:
    """The middles of balls, or floats, moved within their balls or rounding, this way and that."""
    signs = np.random.default_rng(1).choice((-1, 1), len(c)).tolist()
    with working(bits=_MOST_BITS):
        return [x * (1 + 2 * _ROUNDING * (k + 1) * sign) if isinstance(x, float)
                else x.mid() + sign * x.rad() if isinstance(x, arb) else x
                for k, (x, sign) in enumerate(zip(c, signs))]


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
