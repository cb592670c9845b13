r"""How good a series is: radius, residual, error; and better numbers from the same coefficients.

The methods of this class belong to :class:`ftseries.Solution`.  They work in the solver's units:
z = Λ^step with Λ = λ / lam_scale, where step is 2 for a series in λ², so that no coefficient of a
sequence is regularly zero.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import ctx, fmpq

from . import analysis, evaluation
from .aliases import Coefficients, Function, Mode, Modes, Number
from .analysis import Estimate, Singularity
from .arguments import scalar, scalars
from .branch import branch_point
from .conversion import at
from .errors import ConvergenceWarning, InputError
from .expansion import Expansion
from .grid import FloatRing
from .laurent import BallRing, PolynomialRing, RationalRing
from .problem import Scalar
from .refine import Orbit, residuals
from .resum import Resummed
from .series import Series

if TYPE_CHECKING:
    from .problem import Field, Problem
    from .trig import Ring

__all__ = ["Quality"]

#: Fourier orders from which the radius of a whole unknown is taken
_LOW_MODES = 6
#: a relative change beyond which a refined solution may belong to another branch
_FAR = 0.5


class Quality:
    """Analysis of a solution's Taylor coefficients."""

    # what a solution has
    problem: Problem
    arithmetic: str
    order: int
    coefficients: Coefficients
    precision: int | None
    table: Callable[..., dict[Mode, list[float]]]
    _unknown: Callable[[str], Field | Scalar]
    _check_parameters: Callable[[Mapping[str, Any]], None]
    _point: Callable[[Mapping[str, Any]], list[fmpq]]

    def sequence(self, name: str, n: int = 0, sine: bool | None = None,
                 **parameters: Any) -> tuple[int, int, list[Number]]:
        """(step, first, c): mode n of an unknown is Λ^first Σ_k c_k Λ^{step k}.

        The c_k are the solver's numbers: exact, float or ball.
        """
        unknown = self._unknown(name)
        self._check_parameters(parameters)
        if sine is None:
            sine = getattr(unknown, "series", "cos") == "sin"
        mode = int(bool(sine)), 0 if isinstance(unknown, Scalar) else n
        point = self._point(parameters)
        row = [at(coefficients[mode], point) if mode in coefficients else 0
               for coefficients in self.coefficients[name]]
        if not any(row):
            raise InputError(f"mode {n} of {name!r} has no coefficients up to order {self.order}; "
                             "choose a mode of the ansatz or a higher order")
        return analysis.thin(row)

    def expand(self, function: Callable[..., Function], n: int = 0, sine: bool = False,
               **parameters: Any) -> tuple[int, int, list[Number]]:
        """(step, first, c), as :meth:`sequence`, of a mode of a function of λ and the unknowns.

        Parameters
        ----------
        function : callable
            Takes λ and, by name, the unknowns; written as the equations of a problem are.

        Examples
        --------
        The closure S_x/3 of the figure eight, (E4), as a series in λ² (in units of 3^{1/3}):

        >>> import ftseries as fts
        >>> sol = fts.solve(fts.FigureEight(), order=6)
        >>> sol.expand(sol.problem.condition)
        (2, 0, [1, -5/16, 7/256, -55/24576])
        """
        self._check_parameters(parameters)
        ring: Ring
        if self.problem.parameters:
            ring = PolynomialRing(self.problem.parameters)
        elif self.arithmetic == "float":
            ring = FloatRing(degree=self.order + self.problem.ahead, order=self.order)
        else:
            ring = BallRing() if self.arithmetic == "ball" else RationalRing()
        point, mode = self._point(parameters), (int(bool(sine)), n)
        with ctx.workprec(self.precision or ctx.prec):
            expansion = Expansion(ring)
            unknowns = {name: expansion.polynomial(rows)
                        for name, rows in self.coefficients.items()}
            result = function(expansion.lam, **unknowns)
            if not isinstance(result, Series):
                raise InputError(f"the function must return a series, not {result!r}; write it as "
                                 "the equations of a problem are written")
            rows = [result[m].modes() for m in range(self.order + 1)]
        return analysis.thin([at(row[mode], point) if mode in row else 0 for row in rows])

    def singularities(self, name: str, n: int = 0, sine: bool | None = None,
                      **parameters: Any) -> list[Singularity]:
        """The singularities in z = Λ^step nearest to 0, from one mode, nearest first.

        See :func:`ftseries.analysis.nearest_singularities`.
        """
        return analysis.nearest_singularities(self.sequence(name, n, sine, **parameters)[2])

    def branch_point(self, name: str, n: int = 0, sine: bool | None = None,
                     **parameters: Any) -> Singularity:
        """The first of :meth:`singularities`, made sharp on the problem's equations themselves.

        Two periodic solutions meet there; see :mod:`ftseries.branch`.

        Returns
        -------
        Singularity
            In z = Λ^step, with exponent 1/2.

        Raises
        ------
        SolveError
            The singularity is of another kind.

        Examples
        --------
        >>> import ftseries as fts
        >>> sol = fts.solve(fts.GeneralizedMathieu(mu=0), order=40)
        >>> q = sol.branch_point("a").location / 2                          # DLMF, table 28.6.1
        >>> round(abs(q), 8)
        3.76995749
        """
        step = self.sequence(name, n, sine, **parameters)[0]
        z = self.singularities(name, n, sine, **parameters)[0].location
        values = scalars(parameters)
        place = complex(z.real, abs(z.imag)) ** (1 / step)
        inner, outer = (self._complex_amplitudes(part * place, values) for part in (0.97, 0.98))
        slope = {name: {mode: c - inner[name][mode] for mode, c in modes.items()}
                 for name, modes in outer.items()}
        lam, error = branch_point(self.problem, outer, slope, place, values)
        return Singularity(lam**step, 0.5, step * abs(lam) ** (step - 1) * error, 0.0)

    def radius_of_convergence(self, name: str, n: int | None = None, sine: bool | None = None,
                              **parameters: Any) -> Estimate:
        """The radius of convergence in λ, with its uncertainty.

        Parameters
        ----------
        name : str
        n : int, optional
            One Fourier mode; left out, that of the lowest modes whose radius is best determined;
            its distance from the second best is in the uncertainty.
        **parameters
            Values of the problem's free parameters.

        Returns
        -------
        Estimate

        Raises
        ------
        InputError
            Too few coefficients, or a mode without any.

        Examples
        --------
        >>> import ftseries as fts
        >>> sol = fts.solve(fts.GeneralizedMathieu(mu=0), order=99)
        >>> round(sol.radius_of_convergence("a").value ** 2 / 2, 8)             # |q|, DLMF 28.6.1
        3.76995749
        """
        unknown = self._unknown(name)
        if isinstance(unknown, Scalar):
            modes: list[tuple[bool | None, int]] = [(False, 0)]
        elif n is not None:
            modes = [(sine, n)]
        else:
            modes = [(bool(mode[0]), mode[1]) for mode in reversed(unknown.columns(_LOW_MODES))
                     if any(mode in row for row in self.coefficients[name])]
        scale, found = float(self.problem.lam_scale), []
        for sine, n in modes:
            step, _, c = self.sequence(name, n, sine, **parameters)
            try:
                radius = analysis.nearest_singularities(c)[0].radius
            except InputError:
                if len(modes) == 1:
                    raise
                continue
            value = scale * radius.value ** (1 / step)
            found.append((value * radius.error / (radius.value * step), value))
        if not found:
            raise InputError(f"{name!r} has too few coefficients at order {self.order} to estimate "
                             "its radius of convergence; take a higher order")
        (error, value), *others = sorted(found)
        return Estimate(value, max([error] + [abs(value - other) for _, other in others[:1]]))

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
        lam = scalar("lam", lam)
        return residuals(self.problem, self._amplitudes(lam, values),
                         lam / float(self.problem.lam_scale), values)

    def error_estimate(self, name: str, lam: float, **parameters: Any) -> float:
        """About how far the truncated series is from its sum, uniformly in t.

        The last third of the coefficients gives an envelope c_m ≤ C R^{-m}; the estimate is the sum
        of the envelope over the orders left out, infinite at |λ| ≥ R.  It is an extrapolation, not
        a bound.
        """
        radius = float(self.radius_of_convergence(name, **parameters))
        ratio = abs(scalar("lam", lam)) / radius
        if ratio >= 1:
            return np.inf
        sums = np.abs(np.array(list(self.table(name, **parameters).values()))).sum(axis=0)
        m = np.arange(len(sums))
        last = m >= 2 * len(sums) // 3
        envelope = (sums[last] * radius ** m[last]).max()
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
            name: evaluation.amplitudes(self.table(name, **parameters), lam)
            for name in self.problem.unknowns}, parameters=values)
        orbit = first.refine(lam=None if condition else lam)
        if max(_change(first.coefficients[name], modes)
               for name, modes in orbit.coefficients.items()) > _FAR:
            warnings.warn(f"at λ = {orbit.lam:g} Newton's method ended far from the series where "
                          "it began: this may be another of the problem's solutions; take a higher "
                          "order or a smaller λ", ConvergenceWarning, stacklevel=2)
        return orbit

    def _amplitudes(self, lam: float, parameters: Mapping[str, float]) -> dict[str, Modes]:
        """``{name: {mode: A_n(λ)}}`` in the solver's units."""
        return {name: {mode: float(c) / float(self.problem.scale(name)) for mode, c in
                       evaluation.amplitudes(self.table(name, **parameters), lam).items()}
                for name in self.problem.unknowns}

    def _complex_amplitudes(self, lam: complex,
                            parameters: Mapping[str, float]) -> dict[str, Modes]:
        """The same at a complex λ in the solver's units."""
        lam = lam * float(self.problem.lam_scale)
        return {name: {mode: np.polynomial.polynomial.polyval(lam, row)
                       / float(self.problem.scale(name))
                       for mode, row in self.table(name, **parameters).items()}
                for name in self.problem.unknowns}


def _change(before: Mapping[Mode, Any], after: Mapping[Mode, Any]) -> float:
    """The largest change of a mode, relative to the largest mode."""
    change = max(abs(after.get(m, 0.0) - before.get(m, 0.0)) for m in before.keys() | after.keys())
    return float(change / max(map(abs, after.values()), default=1.0))
