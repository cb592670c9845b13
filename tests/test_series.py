"""Laws of the ring of Fourier-Taylor series, in every arithmetic, on random series."""

from fractions import Fraction
from math import comb, factorial

import flint
import numpy as np
import pytest
import sympy as sp
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from ftseries.errors import InputError, NonAnalyticError
from ftseries.expansion import Expansion
from ftseries.grid import FloatRing
from ftseries.laurent import BallRing, PolynomialRing, RationalRing, SurdRing
from ftseries.series import cos, exp, sin

ORDER = 4

RINGS = {"exact": RationalRing, "polynomial": lambda: PolynomialRing(("mu",)), "ball": BallRing,
         "float": lambda: FloatRing(degree=ORDER + 1, order=ORDER)}


@pytest.fixture(params=RINGS)
def ring(request):
    with flint.ctx.workprec(200):
        yield RINGS[request.param]()


numbers = st.fractions(min_value=-2, max_value=2, max_denominator=6)


def modes(k, sines=(0, 1), parity=None):
    """A random Taylor coefficient of order k: Fourier orders n ≤ k."""
    keys = [(s, n) for s in sines for n in range(k + 1)
            if (n or not s) and (parity is None or n % 2 == parity)]
    return st.dictionaries(st.sampled_from(keys), numbers, max_size=3) if keys else st.just({})


#: Taylor coefficients 0, …, ORDER
rows = st.tuples(*(modes(k) for k in range(ORDER + 1))).map(list)
#: the same without, and with, the constant 1 at λ = 0
small = rows.map(lambda r: [{}, *r[1:]])
near_one = rows.map(lambda r: [{(0, 0): Fraction(1)}, *r[1:]])
fourths = st.integers(-8, 8).map(lambda i: Fraction(i, 4))
exponents = st.fractions(min_value=-3, max_value=3, max_denominator=4).filter(bool)


def make(expansion, *series):
    ring = expansion.ring
    out = [expansion.polynomial([{m: ring.number(c) for m, c in row.items()} for row in rows])
           for rows in series]
    return out if len(out) > 1 else out[0]


def equal(a, b, order=ORDER):
    """Identical where exact, overlapping balls, and rounding of a dozen operations in float."""
    for k in range(order + 1):
        u, v = a[k].modes(), b[k].modes()
        scale = max([1.0, *(abs(float(x)) for x in [*u.values(), *v.values()])]
                    if a.ring.name == "float" else [1.0])
        for mode in set(u) | set(v):
            x, y = u.get(mode, 0), v.get(mode, 0)
            if a.ring.name == "float":
                assert abs(x - y) <= 1e-11 * scale, (k, mode)
            elif a.ring.name == "ball":
                assert arb(x).overlaps(arb(y)), (k, mode)
                assert arb(x).rad() < 1e-30 * (1 + abs(arb(x))), "a ball this wide shows nothing"
            else:
                assert x == y, (k, mode)


# --- ring axioms --------------------------------------------------------------------------------

@given(rows, rows, rows)
def test_addition_is_commutative_and_associative(ring, a, b, c):
    a, b, c = make(Expansion(ring), a, b, c)
    equal(a + b, b + a)
    equal((a + b) + c, a + (b + c))


@given(rows, rows, rows)
def test_multiplication_is_commutative_associative_and_distributive(ring, a, b, c):
    a, b, c = make(Expansion(ring), a, b, c)
    equal(a * b, b * a)
    equal((a * b) * c, a * (b * c))
    equal(a * (b + c), a * b + a * c)


@given(rows)
def test_zero_one_and_negation(ring, a):
    a = make(Expansion(ring), a)
    equal(a + 0, a)
    equal(0 + a, a)
    equal(a * 1, a)
    equal(1 * a, a)
    equal(a * 0, a - a)
    equal(-a, 0 - a)
    equal(a - 1, -(1 - a))
    equal(a / 2 + a / 2, a)
    equal(a * Fraction(2, 3), 2 * a / 3)


