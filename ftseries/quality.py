r"""How good a series is: residual, error; and better numbers from the same coefficients.

The methods of this class belong to :class:`ftseries.Solution`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from . import evaluation
from .aliases import Mode
from .arguments import scalar, scalars
from .refine import Orbit, residuals
from .resum import Resummed
from .sequences import Sequences

__all__ = ["Quality"]

#: a relative change beyond which a refined solution may belong to another branch
_FAR = 0.5
#: stands for the size of a solution at rest
_NOTHING = 1e-300


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

    def error_estimate(self, name: str, lam: float, **parameters: Any) -> float:
        """About how far the truncated series is from its sum, uniformly in t.

        The last third of the coefficients gives an envelope c_m ≤ C R^{-m}; the estimate is the sum
        of the envelope over the orders left out, infinite at |λ| ≥ R.  It is an extrapolation, not
        a bound.
        """
        lam = scalar("lam", lam)
        ratio = abs(lam) / (radius := float(self.radius_of_convergence(name, **parameters)))
        if ratio >= 1:
            return np.inf
        table = self._table(name, tuple(scalars(parameters).items()))
        sums = self._scale(name) * np.abs(np.array(list(table.values()))).sum(axis=0)
        m = np.arange(len(sums))
        last = m >= 2 * len(sums) // 3
        envelope = (sums[last] * (radius / self._lam_scale) ** m[last]).max()
        return float(envelope * ratio ** (self.order + 1) / (1 - ratio))

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
            Newton's method ended far from where it began.

        Examples
        --------
        >>> import ftseries as fts
        >>> orbit = fts.solve(fts.FigureEight(), order=6).refine()
        >>> round(orbit.lam, 13), orbit.residual < 1e-10
        (2.0756839088491, True)
        """
        self._check_parameters(parameters)
        condition = lam is None
        if condition:
            lam = self.problem.first_lam(self)
        lam = scalar("lam", lam)
        values = scalars(parameters)
        first = Orbit(self.problem, lam, {
            name: self._amplitudes(name, np.asarray(lam), tuple(values.items()))
            for name in self.problem.unknowns}, parameters=values)
        orbit = first.refine(lam=None if condition else lam)
        if max(_change(first.coefficients[name], modes)
               for name, modes in orbit.coefficients.items()) > _FAR:
            evaluation.warn(f"at λ = {orbit.lam:g} Newton's method ended far from the series where "
                            "it began: this may be another of the problem's solutions; take a "
                            "higher order or a smaller λ")
        return orbit


def _change(before: Mapping[Mode, Any], after: Mapping[Mode, Any]) -> float:
    """The largest change of a mode, relative to the largest mode."""
    change = max(abs(after.get(m, 0.0) - before.get(m, 0.0)) for m in before.keys() | after.keys())
    return float(change / max([_NOTHING, *map(abs, after.values())]))
