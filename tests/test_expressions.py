"""Texts and SymPy expressions from strangers: bounded, never executed, and read as written."""

import inspect
import json
import pickle
import sys
import time
from fractions import Fraction

import pytest
import sympy as sp
from flint import fmpq

import ftseries as fts
from ftseries.expressions import (
    DEGREE,
    DIGITS,
    LEAVES,
    LENGTH,
    NESTED,
    TERMS,
    by_name,
    expression,
    name_of,
)

T, LAM, OMEGA = sp.symbols("t lam omega")
X = sp.Function("x")
OSCILLATOR = {"frequency": "omega",
              "unknowns": {"x": fts.Field("cos", fixed=(1,)), "omega": fts.Scalar()}}
SEED = {"x": "lam*cos(omega*t)", "omega": "1"}


def oscillator(equation, **changes):
    return fts.Equations(equation, **OSCILLATOR | changes)


def refused(call, words, kind=fts.InputError):
    """One sentence with these words, within two seconds of computing."""
    begin = time.process_time()
    with pytest.raises(kind) as caught:
        call()
    assert time.process_time() - begin < 2
    text = str(caught.value)
    assert words in text, text
    assert "\n" not in text and ". " not in text and len(text) < 600
    text.encode()                                           # no lone surrogate in it


# --- what hung, took all memory, or was no sentence ----------------------------------------------

#: what stands beside x'' + x, and what the sentence says
HUGE = {
    "9**9**9**9*x": f"a number of more than {DIGITS} digits arises in a power",
    "x + 2**-100000000": f"more than {DIGITS} digits",
    "x*1e999999999": "the number 1e999999999",
    "x*1e900*1e900": "a number of 1801 digits",
    "x**1000000": f"the exponent 1000000; exponents go up to {DEGREE}",
    "x**10000": "the exponent 10000",
    "x**(10**400)": "the exponent of 401 digits",
    "x**(1/10**9)": "the exponent 1/1000000000; denominators of exponents go up to",
    "(1 + x)**3000": "the exponent 3000",
    "(1 + x)**20*(2 + x)**20*(3 + x)**20": f"9261 terms after multiplying out; at most {TERMS}",
    "(1 + x + x' + omega)**50": "23426 terms",
    "x" + "*x" * 300: f"301 factors in a term after multiplying out; at most {DEGREE}",
    "((x**50)**50)**50": "125000 factors in a term",
    "2**x**2**x**9**9**9": "digits",
    "diff(t**1000000, t, 999999)": "the exponent 1000000",
    "diff(x, t, 1000000000)": "a derivative of order 1000000000",
    "diff(" * 40 + "x*x'" + ", t)" * 40: "a derivative of order 11",
    "diff((1 + x)**30*(2 + x')**30*sin(x)*exp(x)*x*(3 + sin(x))**4, t, 2)": "terms",
    "x" + "'" * 5000: "a derivative of order 5000",
    "sin(10**1000000)*x": "digits",
    "exp(exp(exp(9)))*x": "exp is taken of a number that is a function's value itself",
    "exp(10**9)*x": f"exp is taken of a number beyond {DIGITS}",
    "sqrt(10**100000 + 1)*x": "digits",
    "sin(" * 10 + "x" + ")" * 10: f"6 functions in each other; at most {NESTED}",
    "exp(" * 6 + "x" + ")" * 6: "6 functions",
    "(" * 3000 + "x" + ")" * 3000: "3000 brackets in each other",
    "-" * 9000 + "x": "more than 50 deep",
    "+" * 9000 + "x": "more than 50 deep",
    "x**" * 300 + "x": "deep",
    "a" * 9000: "9000 characters in one name or number",
    "a" * 30_000: f"30006 characters in the text; at most {LENGTH}",
    "9" * 9000 + "*x": "9000 characters in one name or number",
    "9" * 20_000: "characters in the text",
    "x" + "+x" * 3000: f"numbers and names; at most {LEAVES}",
    "x'" * 3000: "numbers and names",
    "(" + "+".join(f"sqrt({p})" for p in sp.primerange(60)) + ")*x": "at most 10 can be",
}


