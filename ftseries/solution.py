r"""A solved problem: coefficients, truncation, files.

Index convention and formula.  ``coefficients[name][m]`` is the Taylor coefficient of order m of an
unknown as a dict ``{(sine, n): number}``, in the solver's units (see ``Problem.unit``):

.. math::  u(t; λ) = \sum_m λ^m\, \mathrm{unit}(m) \sum_n (A_{n,m} \cos nωt + B_{n,m} \sin nωt).

Zero coefficients are left out; a scalar keeps its number under (0, 0).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp
from flint import arb

from . import display, storage
from .aliases import FilePath, Number
from .arguments import shown, whole
from .conversion import float_unit, numeric_unit, to_ball, to_sympy
from .errors import InputError
from .evaluation import unknown
from .precision import working
from .problem import Field, Scalar
from .quality import Quality

if TYPE_CHECKING:
    from .problem import Problem

__all__ = ["Solution", "load"]


class Solution(Quality):
    """The truncated Fourier-Taylor series of every unknown; made by :func:`ftseries.solve`.

    Attributes
    ----------
    problem : Problem
    arithmetic : str
        "exact", "float" or "ball".
    order : int
        The highest Taylor order.
    coefficients : dict
        As in the module's formula.
    precision : int or None
        Bits, in ball arithmetic.
    """

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickled like a saved file, so that solutions travel between processes."""
        return _restored, (self.problem, self.arithmetic, self.order,
                           storage.encoded(self.coefficients), self.precision)

    def __repr__(self) -> str:
        bits = f", precision={self.precision}" if self.precision else ""
        return f"<Solution of {self.problem!r}, order {self.order}, {self.arithmetic}{bits}>"

    def coefficient(self, name: str, *orders: int, sine: bool | None = None) -> Any:
        """One coefficient: ``coefficient("x", n, m)`` of a field, ``coefficient("omega", m)``.

        Parameters
        ----------
        name : str
            An unknown of the problem.
        *orders : int
            Fourier order n and Taylor order m; for a scalar unknown the Taylor order alone.
        sine : bool, optional
            Choose sine or cosine where the unknown has both; a scalar has none.

        Returns
        -------
        SymPy expression, float, or python-flint ball, by arithmetic.

        Examples
        --------
        >>> import ftseries as fts
        >>> sol = fts.solve(fts.FigureEight(), order=4)
        >>> sol.coefficient("r", 4, 4), sol.coefficient("phi", 3, 3)          # (E6c), (E6d)
        (3**(1/3)/256, -1/48)
        """
        kind = unknown(self.problem, name)
        scalar = isinstance(kind, Scalar)
        if len(orders) != (1 if scalar else 2):
            raise InputError(f"{name!r} takes {'its Taylor order m' if scalar else 'n and m'}: "
                             f"coefficient({name!r}, {'m' if scalar else 'n, m'}), not {orders!r}")
        if sine is not None and not isinstance(sine, (bool, np.bool_)) or scalar and sine:
            raise InputError(f"sine={shown(sine)}: " + (f"{name!r} has no sines; leave it out"
                             if scalar else "say sine=True or sine=False, or leave it out"))
        n, m = [0, *(whole(index, order) for index, order in zip("nm"[scalar:], orders))][-2:]
        if m > self.order:
            raise InputError(f"{name!r} is known to order {self.order}, not to {m}; solve again "
                             f"with order={m}")
        if isinstance(kind, Field) and sine is None:
            if kind.series == "both" and n:
                raise InputError(f"{name!r} has cosines and sines; say sine=True or sine=False")
            sine = kind.series == "sin"
        return self._in_unit(name, m, self.coefficients[name][m].get((int(bool(sine)), n)))

    def truncate(self, order: int) -> Solution:
        """The same solution cut at a lower Taylor order."""
        order = whole("order", order)
        if order > self.order:
            raise InputError(f"cannot cut at order {order}: the solution ends at {self.order}")
        return Solution(self.problem, self.arithmetic, order,
                        {name: rows[:order + 1] for name, rows in self.coefficients.items()},
                        self.precision)

    def to_latex(self, name: str, order: int | None = None) -> str:
        """The series of one unknown as LaTeX, cut at Taylor order ``order``."""
        return display.to_latex(self, name, min(self.order, 6) if order is None else order)

    def _repr_latex_(self) -> str:
        return display.summary(self)

    def save(self, path: FilePath) -> None:
        """Write the solution as JSON; see :func:`ftseries.storage.save`."""
        storage.save(self, path)

    def _in_unit(self, name: str, m: int, number: Number | None) -> Any:
        """A solver's number (or None for zero) in the paper's unit and the caller's type."""
        unit = sp.sympify(self.problem.unit(name, m))
        if self.arithmetic == "exact":
            return sp.S.Zero if number is None else unit * to_sympy(number, self.problem.parameters)
        if self.arithmetic == "float":
            return 0.0 if number is None else float_unit(self.problem, unit) * number
        with working(bits=self.precision):
            unit = to_ball(numeric_unit(self.problem, unit))
            return arb(0) if number is None else unit * number


def _restored(problem: Problem, arithmetic: str, order: int, coefficients: Any,
              precision: int | None) -> Solution:
    return Solution(problem, arithmetic, order,
                    storage.decoded(coefficients, problem, arithmetic), precision)


def load(path: FilePath, problem: Problem | None = None) -> Solution:
    """Read a solution written by :meth:`Solution.save`.

    The file may come from a stranger: what it holds is checked to be a solution of its problem,
    every order of the equations, the first coefficients (the seed), the ansatz, types and ranges.
    Where the problem has free parameters, the equations are checked at one point of random values
    of them.  Long exact series take half the time of their solve, others about the same time.

    Parameters
    ----------
    path : str or path
    problem : Problem, optional
        Needed when the problem's class has not been imported or cannot be made from its
        ``arguments()``.

    Raises
    ------
    FileError
        The file is missing, damaged, of another kind, larger than 64 MB, has Fourier orders above
        1000 or more than 100000 bits, or holds no solution of the problem.

    Examples
    --------
    >>> import ftseries as fts, os, tempfile
    >>> sol = fts.solve(fts.GeneralizedMathieu(), order=9)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = os.path.join(folder, "mathieu.json")
    ...     sol.save(file)
    ...     fts.load(file).coefficients == sol.coefficients
    True
    """
    return Solution(*storage.read(path, problem))
