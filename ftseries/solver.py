r"""The solver: one for every problem, in every arithmetic.

The structure of a problem (the linear part, its kernel, what settles open coordinates) is always
found in exact arithmetic, and so are the first orders; ``float`` and ``ball`` then go on from
there.  :mod:`ftseries.stages` compares the coefficients.
"""

from __future__ import annotations

import math
import os
from typing import TYPE_CHECKING, Any

from flint import fmpq
from tqdm import tqdm

from .aliases import Coefficients, Number
from .arguments import whole
from .degrees import highest
from .errors import FaultError, InputError, PrecisionWarning, SolveError, UndeterminedError
from .evaluation import warn
from .grid import FloatRing
from .laurent import BallRing, PolynomialRing, RationalRing, SurdRing
from .linear import LinearPart
from .phases import mode, unsatisfied
from .precision import working
from .problem import Problem
from .solution import Solution
from .stages import LATEST, Stages

if TYPE_CHECKING:
    from .trig import Ring

__all__ = ["solve"]

#: of floats that keep fewer digits a warning is given; the rounding of an order, of its terms
DIGITS, ROUNDING = 3, 10 * 2.0**-53


def solve(problem: Problem, order: int, arithmetic: str = "exact", precision: int = 128,
          progress: bool = True) -> Solution:
    """The Fourier-Taylor series that solves ``problem``, up to Taylor order ``order``.

    Parameters
    ----------
    problem : Problem
        For example ``CubicOscillator(a=1)``.
    order : int
        The highest power of λ, at least 0.
    arithmetic : "exact", "float" or "ball"
        Rational numbers (polynomials in the problem's parameters), float64, or real balls that
        enclose the exact coefficients.  Floats are right to the rounding of the largest mode of
        their order: a mode that is much smaller keeps fewer digits, or none.
    precision : int
        Bits of a ball; used by ``"ball"`` only.
    progress : bool
        Show a progress bar when the solve takes more than a few seconds.

    Returns
    -------
    Solution

    Raises
    ------
    InputError
        Bad order, arithmetic or precision; a problem without seed.
    NonAnalyticError
        An operation that has no Taylor series at λ = 0.
    UndeterminedError, ContradictionError
        λ has no concrete meaning; the equations cannot hold together.

    Examples
    --------
    The second-order coefficients of (C7a) and (C7b):

    >>> import ftseries as fts
    >>> sol = fts.solve(fts.CubicOscillator(a=1), order=4)
    >>> sol.coefficient("x", 2, 2), sol.coefficient("omega", 2)
    (-1/12, -sqrt(3)/24)
    """
    if not isinstance(problem, Problem):
        raise InputError(f"{problem!r} is not a problem; give one such as CubicOscillator(a=1)")
    order = whole("order", order)
    if arithmetic not in ("exact", "float", "ball"):
        raise InputError(f"arithmetic={arithmetic!r}: choose 'exact', 'float' or 'ball'")
    precision = whole("precision", precision, 2)
    if problem.parameters and arithmetic != "exact":
        raise InputError(f"{', '.join(problem.parameters)} is a free parameter, which only "
                         "arithmetic='exact' can carry; give it a value in "
                         f"{type(problem).__name__}")
    seed = problem.first_coefficients()
    _check_memory(problem, order, arithmetic, precision)
    asked, order = order, max(order, *(len(rows) for rows in seed.values()))    # checks the seed
    problem.check_time()
    bar = tqdm(total=order, desc=f"order of {type(problem).__name__}", delay=10, leave=False,
               disable=not progress)
    with bar:
        for late in LATEST:
            try:
                known = _solved(problem, seed, order, arithmetic, precision, late, bar)
                break
            except UndeterminedError:
                if late == LATEST[-1]:
                    raise
    return Solution(problem, arithmetic, order, known,
                    precision if arithmetic == "ball" else None).truncate(asked)


def _solved(problem: Problem, seed: Coefficients, order: int, arithmetic: str, precision: int,
            late: int, bar: Any) -> Coefficients:
    """The coefficients, if all are settled at most ``late`` orders after their own."""
    ring: Ring = _exact_ring(problem)
    known = _converted(seed, ring)
    linear = LinearPart(problem, ring, known, order + late + problem.ahead)
    lead = order if arithmetic == "exact" else min(order, 2 * (late + linear.reach))
    first = Stages(problem, linear, ring, known, lead, late)
    first.run(bar)
    linear = first.linear
    if problem.surd:
        known = _without_surd(known, problem)
    if arithmetic == "float":
        top = order + late + linear.reach
        ring = FloatRing(degree=highest(problem, top) if problem.ahead else top, order=top)
        known = _converted(known, ring)
        if order > lead:
            stages = Stages(problem, linear, ring, known, order, late)
            stages.run(bar, fresh=False)
            _warn_of_rounding(problem, known, lead, stages.sizes)
    elif arithmetic == "ball":
        ring = BallRing()
        with working(bits=precision):
            known = _converted(known, ring)
            if order > lead:
                Stages(problem, linear, ring, known, order, late).run(bar, fresh=False)
    _verify(problem, arithmetic, known, linear, precision)
    return known


