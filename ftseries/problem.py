r"""How a problem is declared: unknowns, their ansatz, equations, first coefficients.

Index convention and formula.  An unknown :class:`Field` u is a Fourier-Taylor series

.. math::  u(τ; λ) = \sum_m λ^m \Big( \sum_{n \le m} A_{n,m} \cos nτ + B_{n,m} \sin nτ \Big),

of which the declaration keeps cosines, sines or both, all, even or odd Fourier orders n, and all,
even or odd Taylor orders m.  An unknown :class:`Scalar` is Σ_m c_m λ^m: a frequency, an eigenvalue.
A problem gives its equations as residuals (left side minus right side) and the *seed*: the first
coefficients, found by hand, which choose one of the solutions of the first non-linear equations.
"""

from __future__ import annotations

import ast
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp

from .aliases import Coefficients, Expr, Function, Json, Mode, Modes
from .arguments import rational
from .errors import InputError
from .series import Series

__all__ = ["Field", "Scalar", "Problem", "expression"]

_PARITIES = {"all": (0, 1), "even": (0,), "odd": (1,)}
_SAFE = (ast.Expression, ast.BinOp, ast.UnaryOp, ast.operator, ast.unaryop, ast.Constant, ast.Name,
         ast.Load)
_SINES = {"cos": (0,), "sin": (1,), "both": (0, 1)}


@dataclass(frozen=True)
class Field:
    """An unknown periodic function.

    Parameters
    ----------
    series : "cos", "sin" or "both"
        The Fourier modes of the ansatz.
    modes, powers : "all", "even" or "odd"
        Fourier orders n and Taylor orders m of the ansatz.
    fixed : tuple of int or of (sine, n)
        Modes that the seed gives completely: their later coefficients are zero.  This is how λ gets
        the meaning "amplitude of that mode".  A Fourier order n means the cosine and the sine;
        (1, n) the sine alone, (0, n) the cosine alone.
    """

    series: str = "cos"
    modes: str = "all"
    powers: str = "all"
    fixed: tuple[int | Mode, ...] = ()

    def __post_init__(self) -> None:
        if self.series not in tuple(_SINES):
            raise InputError(f"series={self.series!r}: choose 'cos', 'sin' or 'both'")
        _check_parity(self)
        if not isinstance(self.fixed, tuple) or not all(
                self.has(mode if isinstance(mode, tuple) else self.mode(mode))
                for mode in self.fixed):
            raise InputError(f"fixed={self.fixed!r}: give a tuple of Fourier orders n of the "
                             "ansatz, such as (1,), or of modes (sine, n)")

    def columns(self, top: int) -> list[Mode]:
        """The modes (sine, n) of the ansatz with n ≤ top, highest first."""
        return [(sine, n) for n in range(top, -1, -1) for sine in (0, 1)
                if self.has((sine, n)) and not self.is_fixed((sine, n))]

    def has(self, mode: tuple[Any, ...]) -> bool:
        """Is this mode (sine, n) part of the ansatz?"""
        sine, n = mode if len(mode) == 2 else (None, None)
        return (isinstance(n, int) and n >= 0 and sine in _SINES[self.series]
                and n % 2 in _PARITIES[self.modes] and (n > 0 or not sine))

    def is_fixed(self, mode: Mode) -> bool:
        """Does the seed give this mode (sine, n) completely?"""
        return mode in self.fixed or mode[1] in self.fixed

    def mode(self, key: int | Mode) -> Mode:
        """A mode given by hand: n, or (sine, n) where both kinds occur."""
        if isinstance(key, tuple):
            return key
        return (1 if self.series == "sin" else 0), key


@dataclass(frozen=True)
class Scalar:
    """An unknown number that depends on λ alone; ``powers`` as for :class:`Field`."""

    powers: str = "all"
    modes = "all"

    def __post_init__(self) -> None:
        _check_parity(self)

    def columns(self, top: int) -> list[Mode]:
        return [(0, 0)]

    def has(self, mode: tuple[Any, ...]) -> bool:
        return mode == (0, 0)

    def is_fixed(self, mode: Mode) -> bool:
        return False

    def mode(self, key: int) -> Mode:
        return 0, key


