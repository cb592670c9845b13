r"""From SymPy expressions to series.

Formula.  With t the time, τ = ωt and unknowns u(t) = s_u U(τ; Λ), ω = s_ω Ω, λ = l Λ, where the
*scales* s are irrational leading coefficients of the seed and l is the unit of λ,

====================  ==================================
d^k u/dt^k            ω^k d^k U/dτ^k
u(t + c)              U(τ + ωc), ωc a rational part of 2π
cos nωt, sin nωt      known functions
+ - * / powers        the same, exponents rational
exp, sin, cos         the same, of an argument that vanishes at λ = 0
====================  ==================================

A subexpression is translated to (factor, function): the SymPy number ``factor`` collects the
scales and the unit, the function builds the rest from series.  Terms of a sum must have rational
ratios of their factors; anything else is refused by name.  No term is ever dropped.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING, Any, TypeAlias

import sympy as sp
from sympy.core.function import AppliedUndef

from .aliases import Expr, Function
from .arguments import rational
from .errors import InputError
from .expressions import is_number, quoted
from .problem import Field, Scalar

if TYPE_CHECKING:
    from .problem import Problem
    from .reading import Language

__all__ = ["LAM", "Translator", "harmonic", "lead", "plain"]

#: roots and functions in a number
_ROOTS = 10
#: the key of λ itself among the series: no unknown can have this name
LAM = ""
#: the series by name, λ among them; what builds a function from them
Environment: TypeAlias = dict[str, Function]
Build: TypeAlias = Callable[[Environment], Function]


@lru_cache(maxsize=1000)
def plain(number: Expr) -> Expr:
    """A SymPy number, written so that a rational one is seen to be rational.

    Numbers with more than a few roots are refused: to simplify them may take any time.

    >>> plain(sp.sqrt(12) / sp.sqrt(3)), plain(sp.cbrt(3) / (2 * sp.Integer(3)**sp.Rational(-2, 3)))
    (2, 3/2)
    """
    if number.is_Rational:
        return number
    roots = number.atoms(sp.Pow, sp.Function)
    if len(roots) > _ROOTS:
        raise InputError(f"the number {quoted(number)} has {len(roots)} roots or functions in it; "
                         f"at most {_ROOTS} can be compared, so write it as a decimal")
    return sp.radsimp(sp.powsimp(sp.simplify(number), force=True))


def harmonic(wave: Expr, time: Expr, omega: Expr) -> int | None:
    """n in cos(nωt) or sin(nωt); None for anything else."""
    if not isinstance(wave, (sp.sin, sp.cos)) or not wave.has(time) or wave.atoms(AppliedUndef):
        return None
    n = sp.expand(sp.expand(wave.args[0]) / (omega * time))
    n = plain(n) if is_number(n) else n
    return int(n) if n.is_Integer and n > 0 else None


class Translator:
    """Translates the equations of one problem.

    Attributes
    ----------
    surd : bool
        Was there a shift that brings √3 into single terms?
    delicate : list
        (equation, subexpression, function) of each power, exp, sin and cos: what may fail to be
        analytic at λ = 0.
    """

    def __init__(self, problem: Problem, language: Language, scales: dict[str, Expr],
                 unit: Expr = sp.S.One) -> None:
        self.problem, self.language, self.scales, self.unit = problem, language, scales, unit
        self.time = sp.Symbol(language.time)
        self.omega = sp.Symbol(problem.frequency) if problem.frequency else sp.S.One
        self.surd = False
        self.delicate: list[tuple[str, Expr, Build]] = []

    def residual(self, e: Expr, where: str) -> Build:
        """The function that builds the residual of an equation from series."""
        mentioned = {s.name for s in e.free_symbols} | {
            f.func.__name__ for f in e.atoms(AppliedUndef)}
        if not mentioned & set(self.problem.unknowns):
            raise InputError(f"equation {where}, {self.language.written(e)} = 0, contains no "
                             "unknown; check what was declared")
        return self.build(e, where)[1]

    def build(self, e: Expr, where: str) -> tuple[Expr, Build]:
        """(factor, function): e = factor · function(series)."""
        if is_number(e):
            if not e.is_finite or e.is_real is False:
                raise InputError(f"equation {where} contains the number {e}; it must be finite "
                                 "and real")
            return e, _one                                   # 2/3, sqrt(3), pi
        if e.is_Symbol:
            return self._symbol(e, where)
        if e.is_Add:
            return self._sum(e, where)
        if e.is_Mul:
            factors, builds = zip(*(self.build(arg, where) for arg in e.args), strict=True)
            return sp.Mul(*factors), _product([b for b in builds if b is not _one])
        if e.is_Pow and e.exp.is_Rational:
            return self._power(e, where)
        if isinstance(e, (sp.Derivative, sp.Subs, AppliedUndef)):
            return self._field(e, where)
        if isinstance(e, (sp.sin, sp.cos, sp.exp)):
            return self._function(e, where)
        raise InputError(f"equation {where} contains {self.language.written(e)}, which has no "
                         "Fourier-Taylor series here; only + - * /, rational powers, exp, sin and "
                         "cos are known")

    def _symbol(self, e: Expr, where: str) -> tuple[Expr, Build]:
        name, problem = e.name, self.problem
        if name == self.language.lam:
            return self.unit, lambda env: env[LAM]
        if name in problem.parameters:
            return sp.S.One, lambda env: env[LAM].expansion.parameter(name)
        if isinstance(problem.unknowns.get(name), Scalar):
            return self.scales.get(name, sp.S.One), lambda env: env[name]
        if isinstance(problem.unknowns.get(name), Field):
            raise InputError(f"equation {where} contains the bare symbol {name}; write "
                             f"{name}({self.time})")
        if e == self.time:
            raise InputError(f"equation {where} contains the time {e} outside of cos and sin of "
                             f"n*{self.omega}*{e}, so it is not periodic; leave it out, or expand "
                             "with an addition theorem")
        raise InputError(f"equation {where} contains {name}, which is neither an unknown, a "
                         "parameter nor λ; declare it, or give it a value")

    def _sum(self, e: Expr, where: str) -> tuple[Expr, Build]:
        parts = [self.build(arg, where) for arg in e.args]
        common = sp.S.One if all(factor.is_Rational for factor, _ in parts) else parts[0][0]
        weighted = []
        for arg, (factor, part) in zip(e.args, parts, strict=True):
            ratio = plain(factor / common)
            if not ratio.is_Rational:
                first, other = map(self.language.written, (e.args[0], arg))
                raise InputError(f"equation {where}: the term {other} differs from {first} by the "
                                 f"factor {ratio}, which is not rational; choose other units")
            weighted.append((rational(ratio), part))

        def build(env: Environment) -> Function:
            total = None
            for weight, part in weighted:
                term = part(env)
                if part is _one:
                    term = env[LAM].expansion.constant(weight)
                elif weight != 1:
                    term = term * weight
                total = term if total is None else total + term
            return total
        return common, build

    def _power(self, e: Expr, where: str) -> tuple[Expr, Build]:
        factor, inner = self.build(e.base, where)
        exponent = rational(e.exp)
        sign = -1 if factor.is_negative else 1              # (-2x)^(1/2) is 2^(1/2) (-x)^(1/2)

        def build(env: Environment) -> Function:
            base = inner(env)
            return (base if sign == 1 else -base) ** exponent
        if exponent.q != 1 or exponent < 0:
            self.delicate.append((where, e, build))
        return (sign * factor) ** e.exp, build

    def _field(self, e: Expr, where: str) -> tuple[Expr, Build]:
        """u(t + c) or a time derivative of it."""
        times, inner, shift = 0, e, sp.S.Zero
        text = self.language.written(e) if not isinstance(e, sp.Derivative) else str(e)
        if isinstance(inner, sp.Subs):
            shift = inner.point[0] - self.time
            inner = inner.expr.xreplace({inner.variables[0]: self.time})
        if isinstance(inner, sp.Derivative):
            if set(inner.variables) != {self.time}:
                raise InputError(f"equation {where}: {text} is not a derivative by {self.time}")
            inner, times = inner.expr, len(inner.variables)
        name = getattr(inner.func, "__name__", "")
        if not isinstance(self.problem.unknowns.get(name), Field) or len(inner.args) != 1:
            raise InputError(f"equation {where} contains {text}, but {name} is not declared as a "
                             "Field; declare it or correct it")
        if times > 2:
            raise InputError(f"equation {where} contains {text}: derivatives up to the second are "
                             "known; write the equation as a system")
        shift += inner.args[0] - self.time
        turn = plain(sp.simplify(shift * self.omega / (2 * sp.pi)))
        if not turn.is_Rational:
            raise InputError(f"equation {where}: in {text} the time differs from {self.time} by "
                             f"{shift}, which is not a rational part of the period "
                             f"{2 * sp.pi / self.omega}; only such shifts are known")
        fraction, frequency = rational(turn), self.problem.frequency
        self.surd = self.surd or 4 % fraction.q != 0

        def build(env: Environment) -> Function:
            series = env[name]
            if times:
                series = series.diff(times)
                if frequency:
                    series = env[frequency] ** times * series
            return series.shift(fraction) if fraction else series
        speed = self.scales[frequency] ** times if frequency in self.scales else sp.S.One
        return self.scales.get(name, sp.S.One) * speed, build

    def _function(self, e: Expr, where: str) -> tuple[Expr, Build]:
        which, n = type(e).__name__, harmonic(e, self.time, self.omega)
        if n:
            return sp.S.One, lambda env: getattr(env[LAM].expansion, which)(n)
        if not isinstance(e, sp.exp) and e.args[0].has(self.time) and not e.atoms(AppliedUndef) \
                and sp.diff(e.args[0], self.time, 2) == 0:
            if (sp.diff(e.args[0], self.time) / self.omega).is_Integer:
                raise InputError(f"equation {where} contains {e}, whose phase is not zero; expand "
                                 "it with an addition theorem, or count the time from another "
                                 f"moment, so that only cos and sin of n*{self.omega}*{self.time} "
                                 "are left")
            raise InputError(f"equation {where} contains {e}, which does not have the period of "
                             f"the ansatz; measure time so that it becomes {which}(n*{self.omega}*"
                             f"{self.time}) with a whole n")
        factor, build = self.build(e.args[0], where)
        factor = plain(factor)
        if not factor.is_Rational:
            raise InputError(f"equation {where}: the argument of {self.language.written(e)} has "
                             f"the factor {factor}, which is not rational; choose other units")
        weight = rational(factor)

        def apply(env: Environment) -> Function:
            inner = build(env)
            return getattr(inner * weight if weight != 1 else inner, which)()
        self.delicate.append((where, e, apply))
        return sp.S.One, apply


def lead(e: Expr, problem: Problem, language: Language) -> Any:
    """How far the Fourier orders of the known functions in an expression run ahead of λ.

    λ^m cos nωt has n - m; the unknowns count 0.  Sums have the largest, products the sum.
    """
    if e.is_Symbol:
        return -1 if e.name == language.lam else 0
    omega = sp.Symbol(problem.frequency) if problem.frequency else 1
    n = harmonic(e, sp.Symbol(language.time), omega)
    if n or not e.args or isinstance(e, (AppliedUndef, sp.Derivative, sp.Subs)):
        return n or 0
    parts = [lead(arg, problem, language) for arg in e.args]
    if e.is_Add:
        return max(parts)
    if e.is_Mul:
        return sum(parts)
    if e.is_Pow and e.exp.is_Integer and e.exp > 0:
        return int(e.exp) * parts[0]
    return sp.oo if parts[0] > 0 else 0


def _one(env: Environment) -> Function:
    return 1


def _product(builds: list[Build]) -> Build:
    def build(env: Environment) -> Function:
        total = None
        for part in builds:
            total = part(env) if total is None else total * part(env)
        return total
    return build
