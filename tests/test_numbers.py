"""Numbers of every library mean the same everywhere; what only looks like one is refused."""

import datetime
import warnings
from decimal import Decimal
from fractions import Fraction

import flint
import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import fmpq

import ftseries as fts
from ftseries import certify
from ftseries.arguments import DIGITS, decimal, rational, real, shown
from ftseries.certify.algebra import given, written
from ftseries.references import cubic as reference
from ftseries.references.cubic_taylor import frequency_taylor

HALVES = [0.5, np.float64(0.5), np.float32(0.5), np.array(0.5), np.longdouble(0.5), "0.5",
          Fraction(1, 2), Decimal("0.5"), sp.Rational(1, 2), sp.Float(0.5), mpmath.mpf(0.5),
          fmpq(1, 2), flint.arb(0.5), flint.arf(0.5)]
TENTHS = [0.1, np.float64(0.1), np.float32(0.1), "0.1", "1/10", Fraction(1, 10), Decimal("0.1"),
          sp.Rational(1, 10), sp.Float(0.1), sp.Float("0.1", 40), mpmath.mpf(0.1), fmpq(1, 10)]
#: not one real number
UNREAL = {
    "complex": 0.5 + 0j, "complex128": np.complex128(0.5 + 0.1j), "complex64": np.complex64(0.5),
    "mpc": mpmath.mpc(0.5, 1), "acb": flint.acb(0.5), "SymPy's I": sp.I / 2,
    "date": np.datetime64("2020-01-01"), "days": np.timedelta64(3, "D"),
    "Python's days": datetime.timedelta(3), "Python's date": datetime.date(2020, 1, 1),
    "masked": np.ma.masked, "masked array": np.ma.array(0.5, mask=True),
    "ball": flint.arb(0.5, 0.1), "interval": mpmath.iv.mpf([0, 1]), "a number modulo 7":
    flint.nmod(3, 7), "list": [[0.1], [0.2, 0.3]], "dict": {}, "letters": "half",
    "object": object(),
}
#: real, and beyond the floats
FAR = {"int": 10**400, "Fraction": Fraction(10**400), "Decimal": Decimal("1e400"),
       "mpf": mpmath.mpf("1e400"), "SymPy": sp.Integer(10)**400, "fmpz": flint.fmpz(10)**400,
       "text": "1e400", "long": np.longdouble("1e400"), "arb": flint.arb("1e400").mid()}
#: so far that computing with them exactly would take all memory
ABSURD = {"text": "1e999999999", "negative": "1e-999999999", "Decimal": Decimal("1e999999"),
          "mpf": mpmath.mpf(2)**10**9, "small mpf": mpmath.mpf(2)**-10**9, "digits": "7" * 5000,
          "int": 10**5000, "fmpq": fmpq(1, 10**5000), "arf": flint.arf((1, 10**9)),
          "decimals": "0." + "1" * 5000, "underscores": "1e9_999_999"}


@pytest.fixture(scope="module")
def cubic():
    return fts.solve(fts.CubicOscillator(), 12)


@pytest.fixture(scope="module")
def mathieu():
    return fts.solve(fts.GeneralizedMathieu(), 8)


@pytest.mark.parametrize("half", HALVES, ids=lambda x: type(x).__name__)
def test_a_half_of_every_library(cubic, mathieu, half):
    assert decimal(half) == rational(half) == fmpq(1, 2) and real("t", half) == 0.5
    assert cubic.evaluate("x", half, lam=half) == cubic.evaluate("x", 0.5, lam=0.5)
    assert cubic.evaluate("x", half, lam=half, dps=30) == cubic.evaluate("x", "0.5", lam="0.5",
                                                                         dps=30)
    assert mathieu.evaluate("a", lam=half, mu=half, dps=20) == mathieu.evaluate(
        "a", lam="0.5", mu="0.5", dps=20)
    assert fts.CubicOscillator(half).a == sp.Rational(1, 2)
    assert fts.GeneralizedMathieu(half).mu == fmpq(1, 2)
    assert reference.frequency(half, dps=30) == reference.frequency("0.5", dps=30)


@pytest.mark.parametrize("tenth", TENTHS, ids=lambda x: type(x).__name__)
def test_a_float_is_the_decimal_that_it_looks_like_everywhere(cubic, mathieu, tenth):
    """0.1 is a tenth in problems, evaluation, references and proofs."""
    assert decimal(tenth) == fmpq(1, 10)
    assert fts.CubicOscillator(tenth).a == sp.Rational(1, 10)
    assert fts.GeneralizedMathieu(tenth).mu == fmpq(1, 10)
    assert fts.FigureEight(tenth).exponent == sp.Rational(1, 10)
    assert frequency_taylor(2, tenth) == frequency_taylor(2, sp.Rational(1, 10))
    assert certify.cubic_bound(1, tenth, 8).lam == fmpq(1, 10)
    assert certify.mathieu_eigenvalue(1, tenth, digits=5).mu == fmpq(1, 10)
    assert written("lam", tenth) == "0.1" and (given("lam", tenth) - fmpq(1, 10)).contains(0)
    if isinstance(tenth, mpmath.mpf):
        return                                      # computations keep its bits
    assert reference.frequency(tenth, dps=40) == reference.frequency(Fraction(1, 10), dps=40)
    if tenth != "1/10":                             # real() takes decimals
        assert mathieu.evaluate("a", lam=tenth, mu=tenth, dps=40) == mathieu.evaluate(
            "a", lam="0.1", mu="0.1", dps=40)