@pytest.mark.parametrize("text", HUGE, ids=lambda text: text[:20])
def test_a_text_that_is_too_large(text):
    refused(lambda: oscillator("x'' + " + text), HUGE[text])
    refused(lambda: oscillator("x'' + x = " + text), HUGE[text].replace("30006", "30001"))


STRANGE = {
    "x # + x**3": "leave comments out",
    "x\ud800": "'\\ud800' in",
    "x\0": "'\\x00' in",
    "'a'*10000000000": "cannot be read",
    "1<<10**12": "'<' in",
    "x % 2": "'%' in", "x @ x": "'@' in", "x[0]": "'[' in", "{x}": "'{' in", "x; x": "';' in",
    "x.real": "cannot be read", "(lambda: x)()": "λ is written lam", "x if x else x": "cannot be",
    "[x for x in x]": "cannot be read", "x // 2": "cannot be read", "x and x": "cannot be read",
    "0x10*x": "write products with *", "1_000*x": "write products with *", "1j*x": "write prod",
    "1if x else 1": "write products with *", "2e3x": "write products with *",
    "True*x": "cannot be read", "x(t, t)": "contains x(t, t), which is not understood",
    "x(t)(t)": "calls a number or a bracket", "2(x)": "calls a number or a bracket",
    "sin(x, x)": "cannot be read", "sin()": "cannot be read", "x()": "contains x(), which",
    "x(*x)": "cannot be read", "sin(x=1)": "a bracket that is not closed", "sin": "cannot be read",
    "(2*x)'": "write primes behind the name of a field", "x(t)'": "write primes behind",
    "x(t - x)": "contains x(t - x), but x is a function of the time",
    "x'(0)": "initial conditions are not given", "x(pi)": "initial conditions are not given",
    "5*diff(x, lam)": "contains diff(x, lam), which is not understood",
    "diff(x, t, lam)": "contains diff(x, t, lam)", "diff(x, omega)": "contains diff(x, omega)",
    "diff(x)": "contains diff(x)", "diff(x, 2)": "contains diff(x, 2)",
    "diff(x, t, -1)": "contains diff(x, t, -1)", "diff(x, t, 1/2)": "contains diff(x, t, 1 / 2)",
    "diff()": "contains diff()",
    "nan*x": "contains nan", "oo*x": "contains oo", "I*x": "contains I", "E*x": "contains E",
    "Integer(2)*x": "the function Integer", "__import__('os')": "cannot be read",
    "eval(x)": "the function eval",
}


@pytest.mark.parametrize("text", STRANGE)
def test_a_text_that_is_not_of_the_language(text):
    """Nothing is executed, and nothing is left out."""
    refused(lambda: oscillator("x'' + " + text), STRANGE[text])


@pytest.mark.parametrize("text, same", [
    ("x'' + x + x^3", "x'' + x + x**3"), ("x''+x\n\t+x**3", "x'' + x + x**3"),
    ("x'' + x*(-x)**2", "x'' + x**3"), ("x'' - -x", "x'' + x"), ("x'' + -x**2", "x'' - x**2"),
    ("x'' + 2**-1*x", "x'' + x/2"), ("x'' + x/2/3*4", "x'' + 2*x/3"),
    ("x'' + x - 1 - 2", "x'' + x - 3"),
    ("x'' + 2**3**2*x", "x'' + 512*x"), ("x'' + .5*x + 1.*x**2", "x'' + x/2 + x**2"),
    ("x'' + 1e-3*x", "x'' + x/1000"), ("x'' + x*λ", "x'' + lam*x"),
    ("diff(x, t, t) + x", "x'' + x"), ("diff(x', t) + x", "x'' + x"),
    ("diff(x*x, t) + x", "2*x*x' + x"),
    ("x''(t - pi/omega) + x", "diff(x(t - pi/omega), t, 2) + x"),
    ("x'' + x + diff(x, t, 0)", "x'' + 2*x"),
    ("x'' + 0.12345678901234567890123*x", "x'' + 12345678901234567890123*x/10**23"),
])
def test_texts_that_mean_the_same(text, same):
    problems = [oscillator(e, seed=SEED) for e in (text, same)]
    assert problems[0].expressions == problems[1].expressions


