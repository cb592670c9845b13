"""The first non-linear steps, solved automatically."""

from fractions import Fraction

import pytest
import sympy as sp

import ftseries as fts


def automatic(equations, choice=None, parameters=(), **unknowns):
    frequency = "omega" if isinstance(unknowns.get("omega"), fts.Scalar) else None
    return fts.Equations(equations, unknowns, frequency=frequency, choice=choice,
                         parameters=parameters)


COS = fts.Field("cos", fixed=(1,))
OMEGA = fts.Scalar()
SEEDS = [
    # the paper's (C7a), (C7b): x_0 = -1, amplitude 1, omega_0 = 2 sqrt 3
    ("x'**2 = 4*(x - 2)*(x - lam + 1)*(x + lam + 1)", {"x": fts.Field("cos"), "omega": OMEGA},
     {"x": "lam*cos(omega*t) - 1", "omega": "2*sqrt(3)"}),
    # van der Pol: the amplitude 2 of the limit cycle, found at order 3
    ("y'' + y = (lam**2 - y**2)*y'", {"y": fts.Field("both", fixed=((1, 1),)), "omega": OMEGA},
     {"y": "2*lam*cos(omega*t)", "omega": "1"}),
    # a damping of higher degree: 8^(1/4), found at order 5
    ("y'' + y = (lam**4 - y**4)*y'", {"y": fts.Field("both", fixed=((1, 1),)), "omega": OMEGA},
     {"y": "2**(3/4)*lam*cos(omega*t)", "omega": "1"}),
    # rest at 0 beside roots of x^4 - x + 1 and x^3 - x + 1
    ("x'' + x - x**2 + x**5 = 0", {"x": COS, "omega": OMEGA},
     {"x": "lam*cos(omega*t)", "omega": "1"}),
    ("x'' + x - x**2 + x**4 = 0", {"x": COS, "omega": OMEGA},
     {"x": "lam*cos(omega*t)", "omega": "1"}),
    # up to 27 states of rest, of which the one at 0 is taken
    (["x'' + x + y**3 - z**3 + x**2*y = 0", "y'' + 2*y - x**3 + z**2*y = 0",
      "z'' + 3*z + x*y*z + x**2 + y**3 = 0"],
     {"x": COS, "y": fts.Field("cos"), "z": fts.Field("cos"), "omega": OMEGA},
     {"x": "lam*cos(omega*t)", "y": "0", "z": "0", "omega": "1"}),
    # not polynomial: about rest at 0
    ("x'' + sin(x) = 0", {"x": COS, "omega": OMEGA}, {"x": "lam*cos(omega*t)", "omega": "1"}),
    # a translation does not oscillate
    (["x'' + x - y = 0", "y'' + y - x + x**3 = 0"],
     {"x": fts.Field("cos", modes="odd", fixed=(1,)), "y": fts.Field("cos", modes="odd"),
      "omega": OMEGA}, {"x": "lam*cos(omega*t)", "y": "-lam*cos(omega*t)", "omega": "sqrt(2)"}),
    # the equilibrium (1, 1) of Lotka and Volterra, about which both oscillate
    (["u' = u*(1 - v)", "v' = -v*(1 - u)"],
     {"u": fts.Field("both", fixed=(1,)), "v": fts.Field("both"), "omega": OMEGA},
     {"u": "lam*cos(omega*t) + 1", "v": "lam*sin(omega*t) + 1", "omega": "1"}),
    # a prescribed time dependence, in resonance with nothing: sign and size follow
    ("x'' + 2*x = lam*cos(2*t)", {"x": fts.Field("cos")}, {"x": "-lam*cos(2*t)/2"}),
    # Mathieu's equation of the paper: psi_1 = sin x, a_0 = 1
    ("psi'' = (-a + lam**2*cos(2*t))*psi",
     {"psi": fts.Field("sin", modes="odd", powers="odd", fixed=(1,)), "a": fts.Scalar("even")},
     {"psi": "lam*sin(t)", "a": "1"}),
]


