r"""Why there are no first steps: what a refusal can say about the motions near rest.

Formula.  With u = u_0 + ε a e^{st}, λ = 0, the terms of order ε are M(s) a.  The *rates* s with
det M(s) = 0 say what free motions near the state of rest u_0 do; only a pair s = ±iω oscillates.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeAlias

import sympy as sp
from mpmath.libmp import NoConvergence
from sympy.core.function import AppliedUndef

from .aliases import Expr
from .precision import working
from .problem import Field, Scalar

if TYPE_CHECKING:
    from .symbolic import Equations

__all__ = ["rates", "free_motions", "forced_motion", "wider"]

#: a state of rest, field to value
State: TypeAlias = dict[str, Expr]

#: below this the real or imaginary part of a computed rate counts as zero
_SMALL = 1e-6


def rates(problem: Equations, state: State) -> list[complex] | None:
    """The rates s of the free motions near a state of rest; None where M(s) gives no polynomial.

    Free parameters count 1.
    """
    t, s, small = sp.Symbol(problem.variable), sp.Dummy("s"), sp.Dummy("small")
    sizes = {name: sp.Dummy(name) for name in problem.language.fields}
    at_rest = {sp.Symbol(problem.language.lam): 0} | {
        sp.Symbol(name): 1 for name in problem.parameters}
    rows = []
    for e in problem.expressions.values():
        e = e.replace(lambda f: isinstance(f, AppliedUndef), lambda f: state.get(
            f.func.__name__, 0) + small * sizes[f.func.__name__] * sp.exp(s * f.args[0]))
        linear = sp.diff(e.subs(at_rest).doit(), small).subs(small, 0)
        rows.append([sp.expand(sp.diff(linear, a) * sp.exp(-s * t)) for a in sizes.values()])
    matrix = sp.Matrix(rows)
    if matrix.rows != matrix.cols:
        return None
    polynomial = sp.expand(matrix.det())
    if polynomial.free_symbols != {s} or not polynomial.is_polynomial(s):
        return None
    try:
        with working():                                             # nroots sets mp.dps
            return [complex(z) for z in sp.Poly(polynomial, s).nroots(n=15, maxsteps=200)]
    except NoConvergence:
        return None


def free_motions(problem: Equations, states: list[State]) -> str | None:
    """Why nothing oscillates near the states of rest; None where something does."""
    found: list[tuple[State, list[complex]]] = []
    for state in states:
        roots = rates(problem, state)
        if not roots or any(abs(r.real) < _SMALL < abs(r.imag) for r in roots):
            return None
        found.append((state, roots))
    state, roots = max(found, key=lambda f: max(r.real for r in f[1]))
    where = ", ".join(f"{name} = {value}" for name, value in state.items())
    at = f"the state of rest {where}"
    shown = f"as exp(s*t) with s = {_written(roots)}"
    if problem.parameters:
        shown += f" where {' = '.join(problem.parameters)} = 1"
    most = max(r.real for r in roots)
    if all(abs(r) < _SMALL for r in roots):
        return (f"there is no linear force at {at}, so the frequency tends to 0 with the amplitude "
                "and no series begins there; add a linear term, such as x in x'' + x + x**3, or "
                "give a seed about another state of rest")
    if most < _SMALL:
        return (f"a damped free motion has no periodic solution: near {at} motions behave {shown}; "
                "leave the damping out, or add a forcing such as lam*cos(t) and take the frequency "
                "away")
    if any(r.real > _SMALL and abs(r.imag) > _SMALL for r in roots):
        return (f"{at} is unstable: motions near it grow {shown}, and a limit cycle of finite size "
                "is not near it; scale the unknown so that λ, the size of the cycle, is in the "
                "equations: (lam**2 - x**2)*x' in place of eps*(1 - x**2)*x', where eps = lam**2")
    if len(found) > 1:
        return (f"nothing oscillates near the {len(found)} states of rest: near {where}, for "
                f"example, motions behave {shown}; change numbers in the equations so that one "
                "s is imaginary")
    return (f"{at} is a saddle, motions near it behave {shown}, and none oscillates; where there "
            "is another state of rest, give a seed about it")


def forced_motion(problem: Equations, states: list[State]) -> str | None:
    """Why a forced motion does not follow its forcing; None where it may."""
    amplitudes = [name for name, u in problem.unknowns.items() if getattr(u, "fixed", ())]
    if problem.frequency is None and not any(isinstance(u, Scalar)
                                             for u in problem.unknowns.values()):
        if not problem.forcing:
            return ("without an unknown frequency every motion would have the period 2*pi; declare "
                    "one, such as \"omega\": Scalar() with frequency=\"omega\"")
        if amplitudes:
            lam = problem.language.lam
            return (f"the forcing determines the amplitude, but 'fixed' of {', '.join(amplitudes)} "
                    f"fixes it as well; leave out 'fixed': {lam} is the strength of the forcing")
        for state in states:
            for n in sorted({n for _, n in problem.forcing}):
                if any(abs(r - 1j * n) < _SMALL for r in rates(problem, state) or ()):
                    return (f"a resonance: the forcing has the frequency {n} of a free motion, "
                            "which it drives without bound; let the forcing begin at a higher "
                            "power of λ where the equations have non-linear terms, as in "
                            "x'' + x + x**3 = lam**3*cos(t), or let the frequency be unknown")
    return None


def wider(problem: Equations, solvable: Callable[[Equations], bool]) -> str | None:
    """The ansatz that would do, where a wider one does."""
    both = {"modes": "all", "powers": "all"}
    choices: list[tuple[dict[str, Any], type]] = [
        ({"modes": "all"}, Field), ({"powers": "all"}, Field), ({"series": "both"}, Field),
        (both, Field), (both | {"series": "both"}, Field), ({"powers": "all"}, Scalar)]
    for changes, kind in choices:
        other = object.__new__(type(problem))               # copy() would ask for the seed
        vars(other).update(vars(problem))
        other.unknowns = {name: replace(u, **changes) if isinstance(u, kind) else u
                          for name, u in problem.unknowns.items()}
        if other.unknowns != problem.unknowns and solvable(other):
            wanted = ", ".join(
                f"give {name} " + " and ".join(f"{key}={value!r}" for key, value in changes.items()
                                               if getattr(problem.unknowns[name], key) != value)
                for name, u in other.unknowns.items() if u != problem.unknowns[name])
            return f"the ansatz lacks modes or powers of the motion; {wanted}"
    return None


def _written(roots: list[complex]) -> str:
    """The rates with three digits, conjugate ones as one."""
    out = []
    for r in sorted(roots, key=lambda r: (r.real, r.imag)):
        if r.imag > -_SMALL:
            real = f"{r.real:.3g} " if abs(r.real) > _SMALL else ""
            text = f"{real}± {r.imag:.3g}i".strip() if r.imag > _SMALL else real.strip() or "0"
            out.append(text)
    return ", ".join(out)
