"""What bad input gets: one clear sentence, a subclass of FTSeriesError, never a silent answer."""

import math
import warnings
from fractions import Fraction

import flint
import numpy as np
import pytest
import sympy as sp
from sample_problems import Duffing, Exponential, LotkaVolterra, MassOnSpring, VanDerPol

import ftseries as fts
from ftseries import (
    ContradictionError,
    ConvergenceWarning,
    Field,
    FTSeriesError,
    InputError,
    NonAnalyticError,
    Problem,
    Scalar,
    SolveError,
    UndeterminedError,
)

CUBIC = fts.CubicOscillator()
EIGHT = fts.figure_eight
ALL_ERRORS = [getattr(fts, name) for name in fts.__all__ if name.endswith("Error")]


@pytest.fixture(scope="module")
def cubic():
    return fts.solve(CUBIC, 6)


@pytest.fixture(scope="module")
def mathieu():
    return fts.solve(fts.GeneralizedMathieu(), 8)


def refused(call, kind, *words):
    """``call`` raises ``kind`` with one sentence that contains the words."""
    with pytest.raises(FTSeriesError) as caught:
        call()
    assert type(caught.value) is kind
    text = str(caught.value)
    assert "\n" not in text and 20 < len(text) < 400
    for word in words:
        assert word in text, text


@pytest.mark.parametrize("error", ALL_ERRORS)
def test_every_error_is_of_the_family(error):
    assert issubclass(error, FTSeriesError)
    assert error.__doc__


def test_a_machine_that_does_not_tell_its_memory(monkeypatch):
    """8 GiB are taken for granted, so the limits stay those of such a machine."""
    def unknown(name):
        raise ValueError(name)
    monkeypatch.setattr("os.sysconf", unknown)
    refused(lambda: fts.solve(CUBIC, 10**5), InputError, "memory")
    assert fts.solve(CUBIC, 2).order == 2


def test_rounding_that_has_grown(monkeypatch):
    """With a tolerance below rounding the float ring must give up, and say why."""
    from ftseries.grid import FloatRing
    monkeypatch.setattr(FloatRing, "negligible", lambda self, x, scale: abs(x) <= 1e-18 * scale)
    refused(lambda: fts.solve(CUBIC, 40, "float"), SolveError, "rounding", "arithmetic='ball'")


def test_errors_can_be_caught_as_the_built_in_ones():
    assert issubclass(InputError, ValueError)
    assert issubclass(NonAnalyticError, ArithmeticError)
    assert issubclass(ConvergenceWarning, UserWarning)


# --- arguments of solve -------------------------------------------------------------------------

@pytest.mark.parametrize("order", [-1, -10**30, 2.0, "3", None, True, False, math.nan, 1j, [3]])
def test_order_must_be_a_whole_number(order):
    refused(lambda: fts.solve(CUBIC, order), InputError, f"order={order!r}", "at least 0")


@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
@pytest.mark.parametrize("order", [10**6, 10**9, 10**30])
def test_order_beyond_memory(order, arithmetic):
    refused(lambda: fts.solve(CUBIC, order, arithmetic), InputError, f"order={order}", "memory",
            "stay below")


@pytest.mark.parametrize("order", [np.int64(3), sp.Integer(3)])
def test_other_integers_are_integers(order):
    assert fts.solve(CUBIC, order).coefficients == fts.solve(CUBIC, 3).coefficients


@pytest.mark.parametrize("arithmetic", ["foo", "Exact", "", None, 1, ["exact"], float])
def test_unknown_arithmetic(arithmetic):
    refused(lambda: fts.solve(CUBIC, 3, arithmetic), InputError, f"arithmetic={arithmetic!r}",
            "'exact', 'float' or 'ball'")


@pytest.mark.parametrize("precision", [0, 1, -5, 1.5, None, True, "x", math.inf])
def test_bad_precision(precision):
    refused(lambda: fts.solve(CUBIC, 3, "ball", precision=precision), InputError,
            f"precision={precision!r}", "at least 2")


@pytest.mark.parametrize("precision", [10**12, 10**30])
def test_precision_beyond_memory(precision):
    refused(lambda: fts.solve(CUBIC, 3, "ball", precision=precision), InputError,
            f"precision={precision}", "memory")