@given(rows)
def test_whole_powers_are_products(ring, a):
    a = make(Expansion(ring), a)
    equal(a**1, a)
    equal(a**2, a * a)
    equal(a**3, a * a * a)
    equal(a**5, a * a * a * a * a)
    equal(a**0, a * 0 + 1)


@given(rows, rows)
def test_the_binomial_formula(ring, a, b):
    """(a + b)² folds the square's pairs, a·b does not."""
    a, b = make(Expansion(ring), a, b)
    equal((a + b) ** 2, a * a + 2 * a * b + b * b)
    equal((a + b) * (a - b), a**2 - b**2)


def test_lambda_shifts_orders(ring):
    expansion = Expansion(ring)
    a = make(expansion, [{(0, 0): 1}, {(1, 1): 2}])
    equal(a * expansion.lam**2, make(expansion, [{}, {}, {(0, 0): 1}, {(1, 1): 2}]))


# --- what a product is: an independent schoolbook -----------------------------------------------

def schoolbook(a, b):
    """The product of two ``{(sine, n): Fraction}`` by the product-to-sum formulas."""
    out = {}

    def add(sine, n, c):
        if n < 0:
            n, c = -n, -c if sine else c
        if n or not sine:
            out[sine, n] = out.get((sine, n), 0) + c

    for (s, m), x in a.items():
        for (t, n), y in b.items():
            c = x * y / 2
            if not s and not t:
                add(0, m + n, c), add(0, m - n, c)
            elif s and t:
                add(0, m - n, c), add(0, m + n, -c)
            elif s:
                add(1, m + n, c), add(1, m - n, c)
            else:
                add(1, m + n, c), add(1, n - m, c)
    return {mode: c for mode, c in out.items() if c}


@given(rows, rows)
def test_product_by_the_formulas_of_trigonometry(ring, a, b):
    expansion = Expansion(ring)
    expected = []
    for k in range(ORDER + 1):
        total = {}
        for j in range(k + 1):
            for mode, c in schoolbook(a[j], b[k - j]).items():
                total[mode] = total.get(mode, 0) + c
        expected.append(total)
    u, v = make(expansion, a, b)
    equal(u * v, make(expansion, expected))


# --- derivative and shifts ----------------------------------------------------------------------

@given(rows, rows)
def test_leibniz_rule(ring, a, b):
    a, b = make(Expansion(ring), a, b)
    equal((a * b).diff(), a.diff() * b + a * b.diff())
    equal((a * b).diff(2), a.diff(2) * b + 2 * a.diff() * b.diff() + a * b.diff(2))


@given(rows)
def test_the_second_derivative_is_the_derivative_twice(ring, a):
    a = make(Expansion(ring), a)
    equal(a.diff(2), a.diff().diff())


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_derivatives_of_cosine_and_sine(ring, n):
    expansion = Expansion(ring)
    equal(expansion.cos(n).diff(), -n * expansion.sin(n))
    equal(expansion.sin(n).diff(), n * expansion.cos(n))
    equal(expansion.cos(n) ** 2 + expansion.sin(n) ** 2, expansion.constant(1)) if n < 4 else None


@given(rows, rows, fourths, fourths)
def test_shifts_compose_and_respect_products(ring, a, b, s, t):
    a, b = make(Expansion(ring), a, b)
    equal(a.shift(s).shift(t), a.shift(s + t))
    equal((a * b).shift(s), a.shift(s) * b.shift(s))
    equal(a.shift(1), a)
    equal(a.shift(s).diff(), a.diff().shift(s))


def test_a_quarter_shift_turns_cosine_into_minus_sine(ring):
    """cos(τ + π/2) = -sin τ: the sign says in which direction the shift goes."""
    expansion = Expansion(ring)
    equal(expansion.cos(1).shift(Fraction(1, 4)), -expansion.sin(1))
    equal(expansion.sin(1).shift(Fraction(1, 4)), expansion.cos(1))


