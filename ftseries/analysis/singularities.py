r"""Singularities and radius of convergence from Taylor coefficients.

Formula.  If f(z) = Σ c_k z^k has J singularities z_i of one type (1 - z/z_i)^s on its circle of
convergence and none nearer, Darboux's theorem gives c_k ≈ Σ_i C_i z_i^{-k} k^{-s-1} (1 + O(1/k)),
so the coefficients obey

.. math::  c_{k+1} = \sum_{i=0}^{J-1} \Big( α_i + \frac{β_i}{k} + \frac{γ_i}{k^2} + … \Big) c_{k-i},

where the z_i are the reciprocal roots of ζ^J = Σ α_i ζ^{J-1-i} and s + 1 = -β_0/α_0.  With J = 1
and two terms this is the plot of Domb and Sykes; J = 2 finds a complex pair.  (C. Domb and
M. F. Sykes, Proc. R. Soc. A 240 (1957) 214; P. Flajolet and R. Sedgewick, Analytic Combinatorics,
chapter VI.)
"""

from dataclasses import dataclass

import mpmath

from ..errors import InputError

__all__ = ["Estimate", "Singularity", "thin", "root_test", "domb_sykes", "nearest_singularities"]

#: decimal digits for exact coefficients; the linear systems are small but badly conditioned
DIGITS = 120
#: an exponent beyond this is a fit of nothing
_STEEPEST = 10


@dataclass(frozen=True)
class Estimate:
    """A number with the uncertainty that the spread of its own variants suggests."""

    value: float
    error: float

    def __str__(self):
        return f"{self.value:.12g} ± {self.error:.1e}"

    def __float__(self):
        return self.value


@dataclass(frozen=True)
class Singularity:
    """A singularity (1 - z/location)^exponent; the errors come from varying the fit."""

    location: complex
    exponent: float
    error: float
    exponent_error: float

    @property
    def radius(self):
        return Estimate(abs(self.location), self.error)


def thin(c):
    """(step, first, d): the coefficients without their regular zeros, c_{first + k step} = d_k.

    >>> thin([0, 1, 0, -2, 0, 3])
    (2, 1, [1, -2, 3])
    """
    support = [k for k, value in enumerate(c) if value != 0]
    if not support:
        raise InputError("all coefficients are zero; there is nothing to analyse")
    step = 0
    for k in support:
        step = _gcd(step, k - support[0])
    step = step or 1
    return step, support[0], list(c[support[0]::step])


def _gcd(a, b):
    while b:
        a, b = b, a % b
    return a


def root_test(c):
    """Pairs (k, |c_k|^{-1/k}) for every non-zero coefficient but the first."""
    return [(k, float(abs(_mp(x)) ** (mpmath.mpf(-1) / k)))
            for k, x in enumerate(c) if k and x != 0]


def domb_sykes(c):
    """The points (1/k, c_k/c_{k-1}) of the plot of Domb and Sykes, zeros left out.

    >>> domb_sykes([1, 2, 4, 8])
    [(1.0, 2.0), (0.5, 2.0), (0.3333333333333333, 2.0)]
    """
    return [(1 / k, float(_mp(c[k]) / _mp(c[k - 1])))
            for k in range(1, len(c)) if c[k] != 0 and c[k - 1] != 0]


def nearest_singularities(c, count=None):
    """The singularities on the circle of convergence: one real one, or a complex pair.

    Parameters
    ----------
    c : sequence
        Taylor coefficients from order 0 on: floats, fmpq, SymPy or mpmath numbers; none of them
        regularly zero (see :func:`thin`).
    count : 1 or 2, optional
        How many to look for; left out, whichever fits better.

    Returns
    -------
    list of Singularity

    Raises
    ------
    InputError
        Fewer than 10 coefficients.

    Examples
    --------
    The square root sqrt(1 - z/2) has its branch point at 2:

    >>> from flint import fmpq
    >>> c = [fmpq(1)]
    >>> for k in range(1, 40):
    ...     c.append(c[-1] * fmpq(2 * k - 3, 4 * k))
    >>> (s,) = nearest_singularities(c)
    >>> round(s.location.real, 10), round(s.exponent, 6)
    (2.0, 0.5)
    """
    if len(c) < 10:
        raise InputError(f"{len(c)} coefficients are too few to locate a singularity; give 10")
    if count not in (None, 1, 2):
        raise InputError(f"count={count!r}: choose 1, 2 or None")
    floating = any(isinstance(x, float) for x in c)
    fits = [fit for j in ((count,) if count else (1, 2)) if (fit := _fit(c, j, floating))]
    if not fits:
        raise InputError("no single singularity or pair explains these coefficients; give more")
    return min(fits, key=lambda fit: fit[0].error / abs(fit[0].location))


def _fit(c, count, floating):
    """The singularities of one count, with the spread over fits of neighbouring size."""
    most = len(c) // (2 * count) - 1
    depths = range(2, min(4 if floating else 14, most) + 1)
    results = []
    with mpmath.workdps(30 if floating else DIGITS):
        c = [_mp(x) for x in c]
        for depth in depths:
            try:
                here = [_solve(c, count, depth, len(c) - 1 - back) for back in (0, 1, 2)]
            except ZeroDivisionError:
                continue
            location = here[0][0]
            spread = max(abs(other[0] - location) for other in here[1:])
            if results:
                spread = max(spread, abs(results[-1][0] - location))
                exponent_spread = max([abs(results[-1][1] - here[0][1])]
                                      + [abs(o[1] - here[0][1]) for o in here[1:]])
            else:
                exponent_spread = max(abs(o[1] - here[0][1]) for o in here[1:])
            results.append((location, here[0][1], spread, exponent_spread))
    results = [r for r in results if abs(r[1]) < _STEEPEST and r[0] != 0]
    if not results:
        return None
    location, exponent, spread, exponent_spread = min(results, key=lambda r: r[2] / abs(r[0]))
    found = [Singularity(complex(location), float(exponent), float(spread), float(exponent_spread))]
    if count == 2:
        found.append(Singularity(complex(location).conjugate(), float(exponent), float(spread),
                                 float(exponent_spread)))
    return found


def _solve(c, count, depth, last):
    """(location, exponent) from the last count·depth equations that end with c_last."""
    size = count * depth
    matrix, right = mpmath.matrix(size), mpmath.matrix(size, 1)
    for row in range(size):
        k = last - 1 - row
        right[row] = c[k + 1]
        for i in range(count):
            for power in range(depth):
                matrix[row, i * depth + power] = c[k - i] / mpmath.mpf(k) ** power
    solution = mpmath.lu_solve(matrix, right)
    alpha = [solution[i * depth] for i in range(count)]
    exponent = -solution[1] / alpha[0] - 1
    if count == 1:
        return 1 / alpha[0], exponent
    root = mpmath.sqrt(mpmath.mpc(alpha[0] ** 2 + 4 * alpha[1]))
    zeta = max(((alpha[0] + root) / 2, (alpha[0] - root) / 2), key=abs)
    location = 1 / zeta
    return mpmath.mpc(location.real, abs(location.imag)), exponent


def _mp(x):
    if hasattr(x, "p") and hasattr(x, "q"):
        return mpmath.mpf(int(x.p)) / int(x.q)
    if hasattr(x, "mid") and hasattr(x, "rad"):
        mantissa, exponent = x.mid().man_exp()
        return mpmath.mpf(int(mantissa)) * mpmath.mpf(2) ** int(exponent)
    return mpmath.mpmathify(x)
