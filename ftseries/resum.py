r"""A solution summed by Padé approximants instead of truncated.

Formula.  Mode n of an unknown is Λ^first Σ_k c_k z^k with z = Λ^step (see
:meth:`ftseries.Solution.sequence`); the sum is replaced by its diagonal Padé approximant in z.
"""

import numpy as np

from .analysis import pade
from .errors import InputError
from .evaluation import finite, fourier_sum
from .problem import Scalar

__all__ = ["Resummed"]


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
        self._modes = {}

    def __repr__(self):
        return f"<Padé sum of {self.solution!r}>"

    def approximants(self, name):
        """``{(sine, n): (step, first, Pade)}`` of one unknown."""
        if name not in self._modes:
            found = {mode for row in self.solution.coefficients[name] for mode in row}
            self._modes[name] = {}
            for sine, n in sorted(found, key=lambda mode: mode[::-1]):
                step, first, c = self.solution.sequence(name, n, sine, **self.parameters)
                c = c[:max(len(c) - self.drop, 1)]
                self._modes[name][sine, n] = step, first, pade(c)
        return self._modes[name]

    def fewer(self):
        """The same with one coefficient less in each mode, to compare with."""
        return Resummed(self.solution, self.parameters, self.drop + 1)

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
        if not all(np.isfinite(a).all() for a in amplitude.values()):
            raise InputError(f"λ = {lam!r} is a pole of a Padé approximant of {name!r}; change λ "
                             "or the order")
        if isinstance(unknown, Scalar):
            return amplitude[0, 0]
        if t is None:
            raise InputError(f"{name!r} depends on time: evaluate({name!r}, t, lam=…)")
        t = finite("t", t)
        if self.problem.frequency:
            t = t * self.amplitudes(self.problem.frequency, lam)[0, 0]
        return fourier_sum(amplitude, t + 0 * finite("lam", lam))

    def error(self, name, lam):
        """Σ_n of the change in A_n(λ) without the last coefficient: an estimate, not a bound."""
        other = self.fewer().amplitudes(name, lam)
        return sum(abs(a - other[mode]) for mode, a in self.amplitudes(name, lam).items())
