"""How far Fourier orders run: against the modes that exact terms have."""

from fractions import Fraction

import pytest
from sample_problems import Duffing, Exponential, Pendulum, Quotient

import ftseries as fts
from ftseries.degrees import highest
from ftseries.expansion import Expansion
from ftseries.laurent import RationalRing


def ahead(kind, by):
    problem = kind()
    problem.ahead = by
    return problem


def true_highest(problem, top):
    """By running the equations over coefficients that do not cancel."""
    expansion, unknowns = Expansion(RationalRing()), {}
    for i, (name, unknown) in enumerate(problem.unknowns.items()):
        rows = problem.first_coefficients()[name]
        rows = rows + [{mode: Fraction(1 + mode[1] + m, 7 + i) for mode in
                        unknown.columns(m + problem.ahead) if problem.in_powers(name, m)}
                       for m in range(len(rows), top + 1)]
        unknowns[name] = expansion.polynomial(
            [{mode: expansion.ring.number(c) for mode, c in row.items()} for row in rows])
    residuals = problem.residuals(expansion.lam, unknowns)
    for residual in residuals.values():
        residual[top]
    return max(n for node in expansion.nodes for term in node.table[:top + 1]
               for _, n in term.modes())


@pytest.mark.parametrize("by", [0, 1, 3])
@pytest.mark.parametrize("kind", [Duffing, Pendulum, Quotient, Exponential, fts.FigureEight])
def test_the_orders_of_exact_terms(kind, by):
    problem = ahead(kind, by)
    assert true_highest(problem, 7) <= highest(problem, 7) <= true_highest(problem, 7) + 1


def test_without_a_head_start_none_runs_ahead():
    for kind in (Duffing, Pendulum, Quotient, Exponential, fts.FigureEight):
        assert highest(kind(), 12) <= 12
