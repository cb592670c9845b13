"""The closed form on the lemniscate against its equations of motion and an integrator."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ftseries import InputError
from ftseries.references import lemniscate

T = 2 * np.pi * np.arange(1024) / 1024


def derivative(z, times=1):
    """By the discrete Fourier transform over the period 2π."""
    return np.fft.ifft((1j * np.fft.fftfreq(z.shape[-1], 1 / z.shape[-1])) ** times * np.fft.fft(z))


def acceleration(z):
    pair = z - np.roll(z, -1, axis=0)
    pull = pair / abs(pair) * lemniscate.attraction(abs(pair))
    return np.roll(pull, 1, axis=0) - pull


def test_the_closed_form_solves_the_equations_of_motion():
    z = lemniscate.bodies(T)
    assert np.abs(derivative(z, 2) - acceleration(z)).max() < 1e-9      # rounding times 512²


def test_integration_stays_on_it():
    z = lemniscate.bodies(T)
    start = np.concatenate([z[:, 0], derivative(z)[:, 0]])
    path = solve_ivp(lambda _, s: np.concatenate([s[3:], acceleration(s[:3])]), (0, 2 * np.pi),
                     start, "DOP853", t_eval=T[::64], rtol=1e-13, atol=1e-14)
    assert np.abs(path.y[:3] - z[:, ::64]).max() < 1e-9


def test_what_the_authors_found_conserved():
    """Centre of mass, angular momentum, moment of inertia, kinetic energy."""
    z = lemniscate.bodies(T)
    v = derivative(z)
    assert np.abs(z.sum(axis=0)).max() < 1e-14
    assert np.abs((np.conj(z) * v).imag.sum(axis=0)).max() < 1e-11
    assert np.ptp((abs(z) ** 2).sum(axis=0)) < 1e-13
    assert np.ptp((abs(v) ** 2).sum(axis=0)) < 1e-10


def test_choreography_upright_and_in_the_middle():
    z = lemniscate.bodies(T[:1023])
    assert np.abs(np.roll(z[2], -341) - z[1]).max() < 3e-2              # 1024 is not 3 · 341
    assert abs(lemniscate.bodies(0.0)[2]) < 1e-16
    assert z[2].imag.max() > z[2].real.max()


def test_times_refused():
    with pytest.raises(InputError, match="t .*finite"):
        lemniscate.bodies(np.nan)
