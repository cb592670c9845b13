"""How a problem is declared: the modes of an ansatz, seeds, units, texts as numbers."""

import math

import numpy as np
import pytest
import sympy as sp
from flint import fmpq
from sample_problems import Duffing, LotkaVolterra, MassOnSpring, VanDerPol

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


def first_mode(seed, fixed, equation="x'' + x + x**3", order=7):
    """The coefficients of cos τ and sin τ in the solution."""
    sol = fts.solve(fts.Equations(equation, seed=seed, frequency="omega", unknowns={
        "x": Field("both", modes="odd", powers="odd", fixed=fixed), "omega": Scalar()}), order)
    return [{m: sp.Rational(str(row[mode])) for m, row in enumerate(sol.coefficients["x"])
             if mode in row} for mode in ((0, 1), (1, 1))]


def test_fixed_modes_keep_the_seed():
    """At all orders; a Fourier order means both kinds, and is λ's meaning without a seed."""
    assert first_mode(None, (1,)) == [{1: 1}, {}]
    for fixed in ((1,), ((0, 1), (1, 1))):
        assert first_mode({"x": "lam*cos(omega*t)", "omega": 1}, fixed) == [{1: 1}, {}]
        assert first_mode({"x": "lam*sin(omega*t)", "omega": 1}, fixed) == [{}, {1: 1}]


def test_a_fixed_mode_of_one_kind_is_a_phase():
    """It is zero without a seed, and what the seed gives with one; the other kind is found."""
    cycle = "x'' + x = (lam**2 - x**2)*x'"
    cosine, sine = first_mode(None, ((1, 1),), cycle)
    assert sine == {} and cosine[1] == 2 and len(cosine) > 1
    other = first_mode({"x": "2*lam*sin(omega*t)", "omega": 1}, ((0, 1),), cycle)
    assert other[0] == {} and other[1][1] == 2
    forced = "x'' + lam**2*x'/10 + x + x**3 = lam**3*cos(omega*t)"
    assert first_mode(None, ((0, 1),), forced, 3) == [{}, {1: 10, 3: -375}]


def test_what_may_be_asked_beyond_the_seed():
    eight = fts.FigureEight()
    assert eight.allowed("r", 2, 2) and eight.allowed("r", 0, 6)
    assert not eight.allowed("r", 4, 2)                    # n > m
    assert not eight.allowed("r", 2, 3)                    # odd power
    assert not eight.allowed("r", 0, 0)                    # the seed's


def test_a_head_start_of_the_fourier_orders():
    """With ahead = 2 the mode n may begin at λ^{n-2}."""
    problem = changed(ahead=2)
    assert problem.allowed("x", 5, 3) and not problem.allowed("x", 7, 3)


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
    (fts.GeneralizedMathieu("-3/10"), "GeneralizedMathieu(mu=-3/10)"),
    (fts.GeneralizedMathieu(2, branch="a1"), "GeneralizedMathieu(mu=2, branch=a1)")])
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
    (2**0.5, sp.Rational("1.4142135623730951")), (0.1 + 0.2, sp.Rational("0.30000000000000004")),
    ("0.12345678901234567", sp.Rational("0.12345678901234567")), (0.3 * a, 3 * a / 10),
    (sp.Float(1) / 3, sp.Rational("0.3333333333333333")), (np.float32(0.3), sp.Rational(3, 10)),
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


# --- numbers: a float is the decimal that it looks like, wherever a user gives one ---------------

X3 = {"x": Field("cos", modes="odd", powers="odd", fixed=(1,)), "omega": Scalar("even")}


def changed(base=Duffing, **attributes):
    """An instance of a changed problem; it does not stay in the list of known problems."""
    problem = type("Changed", (base,), attributes)()
    del Problem.classes["Changed"]
    return problem


def with_force(force):
    return changed(equations=lambda self, lam, x, omega: {
        "(F)": omega**2 * x.diff(2) + force(lam, x)})


NUMBERS = [0.3, 1 / 3, 2**0.5, 0.1 + 0.2, 123456789.12345679]


@pytest.mark.parametrize("k", NUMBERS)
def test_one_rule_for_numbers_everywhere(k):
    """ω² x″ + x + k x³ = 0 has ω_2 = 3k/8."""
    exact = sp.Rational(repr(k))
    problems = [
        with_force(lambda lam, x: x + k * x**3), with_force(lambda lam, x: x + x**3 / (1 / k)),
        with_force(lambda lam, x: x + sp.Float(k) * x**3),
        with_force(lambda lam, x: x + np.float64(k) * x**3),
        fts.Equations("x'' + x + k*x**3", X3, frequency="omega", parameters={"k": k}),
        fts.Equations(f"x'' + x + {k!r}*x**3", X3, frequency="omega")]
    found = [fts.solve(p, 2).coefficient("omega", 2) for p in problems]
    assert found[0] == found[2] == found[3] == found[4] == found[5] == 3 * exact / 8
    assert found[1] == sp.Rational(3, 8) / sp.Rational(repr(1 / k))
    assert fts.CubicOscillator(k).a == fts.FigureEight(exponent=k).exponent == exact
    assert sp.Rational(str(fts.GeneralizedMathieu(mu=k).mu)) == exact


