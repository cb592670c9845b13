r"""The figure eight solution of the three body problem, section 4 of the paper, and other forces.

Index convention and formula.  With the ansatz (E5) for r_12 = r and φ_12 = φ,

.. math::  r(t) = \sum_{n \ge 0} \sum_{m \ge n} λ^{2m} A_{2n,2m} \cos 2nt, \qquad
           φ(t) = λ \cos t + \sum_{n \ge 1} \sum_{m \ge n} λ^{2m+1} B_{2n+1,2m+1} \cos (2n+1)t,

and r_23(t) = r(t - 2π/3), r_31(t) = r(t + 2π/3), likewise φ.  Two bodies at the distance d attract
each other with the force d^{-(α+1)}, gravitation having α = 1.  Lengths are measured in the ℓ at
which the force is ℓ/3, that is 3^{1/(α+2)}; then the force is 1 at the length 1, all coefficients
are rational, and the two others pull with the factor 1/3.  With Z = r e^{iφ} and Q, which
drops the Fourier modes that are multiples of 3, the equations are one: Z'' = -Q(Z/|Z|^{α+2}).
"""

from __future__ import annotations

import warnings
from fractions import Fraction
from typing import Any

import numpy as np
import sympy as sp
from scipy.optimize import brentq
from scipy.special import ellipk

from ..aliases import ArrayLike, Exact, Expr, Function, Json, Real
from ..arguments import real
from ..errors import ConvergenceWarning, FTSeriesError, InputError
from ..expressions import expression, quoted
from ..problem import Field, Problem
from ..series import cos, sin

__all__ = ["FigureEight", "LemniscateEight", "PlanarEight", "relative", "positions", "closure",
           "closure_zero"]

#: the longest interval in which a zero of the closure is searched, in steps of 0.01
_SEARCH = 8


class FigureEight(Problem):
    """The family of periodic solutions of (E3a), (E3b); physical where the closure (E4) vanishes.

    Parameters
    ----------
    exponent : int, Fraction, float or text
        α > -2 of the force d^{-(α+1)}, a rational number: 1 is gravitation, 0 the force 1/d of the
        logarithmic potential.  For other laws of force, override :meth:`force` and :meth:`scale`.

    Examples
    --------
    >>> import ftseries as fts
    >>> sol = fts.solve(fts.FigureEight(), order=6)
    >>> sol.coefficient("r", 2, 6), sol.coefficient("phi", 3, 5)          # (E6b), (E6d)
    (5*3**(1/3)/4096, -1/512)
    >>> fts.solve(fts.FigureEight(exponent=0), order=2).coefficient("r", 2, 2)
    3*sqrt(3)/20
    """

    unknowns = {"r": Field("cos", modes="even", powers="even"),
                "phi": Field("cos", modes="odd", powers="odd", fixed=(1,))}
    seed = {"r": [{0: 1}], "phi": [{}, {1: 1}]}

    def __init__(self, exponent: Exact = 1) -> None:
        self.exponent = expression(exponent)
        if not (self.exponent.is_Rational and self.exponent > -2):
            raise InputError(f"exponent={quoted(exponent)}: give a rational number above -2")

    def force(self, r: Function) -> Function:
        """The attraction at the distance r, in units in which it is 1 at r = 1."""
        return r**-(self.exponent + 1)

    def equations(  # type: ignore[override]     # the unknowns by name
            self, lam: Function, r: Function, phi: Function) -> dict[str, Function]:
        c, s = cos(phi), sin(phi)
        force = self.force(r)
        # cos(φ12-φ31)/r31² + cos(φ12-φ23)/r23² = cos φ12 · x + sin φ12 · y, and sin likewise
        x, y = (force * c).neighbours(), (force * s).neighbours()
        return {
            "(E3a)": r.diff(2) - r * phi.diff()**2 + (2 * force - (c * x + s * y)) / 3,
            "(E3b)": r * phi.diff(2) + 2 * r.diff() * phi.diff() + (s * x - c * y) / 3,
        }

    def vector(self, sol: Any, t: ArrayLike, lam: ArrayLike) -> Any:
        """r_12 at times t, complex."""
        return sol.evaluate("r", t, lam=lam) * np.exp(1j * sol.evaluate("phi", t, lam=lam))

    def first_lam(self, solution: Any) -> float:
        return closure_zero(solution)

    def condition(  # type: ignore[override]
            self, lam: Function, r: Function, phi: Function) -> Function:
        """Its mean is S_x/3, so it vanishes at the physical λ (E4)."""
        return r * cos(phi)

    def scale(self, name: str) -> Expr:
        return sp.Integer(3) ** (1 / (self.exponent + 2)) if name == "r" else sp.S.One

    def arguments(self) -> dict[str, Json]:
        return {} if self.exponent == 1 else {"exponent": str(self.exponent)}


