r"""The first steps by hand, done by machine.

The first coefficients of a non-linear problem obey polynomial equations, such as (C6) of the
paper, with several solutions.  Here they are unknown symbols (fields up to order 1, scalars at
order 0), run through the problem's own equations as parameters of a polynomial ring; the equations
of order 0, 1, 2, … that contain no later coefficient are solved one order after the other.
Solutions without oscillation are left out, and those that depend on a free parameter, because
coefficients are to be polynomials in it.  Of two that become each other by τ to -τ with ω to -ω,
or by τ to τ + π, the one with positive frequency or leading amplitude is kept.
"""

from __future__ import annotations

from collections.abc import Container
from functools import partial
from typing import TYPE_CHECKING, Any, TypeAlias

import sympy as sp

from .aliases import Expr, Mode
from .conversion import to_sympy
from .errors import ContradictionError, InputError, NonAnalyticError, UndeterminedError
from .expansion import Expansion
from .laurent import PolynomialRing, SurdRing
from .problem import Scalar

if TYPE_CHECKING:
    from .problem import Field
    from .symbolic import Equations

__all__ = ["first_steps"]

#: the symbol of each first coefficient, (unknown, mode, order); the values found for some
Symbols: TypeAlias = dict[tuple[str, Mode, int], Expr]
Known: TypeAlias = dict[Expr, Expr]

#: orders 0 … 3 are compared: an energy integral begins at 2, an amplitude may be settled at 3
_ORDERS = 4


def first_steps(problem: Equations, choice: int | None = None) -> dict[str, Expr]:
    """The seed of a problem, ``{name: SymPy expression in λ and the modes}``.

    Parameters
    ----------
    problem : Equations
        Without a seed.
    choice : int, optional
        Which of several solutions to take.

    Raises
    ------
    InputError
        Several solutions without ``choice``, which the message shows; steps that are not
        polynomial.
    UndeterminedError, ContradictionError
        Infinitely many solutions; none.
    """
    amplitudes = [f"{name} at {n}" for name, u in problem.unknowns.items()
                  for n in getattr(u, "fixed", ()) if not isinstance(n, tuple)]
    if len(amplitudes) > 1:
        raise InputError(f"several amplitudes are fixed ({', '.join(amplitudes)}), and only one "
                         f"can be λ; give a seed for {', '.join(problem.unknowns)}")
    symbols = _symbols(problem)
    low = {s for (name, _, m), s in symbols.items() if _is_low(problem, name, m)}
    branches: list[Known] = [{}]
    try:
        for order in range(_ORDERS):
            branches = [found for known in branches
                        for found in _extend(problem, symbols, low, known, order)]
            if not branches:
                raise ContradictionError(
                    f"no first coefficients satisfy {', '.join(problem.expressions)} at order "
                    f"{order} of λ: a resonance, or an ansatz without the symmetry or the Fourier "
                    "orders of the motion; change the equations or the ansatz")
    except (NonAnalyticError, InputError, NotImplementedError) as error:
        terms = f"{', '.join(problem.delicate)} is not polynomial" if problem.delicate else error
        raise InputError(f"the first steps cannot be solved automatically ({terms}); give a seed "
                         f"for {', '.join(problem.unknowns)}") from None
    solutions = _distinct(problem, symbols, branches)
    free = {s for known in solutions for s in low if s not in known}
    if free:
        labels = [_label(name, mode, m, problem.unknowns[name])
                  for (name, mode, m), s in symbols.items() if s in free]
        raise UndeterminedError(
            f"the first equations leave {' and '.join(labels)} free, so λ has no concrete meaning "
            f"yet; fix an amplitude or a phase ('fixed' in a Field), or give a seed for "
            f"{', '.join(problem.unknowns)}")
    if not solutions:
        raise ContradictionError(
            "the first equations have only solutions at rest within the ansatz; change it, or "
            f"give a seed for {', '.join(problem.unknowns)}")
    seeds = [_seed(problem, symbols, known) for known in solutions]
    if len(seeds) > 1 and choice is None:
        shown = "; ".join(f"choice={i}: " + ", ".join(f"{n} = {e}" for n, e in seed.items())
                          for i, seed in enumerate(seeds))
        raise InputError(f"the first steps have {len(seeds)} solutions, select one of them: "
                         f"{shown}")
    if choice is not None and choice not in range(len(seeds)):
        raise InputError(f"choice={choice!r}: the number of solutions of the first steps is "
                         f"{len(seeds)}, counted from 0")
    return seeds[choice or 0]


def _symbols(problem: Equations) -> Symbols:
    """``{(name, mode, m): symbol}`` for the orders compared."""
    return {(name, mode, m): sp.Symbol(f"{name}_{'sc'[1 - mode[0]]}{mode[1]}_{m}"
                                       if not isinstance(unknown, Scalar) else f"{name}_{m}")
            for name, unknown in problem.unknowns.items()
            for m in range(_ORDERS + 1) for mode in unknown.columns(m + problem.ahead)
            if problem.in_powers(name, m)}


