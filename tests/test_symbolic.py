"""Problems from SymPy equations and from text."""

import pickle

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

import ftseries as fts
from ftseries.reading import Language

T, LAM, OMEGA, MU = sp.symbols("t lam omega mu")
X = sp.Function("x")
OSCILLATOR = {"frequency": "omega",
              "unknowns": {"x": fts.Field("cos", fixed=(1,)), "omega": fts.Scalar()}}


def oscillator(equation, **changes):
    return fts.Equations(equation, **OSCILLATOR | changes)


# --- the paper's three problems ---------------------------------------------------------------

SEED = {"x": "lam*cos(omega*t)", "omega": 1}

CUBIC = ["x'**2 = 4*(x - 2)*(x - lam + 1)*(x + lam + 1)",
         sp.Eq(X(T).diff(T)**2, 4 * (X(T) - 2) * (X(T) - LAM + 1) * (X(T) + LAM + 1))]


@pytest.mark.parametrize("equation", CUBIC)
@pytest.mark.parametrize("seed", [None, {"x": "-1 + lam*cos(omega*t)", "omega": "2*sqrt(3)"}])
def test_c3_gives_the_coefficients_of_the_built_in_oscillator(equation, seed):
    mine = fts.solve(oscillator(equation, seed=seed, unknowns={
        "x": fts.Field("cos"), "omega": fts.Scalar()}), order=10)
    built_in = fts.solve(fts.CubicOscillator(a=1), order=10)
    for m in range(11):
        assert mine.coefficient("omega", m) == built_in.coefficient("omega", m)
        for n in range(m + 1):
            assert mine.coefficient("x", n, m) == built_in.coefficient("x", n, m)


@pytest.mark.parametrize("seed", [None, {"psi": "lam*sin(t)", "a": 1}])
def test_m1_gives_the_coefficients_of_the_built_in_equation(seed):
    mine = fts.Equations(
        "psi'' = (-a + lam**2*cos(2*t) + lam**4*mu*cos(4*t))*psi", parameters=("mu",), seed=seed,
        unknowns={"psi": fts.Field("sin", modes="odd", powers="odd", fixed=(1,)),
                  "a": fts.Scalar("even")})
    built_in = fts.solve(fts.GeneralizedMathieu(), order=20)
    assert fts.solve(mine, order=20).coefficients == built_in.coefficients


E3 = {"(E3a)": "r'' = r*phi'^2 - 2/r^2 + cos(phi - phi(t + 2*pi/3))/r(t + 2*pi/3)^2"
               " + cos(phi - phi(t - 2*pi/3))/r(t - 2*pi/3)^2",
      "(E3b)": "phi'' = (-2*r'*phi' - sin(phi - phi(t + 2*pi/3))/r(t + 2*pi/3)^2"
               " - sin(phi - phi(t - 2*pi/3))/r(t - 2*pi/3)^2)/r"}


@pytest.fixture(scope="module")
def eight():
    return fts.Equations(E3, seed={"r": "3**(1/3)", "phi": "lam*cos(t)"}, unknowns={
        "r": fts.Field("cos", modes="even", powers="even"),
        "phi": fts.Field("cos", modes="odd", powers="odd", fixed=(1,))})


def test_e3_typed_as_printed_gives_the_coefficients_of_the_built_in_eight(eight):
    assert fts.solve(eight, 8).coefficients == fts.solve(fts.FigureEight(), 8).coefficients


def test_shifts_by_thirds_with_a_parameter():
    """cos³(τ - a) + cos³(τ + a) = -¾ cos τ + ½ cos 3τ for a = 2π/3: by hand to order 3."""
    sol = fts.solve(fts.Equations(
        "x'' + x + mu*(x(t - 2*pi/(3*omega))**3 + x(t + 2*pi/(3*omega))**3)",
        {"x": fts.Field("cos", modes="odd", powers="odd", fixed=(1,)),
         "omega": fts.Scalar("even")}, frequency="omega", parameters=("mu",)), 4)
    mu = sp.Symbol("mu")
    assert sol.coefficient("omega", 2) == -3 * mu / 8
    assert sol.coefficient("x", 3, 3) == mu / 16


