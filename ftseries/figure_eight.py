"""The figure eight in one place: the three bodies, the closure, and its certified digits."""

from typing import Any

from .certify.digits import digits, load_digits, thousand_digits
from .errors import InputError
from .expansion import Expansion
from .laurent import RationalRing
from .problems.figure_eight import (
    ExpandedEight,
    FigureEight,
    closure,
    closure_zero,
    positions,
    relative,
)
from .series import cos, sin
from .solution import Solution

__all__ = ["FigureEight", "closure", "closure_zero", "digits", "expanded", "load_digits",
           "positions", "relative", "thousand_digits"]


def expanded(sol: Any) -> Solution:
    r"""x_12 = r cos φ and y_12 = r sin φ, expanded once more in λ and cut at the order of ``sol``.

    .. math::  x_{12} + i y_{12} = r e^{iφ} = \sum_n (X_n(λ) + i Y_n(λ)) \cos nt

    Parameters
    ----------
    sol : Solution
        An exact solution of :class:`FigureEight`, with any exponent.

    Returns
    -------
    Solution
        Of the unknowns x (even n) and y (odd n).  :func:`positions`, :func:`closure` and
        :func:`closure_zero` take it as well.

    Raises
    ------
    InputError
        ``sol`` is not such a solution.

    Examples
    --------
    >>> import ftseries as fts
    >>> sol = expanded(fts.solve(fts.FigureEight(), order=6))
    >>> sol.coefficient("x", 0, 0), sol.coefficient("x", 0, 2), sol.coefficient("y", 3, 3)
    (3**(1/3), -5*3**(1/3)/16, 0)
    """
    if type(getattr(sol, "problem", None)) is not FigureEight or sol.arithmetic != "exact":
        raise InputError(f"{sol!r} is not an exact figure eight; give solve(FigureEight(), …)")
    expansion = Expansion(RationalRing())
    r, phi = (expansion.polynomial(sol.coefficients[name]) for name in ("r", "phi"))
    series = {"x": r * cos(phi), "y": r * sin(phi)}
    rows = {name: [u[m].modes() for m in range(sol.order + 1)] for name, u in series.items()}
    return Solution(ExpandedEight(sol.problem.exponent), "exact", sol.order, rows)
