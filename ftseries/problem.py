"""How a problem is declared: unknowns with their ansatz, equations, first coefficients.

A problem gives its equations as residuals (left side minus right side) and the *seed*: the first
coefficients, found by hand, which choose one of the solutions of the first non-linear equations.
Numbers in the equations and in the seed are exact: a decimal is the fraction that it looks like.
"""

from __future__ import annotations

import difflib
import inspect
from collections.abc import Mapping
from typing import Any

import numpy as np
import sympy as sp
from flint import fmpq

from .aliases import Array, Coefficients, Expr, Function, Json, Modes
from .ansatz import Field, Scalar, in_parity
from .arguments import decimal
from .conversion import to_float
from .errors import InputError
from .expressions import expression, name_of
from .function import Function as AnyFunction
from .sampling import Samples

__all__ = ["Field", "Scalar", "Problem", "expression"]

#: the arguments of :meth:`ftseries.Solution.evaluate`
_TAKEN = {"self", "name", "t", "lam", "dps", "derivative"}
#: what a problem declares, as far as a slip in the name would go unnoticed
_DECLARATIONS = ("unknowns", "seed", "parameters", "frequency", "variable", "ahead", "surd",
                 "equations", "arguments")



class Problem:
    """A problem; subclasses declare the attributes they need and :meth:`equations`.

    Attributes
    ----------
    unknowns : dict
        Name to :class:`Field` or :class:`Scalar`.
    seed : dict
        Name to the list of first Taylor coefficients, each a dict ``{n: number}`` (a number alone
        for a scalar), all of them rational.
    parameters : tuple of str
        Names carried as symbols; exact coefficients are polynomials in them.  :meth:`equations`
        takes them by name, after the unknowns.
    frequency : str or None
        The scalar ω in τ = ωt; None where the period is 2π.
    variable : str
        How the independent variable is written.
    ahead : int
        How far Fourier orders may run ahead of Taylor orders: n ≤ m + ahead.  The paper has 0.
    surd : bool
        Do shifts by thirds of a period bring √3 into the single terms of the equations?

    Examples
    --------
    A mass on a spring, x″ + x + μx³ = 0 with a free parameter μ; in τ = ωt the derivative d/dt is
    ω d/dτ.  The seed says x = λ cos τ + … and ω = 1 + …:

    >>> import ftseries as fts
    >>> class Spring(fts.Problem):
    ...     unknowns = {"x": fts.Field("cos", modes="odd", powers="odd", fixed=(1,)),
    ...                 "omega": fts.Scalar("even")}
    ...     seed = {"x": [{}, {1: 1}], "omega": [1]}
    ...     frequency = "omega"
    ...     parameters = ("mu",)
    ...
    ...     def equations(self, lam, x, omega, mu):
    ...         return {"(spring)": omega**2 * x.diff(2) + x + mu * x**3}
    >>> sol = fts.solve(Spring(), order=4)
    >>> sol.coefficient("omega", 2)
    3*mu/8
    >>> round(sol.evaluate("omega", lam=0.1, mu=2), 6)
    1.007477
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
        """The residuals, left side minus right side, by the name of the equation.

        Written ``def equations(self, lam, x, omega, mu)``: λ, then the unknowns and the free
        parameters by their names.  Known are + - * / with functions and numbers, ``**`` with
        rational exponents, ``x.diff()`` and ``x.diff(2)`` for d/dτ, ``x.shift(1/4)`` for a part of
        a period, :func:`ftseries.sin`, :func:`ftseries.cos` and :func:`ftseries.exp` of what
        vanishes at λ = 0, and cos nτ as ``lam.expansion.cos(n)``, sin nτ likewise.
        """
        raise InputError(f"{type(self).__name__} has no equations; define its method 'equations'")

    def residuals(self, lam: Function, unknowns: Mapping[str, Function]) -> dict[str, Function]:
        """:meth:`equations` with the free parameters put in, checked to be a dict of functions."""
        kind = type(self).__name__
        form = ", ".join(["self", "lam", *unknowns, *self.parameters])
        try:
            takes = inspect.signature(self.equations)
            values = {name: lam.expansion.parameter(name) for name in self.parameters
                      if name in takes.parameters} | dict(unknowns)
            takes.bind(lam, **values)
        except (TypeError, ValueError):
            raise InputError(f"the method equations of {kind} takes other arguments than λ, the "
                             "unknowns and the names in 'parameters'; write "
                             f"def equations({form})") from None
        try:
            residuals = self.equations(lam, **values)
        except (NameError, AttributeError) as error:
            if error.name not in self.parameters:
                raise
            raise InputError(f"the parameter {error.name} of {kind} comes as an argument; write "
                             f"def equations({form})") from None
        if not isinstance(residuals, dict) or not residuals:
            raise InputError(f"{kind}.equations must return a dict from the name of each equation "
                             f"to its residual, not {residuals!r}")
        for name, residual in residuals.items():
            if not isinstance(residual, AnyFunction):
                raise InputError(f"equation {name} of {kind} is {residual!r}, not a series; write "
                                 "left side minus right side in the unknowns")
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
        """What the constructor needs to make this problem again, as plain JSON values.

        A class whose constructor takes arguments defines it, such as ``return {"b": self.b}``.
        """
        return {}

    def __repr__(self) -> str:
        inner = ", ".join(f"{k}={v}" for k, v in self.arguments().items())
        return f"{type(self).__name__}({inner})"

    def allowed(self, name: str, n: int, m: int) -> bool:
        """May mode n of an unknown have a coefficient of Taylor order m, beyond the seed?"""
        return (n <= m + self.ahead and m >= len(self.seed[name]) and self.in_powers(name, m))

    def in_powers(self, name: str, m: int) -> bool:
        """Is λ^m among the powers of an unknown's ansatz?"""
        return in_parity(self.unknowns[name].powers, m)

    def check(self) -> None:
        """Refuse a declaration that cannot be meant."""
        kind = type(self).__name__
        self._check_names()
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
        for name in (*self.unknowns, *self.parameters):
            if name_of(name) != name:
                raise InputError(f"Python writes the name {name!r} of {kind} as {name_of(name)!r} "
                                 "(NFKC); declare it so")
        taken = sorted(_TAKEN & set(self.parameters))
        if taken:
            raise InputError(f"the parameter {', '.join(taken)} of {kind} could not be given to "
                             "evaluate, which has an argument of that name; choose another name")
        twice = sorted(set(self.parameters) & set(self.unknowns))
        if twice:
            raise InputError(f"{', '.join(twice)} is declared twice, as an unknown and as a "
                             f"parameter of {kind}; give each a name of its own")

    def _declared(self) -> set[str]:
        """The attributes that the subclass or the instance has of its own."""
        return {name for cls in type(self).__mro__ if cls not in (Problem, object)
                for name in vars(cls)} | set(vars(self))

    def _check_names(self) -> None:
        """Refuse an attribute that looks like a misspelt declaration."""
        declared = self._declared()
        missing = set(_DECLARATIONS) - declared
        for name in sorted(name for name in declared if not name.startswith("_")):
            like = difflib.get_close_matches(name, missing, 1, 0.85)
            if like and not hasattr(Problem, name):
                raise InputError(f"{type(self).__name__} has the attribute {name!r}, which looks "
                                 f"like {like[0]!r} misspelt; correct it, or choose another name")

    def check_time(self) -> None:
        """Refuse a scalar that stands with d/dτ only, as ω d/dτ, where no frequency is declared.

        Each scalar is doubled and the clock slowed down, by two or by √2: if that leaves the
        residuals of some functions as they were, the scalar is a frequency or its square.
        """
        if "frequency" in self._declared():
            return
        for name, unknown in self.unknowns.items():
            if not isinstance(unknown, Scalar):
                continue
            try:
                plain, doubled, *both = (self._sample({name: factor}, clock) for factor, clock
                                         in ((1, 1), (2, 1), (2, 0.5), (2, 0.5**0.5)))
            except (AttributeError, InputError):   # what only series have, or beyond the floats
                return
            if any(np.allclose(plain, values, 1e-9) for values in both) \
                    and not np.allclose(plain, doubled, 1e-9):
                raise InputError(f"{name} stands with derivatives only in {type(self).__name__}, "
                                 f"so it sets the time scale; write {name} d/dτ for "
                                 f"d/d{self.variable} and declare frequency = {name!r} (or "
                                 f"frequency = None, where {self.variable} is τ itself)")

    def _sample(self, factors: dict[str, float], clock: float) -> Array:
        """The residuals of some functions near the seed, the scalars times their factors."""
        samples = Samples(16, 0.7, dict.fromkeys(self.parameters, 0.3))
        samples.n = samples.n * clock
        unknowns = {}
        for i, (name, rows) in enumerate(self.first_coefficients().items()):
            start = samples.constant(to_float(rows[0].get((0, 0), fmpq(0))) + 0.1)
            wave = 0.1 * (samples.cos(1) + samples.sin(i + 1))
            unknowns[name] = start * factors.get(name, 1) if isinstance(
                self.unknowns[name], Scalar) else start + wave
        with np.errstate(all="ignore"):
            return np.concatenate([r.values for r in
                                   self.residuals(samples.lam, unknowns).values()], axis=-1)

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
        return {mode: decimal(c) for mode, c in row.items() if c != 0}