def test_a_choreography_in_floats(eight):
    mine, built_in = (fts.solve(p, 20, arithmetic="float") for p in (eight, fts.FigureEight()))
    for n in range(0, 21, 2):
        # cancellation between the three shifts costs a few digits of the 16
        assert mine.coefficient("r", n, 20) == pytest.approx(built_in.coefficient("r", n, 20),
                                                             rel=1e-9)


# --- no term is dropped -----------------------------------------------------------------------

def residual(problem, order, lam, time=0.7, **values):
    """The equations at the truncated series, evaluated by SymPy and mpmath with 60 digits."""
    sol = fts.solve(problem, order=order)
    numbers = {sp.Symbol(k): v for k, v in values.items()}
    omega = sum((sol.coefficient(problem.frequency, m) * LAM**m for m in range(order + 1)),
                sp.S.Zero) if problem.frequency else sp.S.One
    series = {sp.Symbol(problem.frequency): omega} if problem.frequency else {}
    for name, unknown in problem.unknowns.items():
        total = sp.S.Zero
        for m in range(order + 1):
            if isinstance(unknown, fts.Scalar):
                total += sol.coefficient(name, m) * LAM**m
                continue
            for n in range(m + problem.ahead + 1):
                total += sol.coefficient(name, n, m, sine=False) * LAM**m * sp.cos(n * omega * T)
                total += sol.coefficient(name, n, m, sine=True) * LAM**m * sp.sin(n * omega * T)
        series[sp.Symbol(name) if isinstance(unknown, fts.Scalar) else name] = total
    worst = 0
    for e in problem.expressions.values():
        e = e.subs({s: v for s, v in series.items() if isinstance(s, sp.Symbol)})
        for name in problem.language.fields:
            e = e.replace(sp.Function(name), lambda at, u=series[name]: u.subs(T, at))
        e = e.doit().subs(numbers)
        with mpmath.workdps(60):
            worst = max(worst, abs(sp.lambdify((T, LAM), e, "mpmath")(
                mpmath.mpf(time), mpmath.mpf(lam))))
    return worst


def assert_solved(problem, order=6, **values):
    """The residual falls as λ^(order + 1): by 1e4^(order + 1) from λ = 1e-2 to λ = 1e-6.

    (A dropped term of order k ≤ 6 would stop that at λ^k.)
    """
    coarse, fine = (residual(problem, order, lam, **values) for lam in ("1e-2", "1e-6"))
    assert fine <= 10 * coarse * mpmath.mpf(10) ** (-4 * (order + 1)) + mpmath.mpf(10) ** -55


