"""How a problem is declared: the modes of an ansatz, seeds, units, texts as numbers."""

import pytest
import sympy as sp
from flint import fmpq
from sample_problems import Duffing, LotkaVolterra, VanDerPol

import ftseries as fts
from ftseries import Field, InputError, Problem, Scalar
from ftseries.problem import expression


@pytest.mark.parametrize("field, columns", [
    (Field("cos"), [(0, 3), (0, 2), (0, 1), (0, 0)]),
    (Field("sin"), [(1, 3), (1, 2), (1, 1)]),
    (Field("both"), [(0, 3), (1, 3), (0, 2), (1, 2), (0, 1), (1, 1), (0, 0)]),
    (Field("cos", modes="even"), [(0, 2), (0, 0)]),
    (Field("cos", modes="odd", fixed=(1,)), [(0, 3)]),
    (Field("both", modes="odd", fixed=(1,)), [(0, 3), (1, 3)]),
    (Field("both", modes="odd", fixed=((1, 1),)), [(0, 3), (1, 3), (0, 1)]),
    (Field("both", modes="even", fixed=((0, 0),)), [(0, 2), (1, 2)]),
])
def test_the_columns_of_an_ansatz_highest_first(field, columns):
    assert field.columns(3) == columns
    assert all(field.has(mode) and not field.is_fixed(mode) for mode in columns)


def test_there_is_no_sine_of_order_zero():
    assert not Field("both").has((1, 0))
    assert not Field("sin").has((1, 0))


@pytest.mark.parametrize("series, key, mode", [("cos", 2, (0, 2)), ("sin", 2, (1, 2)),
                                               ("both", 2, (0, 2)), ("both", (1, 2), (1, 2))])
def test_modes_given_by_hand(series, key, mode):
    assert Field(series).mode(key) == mode


def test_scalar():
    assert Scalar().columns(7) == [(0, 0)]
    assert Scalar().has((0, 0)) and not Scalar().has((0, 1)) and not Scalar().is_fixed((0, 0))


def test_declarations_do_not_change():
    with pytest.raises(AttributeError):
        Field().series = "sin"
    assert Field("cos") == Field() and hash(Field()) == hash(Field("cos"))


def test_first_coefficients_are_rational_and_without_zeros():
    assert Duffing().first_coefficients() == {"x": [{}, {(0, 1): fmpq(1)}],
                                              "omega": [{(0, 0): fmpq(1)}]}
    assert fts.FigureEight().first_coefficients() == {"r": [{(0, 0): fmpq(1)}],
                                                      "phi": [{}, {(0, 1): fmpq(1)}]}


    class Written(Duffing):
        seed = {"x": [{}, {1: "1.0"}], "omega": [0.5, 0]}

    assert Written().first_coefficients() == {"x": [{}, {(0, 1): fmpq(1)}],
                                              "omega": [{(0, 0): fmpq(1, 2)}, {}]}


def test_what_may_be_asked_beyond_the_seed():
    eight = fts.FigureEight()
    assert eight.allowed("r", 2, 2) and eight.allowed("r", 0, 6)
    assert not eight.allowed("r", 4, 2)                    # n > m
    assert not eight.allowed("r", 2, 3)                    # odd power
    assert not eight.allowed("r", 0, 0)                    # the seed's


def test_units_of_the_cubic():
    a = sp.Symbol("a", positive=True)
    problem = fts.CubicOscillator(a)
    assert sp.simplify(problem.unit("x", 3) - a**-2) == 0
    assert sp.simplify(problem.unit("omega", 2) - 2 * sp.sqrt(3) * a ** sp.Rational(-3, 2)) == 0
    assert fts.FigureEight().unit("r", 4) == sp.cbrt(3) and fts.FigureEight().unit("phi", 3) == 1
    assert Duffing().unit("x", 5) == 1


@pytest.mark.parametrize("problem, text", [
    (fts.CubicOscillator(), "CubicOscillator(a=1)"), (fts.FigureEight(), "FigureEight()"),
    (fts.CubicOscillator(0.5), "CubicOscillator(a=1/2)"),
    (fts.GeneralizedMathieu(), "GeneralizedMathieu()"),
    (fts.GeneralizedMathieu("-3/10"), "GeneralizedMathieu(mu=-3/10)")])
def test_repr(problem, text):
    assert repr(problem) == text


def test_problems_are_found_by_their_names():
    class Found(Problem):
        pass
    assert Problem.classes["Found"] is Found
    assert Problem.classes["FigureEight"] is fts.FigureEight


@pytest.mark.parametrize("problem, name", [(fts.CubicOscillator(), "(C3)"),
                                           (fts.GeneralizedMathieu(1), "(M1)"),
                                           (VanDerPol(), "(van der Pol)"),
                                           (LotkaVolterra(), "(prey)")])
def test_equations_are_named(problem, name):
    from ftseries.expansion import Expansion
    from ftseries.laurent import RationalRing
    expansion = Expansion(RationalRing())
    unknowns = {key: expansion.unknown() for key in problem.unknowns}
    assert name in problem.residuals(expansion.lam, unknowns)


def test_a_problem_without_a_condition_says_so():
    with pytest.raises(InputError, match="Duffing has no condition"):
        Duffing().condition(None)
    with pytest.raises(InputError, match="Duffing has no condition"):
        Duffing().first_lam(None)


a, b = sp.symbols("a b", positive=True)


@pytest.mark.parametrize("text, value", [
    ("1", 1), ("-3/2", sp.Rational(-3, 2)), ("0.1", sp.Rational(1, 10)),
    ("1e-3", sp.Rational(1, 1000)),
    ("sqrt(3)", sp.sqrt(3)), ("2*sqrt(3)*a**(3/2)/b", 2 * sp.sqrt(3) * a ** sp.Rational(3, 2) / b),
    ("a", a), (0.1, sp.Rational(1, 10)), (sp.pi, sp.pi), (3, 3),
])
def test_texts_as_numbers(text, value):
    assert expression(text) == value


@pytest.mark.parametrize("value", [sp.sqrt(2) * a**2 / 3 + b, sp.Rational(2, 7), 3 * a - b])
def test_what_str_writes_expression_reads(value):
    assert expression(str(value)) == value


@pytest.mark.parametrize("text", ["", "1 +", "f(1)", "a.b", "a[0]", "'a'", "[1]", "lambda: 1",
                                  "__import__('os')", "sqrt('1')", "(1, 2)", "a if b else 1",
                                  "a == b", "(a := 1)", "exec(chr(49))", "True and a", None, [1]])
def test_texts_that_are_refused(text):
    with pytest.raises(InputError, match="is not a number or a SymPy expression"):
        expression(text)
