r"""The language of equations: text, SymPy equations and expressions, read and written.

====================  =============================================
``x``, ``x(t)``       the field x at the time t
``x''``               its second derivative by t
``x(t - 2*pi/3)``     the field at another time
``=``                 separates the sides; without it "= 0" is meant
``^`` and ``**``      powers
====================  =============================================

Only names that were declared may occur, besides sin, cos, exp, sqrt, pi and diff.  A decimal, and a
float by its shortest decimal, is the fraction that it looks like.
"""

from __future__ import annotations

import ast
import keyword
import re
from dataclasses import dataclass, field
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from .aliases import Expr
from .conversion import in_fractions
from .errors import InputError

__all__ = ["Language", "name_of"]

_SAFE = (ast.Expression, ast.BinOp, ast.UnaryOp, ast.Constant, ast.Name, ast.Load, ast.Call,
         ast.operator, ast.unaryop)
_FUNCTIONS = {"sin": sp.sin, "cos": sp.cos, "exp": sp.exp, "sqrt": sp.sqrt, "diff": sp.diff}
_KNOWN = _FUNCTIONS | {"pi": sp.pi}
#: how some other functions can be written, or why they cannot
_INSTEAD = {"tan": "write sin(x)/cos(x)", "tanh": "write (exp(2*x) - 1)/(exp(2*x) + 1)",
            "sinh": "write (exp(x) - exp(-x))/2", "cosh": "write (exp(x) + exp(-x))/2",
            "log": "take y = log(1 + x) as the unknown, and write exp(y) - 1 for x",
            "ln": "take y = ln(1 + x) as the unknown, and write exp(y) - 1 for x",
            "abs": "|x| has a corner at 0, so that no series exists there",
            "sign": "it jumps at 0, so that no series exists there"}
#: what is often written where an expression cannot be read, and the advice
_SLIPS = (
    (r"[⁰¹²³⁴⁵⁶⁷⁸⁹ⁿ]", "write powers with **, such as x**3"),
    (r"[′″‴’”´`\"]", "write derivatives with the straight ', such as x''"),
    (r"[−–—]", "write the sign -"),
    (r"[·×⋅∙÷]", "write products with * and quotients with /"),
    (r"\blambda\b", "λ is written {lam}"),
    (r"(?<![\w.])\d+\.?\d*\s*(?!e[-+]?\d)[^\W\d]\w*", "write products with *, such as 2*x"),
    (r"\b(sin|cos|exp|sqrt)\s+\w+", "write functions with brackets, such as sin(x)"),
    (r"\w+\s+\w+", "write products with *, such as a*x"),
)


def name_of(key: Any) -> str:
    """The name of a SymPy symbol or function, or a name.

    >>> name_of(sp.Symbol("omega")), name_of(sp.Function("x")), name_of("x")
    ('omega', 'x', 'x')
    """
    name = key if isinstance(key, str) else getattr(key, "name", None) or getattr(
        key, "__name__", None)
    if not isinstance(name, str) or not name.isidentifier():
        raise InputError(f"{key!r} is not a name; give a SymPy symbol or function, or its name")
    if keyword.iskeyword(name):
        raise InputError(f"{name!r} is a word of Python's own; choose another name, such as "
                         f"{name[:3]!r}")
    if name in _KNOWN:
        raise InputError(f"{name!r} has a meaning in equations already; choose another name")
    return name


