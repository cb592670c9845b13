"""The picture of "The idea": every curve has its values."""

import numpy as np
import pytest
from matplotlib.figure import Figure
from scipy.special import ellipk

import ftseries as fts
from ftseries.figures import idea


class Duffing(fts.Problem):
    unknowns = {"x": fts.Field("cos", fixed=(1,)), "omega": fts.Scalar()}
    seed = {"x": [{}, {1: 1}], "omega": [1]}
    frequency = "omega"

    def equations(self, lam, x, omega):
        return {"Duffing": omega**2 * x.diff(2) + x + x**3}


@pytest.fixture(scope="module")
def sol():
    return fts.solve(Duffing(), order=13)


@pytest.fixture
def ax():
    return Figure().add_subplot()


def test_error_of_the_period_falls_like_the_first_order_left_out(sol, ax):
    def exact(start):
        return 4 / np.sqrt(1 + start**2) * ellipk(start**2 / (2 * (1 + start**2)))

    idea.period_error(ax, sol, exact, np.array([0.1, 0.2]), orders=[2, 4])
    for line, power in zip(ax.lines, [4, 6], strict=True):
        small, large = line.get_ydata()
        # The next term changes the ratio 2^power by a few percent at λ = 0.2.
        assert large / small == pytest.approx(2**power, rel=0.1)