SOLVED = {
    "pendulum": lambda: oscillator("x'' + sin(x) = 0", unknowns={
        "x": fts.Field("cos", modes="odd", fixed=(1,)), "omega": fts.Scalar()}),
    "asymmetric": lambda: oscillator("x'' + x + x**2 = 0"),
    "exponential": lambda: oscillator("x'' + exp(x) - 1 = 0", seed=SEED),
    "quotient": lambda: oscillator("x'' + x/(1 + x**2) = 0", seed=SEED),
    "root": lambda: oscillator("x'' + x*(1 - x')**(-3/2) = 0", unknowns={
        "x": fts.Field("both", fixed=(1,)), "omega": fts.Scalar()},
        seed=SEED),
    "negative base": lambda: oscillator("x'' + x*(-4 - x)**2*(-(x - 1))**(1/2) = 0",
                                seed={"x": "lam*cos(omega*t)", "omega": 4}),
    "surd unit": lambda: oscillator("x'' - x + x**3 = 0", choice=1),
    "surd frequency": lambda: oscillator("x'' + 3*x + x**3 = 0"),
    "decimals": lambda: oscillator(X(T).diff(T, 2) + X(T) + 0.1 * X(T)**3 + 0.25 * X(T)**2),
    "parameter": lambda: oscillator("x'' + x + mu*x**3 = 0", parameters=("mu",)),
    "powers of λ": lambda: oscillator("x'' + x + (lam - 3*lam**2)*x**2 + lam*x**3 = 0"),
    "forced": lambda: fts.Equations("x'' + 4*x + x**3 = lam*cos(t)", {"x": fts.Field("cos")}),
    "forced and damped": lambda: fts.Equations(
        "x'' + x'/10 + 4*x + x**3 = lam*cos(t) + lam**2*sin(2*t)", {"x": fts.Field("both")}),
    "forced inside": lambda: fts.Equations(
        "x'' + 3*x = lam*exp(lam*cos(t))*(1 + x)", {"x": fts.Field("cos")}, seed={"x": "lam/3"}),
    "forced ahead": lambda: fts.Equations(
        "x'' + 2*x = lam*cos(3*t)", {"x": fts.Field("cos")}, ahead=2),
    "van der Pol": lambda: oscillator("x'' + x = (lam**2 - x**2)*x'", unknowns={
        "x": fts.Field("both", fixed=((1, 1),)), "omega": fts.Scalar()}),
    "Lotka-Volterra": lambda: fts.Equations(
        ["u' = u*(1 - v)", "v' = -v*(1 - u)"], frequency="omega", unknowns={
            "u": fts.Field("both", fixed=(1,)), "v": fts.Field("both"), "omega": fts.Scalar()}),
    "half a period later": lambda: oscillator(
        "x'' + x + x(t - pi/omega)**2 - x''(t + pi/omega)*x**2", choice=1),
    "both amplitudes irrational": lambda: oscillator("x'' - 2*x + x**3 = 0", choice=1),
    "forced at resonance": lambda: fts.Equations(
        "x'' + x + x**3 = lam**3*cos(t)", {"x": fts.Field("cos")}),
    "forced at resonance, later": lambda: fts.Equations(
        "x'' + x + x**3 - lam**2*x = lam**4*cos(t)", {"x": fts.Field("cos")}, choice=1),
    "forced late": lambda: fts.Equations("x'' + 3*x + x**3 = lam**2*cos(t)",
                                         {"x": fts.Field("cos")}),
    "strength of forcing": lambda: fts.Equations(
        "x'' + 3*x + x**3 = mu*lam*cos(t)", {"x": fts.Field("cos")}, parameters=("mu",)),
    "tangent": lambda: oscillator("x'' + sin(x)/cos(x) = 0"),
    "hyperbolic tangent": lambda: oscillator("x'' + (exp(2*x) - 1)/(exp(2*x) + 1) = 0"),
    "Morse": lambda: oscillator("x'' + exp(-x) - exp(-2*x) = 0"),
    "Kepler": lambda: oscillator("x'' = 1/(1 + x)**3 - 1/(1 + x)**2"),
    "square root of 4": lambda: oscillator("x'' + 2*sqrt(2 + x)*(x - 2) = 0",
                                   seed={"x": "2 + lam*cos(omega*t)", "omega": 2}),
}


@pytest.mark.parametrize("name", SOLVED)
def test_the_residual_vanishes(name):
    problem = SOLVED[name]()
    assert_solved(problem, **{"mu": sp.Rational(2, 7)} if problem.parameters else {})


def test_every_term_counts():
    """The test above sees a dropped term: here the series of another equation is put in."""
    problem = oscillator("x'' + x + x**3 = 0")
    problem.expressions = {"(1)": problem.expressions["(1)"] + X(T)**5}
    with pytest.raises(AssertionError):
        assert_solved(problem)


terms = st.lists(st.tuples(st.fractions(-3, 3, max_denominator=5), st.integers(0, 2),
                           st.integers(0, 3), st.sampled_from([0, 2])).filter(
                               lambda q: q[1] + q[2] + q[3] >= 2 and q[2] + q[3] >= 1),
                 min_size=1, max_size=5)


@settings(max_examples=8)
@given(terms)
def test_no_polynomial_term_is_dropped(terms):
    x = X(T)
    e = x.diff(T, 2) + x + sum(sp.Rational(c.numerator, c.denominator) * LAM**i * x**j
                               * x.diff(T)**k for c, i, j, k in terms)
    assert_solved(oscillator(e), order=5)


