"""Enclosures of the eigenvalue against the truncated Hill matrix and DLMF's Mathieu functions."""

import mpmath
import pytest
from certify.altering import refused
from flint import arb, ctx, fmpq
from scipy import special

import ftseries as fts
from ftseries.certify import NotProved, check, mathieu, mathieu_eigenvalue
from ftseries.references import mathieu as reference

PARAMETERS = [("2", "-0.3"), ("1", "0"), ("0.5", "1"), ("3", "1"), ("4", "-0.1")]


@pytest.mark.parametrize("lam, mu", PARAMETERS)
def test_ball_contains_the_independent_value(lam, mu):
    theorem = mathieu_eigenvalue(lam, mu, digits=30)
    assert theorem.a.rad() < 1e-27
    with ctx.workdps(80):
        value = arb(mpmath.nstr(reference.eigenvalue(lam, mu, dps=80), 80))
        assert theorem.a.contains(value)
    assert theorem.beta < reference.eigenvalue(float(lam), float(mu), 1)


@pytest.mark.parametrize("lam", [0, 1, 2, 3])
def test_without_mu_it_is_the_lowest_mathieu_b(lam):
    a = mathieu_eigenvalue(lam).a
    assert abs(float(a) - special.mathieu_b(1, lam**2 / 2)) < 1e-9        # SciPy's accuracy
    assert a < special.mathieu_b(2, lam**2 / 2)          # the lowest odd one with even modes


def test_at_lambda_zero_it_is_one():
    assert mathieu_eigenvalue(0, 5).a.contains(1)


def test_error_of_the_series_of_order_99():
    series = fts.solve(fts.GeneralizedMathieu(), order=99)
    theorem = mathieu_eigenvalue(2, "-0.3", digits=40)
    error = theorem.series_error(series)
    with mpmath.workdps(90), ctx.workdps(80):
        value = series.evaluate("a", lam=2, mu="-0.3", dps=80)
        direct = value - reference.eigenvalue(2, "-0.3", dps=80)
        assert error.contains(arb(mpmath.nstr(direct, 70))) and error.rad() < 1e-38
    assert 3e-5 < error < 4e-5
    fixed = fts.solve(fts.GeneralizedMathieu(mu="-0.3"), order=99)
    assert theorem.series_error(fixed).overlaps(error)


def test_series_of_other_problems_are_refused():
    theorem = mathieu_eigenvalue(1, 0)
    for other in (fts.solve(fts.CubicOscillator(), order=3),
                  fts.solve(fts.GeneralizedMathieu(branch="b2"), order=3),
                  fts.solve(fts.GeneralizedMathieu(mu=1), order=3)):
        with pytest.raises(fts.errors.InputError):
            theorem.series_error(other)


def test_a_problem_too_large_for_the_matrix_is_not_proved(monkeypatch):
    monkeypatch.setattr(mathieu, "LARGEST", 32)
    with pytest.raises(NotProved, match="N = 32"):
        mathieu_eigenvalue(1000)


def test_a_small_matrix_or_a_poor_beta_proves_nothing():
    lam, mu = fmpq(6), fmpq(1)
    with pytest.raises(NotProved, match="not proved"):
        mathieu._prove(lam, mu, 4, 10)
    block = mathieu.hill(fmpq(2), fmpq(0), 16, 16)
    with pytest.raises(NotProved, match="2 eigenvalues below"):
        mathieu._at_most_one_below(arb(20), block, fmpq(2), fmpq(0), 16)
    with pytest.raises(NotProved, match="0 eigenvalues below"):
        mathieu._at_most_one_below(arb(-20), block, fmpq(2), fmpq(0), 16)
    with pytest.raises(NotProved, match="τ = "):
        mathieu._at_most_one_below(arb(2000), block, fmpq(2), fmpq(0), 16)


@pytest.mark.parametrize("arguments", [("x",), (1, "nan"), (1, 0, 0), (1, 0, 2.5),
                                       ("1e400", 0)])
def test_bad_arguments(arguments):
    with pytest.raises(fts.errors.InputError):
        mathieu_eigenvalue(*arguments)


@pytest.mark.parametrize("change", [
    {"a": ["1 0", "1 -30"]}, {"beta": "1 5"}, {"beta": "-1 6"}, {"lam": "3"}, {"mu": "3/10"},
    {"vector": ["1 0"] * 32}, {"vector": ["0 0"] * 32}, {"vector": ["1 0"]},
])
def test_certificate(tmp_path, change):
    path = tmp_path / "a.json"
    theorem = mathieu_eigenvalue(2, "-0.3")
    theorem.save(path)
    assert theorem.a.str(30, radius=False)[:28] in check(path)
    refused(path, lambda data: data.update(change))
