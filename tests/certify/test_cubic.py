"""The bound of the oscillator's series against the closed form by Weierstrass's ℘."""

import mpmath
import pytest
from certify.altering import refused

import ftseries as fts
from ftseries.certify import NotProved, check, cubic_bound
from ftseries.references import cubic, weierstrass

CASES = [("1", "0.5", 24), ("1", "0.5", 6), ("2", "1", 10), ("1", "1.5", 30), ("3", "4", 24),
         ("1", "0.01", 3)]


@pytest.mark.parametrize("a, lam, order", CASES)
def test_the_true_error_is_below_the_bound_and_not_far(a, lam, order):
    theorem = cubic_bound(a, lam, order)
    series = fts.solve(fts.CubicOscillator(a=a), order=order)
    with mpmath.workdps(50):
        omega = cubic.frequency(lam, a, dps=50)
        error = abs(series.evaluate("omega", lam=lam, dps=50) - omega)
        assert error < mpmath.mpf(float(theorem.omega)) < 1000 * error
        for t in ("0", "0.7", "1.9", "12.3"):
            x = series.evaluate("x", mpmath.mpf(t), lam=lam, dps=50)
            gap = abs(x - weierstrass.position(t, lam, a, dps=50))
            assert gap < mpmath.mpf(float(theorem.at(float(t)) * (1 + 1e-12)))


def test_the_bound_falls_with_the_order():
    bounds = [cubic_bound(1, "0.5", order).amplitudes for order in (6, 12, 18, 24)]
    assert all(b < a * 1e-3 for a, b in zip(bounds, bounds[1:]))


@pytest.mark.parametrize("lam, order", [("2.9", 24), ("3", 24), ("4", 40), ("1.5", 1)])
def test_a_poor_series_proves_nothing(lam, order):
    with pytest.raises(NotProved, match="Y = .*Z₁ = .*Z₂ = "):
        cubic_bound(1, lam, order)


@pytest.mark.parametrize("a, lam", [(0, 1), (-1, 1), (1, 0), (1, -1), ("x", 1), (1, float("nan"))])
def test_bad_arguments(a, lam):
    with pytest.raises(fts.errors.InputError):
        cubic_bound(a, lam, 6)


@pytest.mark.parametrize("change", [
    {"radius": "1 -90"}, {"lam": "1/3"}, {"lam": "7"}, {"a": "2"}, {"square": "12"},
    {"modes": ["-1", "1/2"]}, {"radius": "-1 0"},
])
def test_certificate(tmp_path, change):
    path = tmp_path / "x.json"
    cubic_bound(1, "0.5", 24).save(path)
    assert check(path).startswith("Checked. At a = 1, λ = 1/2")
    refused(path, lambda data: data.update(change))
