"""Precision is global in FLINT and mpmath: threads side by side get right digits all the same."""

import multiprocessing
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, ctx, fmpq

import ftseries as fts
from ftseries import analysis, certify, phases, resum
from ftseries.precision import working
from ftseries.references import (
    cubic,
    cubic_taylor,
    floquet,
    gallery,
    mathieu,
    newton,
    three_bodies,
    weierstrass,
)

CUBIC = fts.solve(fts.CubicOscillator(a=1), 12)
BALLS = fts.solve(fts.CubicOscillator(a=1), 12, "ball", precision=300)
SERIES = [fmpq(2, 3)**k * (k + 1) for k in range(24)]


def state():
    return ctx.prec, ctx.cap, mpmath.mp.prec


@pytest.fixture(autouse=True)
def unchanged():
    """Every test leaves the precision as it was, and switches threads often."""
    before, interval = state(), sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    yield
    sys.setswitchinterval(interval)
    assert state() == before


def duffing(factor):
    return fts.Equations(f"x'' + x + ({factor})*x**3 = 0", frequency="omega", unknowns={
        "x": fts.Field("cos", fixed=(1,)), "omega": fts.Scalar()})


def bits(solution):
    """Of the poorest coefficient of ω."""
    return min(c.rel_accuracy_bits() for row in solution.coefficients["omega"]
               for c in row.values())


def shown(value):
    """Something that compares, bit by bit."""
    if isinstance(value, arb):
        return certify.certificate.ball(value)
    if isinstance(value, (list, tuple, np.ndarray, mpmath.matrix)):
        return [shown(x) for x in value]
    if isinstance(value, fts.Solution):
        return shown(value.coefficient("omega", 12))
    return getattr(value, "_mpf_", getattr(value, "_mpc_", None)) or repr(value)


# --- whatever depends on the precision waits for its turn, or does not depend on it

PUBLIC = {
    "solve exactly": lambda: fts.solve(fts.CubicOscillator(a=1), 12),
    "solve in balls": lambda: fts.solve(fts.CubicOscillator(a=1), 12, "ball", precision=200),
    "solve in floats": lambda: fts.solve(fts.CubicOscillator(a=1), 12, "float"),
    "equations": lambda: fts.solve(duffing(2), 12),
    "equations that need roots": lambda: fts.solve(duffing("2/3"), 12),
    "the guard": lambda: phases.unsatisfied(CUBIC.problem, "exact", CUBIC.coefficients),
    "evaluate": lambda: CUBIC.evaluate("x", 0.3, lam=0.5),
    "evaluate to 50 digits": lambda: CUBIC.evaluate("x", "0.3", lam="0.5", dps=50),
    "evaluate with SymPy": lambda: CUBIC.evaluate("x", sp.sqrt(2), lam=sp.Rational(1, 2), dps=50),
    "coefficient": lambda: CUBIC.coefficient("omega", 12),
    "coefficient of balls": lambda: BALLS.coefficient("omega", 12),
    "evaluate balls": lambda: BALLS.evaluate("omega", lam=0.5),
    "resum": lambda: CUBIC.resum().evaluate("omega", lam=0.5),
    "at a phase": lambda: resum.at_phase(CUBIC, "x", 0.3),
    "expand": lambda: BALLS.expand(lambda lam, x, omega: x * omega),
    "radius": lambda: fts.solve(duffing(1), 40).radius_of_convergence("omega"),
    "pade": lambda: analysis.pade(SERIES)(0.3),
    "poles": lambda: analysis.pade(SERIES).poles(),
    "root test": lambda: analysis.root_test(SERIES),
    "domb_sykes": lambda: analysis.domb_sykes(SERIES),
    "singularities": lambda: analysis.nearest_singularities(SERIES),
    "compose": lambda: analysis.compose(SERIES, [0, 1] + [fmpq(1, 7)] * 22),
    "revert": lambda: analysis.revert([0.0, 1.0] + [0.3] * 12),
    "cubic": lambda: cubic.frequency("0.5", dps=40),
    "cubic series": lambda: cubic_taylor.frequency_taylor(12),
    "weierstrass": lambda: weierstrass.position("0.3", "0.5"),
    "mathieu": lambda: mathieu.sine_coefficients(1, "0.1", dps=30),
    "floquet": lambda: floquet.hill_monodromy("0.25", 0, dps=25),
    "newton": lambda: newton.figure_eight_lambda(25),
    "three bodies": lambda: three_bodies.integrate_taylor("0.1", *newton.published_state(), 25),
    "gallery": lambda: gallery.duffing(20),
    "turn": gallery.duffing_turn,
    "eigenvalue": lambda: certify.mathieu_eigenvalue(2, "-0.3", digits=60).a,
    "bound": lambda: certify.cubic_bound(1, "0.5", 12).at(3),
    "digits": lambda: str(certify.digits(20)),
    "thousand digits": lambda: str(certify.thousand_digits()),
    "theorem": lambda: str(certify.prove_eight(fts.solve(fts.FigureEight(), 6).refine(),
                                               modes=60, nu="1.001")),
    "no first steps": lambda: pytest.raises(fts.FTSeriesError, fts.Equations, "x'' - x = 0",
                                            unknowns={"x": fts.Field("cos", fixed=(1,))}),
}
NAMELESS = {"no first steps"}               # only that it is refused, its address is in the text


def test_every_public_number_is_right_beside_a_thread_of_two_bits():
    """In that thread nothing has more than 2 bits, 1 digit, 2 terms; the others come meanwhile."""
    alone = {name: shown(function()) for name, function in PUBLIC.items()}
    with ThreadPoolExecutor(len(PUBLIC)) as pool:
        with working(bits=2, digits=1, terms=2):
            found = {name: pool.submit(function) for name, function in PUBLIC.items()}
            time.sleep(1)
        found = {name: shown(future.result()) for name, future in found.items()}
    assert [name for name in PUBLIC if name not in NAMELESS and found[name] != alone[name]] == []