@pytest.mark.parametrize("problem", [None, fts.CubicOscillator, "cubic", 3])
def test_not_a_problem(problem):
    refused(lambda: fts.solve(problem, 3), InputError, repr(problem), "CubicOscillator(a=1)")


@pytest.mark.parametrize("arithmetic", ["float", "ball"])
def test_a_free_parameter_needs_exact_arithmetic(arithmetic):
    refused(lambda: fts.solve(fts.GeneralizedMathieu(), 4, arithmetic), InputError, "mu",
            "give it a value")


# --- declarations -------------------------------------------------------------------------------

def declared(base=Duffing, **attributes):
    """An instance of a changed problem; it does not stay in the list of known problems."""
    problem = type("Changed", (base,), attributes)()
    del Problem.classes["Changed"]
    return problem


def with_force(force):
    def equations(self, lam, x, omega):
        return {"(F)": omega**2 * x.diff(2) + force(lam, x)}
    return declared(equations=equations)


SEEDS = {
    "none": ({}, "no seed for x, omega"),
    "one missing": ({"x": [{}, {1: 1}]}, "no seed for omega"),
    "foreign": ({"x": [{}, {1: 1}], "omega": [1], "y": [1]}, "y, which is not an unknown"),
    "a sine in a cosine series": ({"x": [{}, {(1, 1): 1}], "omega": [1]}, "mode (1, 1)"),
    "a wrong parity": ({"x": [{}, {}, {2: 1}], "omega": [1]}, "mode (0, 2)"),
    "n above m": ({"x": [{1: 1}], "omega": [1]}, "n ≤ 0"),
    "negative n": ({"x": [{}, {-1: 1}], "omega": [1]}, "mode (0, -1)"),
    "n a text": ({"x": [{}, {"one": 1}], "omega": [1]}, "mode (0, 'one')"),
    "three indices": ({"x": [{}, {(0, 1, 1): 1}], "omega": [1]}, "mode (0, 1, 1)"),
    "a field as a number": ({"x": [0, 1], "omega": [1]}, "mode (0, 0)"),
    "a scalar with a mode": ({"x": [{}, {1: 1}], "omega": [{1: 1}]}, "the seed of omega"),
    "not a number": ({"x": [{}, {1: "foo"}], "omega": [1]}, "'foo' is not a rational number"),
    "NaN": ({"x": [{}, {1: math.nan}], "omega": [1]}, "nan is not a rational number"),
    "infinite": ({"x": [{}, {1: math.inf}], "omega": [1]}, "inf is not a rational number"),
    "irrational": ({"x": [{}, {1: sp.sqrt(2)}], "omega": [1]}, "sqrt(2) is not a rational"),
    "rows not in a list": ({"x": {1: 1}, "omega": 1}, "the list of its first Taylor coefficients"),
    "not a dict": ([1], "a dict from each unknown"),
}


@pytest.mark.parametrize("name", SEEDS)
@pytest.mark.parametrize("order", [0, 6])
def test_a_seed_that_cannot_be_meant(name, order):
    seed, words = SEEDS[name]
    refused(lambda: fts.solve(declared(seed=seed), order), InputError, words)


@pytest.mark.parametrize("order", [0, 1, 2, 8])
@pytest.mark.parametrize("base, seed, kind, words", [
    (Duffing, {"x": [{}, {1: 1}], "omega": [2]}, ContradictionError,
     ("(Duffing)", "order 1", "cos 1τ")),
    (fts.CubicOscillator, {"x": [{0: 5}, {1: 1}], "omega": [1]}, ContradictionError,
     ("(C3)", "order 0", "seed")),
    (fts.CubicOscillator, {"x": [{0: -1}, {1: 2}], "omega": [1]}, SolveError,
     ("seed", "cos 1τ in x at order 1")),
    (fts.FigureEight, {"r": [{0: 2}], "phi": [{}, {1: 1}]}, ContradictionError,
     ("(E3b)", "order 1", "cos 1τ")),
])
def test_a_wrong_seed_names_the_equation_and_the_order(base, seed, kind, words, order):
    """Also where fewer orders are asked for than the seed has."""
    refused(lambda: fts.solve(declared(base, seed=seed), order), kind, *words)


