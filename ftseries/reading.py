r"""The language of equations: text, SymPy equations and expressions, read and written.

====================  =============================================
``x``, ``x(t)``       the field x at the time t
``x''``               its second derivative by t
``x(t - 2*pi/3)``     the field at another time
``=``                 separates the sides; without it "= 0" is meant
``^`` and ``**``      powers
====================  =============================================

Only names that were declared may occur, besides sin, cos, exp, sqrt, pi and diff; a name is any
identifier of Python, such as θ, and λ is the series parameter unless something else is called so.
A decimal, and a float by its shortest decimal, is the fraction that it looks like.  Nothing is left
out, nothing is executed, and what is too large is refused: see :mod:`ftseries.expressions`.
"""

from __future__ import annotations

import ast
import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from .aliases import Expr
from .errors import InputError
from .expressions import (
    FUNCTIONS,
    BoundError,
    Reader,
    checked,
    differentiated,
    is_number,
    parsed,
    quoted,
    sympified,
)

__all__ = ["Language"]

_UNREADABLE = "cannot be read; use numbers, names, + - * / ** and calls such as sin(x)"

#: what a text may call, and the names with a meaning
_CALLS = {*FUNCTIONS, "sqrt", "diff"}
_KNOWN = {*_CALLS, "pi"}
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
    (r"#.*", "leave comments out"),
    (r"\blambda\b", "λ is written {lam}"),
    (r"(?<![\w.])\d+\.?\d*\s*(?!e[-+]?\d)[^\W\d]\w*", "write products with *, such as 2*x"),
    (r"\b(sin|cos|exp|sqrt)\s+\w+", "write functions with brackets, such as sin(x)"),
    (r"\b\w+\s+\w+", "write products with *, such as a*x"),
    (r"[^\w\s+\-*/^().,']", "write numbers, names, + - * / ** and calls such as sin(x)"),
)


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
    #: the values that were put in so far
    used: set[str] = field(default_factory=set, compare=False)

    def __post_init__(self) -> None:
        names = [self.time, self.lam, *self.fields, *self.scalars, *self.parameters, *self.values]
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise InputError(f"{', '.join(twice)} is declared twice; each unknown, each "
                             "parameter, λ and the time needs a name of its own")

    @property
    def symbols(self) -> dict[str, Expr]:
        """Name to symbol, of everything but the fields; λ is the series parameter if still free."""
        names = (self.time, self.lam, *self.scalars, *self.parameters)
        free = {} if "λ" in (*self.fields, *self.values) else {"λ": sp.Symbol(self.lam)}
        return free | {name: sp.Symbol(name) for name in names}

    def equation(self, source: Any) -> Expr:
        """An expression that is to vanish, from a text, a SymPy Eq or an expression."""
        sides: Sequence[Any] = (source,)
        if isinstance(source, str):
            sides = source.split("=")
            if len(sides) > 2:
                raise InputError(f"{quoted(source)} has more than one '='; write one equation, "
                                 "with one '='")
        elif isinstance(source, sp.Equality):
            sides = source.args
        left, *right = (self._read(side, source) for side in sides)
        return self._readable(sp.Add(left, *(-e for e in right)), source)

    def expression(self, source: Any) -> Expr:
        """An expression, from a text or from SymPy."""
        return self._readable(self._read(source, source), source)

    def written(self, e: Expr) -> str:
        """An expression as text that :meth:`equation` reads again: x'' for derivatives."""
        time, e = sp.Symbol(self.time), e.xreplace({sp.E: sp.Symbol("exp(1)")})

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

    def _read(self, source: Any, whole: Any) -> Expr:
        """One side of an equation, in this language's symbols, decimals as fractions."""
        reader = _Reader(self)
        try:
            if isinstance(source, str):
                e = reader.built(self._tree(source, whole))
            else:
                e = sympified(source)
            if e is None:
                raise InputError(f"{quoted(source)} is not an equation; give a SymPy Eq, an "
                                 "expression or a text")
            return checked(reader.rebuilt(checked(e)))
        except BoundError as error:
            raise InputError(f"{quoted(whole)} cannot be read: {error}") from None
        except SyntaxError as error:
            raise InputError(f"{quoted(whole)} {error.msg or _UNREADABLE}") from None

    def _readable(self, e: Expr, whole: Any) -> Expr:
        """The expression in the form in which it is read again, as from a file."""
        reader = _Reader(self)
        try:
            tree = parsed(self.written(checked(e)))
            if e.has(sp.nan, sp.oo, -sp.oo, sp.zoo, sp.I) or not (
                    e.free_symbols <= set(reader.symbols.values())):
                return e                                             # is refused later
            return checked(reader.rebuilt(reader.built(tree)))
        except SyntaxError:                                          # so is what has no text
            return e
        except BoundError as error:
            raise InputError(f"{quoted(whole)} cannot be written out: {error}") from None

    def _tree(self, text: str, whole: str) -> ast.expr:
        """The syntax tree of a text; refuses names that were not declared."""
        try:
            tree = parsed(text)
        except SyntaxError:
            raise SyntaxError(f"cannot be read: {self._slip(text.strip())}") from None
        nodes = list(ast.walk(tree))
        for node in nodes:
            if isinstance(node, ast.Subscript):
                name = getattr(node.value, "id", None)
                if name is None:
                    raise SyntaxError("cannot be read: write primes behind the name of a field, "
                                      "such as x''(t)")
                if name not in self.fields:
                    raise SyntaxError(f"cannot be read: it contains {_source(node)}, but {name} is "
                                      "not declared as a Field; declare it or correct it")
        known = {*self.symbols, *self.values, *self.fields, *_KNOWN}
        calls = {_called(n) for n in nodes if isinstance(n, ast.Call)}
        strange = sorted({n.id for n in nodes if isinstance(n, ast.Name)} - known)
        for name in strange:
            if name in calls:
                instead = f": {_INSTEAD[name]}" if name in _INSTEAD else ""
                raise SyntaxError(f"contains the function {name}, which is not known here; use "
                                  f"rational powers, sqrt, exp, sin and cos{instead}")
        if strange:
            raise SyntaxError(f"contains {', '.join(strange)}, which is neither an unknown, a "
                              "parameter, λ, the time nor a function known here (sin, cos, exp, "
                              "sqrt); declare it or correct it")
        wrong = calls - set(self.fields) - _CALLS
        if wrong:
            raise SyntaxError(f"calls {', '.join(sorted(wrong))}, which is not a function of time; "
                              "declare it as a Field, or write the product with *")
        return tree

    def _slip(self, text: str) -> str:
        """What is wrong with a text that is no expression, and the way out."""
        if not text:
            return "a side is empty; write an expression there, such as 0"
        if text.count("(") != text.count(")"):
            return f"{quoted(text)} has a bracket that is not closed"
        for pattern, advice in _SLIPS:
            match = re.search(pattern, text)
            if match:
                return (f"{quoted(match.group())} in {quoted(text)}; "
                        f"{advice.format(lam=self.lam)}")
        return f"{quoted(text)} is not an expression; write products with * and powers with **"


