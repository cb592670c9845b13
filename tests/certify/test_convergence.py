"""The theorem that the series of the eight converges: it holds where it should, nowhere else."""

import copy
import re
from dataclasses import replace

import numpy as np
import pytest
from certify.altering import REFUSED, refused, set_at
from flint import arb

import ftseries as fts
from ftseries.certify import NotProved, __main__, check, prove_convergence, prove_eight
from ftseries.errors import InputError
from ftseries.series import cos, sin
from ftseries.solution import Solution

LAMBDA_0 = "2.07568390884909"


@pytest.fixture(scope="module")
def series():
    return fts.solve(fts.FigureEight(), order=300, arithmetic="float")


@pytest.fixture(scope="module")
def physical(series):
    return prove_convergence(series, lam="2.076")


@pytest.fixture(scope="module")
def small(series):
    return prove_convergence(series.truncate(60), lam=1, modes=20)


def moved(series, name, m, mode, change):
    """The series with one coefficient changed."""
    coefficients = copy.deepcopy(series.coefficients)
    coefficients[name][m][mode] = coefficients[name][m].get(mode, 0.0) + change
    return Solution(series.problem, "float", series.order, coefficients)


def test_the_disc_contains_the_physical_value(physical):
    assert arb(physical.lam) > arb(LAMBDA_0)
    assert physical.radius < 1e-6 < physical.uniqueness
    eight = prove_eight(fts.solve(fts.FigureEight(), order=6).refine())
    assert physical.identify(eight) < physical.uniqueness
    assert "converge absolutely for all |λ| ≤ 2.076" in str(physical)


def test_another_orbit_is_not_the_sum(physical, small):
    eight = prove_eight(fts.solve(fts.FigureEight(), order=6).refine())
    with pytest.raises(NotProved, match="λ₀ = .* is not below 1"):
        small.identify(eight)
    with pytest.raises(NotProved, match="apart"):
        physical.identify(replace(eight, center=eight.center | {2: eight.center[2] + 1e-4}))
    with pytest.raises(NotProved, match="apart"):
        physical.identify(replace(eight, lam=eight.lam - 1e-3))


@pytest.mark.parametrize("name", ["r", "phi"])
def test_the_exact_coefficients_obey_the_bound(physical, name):
    """Solved in rational numbers, by other code than the float series."""
    exact = fts.solve(fts.FigureEight(), order=40)
    known = sum(abs(c) * 2.076**m for row in exact.table(name).values() for m, c in enumerate(row))
    assert 0.97 * float(physical.norms[name]) < known < float(physical.norms[name])


@pytest.mark.parametrize("lam, order", [("0.8", 10), ("1.5", 30), (LAMBDA_0, 30), (LAMBDA_0, 61)])
@pytest.mark.parametrize("name", ["r", "phi"])
def test_the_error_is_below_the_proved_tail(physical, series, name, lam, order):
    t = np.linspace(0, 2 * np.pi, 50)
    short = series.truncate(order)
    error = abs(series.evaluate(name, t, lam=float(lam)) - short.evaluate(name, t, lam=float(lam)))
    tail = float(physical.tail(name, order, lam))
    assert error.max() < tail < 30 * error.max() + 3e-6


def test_tail_outside_of_the_disc(small):
    with pytest.raises(InputError, match="0 ≤ λ ≤ 1"):
        small.tail("r", 10, "1.1")
    with pytest.raises(InputError, match="unknown"):
        small.tail("x", 10, "0.5")


@pytest.mark.parametrize("name, m, mode, change", [
    ("r", 2, (0, 2), 1e-2), ("r", 0, (0, 0), 1e-2), ("phi", 1, (0, 1), 1e-2),
    ("phi", 7, (0, 5), 1e-3), ("phi", 1, (0, 3), 1e-2), ("r", 1, (0, 0), 1e-2),
    ("r", 4, (0, 3), 1e-2), ("r", 40, (0, 4), float("nan")),
])
def test_perturbed_coefficients_fail(series, name, m, mode, change):
    with pytest.raises(NotProved, match="not proved: "):
        prove_convergence(moved(series.truncate(60), name, m, mode, change), lam=1, modes=20)


def test_a_small_perturbation_is_within_the_radius(series, small):
    near = prove_convergence(moved(series.truncate(60), "phi", 5, (0, 3), 1e-8), lam=1, modes=20)
    assert near.radius > 1e-9 > small.radius


@pytest.mark.parametrize("lam", ["2.2", "2.21", "2.5", "5"])
def test_beyond_the_radius_of_convergence_fails(series, lam):
    with pytest.raises(NotProved, match="not proved: "):
        prove_convergence(series.truncate(120), lam=lam, modes=30)