def _label(name: str, mode: Mode, m: int, unknown: Field | Scalar) -> str:
    wave = f" {'sin' if mode[0] else 'cos'} {mode[1]}τ" if mode[1] else " the mean"
    return f"the coefficient {name}_{m}" if isinstance(unknown, Scalar) else \
        f"the coefficient of{wave} in {name} at order {m} of λ"


def _is_low(problem: Equations, name: str, m: int) -> bool:
    return m == 0 or (m == 1 and not isinstance(problem.unknowns[name], Scalar))


def _extend(problem: Equations, symbols: Symbols, low: set[Expr], known: Known,
            order: int) -> list[Known]:
    """All ways to satisfy the equations of one order, as extensions of ``known``."""
    parameters = {sp.Symbol(name) for name in problem.parameters}
    equations = [e for e in _residual(problem, symbols, known, order)
                 if e.free_symbols <= low | parameters]
    unknown = sorted(set().union(*(e.free_symbols for e in equations)) - set(known) - parameters,
                     key=str)
    if not unknown:
        return [known] if not any(e != 0 for e in equations) else []
    solutions = sp.solve(equations, unknown, dict=True)
    return [known | {s: sp.simplify(v) for s, v in solution.items()} for solution in solutions
            if not any(v.is_real is False or v.free_symbols & parameters
                       for v in solution.values())]


def _residual(problem: Equations, symbols: Symbols, known: Known, order: int) -> list[Expr]:
    """The residual's coefficients of one order as SymPy polynomials in what is not yet known."""
    open_symbols = [s for s in symbols.values() if s not in known]
    irrational = {s: v for s, v in known.items() if not v.is_Rational}
    names = (*problem.parameters, *map(str, open_symbols), *map(str, irrational))
    ring = (SurdRing if problem.surd else PolynomialRing)(names)
    expansion = Expansion(ring)
    unknowns = {}
    for name, unknown in problem.unknowns.items():
        unknowns[name] = expansion.unknown()
        for m in range(order + 1):
            row: dict[Mode, Any] = {}
            for (other, mode, k), s in symbols.items():
                if other == name and k == m:
                    value = known.get(s, s)
                    row[mode] = (ring.parameter(str(s)) if value == s or s in irrational
                                 else ring.number(value))
            for mode, value in _fixed(problem, name, unknown, m).items():
                row[mode] = ring.number(value)
            unknowns[name].set(m, ring.from_modes({k: v for k, v in row.items() if v != 0}))
    back = {sp.Symbol(str(s)): v for s, v in irrational.items()}
    back[sp.Symbol("sqrt3")] = sp.sqrt(3)
    return [sp.expand(to_sympy(c, ring.names).subs(back))
            for residual in problem.equations(expansion.lam, **unknowns).values()
            for c in residual[order].modes().values()]


def _fixed(problem: Equations, name: str, unknown: Field | Scalar, m: int) -> dict[Mode, int]:
    """λ is the amplitude of a fixed Fourier order; a fixed mode (sine, n) is a phase and zero."""
    orders = unknown.fixed if not isinstance(unknown, Scalar) and m == 1 else ()
    return {unknown.mode(n): 1 for n in orders if not isinstance(n, tuple)}


def _distinct(problem: Equations, symbols: Symbols, solutions: list[Known]) -> list[Known]:
    """Without the motionless ones, and without those whose mirror image is kept."""
    given = any(_fixed(problem, name, u, 1) for name, u in problem.unknowns.items())
    moving = [known for known in solutions if given or any(
        known.get(s, s) != 0 for (name, mode, m), s in symbols.items()
        if mode[1] and _is_low(problem, name, m))]
    frequency = symbols.get((problem.frequency or "", (0, 0), 0))
    waves = {s: mode for (name, mode, m), s in symbols.items() if mode[1]}
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


def _seed(problem: Equations, symbols: Symbols, known: Known) -> dict[str, Expr]:
    lam, t = sp.Symbol(problem.language.lam), sp.Symbol(problem.variable)
    omega = sp.Symbol(problem.frequency) if problem.frequency else 1
    seed = {}
    for name, unknown in problem.unknowns.items():
        total = sp.S.Zero
        for m in (0,) if isinstance(unknown, Scalar) else (0, 1):
            rows = {mode: known[s] for (other, mode, k), s in symbols.items()
                    if other == name and k == m} | _fixed(problem, name, unknown, m)
            for (sine, n), value in rows.items():
                wave = (sp.sin if sine else sp.cos)(n * omega * t) if n else sp.S.One
                total += value * lam**m * wave
        seed[name] = total
    return seed
