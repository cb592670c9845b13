r"""Periodic solutions of a generalized Mathieu equation, section 3 of the paper.

Index convention and formula.  With the ansatz (M2),

.. math::  ψ(x) = λ \sin x + \sum_{n = 3, 5, …} \sum_{m = n, n+2, …} Ψ_{n,m} λ^m \sin nx, \qquad
           a = \sum_{m = 0, 2, …} a_m λ^m,

where Ψ_{n,m} and a_m are polynomials in μ.
"""

import sympy as sp

from ..errors import InputError
from ..problem import Field, Problem, Scalar
from ..trig import rational

__all__ = ["GeneralizedMathieu"]


class GeneralizedMathieu(Problem):
    """The lowest odd solution of ψ'' = (-a + λ² cos 2x + λ⁴ μ cos 4x) ψ, equation (M1).

    Parameters
    ----------
    mu : number, optional
        The real parameter μ; left out, it stays a symbol and the coefficients are polynomials.

    Examples
    --------
    >>> import ftseries as fts
    >>> sol = fts.solve(fts.GeneralizedMathieu(), order=8)
    >>> sol.coefficient("a", 6)                          # equation (M3)
    mu/16 + 1/512
    """

    unknowns = {"psi": Field("sin", modes="odd", powers="odd", fixed=(1,)), "a": Scalar("even")}
    seed = {"psi": [{}, {1: 1}], "a": [1]}

    def __init__(self, mu=None):
        if mu is None or mu == sp.Symbol("mu"):
            self.mu, self.parameters = None, ("mu",)
        else:
            try:
                self.mu = rational(mu)
            except InputError:
                raise InputError(f"mu={mu!r} is not a finite rational or float number; leave it "
                                 "out to keep it as a symbol") from None

    def equations(self, lam, psi, a):
        x = lam.expansion
        mu = x.parameter("mu") if self.mu is None else self.mu
        potential = -a + lam**2 * x.cos(2) + lam**4 * mu * x.cos(4)
        return {"(M1)": psi.diff(2) - potential * psi}

    def arguments(self):
        return {} if self.mu is None else {"mu": str(self.mu)}
