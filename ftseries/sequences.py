r"""What the Taylor coefficients of a solution's modes show: singularities, radius of convergence.

The methods of this class belong to :class:`ftseries.Solution`.  They work in the solver's units:
z = Λ^step with Λ = λ / lam_scale, where step is 2 for a series in λ², so that no coefficient of a
sequence is regularly zero.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import fmpq

from . import analysis
from .aliases import Function, Modes, Number
from .analysis import Estimate, FewError, Singularity
from .arguments import scalars, whole
from .branch import branch_point
from .conversion import at
from .errors import InputError
from .evaluation import unknown
from .expansion import Expansion
from .grid import FloatRing
from .laurent import BallRing, PolynomialRing, RationalRing
from .precision import working
from .problem import Scalar
from .series import Series
from .values import Values

if TYPE_CHECKING:
    from .problem import Problem
    from .trig import Ring

__all__ = ["Sequences"]

#: Fourier orders from which the radius of a whole unknown is taken
_LOW_MODES = 6
#: the uncertainty of a field's radius that one sequence alone shows, and up to which one counts
_ALONE, _SHARP = 0.1, 0.1
#: cos(kπ/2)
_WAVE = (1, 0, -1, 0)
#: so many coefficients of a sequence usually show its singularity
_COEFFICIENTS = 20


class Sequences(Values):
    """Analysis of a solution's Taylor coefficients, mode by mode."""

    def sequence(self, name: str, n: int = 0, sine: bool | None = None,
                 **parameters: Any) -> tuple[int, int, list[Number]]:
        """(step, first, c): mode n of an unknown is Λ^first Σ_k c_k Λ^{step k}.

        The c_k are the solver's numbers: exact, float, or balls as they are, also where a ball has
        no digits.
        """
        kind = unknown(self.problem, name)
        self._check_parameters(parameters)
        if sine is None:
            sine = getattr(kind, "series", "cos") == "sin"
        mode = int(bool(sine)), 0 if isinstance(kind, Scalar) else whole("n", n)
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
        _check_signature(function, self.problem)
        ring: Ring
        if self.problem.parameters:
            ring = PolynomialRing(self.problem.parameters)
        elif self.arithmetic == "float":
            ring = FloatRing(degree=self.order + self.problem.ahead, order=self.order)
        else:
            ring = BallRing() if self.arithmetic == "ball" else RationalRing()
        point, mode = self._point(parameters), (int(bool(sine)), n)
        with working(bits=self.precision):
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
        step, _, c = self.sequence(name, n, sine, **parameters)
        return self._nearest(step, c, name)

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
            One Fourier mode; left out, of a field as a whole: from its lowest modes, its values at
            the phases 0 and π/2, and the frequency, the radius that is best determined.  Its
            distance from the next, and from lower ones, is in the uncertainty, which is a fifth
            where there is one alone: single modes may converge farther than the field.
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
        kind = unknown(self.problem, name)
        self._check_parameters(parameters)
        if isinstance(kind, Scalar) or n is not None:
            return self._radius(*self.sequence(name, n or 0, sine, **parameters)[::2], name)
        found = []
        for row in self._rows(name, parameters):
            try:
                found.append(self._radius(*analysis.thin(row)[::2], name))
            except InputError:
                continue
        if not found:
            raise self._few(name, 2)
        best, *others = sorted(found, key=lambda radius: (radius.error, radius.value))
        nearest = min((abs(best.value - other.value) for other in others),
                      default=_ALONE * best.value)
        lowest = min(radius.value for radius in found
                     if radius is best or radius.error < _SHARP * radius.value)
        return Estimate(best.value, max(best.error, 2 * nearest, best.value - lowest))

    def _rows(self, name: str, parameters: Mapping[str, Any]) -> Iterator[list[Number]]:
        """Taylor coefficients of low modes, of the field at the phases 0 and π/2, and of ω."""
        point = self._point(parameters)
        rows = [{mode: at(c, point) for mode, c in row.items()} for row in self.coefficients[name]]
        for mode in reversed(self.problem.unknowns[name].columns(_LOW_MODES)):
            yield [row.get(mode, 0) for row in rows]
        for quarter in (0, 1):
            yield [sum((c * _WAVE[(n * quarter - sine) % 4] for (sine, n), c in row.items()), 0)
                   for row in rows]
        if self.problem.frequency:
            yield [at(row.get((0, 0), fmpq(0)), point)
                   for row in self.coefficients[self.problem.frequency]]

    def _radius(self, step: int, c: Sequence[Number], name: str) -> Estimate:
        """The radius in λ from a series in Λ^step."""
        radius = self._nearest(step, c, name)[0].radius
        value = self._lam_scale * radius.value ** (1 / step)
        return Estimate(value, value * radius.error / (radius.value * step))

    def _nearest(self, step: int, c: Sequence[Number], name: str) -> list[Singularity]:
        try:
            return analysis.nearest_singularities(c)
        except FewError:
            good = analysis.certain(c)
            if len(good) < len(c):
                raise InputError(f"{name!r} shows no singularity: its coefficients are balls, of "
                                 f"which only the first {len(good)} have digits; solve with a "
                                 "larger precision") from None
            raise self._few(name, step) from None

    def _few(self, name: str, step: int) -> InputError:
        return InputError(f"{name!r} shows no singularity at order {self.order}: it has too few "
                          "coefficients, or its function has none; try order="
                          f"{max(2 * self.order, _COEFFICIENTS * step)}")

    def _complex_amplitudes(self, lam: complex,
                            parameters: Mapping[str, float]) -> dict[str, Modes]:
        """``{name: {mode: A_n(λ)}}`` at a complex λ, all in the solver's units."""
        point = tuple(parameters.items())
        return {name: {mode: np.polynomial.polynomial.polyval(lam, row)
                       for mode, row in self._table(name, point).items()}
                for name in self.problem.unknowns}


def _check_signature(function: Any, problem: Problem) -> None:
    """Refuse what does not take λ and, by name, the unknowns."""
    try:
        inspect.signature(function).bind(None, **dict.fromkeys(problem.unknowns))
    except (TypeError, ValueError):
        arguments = ", ".join(["lam", *problem.unknowns])
        raise InputError(f"{function!r} is not a function of λ and all the unknowns; give one like "
                         f"lambda {arguments}: …") from None