@pytest.mark.parametrize("equations, unknowns, seed", SEEDS, ids=lambda v: str(v)[:30])
def test_a_seed_that_is_found(equations, unknowns, seed):
    frequency = "omega" if "omega" in unknowns else None
    problem = fts.Equations(equations, unknowns, frequency=frequency,
                            ahead=1 if "cos(2*t)" in seed.get("x", "") else 0)
    assert problem.seed_texts == seed


def test_two_solutions_are_shown_and_selectable():
    with pytest.raises(fts.InputError) as refusal:
        automatic("x'' - x + x**3 = 0", x=COS, omega=OMEGA)
    assert str(refusal.value) == (
        "the first steps have 2 solutions, select one of them: "
        "choice=0: x = lam*cos(omega*t) - 1, omega = sqrt(2); "
        "choice=1: x = lam*cos(omega*t) + 1, omega = sqrt(2)")
    left, right = (fts.solve(automatic("x'' - x + x**3 = 0", choice, x=COS, omega=OMEGA), 6)
                   for choice in (0, 1))
    for m in range(7):
        # x to -x turns one into the other, with the amplitude λ reversed
        assert right.coefficient("omega", m) == (-1)**m * left.coefficient("omega", m)
        for n in range(m + 1):
            assert right.coefficient("x", n, m) == -(-1)**m * left.coefficient("x", n, m)


@pytest.mark.parametrize("choice", [2, -1, "a", 0.5])
def test_a_choice_that_does_not_exist(choice):
    with pytest.raises(fts.InputError, match=f"choice={choice!r}: the number of solutions"):
        automatic("x'' - x + x**3 = 0", choice, x=COS, omega=OMEGA)


def test_two_normal_modes():
    """ω² = 1 and ω² = 3, the eigenvalues of the stiffness matrix [[2, -1], [-1, 2]]."""
    pair = ["x'' + 2*x - y + x**3 = 0", "y'' + 2*y - x + y**3 = 0"]
    unknowns = {"x": fts.Field("cos", modes="odd", fixed=(1,)), "y": fts.Field("cos", modes="odd"),
                "omega": OMEGA}
    seeds = [automatic(pair, choice, **unknowns).seed_texts for choice in (0, 1)]
    assert {(s["y"], s["omega"]) for s in seeds} == {
        ("lam*cos(omega*t)", "1"), ("-lam*cos(omega*t)", "sqrt(3)")}


def test_a_forcing_that_breaks_the_mirror_keeps_both_signs():
    """x″ + ω₀² x with cubic terms and a forcing at λ⁴: ±cos t are two motions, not one."""
    with pytest.raises(fts.InputError) as refusal:
        automatic("x'' + x + x**3 - lam**2*x = lam**4*cos(t)", x=fts.Field("cos"))
    assert "choice=0: x = -2*sqrt(3)*lam*cos(t)/3; choice=1: x = 2*sqrt(3)*lam*cos(t)/3" in str(
        refusal.value)


def test_a_parameter_stays_a_symbol():
    problem = automatic("x'' + x + mu*x**3 = 0", parameters=("mu",), x=COS, omega=OMEGA)
    assert problem.seed_texts == {"x": "lam*cos(omega*t)", "omega": "1"}
    assert fts.solve(problem, 4).coefficient("omega", 2) == 3 * sp.Symbol("mu") / 8


ODD = fts.Field("cos", modes="odd", powers="odd", fixed=(1,))
TURNED = fts.Field("both", fixed=((1, 1),))
DEPENDENT = [
    ("x'' + mu*x + x**3 = 0", {"x": COS, "omega": OMEGA}, "omega_0 would be sqrt\\(mu\\)"),
    ("x'' + mu*x + x**3 = lam*cos(t)", {"x": fts.Field("cos")}, "would be 1/\\(mu - 1\\)"),
    ("x'' + x + x**3 = mu*lam**3*cos(t)", {"x": fts.Field("cos")}, "would be .*mu\\*\\*\\(1/3\\)/"),
]


@pytest.mark.parametrize("equation, unknowns, message", DEPENDENT)
def test_a_parameter_that_needs_a_value(equation, unknowns, message):
    with pytest.raises(fts.ContradictionError, match=f"mu needs a value, because .* {message}"):
        automatic(equation, parameters=("mu",), **unknowns)


