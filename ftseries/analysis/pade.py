r"""Padé approximants, with their defects reported.

Formula.  [L/M](z) = p(z)/q(z) with deg p ≤ L, deg q ≤ M, q(0) = 1 and q f - p = O(z^{L+M+1}). The
denominator solves the Hankel system Σ_{j=1}^{M} c_{L+i-j} q_j = -c_{L+i}, i = 1 … M, here in ball
arithmetic whose precision is raised until the balls are small.  Where that system is singular, a
lower M may do for all L+M+1 coefficients (the function looks rational); if none does, no [L/M]
matches them, and the entry of the table nearest on the antidiagonal L+M does: the last of them is
the Taylor polynomial. A pole that almost meets a zero (a Froissart doublet) is a *defect*: it
belongs to the rounding of the coefficients or to chance, not to the function.
(G. A. Baker and P. Graves-Morris, Padé Approximants, 1996.)
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from flint import acb, acb_poly, arb, arb_mat, arb_poly, fmpq, fmpq_mat

from ..aliases import ArrayLike, ComplexArray, Number
from ..errors import InputError
from ..precision import working
from .singularities import _numbers

__all__ = ["Pade", "pade"]

_BITS, _MOST_BITS = 256, 2**14
#: coefficients of p and of q
Polynomials: TypeAlias = tuple[list[arb], list[arb]]

#: the balls of p and q must be this good, or below the second bound
_GOOD, _TINY = 80, 2.0**-200


class Pade:
    """The approximant p/q; callable on numbers and arrays.

    Attributes
    ----------
    numerator, denominator : numpy.ndarray
        Coefficients of p and q, lowest first, as floats.
    degrees : tuple
        (L, M) as found.
    asked : tuple
        (L, M) as asked; where it differs, that entry lies in a singular block of the table, and
        this is the nearest one that matches the same coefficients.
    known : int
        How many coefficients it matches.
    """

    def __init__(self, numerator: Sequence[arb], denominator: Sequence[arb],
                 asked: tuple[int, int], known: int) -> None:
        self.exact = [x.mid() for x in numerator], [x.mid() for x in denominator]
        self.numerator = np.array([float(x) for x in numerator])
        self.denominator = np.array([float(x) for x in denominator])
        self.degrees, self.asked = (len(numerator) - 1, len(denominator) - 1), asked
        self.known = known
        self._p, self._q = arb_poly(self.exact[0]), arb_poly(self.exact[1])

    def __repr__(self) -> str:
        asked = "" if self.asked == self.degrees else \
            f", for [{self.asked[0]}/{self.asked[1]}] in a singular block"
        return f"<Padé approximant [{self.degrees[0]}/{self.degrees[1]}]{asked}>"

    def __call__(self, z: ArrayLike) -> Any:
        """The value; infinite at a pole.

        A single number is evaluated in ball arithmetic and rounded once.  Arrays are evaluated in
        float64, which loses the digits that cancel in q.
        """
        z = np.asarray(z)
        if z.ndim == 0:
            return self._value(z[()])
        with np.errstate(divide="ignore", invalid="ignore"):
            return (np.polynomial.polynomial.polyval(z, self.numerator)
                    / np.polynomial.polynomial.polyval(z, self.denominator))

    def rounding(self, z: ArrayLike) -> Any:
        """About the relative error that rounding leaves in the value: more in arrays."""
        z = np.asarray(z)
        if z.ndim == 0:
            return 2.0**-53
        sums = [np.polynomial.polynomial.polyval(abs(z), np.abs(part))
                / np.abs(np.polynomial.polynomial.polyval(z, part))
                for part in (self.numerator, self.denominator)]
        return 2.0**-53 * (1 + sum(self.degrees)) * sum(sums)

    def _value(self, z: Any) -> Any:
        real = not np.iscomplexobj(z)
        with working(bits=_BITS):
            z = arb(float(z)) if real else acb(complex(z))
            q = self._q(z)
            if abs(q) < arb(2) ** (-_BITS // 2):
                return np.float64(np.inf)
            value = self._p(z) / q
            return np.float64(value) if real else np.complex128(complex(value))

    def poles(self) -> ComplexArray:
        """The zeros of q, nearest first, as complex numbers."""
        return self._roots(1)

    def zeros(self) -> ComplexArray:
        """The zeros of p, nearest first."""
        return self._roots(0)

    def defects(self, distance: float = 1e-4) -> list[complex]:
        """The poles that have a zero within ``distance`` times their modulus.

        Of 1/(1 - z/2) + 1e-9/(1 - z) the pole at 1 is next to nothing, and met by a zero:

        >>> approximant = pade([fmpq(1, 2**k) + fmpq(1, 10**9) for k in range(4)], 1, 2)
        >>> approximant.poles().real.round(6), len(approximant.defects())
        (array([1., 2.]), 1)
        """
        zeros = self.zeros()
        return [pole for pole in self.poles()
                if zeros.size and np.abs(zeros - pole).min() < distance * abs(pole)]

    def _roots(self, which: int) -> ComplexArray:
        with working(bits=_BITS):
            polynomial = acb_poly(self.exact[which])
            if polynomial.degree() < 1:
                return np.array([], dtype=complex)
            roots: Any
            try:
                roots = polynomial.roots(tol=2.0**-60, maxprec=_MOST_BITS)
            except ValueError:                              # a root of higher multiplicity
                roots = np.roots([complex(x) for x in polynomial.coeffs()[::-1]])
        return np.array(sorted(map(complex, roots), key=lambda r: (abs(r), r.imag)))


def pade(c: Sequence[Number], upper: int | None = None, lower: int | None = None) -> Pade:
    """The approximant [upper/lower] of a series.

    Parameters
    ----------
    c : sequence
        Taylor coefficients: floats, fmpq, or balls; of a ball its middle.
    upper, lower : int, optional
        L and M; left out, the diagonal one that uses all coefficients.

    Raises
    ------
    InputError
        Fewer than L + M + 1 coefficients, or one that is not finite.

    Examples
    --------
    >>> log = [fmpq(0)] + [fmpq((-1) ** (k + 1), k) for k in range(1, 21)]     # ln(1 + z)
    >>> bool(abs(pade(log)(1.0) - np.log(2)) < 1e-14)
    True
    """
    total = len(c) - 1
    if lower is None:
        lower = total // 2 if upper is None else total - upper
    upper = total - lower if upper is None else upper
    if total < 0 or min(upper, lower) < 0 or upper + lower > total:
        raise InputError(f"[{upper}/{lower}] needs {max(upper + lower + 1, 1)} coefficients, "
                         f"not {len(c)}")
    c, asked = list(c[:upper + lower + 1]), (upper, lower)
    _numbers(c)                                             # refuses what is not finite
    found = _solve(c, upper, lower) or _reduced(c, upper, lower)
    for step in range(1, total + 1):
        if found is None and step <= lower:
            found = _solve(c, upper + step, lower - step)
        if found is None and step <= upper:
            found = _solve(c, upper - step, lower + step)
    assert found is not None                                # the Taylor polynomial always is there
    return Pade(*found, asked, len(c))


def _reduced(c: Sequence[Number], upper: int, lower: int) -> Polynomials | None:
    """[upper/M] with M < lower, if it matches all the coefficients."""
    for smaller in range(lower - 1, -1, -1):
        if (found := _solve(c, upper, smaller)) is not None:
            return found if _matches(c, *found) else None
    return None


def _matches(c: Sequence[Number], p: Sequence[arb], q: Sequence[arb]) -> bool:
    """Are all coefficients those of p/q?"""
    with working(bits=_MOST_BITS):
        known = arb_poly([arb(x).mid() if isinstance(x, arb) else arb(x) for x in c])
        rest = (known * arb_poly(list(q))).truncate(len(c)) - arb_poly(list(p))
        return all(x.contains(0) for x in rest.coeffs())


def _solve(c: Sequence[Number], upper: int, lower: int) -> Polynomials | None:
    """Coefficients of p and q as balls, or None in a singular block."""
    bits = _BITS
    while bits <= _MOST_BITS:
        with working(bits=bits):
            balls = [arb(x).mid() if isinstance(x, arb) else arb(x) for x in c]
            q = _denominator(balls, upper, lower)
            if q is not None:
                p = (arb_poly(balls) * arb_poly(q)).truncate(upper + 1).coeffs()
                p += [arb(0)] * (upper + 1 - len(p))
                if all(x.rel_accuracy_bits() > _GOOD or x.abs_upper() < _TINY for x in p + q):
                    return p, q
        if q is None and bits == _BITS and _singular(c, upper, lower):
            return None
        bits *= 2
    return None


def _denominator(c: Sequence[Number], upper: int, lower: int) -> list[arb] | None:
    """q_0 … q_M, or None where the balls cannot tell the system from a singular one."""
    if lower == 0:
        return [arb(1)]
    table = _hankel(c, upper, lower)
    try:
        solution = arb_mat([row[1:] for row in table]).solve(arb_mat([[-row[0]] for row in table]))
    except ZeroDivisionError:
        return None
    return [arb(1)] + [solution[i, 0] for i in range(lower)]


def _singular(c: Sequence[Number], upper: int, lower: int) -> bool:
    """Is the system singular in exact arithmetic?"""
    exact = [x if isinstance(x, fmpq) else _rational(x) for x in c]
    rows = [x for row in _hankel(exact, upper, lower) for x in row[1:]]
    return fmpq_mat(lower, lower, rows).det() == 0


def _rational(x: Number) -> fmpq:
    mantissa, exponent = arb(x).mid().man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)


def _hankel(c: Sequence[Number], upper: int, lower: int) -> list[list[Number]]:
    return [[c[upper + i - j] if upper + i >= j else 0 * c[0] for j in range(lower + 1)]
            for i in range(1, lower + 1)]
