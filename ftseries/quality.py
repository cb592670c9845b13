r"""How good a series is: residual, error; and better numbers from the same coefficients.

The methods of this class belong to :class:`ftseries.Solution`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np

from . import evaluation
from .arguments import scalar, scalars
from .errors import SolveError
from .family import change, follow
from .refine import Orbit, residuals
from .resum import Resummed
from .sequences import Sequences
from .tables import Point

__all__ = ["Quality"]

#: relative changes: of a good series, of any by Newton's method, of one solution found twice
_GOOD, _CLOSE, _SAME = 1e-3, 0.05, 1e-4
#: the last orders
_LAST = 2
#: of a sum of floats, against its terms
_ROUNDING = 2.0**-52


class Quality(Sequences):
    """A solution tested, and improved."""

    def resum(self, **parameters: Any) -> Resummed:
        """The same series summed by Padé approximants in λ, mode by mode.

        Returns
        -------
        Resummed
            Evaluates like the solution, also beyond the radius of convergence.

        Examples
        --------
        >>> import ftseries as fts
        >>> sol = fts.solve(fts.CubicOscillator(a=1), order=40)
        >>> bool(sol.resum().error("omega", lam=2.5) < 1e-9)
        True
        """
        self._check_parameters(parameters)
        return Resummed(self, parameters)

    def residual(self, lam: float, **parameters: Any) -> dict[str, float]:
        """The largest absolute residual of each equation at λ, in the solver's units, as a dict.

        Derivatives are those of the truncated series, products are not truncated.
        """
        self._check_parameters(parameters)
        values = scalars(parameters)
        lam = scalar("lam", lam) / self._lam_scale
        amplitudes = {name: evaluation.amplitudes(self._table(name, tuple(values.items())), lam)
                      for name in self.problem.unknowns}
        return residuals(self.problem, amplitudes, lam, values)

    def error_estimate(self, name: str, lam: float, t: float | None = None,
                       **parameters: Any) -> float:
        """About how far the truncated series is from its sum: an extrapolation, not a bound.

        The last third of the coefficients gives an envelope c_m ≤ C R^{-m}; the estimate is the sum
        of the envelope over the orders left out, infinite at |λ| ≥ R, and what the rounding of
        floats or the radii of balls add.  It holds at a fixed phase ωt.

        Parameters
        ----------
        name : str
        lam : float
        t : float, optional
            A time; then the error of the phase, |t| times that of ω, is in the estimate of a field
            as well.
        **parameters
            Values of the problem's free parameters.

        Examples
        --------
        >>> import ftseries as fts
        >>> sol = fts.solve(fts.CubicOscillator(a=1), order=24)
        >>> sol.error_estimate("x", 1.5) < 1e-8 < 1e-4 < sol.error_estimate("x", 1.5, t=1e6)
        True
        """
        lam = scalar("lam", lam)
        ratio = abs(lam) / (radius := float(self.radius_of_convergence(name, **parameters)))
        if ratio >= 1:
            return np.inf
        point = tuple(scalars(parameters).items())
        table, size = self._table(name, point), abs(self._scale(name))
        sums = size * np.abs(np.array(list(table.values()))).sum(axis=0)
        m = np.arange(len(sums))
        last = m >= 2 * len(sums) // 3
        envelope = (sums[last] * (radius / self._lam_scale) ** m[last]).max()
        left_out = envelope * ratio ** (self.order + 1) / (1 - ratio)
        terms = sums * (abs(lam) / self._lam_scale) ** m
        error = left_out + _ROUNDING * terms.sum() + size * self._widths(name, lam, point)
        which = self._summed(name)[1:]
        if t is not None and which:
            turns = sum(n * abs(a) for (_, n), a in
                        self._amplitudes(name, np.asarray(lam), point).items())
            error += abs(scalar("t", t)) * turns * self.error_estimate(which[0], lam, **parameters)
        return float(error)

    def _widths(self, name: str, lam: float, point: Point) -> float:
        """Σ over all modes of the radii of the balls times |λ|^m, in the solver's unit."""
        if self.arithmetic != "ball":
            return 0.0
        ratio = abs(lam) / self._lam_scale
        return float(sum(float(c.rad()) * ratio**m for m, row in enumerate(self.coefficients[name])
                         for c in row.values()))

    def refine(self, lam: float | None = None, **parameters: Any) -> Orbit:
        """The periodic solution at λ to rounding, by Newton's method from this series.

        Parameters
        ----------
        lam : float, optional
            Left out, λ is solved for as well, from the problem's condition: for the figure eight
            the λ at which S = 0.
        **parameters
            Values of the problem's free parameters.

        Returns
        -------
        Orbit
            With ``lam``, ``residual``, ``steps``, and ``evaluate`` as here.

        Warns
        -----
        ConvergenceWarning
            Newton's method ended far from where it began, and the family of the series could not be
            followed to λ.

        Raises
        ------
        SolveError
            No solution was found, neither from the series at λ nor by following the family.

        Examples
        --------
        >>> import ftseries as fts
        >>> orbit = fts.solve(fts.FigureEight(), order=6).refine()
        >>> round(orbit.lam, 13), orbit.residual < 1e-10
        (2.0756839088491, True)
        """
        self._check_parameters(parameters)
        values = scalars(parameters)
        condition = lam is None
        lam = scalar("lam", self.problem.first_lam(self) if condition else lam)
        series = partial(self._orbit, values)
        direct = _tried(series(lam).refine, lam=None if condition else lam)
        if isinstance(direct, Orbit) and self._reaches(direct):
            return direct
        family = _tried(follow, series, direct.lam if isinstance(direct, Orbit) else lam)
        if isinstance(family, SolveError):
            if isinstance(direct, SolveError):
                raise SolveError(f"{direct}; {family}")
            evaluation.warn(f"at λ = {direct.lam:g} Newton's method ended far from the series "
                            "where it began: this may be another of the problem's solutions; "
                            f"{family}")
            return direct
        if isinstance(direct, Orbit) and change(family.coefficients, direct.coefficients) < _SAME:
            return direct
        return family.refine(lam=None if condition else lam)

    def _orbit(self, parameters: Mapping[str, float], lam: float, shorter: int = 0) -> Orbit:
        """The truncated series at λ, by so many orders shorter."""
        end = max(self.order - shorter, 0) + 1
        return Orbit(self.problem, lam, {
            name: {mode: self._scale(name) * a for mode, a in evaluation.amplitudes(
                {mode: row[:end] for mode, row in
                 self._table(name, tuple(parameters.items())).items()},
                lam / self._lam_scale).items()}
            for name in self.problem.unknowns}, parameters=parameters)

    def _reaches(self, orbit: Orbit) -> bool:
        """Is an orbit so close to the series as the last orders say that the series is?"""
        series, shorter = (self._orbit(orbit.parameters, orbit.lam, cut).coefficients
                           for cut in (0, _LAST))
        near = change(series, orbit.coefficients)
        return near < _GOOD or near < min(_CLOSE, change(shorter, series))


def _tried(function: Callable[..., Orbit], *arguments: Any, **options: Any) -> Orbit | SolveError:
    """What the function finds, or why it finds nothing."""
    try:
        return function(*arguments, **options)
    except SolveError as error:
        return error
