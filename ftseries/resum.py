r"""A solution summed by Padé approximants instead of truncated.

Formula.  Mode n of an unknown is Λ^first Σ_k c_k z^k with z = Λ^step (see
:meth:`ftseries.Solution.sequence`); the sum is replaced by its diagonal Padé approximant in z.
"""

import numpy as np

from .analysis import Estimate, pade
from .errors import InputError
from .evaluation import finite, fourier_sum
from .problem import Scalar

__all__ = ["Resummed"]

#: coefficients of a mode that are used when they are floats: more would fit their rounding
_FLOAT_TERMS = 100


class Resummed:
    """Padé approximants of all modes; evaluates like the solution they come from.

    Attributes
    ----------
    problem : Problem
    order : int
        The Taylor order of the coefficients used.
    """

    def __init__(self, solution, parameters, drop=0):
        self.solution, self.parameters, self.drop = solution, parameters, drop
        self.problem, self.order = solution.problem, solution.order
        self._modes, self._fewer = {}, None

    def __repr__(self):
        return f"<Padé sum of {self.solution!r}>"

    def approximants(self, name):
        """``{(sine, n): (step, first, Pade)}`` of one unknown."""
        if name not in self._modes:
            found = {mode for row in self.solution.coefficients[name] for mode in row}
            self._modes[name] = {}
            for sine, n in sorted(found, key=lambda mode: mode[::-1]):
                step, first, c = self.solution.sequence(name, n, sine, **self.parameters)
                if any(isinstance(x, float) for x in c):
                    c = c[:_FLOAT_TERMS]
                c = c[:max(len(c) - self.drop, 1)]
                self._modes[name][sine, n] = step, first, pade(c)
        return self._modes[name]

    def fewer(self):
        """The same with one coefficient less in each mode, to compare with."""
        if self._fewer is None:
            self._fewer = Resummed(self.solution, self.parameters, self.drop + 1)
        return self._fewer

    def defects(self):
        """``{(name, sine, n): poles in z}`` of the approximants with spurious pole-zero pairs."""
        return {(name, *mode): spurious for name in self.problem.unknowns
                for mode, (_, _, approximant) in self.approximants(name).items()
                if (spurious := approximant.defects())}

    def amplitudes(self, name, lam):
        """``{(sine, n): A_n(λ)}`` in the paper's units."""
        lam = finite("lam", lam) / float(self.problem.lam_scale)
        unit = float(self.problem.scale(name))
        return {mode: unit * lam**first * approximant(lam**step)
                for mode, (step, first, approximant) in self.approximants(name).items()}

    def evaluate(self, name, t=None, *, lam):
        """The value of an unknown at times t and parameter λ, broadcasting."""
        unknown = self.solution._unknown(name)
        amplitude = self.amplitudes(name, lam)
        self._refuse_poles(name, amplitude, lam)
        if isinstance(unknown, Scalar):
            return amplitude[0, 0]
        if t is None:
            raise InputError(f"{name!r} depends on time: evaluate({name!r}, t, lam=…)")
        t = finite("t", t)
        if self.problem.frequency:
            t = t * self.amplitudes(self.problem.frequency, lam)[0, 0]
        return fourier_sum(amplitude, t + 0 * finite("lam", lam))

    def error(self, name, lam):
        """Σ_n of the change in A_n(λ) without the last coefficients: an estimate, not a bound.

        The larger of the changes without one and without two coefficients; near a pole of an
        approximant it is large.
        """
        mine = self.amplitudes(name, lam)
        self._refuse_poles(name, mine, lam)
        changes = []
        for _, other in zip(range(2), self._poorer()):
            other = other.amplitudes(name, lam)
            changes.append(sum(abs(a - other[mode]) for mode, a in mine.items()))
        return np.maximum(*changes)

    def estimate(self, quantity):
        """``quantity`` of this sum with its uncertainty.

        Parameters
        ----------
        quantity : callable
            Takes a sum such as this one and returns a float.

        Returns
        -------
        Estimate
            The error is the larger change of the quantity without the last coefficient and without
            the last two of each mode: an estimate, not a bound.

        Examples
        --------
        The physical λ of the figure eight, where S = 0:

        >>> import ftseries as fts
        >>> padé = fts.solve(fts.FigureEight(), order=40).resum()
        >>> lam = padé.estimate(fts.figure_eight.closure_zero)
        >>> abs(lam.value - 2.0756839088491) < lam.error < 1e-3
        True
        """
        value = float(quantity(self))
        return Estimate(value, max(abs(float(quantity(other)) - value)
                                   for _, other in zip(range(2), self._poorer())))

    def _poorer(self):
        yield (other := self.fewer())
        yield other.fewer()

    def _refuse_poles(self, name, amplitude, lam):
        if not all(np.isfinite(a).all() for a in amplitude.values()):
            raise InputError(f"λ = {lam!r} is a pole of a Padé approximant of {name!r}; change λ "
                             "or the order")