@pytest.mark.parametrize("ring", ["ball", "float"], indirect=True)
@given(rows, st.integers(-6, 6), st.integers(-6, 6))
def test_shifts_by_any_fraction(ring, a, q, p):
    a = make(Expansion(ring), a)
    s = Fraction(p, 7)
    equal(a.shift(s).shift(Fraction(q, 5)), a.shift(s + Fraction(q, 5)))


@given(a=rows, b=rows, p=st.integers(-12, 12), q=st.integers(-12, 12))
def test_shifts_by_twelfths_over_the_root_of_three(a, b, p, q):
    """Exact identities in Q(√3): nothing but s² = 3 is used."""
    a, b = make(Expansion(SurdRing()), a, b)
    s, t = Fraction(p, 12), Fraction(q, 12)
    equal(a.shift(s).shift(t), a.shift(s + t))
    equal((a * b).shift(s), a.shift(s) * b.shift(s))
    equal(a.shift(Fraction(1, 3)) + a.shift(Fraction(2, 3)), a.neighbours())


@given(a=rows, b=rows, c=rows, p=st.integers(0, 11), q=st.integers(0, 11))
def test_ring_axioms_over_the_root_of_three(a, b, c, p, q):
    """The shifts put √3 into the coefficients."""
    a, b, c = make(Expansion(SurdRing()), a, b, c)
    a, b = a.shift(Fraction(p, 12)), b.shift(Fraction(q, 12))
    equal(a * b, b * a)
    equal((a * b) * c, a * (b * c))
    equal(a * (b + c), a * b + a * c)
    equal(a + (b - a), b)
    equal(1 / (1 + c.expansion.lam * a) * (1 + c.expansion.lam * a), c.expansion.constant(1))


def test_the_root_of_three_reduces():
    ring = SurdRing(("mu",))
    assert ring.from_modes({(0, 0): ring.surd}).scale(ring.surd).modes() == {(0, 0): 3}
    root = Expansion(ring).parameter(sp.sqrt(3))
    assert (root * root)[0].modes() == {(0, 0): 3}
    twelfth = Expansion(ring).cos(1).shift(Fraction(1, 12))[0].modes()
    assert twelfth == {(0, 1): ring.surd / 2, (1, 1): fmpq(-1, 2)}      # cos(τ + π/6)
    with pytest.raises(InputError, match="1/5"):
        Expansion(ring).cos(1).shift(Fraction(1, 5))[0]


@pytest.mark.parametrize("ring", ["ball", "float"], indirect=True)
@pytest.mark.parametrize("bodies", [2, 3, 4, 5])
@given(a=rows)
def test_neighbours_are_the_sum_of_the_other_shifts(ring, bodies, a):
    a = make(Expansion(ring), a)
    total = a.shift(Fraction(1, bodies))
    for j in range(2, bodies):
        total = total + a.shift(Fraction(j, bodies))
    equal(a.neighbours(bodies), total)


@given(rows)
def test_neighbours_of_three_project(ring, a):
    """With P = (1 + neighbours)/3: P² = P, and P is a ring homomorphism's average."""
    a = make(Expansion(ring), a)
    mean = (a + a.neighbours()) / 3
    equal((mean + mean.neighbours()) / 3, mean)
    equal(a.neighbours().diff(), a.diff().neighbours())


# --- powers and elementary functions ------------------------------------------------------------

@given(near_one)
def test_inverse(ring, u):
    u = make(Expansion(ring), u)
    equal(u * u**-1, u**0)
    equal(1 / u, u**-1)
    equal(3 / u, u**-1 * 3)
    equal(u**-2, u**-1 * u**-1)
    equal(u / u, u**0)


