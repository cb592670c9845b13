"""Coordinates that are settled orders late: closed forms, and values found without the package."""

import pytest
import sympy as sp

import ftseries as fts
from ftseries import Field, Scalar

LAM = sp.Symbol("lam")
CYCLE = {"x": Field("both", modes="odd", powers="odd", fixed=((1, 1),)), "omega": Scalar("even")}
SLOW = {"x": Field("cos", fixed=(1,)), "y": Field("cos"), "omega": Scalar()}
REST = {"x": "lam*cos(omega*t)", "y": "0", "omega": "1"}


def slow(*equations, seed=REST, **options):
    return fts.Equations(list(equations), unknowns=SLOW, frequency="omega", seed=seed, **options)


def taylor(function, order):
    """The Taylor coefficients of a function of λ."""
    series = sp.series(function, LAM, 0, order + 1).removeO()
    return [series.coeff(LAM, m) for m in range(order + 1)]


def omegas(solution):
    return [solution.coefficient("omega", m) for m in range(solution.order + 1)]


@pytest.mark.parametrize("late", range(1, 11))
def test_a_slow_variable_settled_any_number_of_orders_late(late):
    """y = λ, so x'' + (1 + λ²) x = 0; for more than four orders late as well."""
    sol = fts.solve(slow("x'' + x + x*y**2 = 0", f"y'' = lam**{late}*(lam - y)"), 8)
    assert omegas(sol) == taylor(sp.sqrt(1 + LAM**2), 8)


@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
def test_its_square_acts_on_rows_that_were_closed(arithmetic):
    """y = λ, so x₀₂ = -1 and nothing else changes."""
    sol = fts.solve(slow("x'' + x + y**2 = 0", "y'' = lam**2*(lam - y)"), 20, arithmetic)
    assert [sol.coefficient("x", 0, m) == -(m == 2) for m in range(21)] == [True] * 21
    assert [sol.coefficient("omega", m) == (m == 0) for m in range(21)] == [True] * 21


@pytest.mark.parametrize("seed", [None, REST])
def test_a_square_four_orders_late(seed):
    sol = fts.solve(slow("x'' + x + x*y**2 = 0", "y'' = lam**4*(lam**2 - y)", seed=seed), 16)
    assert omegas(sol) == taylor(sp.sqrt(1 + LAM**4), 16)


@pytest.mark.parametrize(("equations", "y", "power"), [
    (["x'' + x + x*y**2 = 0", "y'' = lam**4*(lam**2 - y)"], "lam**2", 4),
    (["x'' + x + x*y**2 = 0", "y'' = lam**6*(lam**3 - y)"], "lam**3", 6),
    (["x'' + x + x*y = 0", "y'' = lam**3*(lam**2 - y)"], "lam**2", 2),
    (["x'' + x + x*y**2 = 0", "y'' = lam**8*(lam - y)"], "lam", 2)])
@pytest.mark.parametrize("order", [9, 20])
def test_floats_where_whole_orders_vanish(equations, y, power, order):
    """Nothing but rounding is left of the terms there: no reason to refuse.  ω = √(1 + λ^power),
    to a hundred roundings of 1."""
    sol = fts.solve(slow(*equations, seed=REST | {"y": y}), order, "float")
    assert omegas(sol) == pytest.approx(list(map(float, taylor(sp.sqrt(1 + LAM**power), order))),
                                        abs=1e-14)


def test_floats_of_two_slow_variables():
    """y = λ and z = λ²: ω = √(1 + λ³)."""
    sol = fts.solve(fts.Equations(
        ["x'' + x + x*y*z = 0", "y'' = lam**2*(lam - y)", "z'' = lam**4*(lam**2 - z)"],
        unknowns=SLOW | {"z": Field("cos")}, frequency="omega",
        seed=REST | {"y": "lam", "z": "lam**2"}), 24, "float")
    assert omegas(sol) == pytest.approx(list(map(float, taylor(sp.sqrt(1 + LAM**3), 24))),
                                        abs=1e-14)


def test_a_slow_variable_that_depends_on_itself():
    """y = λ + y²/3: Catalan numbers over powers of 3."""
    sol = fts.solve(slow("x'' + x + x*y = 0", "y'' = lam**2*(lam + y**2/3 - y)"), 8)
    y = taylor((3 - sp.sqrt(9 - 12 * LAM)) / 2, 8)
    assert [sol.coefficient("y", 0, m) for m in range(9)] == y
    rooted = taylor(sp.sqrt(1 + sum(c * LAM**m for m, c in enumerate(y))), 8)
    assert omegas(sol) == rooted


