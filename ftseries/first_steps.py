r"""The first steps by hand, done by machine.

The first coefficients of a non-linear problem obey polynomial equations, such as (C6) of the
paper, with several solutions.  Fields up to order 1 and scalars at order 0 are sought; the
equations of order 0, 1, 2, … (:mod:`ftseries.first_orders`) that contain no later coefficient are
solved one order after the other, as far as :mod:`ftseries.roots` goes.  Equations that are not
polynomial, or have too many states of rest, are solved about rest at 0.
Solutions without oscillation are left out, and those that depend on a free parameter, because
coefficients are to be polynomials in it.  Of two that become each other by τ to -τ with ω to -ω,
or by τ to τ + π, the one with positive frequency or leading amplitude is kept.
"""

from __future__ import annotations

from collections.abc import Container
from contextlib import suppress
from functools import partial
from typing import TYPE_CHECKING

import sympy as sp

from .aliases import Expr, Mode
from .errors import (
    ContradictionError,
    FTSeriesError,
    InputError,
    NonAnalyticError,
    UndeterminedError,
)
from .first_orders import Known, Symbols, fixed, is_low, residual, symbols
from .problem import Scalar
from .reasons import forced_motion, free_motions, wider
from .roots import Roots, vanishes
from .stages import LATEST

if TYPE_CHECKING:
    from .symbolic import Equations

__all__ = ["first_steps"]

#: orders 0 … 3 are compared: an energy integral begins at 2, an amplitude may be settled at 3;
#: while something is free more of them
_ORDERS = 4
_MOST = LATEST[0] + 2
#: the largest ``ahead`` that is tried
_AHEAD = 100


def first_steps(problem: Equations) -> list[dict[str, Expr]]:
    """The seeds of a problem, each ``{name: SymPy expression in λ and the modes}``.

    Parameters
    ----------
    problem : Equations
        Without a seed.

    Raises
    ------
    InputError
        Steps that are not polynomial, or have too many solutions.
    UndeterminedError, ContradictionError
        Infinitely many solutions; none.
    """
    names = ", ".join(problem.unknowns)
    amplitudes = [f"{name} at {n}" for name, u in problem.unknowns.items()
                  for n in getattr(u, "fixed", ()) if not isinstance(n, tuple)]
    if len(amplitudes) > 1:
        raise InputError(f"several amplitudes are fixed ({', '.join(amplitudes)}), and only one "
                         f"can be λ; give a seed for {names}")
    if problem.ahead > _AHEAD:
        raise InputError(f"ahead={problem.ahead} gives the unknowns too many first coefficients to "
                         f"find them automatically (ahead goes up to {_AHEAD} there); give a seed "
                         f"for {names}")
    search = _Search(problem)
    try:
        solutions = search.run()
    except (NonAnalyticError, InputError, NotImplementedError) as error:
        still = free_motions(problem, search.rest()) if search.states else None
        if still:
            raise ContradictionError(f"no motion begins at rest: {still}") from None
        why, terms = str(error), list(dict.fromkeys(problem.delicate))
        if terms and not search.states:
            verb = "are" if len(terms) > 1 else "is"
            why = (f"{', '.join(terms)} {verb} not polynomial, and no series begins with rest at "
                   f"{', '.join(f'{name} = 0' for name in problem.language.fields)}")
        raise InputError(f"the first steps cannot be solved automatically ({why}); give a seed "
                         f"for {names}") from None
    if not solutions:
        failed = "the first equations have only solutions at rest within the ansatz" \
            if search.failed is None else (f"no first coefficients satisfy "
                                           f"{', '.join(problem.expressions)} at order "
                                           f"{search.failed} of λ")
        raise ContradictionError(f"{failed}: {search.reason()}")
    free = {s for known in solutions for s in search.low if s not in known}
    if free:
        labels = [search.label(key) for key, s in search.symbols.items() if s in free]
        raise UndeterminedError(
            f"the first equations leave {' and '.join(labels)} free, so λ has no concrete meaning "
            f"yet; fix an amplitude or a phase ('fixed' in a Field), or give a seed for {names}")
    solutions.sort(key=partial(_size, frequency=search.frequency))
    return [_seed(problem, search.symbols, known) for known in solutions]


