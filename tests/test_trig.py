"""One Taylor order in the Laurent rings: the four kinds, their modes and products."""

from fractions import Fraction

import flint
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from ftseries.errors import InputError, NonAnalyticError
from ftseries.grid import FloatRing
from ftseries.laurent import BallRing, PolynomialRing, RationalRing, SurdRing
from ftseries.trig import Ring, Table, Trig

MODES = [(0, 0), (0, 1), (0, 2), (0, 3), (1, 1), (1, 2), (1, 3)]
RINGS = [RationalRing(), PolynomialRing(("mu", "nu")), BallRing(), FloatRing(degree=12)]
ring_of_each_kind = pytest.mark.parametrize("ring", RINGS, ids=["exact", "polynomial", "ball",
                                                                "float"])


@ring_of_each_kind
@pytest.mark.parametrize("mode", MODES)
def test_one_mode_there_and_back(ring, mode):
    """A single mode stays itself, and lies in the part of its kind."""
    trig = ring.from_modes({mode: ring.number(fmpq(3, 7))})
    assert set(trig.parts) == {mode[1] % 2 + 2 * mode[0]}
    for other, c in trig.modes().items():
        expected = 3 / 7 if other == mode else 0
        assert float(c if not hasattr(c, "leading_coefficient") else c.leading_coefficient()) \
            == pytest.approx(expected, abs=1e-15)


@ring_of_each_kind
@pytest.mark.parametrize("u", MODES)
@pytest.mark.parametrize("v", MODES)
def test_the_kind_of_a_product_is_the_exclusive_or(ring, u, v):
    product = (ring.from_modes({u: ring.number(1)}) * ring.from_modes({v: ring.number(1)})).parts
    assert set(product) == {(u[1] % 2 + 2 * u[0]) ^ (v[1] % 2 + 2 * v[0])}


def test_products_of_single_modes_exactly():
    ring = RationalRing()

    def product(u, v):
        return (ring.from_modes({u: fmpq(1)}) * ring.from_modes({v: fmpq(1)})).modes()

    half = fmpq(1, 2)
    assert product((0, 2), (0, 3)) == {(0, 1): half, (0, 5): half}
    assert product((1, 2), (1, 3)) == {(0, 1): half, (0, 5): -half}
    assert product((1, 2), (0, 3)) == {(1, 5): half, (1, 1): -half}
    assert product((1, 3), (0, 2)) == {(1, 5): half, (1, 1): half}
    assert product((1, 1), (1, 1)) == {(0, 0): half, (0, 2): -half}
    assert product((1, 1), (0, 1)) == {(1, 2): half}
    assert product((0, 0), (1, 3)) == {(1, 3): 1}


def test_exact_zeros_are_left_out():
    ring = RationalRing()
    trig = ring.from_modes({(0, 1): fmpq(1), (0, 3): fmpq(2)})
    assert (trig + ring.from_modes({(0, 1): fmpq(-1)})).modes() == {(0, 3): 2}
    assert (trig + trig.scale(-1)).modes() == {}
    assert ring.from_modes({}).modes() == {}


@pytest.mark.parametrize("ring", [*RINGS[:3], SurdRing()], ids=["exact", "polynomial", "ball",
                                                              "surd"])
def test_a_part_is_the_laurent_polynomial_of_its_definition(ring):
    """At z = 2, w = 4: z^{-d} p(w)/c is cos nτ = (z^n + z^{-n})/2 and, times i, sin nτ =
    (z^n - z^{-n})/2i; and a value of a sum, a multiple, a product is that of the values."""
    def value(trig):
        out = [fmpq(0), fmpq(0)]                            # real and imaginary part
        for kind, (d, p, c) in trig.parts.items():
            out[kind >> 1] += p(4, *(0 for _ in ring.names)) * fmpq(1, 2**d * int(c))
        return out

    def expected(modes):
        out = [fmpq(0), fmpq(0)]
        for (sine, n), c in modes.items():
            out[sine] += c * (fmpq(1, 2**n) - 2**n if sine else fmpq(1, 2**n) + 2**n) / 2
        return out

    modes = [{(0, 0): fmpq(1), (0, 1): fmpq(3), (0, 2): fmpq(-2), (1, 1): fmpq(5)},
             {(0, 1): fmpq(2), (0, 4): fmpq(3, 8), (1, 2): fmpq(-1), (1, 3): fmpq(7)}]
    u, v = (ring.from_modes({mode: ring.number(c) for mode, c in row.items()}) for row in modes)
    (a, b), (c, d) = map(expected, modes)
    assert value(u) == [a, b] and value(v) == [c, d]
    assert value(u + v) == [a + c, b + d]
    assert value(u.scale(ring.number(fmpq(3, 2)))) == [a * fmpq(3, 2), b * fmpq(3, 2)]
    assert value(u * v) == [a * c - b * d, a * d + b * c]
    assert value(Trig(ring, {0: ring.one})) == [1, 0]


@given(st.dictionaries(st.sampled_from(MODES), st.fractions(max_denominator=30), max_size=5))
def test_modes_there_and_back(modes):
    ring = RationalRing()
    given_ = {m: fmpq(c.numerator, c.denominator) for m, c in modes.items()}
    assert ring.from_modes(given_).modes() == {m: c for m, c in given_.items() if c}