def test_newtons_method_replaces_missing_orders(series):
    """From a series so short that it proves nothing by itself."""
    with pytest.raises(NotProved, match="not proved: "):
        prove_convergence(series.truncate(20), lam="1.5", modes=25)
    longer = prove_convergence(series.truncate(20), lam="1.5", modes=25, orders=45)
    assert longer.radius < 1e-6 and longer.orders == 45
    plain = prove_convergence(series.truncate(88), lam="1.5", modes=25)
    for name in ("r", "phi"):
        assert abs(longer.norms[name] - plain.norms[name]) < 1e-5


@pytest.mark.parametrize("order, modes", [(300, 12), (60, 40), (0, 10)])
def test_too_few_modes_or_orders_fail(series, order, modes):
    with pytest.raises(NotProved, match="not proved: "):
        prove_convergence(series.truncate(order), lam="2.076", modes=modes)


class OtherForce(fts.FigureEight):
    """Bodies that attract each other with the inverse cube of the distance."""

    def equations(self, lam, r, phi):
        c, s = cos(phi), sin(phi)
        force = r**-3
        x, y = (force * c).neighbours(), (force * s).neighbours()
        return {
            "x": r.diff(2) - r * phi.diff()**2 + (2 * force - (c * x + s * y)) / 3,
            "y": r * phi.diff(2) + 2 * r.diff() * phi.diff() + (s * x - c * y) / 3,
        }


def test_the_solution_of_other_equations_fails():
    other = fts.solve(OtherForce(), order=40, arithmetic="float")
    with pytest.raises(InputError, match="not a series of the figure eight"):
        prove_convergence(other)
    mislabelled = Solution(fts.FigureEight(), "float", other.order, other.coefficients)
    with pytest.raises(NotProved, match="not proved: .* = "):
        prove_convergence(mislabelled, lam="0.5", modes=20)


@pytest.mark.parametrize("arguments, message", [
    ({"lam": 0}, "above 0"), ({"lam": "x"}, "not a number"), ({"lam": -1}, "above 0"),
    ({"lam": float("nan")}, "not a number"), ({"modes": 2}, "modes"), ({"modes": 9.5}, "modes"),
    ({"orders": 0}, "orders"), ({"orders": "all"}, "orders"),
])
def test_bad_arguments(series, arguments, message):
    with pytest.raises(InputError, match=message):
        prove_convergence(series.truncate(20), **arguments)


@pytest.mark.parametrize("other", [
    lambda series: fts.solve(fts.CubicOscillator(), order=4), lambda series: series.resum()])
def test_other_input(series, other):
    with pytest.raises(InputError, match="not a series of the figure eight"):
        prove_convergence(other(series.truncate(20)))


# --- certificates

@pytest.fixture
def saved(small, tmp_path):
    path = tmp_path / "convergence.json"
    small.save(path)
    return path


def test_the_physical_certificate_is_checked(physical, tmp_path, capsys):
    path = tmp_path / "physical.json"
    physical.save(path)
    assert __main__.main([path]) == 0
    assert "converge absolutely for all |λ| ≤ 2.076" in capsys.readouterr().out


def test_a_weaker_claim_is_still_true_and_a_stronger_one_is_refused(small, tmp_path):
    replace(small, uniqueness=small.uniqueness / 2).save(tmp_path / "weak.json")
    assert check(tmp_path / "weak.json").startswith("Checked")
    replace(small, radius=small.radius * 0.9).save(tmp_path / "narrow.json")
    with pytest.raises(NotProved, match="p.r. ≤ 0"):
        check(tmp_path / "narrow.json")


ALTERED = {
    "center": set_at("center", 2, 3, value=2**50),
    "order 0": set_at("center", 0, 1, value=2**60 + 2**50),
    "center mode": set_at("center", 3, 0, value=3),
    "root": set_at("root", 0, 1, value=-2**60),
    "root mode": set_at("root", 1, 0, value=1),
    "inverse": set_at("inverse", 1, 1, value=[2**30]),
    "inverse size": lambda data: data["inverse"].pop(),
    "larger disc": set_at("lam", value="1.1"),
    "smaller disc": set_at("lam", value="0.9"),
    "whole plane": set_at("lam", value="2.3"),
    "modes": set_at("modes", value=8),
    "orders": set_at("orders", value=10),
    "uniqueness": set_at("uniqueness", value="1 -5"),
    "larger ball": lambda data: data.update(largest="1 -3", uniqueness="1 -3"),
    "sum of r": set_at("norms", "r", value="1 0"),
    "sum of phi": set_at("norms", "phi", value="1 0"),
    "nan": set_at("lam", value="nan"),
}


@pytest.mark.parametrize("name", ALTERED)
def test_altered_certificate_with_a_fresh_checksum_is_refused(saved, name, capsys):
    refused(saved, ALTERED[name])
    assert __main__.main([saved, saved]) == 2
    assert re.search(REFUSED, capsys.readouterr().err)


def test_the_command_without_a_file(capsys):
    assert __main__.main([]) == 2 and "usage" in capsys.readouterr().err
