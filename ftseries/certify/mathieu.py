r"""Theorem: the lowest eigenvalue of the generalized Mathieu equation lies in this ball.

Formula.  Odd solutions ψ = Σ c_n sin nx, n = 1, 3, 5, …, of (M1) are eigenvectors of the matrix
H = n² + q M¹ + s M² in ℓ² with q = λ²/2, s = λ⁴μ/2, Mʲ_nk = δ(|n - k|, 2j) - δ(n + k, 2j), a
bounded symmetric perturbation of n².  Let B be its first N rows and columns and c = |q| + |s|.

*At most one eigenvalue lies below β.*  The rest of H is at least τ + β, with
τ = (2N + 1)² - 2c - β > 0, and the coupling to the block has norm at most c, so H - β is at least
B - β - c²/τ on the block and non-negative beyond (complete the square).  The signs of the pivots of
this matrix count its negative eigenvalues (Sylvester): one.

*Where it is* (Rayleigh and Temple).  For a vector v with Rayleigh quotient η < β and residual
ρ = ‖(H - η)v‖/‖v‖,

.. math::  η - \frac{ρ^2}{β - η} \le a \le η.

It is the lowest of all odd periodic solutions: those with even n solve the same equation on
[0, π/2] with ψ(π/2) = 0 instead of ψ'(π/2) = 0, a smaller space for Rayleigh's quotient.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb, arb_mat, fmpq

from ..aliases import Array, Exact, FilePath
from ..arguments import decimal, whole
from ..errors import InputError
from ..precision import working
from ..problems.mathieu import GeneralizedMathieu
from . import certificate
from .algebra import upper
from .balls import NotProved, at_least

__all__ = ["EigenvalueTheorem", "mathieu_eigenvalue"]

LARGEST = 512                       # N


@dataclass(frozen=True)
class EigenvalueTheorem:
    """What was proved.

    Attributes
    ----------
    a : arb
        A ball that contains the lowest eigenvalue with odd ψ, and no other.
    beta : arb
        The second one with odd modes is not below β.
    lam, mu : fmpq
        The parameters, exactly.
    vector : list of arb
        v, the approximate c_1, c_3, ….
    precision : int
    """

    a: arb
    beta: arb
    lam: fmpq
    mu: fmpq
    vector: list[arb]
    precision: int

    def __str__(self) -> str:
        return (f"Theorem. For λ = {self.lam}, μ = {self.mu} the lowest a for which (M1) has an "
                f"odd 2π-periodic solution is {self.a.str(40)}; the next with odd modes is at "
                f"least {at_least(self.beta, 6)}. [N = {len(self.vector)}]")

    def save(self, path: FilePath) -> None:
        """Write a certificate for :func:`ftseries.certify.check`."""
        certificate.write(path, {
            "theorem": "Mathieu eigenvalue", "precision": self.precision, "lam": str(self.lam),
            "mu": str(self.mu), "a": certificate.ball(self.a),
            "beta": certificate.exact(self.beta),
            "vector": [certificate.exact(x) for x in self.vector]})

    def series_error(self, solution: Any) -> arb:
        """A ball that contains (series at this λ and μ) - a: the true error of the series.

        Coefficients that are floats are taken as exact numbers.

        Examples
        --------
        >>> import ftseries as fts
        >>> theorem = fts.certify.mathieu_eigenvalue(1, 0)
        >>> error = theorem.series_error(fts.solve(fts.GeneralizedMathieu(), order=8))
        >>> print(error.str(5, radius=False))
        8.0800e-6
        """
        problem = getattr(solution, "problem", None)
        if not isinstance(problem, GeneralizedMathieu) or problem.branch != "b1":
            raise InputError(f"{solution!r} is not a series of the lowest odd solution of (M1)")
        if problem.mu is not None and problem.mu != self.mu:
            raise InputError(f"the series has μ = {problem.mu}, the theorem μ = {self.mu}")
        with working(bits=self.precision):
            total = arb(0)
            for m, row in enumerate(solution.coefficients["a"]):
                for c in row.values():
                    total += _value(c, self.mu) * arb(self.lam**m)
            return total - self.a


def _value(c: Any, mu: fmpq) -> arb:
    """A coefficient as a ball: a polynomial in μ, a rational, a float or a ball."""
    if hasattr(c, "to_dict"):
        return arb(sum((k * mu ** int(i[-1]) for i, k in c.to_dict().items()), fmpq(0)))
    return c if isinstance(c, arb) else arb(c)


def mathieu_eigenvalue(lam: Exact, mu: Exact = 0, digits: int = 30) -> EigenvalueTheorem:
    """Enclose the eigenvalue of (M1) that belongs to the lowest odd solution.

    Parameters
    ----------
    lam, mu : int, str, Fraction or float
        The parameters, taken exactly; a float is the decimal that it looks like.
    digits : int
        Digits to be aimed at.

    Raises
    ------
    NotProved
        The inequalities do not hold at any size of the matrix up to 512.

    Examples
    --------
    >>> from ftseries import certify
    >>> print(certify.mathieu_eigenvalue(2, "-0.3", digits=20).a.str(20, radius=False))
    -2.9959818288053853293
    """
    lam, mu = decimal(lam), decimal(mu)
    if not max(abs(lam), abs(mu)) < 10**12:
        raise InputError(f"lam={lam}, mu={mu}: both must be below 10^12 in size")
    digits = whole("digits", digits, 1, 1000)
    size, precision = 16, int(3.33 * digits) + 96
    with working(bits=precision):
        while True:
            try:
                a, beta, vector = _prove(lam, mu, size, digits)
                if a.rad() < arb(10) ** -digits * (1 + abs(a)):
                    return EigenvalueTheorem(a, beta, lam, mu, vector, precision)
                reason = f"not proved: the ball {a.str(10)} is wider than {digits} digits"
            except NotProved as error:
                reason = str(error)
            size *= 2
            if size > LARGEST:
                raise NotProved(f"{reason}; N = {size // 2}")


def hill(lam: fmpq, mu: fmpq, rows: int, columns: int) -> list[list[fmpq]]:
    """The corner of H with that many rows and columns, as rows of rational numbers."""
    q, s = lam**2 / 2, lam**4 * mu / 2

    def entry(n: int, k: int) -> fmpq:
        return (fmpq(n * n if n == k else 0) + q * ((abs(n - k) == 2) - (n + k == 2))
                + s * ((abs(n - k) == 4) - (n + k == 4)))
    return [[entry(2 * i + 1, 2 * j + 1) for j in range(columns)] for i in range(rows)]


def _prove(lam: fmpq, mu: fmpq, size: int, digits: int) -> tuple[arb, arb, list[arb]]:
    block = hill(lam, mu, size, size)
    floats = np.array([[float(x.p) / float(x.q) for x in row] for row in block])
    values = np.linalg.eigvalsh(floats)
    beta = arb(float(values[0] + values[1]) / 2)
    vector = _eigenvector(block, floats, values[0], digits)
    corner = arb_mat([[arb(x) for x in row] for row in hill(lam, mu, size + 2, size)])
    image = [x[0] for x in (corner * arb_mat([[x] for x in vector])).tolist()]
    square = sum((x * x for x in vector), arb(0))
    eta = sum((x * y for x, y in zip(vector, image)), arb(0)) / square
    rest = [y - eta * x for x, y in zip([*vector, arb(0), arb(0)], image)]
    residual = sum((x * x for x in rest), arb(0)) / square
    if not eta < beta:
        raise NotProved(f"not proved: η = {eta.str(8)} is not below β = {beta.str(8)}")
    _at_most_one_below(beta, block, lam, mu, size)
    low = (eta - upper(residual) / (beta - eta)).lower()
    return low.union(eta), beta, vector


def _eigenvector(block: list[list[fmpq]], floats: Array, value: float, digits: int) -> list[arb]:
    """Inverse iteration with a shift close by: each step gains some nine digits."""
    size = len(block)
    shift = arb(float(value) - 1e-9 * (1 + abs(float(value))))
    matrix = arb_mat([[arb(x) - (shift if i == j else 0) for j, x in enumerate(row)]
                      for i, row in enumerate(block)])
    inverse = arb_mat([[x.mid() for x in row] for row in matrix.inv().tolist()])
    v = arb_mat([[arb(float(x))] for x in np.linalg.eigh(floats)[1][:, 0]])
    for _ in range(2 + digits // 12):
        v = inverse * v
        largest = max(v.tolist(), key=lambda row: float(abs(row[0]).mid()))[0]
        v = arb_mat([[(row[0] / largest).mid()] for row in v.tolist()])
    return [v[i, 0] for i in range(size)]


def _at_most_one_below(beta: arb, block: list[list[fmpq]], lam: fmpq, mu: fmpq, size: int) -> None:
    """Raise :class:`NotProved` unless the pivots show one negative eigenvalue."""
    c = arb(lam**2 / 2 + abs(lam**4 * mu) / 2)
    tau = (2 * size + 1) ** 2 - 2 * c - beta
    if not tau > 0:
        raise NotProved(f"not proved: N = {size} is too small, τ = {tau.str(5)}")
    shift = beta + c**2 / tau
    rows = [[arb(x) - (shift if i == j else 0) for j, x in enumerate(row)]
            for i, row in enumerate(block)]
    negative = 0
    for k in range(size):
        pivot = rows[k][k]
        if not (pivot > 0 or pivot < 0):
            raise NotProved(f"not proved: the sign of pivot {k} is open, {pivot.str(5)}")
        negative += bool(pivot < 0)
        for i in range(k + 1, min(k + 3, size)):                       # five diagonals
            factor = rows[i][k] / pivot
            for j in range(k + 1, min(k + 3, size)):
                rows[i][j] -= factor * rows[k][j]
    if negative != 1:
        raise NotProved(f"not proved: {negative} eigenvalues below β = {beta.str(8)} instead of 1")