def test_the_strength_of_a_forcing_stays_a_symbol():
    """A forced motion follows its forcing: 2 A = mu at order 1, -6 A_3 + A³/4 = 0 at order 3."""
    problem = automatic("x'' + 3*x + x**3 = mu*lam*cos(t)", parameters=("mu",), x=fts.Field("cos"))
    sol, mu = fts.solve(problem, 3), sp.Symbol("mu")
    assert problem.seed_texts == {"x": "0"}
    assert (sol.coefficient("x", 1, 1), sol.coefficient("x", 3, 3)) == (mu / 2, mu**3 / 192)


REFUSED = [
    ("x'' + x + x**3 = 0", {"x": fts.Field("cos", modes="odd"), "omega": OMEGA},
     fts.UndeterminedError, "leave the coefficient of cos 1τ in x at order 1 of λ free"),
    ("x'' + x = lam*cos(t)", {"x": fts.Field("cos")}, fts.ContradictionError,
     "satisfy \\(1\\) at order 1 of λ: a resonance: the forcing has the frequency 1 of a free"),
    ("x'' + 4*x = lam**2*sin(2*t)", {"x": fts.Field("both")},
     fts.ContradictionError, "at order 2 of λ: a resonance: the forcing has the frequency 2"),
    ("x'' + 3*x + x**3 = lam*cos(t)", {"x": COS},
     fts.ContradictionError, "the forcing determines the amplitude, but 'fixed' of x"),
    ("x'' + x + x**3 = 0", {"x": COS},
     fts.ContradictionError, "at order 3 of λ: without an unknown frequency every motion"),
    ("x'' + 2*x + x**3 = 0", {"x": fts.Field("cos")},
     fts.ContradictionError, "only solutions at rest .*: without an unknown frequency"),
    ("x'' + x'/10 + x = 0", {"x": COS, "omega": OMEGA}, fts.ContradictionError,
     "at order 1 of λ: a damped free motion has no periodic solution: .* -0.05 ± 0.999i"),
    ("x'' + x'/10 + x + x**3 = 0", {"x": TURNED, "omega": OMEGA},
     fts.ContradictionError, "only solutions at rest .*: a damped free motion has no periodic"),
    ("x'' + x = x'", {"x": COS, "omega": OMEGA},
     fts.ContradictionError, "at order 1 of λ: .* unstable: motions near it grow .* 0.5 ± 0.866i"),
    ("x'' + x = (1 - x**4)*x'", {"x": TURNED, "omega": OMEGA},
     fts.ContradictionError, "scale the unknown so that λ, the size of the cycle, is in the eq"),
    ("x'' - x = 0", {"x": COS, "omega": OMEGA},
     fts.ContradictionError, "at order 1 of λ: .* x = 0 is a saddle, .* s = -1, 1, and none"),
    ("x'' + x**3 = 0", {"x": ODD, "omega": OMEGA},
     fts.ContradictionError, "at order 3 of λ: there is no linear force at the state of rest x ="),
    (["x' = 10*(y - x)", "y' = x*(28 - z) - y", "z' = x*y - 8*z/3"],
     {"x": fts.Field("both", fixed=(1,)), "y": fts.Field("both"), "z": fts.Field("both"),
      "omega": OMEGA}, fts.ContradictionError, "nothing oscillates near the 3 states of rest"),
    (["2*x'' + y''*cos(x - y) + y'**2*sin(x - y) + 2*sin(x) + x'/10 = 0",
      "y'' + x''*cos(x - y) - x'**2*sin(x - y) + sin(y) + y'/10 = 0"],
     {"x": TURNED, "y": fts.Field("both"), "omega": OMEGA},
     fts.ContradictionError, "a damped free motion has no periodic solution"),
    ("x'' + x + x**2 = 0", {"x": fts.Field("cos", modes="odd", fixed=(1,)), "omega": OMEGA},
     fts.ContradictionError, "at order 2 of λ: the ansatz lacks .*; give x modes='all'$"),
    ("x'' + x + x**2 = 0", {"x": ODD, "omega": fts.Scalar("even")},
     fts.ContradictionError, "the ansatz lacks .*; give x modes='all' and powers='all'$"),
    ("x'' + x'/10 + 3*x + x**3 = lam*cos(t)", {"x": fts.Field("cos")},
     fts.ContradictionError, "the ansatz lacks .*; give x series='both'$"),
    ("x'' - x + x**3 = 0", {"x": ODD, "omega": OMEGA},
     fts.ContradictionError, "the ansatz lacks .*; give x modes='all' and powers='all'$"),
    ("x'' + x + x(t - pi/(2*omega)) = 0", {"x": COS, "omega": OMEGA},
     fts.ContradictionError, "the ansatz may lack the symmetry or the Fourier orders"),
    ("x'' + x**2 + 1 = 0", {"x": COS, "omega": OMEGA},
     fts.ContradictionError, "at order 0 of λ: there is no state of rest in the ansatz"),
    ("x'' + x**6 - x - 1 = 0", {"x": COS, "omega": OMEGA}, fts.ContradictionError,
     "at order 0 of λ: the mean of x at order 0 of λ would be a root c of c\\*\\*6 - c - 1, with"),
    (["x'' + 3*x - y + x**3 = 0", "y'' + 4*y - x - z = 0", "z'' + 7*z - y = 0"],
     {"x": ODD, "y": fts.Field("cos", modes="odd"), "z": fts.Field("cos", modes="odd"),
      "omega": OMEGA}, fts.ContradictionError, "omega_0 would be a root c of -c\\*\\*6"),
    ("x'' + sqrt(x) = 0", {"x": COS, "omega": OMEGA}, fts.InputError,
     "\\(sqrt\\(x\\) is not polynomial, and no series begins with rest at x = 0\\); give a"),
    ("p'' + sin(p) + cos(p) = 0", {"p": COS, "omega": OMEGA}, fts.InputError,
     "\\(cos\\(p\\), sin\\(p\\) are not polynomial, .* rest at p = 0\\); give a seed for p, omega"),
    ("x'' + x + x**3 = 0", {"x": fts.Field("cos", fixed=(0, 1)), "omega": OMEGA},
     fts.InputError, "several amplitudes are fixed \\(x at 0, x at 1\\).* give a seed for x"),
]


