"""The limit cycle of van der Pol against published numbers, expansions and its own equation."""

import numpy as np
import pytest

from ftseries import InputError
from ftseries.references.van_der_pol import LimitCycle


def test_published_period_and_amplitude_at_1():
    """T = 6.66328685932313…, a = 2.00861986087484… are quoted to 26 digits in the literature."""
    cycle = LimitCycle(1)
    assert 2 * np.pi / cycle.omega == pytest.approx(6.66328685932313, abs=1e-11)  # the integrator's
    assert cycle.amplitude == pytest.approx(2.00861986087484, abs=1e-11)


@pytest.mark.parametrize("eps", [0.0, 0.01, 0.05, 0.1])
def test_the_textbook_expansions(eps):
    """ω = 1 - ε²/16 + 17ε⁴/3072 + O(ε⁶), a = 2 + ε²/96 + O(ε⁴); what follows is < 1e-2."""
    cycle = LimitCycle(eps)
    assert cycle.omega == pytest.approx(1 - eps**2 / 16 + 17 * eps**4 / 3072,
                                        abs=1e-2 * eps**6 + 1e-11)
    assert cycle.amplitude == pytest.approx(2 + eps**2 / 96, abs=1e-2 * eps**4 + 1e-11)


@pytest.mark.parametrize("eps", [0.5, 2, 10])
def test_it_closes_and_solves_the_equation(eps):
    cycle = LimitCycle(eps)
    tau = np.linspace(0, 2 * np.pi, 40)
    assert np.allclose(cycle(tau + 2 * np.pi), cycle(tau), atol=1e-11)
    step = 1e-4                                     # four differences: the error is some step⁴ ε⁵
    x, v = cycle(tau), cycle.speed(tau)
    shifts = step * np.array([-2, -1, 1, 2])
    weights = np.array([1, -8, 8, -1]) / (12 * step) * cycle.omega
    slope = sum(w * cycle(tau + s) for w, s in zip(weights, shifts))
    bend = sum(w * cycle.speed(tau + s) for w, s in zip(weights, shifts))
    assert np.abs(slope - v).max() < 1e-7 * (1 + eps)**2
    assert np.abs(bend - eps * (1 - x**2) * v + x).max() < 1e-7 * (1 + eps)**3


@pytest.mark.parametrize("eps", [0, 1, 5])
def test_the_phase_and_the_amplitude(eps):
    cycle = LimitCycle(eps)
    tau = 2 * np.pi * np.arange(4096) / 4096
    assert abs(np.mean(cycle(tau) * np.sin(tau))) < 1e-12
    assert np.mean(cycle(tau) * np.cos(tau)) > 0.9
    assert cycle(tau).max() == pytest.approx(cycle.amplitude, abs=1e-5)     # between two samples


@pytest.mark.parametrize("eps", [-1, 21, float("nan"), "a"])
def test_refusals(eps):
    with pytest.raises(InputError, match="eps"):
        LimitCycle(eps)