@given(near_one, exponents)
def test_a_power_and_its_inverse_power(ring, u, alpha):
    u = make(Expansion(ring), u)
    equal((u**alpha) ** (1 / alpha), u)


@given(near_one, exponents, exponents)
def test_powers_add_and_multiply(ring, u, alpha, beta):
    u = make(Expansion(ring), u)
    equal(u**alpha * u**beta, u ** (alpha + beta))
    equal((u**alpha).diff(), alpha * u ** (alpha - 1) * u.diff())


@pytest.mark.parametrize("c", [Fraction(2), Fraction(1, 2)])
@given(near_one, st.integers(-5, 5).filter(bool))
def test_a_constant_factor_in_a_power(ring, c, u, m):
    """(c² u)^{m/2} = c^m u^{m/2}: the series starts at c², not at 1."""
    u = make(Expansion(ring), u)
    equal((c**2 * u) ** Fraction(m, 2), c**m * u ** Fraction(m, 2))


@given(near_one, near_one, exponents)
def test_power_of_a_product(ring, u, v, alpha):
    u, v = make(Expansion(ring), u, v)
    equal((u * v) ** alpha, u**alpha * v**alpha)


@given(small, small)
def test_exponential_law(ring, u, v):
    u, v = make(Expansion(ring), u, v)
    equal(exp(u) * exp(-u), u * 0 + 1)
    equal(exp(u + v), exp(u) * exp(v))
    equal(exp(u).diff(), u.diff() * exp(u))


@given(small, small)
def test_addition_theorems(ring, u, v):
    u, v = make(Expansion(ring), u, v)
    equal(sin(u) ** 2 + cos(u) ** 2, u * 0 + 1)
    equal(sin(u + v), sin(u) * cos(v) + cos(u) * sin(v))
    equal(cos(u + v), cos(u) * cos(v) - sin(u) * sin(v))
    equal(sin(-u), -sin(u))
    equal(cos(-u), cos(u))
    equal(sin(u).diff(), u.diff() * cos(u))
    equal(cos(u).diff(), -u.diff() * sin(u))


@given(small)
def test_functions_by_their_power_series(ring, u):
    """u = O(λ), so the sums end at ORDER."""
    u = make(Expansion(ring), u)
    terms = [u**k / factorial(k) for k in range(ORDER + 1)]
    equal(exp(u), sum(terms[1:], terms[0]))
    equal(sin(u), terms[1] - terms[3])
    equal(cos(u), terms[0] - terms[2] + terms[4])


@given(small, exponents)
def test_binomial_series(ring, u, alpha):
    u = make(Expansion(ring), u)
    total, c = u * 0, Fraction(1)
    for k in range(ORDER + 1):
        total = total + c * u**k
        c = c * (alpha - k) / (k + 1)
    equal((1 + u) ** alpha, total)


# --- truncation, laziness -----------------------------------------------------------------------

@given(near_one, near_one, st.integers(0, ORDER))
def test_truncation_is_a_homomorphism(ring, u, v, k):
    """Coefficients up to k of every operation depend on coefficients up to k alone."""
    expansion = Expansion(ring)
    long, cut = make(expansion, u, v), make(expansion, u[:k + 1], v[:k + 1])
    for operation in (lambda a, b: a + b, lambda a, b: a * b, lambda a, b: a**-1 * b,
                      lambda a, b: a**Fraction(1, 2), lambda a, b: exp(a - 1) * sin(b - 1),
                      lambda a, b: a.diff() * b.diff(2), lambda a, b: a.neighbours()):
        equal(operation(*long), operation(*cut), k)