def _check_parity(unknown: Field | Scalar) -> None:
    for what in ("modes", "powers"):
        if getattr(unknown, what) not in tuple(_PARITIES):
            raise InputError(f"{what}={getattr(unknown, what)!r}: choose 'all', 'even' or 'odd'")


def expression(x: Any) -> Expr:
    """A number, SymPy expression or text as a SymPy expression; decimals become rationals.

    A text may hold numbers, names (of positive symbols), + - * / ** and sqrt, and nothing else:
    it may come from a file.

    >>> expression("2*sqrt(3)/a"), expression(0.1)
    (2*sqrt(3)/a, 1/10)
    """
    try:
        if isinstance(x, str):
            nodes = list(ast.walk(ast.parse(x, mode="eval")))
            names = {node.id for node in nodes if isinstance(node, ast.Name)}
            if not all(isinstance(node, _SAFE) or (isinstance(node, ast.Call)
                                                   and isinstance(node.func, ast.Name)
                                                   and node.func.id == "sqrt") for node in nodes):
                raise ValueError(x)
            symbols = {name: sp.Symbol(name, positive=True) for name in names - {"sqrt"}}
            result = sp.sympify(x, locals=symbols, rational=True)
        else:
            result = sp.nsimplify(x, rational=True) if isinstance(x, float) else sp.sympify(x)
    except (sp.SympifyError, SyntaxError, TypeError, ValueError):
        result = None
    if not isinstance(result, sp.Expr):
        raise InputError(f"{x!r} is not a number or a SymPy expression")
    return result


