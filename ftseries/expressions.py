r"""From texts and SymPy expressions of strangers to SymPy: bounded before anything is computed.

A text is taken apart by Python's own parser, and nothing of it is executed: it holds numbers,
names, + - * / ** and calls, and each of them is put together here.  A SymPy expression is put
together again in the same way.  So 9**9**9**9 is refused by its size, and not computed.

====================  ========================================================
``LENGTH``            characters of a text
``LEAVES``            numbers and names in it
``DEPTH``             levels of brackets, powers and functions, one in the other
``DIGITS``            digits of a number, and characters of a name
``DEGREE``            exponents, and the degree of an expression multiplied out
``TERMS``             terms of an expression multiplied out
``NESTED``            functions in the arguments of functions
``ORDERS``            orders of derivatives that are carried out
====================  ========================================================
"""

from __future__ import annotations

import ast
import keyword
import math
import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import accumulate
from typing import Any

import numpy as np
import sympy as sp
from sympy.core.function import AppliedUndef

from .aliases import Expr
from .arguments import decimal, shown
from .conversion import in_fractions, symbolic, to_sympy
from .errors import InputError
from .precision import working

__all__ = ["FUNCTIONS", "BoundError", "Reader", "by_name", "checked", "differentiated",
           "expression", "is_number", "name_of", "parsed", "quoted", "sympified"]

LENGTH, LEAVES, DEPTH, DIGITS, DEGREE, TERMS = 10_000, 1000, 50, 1000, 100, 1000
NESTED, ORDERS = 5, 10
#: denominators of exponents, and nodes of a SymPy expression
_ROOTS, _NODES = 10**6, 10 * LEAVES

#: the functions of one variable that have a series, sqrt apart
FUNCTIONS = {"sin": sp.sin, "cos": sp.cos, "exp": sp.exp}
#: names with a meaning of their own
_KNOWN = {*FUNCTIONS, "sqrt", "diff", "pi"}
#: what some programs write for no number, and SymPy for the imaginary unit
_NO_NUMBERS = {"nan", "NaN", "inf", "Inf", "infinity", "oo", "zoo", "I"}
#: all that a text may consist of
_FOREIGN = re.compile(r"[^\w\s+\-*/^().,']")
#: a number, up to the sign of its exponent
_WORD = re.compile(r"(\d+\.?\d*|\.\d+)([eE]\d*)?")
_NUMBER = re.compile(r"(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")


class BoundError(InputError):
    """What is given is larger than this module allows; the message does not quote it."""


def quoted(source: Any) -> str:
    """What was given, as messages quote it.

    >>> quoted("x"), len(quoted("x" * 1000))
    ("'x'", 63)
    """
    if isinstance(source, sp.Basic) and not _is_short(source):
        return f"a long SymPy expression of type {type(source).__name__}"
    if not isinstance(source, str):
        return shown(source).rstrip(".")
    return repr(source if len(repr(source)) <= 240 else source[:60] + "…")


def _is_short(e: sp.Basic) -> bool:
    """Can an expression be printed?  SymPy computes 9**9**9**9 for it."""
    level = nodes = [e]
    for _ in range(DEPTH):
        level = [a for node in level for a in node.args]
        nodes = nodes + level
        if not level or len(nodes) > LEAVES:
            break
    return not level and not any(p.is_Pow and p.is_number and (
        p.exp.args or abs(p.exp) > DIGITS) for p in nodes)


def name_of(key: Any) -> str:
    """The name of a SymPy symbol or function, or a name, written as Python writes it (NFKC).

    >>> name_of(sp.Symbol("omega")), name_of(sp.Function("x")), name_of("x")
    ('omega', 'x', 'x')
    """
    name = key if isinstance(key, str) else getattr(key, "name", None) or getattr(
        key, "__name__", None)
    if not isinstance(name, str) or not name.isidentifier():
        raise InputError(f"{quoted(key)} is not a name; give a SymPy symbol or function, or its "
                         "name")
    name = unicodedata.normalize("NFKC", name)
    if len(name) > DIGITS:
        raise InputError(f"{quoted(name)} has {len(name)} characters; a name has at most {DIGITS}")
    if keyword.iskeyword(name):
        raise InputError(f"{name!r} is a word of Python's own; choose another name, such as "
                         f"{name[:3]!r}")
    if name in _KNOWN:
        raise InputError(f"{name!r} has a meaning in equations already; choose another name")
    return name


