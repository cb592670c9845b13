"""The theorem on the eight: it holds where it should, and nowhere else."""

from dataclasses import replace
from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
from certify.altering import refused, set_at
from flint import arb, ctx

import ftseries as fts
from ftseries.certify import NotProved, check, prove_eight
from ftseries.references import newton
from ftseries.refine import Orbit

DPS = 30                                     # the balls are 1e-15 wide


def contains(ball, number):
    with ctx.workdps(DPS):
        return ball.contains(arb(mpmath.nstr(number, DPS)))


@pytest.fixture(scope="module")
def orbit():
    return fts.solve(fts.FigureEight(), order=6).refine()


@pytest.fixture(scope="module")
def theorem(orbit):
    return prove_eight(orbit)


def moved(orbit, name="r", **change):
    """The orbit with some coefficients changed."""
    modes = {tuple(int(i) for i in key[1:].split("_")): c for key, c in change.items()}
    coefficients = {k: dict(v) for k, v in orbit.coefficients.items()}
    for mode, c in modes.items():
        coefficients[name][mode] = coefficients[name].get(mode, 0.0) + c
    return Orbit(orbit.problem, orbit.lam, coefficients, 0.0, 0)


def test_balls_contain_an_independent_integration(theorem):
    positions, velocities = newton.figure_eight_state(dps=DPS)
    for balls, values in ((theorem.positions, positions), (theorem.velocities, velocities)):
        for ball, value in zip(balls, values, strict=True):
            assert contains(ball.real, value.real) and contains(ball.imag, value.imag)
            assert ball.real.rad() < 1e-13 and ball.imag.rad() < 1e-13
    assert contains(theorem.lam, newton.figure_eight_lambda(dps=DPS))
    assert theorem.lam.rad() < 1e-14


def test_the_series_of_order_400_is_within_1e_12():
    theorem = prove_eight(fts.solve(fts.FigureEight(), order=400, arithmetic="float"))
    assert theorem.radius + theorem.distance < 1e-12
    assert contains(theorem.lam, newton.figure_eight_lambda(dps=DPS))


def test_the_padé_sum_is_proved_too():
    theorem = prove_eight(fts.solve(fts.FigureEight(), order=80, arithmetic="float").resum())
    assert contains(theorem.lam, newton.figure_eight_lambda(dps=DPS))


@pytest.mark.parametrize("size", [1e-12, 1e-9])
def test_a_small_perturbation_is_within_the_radius(orbit, theorem, size):
    near = prove_eight(moved(orbit, _0_2=size))
    assert near.radius > size / 10 and near.radius > theorem.radius
    assert near.lam.overlaps(theorem.lam) and near.lam.rad() > theorem.lam.rad()


@pytest.mark.parametrize("change, message", [
    ({"_0_2": 1e-3}, "Y = .*Z₁ = .*Z₂"),                 # perturbed
    ({"_0_2": 0.3}, "not proved"),
    ({"_1_1": 1e-3}, "not proved"),                       # a sine: not symmetric under reversal
    ({"_0_1": 1e-3}, "not proved"),                       # an odd mode of r
    ({"_1_2": 1e-4}, "symmetric part"),                   # cut off by the projection
    ({"name": "phi", "_0_2": 1e-3}, "not proved"),
    ({"name": "phi", "_0_1": 1e-2}, "Y = "),              # λ moved
    ({"_0_2": float("nan")}, "not proved"),
])
def test_perturbed_inputs_and_wrong_symmetries_fail(orbit, change, message):
    with pytest.raises(NotProved, match=message):
        prove_eight(moved(orbit, **change))


@pytest.mark.parametrize("modes", [4, 10, 20])
def test_too_few_modes_fail(orbit, modes):
    with pytest.raises(NotProved, match="not proved: .* = "):
        prove_eight(orbit, modes=modes)


