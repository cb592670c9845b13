"""Exact frequencies of the gallery's oscillators, against complete elliptic integrals."""

import numpy as np
import pytest
from flint import fmpq
from scipy.special import ellipk, ellipkm1

import ftseries as fts
from ftseries.references import gallery


def nome(m):
    return np.exp(-np.pi * ellipkm1(m) / ellipk(m))


@pytest.mark.parametrize("m", [0.01, 0.1, 0.3])
def test_pendulum_of_largest_angle_2_asin_sqrt_m(m):
    q = nome(m)
    lam2 = 64 * q / (1 + q)**2
    total = sum(float(c) * lam2**k for k, c in enumerate(gallery.pendulum(30)))
    assert total == pytest.approx((np.pi / 2 / ellipk(m))**2, rel=1e-13)       # rounding


@pytest.mark.parametrize("a", [0.1, 0.4, 0.7])
def test_duffing_of_amplitude_a(a):
    m = a**2 / (2 * (1 + a**2))
    omega = np.pi * np.sqrt(1 + a**2) / (2 * ellipk(m))
    q = nome(m)
    lam = a * 2 * np.pi / (np.sqrt(m) * ellipk(m)) * np.sqrt(q) / (1 + q)
    total = sum(float(c) * lam**(2 * k) for k, c in enumerate(gallery.duffing(60)))
    assert total == pytest.approx(omega**2, rel=1e-12)              # rounding of the nome


@pytest.mark.parametrize("equation, exact", [("x'' + sin(x) = 0", gallery.pendulum),
                                             ("x'' + x + x**3 = 0", gallery.duffing)])
def test_the_solver_gives_every_coefficient(equation, exact):
    problem = fts.Equations(equation, frequency="omega", unknowns={
        "x": fts.Field("cos", modes="odd", powers="odd", fixed=(1,)), "omega": fts.Scalar("even")})
    rows = fts.solve(problem, order=60).coefficients["omega"]
    c = [rows[2 * k].get((0, 0), fmpq(0)) for k in range(31)]
    assert [sum((c[j] * c[k - j] for j in range(k + 1)), fmpq(0))
            for k in range(31)] == exact(30)
