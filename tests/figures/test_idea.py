"""Pictures of "The idea": every coefficient has its place, every curve its values."""

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


def test_triangle_marks_each_place_once_and_none_above_the_diagonal(sol, ax):
    idea.coefficient_triangle(ax, sol, "x", 9)
    discs, crosses = (set(map(tuple, marks.get_offsets())) for marks in ax.collections)
    assert discs | crosses == {(m, n) for m in range(10) for n in range(m + 1)}
    # All with odd n, m and n > 1, and A_11.
    assert discs == {(1, 1)} | {(m, n) for m in range(3, 10, 2) for n in range(3, m + 1, 2)}
    assert not discs & crosses


def test_disc_grows_with_the_coefficient(sol, ax):
    idea.coefficient_triangle(ax, sol, "x", 9)
    places, areas = ax.collections[0].get_offsets(), ax.collections[0].get_sizes()
    values = [abs(float(sol.coefficient("x", int(n), int(m)))) for m, n in places]
    assert (np.argsort(values) == np.argsort(areas)).all()


def test_orders_that_the_solution_does_not_have(sol, ax):
    with pytest.raises(fts.InputError, match=f"order={sol.order + 1}: give a whole number from 0"):
        idea.coefficient_triangle(ax, sol, "x", sol.order + 1)


def test_error_of_the_period_falls_like_the_first_order_left_out(sol, ax):
    def exact(start):
        return 4 / np.sqrt(1 + start**2) * ellipk(start**2 / (2 * (1 + start**2)))

    idea.period_error(ax, sol, exact, np.array([0.1, 0.2]), orders=[2, 4])
    for line, power in zip(ax.lines, [4, 6], strict=True):
        small, large = line.get_ydata()
        # The next term changes the ratio 2^power by a few percent at λ = 0.2.
        assert large / small == pytest.approx(2**power, rel=0.1)