def test_irrational_numbers_have_all_digits(cubic):
    for pi in (sp.pi, mpmath.pi):
        x = cubic.evaluate("x", pi, lam="0.5", dps=50)
        with mpmath.workdps(60):
            assert abs(cubic.evaluate("x", +mpmath.pi, lam="0.5", dps=50) - x) < 1e-48


@pytest.mark.parametrize("kind", UNREAL)
def test_what_is_no_real_number_is_refused_everywhere(cubic, mathieu, kind):
    value = UNREAL[kind]
    tries = [lambda: real("t", value), lambda: real("t", [value, 0.5]), lambda: decimal(value),
             lambda: cubic.evaluate("omega", lam=value), lambda: cubic.refine(value),
             lambda: cubic.evaluate("omega", lam=value, dps=20),
             lambda: cubic.evaluate("x", value, lam=0.1),
             lambda: mathieu.evaluate("a", lam=0.1, mu=value), lambda: cubic.residual(value),
             lambda: mathieu.evaluate("a", lam=0.1, mu=value, dps=20),
             lambda: cubic.resum().evaluate("omega", lam=value),
             lambda: fts.GeneralizedMathieu(value), lambda: fts.CubicOscillator(value),
             lambda: certify.mathieu_eigenvalue(value), lambda: certify.cubic_bound(1, value, 4)]
    if kind == "letters":
        tries.remove(tries[-3])                     # a symbol
    with warnings.catch_warnings():
        warnings.simplefilter("error", np.exceptions.ComplexWarning)
        for attempt in tries:
            with pytest.raises(fts.InputError) as caught:
                attempt()
            assert "\n" not in str(caught.value)


@pytest.mark.parametrize("array", [
    np.array([0.5 + 0j]), np.array([0.5, 0.1j], object), np.array(["2020-01-01"], "M8[D]"),
    np.array([3], "m8[s]"), np.ma.array([0.1, 0.2], mask=[0, 1]), [flint.arb(0.5, 0.1)],
    np.array([(1, 2.0)], "i,f"), [0.5, None, "x"], np.array([True]),
], ids=lambda a: str(getattr(a, "dtype", "list")))
def test_arrays_of_them(array):
    with pytest.raises(fts.InputError, match="^t"):
        real("t", array)


def test_a_masked_array_without_a_mask_is_an_array():
    assert real("t", np.ma.array([0.1, 0.2])).tolist() == [0.1, 0.2]


def test_a_ball_says_what_to_do():
    with pytest.raises(fts.InputError, match=r"^lam: .* is a ball with a radius, .*\.mid\(\)$"):
        real("lam", flint.arb(0.5, 0.1))


def test_series_of_pandas():
    pandas = pytest.importorskip("pandas", reason="pandas is not among the requirements")
    assert real("t", pandas.Series([0.1, 0.2])).tolist() == [0.1, 0.2]
    for bad in ([0.1j, 1], pandas.to_datetime(["2020-01-01"]), pandas.to_timedelta(["1 day"])):
        with pytest.raises(fts.InputError):
            real("t", pandas.Series(bad))


@pytest.mark.parametrize("kind", FAR)
def test_numbers_beyond_the_floats(cubic, kind):
    for attempt in (lambda: real("t", FAR[kind]), lambda: cubic.evaluate("omega", lam=FAR[kind]),
                    lambda: cubic.evaluate("omega", lam=FAR[kind], dps=20)):
        with pytest.raises(fts.InputError, match="is beyond the floats"):
            attempt()
    assert decimal(FAR[kind]) > fmpq(10)**399                      # exactly it is a number


@pytest.mark.parametrize("kind", ABSURD)
def test_absurd_numbers_are_refused_at_once(kind):
    for attempt in (decimal, fts.GeneralizedMathieu, lambda x: certify.cubic_bound(x, 1, 4)):
        with pytest.raises(fts.InputError, match=f"{DIGITS}|1000|is not a number"):
            attempt(ABSURD[kind])


def test_parameters_beyond_the_floats():
    unknowns = {"x": fts.Field("cos", fixed=(1,)), "omega": fts.Scalar()}
    problem = fts.Equations("x'' + x + k*x**3 = 0", unknowns=unknowns, frequency="omega",
                            parameters={"k": "1e400"})
    assert fts.solve(problem, 4).coefficient("omega", 2) == sp.Rational(3, 8) * sp.Integer(10)**400
    for attempt in (problem, fts.GeneralizedMathieu("1e400")):
        with pytest.raises(fts.InputError, match="beyond the floats; solve with .*='exact'"):
            fts.solve(attempt, 8, "float")


