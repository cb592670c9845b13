r"""A family of periodic solutions, followed in λ.

Formula.  Newton's method reaches the solution next to its first guess.  Whether that belongs to the
family of a series is certain only where the series is good; so the family is followed from there.
Each solution is predicted from the two before it along a straight line,

.. math::  c(λ + h) ≈ c(λ) + \frac{h}{h'} \big( c(λ) - c(λ - h') \big),

and a step counts only if Newton's method ends close to what was predicted; else it is halved.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Mapping

from .aliases import Modes
from .errors import SolveError
from .refine import Orbit, Unresolved

__all__ = ["change", "follow"]

#: a change of an unknown, against its largest mode, up to which a solution is next to another; what
#: is aimed at; and below which a step is close to a straight line
_NEAR, _AIM = 0.03, 0.01
#: a change of an unknown by which a series counts as good
_GOOD = 1e-3
#: the first two places, as a part of the second
_BEFORE = 0.9
#: how often λ is halved in search of a place where the series is good
_HALVINGS = 12
#: the smallest step, as a part of λ, and the most of them
_SMALLEST, _MOST_STEPS = 3e-3, 80
#: an unknown below this part of the largest one is rounding
_NOTHING = 1e-9


def change(before: Mapping[str, Modes], after: Mapping[str, Modes],
           seen: Mapping[str, float] | None = None) -> float:
    """The largest change of a mode, relative to the largest mode of its own unknown.

    ``seen`` are larger sizes that the unknowns had elsewhere, against which to take it.

    >>> change({"x": {(0, 1): 1.0}, "y": {}}, {"x": {(0, 1): 2.0, (0, 3): -0.5}, "y": {}})
    0.5
    """
    sizes = _sizes(after, seen or {})
    least = max(_NOTHING * max(sizes.values()), sys.float_info.min)
    return max((abs(modes.get(mode, 0.0) - before[name].get(mode, 0.0)) / max(sizes[name], least)
                for name, modes in after.items() for mode in modes.keys() | before[name].keys()),
               default=0.0)


def _sizes(modes: Mapping[str, Modes], seen: Mapping[str, float]) -> dict[str, float]:
    """The largest mode of each unknown, here or before."""
    return {name: max([seen.get(name, 0.0), *map(abs, row.values())])
            for name, row in modes.items()}


def follow(series: Callable[[float], Orbit], lam: float) -> Orbit:
    """The solution at λ of the family that is ``series`` near λ = 0, to some digits.

    Parameters
    ----------
    series : callable
        Takes λ and returns the truncated series there, as an orbit.
    lam : float

    Raises
    ------
    SolveError
        The series is good nowhere, or a step fails however small it is: the family may end or turn
        back there.

    Examples
    --------
    Mathieu's eigenvalue b_1 at λ = 4, beyond the radius of convergence 2.75:

    >>> import ftseries as fts
    >>> sol = fts.solve(fts.GeneralizedMathieu(mu=0), order=12)
    >>> orbit = follow(lambda lam: sol._orbit({}, lam), 4.0)
    >>> round(orbit.evaluate("a"), 6)                                    # SciPy's mathieu_b(1, 8)
    -10.605368
    """
    before, here = _beginning(series, lam)
    steps, step = before.steps + here.steps, here.lam - before.lam
    seen = _sizes(here.coefficients, {})            # an unknown may pass through 0
    for _ in range(_MOST_STEPS):
        if here.lam == lam:
            here.steps = steps
            return here
        ahead = lam if abs(lam - here.lam) <= abs(step) else here.lam + step
        guess = _predicted(before, here, ahead)
        try:
            found = guess.rough(ahead)
        except Unresolved:
            break
        except SolveError:
            off = math.inf
        else:
            steps, off = steps + found.steps, change(
                guess.coefficients, found.coefficients, seen)
        if off <= _NEAR:
            before, here, seen = here, found, _sizes(found.coefficients, seen)
        elif abs(ahead - here.lam) < _SMALLEST * abs(lam):
            break
        step *= min(max((_AIM / off) ** 0.5 if off else 2.0, 0.5), 2.0)
    raise SolveError(f"the family was followed to λ = {here.lam:.6g}, not on to {lam:g}: it may "
                     "end, turn back or come close to a collision there; take a smaller λ")


def _beginning(series: Callable[[float], Orbit], lam: float) -> tuple[Orbit, Orbit]:
    """The solutions just before and at the largest of λ/2, λ/4, … where the series is good."""
    for halvings in range(1, _HALVINGS + 1):
        first = [series(part * lam / 2**halvings) for part in (_BEFORE, 1)]
        try:
            found = [each.rough(each.lam) for each in first]
        except SolveError:
            continue
        if all(change(each.coefficients, orbit.coefficients) <= _GOOD
               for each, orbit in zip(first, found)):
            return found[0], found[1]
    raise SolveError(f"down to λ = {lam / 2**_HALVINGS:.2g} the series is too poor a first guess; "
                     "take a higher order")


def _predicted(before: Orbit, here: Orbit, lam: float) -> Orbit:
    """On the straight line through two solutions."""
    part = (lam - here.lam) / (here.lam - before.lam)
    return Orbit(here.problem, lam, {
        name: {mode: (1 + part) * modes.get(mode, 0.0) - part * old.get(mode, 0.0)
               for mode in modes.keys() | old.keys()}
        for name, modes in here.coefficients.items() for old in [before.coefficients[name]]},
        parameters=here.parameters)
