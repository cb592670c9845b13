"""Many digits of the eight: against an integration, published values, and themselves."""

import json
from dataclasses import replace
from functools import cache

import mpmath
import numpy as np
import pytest
from certify.altering import refused
from flint import arb, ctx, fmpq, fmpz
from hypothesis import assume, given
from hypothesis import strategies as st

import ftseries as fts
from ftseries.certify import NotProved, certificate, check, prove_eight
from ftseries.certify.balls import decimal
from ftseries.certify.digits import PROOF, STORED, certified
from ftseries.certify.lifting import lift
from ftseries.errors import FileError, InputError
from ftseries.references import newton

DIGITS = 50


@cache
def digits(n=DIGITS):
    return fts.figure_eight.digits(n)


@pytest.fixture(scope="module")
def thousand():
    return fts.figure_eight.thousand_digits()


@pytest.fixture(scope="module")
def theorem():
    return prove_eight(fts.solve(fts.FigureEight(), order=6).refine(), **PROOF)


def inside(ball, number, dps=DIGITS):
    """The ball overlaps the independent number, which is right to ``dps`` digits."""
    with ctx.workdps(dps + 20):
        return ball.overlaps(arb(mpmath.nstr(number, dps + 10), arb(10)**-dps))


# --- independent truths

def test_fifty_digits_of_an_independent_integration():
    """Taylor's method in time and shooting; no Fourier series, no proof."""
    eight = digits()
    with mpmath.workdps(DIGITS + 20):
        r, v = newton.figure_eight_state(dps=DIGITS)
        for balls, values in ((eight.positions, r), (eight.velocities, v)):
            for ball, z in zip(balls, values, strict=True):
                assert inside(ball.real, z.real) and inside(ball.imag, z.imag)
        assert inside(eight.lam, newton.figure_eight_lambda(dps=DIGITS))
        assert inside(eight.energy, newton.energy(r, v))
        assert inside(arb(eight.angular_momentum), newton.angular_momentum(r, v))
        c = newton.figure_eight_coefficients(dps=DIGITS)
        for n, ball in eight.coefficients.items():
            if n < len(c):
                assert inside(ball, c[n].imag if n % 2 else c[n].real, DIGITS - 2)
    assert eight.lam.rad() < arb(10)**-DIGITS and eight.energy.rad() < arb(10)**-DIGITS


def test_published_digits(thousand):
    """Simó's values as Chenciner and Montgomery print them, and fourteen decimals in common use.

    The latter are off by up to 2 in the last place, see tests/references/test_newton.py.
    """
    form = thousand.normal_form()
    r, v = form["position_1"], form["velocity_3"]
    computed = [float(x) for x in (r.real, r.imag, v.real, v.imag, form["period"])]
    z, w = newton.POSITION_1, newton.VELOCITY_3
    assert [round(x, 8) for x in computed] == [z.real, z.imag, w.real, w.imag, newton.PERIOD]
    common = (0.97000435669734, -0.24308753153583, -0.93240737144104, -0.86473146092102,
              6.32591398292621)
    np.testing.assert_allclose(computed, common, rtol=0, atol=2.5e-14)
    assert (abs(r) - 1).contains(0)


# --- the thousand digits

def test_the_whole_certificate_is_checked():
    """All of it, by code that shares nothing with what made it (6 s)."""
    assert check(STORED).startswith("Checked. The 1000 digits")


def test_a_hundred_digits_computed_anew_begin_the_thousand(thousand):
    short = digits(100).decimals()
    for name, text in thousand.decimals().items():
        assert len(text.partition(".")[2]) == 1000
        assert text.startswith(short[name])


def test_virial_theorem(thousand):
    """The mean kinetic energy is -E; by Parseval it is 3/4 Σ n² c_n².  All coefficients matter."""
    with ctx.workprec(thousand.precision):
        kinetic = 3 * sum((n * n * c.mid()**2 for n, c in thousand.coefficients.items()),
                          arb(0)) / 4
        assert abs(kinetic + thousand.energy) < arb(10)**-1000


def test_claimed_distance_holds(thousand):
    """The error of a short run, measured with the long one."""
    short = digits(30)
    with ctx.workprec(thousand.precision):
        error = sum((abs(thousand.unknown(n) - short.unknown(n)) for n in short.unknowns),
                    arb(0))
        assert short.distance / 10**6 < error < short.distance < arb(10)**-38


@pytest.mark.parametrize("n", [1, 2, 15, 33])
def test_few_digits(thousand, n):
    for name, text in thousand.decimals().items():
        assert text[:text.index(".") + n + 1] == digits(n).decimals()[name]


def test_printed(thousand):
    text = str(digits(1))
    assert "lambda_0 = 2.0\n" in text and "energy = -1.2\n" in text
    assert thousand.decimals()["lambda_0"] in str(thousand)


def test_the_facade_has_the_functions_of_the_problem():
    from ftseries.problems import figure_eight
    for name in ("positions", "closure", "closure_zero", "relative", "FigureEight"):
        assert getattr(fts.figure_eight, name) is getattr(figure_eight, name)


# --- the iteration and its certificate

def test_every_pass_gains_thirteen_digits(theorem):
    sizes = [p.correction for p in lift(theorem.center, theorem.inverse, 400)]
    assert all(b < a - 13 for a, b in zip(sizes, sizes[1:-1]))