@pytest.mark.parametrize("make, words", [
    (lambda: Field(series="tan"), "series='tan'"),
    (lambda: Field(series=["cos"]), "series=['cos']"),
    (lambda: Field(modes="x"), "modes='x'"),
    (lambda: Field(modes=["odd"]), "modes=['odd']"),
    (lambda: Field(powers=3), "powers=3"),
    (lambda: Scalar("x"), "powers='x'"),
    (lambda: Scalar([]), "powers=[]"),
    (lambda: Field(fixed=1), "fixed=1"),
    (lambda: Field(fixed=[1]), "fixed=[1]"),
    (lambda: Field(fixed=("a",)), "fixed=('a',)"),
    (lambda: Field(fixed=(-1,)), "fixed=(-1,)"),
    (lambda: Field("cos", fixed=((1, 1),)), "fixed=((1, 1),)"),
    (lambda: Field("cos", modes="odd", fixed=(2,)), "fixed=(2,)"),
])
def test_a_declaration_of_an_unknown(make, words):
    refused(make, InputError, words)


@pytest.mark.parametrize("attributes, words", [
    ({"unknowns": {"x": "cos", "omega": Scalar()}}, "'cos'"),
    ({"frequency": "nu"}, "frequency='nu'"),
    ({"frequency": "x"}, "frequency='x'"),
    ({"parameters": "mu"}, "parameters='mu'"),
    ({"unknowns": {}, "seed": {}, "frequency": None}, "no unknowns"),
    ({"equations": Problem.equations}, "no equations"),
    ({"equations": lambda self, lam, x, omega: {}}, "{}"),
    ({"equations": lambda self, lam, x, omega: None}, "None"),
    ({"equations": lambda self, lam, x, omega: [x]}, "dict"),
    ({"equations": lambda self, lam, x, omega: {"(1)": 0}}, "equation (1)"),
])
def test_a_declaration_of_a_problem(attributes, words):
    refused(lambda: fts.solve(declared(**attributes), 4), InputError, words)


@pytest.mark.parametrize("force, kind, words", [
    (lambda lam, x: x**-1, NonAnalyticError, "the power -1"),
    (lambda lam, x: x**Fraction(1, 2), NonAnalyticError, "the power 1/2"),
    (lambda lam, x: 1 / lam, NonAnalyticError, "the power -1"),
    (lambda lam, x: (1 + lam.expansion.cos(1))**-1 + x, NonAnalyticError, "oscillates"),
    (lambda lam, x: fts.exp(1 + x) - 1, NonAnalyticError, "zero at λ = 0"),
    (lambda lam, x: fts.sin(1 + x), NonAnalyticError, "addition theorem"),
    (lambda lam, x: fts.cos(1 + x), NonAnalyticError, "addition theorem"),
    (lambda lam, x: (2 + x)**Fraction(1, 2), InputError, "(2)^(1/2) is not rational"),
    (lambda lam, x: (x - 1)**Fraction(1, 2), InputError, "(-1)^(1/2) is not rational"),
    (lambda lam, x: x.shift(Fraction(1, 3)), InputError, "neighbours"),
    (lambda lam, x: x.diff(3), InputError, "a derivative of order 3"),
    (lambda lam, x: x.diff(0), InputError, "a derivative of order 0"),
    (lambda lam, x: x / 0, InputError, "zero"),
    (lambda lam, x: sp.sqrt(2) * x, InputError, "sqrt(2) is not a rational"),
    (lambda lam, x: x + lam.expansion.parameter("mu"), InputError, "'mu' is not a parameter"),
    (lambda lam, x: x**math.nan, InputError, "nan is not a rational"),
])
def test_operations_without_a_taylor_series(force, kind, words):
    refused(lambda: fts.solve(with_force(force), 4), kind, words)


class TestAnsatzE1:
    """The teaching case of the paper: Cartesian coordinates of the eight start at the origin."""

    @staticmethod
    def ansatz(power):
        def equations(self, lam, x, y):
            force = (x * x + y * y)**power
            return {"x": x.diff(2) + x * force, "y": y.diff(2) + y * force}
        return declared(Problem, equations=equations, frequency=None,
                        unknowns={"x": Field("sin", modes="even", powers="even"),
                                  "y": Field("sin", modes="odd", powers="odd", fixed=(1,))},
                        seed={"x": [{}, {}, {2: 1}], "y": [{}, {1: 1}]})

    def test_is_refused_with_the_power_as_declared(self):
        refused(lambda: fts.solve(self.ansatz(Fraction(-3, 2)), 6), NonAnalyticError,
                "the power -3/2", "vanishes at λ = 0", "choose other variables")

    @pytest.mark.parametrize("arithmetic", ["float", "ball"])
    def test_in_every_arithmetic(self, arithmetic):
        refused(lambda: fts.solve(self.ansatz(Fraction(-3, 2)), 60, arithmetic),
                NonAnalyticError, "the power -3/2")


