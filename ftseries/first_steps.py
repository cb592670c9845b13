r"""The first steps by hand, done by machine.

The first coefficients of a non-linear problem obey polynomial equations, such as (C6) of the
paper, with several solutions.  Here they are unknown symbols (fields up to order 1, scalars at
order 0), run through the problem's own equations as parameters of a polynomial ring; the equations
of order 0, 1, 2, … that contain no later coefficient are solved one order after the other.
Solutions without oscillation are left out, and of two that differ by the sign of a frequency or of
the leading amplitude the positive one is kept: they are the same motion with time or phase
reversed.
"""

import sympy as sp

from .conversion import to_sympy
from .errors import InputError, NonAnalyticError
from .laurent import PolynomialRing, SurdRing
from .problem import Scalar
from .series import Expansion

__all__ = ["first_steps"]

#: orders 0 … 3 are compared: an energy integral begins at 2, an amplitude may be settled at 3
_ORDERS = 4


def first_steps(problem, choice=None):
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
        No solution, infinitely many, or several without ``choice``; the message shows them.
    """
    symbols = _symbols(problem)
    low = {s for (name, _, m), s in symbols.items() if _is_low(problem, name, m)}
    branches = [({}, 0)]
    try:
        for order in range(_ORDERS):
            branches = [(found, order) for known, _ in branches
                        for found in _extend(problem, symbols, low, known, order)]
    except (NonAnalyticError, InputError) as error:
        raise InputError(f"the first steps cannot be solved automatically ({error}); give a seed "
                         f"for {', '.join(problem.unknowns)}") from None
    solutions = _distinct(problem, symbols, [known for known, _ in branches])
    free = {s for known in solutions for s in low if s not in known}
    if free or not solutions:
        what = (f"the equations leave {', '.join(sorted(map(str, free)))} free" if free
                else "the first equations have no solution that oscillates")
        raise InputError(f"{what}; give a seed for {', '.join(problem.unknowns)}, or fix what λ "
                         "means")
    seeds = [_seed(problem, symbols, known) for known in solutions]
    if len(seeds) > 1 and choice is None:
        shown = "; ".join(f"choice={i}: " + ", ".join(f"{n} = {e}" for n, e in seed.items())
                          for i, seed in enumerate(seeds))
        raise InputError(f"{len(seeds)} solutions of the first steps: {shown}")
    if choice is not None and choice not in range(len(seeds)):
        raise InputError(f"choice={choice!r}: there are {len(seeds)} solutions of the first steps")
    return seeds[choice or 0]


def _symbols(problem):
    """``{(name, mode, m): symbol}`` for the orders compared."""
    return {(name, mode, m): sp.Symbol(f"{name}_{'sc'[1 - mode[0]]}{mode[1]}_{m}"
                                       if not isinstance(unknown, Scalar) else f"{name}_{m}")
            for name, unknown in problem.unknowns.items()
            for m in range(_ORDERS + 1) for mode in unknown.columns(m + problem.ahead)
            if problem.in_powers(name, m)}


def _is_low(problem, name, m):
    return m == 0 or (m == 1 and not isinstance(problem.unknowns[name], Scalar))


def _extend(problem, symbols, low, known, order):
    """All ways to satisfy the equations of one order, as extensions of ``known``."""
    equations = [e for e in _residual(problem, symbols, known, order) if e.free_symbols <= low]
    unknown = sorted(set().union(*(e.free_symbols for e in equations)) - set(known), key=str)
    if not unknown:
        return [known] if not any(e != 0 for e in equations) else []
    solutions = sp.solve(equations, unknown, dict=True)
    return [known | {s: sp.simplify(v) for s, v in solution.items()} for solution in solutions
            if all(v.is_real is not False for v in solution.values())]


def _residual(problem, symbols, known, order):
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
            row = {}
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


def _fixed(problem, name, unknown, m):
    """λ is the amplitude of a fixed Fourier order; a fixed mode (sine, n) is a phase and zero."""
    orders = unknown.fixed if not isinstance(unknown, Scalar) and m == 1 else ()
    return {unknown.mode(n): 1 for n in orders if not isinstance(n, tuple)}


def _distinct(problem, symbols, solutions):
    """Without the motionless ones and the mirror images."""
    kept = []
    for known in solutions:
        given = any(_fixed(problem, name, u, 1) for name, u in problem.unknowns.items())
        oscillates = given or any(
            known.get(s, s) != 0 for (name, mode, m), s in symbols.items()
            if mode[1] and _is_low(problem, name, m))
        frequency = symbols.get((problem.frequency, (0, 0), 0))
        leading = next((known[s] for (name, mode, m), s in symbols.items()
                        if m == 1 and mode[1] and known.get(s, 0) != 0), sp.S.One)
        if oscillates and leading.is_negative is not True and (
                frequency is None or known.get(frequency, sp.S.One).is_positive is not False):
            kept.append(known)
    return kept


def _seed(problem, symbols, known):
    lam, t = sp.Symbol(problem.lam_name), problem.time
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
