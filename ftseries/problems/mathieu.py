r"""Periodic solutions of a generalized Mathieu equation, section 3 of the paper.

Index convention and formula.  With the ansatz (M2),

.. math::  ψ(x) = λ \sin x + \sum_{n = 3, 5, …} \sum_{m = n, n+2, …} Ψ_{n,m} λ^m \sin nx, \qquad
           a = \sum_{m = 0, 2, …} a_m λ^m,

where Ψ_{n,m} and a_m are polynomials in μ.  The paper treats the branch b_1; the branches a_n
(cosines) and b_n (sines) start in the same way from λ cos nx or λ sin nx with a = n², and their
Fourier orders are those of the parity of n, up to m + n - 1 at Taylor order m.
"""

from __future__ import annotations

import re
from typing import Any

import sympy as sp

from ..aliases import Function, Json
from ..arguments import decimal
from ..errors import InputError
from ..expressions import expression, quoted
from ..problem import Field, Problem, Scalar

__all__ = ["GeneralizedMathieu"]


class GeneralizedMathieu(Problem):
    """A solution of ψ'' = (-a + λ² cos 2x + λ⁴ μ cos 4x) ψ, equation (M1), and its eigenvalue a.

    Parameters
    ----------
    mu : number, optional
        The real parameter μ; left out, it stays a symbol and the coefficients are polynomials.
    branch : str
        "b1", the paper's lowest odd solution, or another characteristic value in the notation of
        DLMF 28.2: "a0", "a1", … for even solutions, "b1", "b2", … for odd ones (λ² = 2q).

    Examples
    --------
    >>> import ftseries as fts
    >>> sol = fts.solve(fts.GeneralizedMathieu(), order=8)
    >>> sol.coefficient("a", 6)                          # equation (M3)
    mu/16 + 1/512
    >>> fts.solve(fts.GeneralizedMathieu(mu=0, branch="a0"), order=4).coefficient("a", 4)
    -1/8
    """

    variable = "x"

    def __init__(self, mu: Any = None, branch: str = "b1") -> None:
        if mu is None or isinstance(mu, sp.Symbol) and mu.name == "mu":
            self.mu, self.parameters = None, ("mu",)
        else:
            try:
                self.mu = decimal(expression(mu) if isinstance(mu, str) else mu)
            except InputError as error:
                raise InputError(f"mu={quoted(mu)} is not a finite rational or float number; leave "
                                 f"it out to keep it as a symbol ({error})") from None
        if not isinstance(branch, str) or not re.fullmatch(
                r"a(0|[1-9][0-9]{,3})|b[1-9][0-9]{,3}", branch):
            raise InputError(f"branch={quoted(branch)}: give 'a0', 'a1', … or 'b1', 'b2', … up to "
                             "9999")
        self.branch, n = branch, int(branch[1:])
        self.unknowns = {"psi": Field("cos" if branch[0] == "a" else "sin",
                                      modes="odd" if n % 2 else "even", powers="odd", fixed=(n,)),
                         "a": Scalar("even")}
        self.seed = {"psi": [{}, {n: 1}], "a": [n**2]}
        self.ahead = max(n - 1, 0)

    def equations(  # type: ignore[override]     # the unknowns by name
            self, lam: Function, psi: Function, a: Function, mu: Any = None
    ) -> dict[str, Function]:
        x, mu = lam.expansion, self.mu if mu is None else mu
        potential = -a + lam**2 * x.cos(2) + lam**4 * mu * x.cos(4)
        return {"(M1)": psi.diff(2) - potential * psi}

    def arguments(self) -> dict[str, Json]:
        given = {} if self.mu is None else {"mu": str(self.mu)}
        return given | ({} if self.branch == "b1" else {"branch": self.branch})