class _Search:
    """The search for the first coefficients, and what it met on the way."""

    def __init__(self, problem: Equations) -> None:
        self.problem, self.symbols, self.roots = problem, symbols(problem, _MOST), Roots()
        self.low = {s for (name, _, m), s in self.symbols.items() if is_low(problem, name, m)}
        self.frequency = self.symbols.get((problem.frequency or "", (0, 0), 0))
        #: does something stay free, so that earlier equations still count?
        self.pending = False
        #: the states of rest, the order that fails, and what depends on a parameter
        self.states: list[Known] = []
        self.failed: int | None = None
        self.dependent: list[tuple[Expr, Expr]] = []

    def run(self) -> list[Known]:
        """The solutions that oscillate."""
        branches: list[Known] = [{}]
        for order in range(_MOST):
            if order >= _ORDERS and all(self.low <= set(known) for known in branches):
                break
            branches = self.extended(branches, order)
            if order == 0:
                self.states = branches
            if not branches:
                self.failed = order
                return []
        return _distinct(self.problem, self.symbols, branches)

    def extended(self, branches: list[Known], order: int) -> list[Known]:
        self.roots, self.dependent = Roots(), []
        if order == 0 and self.problem.ahead:               # at rest, if the forcing vanishes
            still = {s: sp.S.Zero for (_, mode, m), s in self.symbols.items() if m == 0 < mode[1]}
            with suppress(NonAnalyticError, InputError):
                found = self.extend(still, order)
                if found:
                    return found
            self.roots, self.dependent = Roots(), []
        try:
            return [found for known in branches for found in self.extend(known, order)]
        except (NonAnalyticError, InputError):
            if order:
                raise
        rest = {s: sp.S.Zero for (name, _, m), s in self.symbols.items()
                if m == 0 and not isinstance(self.problem.unknowns[name], Scalar)}
        found = self.extend(rest, order)
        if not found:
            raise InputError("they have too many solutions, and rest at 0 is none of them")
        return found

    def extend(self, known: Known, order: int) -> list[Known]:
        """All ways to satisfy the equations of one order, as extensions of ``known``."""
        parameters = {sp.Symbol(name) for name in self.problem.parameters}
        orders = range(order + 1) if self.pending else [order]
        equations = [e for k in orders for e in residual(self.problem, self.symbols, known, k)
                     if e.free_symbols <= self.low | parameters]
        unknown = sorted(set().union(*(e.free_symbols for e in equations)) - set(known)
                         - parameters, key=str)
        if not unknown:
            return [known] if all(map(vanishes, equations)) else []
        solutions = self.roots.solve(equations, unknown)
        self.pending = self.pending or any(len(found) < len(unknown) for found in solutions)
        kept = []
        for solution in solutions:
            dependent = [(s, v) for s, v in solution.items() if v.free_symbols & parameters]
            if all(self.follows(s, v) and len(solutions) == 1 for s, v in dependent):
                earlier = {s: sp.expand(v.xreplace(solution)) for s, v in known.items()}
                kept.append(earlier | solution)
            else:
                self.dependent += dependent
        return kept

    def follows(self, s: Expr, value: Expr) -> bool:
        """Is this the amplitude of a forced motion, a polynomial in the parameters?"""
        return value.is_polynomial(*value.free_symbols) and any(
            m == 1 for (_, _, m), other in self.symbols.items() if other == s)

    def label(self, key: tuple[str, Mode, int]) -> str:
        """A coefficient in words."""
        name, (sine, n), m = key
        if isinstance(self.problem.unknowns[name], Scalar):
            return f"the coefficient {name}_{m}"
        what = f"coefficient of {'sin' if sine else 'cos'} {n}τ in" if n else "mean of"
        return f"the {what} {name} at order {m} of λ"

    def rest(self) -> list[dict[str, Expr]]:
        """The states of rest, each field to its value."""
        return [{name: known.get(self.symbols.get((name, (0, 0), 0), sp.S.Zero), sp.S.Zero)
                 for name in self.problem.language.fields} for known in self.states]

    def reason(self) -> str:
        """Why there is no solution, and the way out."""
        problem = self.problem
        if self.dependent:
            s, value = self.dependent[0]
            key = next(key for key, other in self.symbols.items() if other == s)
            letters = sorted(x.name for x in value.free_symbols if x.name in problem.parameters)
            return (f"{' and '.join(letters)} need{'s' * (len(letters) == 1)} a value, because "
                    f"{self.label(key)} would be {value}, and coefficients are polynomials in a "
                    f"parameter; give it in parameters={{{letters[0]!r}: 2}}, for example")
        if self.roots.left:
            p = self.roots.left[0]
            key, s = next((key, s) for key, s in self.symbols.items() if p.has(s))
            return (f"{self.label(key)} would be a root c of {p.xreplace({s: sp.Symbol('c')})}, "
                    "with which no units make the coefficients rational; change numbers in the "
                    "equations so that c becomes rational")
        if self.failed == 0:
            return ("there is no state of rest in the ansatz; change the equations or the ansatz, "
                    f"or give a seed for {', '.join(problem.unknowns)}")
        return (forced_motion(problem, self.rest()) or wider(problem, _solvable)
                or free_motions(problem, self.rest())
                or "the ansatz may lack the symmetry or the Fourier orders of the motion; change "
                   f"the equations or the ansatz, or give a seed for {', '.join(problem.unknowns)}")