@pytest.mark.parametrize("lam", [0.05, 0.1])
def test_a_forced_motion_is_the_one_that_integration_finds(lam):
    sol = fts.solve(SOLVED["forced and damped"](), order=24, arithmetic="float")
    at = sol.evaluate("x", [0.0, 1e-5, -1e-5, 2.0], lam=lam)
    orbit = solve_ivp(lambda t, y: [y[1], lam * np.cos(t) + lam**2 * np.sin(2 * t) - y[1] / 10
                                    - 4 * y[0] - y[0]**3], (0, 2),
                      [at[0], (at[1] - at[2]) / 2e-5], rtol=1e-11, atol=1e-12)
    assert orbit.y[0, -1] == pytest.approx(at[3], abs=1e-9)          # the difference quotient's


# --- equivalent forms -------------------------------------------------------------------------

EQUIVALENT = ["x'' + x + x**3 = 0", "x''+x+x^3", "x''(t) = -x(t) - x(t)**3", "-x - x*x*x = x''",
              "diff(x, t, 2) + x + x**3 = 0", "2*x'' + 2*x + 2*x**3 = 0", "x'' = -x*(1 + x^2)",
              sp.Eq(X(T).diff(T, 2), -X(T) - X(T)**3), X(T).diff(T, 2) + X(T) + X(T)**3,
              sp.Function("x", real=True)(T).diff(T, 2) + sp.Function("x", real=True)(T) + X(T)**3]


@pytest.mark.parametrize("equation", EQUIVALENT, ids=map(str, range(10)))
def test_forms_of_one_equation(equation):
    expected = fts.solve(oscillator(EQUIVALENT[0]), order=6).coefficients
    assert fts.solve(oscillator(equation), order=6).coefficients == expected


def test_other_names_for_time_and_lambda():
    s, eps, q, w = sp.symbols("s epsilon q w", positive=True)
    f = sp.Function("f")
    mine = fts.Equations(f(s).diff(s, 2) + f(s) + f(s)**3, time=s, lam=eps, frequency=w,
                         unknowns={f: fts.Field("cos", fixed=(1,)), w: fts.Scalar()},
                         seed={f: eps * sp.cos(w * s), w: 1})
    other = fts.solve(oscillator("x'' + x + x**3"), order=6)
    assert fts.solve(mine, order=6).coefficients["f"] == other.coefficients["x"]


def test_a_value_for_a_parameter():
    symbol = fts.solve(oscillator("x'' + x + mu*x**3", parameters=("mu",)), order=6)
    number = fts.solve(oscillator("x'' + x + mu*x**3", parameters={"mu": 0.5}), order=6)
    for m in range(0, 7, 2):
        assert symbol.coefficient("omega", m).subs(MU, sp.Rational(1, 2)) == number.coefficient(
            "omega", m)


@pytest.mark.parametrize("name", sorted(SOLVED.keys() - {"root"}))
def test_a_problem_survives_saving_and_pickling(name, tmp_path):
    problem = SOLVED[name]()
    sol = fts.solve(problem, order=4)
    sol.save(tmp_path / "s.json")
    for again in (fts.load(tmp_path / "s.json"), pickle.loads(pickle.dumps(sol)),
                  fts.load(tmp_path / "s.json", problem=problem)):
        assert again.coefficients == sol.coefficients
        assert fts.solve(again.problem, order=4).coefficients == sol.coefficients


def test_what_is_written_is_read_again():
    language = Language("t", "lam", ("x", "y"), ("omega",))
    e = language.equation("x''*y'(t + 2*pi/(3*omega)) = sin(x)*exp(-y)/2 + x(t - pi)^(3/2)")
    assert sp.simplify(language.equation(language.written(e)) - e) == 0


# --- refusals ---------------------------------------------------------------------------------