def nested(f, times):
    e = X(T)
    for _ in range(times):
        e = f(e)
    return e


NINES = sp.Pow(9, sp.Pow(9, sp.Pow(9, 9, evaluate=False), evaluate=False), evaluate=False)


@pytest.mark.parametrize("e, words", [
    (X(T)**1000000, "1000000 factors in a term"),
    ((1 + X(T))**300, "300 factors in a term"),
    (nested(sp.sin, 10), "6 functions in each other"),
    (nested(lambda e: 1 + X(T) * e, 60), "deep"),
    (sp.Add(*(X(T)**i * LAM**j for i in range(1, 40) for j in range(1, 30))), "1132 terms"),
    (X(T) * 10**2000, "a number of 2001 digits"),
    (X(T) * sp.Float("1e5000"), "more than 1000 digits is given"),
    (X(T) * NINES, "digits"),
    (X(T)**sp.Rational(1, 10**9), "denominators of exponents"),
    (sp.Integral(X(T), T), "Integral(x, t), which has no Fourier-Taylor series"),
    (X(T) + sp.Sum(LAM**OMEGA, (OMEGA, 1, 10**12)), "which has no Fourier-Taylor series"),
    (sp.Derivative(X(T), LAM), "which is not a derivative by t"),
    (X(T) * sp.GoldenRatio, "GoldenRatio, which has no"),
    (X(T) * sp.gamma(sp.Rational(1, 3)), "gamma(1/3), which has no"),
])
def test_a_sympy_expression_beyond_the_language(e, words):
    refused(lambda: oscillator(X(T).diff(T, 2) + e), words)


@pytest.mark.parametrize("value", [10**9, "9**9**9", "1e400", "1/0"])
def test_a_value_that_would_make_a_huge_number(value):
    refused(lambda: oscillator("x'' + x*2**m", parameters={"m": value}), "")


@pytest.mark.parametrize("changes, words", [
    ({"seed": SEED | {"x": "lam*cos(omega*t) + lam**(9**9**9)"}}, "digits"),
    ({"seed": SEED | {"x": "(1 + lam)**90*(2 + lam)**90*cos(omega*t)"}}, "terms after"),
    ({"seed": SEED | {"omega": "sqrt(" * 30 + "2" + ")" * 30}}, "denominators"),
    ({"seed": SEED | {"omega": "+".join(f"sqrt({p})" for p in sp.primerange(200))}}, "46 roots"),
    ({"seed": SEED | {"x": ["__import__('os')"]}}, "is not an equation"),
    ({"time": "a" * 5000}, "a name has at most"),
    ({"ahead": 10**6}, "ahead goes up to 100 there"),
    ({"parameters": ("mu",)}, "no equation contains the parameter mu"),
    ({"parameters": {"mu": 2}}, "no equation contains the parameter mu"),
    ({"parameters": {"mu": None, "nu": 1}}, "no equation contains the parameter mu, nu"),
])
def test_other_texts_and_names(changes, words):
    refused(lambda: oscillator("x'' + x + x**3", **changes), words)


# --- numbers and units --------------------------------------------------------------------------

@pytest.mark.parametrize("text", [
    "9**9**9**9", "2**-100000000", "1e999999999", "9" * 5000, "a" * 20_000, "-" * 9000 + "1",
    "(" * 999 + "1" + ")" * 999, "'a'*10000000000", "1<<10**12", "1 % 2", "a # b", "\ud800", "\0",
    "nan", "NaN", "oo", "zoo", "I", "inf", "1/0", "0/0", "sqrt(-1)", "sin(1)", "a.b", "a'",
    "lambda", "sqrt", "exp", "(a + b)**500", "sqrt(1, 2)", "1" + "+1" * 2000, "2**sqrt(2)",
    "a**(1/10**9)",
])
def test_a_text_that_is_no_number(text):
    for make in (expression, fts.CubicOscillator, lambda a: fts.FigureEight(exponent=a),
                 lambda a: fts.GeneralizedMathieu(mu=a)):
        refused(lambda make=make: make(text), "")


