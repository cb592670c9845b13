"""Texts from a grammar, right and wrong ones: a solution comes out, or one sentence, in time.

``make test`` tries 300 texts, always the same; ``FTSERIES_FUZZ=10000`` that many, new ones.
"""

import os
import time
from collections import Counter

import pytest
import sympy as sp
from fuzz import Hung, limited
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st
from sympy.core.function import AppliedUndef
from test_symbolic import assert_solved

import ftseries as fts
from ftseries.expressions import expression
from ftseries.reading import Language

TRIES = int(os.environ.get("FTSERIES_FUZZ", 0))
#: seconds of computing: to refuse a text, to do anything with it
REFUSED, LIMIT = 2, 60
COUNTS = Counter()

fuzz = settings(max_examples=TRIES // 2 or 150, derandomize=not TRIES, deadline=None,
                suppress_health_check=list(HealthCheck), database=None)


@pytest.fixture(scope="module", autouse=True)
def report():
    yield
    if TRIES:
        print("\n", dict(COUNTS))


def outcome(call):
    """What a call returns, or None where it is refused by a sentence, in time."""
    begin = time.process_time()
    COUNTS["tried"] += 1
    try:
        with limited(LIMIT):
            result = call()
        COUNTS["read"] += 1
        return result
    except fts.FTSeriesError as error:
        COUNTS["refused"] += 1
        assert "\n" not in str(error) and 20 < len(str(error)) < 2000
    except Hung:
        COUNTS["hung"] += 1
        raise AssertionError("hung") from None
    except Exception:
        COUNTS["other"] += 1
        raise
    finally:
        COUNTS["slow"] += time.process_time() - begin > REFUSED
    assert time.process_time() - begin < REFUSED
    return None


# --- the grammar ----------------------------------------------------------------------------------

small = st.sampled_from(["0", "1", "2", "3", "1/2", "0.1", "2.5", "-1", "3/4", "1e-2", ".5", "4."])
large = st.sampled_from(["9**9**9", "1e400", "1e999999", "10**400", "1" * 500, "1" * 1500, "0**0",
                         "1/0", "2**-9999", "sqrt(2)", "pi", "sqrt(10**99+1)", "(-8)**(1/3)"])
names = st.sampled_from(["x", "x", "x'", "x''", "x(t)", "x'(t)", "x(t - pi/omega)", "omega", "lam",
                         "λ", "lam**2", "lam*cos(omega*t)", "sin(2*omega*t)*lam**2", "mu"])
strange = st.sampled_from(["y", "y'", "t", "x(0)", "x(t+1)", "x(2*t)", "x(x)", "x'''", "lambda",
                           "nan", "oo", "I", "E", "Integer", "True", "None", "__import__", "µ",
                           "x" * 99, "diff(x, t)", "diff(x, lam)", "diff(x, t, 99)", "cos(t)",
                           "diff(x*x', t, 2)", "x.real", "'a'", "#", "[1]", "x²", "½", "lam.x", ""])
functions = st.sampled_from(["sin", "cos", "exp", "sqrt", "tan", "diff", "x", "omega", "eval"])
operators = st.sampled_from(["+", "-", "*", "*", "/", "**", "^"])
others = st.sampled_from(["%", "//", "@", "<<", " if ", " and ", "==", ":=", ",", ";", " ", "=",
                          " in ", "~", "..", "\n", "\0", "\ud800", "\\", "#", "lambda x:", "'",
                          "("])


def grown(leaves, operators):
    """Sums, products, powers, calls and brackets of some leaves."""
    return st.recursive(leaves, lambda e: st.one_of(
        st.tuples(e, operators, e).map("".join),
        st.tuples(e, operators, e).map("".join),
        st.tuples(st.just("("), e, operators, e, st.just(")")).map("".join),
        st.tuples(functions, st.just("("), e, st.just(")")).map("".join),
        st.tuples(st.just("("), e, st.just(")**"), st.integers(-3, 300).map(str)).map("".join),
        st.tuples(st.just("-("), e, st.just(")")).map("".join)), max_leaves=12)