READING = [
    ("x'' + xx = 0", "\"x'' \\+ xx = 0\" contains xx, which is neither an unknown, a parameter"),
    ("x'' + tanh(x) = 0", "contains the function tanh, which is not known here; .*exp\\(2\\*x\\)"),
    ("x'' + tan(x) = 0", "the function tan, .* sin and cos: write sin\\(x\\)/cos\\(x\\)"),
    ("x'' + log(1 + x) = 0", "the function log, .* take y = log\\(1 \\+ x\\) as the unknown"),
    ("x'' + x + abs(x) = 0", "the function abs, .* has a corner at 0"),
    ("x'' + gamma(x) = 0", "the function gamma, .* rational powers, sqrt, exp, sin and cos$"),
    ("y'' + x + x**3 = 0", "contains y'', but y is not declared as a Field"),
    ("xx'' + x = 0", "contains xx'', but xx is not declared as a Field"),
    ("omega' + x = 0", "contains omega', but omega is not declared as a Field"),
    ("x'' + lambda*x = 0", "'lambda' in .*; λ is written lam"),
    ("x'' + x³ = 0", "'³' in .*; write powers with \\*\\*"),
    ("x″ + x = 0", "'″' in .*; write derivatives with the straight '"),
    ("x'' − x = 0", "'−' in .*; write the sign -"),
    ("x'' + 2·x = 0", "'·' in .*; write products with \\*"),
    ("x'' + sin x = 0", "'sin x' in .*; write functions with brackets"),
    ("x'' + omega x = 0", "'omega x' in .*; write products with \\*"),
    ("x'' + x)*2 = 0", "a bracket that is not closed"),
    ("x'' + * x = 0", "is not an expression; write products with"),
    ("x'' + x = ", "a side is empty; write an expression there"),
    (["x'' + x + x**3 = 0", "x(0) = 1"], "contains x\\(0\\), .* initial conditions are not given"),
    ("x'' + mu*x = 0", "contains mu, which is neither .* declare it or correct it"),
    ("x'' + 2x = 0", "'2x' in \"x'' \\+ 2x\"; write products with"),
    ("x'' = x = 0", "more than one '='"),
    ("x'' + x(1 - x) = 0", "contains x\\(1 - x\\), but x is a function of the time t"),
    ("x'' + x'(0) = 0", "contains x\\(0\\), but x is a function of the time t"),
    ("x'' + x(t = 0", "a bracket that is not closed"),
    ("x'' + omega(t) + x = 0", "calls omega, which is not a function of time"),
    ("x'' + sin*x = 0", "cannot be read; use numbers, names"),
    ("x'' + x + 'abc'", "cannot be read"),
    ("x'' + sin(x, 2)", "cannot be read"),
    ("", "'' cannot be read: a side is empty"),
    (None, "None is not an equation; give a SymPy Eq"),
    (sp.true, "True is not an equation"),
    (object, "is not an equation"),
]
TRANSLATING = [
    ("x'' + x**x = 0", "contains x\\*\\*x, which has no Fourier-Taylor series here"),
    (X(T).diff(T, 2) + sp.tanh(X(T)), "contains tanh\\(x\\), which has no Fourier-Taylor series"),
    (X(T).diff(T, 2) + sp.Abs(X(T)), "contains Abs\\(x\\), which has no"),
    (X(T).diff(T, 2) + MU * X(T), "contains mu, which is neither .* give it a value"),
    (X(T).diff(T, 2) + sp.Symbol("x"), "the bare symbol x; write x\\(t\\)"),
    (X(T).diff(T, 2) + sp.Function("y")(T), "y is not declared as a Field"),
    (X(T).diff(T, 2) + X(LAM), "in x\\(lam\\) the time differs from t by lam - t"),
    (X(T).diff(T, LAM) + X(T).diff(T, 3), "Derivative\\(x\\(t\\), \\(t, 3\\)\\): derivatives up"),
    ("x''' + x = 0", "derivatives up to the second are known; write the equation as a system"),
    ("x'' + x(t - 1) = 0", "in x\\(t - 1\\) the time differs from t by -1"),
    ("x'' + x(2*t) = 0", "the time differs from t by t"),
    ("x'' + t*x = 0", "contains the time t outside of cos and sin"),
    ("x'' + x = lam*cos(t)", "contains cos\\(t\\), which does not have the period"),
    ("x'' + x = lam*cos(omega*t - 1)", "contains cos\\(omega\\*t - 1\\), whose phase is not zero"),
    ("x'' + x = lam*sin(omega*t + x)", "contains the time t outside .* addition theorem"),
    ("x'' + x + sqrt(2)*x**3 = 0", "the term .* differs from .* not rational; choose other units"),
    ("x'' + sin(sqrt(2)*x) = 0", "the argument of sin\\(sqrt\\(2\\)\\*x\\) has the factor sqrt"),
    ("x'' + x + x/0 = 0", "the number zoo; it must be finite and real"),
    (X(T).diff(T, 2) + sp.I * X(T), "the number I; it must be finite and real"),
    ("x'' + x = lam*cos(3*omega*t)", "the term -lam\\*cos\\(3\\*omega\\*t\\) brings a Fourier"),
    ("x'' + x + sqrt(1 + lam*cos(2*omega*t))*x", "brings a Fourier order n before"),
    ("x'' + x + x**3 = lam**9*cos(20*omega*t)", "the term .* brings a Fourier order n before"),
    ("0", "no equation contains x; correct"),
    ("x - x + lam = 0", "no equation contains x"),
    (["x'' + x", "x' - 1", "x"], "equations: 3, fields: 1 \\(x\\), scalars: 1; give one equation"),
    ([], "equations: 0, fields: 1"),
    (["x'' + x", "lam = 0"], "equation \\(2\\), lam = 0, contains no unknown"),
]


