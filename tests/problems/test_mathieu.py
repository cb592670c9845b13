"""The generalized Mathieu equation of section 3: printed series, Hill matrix, SciPy."""

import mpmath
import numpy as np
import pytest
import sympy as sp

import ftseries as fts
from ftseries.references import mathieu

mu = sp.Symbol("mu")


@pytest.fixture(scope="module")
def order_99():
    return fts.solve(fts.GeneralizedMathieu(), 99)


def test_M3_as_printed(order_99):
    printed = [1, -sp.Rational(1, 2), -sp.Rational(1, 32), (32 * mu + 1) / 512,
               (-1024 * mu**2 - 64 * mu - 1) / 24576]
    computed = [order_99.coefficient("a", m) for m in range(0, 9, 2)]
    assert [sp.expand(x - y) for x, y in zip(computed, printed, strict=True)] == [0] * 5


def test_abramowitz_and_stegun_20_2_25(order_99):
    """a_1(-q) = b_1(q) as printed there, with λ² = 2q."""
    printed = [1, -1, "-1/8", "1/64", "-1/1536", "-11/36864", "49/589824", "-55/9437184",
               "-83/35389440"]
    computed = [order_99.coefficient("a", 2 * k).subs(mu, 0) * 2**k for k in range(9)]
    assert computed == [sp.Rational(c) for c in printed]


def test_M2_the_ansatz(order_99):
    assert all(row == {} for row in order_99.coefficients["a"][1::2])
    for m, row in enumerate(order_99.coefficients["psi"]):
        assert all(sine == 1 and n % 2 == 1 and n <= m and (n - m) % 2 == 0 for sine, n in row)
        assert ((1, 1) in row) == (m == 1)                           # λ sin x, to all orders


def test_the_outermost_coefficients_in_closed_form(order_99):
    """Ψ_{n,n} at μ = 0: (1 - n²) Ψ_{n,n} = ½ Ψ_{n-2,n-2}, from (M1) by hand."""
    value = sp.Integer(1)
    for n in range(3, 40, 2):
        value /= 2 * (1 - n**2)
        assert order_99.coefficient("psi", n, n).subs(mu, 0) == value


@pytest.mark.parametrize("lam, m", [("0.3", "0"), ("1", "0"), ("1.5", "0"), ("1.2", "-0.3"),
                                    ("1", "0.3"), ("1.3", "0.1")])
def test_eigenvalue_against_the_hill_matrix(order_99, lam, m):
    """The truncation leaves about (λ/ρ)^100, ρ the radius of convergence at that μ (≥ 1.9)."""
    with mpmath.workdps(30):
        truth = mathieu.eigenvalue(mpmath.mpf(lam), mpmath.mpf(m), dps=30)
        computed = order_99.evaluate("a", lam=mpmath.mpf(lam), mu=mpmath.mpf(m), dps=30)
        assert abs(computed - truth) < 10 * (mpmath.mpf(lam) / mpmath.mpf("1.9")) ** 100 + 1e-28


def test_eigenvalue_against_scipy(order_99):
    lam = np.linspace(0, 1.8, 19)
    assert np.abs(order_99.evaluate("a", lam=lam, mu=0) - mathieu.mathieu_b(lam)).max() < 5e-15 * 10


def test_the_papers_example(order_99):
    """λ = 2, μ = -0.3: inside, but close to, the radius of about 2.2."""
    truth = mathieu.eigenvalue(2, -0.3)
    assert 1e-6 < abs(order_99.evaluate("a", lam=2, mu=-0.3) - truth) < 1e-4
    assert abs(fts.solve(fts.GeneralizedMathieu("-3/10"), 300, "float").evaluate("a", lam=2)
               - truth) < 1e-9


@pytest.mark.parametrize("m", [0, 0.2, -0.3])
def test_eigenfunction_against_the_hill_matrix(order_99, m):
    x = np.linspace(-4, 4, 33)
    truth = mathieu.eigenfunction(x, 1.2, m)
    assert np.abs(order_99.evaluate("psi", x, lam=1.2, mu=m) - truth).max() < 1e-13


def test_a_number_for_mu_before_or_after():
    symbolic = fts.solve(fts.GeneralizedMathieu(), 21)
    concrete = fts.solve(fts.GeneralizedMathieu(mu="-3/10"), 21)
    for m in range(22):
        assert (sp.sympify(symbolic.coefficient("a", m)).subs(mu, sp.Rational(-3, 10))
                == concrete.coefficient("a", m))
        for n in range(1, m + 1, 2):
            assert (sp.sympify(symbolic.coefficient("psi", n, m)).subs(mu, sp.Rational(-3, 10))
                    == concrete.coefficient("psi", n, m))
    assert concrete.evaluate("a", lam=1.1) == pytest.approx(
        symbolic.evaluate("a", lam=1.1, mu=-0.3), abs=1e-15)


def test_mu_of_every_kind():
    for value in (0.25, "1/4", "0.25", sp.Rational(1, 4), np.float64(0.25), mpmath.mpf("0.25")):
        solution = fts.solve(fts.GeneralizedMathieu(value), 6)
        assert solution.coefficient("a", 6) == sp.Rational(9, 512)


def test_radius_of_convergence_at_mu_0(order_99):
    """DLMF table 28.6.1: |q| < 3.7699574940, so |λ| < 2.7459; fitted to 50 coefficients."""
    from ftseries.evaluation import radius_estimate
    radius = radius_estimate(order_99.table("a", mu=0))
    assert radius == pytest.approx(np.sqrt(2 * 3.7699574940), rel=0.02)
