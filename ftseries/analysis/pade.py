r"""Padé approximants, with their defects reported.

Formula.  [L/M](z) = p(z)/q(z) with deg p ≤ L, deg q ≤ M, q(0) = 1 and q f - p = O(z^{L+M+1}).  The
denominator solves the Hankel system Σ_{j=1}^{M} c_{L+i-j} q_j = -c_{L+i}, i = 1 … M, here in ball
arithmetic whose precision is raised until the balls are small.  In a singular block of the table
M is lowered to the nearest solvable entry.  A pole that almost meets a zero (a Froissart doublet)
is a *defect*: it belongs to the rounding of the coefficients or to chance, not to the function.
(G. A. Baker and P. Graves-Morris, Padé Approximants, 1996.)
"""

import mpmath
import numpy as np
from flint import arb, arb_mat, arb_poly, ctx, fmpq, fmpq_mat

from ..errors import InputError

__all__ = ["Pade", "pade"]

_MOST_BITS = 2**15


class Pade:
    """The approximant p/q; callable on numbers and arrays.

    Attributes
    ----------
    numerator, denominator : numpy.ndarray
        Coefficients of p and q, lowest first, as floats.
    degrees : tuple
        (L, M) as found; M may be lower than asked in a singular block.
    """

    def __init__(self, numerator, denominator):
        self.exact = numerator, denominator
        self.numerator = np.array([float(x) for x in numerator])
        self.denominator = np.array([float(x) for x in denominator])
        self.degrees = len(numerator) - 1, len(denominator) - 1

    def __repr__(self):
        return f"<Padé approximant [{self.degrees[0]}/{self.degrees[1]}]>"

    def __call__(self, z):
        """The value; infinite at a pole."""
        z = np.asarray(z)
        with np.errstate(divide="ignore", invalid="ignore"):
            value = (np.polynomial.polynomial.polyval(z, self.numerator)
                     / np.polynomial.polynomial.polyval(z, self.denominator))
        return value[()]

    def poles(self):
        """The zeros of q, nearest first, as complex numbers."""
        return self._roots(1)

    def zeros(self):
        """The zeros of p, nearest first."""
        return self._roots(0)

    def defects(self, distance=1e-6):
        """The poles that have a zero within ``distance`` times their modulus."""
        zeros = self.zeros()
        return [pole for pole in self.poles()
                if zeros.size and np.abs(zeros - pole).min() < distance * abs(pole)]

    def _roots(self, which):
        coefficients = [mpmath.mpf(x.mid().str(60, radius=False)) for x in self.exact[which]]
        while coefficients and coefficients[-1] == 0:
            coefficients.pop()
        if len(coefficients) < 2:
            return np.array([], dtype=complex)
        with mpmath.workdps(60):
            roots = mpmath.polyroots(coefficients[::-1], maxsteps=500, extraprec=400)
        return np.array(sorted((complex(r) for r in roots), key=lambda r: (abs(r), r.imag)))


def pade(c, upper=None, lower=None):
    """The approximant [upper/lower] of a series.

    Parameters
    ----------
    c : sequence
        Taylor coefficients: floats, fmpq, or balls.
    upper, lower : int, optional
        L and M; left out, the diagonal one that uses all coefficients.

    Raises
    ------
    InputError
        Fewer than L + M + 1 coefficients.

    Examples
    --------
    >>> from flint import fmpq
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
    c = [x if isinstance(x, (fmpq, arb)) else arb(x) for x in c[:upper + lower + 1]]
    while True:
        found = _solve(c, upper, lower)
        if found is not None:
            return Pade(*found)
        lower -= 1


def _solve(c, upper, lower):
    """Coefficients of p and q as balls, or None in a singular block."""
    bits, exact = 256, all(isinstance(x, fmpq) or x.is_exact() for x in c)
    while bits <= _MOST_BITS:
        with ctx.workprec(bits):
            balls = [arb(x) for x in c]
            q = _denominator(balls, upper, lower)
            if q is not None:
                p = (arb_poly(balls) * arb_poly(q)).truncate(upper + 1).coeffs()
                p += [arb(0)] * (upper + 1 - len(p))
                if not exact or all(x.rel_accuracy_bits() > 80 or x.abs_upper() < 2**-200
                                    for x in p + q):
                    return p, q
            elif all(isinstance(x, fmpq) for x in c) and _hankel(c, upper, lower).det() == 0:
                return None
        bits *= 2
    return None


def _hankel(c, upper, lower):
    rows = [[c[upper + i - j] if upper + i >= j else fmpq(0) for j in range(1, lower + 1)]
            for i in range(1, lower + 1)]
    return fmpq_mat(lower, lower, [x for row in rows for x in row])


def _denominator(c, upper, lower):
    if lower == 0:
        return [arb(1)]
    at = [[c[upper + i - j] if upper + i >= j else arb(0) for j in range(lower + 1)]
          for i in range(1, lower + 1)]
    try:
        solution = arb_mat([row[1:] for row in at]).solve(arb_mat([[-row[0]] for row in at]))
    except ZeroDivisionError:
        return None
    return [arb(1)] + [solution[i, 0] for i in range(lower)]