monomials = st.tuples(small, st.sampled_from(["", "*lam", "*mu", "*λ**2"]), st.sampled_from(
    ["*x", "*x**2", "*x**3", "*x*x'", "*x'**2", "*sin(x)", "*x/(1 + x)", "*x*sqrt(1 + x)",
     "*x(t - pi/omega)**2", "*exp(x)*x", "*lam**3*cos(3*omega*t)"])).map("".join)
good = st.lists(monomials, min_size=1, max_size=3).map(
    lambda terms: "x'' + x + " + " + ".join(terms) + " = 0")
wild = grown(st.one_of(small, names), operators).map(lambda e: "x'' + x + " + e)
wilder = grown(st.one_of(small, large, names, strange), operators)
repeated = st.tuples(st.one_of(small, large, names, strange, others, operators, st.just("("),
                               st.just("sin("), st.just("x*"), st.just("+x**2")),
                     st.integers(1, 3000), wilder).map(lambda t: (t[0] * t[1] + t[2])[:10_000])


@st.composite
def damaged(draw):
    """A text with something put in, doubled or taken out."""
    text = draw(st.one_of(good, wild, wilder))
    for _ in range(draw(st.integers(1, 3))):
        i, j = sorted(draw(st.tuples(*2 * [st.integers(0, len(text))])))
        text = draw(st.sampled_from([text[:i] + draw(others) + text[i:], text[:i] + text[j:],
                                     text[:j] + text[i:]]))
    return text


texts = st.one_of(good, wild, wilder, damaged(), damaged(), repeated)
SEED = {"x": "lam*cos(omega*t)", "omega": "1"}


@pytest.mark.filterwarnings("ignore:Generating overly large repr")
@fuzz
@given(texts, st.sampled_from([SEED, SEED, SEED, None]))
@example("x'' + x + x**3 = 0", None)
def test_equations(text, seed):
    """Either a sentence, or the residual of the solution vanishes; what is read can be saved."""
    def solved():
        problem = fts.Equations(text, {"x": fts.Field("both", fixed=(1,)), "omega": fts.Scalar()},
                                seed=seed, frequency="omega", parameters=("mu",) if "mu" in text
                                else ())
        fts.solve(problem, 3)
        return problem
    problem = outcome(solved)
    if problem is not None:
        again = fts.Equations(**problem.arguments())
        assert again.expressions == problem.expressions and again.seed == problem.seed
        assert_solved(problem, order=3, **{"mu": sp.Rational(2, 7)} if problem.parameters else {})
        COUNTS["right"] += 1


def assert_same(a, b):
    """Equal, or with equal values at a point: 1/(2*(x + 1)) is read as 1/(2*x + 2)."""
    if a != b:
        inner = sorted(a.atoms(AppliedUndef, sp.Derivative, sp.Subs) | a.free_symbols, key=str)
        at = {e: sp.Rational(i + 3, 7) for i, e in enumerate(inner)}
        difference = sp.Add(a, -b).xreplace(at)
        assert abs(difference.evalf(20, chop=True)) < 1e-10 * abs(a.xreplace(at).evalf(20)) + 1e-10


LANGUAGE = Language("t", "lam", ("x",), ("omega",), ("mu",))


@pytest.mark.filterwarnings("ignore:Generating overly large repr")
@fuzz
@given(texts)
def test_expressions(text):
    """What is read is written as a text that means the same, in the language and as a number."""
    e = outcome(lambda: expression(text))
    if e is not None:
        assert_same(expression(str(e)), e)
        COUNTS["right"] += 1
    e = outcome(lambda: LANGUAGE.expression(text))
    if e is not None and not e.has(sp.nan, sp.oo, -sp.oo, sp.zoo, sp.I):     # refused later
        assert_same(LANGUAGE.expression(LANGUAGE.written(e)), e)
        COUNTS["right"] += 1
