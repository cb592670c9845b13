"""The guard: residuals at single phases, and faults that are planted in the solver."""

import numpy as np
import pytest
from flint import arb, fmpq

import ftseries as fts
from ftseries import solver
from ftseries.phases import Phases, unsatisfied
from ftseries.precision import working
from ftseries.stages import Stages

PROBLEMS = [fts.CubicOscillator(a=1), fts.FigureEight(), fts.GeneralizedMathieu()]
ALL = [(p, a) for p in PROBLEMS for a in ("exact", "float", "ball")
       if a == "exact" or not p.parameters]


@pytest.mark.parametrize("problem, arithmetic", ALL)
def test_an_altered_coefficient_is_seen(problem, arithmetic):
    """Any one of them, by a part in 10⁶, and the equation and order are named."""
    sol = fts.solve(problem, 9, arithmetic)
    assert unsatisfied(problem, arithmetic, sol.coefficients) is None
    seen = 0
    for name, rows in sol.coefficients.items():
        for m, row in enumerate(rows[len(problem.seed[name]):], len(problem.seed[name])):
            for mode, value in row.items():
                row[mode] = value * fmpq(1000001, 10**6) if arithmetic != "float" else \
                    value * 1.000001
                if defect := unsatisfied(problem, arithmetic, sol.coefficients, [1, 1]):
                    assert defect.order >= m
                    seen += 1
                else:               # order 9 alone has coordinates that only order 10 settles
                    assert m >= 8
                row[mode] = value
    assert seen > 5


class TestPlantedFaults:
    """A coefficient altered after it was settled; a row that is skipped."""

    @pytest.fixture(params=["exact", "float", "ball"])
    def arithmetic(self, request):
        return request.param

    def test_a_coefficient_altered_after_it_was_settled(self, monkeypatch, arithmetic):
        """Behind the back of the stages' own check, at a high order."""
        run = Stages.run

        def altered(self, bar, fresh=True):
            run(self, bar, fresh)
            if self.order >= 14 or not fresh:
                row = self.known["r"][14]
                row[0, 2] = row[0, 2] + (fmpq(1, 10**9) if self.ring.exact else 1e-5)

        monkeypatch.setattr(Stages, "run", altered)
        with pytest.raises(fts.FaultError if arithmetic != "float" else fts.SolveError,
                           match="equation .E3.* order 14 of λ"):
            fts.solve(fts.FigureEight(), 16, arithmetic)

    def test_a_row_that_is_skipped(self, monkeypatch, arithmetic):
        residual = Stages.residual

        def without(self, k, ahead=None):
            return {row: c for row, c in residual(self, k, ahead).items() if k != 14 or row[2] != 4}

        monkeypatch.setattr(Stages, "residual", without)
        with pytest.raises(fts.FaultError, match="order 14 of λ, mode cos 4τ.*fault of ftseries"):
            fts.solve(fts.FigureEight(), 14, arithmetic)

    def test_the_guard_cannot_be_left_out(self, monkeypatch):
        """Every solve asks it, of whatever order."""
        asked = []
        monkeypatch.setattr(solver, "unsatisfied", lambda *a: asked.append(a))
        for order in (0, 1, 5):
            fts.solve(fts.CubicOscillator(a=1), order)
        assert len(asked) == 3


@pytest.mark.parametrize("order", [3, 30])
def test_a_fault_that_is_tiny(order):
    """Exact coefficients are held to 2^-128 of the terms, not to rounding."""
    sol = fts.solve(fts.FigureEight(), order)
    sol.coefficients["phi"][3][0, 3] += fmpq(1, 10**35)
    assert unsatisfied(sol.problem, "exact", sol.coefficients).order == 3