@pytest.mark.parametrize("equation, unknowns, kind, message", REFUSED,
                         ids=lambda v: str(v)[:30])
def test_first_steps_that_are_refused(equation, unknowns, kind, message):
    with pytest.raises(kind, match=message):
        automatic(equation, **unknowns)


@pytest.mark.parametrize("a", [1, 2, Fraction(1, 2), Fraction(7, 3)])
def test_a_motion_is_born_in_a_hopf_bifurcation(a):
    """The Brusselator; λ² by the amplitude equation in Kuramoto's book of 1984."""
    both, even = fts.Field("both"), fts.Scalar("even")
    problem = fts.Equations(
        [f"x' = {a} - (b + 1)*x + x**2*y", "y' = b*x - x**2*y"], frequency="omega",
        unknowns={"x": fts.Field("both", fixed=(1,)), "y": both, "b": even, "omega": even})
    solution, a = fts.solve(problem, 2), sp.Rational(a)
    assert [solution.coefficient("b", m) for m in (0, 2)] == [1 + a**2, (2 + a**2) / (4 * a**2)]
    assert [solution.coefficient("omega", m) for m in (0, 2)] == [
        a, -(4 - 7 * a**2 + 4 * a**4) / (24 * a**3)]


def test_a_parameter_that_two_orders_find_together():
    """Rest leaves mu free; the first order says where it oscillates. The motion is a circle."""
    odd, even = {"modes": "odd"}, fts.Scalar("even")
    problem = fts.Equations(
        ["x' = mu*x - y - x*(x**2 + y**2)", "y' = x + mu*y - y*(x**2 + y**2)"], frequency="omega",
        unknowns={"x": fts.Field("both", **odd, fixed=(1,)), "y": fts.Field("both", **odd),
                  "mu": even, "omega": even})
    solution = fts.solve(problem, 6)
    assert [solution.coefficient("mu", m) for m in (0, 2, 4, 6)] == [0, 1, 0, 0]
    assert [solution.coefficient("omega", m) for m in (0, 2, 4, 6)] == [1, 0, 0, 0]