def test_a_poorer_guess_gets_a_larger_distance(theorem):
    """And a guess outside the theorem's ball, or with a wrong root, nothing at all."""
    *_, guess = lift(theorem.center, theorem.inverse, 200)
    good = certified(theorem, guess, 20)
    for mode, bits in ((1, 100), (70, 80), (2, 60)):
        step = fmpz(1) << (guess.bits - bits)
        poor = replace(guess, u=guess.u | {mode: guess.u[mode] + step})
        found = certified(theorem, poor, 20)
        assert found.distance > arb(2)**-bits > good.distance
        assert found.lam.contains(digits().lam)
    far = replace(guess, u=guess.u | {1: guess.u[1] + (fmpz(1) << (guess.bits - 10))})
    with pytest.raises(NotProved, match="away from the center"):
        certified(theorem, far, 20)
    for root in ([-c for c in guess.root], [2 * c for c in guess.root]):
        with pytest.raises(NotProved, match="v"):
            certified(theorem, replace(guess, root=root), 20)


# --- decimals

@given(st.fractions(min_value=-10, max_value=10, max_denominator=10**9), st.integers(1, 30))
def test_decimal_truncates(x, n):
    assume((x * 10**n).denominator > 1)          # a ball around a decimal number is undecided
    with ctx.workdps(60):
        text = decimal(arb(fmpq(x.numerator, x.denominator)), n)
    whole = abs(x.numerator) * 10**n // x.denominator
    assert int(text.replace(".", "").removeprefix("-")) == whole
    assert text.startswith("-") == (x < 0 and whole > 0)
    assert len(text.partition(".")[2]) == n


def test_undecided_decimals_are_refused():
    with pytest.raises(NotProved, match="3 digits"):
        decimal(arb("0.125", "1e-9"), 3)
    with pytest.raises(NotProved):
        decimal(arb("nan"), 3)


# --- bad input, files

@pytest.mark.parametrize("n", [0, -3, 2.5, "x", True, None, 10**9, arb(5)])
def test_bad_numbers_of_digits(n):
    with pytest.raises(InputError, match="whole number from 1 to"):
        fts.figure_eight.digits(n)


@pytest.fixture
def saved(tmp_path):
    path = tmp_path / "digits.json"
    digits(30).save(path)
    return path


def test_saved_and_loaded(saved):
    again = fts.figure_eight.load_digits(saved)
    assert again.decimals() == digits(30).decimals()
    assert again.unknowns == digits(30).unknowns
    assert again.distance == digits(30).distance
    again.save(saved)
    assert check(saved).startswith("Checked. The 30 digits")


def test_every_cut_is_refused(saved):
    text = saved.read_text()
    for n in range(0, len(text), 4999):
        saved.write_text(text[:n])
        for read in (check, fts.figure_eight.load_digits):
            with pytest.raises(FileError):
                read(saved)


def changed_digit(data, name):
    text = data["decimals"][name]
    data["decimals"][name] = text[:-1] + str((int(text[-1]) + 1) % 10)


def changed_unknown(data, i, by):
    texts = data["unknowns"].split()
    texts[i] = by(texts[i])
    data["unknowns"] = " ".join(texts)


ALTERED = {
    **{name: lambda data, name=name: changed_digit(data, name)
       for name in ("lambda_0", "x_1", "y_1", "vx_3", "vy_3", "energy")},
    "sign": lambda data: data["decimals"].update(x_1=data["decimals"]["x_1"][1:]),
    "more decimals": lambda data: data["decimals"].update(mass="1." + 30 * "0"),
    "first unknown": lambda data: changed_unknown(data, 0, lambda text: text[:20] + "AAAA"
                                                  + text[24:]),
    "last unknown": lambda data: changed_unknown(data, 50, lambda text: "AAAA" + text[4:]),
    "missing unknown": lambda data: changed_unknown(data, 7, lambda text: ""),
    "distance": lambda data: data.update(distance="1 -160"),
    "lambda": lambda data: data.update(lam=[data["lam"][0], "1 -170"]),
    "theorem": lambda data: data["eight"]["center"].__setitem__(0, [1, "1 0"]),
    "radius": lambda data: data["eight"].update(radius="1 -90"),
}


@pytest.mark.parametrize("name", ALTERED)
def test_altered_certificate_with_a_fresh_checksum_is_refused(saved, name):
    refused(saved, ALTERED[name])


@pytest.mark.parametrize("change", [
    {"digits": 0}, {"digits": 10**7}, {"digits": "x"}, {"bits": None}, {"unknowns": 5},
    {"unknowns": "!"}, {"distance": "x"}, {"eight": {}}, {"decimals": {}}, {"precision": 10**9},
])
def test_nonsense_is_refused(saved, change):
    certificate.write(saved, certificate.read(saved) | change)
    with pytest.raises(FileError):
        check(saved)


def test_loading_refuses_what_does_not_fit(saved, tmp_path, theorem):
    theorem.save(tmp_path / "theorem.json")
    with pytest.raises(FileError, match="no certificate of digits"):
        fts.figure_eight.load_digits(tmp_path / "theorem.json")
    data = certificate.read(saved)
    changed_digit(data, "energy")
    certificate.write(saved, data)
    with pytest.raises(FileError, match="decimals"):
        fts.figure_eight.load_digits(saved)
    saved.write_text(json.dumps({}))
    with pytest.raises(FileError, match="not a certificate"):
        fts.figure_eight.load_digits(saved)
