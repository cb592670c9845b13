r"""Polynomial equations, solved as far as roots of quadratic equations go.

The system is split by factors, linear equations are used up, and a Gröbner basis of what is left
brings an equation for one unknown alone.  In one unknown x, factors :math:`a x^g + b` and
:math:`a x^{2g} + b x^g + c` are solved; what has more terms is *left*: its roots could not be units
of measure, so no series with rational coefficients begins there.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from math import gcd, prod
from typing import TypeAlias

import sympy as sp

from .aliases import Expr
from .errors import InputError
from .precision import working

__all__ = ["Roots", "vanishes"]

Found: TypeAlias = dict[Expr, Expr]

#: the largest number of solutions (by Bézout) of a system that is tried, and of steps
_BEZOUT = 10
_STEPS = 300


class Roots:
    """The real solutions of systems of polynomial equations.

    Attributes
    ----------
    left : list
        The factors with real roots that were not looked for.

    Examples
    --------
    >>> x, y = sp.symbols("x y")
    >>> roots = Roots()
    >>> roots.solve([x * y - 2, x - y - 1], [x, y])
    [{x: 2, y: 1}, {x: -1, y: -2}]
    >>> roots.solve([x**6 - x**2 + x], [x]), roots.left      # 0, and a root that is too hard
    ([{x: 0}], [x**5 - x + 1])
    """

    def __init__(self) -> None:
        self.left: list[Expr] = []

    def solve(self, equations: Sequence[Expr], unknowns: Sequence[Expr]) -> list[Found]:
        """Unknown to value; an unknown that stays free is missing, and may occur in values."""
        self.steps = 0
        out: list[Found] = []
        for found in self._solve(list(equations), list(unknowns), False):
            found = {s: _tidy(found[s]) for s in unknowns if s in found}
            if found not in out:
                out.append(found)
        return out

    def _solve(self, equations: list[Expr], unknowns: list[Expr], reduced: bool) -> list[Found]:
        self.steps += 1
        if self.steps > _STEPS:
            raise InputError("the polynomial equations have too many solutions")
        equations = [e for e in map(sp.expand, equations) if not vanishes(e)]
        equations.sort(key=sp.count_ops)
        if any(not e.has(*unknowns) for e in equations):
            return []
        if not equations:
            return [{}]
        for i, e in enumerate(equations):
            constant, factors = sp.factor_list(e, *unknowns)
            factors = [(f, k) for f, k in factors if f.has(*unknowns)]
            rest = equations[:i] + equations[i + 1:]
            if not factors:                               # its terms cancel after all
                return self._solve(rest, unknowns, reduced) if vanishes(constant) else []
            if len(factors) > 1 or factors[0][1] > 1:
                return [found for f, _ in factors
                        for found in self._solve([f, *rest], unknowns, False)]
        for choose in (_linear, self._single):
            for e in equations:
                chosen = choose(e, unknowns)
                if chosen:
                    return self._put_in(*chosen, equations, e, unknowns)
        if not reduced and len(equations) > 1:
            degrees = [sp.Poly(e, *unknowns).total_degree() for e in equations]
            if prod(sorted(degrees)[-len(unknowns):]) > _BEZOUT:
                raise InputError("the polynomial equations have too many solutions")
            return self._solve(list(sp.groebner(equations, *unknowns, order="lex").exprs), unknowns,
                               True)
        return [{}]                                       # infinitely many: the unknowns stay free

    def _single(self, e: Expr, unknowns: list[Expr]) -> tuple[Expr, list[Expr]] | None:
        """The only unknown in e, and its values; those that are too hard are left."""
        inside = [s for s in unknowns if e.has(s)]
        if len(inside) > 1:
            return None
        values = _radicals(e, inside[0])
        if values is None and _may_be_real(sp.Poly(e, inside[0])):
            self.left.append(e)
        return inside[0], values or []

    def _put_in(self, s: Expr, values: list[Expr], equations: list[Expr], e: Expr,
                unknowns: list[Expr]) -> list[Found]:
        rest, others = [f for f in equations if f is not e], [u for u in unknowns if u != s]
        return [found | {s: value.xreplace(found)} for value in values for found in self._solve(
            [sp.numer(sp.together(f.xreplace({s: value}))) for f in rest], others, False)]


def _linear(e: Expr, unknowns: list[Expr]) -> tuple[Expr, list[Expr]] | None:
    """An unknown that e contains linearly, with a coefficient without unknowns; its value."""
    for s in unknowns:
        if e.has(s):
            p = sp.Poly(e, s)
            if p.degree() == 1 and not p.LC().has(*unknowns):
                return s, [sp.expand(-p.nth(0) / p.LC())]
    return None


def _radicals(e: Expr, s: Expr) -> list[Expr] | None:
    """The real roots of a polynomial in x^g of degree 1 or 2; None of any other."""
    p = sp.Poly(e, s)
    g = reduce(gcd, (i for (i,) in p.monoms()))
    if g == 0 or p.degree() > 2 * g:
        return None
    a, b, c = p.nth(2 * g), p.nth(g), p.nth(0)
    if a == 0:
        powers = [-c / b]
    else:
        root = sp.sqrt(_tidy(sp.expand(b**2 - 4 * a * c)))
        powers = [(-b + sign * root) / (2 * a) for sign in (1, -1)]
    values: list[Expr] = []
    for z in map(_tidy, powers):
        if z == 0:
            values.append(sp.S.Zero)
        elif not _is_negative(z, lambda x: abs(sp.im(x)) > 1e-20):
            negative = _is_negative(z, lambda x: sp.re(x) < 0)
            if g % 2:
                values.append(-_root(-z, g) if negative else _root(z, g))
            elif not negative:
                values += [_root(z, g), -_root(z, g)]
    return values


def _may_be_real(p: sp.Poly) -> bool:
    """Has a polynomial a real root?  Only rational ones are decided."""
    return not p.domain.is_QQ and not p.domain.is_ZZ or p.count_roots() > 0


def _is_negative(z: Expr, test: Callable[[Expr], bool]) -> bool:
    return not z.free_symbols and bool(test(_numeric(z, 30)))


def _root(z: Expr, g: int) -> Expr:
    return sp.sqrtdenest(sp.root(z, g)) if g > 1 else z


def _tidy(value: Expr) -> Expr:
    return value if value.is_Rational else sp.simplify(sp.sqrtdenest(value))


def vanishes(e: Expr) -> bool:
    """Is an expanded expression zero?  Numbers with roots are decided by 40 digits."""
    if e.is_Rational or e.free_symbols:
        return bool(e == 0)
    return bool(abs(_numeric(e, 40)) < sp.Float("1e-30"))


def _numeric(e: Expr, digits: int) -> Expr:
    with working():                                                 # SymPy computes with mpmath
        return sp.N(e, digits)
