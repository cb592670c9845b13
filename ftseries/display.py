r"""LaTeX of a solution: sums ordered by Fourier order, each coefficient a polynomial in λ."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp
from sympy.printing.pretty.pretty_symbology import greek_unicode

from .aliases import Expr, Mode
from .arguments import whole
from .evaluation import unknown
from .problem import Scalar

if TYPE_CHECKING:
    from .solution import Solution

__all__ = ["to_latex", "summary"]

#: how LaTeX writes names that SymPy would write otherwise, and single Greek letters
_NAMES = {"phi": r"\varphi", "lambda": r"\lambda"}
_LETTERS = str.maketrans({letter: f"{{{_NAMES.get(name) or sp.latex(sp.Symbol(name))}}}"
                          for name, letter in greek_unicode.items()})


def to_latex(solution: Solution, name: str, order: int) -> str:
    r"""One unknown, cut at Taylor order ``order``, as a LaTeX equation without dollars.

    >>> import ftseries as fts
    >>> fts.solve(fts.CubicOscillator(a=1), order=3).to_latex("omega", order=3)
    '\\omega = 2 \\sqrt{3} - \\frac{\\sqrt{3}}{24} \\lambda^{2} + \\mathcal{O}(\\lambda^{4})'
    """
    order = whole("order", order, most=solution.order)
    scalar = isinstance(unknown(solution.problem, name), Scalar)
    by_mode: dict[Mode, list[tuple[int, Expr]]] = {}
    for m, row in enumerate(solution.coefficients[name][:order + 1]):
        for mode, number in row.items():
            by_mode.setdefault(mode, []).append((m, solution._in_unit(name, m, number)))
    phase = variable = _name(solution.problem.variable)
    if solution.problem.frequency:
        phase = f"{_name(solution.problem.frequency)} {variable}"
    terms = []
    for (sine, n), powers in sorted(by_mode.items(), key=lambda item: (item[0][1], item[0][0])):
        pieces = [_term(c, _power(m)) for m, c in powers]
        function = "" if n == 0 else (rf"\{'sin' if sine else 'cos'} "
                                      + ("" if n == 1 else str(n)) + phase)
        if not function:
            terms += pieces
        elif len(pieces) == 1:
            terms.append(_term(powers[0][1], (_power(powers[0][0]) + " " + function).strip()))
        else:
            terms.append(rf"+\left({_join(pieces)}\right) {function}")
    left = _name(name) + ("" if scalar else f"({variable})")
    text = rf"{left} = {_join(terms) or '0'} + \mathcal{{O}}(\lambda^{{{order + 1}}})"
    return text.translate(_LETTERS)


def _name(name: str) -> str:
    return _NAMES.get(name) or sp.latex(sp.Symbol(name))


def summary(solution: Solution) -> str:
    """All unknowns to low order, as displayed LaTeX."""
    order = min(solution.order, 4)
    lines = r" \\ ".join(to_latex(solution, name, order).replace(" = ", " &= ", 1)
                         for name in solution.problem.unknowns)
    return rf"$\displaystyle \begin{{aligned}} {lines} \end{{aligned}}$"


def _power(m: int) -> str:
    return "" if m == 0 else r"\lambda" if m == 1 else rf"\lambda^{{{m}}}"


def _term(coefficient: Expr, factor: str) -> str:
    """'+ c factor' with its sign in front."""
    c = sp.sympify(coefficient if not hasattr(coefficient, "mid") else float(coefficient))
    negative = c.could_extract_minus_sign()
    c = -c if negative else c
    body = factor if c == 1 and factor else sp.latex(c)
    if c.is_Add and factor:
        body = rf"\left({body}\right)"
    return ("-" if negative else "+") + (body if body == factor else f"{body} {factor}".strip())


def _join(terms: list[str]) -> str:
    text = " ".join(f"{t[0]} {t[1:]}" for t in terms)
    if text.startswith("+ "):
        return text[2:]
    return text.replace("- ", "-", 1) if text.startswith("- ") else text
