"""The explorer of convergence: what it packs, against the series and the known branch points."""

import numpy as np
import pytest

import ftseries as fts
from ftseries import InputError
from ftseries.explorers.convergence import convergence
from ftseries.references import newton


@pytest.fixture(scope="module")
def eight():
    return fts.solve(fts.FigureEight(), order=40)


@pytest.fixture(scope="module")
def explorer(eight):
    return convergence(eight, order=24)


def test_truncated_error_is_the_closure_cut_at_its_order(eight, explorer):
    """S expanded in λ² to order n, from the coefficients themselves, in units of S(0)."""
    view = explorer.view
    _, _, c = eight.expand(eight.problem.condition)
    z = newton.figure_eight_lambda() ** 2
    for order, shown in zip(view.orders, view.plain):
        exact = sum(float(x.p) / float(x.q) * z**k for k, x in enumerate(c[:order // 2 + 1]))
        assert shown == pytest.approx(abs(exact), rel=1e-9, abs=1e-15)


def test_pade_is_better_at_the_highest_orders(explorer):
    view = explorer.view
    assert max(view.resummed[-3:]) < 0.05 * min(view.plain[-3:])


def test_poles_gather_beyond_the_branch_points(explorer):
    """The branch points are λ² = 2.1712 ± 4.3727 i; no pole but a defect lies well inside."""
    view = explorer.view
    poles = np.array(view.poles[-1]) @ [1, 1j]
    zeros = np.array(view.zeros[-1]) @ [1, 1j]
    genuine = [p for p in poles if np.abs(zeros - p).min() > 1e-3 * abs(p)]
    assert min(map(abs, genuine)) > 0.95 * abs(2.17118419271 + 4.37266142208j)
    assert view.radius == pytest.approx(abs(2.17118419271 + 4.37266142208j), rel=0.05)


def test_controls_and_picture(explorer):
    assert explorer.controls["order"].value == 24
    assert explorer.picture()[:4] == b"\x89PNG"
    assert "order 24" in explorer.alt


def test_refusals(eight):
    for wrong in (None, fts.solve(fts.CubicOscillator(), order=30), eight.truncate(20),
                  fts.solve(fts.FigureEight(), order=30, arithmetic="float")):
        with pytest.raises(InputError, match="exact solution of FigureEight"):
            convergence(wrong)
    with pytest.raises(InputError, match="orders 8 to 40"):
        convergence(eight, order=60)