@pytest.mark.parametrize("x", [
    ["__import__('os')"], ("1",), {"a": 1}, {"1"}, object(), None, b"1", sp.exp(1), sp.sin(1), sp.I,
    sp.nan, sp.oo, sp.Symbol("nan"), sp.Symbol("a b"), sp.Symbol("pi"), X(T), sp.Eq(T, 1), NINES,
    sp.Float("1e5000"), sp.Symbol("a")**1000, sp.Matrix([1]),
])
def test_what_is_no_number(x):
    refused(lambda: expression(x), "")


@pytest.mark.parametrize("code", ["__import__('sys').setprofile(1)", "exec('raise SystemExit')"])
def test_a_file_is_never_executed(code, tmp_path):
    """SymPy would execute a text in a list, as a file of JSON may hold."""
    from ftseries import jsonfile
    fts.solve(fts.CubicOscillator(2), 3).save(tmp_path / "s.json")
    data = json.loads((tmp_path / "s.json").read_text())
    for value in (code, [code], {"a": code}, [[code]]):
        data["problem"]["arguments"]["a"] = value
        jsonfile.write(tmp_path / "t.json", "ftseries", {
            k: v for k, v in data.items() if k not in ("format", "version", "sha256")})
        refused(lambda: fts.load(tmp_path / "t.json"), "", fts.FTSeriesError)
        assert sys.getprofile() is None


@pytest.mark.parametrize("x", ["2*sqrt(3)/a", "a**(1/3)*pi", 0.1, Fraction(1, 3), sp.sqrt(2), sp.pi,
                               "(a + b)**2/(1 - sqrt(2))", "α*β", "1e-300", "2**-3000", 10**999])
def test_a_number_is_written_as_it_is_read(x):
    assert expression(str(expression(x))) == expression(x)


def test_branches():
    refused(lambda: fts.GeneralizedMathieu(branch="b" + "9" * 20_000), "up to 9999")
    refused(lambda: fts.GeneralizedMathieu(branch="a٣"), "give 'a0'")


def test_a_root_of_any_degree():
    """1^(p/q) is 1; no other rational in a memory has a root of degree 10^900."""
    tiny = fts.solve(fts.FigureEight(exponent=sp.Rational(1, 10**900)), 4)
    zero = fts.solve(fts.FigureEight(exponent=0), 4)
    difference = tiny.coefficients["phi"][3][0, 3] - zero.coefficients["phi"][3][0, 3]
    assert abs(difference) < fmpq(1, 10**899)


# --- names --------------------------------------------------------------------------------------

@pytest.mark.parametrize("key, name", [("µ", "μ"), ("ϕ", "φ"), (sp.Symbol("ϵ"), "ε"),
                                       (sp.Function("ﬁ"), "fi"), ("Integer", "Integer")])
def test_names_are_those_of_python(key, name):
    assert name_of(key) == name


def test_a_letter_and_its_accent_are_one():
    """As Python reads a name that is typed in two characters."""
    unknowns = {"e\u0301": fts.Field("cos", fixed=(1,)), "omega": fts.Scalar()}
    sol = fts.solve(fts.Equations("e\u0301'' + e\u0301 + e\u0301**3 = 0", unknowns=unknowns,
                                  frequency="omega"), 2)
    assert sol.coefficient("\u00e9", 1, 1) == 1 and sol.coefficient("omega", 2) == sp.Rational(3, 8)