def by_name(given: Mapping[Any, Any]) -> dict[str, Any]:
    """The same with names for keys; refuses two keys of one name."""
    named: dict[str, Any] = {}
    for key, value in given.items():
        name = name_of(key)
        if name in named:
            raise InputError(f"{name} is given twice, as Python writes names (NFKC); give each a "
                             "name of its own")
        named[name] = value
    return named


# --- texts ----------------------------------------------------------------------------------------

def parsed(text: str) -> ast.expr:
    """The syntax tree of a text; numbers are SymPy rationals, and x'' is written x[2].

    Raises
    ------
    BoundError
        The text is beyond the bounds of this module.
    SyntaxError
        It is no expression.
    """
    _bound(len(text), LENGTH, "characters in the text")
    text = unicodedata.normalize("NFC", text)              # a letter and its accent are one
    foreign = _FOREIGN.search(text)
    if foreign:
        raise SyntaxError(foreign.group())
    words = re.findall(r"[\w.]+", text)
    _bound(max(map(len, words), default=0), DIGITS, "characters in one name or number")
    if any(not (word[0].isalpha() or word[0] == "_" or _WORD.fullmatch(word)) for word in words):
        raise SyntaxError                                    # Python reads 1if as 1 if, and warns
    _bound(len(words), LEAVES, "numbers and names")
    _bound(max(accumulate((sign == "(") - (sign == ")") for sign in re.findall(r"[()]", text)),
               default=0), DEPTH, "brackets in each other")
    source = re.sub("'+", lambda primes: f"[{len(primes.group())}]", text.replace("^", "**"))
    source = " ".join(source.split())
    try:
        tree = ast.parse(source, mode="eval").body
    except (RecursionError, MemoryError):
        raise _too_deep() from None
    encoded = source.encode()
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant):
            node.value = _number(encoded[node.col_offset:node.end_col_offset].decode())
    return tree


def _number(text: str) -> Any:
    match = _NUMBER.fullmatch(text)
    if not match:
        raise SyntaxError(text)
    if match.group(2) and abs(int(match.group(2)[1:])) > DIGITS:
        raise BoundError(f"there is the number {text}; numbers have at most {DIGITS} digits")
    number = Fraction(text)
    return sp.Rational(number.numerator, number.denominator)


def _bound(number: int, most: int, what: str) -> None:
    if number > most:
        raise BoundError(f"there are {number if number < 10**9 else 'very many'} {what}; at most "
                         f"{most} are allowed")


def _too_deep() -> BoundError:
    return BoundError(f"brackets, signs, powers and functions are more than {DEPTH} deep in each "
                      "other; at most that many are allowed")


# --- operations -----------------------------------------------------------------------------------

def is_number(e: Expr) -> bool:
    """Has an expression neither symbols nor unknown functions?"""
    return not e.free_symbols and not e.atoms(AppliedUndef)


def _digits(e: Expr) -> int:
    """The digits of the longest number in an expression."""
    return 1 + int(max(map(_log10, e.atoms(sp.Rational)), default=0))


def _log10(q: Expr) -> float:
    """The logarithm of the larger of numerator and denominator."""
    return math.log10(max(abs(int(q.p)), int(q.q)))


def _of_a_size(e: Expr) -> Expr:
    """The expression; refuses a number in it that is too long."""
    if _digits(e) > DIGITS:
        raise BoundError(f"a number of {_digits(e)} digits arises; numbers have at most {DIGITS}")
    return e


def _power(base: Expr, exponent: Expr) -> Expr:
    """base ** exponent, refused before it is computed if it is too large."""
    if is_number(base) and is_number(exponent) and not exponent.is_Rational:
        if exponent.is_finite is False:
            return base ** exponent
        raise BoundError("a number has an exponent that is not rational; only rational powers are "
                         "known")
    if exponent.is_Rational:
        size = abs(exponent)
        if base.is_Rational:
            if size * _log10(base) > DIGITS:
                raise BoundError(f"a number of more than {DIGITS} digits arises in a power; "
                                 f"numbers have at most {DIGITS}")
        elif size > DEGREE:
            raise BoundError(f"a power has the exponent {_shown(exponent)}; exponents go up to "
                             f"{DEGREE}")
        if exponent.q > _ROOTS:
            raise BoundError(f"a power has the exponent {_shown(exponent)}; denominators of "
                             f"exponents go up to {_ROOTS}")
    return _of_a_size(sp.Pow(base, exponent))


def _shown(number: Expr) -> str:
    return str(number) if _digits(number) < 20 else f"of {_digits(number)} digits"