@pytest.mark.parametrize("equation, message", READING + TRANSLATING,
                         ids=lambda v: v[:40] if isinstance(v, str) else None)
def test_an_equation_that_is_refused(equation, message):
    with pytest.raises(fts.InputError, match=message) as refusal:
        oscillator(equation)
    assert "\n" not in str(refusal.value)


DECLARATIONS = [
    ({"lam": "lambda"}, "'lambda' is a word of Python's own; choose another name, such as 'lam'"),
    ({"lam": "x"}, "x is declared twice"),
    ({"time": "sin"}, "'sin' has a meaning in equations already"),
    ({"time": 3}, "3 is not a name; give a SymPy symbol"),
    ({"frequency": "w"}, "frequency='w' of Equations is not one of its unknown scalars"),
    ({"unknowns": ["x"]}, "unknowns=\\['x'\\]: give a dict"),
    ({"unknowns": {"x": 3, "omega": fts.Scalar()}}, "the unknown x is 3; declare it as a Field"),
    ({"parameters": "mu"}, "parameters='mu': give a tuple of names"),
    ({"parameters": {"mu": "a"}}, "the parameter mu has the value 'a', which is not a rational"),
    ({"ahead": -1}, "ahead=-1: give a whole number of at least 0"),
    ({"choice": 1}, "choice=1: the number of solutions of the first steps is 1"),
    ({"seed": SEED, "choice": 0}, "choice=0 selects one of the first steps .* where a seed is"),
    ({"seed": "x"}, "seed='x': give a dict"),
    ({"seed": SEED | {"y": 1}}, "the seed names y, which is not an unknown; they are x, omega"),
    ({"seed": SEED | {"x": "lam*cos(t)"}}, "the term lam\\*cos\\(t\\); its terms are number \\*"),
    ({"seed": SEED | {"x": "cos(omega*t)/lam"}}, "has the term cos\\(omega\\*t\\)/lam"),
    ({"seed": SEED | {"omega": "lam*cos(omega*t)"}}, "the seed of omega has the term"),
    ({"seed": SEED | {"x": "sqrt(2) + lam*cos(omega*t) + sqrt(5)*lam**2"}},
     "the number 1 beside sqrt\\(2\\)"),
    *(({"parameters": {name: 2}}, f"{name} is declared twice") for name in ("lam", "omega", "t")),
]


@pytest.mark.parametrize("changes, message", DECLARATIONS, ids=lambda v: str(v)[:40])
def test_a_declaration_that_is_refused(changes, message):
    with pytest.raises(fts.InputError, match=message):
        oscillator("x'' + x + x**3 = 0", **changes)