# --- λ without a meaning, contradictions, a narrow ansatz ---------------------------------------

FREE = {"x": Field("cos", modes="odd", powers="odd"), "omega": Scalar("even")}


@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
@pytest.mark.parametrize("order", [3, 12])
def test_lambda_without_a_meaning(order, arithmetic):
    """sinh λ instead of λ would do as well: the amplitude at order 3 stays free."""
    refused(lambda: fts.solve(declared(unknowns=FREE), order, arithmetic), UndeterminedError,
            "cos 1τ in x at order 3", "no concrete meaning", "fixed")


def test_a_number_that_no_equation_holds():
    def equations(self, lam, x, omega, b):
        return Duffing.equations(self, lam, x, omega)
    refused(lambda: fts.solve(declared(
        equations=equations, unknowns=Duffing.unknowns | {"b": Scalar("even")},
        seed=Duffing.seed | {"b": [1]}), 5), UndeterminedError, "the coefficient b_2")


def test_a_phase_that_nothing_fixes():
    both = {"y": Field("both", modes="odd", powers="odd"), "omega": Scalar()}
    refused(lambda: fts.solve(declared(VanDerPol, unknowns=both), 8), UndeterminedError,
            "sin 1τ in y at order 3")


def test_energy_is_what_gives_lambda_its_meaning_in_C3():
    """Newton's form of (C3) does not contain the energy, so the amplitude is free."""
    def equations(self, lam, x, omega):
        return {"(C3')": 12 * omega**2 * x.diff(2) + 2 * (3 + lam**2) - 6 * x * x}
    unknowns = {"x": Field("cos"), "omega": Scalar()}
    refused(lambda: fts.solve(declared(fts.CubicOscillator, equations=equations,
                                       unknowns=unknowns), 8), UndeterminedError, "cos 1τ in x")


def constant(**equations):
    """A problem for the constant x = 1 + …"""
    def method(self, lam, x):
        return {name: residual(lam, x) for name, residual in equations.items()}
    return declared(Problem, unknowns={"x": Field()}, seed={"x": [{0: 1}]}, equations=method)


@pytest.mark.parametrize("problem, words", [
    (constant(one=lambda lam, x: x - 1 - lam, two=lambda lam, x: x - 1 - 2 * lam),
     ("equation two", "order 1", "contradict")),
    (constant(one=lambda lam, x: x - 1 - lam, two=lambda lam, x: x - 1 - lam + lam**5),
     ("equation two", "order 5", "contradict")),
    (constant(one=lambda lam, x: x - 1 - lam, two=lambda lam, x: lam * lam),
     ("equation two", "does not depend on any unknown")),
    # resonance: x″ + x = λ cos τ has no periodic solution
    (constant(one=lambda lam, x: x.diff(2) + x - 1 - lam * lam.expansion.cos(1)),
     ("equation one", "order 1", "cos 1τ")),
    # a sine cannot be answered by cosines
    (constant(one=lambda lam, x: x.diff(2) + 2 * x - 2 - lam**3 * lam.expansion.sin(1)),
     ("equation one", "order 3", "sin 1τ")),
])
def test_contradictory_equations(problem, words):
    refused(lambda: fts.solve(problem, 8), ContradictionError, *words)