@pytest.mark.parametrize("number", [Fraction(1, 2**20000), sp.Rational(1, 2**20000), 10**5000],
                         ids=["Fraction", "SymPy", "int"])
def test_a_problem_that_could_not_be_printed_is_not_made(number):
    for kind in (fts.CubicOscillator, fts.FigureEight):
        with pytest.raises(fts.InputError, match="more than 1000 digits|at most 1000"):
            kind(number)


def test_what_cannot_be_printed_is_shown():
    assert shown(10**5000) == "<int, too long to print>"
    assert len(shown("x" * 10**6)) < 200 and shown(np.eye(2)) == "array([[1., 0.], [0., 1.]])"
    with pytest.raises(fts.InputError, match="^n=<int, too long to print>"):
        fts.arguments.whole("n", 10**5000, 1, 2)


# --- λ by its name ------------------------------------------------------------------------------

@pytest.mark.parametrize("arguments, call", [
    (("omega", 0.5), r"'omega', lam=0\.5"), (("omega",), "'omega', lam=…"),
    (("x", 0.5), "'x', t, lam=…"), (("x", 0.5, 0.1), r"'x', t, lam=0\.1"),
    (("x",), "'x', t, lam=…"),
])
def test_the_sentence_shows_the_call(cubic, arguments, call):
    for source in (cubic, cubic.resum()):
        with pytest.raises(fts.InputError, match=rf"λ is given by its name: evaluate\({call}\)$"):
            source.evaluate(*arguments)
    with pytest.raises(fts.InputError, match="λ is given by its name"):
        cubic.refine(0.1).evaluate("x", 0.5, 0.1)


# --- proofs -------------------------------------------------------------------------------------

@pytest.mark.parametrize("precision", ["a", 10, 10**9, 64.0, None])
def test_bits_of_a_proof(precision):
    orbit = fts.solve(fts.FigureEight(), 6).refine()
    for prove in (lambda: certify.cubic_bound(1, "0.5", 4, precision=precision),
                  lambda: certify.prove_eight(orbit, precision=precision)):
        with pytest.raises(fts.InputError, match="^precision=.*: give a whole number from 53 to"):
            prove()


def test_a_certificate_has_decimals(cubic):
    assert [written("x", x) for x in (1, "2.50", -0.25, 1e-7, Fraction(3, 8), "-12")] == [
        "1", "2.5", "-0.25", "0.0000001", "0.375", "-12"]
    with pytest.raises(fts.InputError, match="nu=4/3 is not a decimal; give one, such as 1.33333"):
        written("nu", Fraction(4, 3))


# --- coefficients, search, modes ----------------------------------------------------------------

def test_a_scalar_has_no_sines(cubic):
    assert cubic.coefficient("omega", 2) == cubic.coefficient("omega", 2, sine=False) != 0
    with pytest.raises(fts.InputError, match="'omega' has no sines; leave it out"):
        cubic.coefficient("omega", 2, sine=True)
    with pytest.raises(fts.InputError, match="sine='no': say sine=True or sine=False"):
        cubic.coefficient("x", 2, 2, sine="no")


@pytest.mark.parametrize("search", [(4, 0), (2, 2), (0, 4j), (0, np.inf), 3, (0, 1e9)])
def test_an_interval_has_two_ends_in_order(search):
    with pytest.raises(fts.InputError, match="^search"):
        fts.figure_eight.closure_zero(fts.solve(fts.FigureEight(), 6), search=search)


@pytest.mark.parametrize("fixed", [(True,), ((True, 1),), ((0, True),), (1.0,), (None,)])
def test_modes_are_whole_numbers(fixed):
    with pytest.raises(fts.InputError, match="^fixed="):
        fts.Field("both", fixed=fixed)


@pytest.mark.parametrize("size", [10**6, 10**9, 10**18, 10**400])
def test_nobody_asks_for_so_many_digits_bits_or_derivatives(cubic, size):
    """The libraries would end the process, or never end."""
    for ask in ({"dps": size}, {"t": 0, "derivative": size}):
        with pytest.raises(fts.InputError, match="give a whole number from"):
            cubic.evaluate("x" if "t" in ask else "omega", lam=0.5, **ask)
    with pytest.raises(fts.InputError, match="give a whole number from"):
        cubic.enclosure("omega", lam=0.5, precision=10 * size)
    with pytest.raises(fts.InputError, match="give a whole number from"):
        reference.frequency(1, 0.5, dps=size)


def test_a_quotient_is_a_number_wherever_it_stands(cubic):
    assert cubic.evaluate("omega", lam="1/2") == cubic.evaluate("omega", lam=0.5)
    for text in ("1/0", "1/x", "1/2/3"):
        with pytest.raises(fts.InputError, match="lam='.*' is not a real number"):
            cubic.evaluate("omega", lam=text)


def test_a_ball_of_a_masked_number_is_none(cubic):
    with pytest.raises(fts.InputError, match="^lam: some of its entries are masked"):
        cubic.enclosure("omega", lam=np.ma.array([0.1, 0.2], mask=[0, 1]))