def _function(name: str, argument: Expr) -> Expr:
    """sin, cos or exp of an expression; of a number only if it contains no function itself."""
    if is_number(argument):
        if argument.has(sp.Function, sp.E):
            raise BoundError(f"{name} is taken of a number that is a function's value itself; "
                             "write that number as a decimal")
        with working():                                             # SymPy computes with mpmath
            beyond = name == "exp" and argument.is_finite and abs(argument.evalf(15)) > DIGITS
        if beyond:
            raise BoundError(f"exp is taken of a number beyond {DIGITS}; such numbers are not "
                             "known here")
    return _of_a_size(FUNCTIONS[name](argument))


def differentiated(e: Expr, time: Expr, times: int) -> Expr:
    """The time derivative, as long as it stays short."""
    highest = times + max((int(d.derivative_count) for d in e.atoms(sp.Derivative)), default=0)
    if highest > ORDERS:
        raise BoundError(f"a derivative of order {highest} is asked for; orders go up to {ORDERS}")
    for _ in range(times):
        if sum(len(list(sp.preorder_traversal(term)))**2
               for term in sp.Add.make_args(e)) > _NODES:
            raise BoundError(f"a derivative by {time} of a long expression is asked for; carry it "
                             "out by hand, or take a part of the expression as an unknown")
        e = checked(sp.diff(e, time))
    return e


def checked(e: Expr) -> Expr:
    """The expression; refuses one beyond the bounds of this module."""
    level, nodes, depth = [e], 1, 0
    while level:
        level = [a for node in level for a in node.args]
        nodes, depth = nodes + len(level), depth + 1
        _bound(nodes, _NODES, "parts")
        if depth > 2 * DEPTH:
            raise _too_deep()
    _spread(_of_a_size(e))
    return e


def _spread(e: Expr) -> tuple[int, int, int]:
    """(terms, degree, nested functions) of an expression multiplied out; refuses too many."""
    parts = [_spread(a) for a in e.args] if e.is_Add or e.is_Mul or e.is_Pow or isinstance(
        e, tuple(FUNCTIONS.values())) else []
    if not parts:
        return 1, int(not e.is_number), 0
    terms, degrees, nested = zip(*parts)
    inside = max(nested)
    if e.is_Add:
        found = sum(terms), max(degrees), inside
    elif e.is_Mul:
        found = math.prod(terms), sum(degrees), inside
    elif e.is_Pow and isinstance(e.exp, sp.Rational):
        n = math.ceil(abs(e.exp))
        found = math.comb(terms[0] + n - 1, n) if n else 1, degrees[0] * n, inside
    else:
        found = 1, 1, inside + (not e.is_Pow)
    _bound(found[0], TERMS, "terms after multiplying out")
    _bound(found[1], DEGREE, "factors in a term after multiplying out")
    _bound(found[2], NESTED, "functions in each other")
    return found


def sympified(source: Any) -> Expr | None:
    """A SymPy expression, or a number as one; None for anything else.

    (SymPy's own conversion would execute the texts in a dict or a list.)
    """
    if isinstance(source, sp.Expr):
        return source
    if isinstance(source, (str, bool, np.bool_)):
        return None
    try:
        return to_sympy(decimal(source), ())
    except InputError:
        return None


