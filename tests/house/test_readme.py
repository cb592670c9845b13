"""The README's tour runs as printed and draws an orbit."""

import re
from pathlib import Path

import matplotlib
import numpy as np

README = Path(__file__).parents[2] / "README.md"


def test_tour_runs_and_draws_a_closed_orbit():
    (tour,) = re.findall(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
    matplotlib.use("agg")
    names = {}
    exec(tour, names)
    orbit = names["r1"]
    assert np.ptp(orbit.real) > 0
    # The tour's times run over one period, so the curve closes up to rounding.
    assert abs(orbit[0] - orbit[-1]) < 1e-12 * np.abs(orbit).max()