def test_numbers_of_sums_seeds_and_exponents():
    problem = changed(seed={"x": [{}, {1: 0.1}], "omega": [1]}, unknowns=X3)
    assert problem.first_coefficients()["x"][1] == {(0, 1): fmpq(1, 10)}
    added = with_force(lambda lam, x: x * (x**2 + 0.7 - 0.2) / 0.5)
    assert fts.solve(added, 2).coefficient("omega", 2) == sp.Rational(3, 4)
    root = with_force(lambda lam, x: x * (1 + x**2)**0.3)
    assert fts.solve(root, 2).coefficient("omega", 2) == sp.Rational(9, 80)


# --- free parameters -----------------------------------------------------------------------------

def test_parameters_come_by_name():
    by_name = changed(parameters=("mu", "k"), equations=lambda self, lam, x, omega, mu, k: {
        "(D)": omega**2 * x.diff(2) + x + mu * x**3 + k * x**5})
    sol = fts.solve(by_name, 6)
    mu, k = sp.symbols("mu k")
    assert sol.coefficient("omega", 2) == 3 * mu / 8
    assert sp.expand(sol.coefficient("omega", 4) - (-15 * mu**2 / 256 + 5 * k / 16)) == 0
    old = fts.solve(MassOnSpring(), 6)
    assert [sp.expand(sol.coefficient("omega", m)).subs(k, 0) for m in range(7)] == [
        sp.expand(old.coefficient("omega", m)) for m in range(7)]


def test_parameters_by_name_are_numbers_of_an_orbit():
    sol = fts.solve(changed(parameters=("mu",), equations=lambda self, lam, x, omega, mu: {
        "(D)": omega**2 * x.diff(2) + x + mu * x**3}), 12)
    orbit = sol.refine(0.5, mu=2)
    assert orbit.residual < 1e-12
    assert orbit.evaluate("omega") == pytest.approx(sol.evaluate("omega", lam=0.5, mu=2), abs=1e-5)


# --- a forgotten or misspelt frequency ------------------------------------------------------------

def without_frequency(**attributes):
    """Duffing's equation, declared anew."""
    return changed(Problem, unknowns=X3, seed=Duffing.seed, **(
        {"equations": Duffing.equations} | attributes))


def test_a_forgotten_frequency():
    with pytest.raises(InputError, match="^omega stands with derivatives only in Changed.*"
                       "declare frequency = 'omega' \\(or frequency = None, where t is"):
        fts.solve(without_frequency(), 4)
    square = without_frequency(equations=lambda self, lam, x, omega: {
        "(D)": omega * x.diff(2) + x + x**3})
    with pytest.raises(InputError, match="write omega d/dτ for d/dt"):
        fts.solve(square, 4)


def test_a_frequency_that_is_left_out_on_purpose():
    """x is a function of τ then."""
    tau = fts.solve(without_frequency(frequency=None), 4)
    t = fts.solve(without_frequency(frequency="omega"), 4)
    assert tau.coefficients == t.coefficients
    assert tau.evaluate("x", 1.0, lam=0.1) == pytest.approx(
        t.evaluate("x", 1.0 / t.evaluate("omega", lam=0.1), lam=0.1), abs=1e-15)


def test_a_scalar_that_is_no_frequency():
    """x″ + c x′ + x = -λ³ sin τ is solved by x = λ cos τ and c = λ²: c stands with x′ only, but x″
    stands without it, so the time scale is not c's."""
    damped = changed(Problem, seed={"x": [{}, {(0, 1): 1}], "c": [0]}, unknowns={
        "x": Field("both", modes="odd", powers="odd", fixed=(1,)), "c": Scalar("even")},
        equations=lambda self, lam, x, c: {
            "(D)": x.diff(2) + c * x.diff() + x + lam**3 * lam.expansion.sin(1)})
    assert [fts.solve(damped, 4).coefficient("c", m) for m in range(5)] == [0, 0, 1, 0, 0]


@pytest.mark.parametrize("name, meant", [("frequecy", "frequency"), ("parameter", "parameters"),
                                         ("unknown", "unknowns"), ("seeds", "seed")])