@pytest.mark.parametrize("equation, term, why", [
    ("x'' + x + sqrt(x) = 0", "sqrt\\(x\\)", "vanishes at λ = 0"),
    ("x'' + x + 1/x = 0", "1/x", "vanishes at λ = 0"),
    ("x'' + exp(x - 1) = 0", "exp\\(x - 1\\)", "zero at λ = 0"),
    ("x'' + x + sin(x/lam) = 0", "1/lam", "vanishes at λ = 0"),
])
def test_a_term_that_is_not_analytic_is_named(equation, term, why):
    with pytest.raises(fts.NonAnalyticError, match=f"equation \\(1\\), in {term}: .*{why}"):
        oscillator(equation, seed=SEED)


def test_a_root_that_is_not_rational_is_named():
    with pytest.raises(fts.InputError, match="in sqrt\\(x \\+ 2\\): .*is not rational"):
        oscillator("x'' + x*sqrt(2 + x) = 0", seed=SEED)


# what is wrong: equation, options of Equations, options of solve, what is quoted, the way out
BAD_INPUT = {
    "a typo in a symbol": ("x'' + omga**2*x = 0", {}, {}, "omga", "declare it or correct it"),
    "a typo in SymPy": (X(T).diff(T, 2) + sp.Symbol("lamb") * X(T), {}, {}, "lamb", "declare it"),
    "an unknown function": ("x'' + sinh(x) = 0", {}, {}, "sinh", "write (exp(x)"),
    "an unknown SymPy function": (X(T).diff(T, 2) + sp.gamma(X(T)), {}, {}, "gamma(x)", "only"),
    "too few equations": ("x'' + y = 0", {"frequency": None, "unknowns": {
        "x": fts.Field("cos"), "y": fts.Field("cos")}}, {}, "(x, y)", "give one equation"),
    "too many equations": (["x'' + x", "x' - 1", "x"], {}, {}, "equations: 3", "give one equation"),
    "no value in floats": ("x'' + x + mu*x**3 = 0", {"parameters": ("mu",)},
                           {"arithmetic": "float"}, "mu", "give it a value"),
    "no value in balls": ("x'' + x + mu*x**3 = 0", {"parameters": ("mu",)},
                          {"arithmetic": "ball"}, "mu", "give it a value"),
    "a negative order": ("x'' + x + x**3 = 0", {}, {"order": -2}, "order=-2", "at least 0"),
    "half an order": ("x'' + x + x**3 = 0", {}, {"order": 1.5}, "order=1.5", "whole number"),
    "an order in words": ("x'' + x + x**3 = 0", {}, {"order": "six"}, "order='six'", "whole"),
}


@pytest.mark.parametrize("what", BAD_INPUT)
def test_bad_input_gets_one_sentence_that_quotes_it_and_names_the_way_out(what):
    equation, changes, options, quoted, way_out = BAD_INPUT[what]
    with pytest.raises(fts.InputError) as refusal:
        fts.solve(oscillator(equation, **changes), **{"order": 4} | options)
    sentence = str(refusal.value)
    assert quoted in sentence and way_out in sentence
    assert "\n" not in sentence and ". " not in sentence and len(sentence) < 300


@pytest.mark.parametrize("equation, seed, message", [
    ("x'' + x + x**3 = lam**2*cos(omega*t)", SEED | {"omega": 2}, "has no solution at order 1"),
    ("x'' + x = x'", SEED, "has no solution at order 1 of λ, mode sin"),
])
def test_a_contradiction_with_the_seed_names_equation_order_and_mode(equation, seed, message):
    with pytest.raises(fts.ContradictionError, match=f"equation \\(1\\) {message}"):
        fts.solve(oscillator(equation, seed=seed), order=4)


def test_a_free_amplitude_is_named():
    problem = oscillator("x'' + x + x**3 = 0", seed=SEED, unknowns={
        "x": fts.Field("cos", modes="odd"), "omega": fts.Scalar()})
    with pytest.raises(fts.UndeterminedError, match="λ has no concrete meaning yet"):
        fts.solve(problem, order=6)


# --- what is left ---------------------------------------------------------------------------------

def test_equations_are_shown_as_they_are_read():
    assert repr(oscillator("x'' = -x - x^3")) == "Equations(x**3 + x + x'' = 0)"


