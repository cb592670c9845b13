"""js/elliptic.js against the exact oscillator of ftseries.references."""

import numpy as np
from mpmath import mpf

from ftseries import explorers
from ftseries.references import cubic

END = 6.0


def test_exact_motion(run_javascript):
    """Also near λ = 3, where the motion slows down on the top: rounding costs some digits there."""
    random = np.random.default_rng(5)
    lam = np.concatenate([random.uniform(0, 3, 200), [0.0, 1e-9, 2.999, 2.9999999]])
    t = random.uniform(0, END, lam.size)
    found = run_javascript("output = input.map(([t, lam]) => [position(t, lam), frequency(lam)]);",
                           np.transpose([t, lam]).tolist(), "elliptic.js")
    bits = [(mpf(t), mpf(lam)) for t, lam in zip(t.tolist(), lam.tolist(), strict=True)]
    exact = [(float(cubic.position(*place, dps=30)), float(cubic.frequency(place[1], dps=30)))
             for place in bits]                        # an mpf is its bits, a float its decimal
    assert np.abs(np.subtract(found, exact)).max() < 1e-12


def test_at_the_separatrix_the_particle_rests(run_javascript):
    assert run_javascript("output = [position(0, 3), position(4, 3), frequency(3)];", None,
                          "elliptic.js") == [2, 2, 0]


def test_potential_energy_speed(run_javascript):
    lam = np.linspace(0, 3.5, 8)
    found = np.array(run_javascript("""
        output = input.map((lam) =>
          [potential(-1.3, lam), energy(lam), top(lam), speed(-1, lam, energy(lam))]);
        """, lam.tolist(), "elliptic.js"))
    V, E, top, speed = found.T
    assert np.allclose(V, cubic.potential(-1.3, lam), rtol=1e-14)
    assert np.allclose(E, cubic.energy(lam), rtol=1e-14)
    assert np.allclose(speed**2, cubic.polynomial(-1.0, lam), rtol=1e-13)
    h = 1e-4        # V is cubic: the central difference is its slope and -2h²
    slope = (cubic.potential(top + h, lam) - cubic.potential(top - h, lam)) / (2 * h)
    assert np.abs(slope + 2 * h**2).max() < 1e-9


def test_controls():
    controls = explorers.cubic(order=24, lam=0.5, stored=30).controls
    assert list(controls) == ["λ", "order", "t", "Play"]
    assert (controls["λ"].max, controls["order"].max, controls["t"].max) == (3.5, 30, END)