def test_another_spelling_of_a_name_is_told():
    problem = fts.Equations("ϕ'' + ϕ + µ*ϕ**3 = 0", unknowns={
        "ϕ": fts.Field("cos", fixed=(1,)), "omega": fts.Scalar()}, frequency="omega",
        parameters=("µ",))
    sol = fts.solve(problem, 2)
    refused(lambda: sol.coefficient("ϕ", 1, 1), "as Python writes them (NFKC), this one 'φ'")
    refused(lambda: sol.evaluate("omega", lam=0.1, **{"µ": 1}), "as Python writes them (NFKC)")
    assert sol.evaluate("omega", lam=0.1, µ=1) == sol.evaluate("omega", lam=0.1, μ=1)


def test_two_spellings_of_one_name():
    refused(lambda: by_name({"µ": 1, "μ": 2}), "μ is given twice")


#: field, frequency, parameter, time, λ
NAMES = [("θ", "ω", "μ", "t", "lam"), ("x", "omega", "\u00b5", "t", "lam"),
         ("φ", "ω", "λ", "τ", "ε"), ("ϕ", "Ω", "ϵ", "s", "λ"),
         ("x", "omega", "omega_0", "t", "lam"),
         ("x", "omega", "x_c1_1", "t", "lam"), ("x", "x_c0", "sqrt3", "t", "lam"),
         ("w", "p0", "p1", "t", "lam"), ("Integer", "Float", "Rational", "t", "lam"),
         ("lam", "self", "env", "t", "eps"), ("E", "I", "N", "S", "Q"),
         ("nan", "oo", "zoo", "t", "lam"), ("变量", "частота", "параметр", "時", "λ")]


def named(x, omega, mu, t, lam, source):
    """x'' + x + μ x³ + λ x² = 0 in other names, as a text or in SymPy."""
    if source == "SymPy":
        time, f, w, m = sp.Symbol(t), sp.Function(x), sp.Symbol(omega), sp.Symbol(mu)
        equation = f(time).diff(time, 2) + f(time) + m * f(time)**3 + sp.Symbol(lam) * f(time)**2
    else:
        time, f, w, m = t, x, omega, mu
        equation = f"{x}'' + {x}({t}) + {mu}*{x}**3 + {lam}*{x}^2 = 0"
    return {"equations": equation, "frequency": w, "time": time,
            "unknowns": {f: fts.Field("cos", fixed=(1,)), w: fts.Scalar()}}, m


@pytest.mark.parametrize("source", ["text", "SymPy"])
@pytest.mark.parametrize("names", NAMES, ids=lambda names: names[0])
def test_any_names(names, source, tmp_path):
    """Solved, saved, loaded, pickled, written: as with plain names."""
    plain = fts.solve(oscillator("x'' + x + mu*x**3 + lam*x**2", parameters=("mu",)), 4)
    options, mu = named(*names, source)
    sol = fts.solve(fts.Equations(**options, parameters=(mu,), lam=names[4]), 4)
    x, omega, mu, *_ = map(name_of, names)
    for mine, other in ((x, "x"), (omega, "omega")):
        assert sol.coefficients[mine] == plain.coefficients[other]
    assert sol.coefficient(omega, 2) == 3 * sp.Symbol(mu) / 8
    assert sol.evaluate(x, 0.3, lam=0.1, **{mu: 2}) == plain.evaluate("x", 0.3, lam=0.1, mu=2)
    assert sol.evaluate(omega, lam=0.1, dps=30, **{mu: 2}) == plain.evaluate(
        "omega", lam=0.1, dps=30, mu=2)
    sol.save(tmp_path / "s.json")
    for again in (fts.load(tmp_path / "s.json"), pickle.loads(pickle.dumps(sol))):
        assert again.coefficients == sol.coefficients
        assert again.problem.arguments() == sol.problem.arguments()
    assert sol.to_latex(x).count("=") == 1


@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
@pytest.mark.parametrize("names", NAMES, ids=lambda names: names[0])
def test_any_names_in_every_arithmetic(names, arithmetic, tmp_path):
    options, mu = named(*names, "text")
    sol = fts.solve(fts.Equations(**options, parameters={mu: 2}, lam=names[4]), 4, arithmetic)
    assert float(sol.coefficient(name_of(names[1]), 2)) == 0.75
    sol.save(tmp_path / "s.json")
    assert float(fts.load(tmp_path / "s.json").coefficient(name_of(names[1]), 2)) == 0.75