@given(near_one, st.lists(st.tuples(st.integers(1, ORDER), modes(1)), max_size=4))
def test_changed_coefficients_are_forgotten(ring, start, changes):
    """After each change of an unknown and ``forget``, a graph gives what a fresh graph gives."""
    expansion = Expansion(ring)

    def graph(x):
        return (x**-2 * cos(x - 1) + exp(x - 1) * x.diff() + x.neighbours() * x * x
                + x**Fraction(1, 2))

    def convert(row):
        return ring.from_modes({m: ring.number(c) for m, c in row.items()})

    current = [dict(row) for row in start]
    x = expansion.unknown()
    for k, row in enumerate(current):
        x.set(k, convert(row))
    y = graph(x)
    y[ORDER]
    for k, row in changes:
        current[k] = row
        for j in range(k, ORDER + 1):
            x.set(j, convert(current[j]))
        expansion.forget(k)
        equal(y, graph(make(Expansion(ring), current)))


def test_an_unset_unknown_is_zero(ring):
    x = Expansion(ring).unknown()
    x.set(3, ring.from_modes({(0, 1): ring.number(1)}))
    assert not any(c for k in (0, 1, 2, 4) for c in x[k].modes().values())
    equal(x, make(Expansion(ring), [{}, {}, {}, {(0, 1): Fraction(1)}]))


def test_a_long_sum_with_its_deep_part_kept():
    """Order 24: the windows at both ends and the kept middle give the whole Cauchy sum."""
    ring = RationalRing()
    expansion = Expansion(ring)
    x = expansion.unknown()
    for k in range(25):
        x.set(k, ring.from_modes({(0, 0): fmpq(1)}))
    square, inverse, cube = x * x, x**-1, x**3
    assert [square[k].modes()[0, 0] for k in range(25)] == [k + 1 for k in range(25)]
    assert [inverse[k].modes() for k in range(25)] == [{(0, 0): 1}, {(0, 0): -1}] + [{}] * 23
    for k in (22, 23, 24):
        x.set(k, ring.from_modes({(0, 0): fmpq(2)}))
        for j in range(k + 1, 25):
            x.set(j, ring.from_modes({(0, 0): fmpq(1)}))
        expansion.forget(k)
        expected = [1] * 22 + [2] * (k - 21) + [1] * (24 - k)
        assert cube[24].modes()[0, 0] == sum(
            expected[i] * expected[j] * expected[24 - i - j]
            for i in range(25) for j in range(25 - i))


LONG = 12


@pytest.fixture(params=RINGS)
def long_ring(request):
    """To order 12: Cauchy sums have a deep part, which settled coefficients give, from order 6."""
    with flint.ctx.workprec(200):
        yield FloatRing(degree=LONG, order=LONG) if request.param == "float" else RINGS[
            request.param]()


def legendre(k):
    """P_k(cos τ) = Σ_j c_j c_{k-j} cos (k - 2j)τ with c_j = C(2j, j)/4^j."""
    out = {}
    for j in range(k + 1):
        mode = 0, abs(k - 2 * j)
        out[mode] = out.get(mode, 0) + Fraction(comb(2 * j, j) * comb(2 * k - 2 * j, k - j), 4**k)
    return out


def test_products_and_powers_of_the_generating_function_of_legendre(long_ring):
    """G = Σ λ^k P_k(cos τ) = D^{-1/2} with D = 1 - 2λ cos τ + λ²; and 1/D = Σ λ^k U_k(cos τ)
    with U_k = Σ_j cos (k - 2j)τ.  G and 1/D have terms at all orders."""
    expansion = Expansion(long_ring)
    g, u = make(expansion, [legendre(k) for k in range(LONG + 1)],
                [{(0, n): 2 if n else 1 for n in range(k % 2, k + 1, 2)} for k in range(LONG + 1)])
    d = 1 - 2 * expansion.lam * expansion.cos(1) + expansion.lam**2
    equal(g * g, u, LONG)
    equal(g * u * d, g, LONG)
    equal(g**-1, g * d, LONG)
    equal(g**-2, d, LONG)
    equal(u ** Fraction(1, 2), g, LONG)
    equal(u ** Fraction(-3, 2), g * d * d, LONG)
    equal(d ** Fraction(-1, 2), g, LONG)