class _Reader(Reader):
    """Puts expressions of a language together."""

    def __init__(self, language: Language) -> None:
        self.language, self.time = language, sp.Symbol(language.time)
        self.symbols = language.symbols

    def name(self, name: str) -> Expr:
        language = self.language
        if name in language.fields:
            return sp.Function(name)(self.time)
        if name in language.values:
            return sp.Symbol(name)                       # the value is put in by `symbol`
        if name == "pi":
            return sp.pi
        if name not in self.symbols:
            raise SyntaxError
        return self.symbols[name]

    def symbol(self, symbol: Expr) -> Expr:
        name = unicodedata.normalize("NFKC", symbol.name)
        if name in self.language.values:
            self.language.used.add(name)
            return self.language.values[name]
        return self.symbols.get(name, symbol)

    def call(self, node: ast.expr, arguments: Sequence[Expr]) -> Expr:
        name = _called(node)
        if name in self.language.fields:
            return self._field(node, name, arguments)
        if name == "diff":
            return self._derivative(node, arguments)
        if len(arguments) != 1:
            raise SyntaxError
        return self.function(name, arguments[0])

    def _field(self, node: ast.expr, name: str, arguments: Sequence[Expr]) -> Expr:
        """x(t), x(t - c), x''(t - c)."""
        primed = node.func if isinstance(node, ast.Call) else node
        times = int(ast.unparse(primed.slice)) if isinstance(primed, ast.Subscript) else 0
        if not isinstance(node, ast.Call):
            return differentiated(self.name(name), self.time, times)
        if len(arguments) != 1:
            self._no(node)
        (argument,) = arguments
        if self.time not in argument.free_symbols or argument.atoms(AppliedUndef):
            at = (f"contains {name}({_source(node.args[0])}), but {name} is a function of the time "
                  f"{self.time}")
            if is_number(argument):
                raise SyntaxError(f"{at} and initial conditions are not given; what λ and the "
                                  "phase are is said by 'fixed' in the Field")
            raise SyntaxError(f"{at}; write {name}({self.time}) or {name}({self.time} - 2*pi/3), "
                              "and products with *")
        return differentiated(sp.Function(name)(argument), self.time, times)

    def _derivative(self, node: ast.expr, arguments: Sequence[Expr]) -> Expr:
        """diff(e, t), diff(e, t, 2), diff(e, t, t)."""
        e, *variables = arguments or self._no(node)
        times = 0
        for i, v in enumerate(variables):
            if v == self.time:
                times += 1
            elif v.is_Integer and v >= 0 and i and variables[i - 1] == self.time:
                times += int(v) - 1
            else:
                self._no(node)
        return differentiated(e, self.time, times) if variables else self._no(node)

    def _no(self, node: ast.expr) -> Any:
        raise SyntaxError(f"contains {_source(node)}, which is not understood; write x({self.time} "
                          f"- 2*pi/3) for a field x at another time, and diff(x, {self.time}) or "
                          f"diff(x, {self.time}, 2) for derivatives by {self.time}")

    def other(self, e: Expr) -> Expr:
        if e is sp.E or isinstance(e, (sp.sin, sp.cos, sp.exp)):
            return self.function("exp" if e is sp.E else type(e).__name__, *(
                map(self.rebuilt, e.args) if e.args else [sp.S.One]))
        if isinstance(e, AppliedUndef):
            name = unicodedata.normalize("NFKC", e.func.__name__)
            return sp.Function(name)(*map(self.rebuilt, e.args))
        if isinstance(e, sp.Derivative):
            by = {self.symbol(v) for v in e.variables}
            if by != {self.time}:
                raise SyntaxError(f"contains {quoted(e)}, which is not a derivative by {self.time}")
            return differentiated(self.rebuilt(e.expr), self.time, len(e.variables))
        if isinstance(e, sp.Subs) and len(e.variables) == 1 and isinstance(
                e.expr, sp.Derivative) and isinstance(e.expr.expr, AppliedUndef) and \
                set(e.expr.variables) == set(e.variables) == set(e.expr.expr.args):
            inner = sp.Function(unicodedata.normalize("NFKC", e.expr.expr.func.__name__))
            return sp.Subs(inner(*e.variables).diff(*e.expr.variables), e.variables[0],
                           self.rebuilt(e.point[0])).doit()
        raise SyntaxError(f"contains {self.language.written(e)}, which has no Fourier-Taylor "
                          "series here; only + - * /, rational powers, exp, sin and cos are known")


def _called(node: ast.expr) -> str:
    """The name that is called, or that has primes."""
    inner = node.func if isinstance(node, ast.Call) else node
    inner = inner.value if isinstance(inner, ast.Subscript) else inner
    return getattr(inner, "id", "a number or a bracket")


def _source(node: ast.expr) -> str:
    """The text of a node, shortened."""
    text = re.sub(r"\[(\d+)\]", lambda primes: "'" * min(int(primes.group(1)), 9),
                  ast.unparse(node))
    return text if len(text) < 80 else text[:60] + "…"