def test_two_slow_variables_one_of_which_feeds_the_other():
    """y = λ and z = y² = λ²: settled one after the other, both late."""
    problem = fts.Equations(
        ["x'' + x + x*z = 0", "y'' = lam**2*(lam - y)", "z'' = lam**2*(y**2 - z)"],
        unknowns=SLOW | {"z": Field("cos")}, frequency="omega", seed=REST | {"z": "0"})
    sol = fts.solve(problem, 8)
    assert omegas(sol) == taylor(sp.sqrt(1 + LAM**2), 8)
    assert [sol.coefficient("z", 0, m) for m in range(9)] == [int(m == 2) for m in range(9)]


def test_a_forcing_that_a_slow_variable_cancels():
    """The row y² - λ², which no coefficient of its order can change, waits for y = λ."""
    unknowns = SLOW | {"x": Field("cos", modes="odd", fixed=(1,))}
    problem = fts.Equations(["x'' + x + y**2 - lam**2 = 0", "y'' = lam**2*(lam - y)"],
                            unknowns=unknowns, frequency="omega", seed=REST)
    assert omegas(fts.solve(problem, 8)) == [1] + [0] * 8


class TestWeaklyDamped:
    """The amplitude is settled four orders late and acts, together with ω, two orders late.
    Values by harmonic balance with 60 digits."""

    def test_duffing(self):
        problem = fts.Equations("x'' + x + x**3 = lam**2*(lam**2 - x**2)*x'", unknowns=CYCLE,
                                frequency="omega", seed={"x": "2*lam*cos(omega*t)", "omega": "1"})
        sol = fts.solve(problem, 8)
        R = sp.Rational
        assert omegas(sol)[::2] == [1, R(3, 2), R(-27, 16), R(279, 64), R(-14809, 1024)]
        assert [sol.coefficient("x", 1, m, sine=False) for m in (1, 3, 5, 7)] == [
            2, -R(1, 2), R(101, 64), -R(87, 16)]

    @pytest.mark.parametrize("order", [6, 7, 12])
    def test_the_order_that_is_asked_changes_nothing(self, order):
        problem = fts.Equations("x'' + sin(x) = lam**2*(lam**2 - x**2)*x'", unknowns=CYCLE,
                                frequency="omega", seed={"x": "2*lam*cos(omega*t)", "omega": "1"})
        assert fts.solve(problem, order).coefficient("omega", 6) == sp.Rational(-7, 1536)


def test_two_equal_oscillators_are_one():
    """On y = x the equations are x'' + x + 2x³ + x⁵ = 0."""
    odd = Field("cos", modes="odd", powers="odd")
    one = {"x": Field("cos", modes="odd", powers="odd", fixed=(1,)), "omega": Scalar("even")}
    both = fts.solve(fts.Equations(
        ["x'' + x + x*(x**2 + y**2) + x**2*y**3 = 0", "y'' + y + y*(x**2 + y**2) + x**3*y**2 = 0"],
        unknowns=one | {"y": odd}, frequency="omega",
        seed={"x": "lam*cos(omega*t)", "y": "lam*cos(omega*t)", "omega": "1"}), 11)
    alone = fts.solve(fts.Equations("x'' + x + 2*x**3 + x**5 = 0", unknowns=one,
                                    frequency="omega"), 11)
    assert both.coefficients["x"] == both.coefficients["y"] == alone.coefficients["x"]
    assert both.coefficients["omega"] == alone.coefficients["omega"]
    assert both.coefficient("omega", 6) == -sp.Rational(37, 1024)