def test_functions_of_the_logarithm(long_ring):
    """-log(1 - λ e^{iτ}) = L + iθ with L = Σ λ^k cos kτ/k and θ = Σ λ^k sin kτ/k.  So exp L is the
    generating function of Legendre's polynomials, and e^{-iθ} = (1 - λ e^{iτ}) exp L."""
    expansion = Expansion(long_ring)
    log, theta, g = make(expansion, *(
        [{}, *({(sine, k): Fraction(1, k)} for k in range(1, LONG + 1))] for sine in (0, 1)),
        [legendre(k) for k in range(LONG + 1)])
    equal(exp(log), g, LONG)
    equal(sin(theta), expansion.lam * expansion.sin(1) * g, LONG)
    equal(cos(theta), (1 - expansion.lam * expansion.cos(1)) * g, LONG)


@pytest.mark.parametrize("changed", range(LONG + 1))
def test_a_change_of_any_order_is_forgotten_up_to_a_high_one(changed):
    """Also by the kept deep parts of the sums: that of order 6 + j contains coefficient 3 + j."""
    expansion, fresh = Expansion(RationalRing()), Expansion(RationalRing())
    rows = [{(0, k % 3): Fraction(1, k + 1), (1, 1): Fraction(k)} for k in range(LONG + 1)]
    rows[0] = {(0, 0): Fraction(1)}

    def graph(x):
        return x * x.diff() + x**-1 + x ** Fraction(-1, 2) + exp(x.diff()) + sin(x.diff())

    def set_from(first):
        for k in range(first, LONG + 1):
            x.set(k, expansion.ring.from_modes({m: fmpq(c.numerator, c.denominator)
                                                for m, c in rows[k].items()}))

    x = expansion.unknown()
    set_from(0)
    y = graph(x)
    y[LONG]
    rows[changed] = {(0, 0): Fraction(4)}
    set_from(changed)
    expansion.forget(changed)
    equal(y, graph(make(fresh, rows)), LONG)


# --- arithmetics against each other -------------------------------------------------------------

@given(near_one, small, exponents)
def test_balls_contain_exact_and_float_agrees(u, v, alpha):
    def result(ring):
        a, b = make(Expansion(ring), u, v)
        return a**alpha * exp(b) + sin(b).diff() * cos(b) / a

    exact = result(RationalRing())
    with flint.ctx.workprec(150):
        ball = result(BallRing())
        [ball[k] for k in range(ORDER + 1)]
        for k in range(ORDER + 1):
            e, b = exact[k].modes(), ball[k].modes()
            for mode in set(e) | set(b):
                value = e.get(mode, fmpq(0))
                assert (b.get(mode, arb(0)) * value.q - value.p).contains(0)
    equal(result(FloatRing(degree=ORDER + 1, order=ORDER)), make(
        Expansion(FloatRing(degree=ORDER + 1, order=ORDER)),
        [{m: Fraction(int(c.p), int(c.q)) for m, c in exact[k].modes().items()}
         for k in range(ORDER + 1)]))


@given(near_one, numbers)
def test_polynomials_in_mu_specialize(u, mu):
    """Putting a number for μ before or after gives the same: evaluation is a homomorphism."""
    def result(ring, value):
        x = make(Expansion(ring), u)
        parameter = x.expansion.parameter("mu") if value is None else value
        y = x + parameter * x.expansion.lam * x.expansion.cos(1)
        return y**-1 + y * y * parameter

    symbolic, concrete = result(PolynomialRing(("mu",)), None), result(RationalRing(), mu)
    point = [fmpq(0), fmpq(mu.numerator, mu.denominator)]
    for k in range(ORDER + 1):
        specialized = {m: c(*point) for m, c in symbolic[k].modes().items()}
        assert {m: c for m, c in specialized.items() if c} == concrete[k].modes()