class Reader:
    """Puts expressions together; subclasses say what names and calls mean."""

    def name(self, name: str) -> Expr:
        """The value of a name in a text."""
        raise NotImplementedError

    def symbol(self, symbol: Expr) -> Expr:
        """What stands for a symbol in a SymPy expression."""
        raise NotImplementedError

    def call(self, node: ast.expr, arguments: Sequence[Expr]) -> Expr:
        """A call in a text, or a name with primes (a subscript), which has no arguments."""
        raise SyntaxError

    def other(self, e: Expr) -> Expr:
        """What is none of number, symbol, sum, product and power."""
        raise SyntaxError

    def built(self, node: ast.AST, depth: int = 0) -> Expr:
        """The expression of a syntax tree; SyntaxError for what is not of the language."""
        if depth > 2 * DEPTH:
            raise _too_deep()
        match node:
            case ast.BinOp(op=ast.Add() | ast.Sub()):
                return _of_a_size(sp.Add(*(
                    -e if isinstance(op, ast.Sub) else e
                    for op, e in self._chain(node, (ast.Add, ast.Sub), depth))))
            case ast.BinOp(op=ast.Mult() | ast.Div()):
                return _of_a_size(sp.Mul(*(
                    _power(e, sp.S.NegativeOne) if isinstance(op, ast.Div) else e
                    for op, e in self._chain(node, (ast.Mult, ast.Div), depth))))
            case ast.BinOp(op=ast.Pow()):
                return _power(self.built(node.left, depth + 1), self.built(node.right, depth + 1))
            case ast.UnaryOp(op=ast.USub()):
                return -self.built(node.operand, depth + 1)
            case ast.UnaryOp(op=ast.UAdd()):
                return self.built(node.operand, depth + 1)
            case ast.Constant():
                return node.value
            case ast.Name():
                return self.name(node.id)
            case ast.Call(keywords=[]):
                return self.call(node, [self.built(a, depth + 1) for a in node.args])
            case ast.Subscript():
                return self.call(node, [])
        raise SyntaxError

    def _chain(self, node: ast.expr, kinds: tuple[type, ...],
               depth: int) -> Iterable[tuple[ast.operator | None, Expr]]:
        """The terms of a sum, or the factors of a product, with the operators before them."""
        rest: list[tuple[ast.operator | None, ast.expr]] = []
        while isinstance(node, ast.BinOp) and isinstance(node.op, kinds):
            rest.append((node.op, node.right))
            node = node.left
        return [(op, self.built(e, depth + 1)) for op, e in [(None, node), *reversed(rest)]]

    def rebuilt(self, e: Expr) -> Expr:
        """A SymPy expression in the language, decimals as fractions; other things are refused."""
        if e.is_Symbol:
            return self.symbol(e)
        if e.is_Add:
            return _of_a_size(sp.Add(*map(self.rebuilt, e.args)))
        if e.is_Mul:
            return _of_a_size(sp.Mul(*map(self.rebuilt, e.args)))
        if e.is_Pow and e is not sp.E and not isinstance(e, sp.exp):
            return _power(*map(self.rebuilt, e.args))
        if e.is_Float and e.is_finite and abs(e._mpf_[2] + e._mpf_[3]) * math.log10(2) > DIGITS:
            raise BoundError(f"a number of more than {DIGITS} digits is given; numbers have at "
                             f"most {DIGITS}")
        if e.is_Number:
            return _of_a_size(in_fractions(e))
        return e if e is sp.pi or e is sp.I or e is sp.zoo else self.other(e)

    @staticmethod
    def function(name: str, argument: Expr) -> Expr:
        """sin, cos, exp or sqrt of an expression."""
        return _power(argument, sp.S.Half) if name == "sqrt" else _function(name, argument)


# --- numbers and units ----------------------------------------------------------------------------

class _Number(Reader):
    """Numbers, and symbols for positive ones."""

    def name(self, name: str) -> Expr:
        return sp.pi if name == "pi" else sp.Symbol(self._checked(name), positive=True)

    def symbol(self, symbol: Expr) -> Expr:
        self._checked(symbol.name)
        return symbol

    def _checked(self, name: str) -> str:
        if name in _NO_NUMBERS:
            raise InputError(f"{name} is not a number, and no name for one; give a finite real "
                             "number, or another name")
        return name_of(name)

    def call(self, node: ast.expr, arguments: Sequence[Expr]) -> Expr:
        match node:
            case ast.Call(func=ast.Name("sqrt")) if len(arguments) == 1:
                return self.function("sqrt", arguments[0])
        raise SyntaxError


def expression(x: Any) -> Expr:
    """A number, SymPy expression or text as a SymPy expression; decimals become rationals.

    It may hold numbers, pi, names (in a text, of positive symbols), + - * / ** and sqrt, and
    nothing else, within the bounds of this module: it may come from a file.

    >>> expression("2*sqrt(3)/a"), expression(0.1)
    (2*sqrt(3)/a, 1/10)
    """
    if not isinstance(x, (str, sp.Basic)):
        return symbolic(x)
    reader = _Number()
    e = None
    try:
        if isinstance(x, str):
            e = checked(reader.built(parsed(x)))
        elif (given := sympified(x)) is not None:
            e = checked(reader.rebuilt(checked(given)))
    except SyntaxError:
        pass
    except BoundError as error:
        raise InputError(f"{quoted(x)} cannot be read: {error}") from None
    if e is None or e.has(sp.nan, sp.oo, -sp.oo, sp.zoo, sp.I):
        raise InputError(f"{quoted(x)} is not a number or a SymPy expression of finite real "
                         "numbers, names, + - * / ** and sqrt")
    return e