@pytest.mark.parametrize("base, unknowns, kind, words", [
    (Duffing, {"x": Duffing.unknowns["x"], "omega": Scalar("odd")}, ContradictionError,
     ("(Duffing)", "order 3", "cos 1τ", "ansatz")),
    (Exponential, {"x": Field("cos", modes="odd", fixed=(1,)), "omega": Scalar("even")},
     ContradictionError, ("(Toda)", "order 2", "cos 0τ", "ansatz")),
    (Exponential, {"x": Field("cos", powers="odd", fixed=(1,)), "omega": Scalar("even")},
     SolveError, ("too narrow", "cos 2τ in x at order 2 of λ = 1/12")),
    (LotkaVolterra, {"u": Field("both", fixed=(1,)), "v": Field("sin"), "omega": Scalar()},
     ContradictionError, ("order 2", "ansatz")),
])
def test_a_narrow_ansatz(base, unknowns, kind, words):
    refused(lambda: fts.solve(declared(base, unknowns=unknowns,
                                       **({} if base is not LotkaVolterra else
                                          {"seed": base.seed | {"v": [{}, {1: 1}]}})), 8),
            kind, *words)


@pytest.mark.parametrize("force, words", [
    (lambda lam, x: lam.expansion.parameter("mu") * x, "depends on a parameter"),
    (lambda lam, x: x / (1 + lam.expansion.parameter("mu")), "depends on a parameter at λ = 0"),
])
def test_a_parameter_where_coefficients_would_not_be_polynomials(force, words):
    def equations(self, lam, x, omega):
        return {"(F)": omega**2 * x.diff(2) + force(lam, x)}
    refused(lambda: fts.solve(declared(MassOnSpring, equations=equations), 4), InputError, words)


# --- asking a solution --------------------------------------------------------------------------

@pytest.mark.parametrize("arguments, words", [
    (("x", 2, 7), "order 6, not to 7"),
    (("omega", 7), "order 6, not to 7"),
    (("y", 1, 1), "'y' is not an unknown"),
    ((None, 1), "None is not an unknown"),
    ((["x"], 1), "['x'] is not an unknown"),
    (("x", 2), "coefficient('x', n, m)"),
    (("x",), "coefficient('x', n, m)"),
    (("x", 1, 2, 3), "coefficient('x', n, m)"),
    (("omega",), "coefficient('omega', m)"),
    (("omega", 1, 2), "coefficient('omega', m)"),
    (("x", -1, 2), "n=-1: give a whole number"),
    (("x", 1, -2), "m=-2: give a whole number"),
    (("omega", -2), "m=-2: give a whole number"),
    (("x", 1.0, 2), "n=1.0"),
    (("x", True, 2), "n=True"),
    (("x", None, 2), "n=None"),
    (("x", "1", 2), "n='1'"),
])
def test_a_coefficient_that_is_not_there(cubic, arguments, words):
    refused(lambda: cubic.coefficient(*arguments), InputError, words)


def test_cosine_or_sine_must_be_said_where_there_are_both():
    solution = fts.solve(LotkaVolterra(), 2)
    refused(lambda: solution.coefficient("u", 1, 1), InputError, "sine=True or sine=False")
    assert solution.coefficient("u", 1, 1, sine=False) == 1


@pytest.mark.parametrize("dps", [None, 20])
@pytest.mark.parametrize("t, lam, words", [
    (math.nan, 0.5, "t contains"), (math.inf, 0.5, "t contains"),
    ([0, -math.inf], 0.5, "t contains"), (0, math.nan, "lam contains"),
    (0, math.inf, "lam contains"), (0, [0.1, math.nan], "lam contains"),
    (0, None, "lam"), ("x", 0.5, "t='x'"), (0, "x", "lam='x'"), (1j, 0.5, "t=1j"),
    (0, 0.5j, "lam=0.5j"), ([[1], [1, 2]], 0.5, "t=[[1], [1, 2]]"), (0, True, "lam=True"),
    ([1, 2], [0.1, 0.2, 0.3], "do not broadcast"),
])
def test_bad_t_and_lambda(cubic, t, lam, words, dps):
    refused(lambda: cubic.evaluate("x", t, lam=lam, dps=dps), InputError, words)