def test_the_numbers_of_a_series_of_constants():
    """The central binomial coefficients: (1 - 4λ)^(-1/2)."""
    expansion = Expansion(RationalRing())
    root = (1 - 4 * expansion.lam) ** Fraction(-1, 2)
    assert [int(root[k].modes()[0, 0]) for k in range(7)] == [1, 2, 6, 20, 70, 252, 924]


# --- refusals -----------------------------------------------------------------------------------

@pytest.mark.parametrize("alpha", [-1, Fraction(1, 2), Fraction(-3, 2)])
def test_power_of_what_vanishes_or_oscillates(ring, alpha):
    expansion = Expansion(ring)
    with pytest.raises(NonAnalyticError, match=f"the power {alpha} .* vanishes"):
        (expansion.lam**alpha)[0]
    with pytest.raises(NonAnalyticError, match=f"the power {alpha} .*oscillates"):
        ((2 + expansion.cos(1)) ** alpha)[0]


@pytest.mark.parametrize("function", [exp, sin, cos])
def test_functions_of_what_does_not_vanish(ring, function):
    expansion = Expansion(ring)
    with pytest.raises(NonAnalyticError, match="zero at λ = 0"):
        function(expansion.lam + 1)[0]
    with pytest.raises(NonAnalyticError, match="oscillates"):
        function(expansion.cos(1))[0]


@pytest.mark.parametrize("ring", ["exact", "polynomial"], indirect=True)
def test_irrational_numbers_in_exact_arithmetic(ring):
    expansion = Expansion(ring)
    with pytest.raises(InputError, match="not rational"):
        ((2 + expansion.lam) ** Fraction(1, 2))[0]
    with pytest.raises(InputError, match="neighbours"):
        expansion.cos(1).shift(Fraction(1, 3))[0]
    assert ((Fraction(9, 4) + expansion.lam) ** Fraction(-3, 2))[0].modes() == {(0, 0): fmpq(8, 27)}
    assert ((expansion.lam - 2) ** -3)[0].modes() == {(0, 0): fmpq(-1, 8)}


@pytest.mark.parametrize("ring", ["exact", "polynomial"], indirect=True)
@pytest.mark.parametrize("power", [Fraction(1, 2), Fraction(1, 3), Fraction(-2, 3)])
def test_a_root_of_a_negative_number_in_exact_arithmetic(ring, power):
    """Also a cube root: the principal value of (-64)^{1/3} is not -4."""
    with pytest.raises(InputError, match="not rational"):
        ((Expansion(ring).lam - 64) ** power)[0]


@pytest.mark.parametrize("ring", ["ball", "float"], indirect=True)
def test_a_root_of_a_negative_number(ring):
    with pytest.raises(InputError, match="negative"):
        ((Expansion(ring).lam - 1) ** Fraction(1, 2))[0]
    assert float(((Expansion(ring).lam - 2) ** -3)[0].modes()[0, 0]) == pytest.approx(-1 / 8)


def test_zero_divisors(ring):
    expansion = Expansion(ring)
    with pytest.raises(InputError, match="zero"):
        expansion.lam / 0
    with pytest.raises(NonAnalyticError, match="vanishes"):
        (1 / (expansion.lam * 0))[0]


def test_values_of_a_product_at_points():
    """The values of the product are the products of the values, in NumPy."""
    rng = np.random.default_rng(1)
    ring = FloatRing(degree=9, order=0)
    tau = np.linspace(0, 7, 40)

    def at(trig):
        return sum(c * (np.sin if s else np.cos)(n * tau) for (s, n), c in trig.modes().items())

    for _ in range(20):
        u, v = (ring.from_modes({(s, n): float(rng.normal()) for s in (0, 1) for n in range(5)
                                 if n or not s}) for _ in range(2))
        assert np.allclose(at(u * v), at(u) * at(v), rtol=0, atol=1e-12)
        assert np.allclose(at(u + v), at(u) + at(v), rtol=0, atol=1e-13)
