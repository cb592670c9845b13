r"""The figure eight solution of the three body problem, section 4 of the paper.

Index convention and formula.  With the ansatz (E5) for r_12 = r and φ_12 = φ,

.. math::  r(t) = \sum_{n \ge 0} \sum_{m \ge n} λ^{2m} A_{2n,2m} \cos 2nt, \qquad
           φ(t) = λ \cos t + \sum_{n \ge 1} \sum_{m \ge n} λ^{2m+1} B_{2n+1,2m+1} \cos (2n+1)t,

and r_23(t) = r(t - 2π/3), r_31(t) = r(t + 2π/3), likewise φ.  Lengths are measured in 3^{1/3}; then
all coefficients are rational and the force of the two others carries the factor 1/3.
"""

import warnings

import numpy as np
import sympy as sp
from scipy.optimize import brentq

from ..errors import ConvergenceWarning, FTSeriesError, InputError
from ..problem import Field, Problem
from ..series import cos, sin
from ..trig import finite

__all__ = ["FigureEight", "relative", "positions", "closure", "closure_zero"]


class FigureEight(Problem):
    """The family of periodic solutions of (E3a), (E3b); physical where the closure (E4) vanishes.

    Examples
    --------
    >>> import ftseries as fts
    >>> sol = fts.solve(fts.FigureEight(), order=6)
    >>> sol.coefficient("r", 2, 6), sol.coefficient("phi", 3, 5)          # (E6b), (E6d)
    (5*3**(1/3)/4096, -1/512)
    """

    unknowns = {"r": Field("cos", modes="even", powers="even"),
                "phi": Field("cos", modes="odd", powers="odd", fixed=(1,))}
    seed = {"r": [{0: 1}], "phi": [{}, {1: 1}]}

    def equations(self, lam, r, phi):
        c, s = cos(phi), sin(phi)
        force = r**-2
        # cos(φ12-φ31)/r31² + cos(φ12-φ23)/r23² = cos φ12 · x + sin φ12 · y, and sin likewise
        x, y = (force * c).neighbours(), (force * s).neighbours()
        return {
            "(E3a)": r.diff(2) - r * phi.diff()**2 + (2 * force - (c * x + s * y)) / 3,
            "(E3b)": r * phi.diff(2) + 2 * r.diff() * phi.diff() + (s * x - c * y) / 3,
        }

    def first_lam(self, solution):
        return closure_zero(solution)

    def condition(self, lam, r, phi):
        """Its mean is S_x/3, so it vanishes at the physical λ (E4)."""
        return r * cos(phi)

    def scale(self, name):
        return sp.cbrt(3) if name == "r" else sp.S.One


def relative(sol, t, lam):
    """r_12, r_23, r_31 of (E2), (E5b), (E5d) as complex numbers, shape (3,) + t.shape.

    Arguments as for :func:`positions`.
    """
    if not isinstance(getattr(sol, "problem", None), FigureEight):
        raise InputError(f"{sol!r} is not a figure eight; solve FigureEight() first")
    times = finite("t", t)[..., *(None,) * np.ndim(lam)]
    times = np.stack([times, times - 2 * np.pi / 3, times + 2 * np.pi / 3])
    return sol.evaluate("r", times, lam=lam) * np.exp(1j * sol.evaluate("phi", times, lam=lam))


def positions(sol, t, lam):
    """The three bodies by (E4a), as complex numbers x + iy.

    Parameters
    ----------
    sol : Solution
        A solution of :class:`FigureEight`.
    t : array_like
        Times; the period is 2π.
    lam : float
        The series parameter; the bodies obey Newton's equations where :func:`closure` vanishes.
        An array of values adds its shape at the end of the result's.

    Returns
    -------
    numpy.ndarray
        Complex, of shape (3,) + t.shape: r_1, r_2, r_3.

    Examples
    --------
    >>> import ftseries as fts
    >>> sol = fts.solve(fts.FigureEight(), order=6)
    >>> r1, r2, r3 = fts.figure_eight.positions(sol, 0.0, 2.09)
    >>> bool(abs(r3) < 1e-12)                                   # body 3 starts at the origin
    True
    """
    r12, r23, r31 = relative(sol, t, lam)
    return np.stack([r12 - r31, r23 - r12, r31 - r23]) / 3


def closure(sol, lam):
    """S_x of (E4) at t = 0: r12 cos φ12 + r23 cos φ23 + r31 cos φ31, with numbers put into r and φ.

    ``lam`` may be an array; the result has its shape.
    """
    return relative(sol, 0.0, lam).real.sum(axis=0)


def closure_zero(sol, search=(0.0, 4.0)):
    """λ_n of the paper: the smallest positive zero of :func:`closure` for this truncation.

    Raises
    ------
    FTSeriesError
        No zero in ``search``.

    Examples
    --------
    >>> import ftseries as fts
    >>> round(fts.figure_eight.closure_zero(fts.solve(fts.FigureEight(), order=6)), 5)
    2.09531
    """
    if np.shape(search) != (2,):
        raise InputError(f"search={search!r}: give the two ends of an interval of λ")
    lam = np.linspace(*finite("search", search), 801)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ConvergenceWarning)       # the search goes past the zero
        sign = np.sign(closure(sol, lam))
        change = np.flatnonzero(sign[:-1] * sign[1:] <= 0)
        if not change.size:
            raise FTSeriesError(f"S_x has no zero for {search[0]} < λ < {search[1]} at order "
                                f"{sol.order}; take a higher order or another search interval")
        left, right = lam[change[0]:change[0] + 2]
        return float(brentq(lambda x: float(closure(sol, x)), left, right,
                            xtol=1e-15, rtol=1e-15))