# --- threads of different precision at once

def test_solves_of_64_and_1000_bits_side_by_side():
    alone = {b: bits(fts.solve(duffing(1), 30, "ball", precision=b)) for b in (64, 1000)}
    assert alone[1000] > 950 > 64 > alone[64]
    with ThreadPoolExecutor(4) as pool:
        asked = [64, 1000] * 6
        found = pool.map(lambda b: bits(fts.solve(duffing(1), 30, "ball", precision=b)), asked)
        assert list(found) == [alone[b] for b in asked]


def test_sweep_in_threads_keeps_the_bits():
    with ThreadPoolExecutor(2) as pool:
        found = fts.sweep(duffing, [1, 2, 3, Fraction(1, 2), 5, 7], 40, executor=pool,
                          arithmetic="ball", precision=400)
    assert all(bits(solution) >= 380 for solution in found)


def test_evaluate_with_15_and_300_digits_side_by_side():
    with mpmath.workdps(320):
        t, lam = mpmath.mpf(3) / 8, mpmath.mpf(1) / 2
    true = CUBIC.evaluate("x", t, lam=lam, dps=320)
    with ThreadPoolExecutor(4) as pool:
        asked = [15, 300] * 8
        found = list(pool.map(lambda n: CUBIC.evaluate("x", t, lam=lam, dps=n), asked))
    with mpmath.workdps(320):
        assert all(abs(x - true) < mpmath.mpf(10)**(1 - n) for n, x in zip(asked, found))


def test_eigenvalues_to_200_digits_side_by_side(tmp_path):
    def proved(lam):
        theorem = certify.mathieu_eigenvalue(lam, digits=200)
        theorem.save(tmp_path / f"{lam}.json")
        return theorem.a.rad() < arb(10)**-198 and certify.check(tmp_path / f"{lam}.json")

    with ThreadPoolExecutor(3) as pool:
        assert all(text.startswith("Checked") for text in pool.map(proved, (1, 2, 3)))


# --- the block itself

def test_blocks_nest_and_restore():
    before = state()
    with working(bits=300, digits=50, terms=7):
        assert (ctx.prec, ctx.cap, mpmath.mp.dps) == (300, 7, 50)
        with working(digits=20):
            assert (ctx.prec, ctx.cap, mpmath.mp.dps) == (300, 7, 20)
        assert (ctx.prec, ctx.cap, mpmath.mp.dps) == (300, 7, 50)
    assert state() == before


@pytest.mark.parametrize("error", [ValueError, KeyboardInterrupt, SystemExit, GeneratorExit])
def test_exceptions_leave_nothing_behind(error):
    before = state()
    with pytest.raises(error), working(bits=300, digits=50, terms=7):
        raise error
    assert state() == before
    with ThreadPoolExecutor(1) as pool:                    # and the lock is free
        assert pool.submit(lambda: CUBIC.evaluate("x", 0, lam=0.5, dps=30)).result(10)


def test_an_error_within_a_solve_leaves_nothing_behind(monkeypatch):
    def interrupted(*arguments):
        raise KeyboardInterrupt

    before = state()
    monkeypatch.setattr("ftseries.phases._residuals", interrupted)
    with pytest.raises(KeyboardInterrupt):
        fts.solve(fts.CubicOscillator(a=1), 12, "ball", precision=500)
    assert state() == before


@pytest.mark.parametrize("arguments", [{"bits": "many"}, {"digits": "many"}, {"terms": "many"}])
def test_what_is_no_number_leaves_nothing_behind(arguments):
    before = state()
    with pytest.raises((TypeError, ValueError)), working(bits=300), working(**arguments):
        pass
    assert state() == before


@pytest.mark.parametrize("place, name, value", [(ctx, "prec", 30), (mpmath.mp, "dps", 5),
                                                (ctx, "cap", 3)])
def test_a_change_from_outside_is_not_silent(place, name, value):
    def change():
        setattr(place, name, value)

    other = threading.Thread(target=change)
    with pytest.raises(fts.PrecisionError, match="from outside"), working(bits=300, digits=50):
        other.start()
        other.join()


def test_who_sets_the_precision_in_a_block_disturbs_nobody():
    """The way out that the refusal names."""
    def disturb():
        with working():
            ctx.prec, mpmath.mp.dps = 2, 1
            time.sleep(1e-3)
            ctx.prec, mpmath.mp.dps = 53, 15

    with ThreadPoolExecutor(4) as pool:
        other = [pool.submit(disturb) for _ in range(20)]
        found = [pool.submit(CUBIC.evaluate, "x", 0.25, lam=0.5, dps=40) for _ in range(5)]
        assert all(future.result() is None for future in other)
        assert len({future.result()._mpf_ for future in found}) == 1


def _forked(queue):
    queue.put((bits(fts.solve(duffing(1), 12, "ball", precision=200)), *state()))


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork here")
def test_a_child_inherits_no_lock_and_no_precision():
    inside, leave = threading.Event(), threading.Event()

    def hold():
        with working(bits=1000):
            inside.set()
            leave.wait(0.5)

    context, before = multiprocessing.get_context("fork"), state()
    holder, queue = threading.Thread(target=hold), context.SimpleQueue()
    holder.start()
    inside.wait()
    child = context.Process(target=_forked, args=(queue,))
    child.start()
    found = queue.get()
    child.join(), holder.join()
    assert found[0] > 150 and found[1:] == before