def test_polynomials_keep_their_parameters():
    ring = PolynomialRing(("mu", "nu"))
    mu, nu = ring.parameter("mu"), ring.parameter("nu")
    u = ring.from_modes({(0, 1): mu + 2 * nu})
    v = ring.from_modes({(0, 1): mu - 2 * nu})
    product = (u * v).modes()
    assert product == {(0, 0): (mu**2 - 4 * nu**2) / 2, (0, 2): (mu**2 - 4 * nu**2) / 2}


@ring_of_each_kind
def test_shift_by_quarters(ring):
    turn = ring.turn
    for fraction, (cosine, sine) in {Fraction(1, 4): (0, 1), Fraction(1, 2): (-1, 0),
                                     Fraction(3, 4): (0, -1), Fraction(-1, 4): (0, -1),
                                     Fraction(5): (1, 0)}.items():
        assert [float(x) for x in turn(fraction)] == pytest.approx([cosine, sine], abs=1e-14)


def test_balls_enclose_irrational_turns():
    """cos and sin of 2π/5 are algebraic: 4c² + 2c - 1 = 0, c² + s² = 1."""
    with flint.ctx.workprec(300):
        c, s = BallRing().turn(Fraction(1, 5))
        assert (4 * c * c + 2 * c - 1).contains(0) and (c * c + s * s - 1).contains(0)
        assert c > 0 and s > 0 and c.rad() < 1e-80


def test_a_whole_number_is_an_exact_ball():
    """However many bits it has; a fraction is a ball around it."""
    with flint.ctx.workprec(53):
        assert BallRing().number(3**60).unique_fmpz() == 3**60
        assert BallRing().number(3**60).is_exact()
        third = BallRing().number(fmpq(1, 3))
        assert third.contains(fmpq(1, 3)) and 0 < third.rad() < 2.0**-53


def test_the_roots_of_the_rings():
    assert RationalRing().root(fmpq(4, 9), Fraction(-3, 2)) == fmpq(27, 8)
    assert RationalRing().root(fmpq(-2), -3) == fmpq(-1, 8)
    polynomial = PolynomialRing(("mu",))
    assert polynomial.root(polynomial.number(fmpq(1, 8)), Fraction(1, 3)) == fmpq(1, 2)
    assert FloatRing(4).root(2.0, Fraction(1, 2)) == pytest.approx(2**0.5, rel=1e-15)
    with flint.ctx.workprec(200):
        root = BallRing().root(arb(2), Fraction(1, 2))
        assert (root * root - 2).contains(0) and root.rad() < 1e-55


def test_a_parameter_under_a_root_is_refused():
    ring = PolynomialRing(("mu",))
    with pytest.raises(InputError, match="depends on a parameter"):
        ring.root(ring.parameter("mu") + 1, -1)


def test_a_square_takes_each_pair_once():
    """The folded sum for a·a equals the plain sum for two copies."""
    ring = RationalRing()
    rows = Table(ring.from_modes({(0, k % 3): fmpq(k + 1), (1, 1): fmpq(k, 2)}) for k in range(8))
    copy = Table(rows)
    for k in range(8):
        assert (ring.convolve(rows, rows, k, 0, k).modes()
                == ring.convolve(rows, copy, k, 0, k).modes())


def test_weights_of_a_cauchy_sum():
    """Σ (α + βj) a_j b_{k-j} with constants: Σ_{j=1}^{4} (2 + 3j)·1·1 = 38."""
    for ring in RINGS[:3]:
        rows = Table(ring.from_modes({(0, 0): ring.number(1)}) for _ in range(6))
        value = ring.convolve(rows, rows, 5, 1, 4, 2, 3).modes()[0, 0]
        assert value == 38


def test_cut_drops_the_end_of_a_table():
    table = Table([1, 2, 3])
    table.cut(1)
    assert table == [1]


def test_multiplying_modes_by_i_is_the_derivative_of_each_kind():
    ring = RationalRing()
    for sine, n in MODES:
        derivative = ring.from_modes({(sine, n): fmpq(1)}).multiply_modes(lambda n, ring: (0, n))
        assert derivative.modes() == ({(1 - sine, n): n if sine else -n} if n else {})


def test_the_base_ring_is_exact_by_default():
    assert Ring.exact and Ring.names == () and not FloatRing.exact
    assert isinstance(RationalRing().from_modes({}), Trig)


def test_parts_that_meet_are_added():
    """(3 + 4i) e^{iτ}: cos τ to 3 cos τ - 4 sin τ, and sin τ to 3 sin τ + 4 cos τ."""
    ring = RationalRing()
    f = ring.from_modes({(0, 1): fmpq(1), (1, 1): fmpq(2)})
    assert f.multiply_modes(lambda n, ring: (3, 4 * n)).modes() == {(0, 1): 11, (1, 1): 2}


def test_rounding_is_no_oscillation():
    ring = FloatRing(degree=4)
    start = ring.from_modes({(0, 0): 4.0, (0, 2): 1e-12})
    assert start.power(fmpq(1, 2)).modes()[0, 0] == pytest.approx(2, rel=1e-15)
    with pytest.raises(NonAnalyticError, match="the power 1/2 needs an argument that is constant"):
        ring.from_modes({(0, 0): 4.0, (0, 2): 1e-3}).power(fmpq(1, 2))
    with pytest.raises(NonAnalyticError, match="exp needs an argument that is constant"):
        ring.from_modes({(0, 2): 1e-3}).exp()
    with pytest.raises(NonAnalyticError, match="the power 1/2 of a quantity that vanishes"):
        ring.from_modes({}).power(fmpq(1, 2))