class PlanarEight(FigureEight):
    """The same motions in Cartesian coordinates, r_12 = x + iy, where λ is the amplitude of cos t.

    The series converges only just at the physical λ, but Newton's method (``Orbit.refine``) does
    from further away, and with fewer modes where two bodies come close: φ jumps there, Z does not.

    Examples
    --------
    >>> import ftseries as fts
    >>> sol = fts.solve(PlanarEight(), order=4)
    >>> sol.coefficient("x", 2, 2)
    -3**(2/3)/24
    """

    unknowns = {"x": Field("cos", modes="even", powers="even"),
                "y": Field("cos", modes="odd", powers="odd", fixed=(1,))}
    seed = {"x": [{0: 1}], "y": [{}, {1: 1}]}

    def equations(  # type: ignore[override]
            self, lam: Function, x: Function, y: Function) -> dict[str, Function]:
        r = (x * x + y * y) ** Fraction(1, 2)
        pull = self.force(r) / r
        residuals = {}
        for name, u in (("x", x), ("y", y)):
            force = pull * u
            residuals[name] = u.diff(2) + (2 * force - force.neighbours()) / 3
        return residuals

    def vector(self, sol: Any, t: ArrayLike, lam: ArrayLike) -> Any:
        return sol.evaluate("x", t, lam=lam) + 1j * sol.evaluate("y", t, lam=lam)

    def condition(  # type: ignore[override]
            self, lam: Function, x: Function, y: Function) -> Function:
        return x

    @property
    def lam_scale(self) -> Expr:
        return super().scale("r")

    def scale(self, name: str) -> Expr:
        return super().scale("r")


class ExpandedEight(PlanarEight):
    """What :func:`ftseries.figure_eight.expanded` gives; λ is the angle's, as in (E5c)."""

    unknowns = {"x": Field("cos", modes="even", powers="even"),
                "y": Field("cos", modes="odd", powers="odd")}

    @property
    def lam_scale(self) -> Expr:
        return sp.S.One


class LemniscateEight(FigureEight):
    """The eight of T. Fujiwara, H. Fukuda, H. Ozaki, which moves on Bernoulli's lemniscate.

    The pair potential is ½ ln d - (√3/24) d², and the period 4K(k²) with k² = (2 + √3)/4; in the
    time in which it is 2π the equation is W Z'' = -3 Q(Z (1/(2|Z|²) - √3/12)), W = (π/2K)².  In
    units ℓ the force is (1 + β)/r - βr with β = √3/(4W), which is rounded to float64.

    Examples
    --------
    >>> import ftseries as fts
    >>> sol = fts.solve(LemniscateEight(), order=60, arithmetic="float")
    >>> round(fts.figure_eight.closure_zero(sol), 2)                # 2.08304 on the lemniscate
    2.08
    """

    def __init__(self) -> None:
        super().__init__(exponent=0)
        W = (np.pi / (2 * ellipk((2 + np.sqrt(3)) / 4))) ** 2
        self.beta = float(np.sqrt(3) / (4 * W))
        self.length = float(np.sqrt(3 / (2 * W * (1 + self.beta))))

    def force(self, r: Function) -> Function:
        return (1 + self.beta) / r - self.beta * r

    def scale(self, name: str) -> Expr:
        return sp.Float(self.length) if name == "r" else sp.S.One

    def arguments(self) -> dict[str, Json]:
        return {}


def is_gravitational(sol: Any) -> bool:
    """Whether ``sol`` belongs to the problem FigureEight() itself, not to a relative of it."""
    problem = getattr(sol, "problem", None)
    return type(problem) is FigureEight and bool(problem.exponent == 1)


def relative(sol: Any, t: ArrayLike, lam: ArrayLike) -> Any:
    """r_12, r_23, r_31 of (E2), (E5b), (E5d) as complex numbers, shape (3,) + t.shape.

    Arguments as for :func:`positions`.
    """
    if not isinstance(getattr(sol, "problem", None), FigureEight):
        raise InputError(f"{sol!r} is not a figure eight; solve FigureEight() first")
    times = real("t", t)[..., *(None,) * np.ndim(lam)]
    times = np.stack([times, times - 2 * np.pi / 3, times + 2 * np.pi / 3])
    return sol.problem.vector(sol, times, lam)


def positions(sol: Any, t: ArrayLike, lam: ArrayLike) -> Any:
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


def closure(sol: Any, lam: ArrayLike) -> Real:
    """S_x of (E4) at t = 0: r12 cos φ12 + r23 cos φ23 + r31 cos φ31, with numbers put into r and φ.

    ``lam`` may be an array; the result has its shape.
    """
    return relative(sol, 0.0, lam).real.sum(axis=0)


def closure_zero(sol: Any, search: tuple[float, float] = (0.0, 4.0)) -> float:
    """λ_n of the paper: the smallest positive zero of :func:`closure` for this truncation.

    Parameters
    ----------
    sol : Solution
    search : pair of numbers
        The two ends of an interval of λ, at most 8 apart.

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
    low, high = real("search", search)
    if not low < high:
        raise InputError(f"search={search!r}: give the two ends of an interval, the lower one "
                         "first")
    if high - low > _SEARCH:
        raise InputError(f"search={search!r}: give an interval of length {_SEARCH} at most; in a "
                         "longer one the steps of the search pass over zeros")
    lam = np.linspace(low, high, 801)
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