class TestRefusals:
    def test_two_values_of_a_slow_variable(self):
        """y² = λ²: y = λ or -λ."""
        with pytest.raises(fts.SolveError, match=r"non-linear in the coefficients.*order 4 of λ"):
            fts.solve(slow("x'' + x + x*y = 0", "y'' = lam**2*(lam**2 - y**2)"), 8)

    def test_and_the_seed_that_chooses_one(self):
        for sign in (1, -1):
            seed = REST | {"y": f"{sign}*lam"}
            sol = fts.solve(slow("x'' + x + x*y = 0", "y'' = lam**2*(lam**2 - y**2)", seed=seed), 8)
            assert omegas(sol) == taylor(sp.sqrt(1 + sign * LAM), 8)

    def test_a_forcing_that_nothing_cancels(self):
        unknowns = SLOW | {"x": Field("cos", modes="odd", fixed=(1,))}
        problem = fts.Equations(["x'' + x + y - 2*lam = 0", "y'' = lam**2*(lam - y)"],
                                unknowns=unknowns, frequency="omega", seed=REST)
        with pytest.raises(fts.ContradictionError, match=r"equation \(2\).*order 3"):
            fts.solve(problem, 8)

    def test_what_nothing_determines(self):
        with pytest.raises(fts.UndeterminedError, match="nothing up to 12 orders later"):
            fts.solve(slow("x'' + x + x*y = 0", "y'' = 0"), 8)

    def test_the_head_start_that_an_ansatz_needs_is_named_and_does(self):
        """x'' + x + λx³ = 0 with x = cos τ + …: 3/8, -15/256 (Duffing's, λ for the amplitude)."""
        def solved(ahead):
            return fts.solve(fts.Equations(
                "x'' + x + lam*x**3 = 0", unknowns={"x": Field("cos", fixed=(1,)),
                                                    "omega": Scalar()},
                frequency="omega", seed={"x": "cos(omega*t)", "omega": "1"}, ahead=ahead), 4)
        with pytest.raises(fts.SolveError, match="this one needs ahead=3 or more"):
            solved(2)
        assert omegas(solved(5))[:3] == [1, sp.Rational(3, 8), -sp.Rational(15, 256)]


class TestFloats:
    """Floats refuse what exact numbers refuse, and say where rounding has eaten the digits."""

    def forced(self, power, ahead):
        return fts.Equations(f"x'' + 2*x - x**{power} = lam*cos(2*t)", ahead=ahead,
                             unknowns={"x": Field("cos")}, seed={"x": "0"})

    @pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
    @pytest.mark.parametrize("power, ahead, order, named",
                             [(9, 1, 18, 9), (9, 9, 18, 13), (3, 1, 12, 3), (5, 2, 12, 5)])
    def test_modes_beyond_the_ansatz(self, arithmetic, power, ahead, order, named):
        """x^p of cos 2τ has cos 2pτ at order p; after the first orders, too, which are exact."""
        with pytest.raises(fts.SolveError, match=f"too narrow.*this one needs ahead={named} or"):
            fts.solve(self.forced(power, ahead), order, arithmetic)

    @pytest.mark.parametrize("power", [3, 9])
    def test_no_aliasing_with_a_head_start(self, power):
        """Products of modes n ≤ m + ahead reach further than m + ahead."""
        exact = fts.solve(self.forced(power, 18), 18)
        floats = fts.solve(self.forced(power, 18), 18, "float")
        for n in range(37):
            for m in range(19):
                assert floats.coefficient("x", n, m) == pytest.approx(
                    float(exact.coefficient("x", n, m)), abs=1e-16)

    @pytest.mark.parametrize("equation", ["x'' + x/(1+x) = 0", "x'' + x + x**2/(1-x) = 0",
                                          "x'' + 1 - 1/(1+x) = 0"])
    def test_digits_that_cancel_are_missed(self, equation):
        """ω is what is left of terms 10²⁰ times its size: of order 60 no digit is right."""
        problem = fts.Equations(equation, unknowns={"x": Field("cos", fixed=(1,)),
                                                    "omega": Scalar()}, frequency="omega")
        with pytest.warns(fts.PrecisionWarning, match=r"from order 38 .* 'omega' keep fewer than "
                                                      r"3 digits.*truncate\(37\)"):
            floats = fts.solve(problem, 60, "float")
        exact = fts.solve(problem, 60)
        for m in range(2, 38, 2):               # what is not warned of keeps three digits
            assert floats.coefficient("omega", m) == pytest.approx(
                float(exact.coefficient("omega", m)), rel=1e-3, abs=0)
        assert floats.coefficient("omega", 60) != pytest.approx(
            float(exact.coefficient("omega", 60)), rel=1, abs=0)

    @pytest.mark.parametrize("problem, order", [(fts.CubicOscillator(a=1), 100),
                                                (fts.FigureEight(), 200)])
    def test_no_warning_where_the_digits_are_there(self, recwarn, problem, order):
        fts.solve(problem, order, "float")
        assert not recwarn.list