def _verify(problem: Problem, arithmetic: str, known: Coefficients, linear: LinearPart,
            precision: int) -> None:
    """Nothing leaves the solver whose equations were not looked at afresh."""
    defect = unsatisfied(problem, arithmetic, known, linear.shifts,
                         precision if arithmetic == "ball" else None)
    if defect is None:
        return
    if arithmetic == "float" and not defect.share > 1e-3:
        raise SolveError(f"rounding has grown to {defect.share:.0e} of the terms of equation "
                         f"{defect.equation} at order {defect.order} of λ; stay below, or solve "
                         "with arithmetic='ball' or 'exact'")
    sine, n = mode(problem, known, defect)
    raise FaultError(f"the coefficients that were found do not satisfy equation {defect.equation} "
                     f"of {problem!r} at order {defect.order} of λ, mode {'sin' if sine else 'cos'}"
                     f" {n}τ; this is a fault of ftseries: please report the problem with this "
                     "message, and do not use another order of it unchecked")


def _warn_of_rounding(problem: Problem, known: Coefficients, lead: int,
                      sizes: dict[int, float]) -> None:
    """Warn where the floats of an order keep few digits, against the terms they come from.

    Orders that are zero among the first ones, which are exact, are zero: rounding is all they have.
    """
    for name, rows in known.items():
        first = [m for m, row in enumerate(rows[:lead + 1]) if row]
        step = math.gcd(*(m - first[0] for m in first)) if first else 0
        for m in range(first[0] + step, len(rows), step) if step else ():
            size = max(map(abs, rows[m].values()), default=0.0)
            if m > lead and size * 10**-DIGITS < ROUNDING * sizes.get(m, 0.0):
                warn(f"from order {m} of λ on, the coefficients of {name!r} keep fewer than "
                     f"{DIGITS} digits: they are what is left of terms of about "
                     f"{sizes[m] / max(size, 1e-300):.0e} times their size; truncate({m - 1}), or "
                     "solve with arithmetic='ball' or 'exact'", PrecisionWarning)
                break


def _exact_ring(problem: Problem) -> PolynomialRing | RationalRing:
    if problem.surd:
        return SurdRing(problem.parameters)
    return PolynomialRing(problem.parameters) if problem.parameters else RationalRing()


def _without_surd(known: Coefficients, problem: Problem) -> Coefficients:
    """The coefficients without the variable √3, which has to cancel in the end."""
    target = PolynomialRing(problem.parameters)

    def plain(name: str, m: int, c: Number) -> Number:
        terms = c.to_dict()
        if any(exponents[-1] for exponents in terms):
            raise SolveError(f"a coefficient of {name} at order {m} contains √3 "
                             f"({SurdRing(problem.parameters).written(c)}); choose the phase or "
                             "the unit so that the coefficients are rational")
        if not problem.parameters:
            return sum(terms.values(), fmpq(0))
        return target.context.from_dict({exponents[:-1]: q for exponents, q in terms.items()})
    return {name: [{mode: plain(name, m, c) for mode, c in row.items()}
                   for m, row in enumerate(rows)] for name, rows in known.items()}


def _converted(known: Coefficients, ring: Ring) -> Coefficients:
    return {name: [{mode: ring.number(c) for mode, c in row.items()} for row in rows]
            for name, rows in known.items()}


def _check_memory(problem: Problem, order: int, arithmetic: str, precision: int) -> None:
    """Refuse an order whose tables cannot fit: about (nodes · order²/2) numbers."""
    nodes = 24 * len(problem.unknowns)
    size = {"float": 8, "exact": 64, "ball": 64 + precision // 4}[arithmetic]
    try:
        memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, ValueError, OSError):
        memory = 2**33
    if nodes * size * (order + 1)**2 // 2 > memory:
        most = math.isqrt(2 * memory // (nodes * size))
        bits = f" and precision={precision}" if arithmetic == "ball" else ""
        raise InputError(f"order={order} needs more memory than this machine has; with "
                         f"arithmetic={arithmetic!r}{bits} stay below about {most}")