class TestFunctions:
    """What the equations do, against NumPy at a number λ."""

    lam = 0.03

    def pair(self, make):
        """A function of (u, lam) by phases, and by NumPy on τ = 1 + 2πj/12."""
        at = Phases(40, 12, ())
        u = at.polynomial([{(0, 0): arb(1)}, {(0, 1): arb(2), (1, 2): arb(-1)}, {(1, 3): arb(3)}])
        with working(bits=128, terms=41):
            values = make(u, at.lam).values
            ours = [float(sum((c * arb(self.lam)**k for k, c in enumerate(v.coeffs())), arb(0)))
                    for v in values]
        return np.array(ours), 1 + 2 * np.pi * np.arange(12) / 12

    def u(self, tau):
        lam = self.lam
        return 1 + lam * (2 * np.cos(tau) - np.sin(2 * tau)) + 3 * lam**2 * np.sin(3 * tau)

    @pytest.mark.parametrize("make, truth", [
        (lambda u, lam: u * u - 3, lambda u, tau: u(tau)**2 - 3),
        (lambda u, lam: 2 / u + lam, lambda u, tau: 2 / u(tau) + 0.03),
        (lambda u, lam: u**fmpq(-3, 2), lambda u, tau: u(tau)**-1.5),
        (lambda u, lam: (u - 1).sin() * (u - 1).cos(),
         lambda u, tau: np.sin(u(tau) - 1) * np.cos(u(tau) - 1)),
        (lambda u, lam: (u - 1).exp(), lambda u, tau: np.exp(u(tau) - 1)),
        (lambda u, lam: u.shift(fmpq(1, 4)), lambda u, tau: u(tau + np.pi / 2)),
        (lambda u, lam: u.neighbours(3),
         lambda u, tau: u(tau + 2 * np.pi / 3) + u(tau - 2 * np.pi / 3)),
    ])
    def test_values(self, make, truth):
        ours, tau = self.pair(make)
        assert np.abs(ours - truth(self.u, tau)).max() < 1e-14

    @pytest.mark.parametrize("make", [
        lambda u, lam: u * u * lam, lambda u, lam: u**fmpq(1, 3), lambda u, lam: u**-2,
        lambda u, lam: (u - 1).sin() + (u - 1).cos(), lambda u, lam: ((u - 1) * lam).exp(),
        lambda u, lam: u.shift(fmpq(5, 12)), lambda u, lam: u.neighbours(4)])
    def test_derivatives_by_a_central_difference(self, make):
        """Error h²/6 f''' + rounding 1e-16/h with h = 1e-5: some 1e-10."""
        ours, tau = self.pair(lambda u, lam: make(u, lam).diff())

        class Shifted(TestFunctions):
            def pair(self, make, by):
                at = Phases(40, 12, ())
                at.tau = [t + arb(by) for t in at.tau]
                u = at.polynomial([{(0, 0): arb(1)}, {(0, 1): arb(2), (1, 2): arb(-1)},
                                   {(1, 3): arb(3)}])
                with working(bits=128, terms=41):
                    return np.array([float(sum((c * arb(self.lam)**k for k, c in
                                                enumerate(v.coeffs())), arb(0)))
                                     for v in make(u, at.lam).values])
        h = 1e-5
        ends = [Shifted().pair(make, sign * h) for sign in (1, -1)]
        assert np.abs(ours - (ends[0] - ends[1]) / (2 * h)).max() < 1e-9


SLOW = {"x": fts.Field("cos", fixed=(1,)), "y": fts.Field("cos"), "omega": fts.Scalar()}
CANCELLING = [  # in floats the terms of some orders cancel to rounding, or to nothing
    (["x'' + x + 5/4*y**2", "y'' = lam**2*(lam/3 - y)"], 1 / 3),
    (["x'' + x - y**2", "y'' = lam**3*(-lam**2/3 - y)"], None),
    (["x'' + x + x*y/3", "y'' = lam**5*(lam**2 - y)"], None),
    (["x'' + x + 5/4*y**2 - 2*z*x", "y'' = lam*(-2*lam - y)", "z'' = lam*(y**2 - z)"], -2.0),
]


@pytest.mark.parametrize("equations, first", CANCELLING)
def test_rounding_is_no_fault(equations, first):
    """Where all terms of an order cancel, what floats leave is measured against these terms."""
    unknowns = SLOW | ({"z": fts.Field("cos")} if len(equations) == 3 else {})
    seed = {"x": "lam*cos(omega*t)", "y": "0", "omega": "1"} | (
        {"z": "0"} if len(equations) == 3 else {})
    problem = fts.Equations(equations, unknowns=unknowns, seed=seed, frequency="omega")
    exact, floats = (fts.solve(problem, 10, arithmetic) for arithmetic in ("exact", "float"))
    for name in unknowns:
        for m, row in enumerate(exact.coefficients[name]):
            for mode, c in row.items():
                other = floats.coefficients[name][m].get(mode, 0.0)
                assert other == pytest.approx(float(c.p) / float(c.q), rel=1e-9)
    if first is not None:
        assert floats.coefficient("y", 0, 1) == pytest.approx(first, rel=1e-15)