def test_a_language_without_fields():
    assert Language(time="t", lam="lam", fields=()).expression("2*lam^2") == 2 * LAM**2


@pytest.mark.parametrize("value", [object(), "1 +", [1]])
def test_a_parameter_that_is_no_number(value):
    with pytest.raises(fts.InputError, match="the parameter c has the value"):
        oscillator("x'' + x + c*x**3", parameters={"c": value})


def test_a_derivative_by_something_else():
    s = sp.Symbol("s")
    with pytest.raises(fts.InputError, match="not a derivative by t"):
        oscillator(sp.Derivative(X(T, s), s) + X(T))


@pytest.mark.parametrize("value, exact", [
    (0.1, "1/10"), (1 / 3, "0.3333333333333333"), (2**0.5, "1.4142135623730951"),
    (0.30000000000000004, "0.30000000000000004"), (123456789.12345679, "123456789.12345679"),
    ("0.12345678901234567", "0.12345678901234567"), (np.float64(0.1), "1/10")])
def test_a_float_is_its_shortest_decimal(value, exact):
    """As a parameter, and in a SymPy expression."""
    given = oscillator("x'' + x + mu*x**3", parameters={"mu": value})
    assert given.expressions["(1)"].coeff(X(T)**3) == sp.Rational(exact)
    if isinstance(value, float):
        inside = oscillator(X(T).diff(T, 2) + X(T) + sp.sympify(float(value)) * X(T)**3)
        assert inside.expressions == given.expressions


def test_a_fraction_is_a_parameter():
    given = oscillator("x'' + x + mu*x**3", parameters={"mu": sp.Rational(1, 3)})
    assert given.expressions["(1)"].coeff(X(T)**3) == sp.Rational(1, 3)


@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
def test_an_irrational_amplitude_at_resonance(arithmetic):
    """x'' + x + x³ = λ³ cos t: the amplitude (4/3)^(1/3) λ makes the unit of λ; by integration."""
    problem = SOLVED["forced at resonance"]()
    assert problem.lam_scale == sp.cbrt(6) / 2
    sol, lam = fts.solve(problem, 20, arithmetic=arithmetic), 0.3
    assert float(sol.coefficient("x", 1, 1)) == pytest.approx((4 / 3)**(1 / 3), rel=1e-15)
    start = sol.evaluate("x", 0.0, lam=lam)
    orbit = solve_ivp(lambda t, y: [y[1], lam**3 * np.cos(t) - y[0] - y[0]**3], (0, 2 * np.pi),
                      [start, 0], rtol=1e-12, atol=1e-13)
    assert orbit.y[:, -1] == pytest.approx([start, 0], abs=1e-10)     # the integrator's


PAIR = ["x'' + 3*x - 2*y + x**3 = 0", "y'' + 5*y - 2*x + y**3 = 0"]
PAIR_UNKNOWNS = {"x": fts.Field("cos", modes="odd", fixed=(1,)),
                 "y": fts.Field("cos", modes="odd"), "omega": fts.Scalar()}


@pytest.mark.parametrize("choice", [None, 0, 1])
def test_an_irrational_mode_shape_is_refused_at_the_choice(choice):
    with pytest.raises(fts.InputError, match="because the ratio of the amplitudes of y and x, .*"
                       "sqrt\\(5\\).*, is irrational; take normal coordinates as unknowns"):
        oscillator(PAIR, unknowns=PAIR_UNKNOWNS, choice=choice)


def test_an_irrational_choice_is_marked():
    """The shapes are 1 and -1 about rest at 0, and irrational about rest at (-3/2, -3/4)."""
    with pytest.raises(fts.InputError) as refusal:
        oscillator(["x'' + 2*x - y + x**2 = 0", "y'' + 2*y - x = 0"], unknowns={
            "x": fts.Field("cos", fixed=(1,)), "y": fts.Field("cos"), "omega": fts.Scalar()})
    offers = str(refusal.value).partition(": ")[2].split("; ")
    assert [" (with irrational coefficients)" in offer for offer in offers] == [
        " - 3/2" in offer for offer in offers] == [False, True, False]