def _solvable(problem: Equations) -> bool:
    try:
        return bool(_Search(problem).run())
    except FTSeriesError:
        return False


def _distinct(problem: Equations, named: Symbols, solutions: list[Known]) -> list[Known]:
    """Without the motionless ones, and without those whose mirror image is kept."""
    given = any(fixed(problem, name, u, 1) for name, u in problem.unknowns.items())
    frequency = named.get((problem.frequency or "", (0, 0), 0))
    moving = [known for known in solutions if known.get(frequency) != 0 and (given or any(
        known.get(s, s) != 0 for (name, mode, m), s in named.items()
        if mode[1] and is_low(problem, name, m)))]
    if not (moving or problem.frequency) and problem.forcing:
        moving = solutions[:1]                          # forced at a higher power of λ
    waves = {s: mode for (name, mode, m), s in named.items() if mode[1]}
    mirrors = ({s for s, (_, n) in waves.items() if n % 2},                    # τ to τ + π
               {s for s, (sine, _) in waves.items() if sine} | {frequency})    # τ to -τ
    broken = (any(n % 2 for _, n in problem.forcing), any(sine for sine, _ in problem.forcing))
    for key, mirror, forced in zip((waves, {frequency}), mirrors, broken, strict=True):
        if forced:                                      # the equations do not allow this mirror
            continue
        kept = []
        for known in sorted(moving, key=partial(_is_negative, key=key)):
            if {s: sp.simplify(-v if s in mirror else v) for s, v in known.items()} not in kept:
                kept.append(known)
        moving = kept
    return moving


def _is_negative(known: Known, key: Container[Expr]) -> bool:
    """Is the first coefficient among ``key`` negative that is not zero?"""
    return next((v.is_negative is True for s, v in known.items() if s in key and v != 0), False)


def _size(known: Known, frequency: Expr | None) -> list[float]:
    """What solutions are ordered by: the frequency, then the other numbers."""
    values = [known.get(frequency, sp.S.Zero), *(known[s] for s in sorted(known, key=str))]
    return [float(v) if not v.free_symbols else 0.0 for v in values]


def _seed(problem: Equations, named: Symbols, known: Known) -> dict[str, Expr]:
    lam, t = sp.Symbol(problem.language.lam), sp.Symbol(problem.variable)
    omega = sp.Symbol(problem.frequency) if problem.frequency else 1
    seed = {}
    for name, unknown in problem.unknowns.items():
        total = sp.S.Zero
        follows = any(known[s].free_symbols for (other, _, m), s in named.items()
                      if other == name and m == 1 and s in known)       # the solver finds it
        for m in (0,) if isinstance(unknown, Scalar) or follows else (0, 1):
            rows = {mode: known[s] for (other, mode, k), s in named.items()
                    if other == name and k == m} | fixed(problem, name, unknown, m)
            for (sine, n), value in rows.items():
                wave = (sp.sin if sine else sp.cos)(n * omega * t) if n else sp.S.One
                total += value * lam**m * wave
        seed[name] = total
    return seed