def test_a_misspelt_declaration(name, meant):
    attributes = {"unknowns": X3, "seed": Duffing.seed, "frequency": "omega",
                  "equations": Duffing.equations}
    attributes[name] = attributes.pop(meant, ("mu",))
    with pytest.raises(InputError, match=f"^Changed has the attribute {name!r}, which looks like "
                                         f"{meant!r} misspelt"):
        fts.solve(changed(Problem, **attributes), 4)


def test_attributes_of_ones_own():
    problem = changed(Duffing, frequencies=(1, 2), seeds=3, length=2, _frequency="x")
    problem.variables = "x"
    problem.variable = "s"
    assert fts.solve(problem, 2).coefficient("omega", 2) == sp.Rational(3, 8)


# --- the method equations ------------------------------------------------------------------------

@pytest.mark.parametrize("equations, parameters, form", [
    (lambda self, x, omega: {}, (), "lam, x, omega"),
    (lambda lam, x, omega: {}, (), "lam, x, omega"),
    (lambda self, lam, y, omega: {}, (), "lam, x, omega"),
    (lambda: {}, (), "lam, x, omega"),
    (lambda self, lam, x, omega, mu: {}, (), "lam, x, omega"),
    (lambda self, lam, x, omega, nu: {}, ("mu",), "lam, x, omega, mu"),
])
def test_other_arguments_of_equations(equations, parameters, form):
    problem = changed(equations=equations, parameters=parameters)
    with pytest.raises(InputError, match="^the method equations of Changed takes other arguments "
                                         f".*write def equations\\(self, {form}\\)$"):
        fts.solve(problem, 4)


@pytest.mark.parametrize("term", [lambda self, x: self.mu * x, lambda self, x: mu * x])  # noqa: F821
def test_a_parameter_that_does_not_come_as_an_argument(term):
    problem = changed(parameters=("mu",), equations=lambda self, lam, x, omega: {
        "(D)": term(self, x)})
    with pytest.raises(InputError, match="^the parameter mu of Changed comes as an argument; write "
                                         r"def equations\(self, lam, x, omega, mu\)$"):
        fts.solve(problem, 4)


@pytest.mark.parametrize("missing", [lambda self, x: self.nothing * x,
                                     lambda self, x: nothing * x])           # noqa: F821
def test_errors_of_ones_own_stay(missing):
    problem = changed(equations=lambda self, lam, x, omega: {"(D)": missing(self, x)})
    with pytest.raises((NameError, AttributeError), match="nothing"):
        fts.solve(problem, 4)


def test_a_name_that_is_declared_twice():
    with pytest.raises(InputError, match="^omega is declared twice, as an unknown and as a param"):
        fts.solve(changed(parameters=("omega",)), 4)


@pytest.mark.parametrize("force, words", [
    (lambda x: x ^ 3, r"\^ is no power in Python; write x\*\*3"),
    (lambda x: 3 ^ x, r"\^ is no power in Python"),
    (abs, "has no Fourier-Taylor series"),
    (lambda x: x if x > 0 else -x, "neither large nor small"),
    (lambda x: max(x, 0), "neither large nor small"), (lambda x: min(0, x), "neither large nor"),
    (lambda x: x * np.sqrt(1 + x * x), "powers, such as x.*for a root"),
    (np.tanh, "knows sin, cos and exp"),
    (math.sin, "use ftseries.sin"), (sp.sin, "use ftseries.sin"), (sp.exp, "use ftseries.sin"),
    (sp.sqrt, "Fraction"), (float, "use ftseries.sin"),
])
def test_what_python_offers_to_numbers_only(force, words):
    with pytest.raises(InputError, match=words):
        fts.solve(with_force(lambda lam, x: force(x)), 4)


def test_numbers_of_sympy_and_numpy_on_the_left():
    third = with_force(lambda lam, x: x + sp.Rational(1, 3) * x**3)
    assert fts.solve(third, 2).coefficient("omega", 2) == sp.Rational(1, 8)
    sines = with_force(lambda lam, x: np.sin(x)), with_force(lambda lam, x: fts.sin(x))
    assert len({fts.solve(p, 4).coefficient("omega", 4) for p in sines}) == 1


def test_a_text_keeps_all_its_digits():
    assert expression("0.12345678901234567890123") == sp.Rational(12345678901234567890123, 10**23)


def test_a_problem_without_equations():
    class Nothing(Problem):
        unknowns, seed = Duffing.unknowns, Duffing.seed
        frequency = "omega"
    with pytest.raises(InputError, match="Nothing has no equations"):
        fts.solve(Nothing(), 2)