class Problem:
    """A problem; subclasses declare the four attributes and :meth:`equations`.

    Attributes
    ----------
    unknowns : dict
        Name to :class:`Field` or :class:`Scalar`.
    seed : dict
        Name to the list of first Taylor coefficients, each a dict ``{n: number}`` (a number alone
        for a scalar), all of them rational.
    parameters : tuple of str
        Names carried as symbols; exact coefficients are polynomials in them.
    frequency : str or None
        The scalar ω in τ = ωt; None where the period is 2π.
    variable : str
        How the independent variable is written.
    ahead : int
        How far Fourier orders may run ahead of Taylor orders: n ≤ m + ahead.  The paper has 0.
    surd : bool
        Do shifts by thirds of a period bring √3 into the single terms of the equations?
    """

    unknowns: dict[str, Field | Scalar] = {}
    seed: dict[str, Any] = {}
    parameters: tuple[str, ...] = ()
    frequency: str | None = None
    variable = "t"
    ahead = 0
    surd = False
    #: every problem class by name, so that a saved solution finds its own
    classes: dict[str, type[Problem]] = {}

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        Problem.classes[cls.__name__] = cls

    def equations(self, lam: Function, **unknowns: Function) -> dict[str, Function]:
        """The residuals, a dict from the equation's name to a :class:`ftseries.series.Series`."""
        raise InputError(f"{type(self).__name__} has no equations; define its method 'equations'")

    def residuals(self, lam: Function, unknowns: Mapping[str, Function]) -> dict[str, Series]:
        """:meth:`equations`, checked to be a dict of series."""
        residuals = self.equations(lam, **unknowns)
        if not isinstance(residuals, dict) or not residuals:
            raise InputError(f"{type(self).__name__}.equations must return a dict from the name of "
                             f"each equation to its residual, not {residuals!r}")
        for name, residual in residuals.items():
            if not isinstance(residual, Series):
                raise InputError(f"equation {name} of {type(self).__name__} is {residual!r}, not a "
                                 "series; write left side minus right side in the unknowns")
        return residuals

    #: the SymPy number in which λ is measured
    lam_scale: Expr = sp.S.One

    def scale(self, name: str) -> Expr:
        """The SymPy number in which an unknown is measured."""
        return sp.S.One

    def unit(self, name: str, m: int) -> Expr:
        """What turns the solver's coefficient of order m into the paper's."""
        return sp.sympify(self.scale(name)) / sp.sympify(self.lam_scale) ** m

    def first_lam(self, solution: Any) -> float:
        """A first guess of the λ that :meth:`condition` singles out."""
        raise InputError(f"{type(self).__name__} has no condition that singles out a λ; give lam")

    def condition(self, lam: Function, **unknowns: Function) -> Function:
        """A function whose mean vanishes at the λ that is sought, where the problem has one."""
        raise InputError(f"{type(self).__name__} has no condition that singles out a λ; give lam")

    def arguments(self) -> dict[str, Json]:
        """What the constructor needs to make this problem again, as plain JSON values."""
        return {}

    def __repr__(self) -> str:
        inner = ", ".join(f"{k}={v}" for k, v in self.arguments().items())
        return f"{type(self).__name__}({inner})"

    def allowed(self, name: str, n: int, m: int) -> bool:
        """May mode n of an unknown have a coefficient of Taylor order m, beyond the seed?"""
        return (n <= m + self.ahead and m >= len(self.seed[name]) and self.in_powers(name, m))

    def in_powers(self, name: str, m: int) -> bool:
        """Is λ^m among the powers of an unknown's ansatz?"""
        return m % 2 in _PARITIES[self.unknowns[name].powers]

    def check(self) -> None:
        """Refuse a declaration that cannot be meant."""
        kind = type(self).__name__
        if not self.unknowns:
            raise InputError(f"{kind} has no unknowns; declare its Fields and Scalars")
        for name, unknown in self.unknowns.items():
            if not isinstance(unknown, (Field, Scalar)):
                raise InputError(f"the unknown {name} of {kind} is {unknown!r}; declare it as a "
                                 "Field or a Scalar")
        if self.frequency is not None and not isinstance(self.unknowns.get(self.frequency), Scalar):
            raise InputError(f"frequency={self.frequency!r} of {kind} is not one of its unknown "
                             "scalars")
        if not isinstance(self.parameters, tuple):
            raise InputError(f"parameters={self.parameters!r} of {kind}: give a tuple of names, "
                             "such as ('mu',)")

    def first_coefficients(self) -> Coefficients:
        """The seed as ``{name: [{(sine, n): fmpq}, …]}``; refuses a missing or foreign one."""
        self.check()
        if not isinstance(self.seed, dict) or not all(
                isinstance(rows, (list, tuple)) for rows in self.seed.values()):
            raise InputError(f"seed={self.seed!r} of {type(self).__name__}: give a dict from each "
                             "unknown to the list of its first Taylor coefficients")
        missing = [name for name in self.unknowns if not self.seed.get(name)]
        if missing:
            raise InputError(f"{type(self).__name__} has no seed for {', '.join(missing)}: give "
                             "its first coefficients, found by hand, in the attribute 'seed'")
        foreign = set(self.seed) - set(self.unknowns)
        if foreign:
            raise InputError(f"the seed names {', '.join(sorted(foreign))}, which is not an "
                             f"unknown of {type(self).__name__}; it has {', '.join(self.unknowns)}")
        return {name: [self._seed_row(name, m, row) for m, row in enumerate(self.seed[name])]
                for name in self.unknowns}

    def _seed_row(self, name: str, m: int, row: Any) -> Modes:
        unknown = self.unknowns[name]
        row = {unknown.mode(n): c for n, c in (row if isinstance(row, dict) else {0: row}).items()}
        for mode in row:
            top = m + self.ahead
            if not unknown.has(mode) or mode[1] > top:
                raise InputError(f"the seed of {name} at order {m} of λ has the mode {mode}, which "
                                 f"the ansatz {unknown} with Fourier orders n ≤ {top} leaves out")
        return {mode: rational(c) for mode, c in row.items() if c != 0}