@pytest.mark.parametrize("call, words", [
    (lambda sol: sol.evaluate("x", lam=0.5), "depends on time"),
    (lambda sol: sol.evaluate("omega", 0, lam=0.5), "leave t out"),
    (lambda sol: sol.evaluate("z", 0, lam=0.5), "'z' is not an unknown"),
    (lambda sol: sol.evaluate("x'", 0, lam=0.5), "derivative=1"),
    (lambda sol: sol.evaluate("x", 0, lam=0.5, derivative=-1), "derivative=-1"),
    (lambda sol: sol.evaluate("x", 0, lam=0.5, derivative=0.5), "derivative=0.5"),
    (lambda sol: sol.evaluate("omega", lam=0.5, derivative=1), "leave derivative out"),
    (lambda sol: sol.branch_point("x", "3"), "n='3': give a whole number"),
    (lambda sol: sol.sequence("x", -1), "n=-1: give a whole number"),
    (lambda sol: sol.error_estimate("x", [0.1, 0.2]), "lam=[0.1, 0.2]: give one number"),
    (lambda sol: sol.evaluate("x", 0, lam=0.5, mu=1), "given: mu"),
    (lambda sol: sol.truncate(7), "cannot cut at order 7"),
    (lambda sol: sol.truncate(-1), "order=-1"),
    (lambda sol: sol.truncate(1.5), "order=1.5"),
    (lambda sol: sol.truncate(True), "order=True"),
    (lambda sol: sol.to_latex("z"), "'z' is not an unknown"),
    (lambda sol: sol.to_latex("x", order=7), "order=7"),
    (lambda sol: sol.to_latex("x", order=-1), "order=-1"),
    (lambda sol: sol.to_latex("x", order=1.5), "order=1.5"),
    (lambda sol: sol.to_latex("x", order=True), "order=True"),
    (lambda sol: sol.table("z"), "'z' is not an unknown"),
    (lambda sol: EIGHT.positions(sol, 0, 1), "is not a figure eight"),
    (lambda sol: EIGHT.closure(sol, 1), "is not a figure eight"),
    (lambda sol: EIGHT.closure_zero(sol), "is not a figure eight"),
])
def test_what_a_solution_cannot_do(cubic, call, words):
    refused(lambda: call(cubic), InputError, words)


@pytest.mark.parametrize("dps", [0, -1, 1.5, "x", True])
def test_bad_digits(cubic, dps):
    refused(lambda: cubic.evaluate("x", 0, lam=0.5, dps=dps), InputError, f"dps={dps!r}")


@pytest.mark.parametrize("dps", [None, 20])
@pytest.mark.parametrize("parameters, words", [
    ({}, "needs mu=…; given: none"),
    ({"nu": 1}, "needs mu=…; given: nu"),
    ({"mu": 1, "nu": 1}, "given: mu, nu"),
    ({"mu": math.nan}, "mu contains"),
    ({"mu": math.inf}, "mu contains"),
    ({"mu": "x"}, "mu='x'"),
])
def test_missing_and_unknown_parameters(mathieu, parameters, words, dps):
    refused(lambda: mathieu.evaluate("a", lam=0.5, dps=dps, **parameters), InputError, words)


def test_parameters_of_a_table(mathieu):
    refused(lambda: mathieu.table("a"), InputError, "needs mu")
    refused(lambda: mathieu.table("a", mu="x"), InputError, "mu='x'")
    refused(lambda: mathieu.table("a", mu=math.nan), InputError, "mu contains")
    refused(lambda: mathieu.evaluate("a", lam=0.5, dps=20, mu=[0.1, 0.2]), InputError, "one value")


@pytest.mark.parametrize("a", [0, -1, math.nan, math.inf, "foo bar", "import os", "x+", None, [1],
                               1j, True, "1/0", "-a", sp.I, sp.Symbol("a", negative=True),
                               "__import__('os').getcwd()", "exit()", "a.b", "sqrt.x", "[1]",
                               "lambda: 0", "exec(chr(49))", "'1'"])
def test_the_length_a_must_be_positive(a):
    """A text may come from a file: nothing in it is executed."""
    refused(lambda: fts.CubicOscillator(a=a), InputError)


@pytest.mark.parametrize("mu", [math.nan, math.inf, "foo", 1j, [1], sp.Symbol("nu"), sp.sqrt(2)])
def test_mu_must_be_rational(mu):
    refused(lambda: fts.GeneralizedMathieu(mu=mu), InputError, f"mu={mu!r}")


def test_a_symbol_cannot_be_evaluated():
    a = sp.Symbol("a", positive=True)
    exact = fts.solve(fts.CubicOscillator(a), 4)
    refused(lambda: exact.evaluate("x", 0, lam=0.5), InputError, "contains a")
    refused(lambda: exact.evaluate("x", 0, lam=0.5, dps=20), InputError, "contains a")
    refused(lambda: fts.solve(fts.CubicOscillator(a), 4, "float").coefficient("x", 1, 3),
            InputError, "arithmetic='exact'")