@dataclass(frozen=True)
class Language:
    """The names that equations may contain; ``values`` are put in wherever a name stands.

    Examples
    --------
    >>> language = Language(time="t", lam="lam", fields=("x",), scalars=("omega",))
    >>> e = language.equation("x'' = -x(t - 2*pi/3)^2 + 0.5*lam")
    >>> e
    -lam/2 + x(t - 2*pi/3)**2 + Derivative(x(t), (t, 2))
    >>> language.written(e)
    "-lam/2 + x'' + x(t - 2*pi/3)**2"
    """

    time: str
    lam: str
    fields: tuple[str, ...]
    scalars: tuple[str, ...] = ()
    parameters: tuple[str, ...] = ()
    values: dict[str, Expr] = field(default_factory=dict)

    def __post_init__(self) -> None:
        names = [self.time, self.lam, *self.fields, *self.scalars, *self.parameters, *self.values]
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise InputError(f"{', '.join(twice)} is declared twice; each unknown, each "
                             "parameter, λ and the time needs a name of its own")

    @property
    def symbols(self) -> dict[str, Expr]:
        """Name to symbol, of everything but the fields."""
        names = (self.time, self.lam, *self.scalars, *self.parameters)
        return {name: sp.Symbol(name) for name in names}

    def equation(self, source: Any) -> Expr:
        """An expression that is to vanish, from a text, a SymPy Eq or an expression."""
        if isinstance(source, str):
            sides = source.split("=")
            if len(sides) > 2:
                raise InputError(f"{source!r} has more than one '='; write one equation, with one "
                                 "'='")
            parts = [self._read(side, source) for side in sides]
            return self._own(parts[0] - parts[1] if len(parts) == 2 else parts[0])
        if isinstance(source, sp.Equality):
            return self._own(source.lhs - source.rhs)
        return self.expression(source)

    def expression(self, source: Any) -> Expr:
        """An expression, from a text or from SymPy."""
        if isinstance(source, str):
            return self._own(self._read(source, source))
        try:
            e = sp.sympify(source)
        except sp.SympifyError:
            e = None
        if not isinstance(e, sp.Expr):
            raise InputError(f"{source!r} is not an equation; give a SymPy Eq, an expression or a "
                             "text")
        return self._own(e)

    def written(self, e: Expr) -> str:
        """An expression as text that :meth:`equation` reads again: x'' for derivatives."""
        time = sp.Symbol(self.time)

        def primed(f: Expr, times: int = 0) -> Expr:
            at = "" if f.args[0] == time else f"({f.args[0]})"
            return sp.Symbol(f.func.__name__ + "'" * times + at)

        def at_point(inner: Expr, variables: Expr, point: Expr) -> Expr:
            f = inner.expr.xreplace({variables[0]: point[0]})
            return primed(f, int(inner.derivative_count))
        e = e.replace(sp.Subs, at_point)
        e = e.replace(lambda d: isinstance(d, sp.Derivative),
                      lambda d: primed(d.expr, int(d.derivative_count)))
        return str(e.replace(lambda f: isinstance(f, AppliedUndef), primed))

    def _own(self, e: Expr) -> Expr:
        """The expression in this language's symbols, decimals as fractions, values put in."""
        symbols = self.symbols | {name: sp.sympify(v) for name, v in self.values.items()}
        e = e.subs({s: symbols[s.name] for s in e.free_symbols if s.name in symbols})
        return in_fractions(e).doit()

    def _read(self, text: str, whole: str) -> Expr:
        """One side of an equation given as text."""
        source = self._with_time(text.replace("^", "**").strip(), whole)
        for name, primes in re.findall(r"([^\W\d]\w*)\s*('+)", source):
            raise InputError(f"{whole!r} cannot be read: it contains {name}{primes}, but {name} is "
                             "not declared as a Field; declare it or correct it")
        try:
            nodes = list(ast.walk(ast.parse(source, mode="eval")))
        except SyntaxError:
            raise InputError(f"{whole!r} cannot be read: {self._slip(text.strip())}") from None
        known = {*self.symbols, *self.values, *self.fields, *_KNOWN}
        calls = {getattr(n.func, "id", "a number or a bracket")
                 for n in nodes if isinstance(n, ast.Call)}
        strange = sorted({n.id for n in nodes if isinstance(n, ast.Name)} - known)
        for name in strange:
            if name == "λ":
                raise InputError(f"{whole!r} contains λ, which is written {self.lam}")
            if name in calls:
                instead = f": {_INSTEAD[name]}" if name in _INSTEAD else ""
                raise InputError(f"{whole!r} contains the function {name}, which is not known "
                                 f"here; use rational powers, sqrt, exp, sin and cos{instead}")
        if strange:
            raise InputError(f"{whole!r} contains {', '.join(strange)}, which is neither "
                             "an unknown, a parameter, λ, the time nor a function known here (sin, "
                             "cos, exp, sqrt); declare it or correct it")
        wrong = calls - set(self.fields) - set(_FUNCTIONS)
        if wrong:
            raise InputError(f"{whole!r} calls {', '.join(sorted(wrong))}, which is not a function "
                             "of time; declare it as a Field, or write the product with *")
        try:
            if not all(isinstance(n, _SAFE) and isinstance(getattr(n, "value", 0), (int, float))
                       for n in nodes):
                raise TypeError
            functions = {name: sp.Function(name) for name in self.fields}
            names = self.symbols | {v: sp.Symbol(v) for v in self.values} | functions
            result = sp.sympify(source, locals={**_KNOWN, **names}, rational=True)
        except (sp.SympifyError, TypeError, ValueError, AttributeError):
            result = None
        if not isinstance(result, sp.Expr):
            raise InputError(f"{whole!r} cannot be read; use numbers, names, + - * / ** and calls "
                             "such as sin(x)")
        return result

    def _slip(self, text: str) -> str:
        """What is wrong with a text that is no expression, and the way out."""
        if not text:
            return "a side is empty; write an expression there, such as 0"
        if text.count("(") != text.count(")"):
            return f"{text!r} has a bracket that is not closed"
        for pattern, advice in _SLIPS:
            match = re.search(pattern, text)
            if match:
                return f"{match.group()!r} in {text!r}; {advice.format(lam=self.lam)}"
        return f"{text!r} is not an expression; write products with * and powers with **"

    def _with_time(self, text: str, whole: str) -> str:
        """x'' as diff(x(t), t, 2), x as x(t)."""
        if not self.fields:
            return text
        pattern = re.compile(rf"\b({'|'.join(map(re.escape, self.fields))})\b\s*('*)\s*(\()?")
        out, end = [], 0
        while match := pattern.search(text, end):
            name, primes, bracket = match.groups()
            out.append(text[end:match.start()])
            end = match.end() if bracket else match.end(2)
            argument = self.time
            if bracket:
                argument, end = self._bracket(text, end, whole)
                if re.fullmatch(r"\s*[-+]?[\d.]+\s*", argument):
                    raise InputError(f"{whole!r} contains {name}({argument}), but {name} is a "
                                     f"function of the time {self.time} and initial conditions are "
                                     "not given; what λ and the phase are is said by 'fixed' in "
                                     "the Field")
                if self.time not in re.findall(r"\w+", argument):
                    raise InputError(f"{whole!r} contains {name}({argument}), but {name} is a "
                                     f"function of the time {self.time}; write {name}({self.time})"
                                     f" or {name}({self.time} - 2*pi/3), and products with *")
            f = f"{name}({argument})"
            out.append(f"diff({f}, {self.time}, {len(primes)})" if primes else f)
        return "".join(out) + text[end:]

    @staticmethod
    def _bracket(text: str, start: int, whole: str) -> tuple[str, int]:
        """(what stands in the bracket that opens before ``start``, where it ends)."""
        depth = 1
        for i in range(start, len(text)):
            depth += {"(": 1, ")": -1}.get(text[i], 0)
            if depth == 0:
                return text[start:i], i + 1
        raise InputError(f"{whole!r} has a bracket that is not closed")