def test_greek_letters_in_latex():
    pendulum = fts.Equations("θ'' + sin(θ) = 0", {"θ": fts.Field("cos", fixed=(1,)),
                                                  "ω_1": fts.Scalar()}, frequency="ω_1")
    sol = fts.solve(pendulum, 3)
    assert sol.coefficient("ω_1", 2) == -sp.Rational(1, 16)
    assert sol.to_latex("ω_1", 2) == (
        r"{\omega}_{1} = 1 - \frac{1}{16} \lambda^{2} + \mathcal{O}(\lambda^{3})")
    assert sol.to_latex("θ", 1) == (
        r"{\theta}(t) = \lambda \cos {\omega}_{1} t + \mathcal{O}(\lambda^{2})")


@pytest.mark.parametrize("parameter", ["omega_0", "omega_1", "x_c0_0", "x_c1_1", "sqrt3", "c"])
def test_first_orders_know_no_names(parameter):
    """By hand: A(3 - 1) = p for x'' + 3x + x³ = pλ cos t; thirds of a period bring √3."""
    x = {"x": fts.Field("cos")}
    forced = fts.Equations(f"x'' + 3*x + x**3 = {parameter}*lam*cos(t)", x, parameters=(parameter,))
    assert fts.solve(forced, 3).coefficient("x", 1, 1) == sp.Symbol(parameter) / 2
    thirds = fts.Equations(
        f"x'' + x + {parameter}*(x(t - 2*pi/(3*omega))**3 + x(t + 2*pi/(3*omega))**3)",
        {"x": fts.Field("cos", modes="odd", powers="odd", fixed=(1,)),
         "omega": fts.Scalar("even")}, frequency="omega", parameters=(parameter,))
    assert fts.solve(thirds, 3).coefficient("x", 3, 3) == sp.Symbol(parameter) / 16


@pytest.mark.parametrize("changes, words", [
    ({"lam": "lambda"}, "a word of Python's own"), ({"time": "pi"}, "has a meaning in equations"),
    ({"parameters": ("exp",)}, "has a meaning in equations"), ({"parameters": ("x y",)}, "not a n"),
    ({"parameters": ("dps",)}, "could not be given to evaluate"),
    ({"parameters": ("lam",), "lam": "eps"}, "could not be given to evaluate"),
    ({"unknowns": {"µ": fts.Field(), "μ": fts.Scalar()}, "frequency": "μ"}, "μ is given twice"),
    ({"parameters": ("ω", "ω")}, "no equation contains"),
])
def test_names_that_cannot_be(changes, words):
    refused(lambda: oscillator("x'' + x + x**3", **changes), words)


def test_the_names_that_evaluate_takes():
    from ftseries.problem import _TAKEN
    arguments = inspect.signature(fts.Solution.evaluate).parameters.values()
    assert {a.name for a in arguments
            if a.kind not in (a.VAR_KEYWORD, a.VAR_POSITIONAL)} == _TAKEN


@pytest.mark.parametrize("attributes", [{"parameters": ("µ",)}, {"unknowns": {
    "ϕ": fts.Field("cos"), "omega": fts.Scalar()}}])
def test_a_class_writes_names_as_python_does(attributes):
    kind = type("Micro", (fts.CubicOscillator,), attributes)
    del fts.Problem.classes["Micro"]
    refused(lambda: fts.solve(kind(), 2), "Python writes the name")


def test_lambda_may_be_a_parameter():
    """λ is lam, unless something else is called so."""
    alias = oscillator("x'' + x + λ*x**2 + x**3", seed=SEED | {"x": "λ*cos(omega*t)"})
    assert alias.expressions == oscillator("x'' + x + lam*x**2 + x**3", seed=SEED).expressions
    other = oscillator("x'' + x + λ*x**3", parameters={"λ": 2})
    assert fts.solve(other, 2).coefficient("omega", 2) == sp.Rational(3, 4)