@pytest.mark.parametrize("call, kind, words", [
    (lambda sol: EIGHT.positions(None, 0, 1), InputError, "not a figure eight"),
    (lambda sol: EIGHT.positions(sol, math.nan, 1), InputError, "t contains"),
    (lambda sol: EIGHT.positions(sol, "x", 1), InputError, "t='x'"),
    (lambda sol: EIGHT.closure(sol, math.inf), InputError, "lam contains"),
    (lambda sol: EIGHT.closure_zero(sol, search=(1,)), InputError, "search=(1,)"),
    (lambda sol: EIGHT.closure_zero(sol, search=(0, math.nan)), InputError, "search contains"),
    (lambda sol: EIGHT.closure_zero(sol, search=(0, 1)), FTSeriesError, "no zero for 0 < λ < 1"),
    (lambda sol: EIGHT.closure_zero(sol.truncate(0)), FTSeriesError, "order 0"),
])
def test_bad_input_of_the_eight(call, kind, words):
    refused(lambda: call(fts.solve(fts.FigureEight(), 6)), kind, words)


# --- λ outside the radius of convergence is a warning that names the radius ---------------------

class TestRadius:
    """The cubic's radius is 3a exactly, where the period becomes infinite."""

    @pytest.mark.parametrize("dps", [None, 15])
    @pytest.mark.parametrize("a", [1, 2])
    def test_outside(self, a, dps):
        solution = fts.solve(fts.CubicOscillator(a), 40)
        with pytest.warns(ConvergenceWarning, match=r"λ = \S+ lies outside the radius") as caught:
            value = solution.evaluate("x", 0.1, lam=4 * a, dps=dps)
        assert math.isfinite(value)
        named = float(str(caught[0].message).split("near ")[1].split(";")[0])
        assert named == pytest.approx(3 * a, rel=0.05)       # fitted to 40 coefficients
        assert caught[0].filename == __file__                # it points at the caller's line

    @pytest.mark.parametrize("lam", [0, 0.5, 2.8, -2.8, [0.1, 2.5]])
    def test_inside(self, lam):
        solution = fts.solve(fts.CubicOscillator(), 40)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            solution.evaluate("x", 0.1, lam=lam)

    def test_negative_lambda_and_arrays_outside(self):
        solution = fts.solve(fts.CubicOscillator(), 40)
        for lam in (-4, [0.1, -4.0]):
            with pytest.warns(ConvergenceWarning):
                solution.evaluate("omega", lam=lam)

    def test_the_figure_eight_converges_at_its_physical_lambda(self):
        solution = fts.solve(fts.FigureEight(), 100, "float")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            solution.evaluate("r", 0.1, lam=2.0757)
        with pytest.warns(ConvergenceWarning, match="near 2.2"):
            solution.evaluate("r", 0.1, lam=2.5)


# --- an interrupt -------------------------------------------------------------------------------

@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
def test_an_interrupt_leaves_no_trace(monkeypatch, arithmetic):
    """Ctrl-C in the middle: the precision of FLINT is as before, and the next solve is right."""
    from ftseries.stages import Stages
    before, stage = (flint.ctx.prec, flint.ctx.cap), Stages.stage

    def interrupted(self, k):
        if k == 20:
            assert arithmetic != "ball" or flint.ctx.prec == 300
            raise KeyboardInterrupt
        return stage(self, k)

    with monkeypatch.context() as patch:
        patch.setattr(Stages, "stage", interrupted)
        with pytest.raises(KeyboardInterrupt):
            fts.solve(fts.FigureEight(), 30, arithmetic, precision=300)
    assert (flint.ctx.prec, flint.ctx.cap) == before
    again = fts.solve(fts.FigureEight(), 6, arithmetic)
    assert float(again.coefficient("phi", 5, 5)) == pytest.approx(-9 / 20480, rel=1e-15)


def test_an_error_leaves_no_trace():
    before = flint.ctx.prec
    refused(lambda: fts.solve(declared(unknowns=FREE), 20, "ball", precision=300),
            UndeterminedError)
    assert flint.ctx.prec == before