@pytest.mark.parametrize("lam", [1.0, 2.0, 2.0757])
def test_a_lambda_that_is_not_the_zero_fails(lam):
    series = fts.solve(fts.FigureEight(), order=120, arithmetic="float")
    with pytest.raises(NotProved, match="Y = .*Z₁ = .*Z₂ = "):
        prove_eight(series, lam=lam)


def test_the_orbit_at_lambda_2_is_no_solution_of_newtons_equations():
    with pytest.raises(NotProved, match="Y = .*Z₁ = .*Z₂ = "):
        prove_eight(fts.solve(fts.FigureEight(), order=30).refine(2.0))


def test_another_curve_is_no_eight_of_newtons(orbit):
    """From the shape of a lemniscate."""
    def evaluate(name, t, lam):
        x = np.cos(t) / (1 + np.sin(t)**2)
        z = 1 + x * np.sin(t) + 1j * x
        return np.abs(z) if name == "r" else np.angle(z)

    with pytest.raises(NotProved, match="not proved: .* = "):
        prove_eight(SimpleNamespace(problem=orbit.problem, lam=orbit.lam, evaluate=evaluate))


@pytest.mark.parametrize("arguments, message", [
    ({"nu": 1}, "above 1"), ({"nu": "x"}, "not a number"), ({"modes": 0}, "modes"),
    ({"modes": 2.5}, "modes"), ({"lam": 2.0}, "own λ"),
])
def test_bad_arguments(orbit, arguments, message):
    with pytest.raises(fts.errors.InputError, match=message):
        prove_eight(orbit, **arguments)


def test_another_problem():
    with pytest.raises(fts.errors.InputError, match="not a figure eight"):
        prove_eight(fts.solve(fts.CubicOscillator(), order=4))


# --- certificates

@pytest.fixture
def saved(theorem, tmp_path):
    path = tmp_path / "eight.json"
    theorem.save(path)
    return path


def test_certificate_is_checked(saved, theorem):
    assert theorem.lam.str(25) in check(saved)


def test_a_weaker_claim_is_still_true_and_a_stronger_one_is_refused(theorem, tmp_path):
    replace(theorem, uniqueness=theorem.uniqueness / 2).save(tmp_path / "weak.json")
    assert check(tmp_path / "weak.json").startswith("Checked")
    replace(theorem, radius=theorem.radius * 0.99).save(tmp_path / "narrow.json")
    with pytest.raises(NotProved, match="p.r. ≤ 0"):
        check(tmp_path / "narrow.json")


ALTERED = {
    "center": set_at("center", 5, 1, value="1 -20"),
    "center mode": set_at("center", 2, 0, value=3),
    "root": set_at("root", 0, 1, value="-1 0"),
    "inverse": set_at("inverse", 0, 0, value="1 0"),
    "inverse size": lambda data: data["inverse"].pop(),
    "nu": set_at("nu", value="1.2"),
    "nu of 1": set_at("nu", value="1"),
    "modes": set_at("modes", value=80),
    "uniqueness": set_at("uniqueness", value="1 -5"),
    "larger ball": lambda data: data.update(largest="1 -5", uniqueness="1 -5"),
    "lambda": lambda data: data.update(lam=[data["lam"][0], "1 -60"]),
    "position": set_at("positions", 0, 1, 0, value="1 0"),
    "velocity": set_at("velocities", 2, 0, 1, value="1 -90"),
    "no body": lambda data: data.update(positions=[]),
    "nan": lambda data: data.update(nu="nan"),
}


@pytest.mark.parametrize("name", ALTERED)
def test_altered_certificate_with_a_fresh_checksum_is_refused(saved, name):
    refused(saved, ALTERED[name])


def test_eights_of_other_forces_are_not_proved():
    """Their orbits solve other equations than those the theorem is about."""
    orbit = fts.solve(fts.FigureEight(), 6).refine().refine(fts.FigureEight("9/10"))
    with pytest.raises(fts.errors.InputError, match="under gravitation"):
        prove_eight(orbit)
