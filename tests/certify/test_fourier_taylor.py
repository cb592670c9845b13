"""The algebra with two indices: every result contains what it stands for."""

import pytest
from flint import acb, arb, ctx
from hypothesis import given
from hypothesis import strategies as st

from ftseries.certify import NotProved
from ftseries.certify.algebra import negative_power
from ftseries.certify.fourier_taylor import BITS, Space

SPACE = Space(top=6, orders=4)
INTEGERS = st.integers(-2**20, 2**20)
ROWS = {odd: st.dictionaries(st.sampled_from(range(odd, 7, 2)),
                             st.lists(INTEGERS, min_size=1, max_size=4), min_size=1, max_size=3)
        for odd in (0, 1)}
POINTS = [(acb("0.3", "0.2"), arb("0.4")), (acb(0, "-0.9"), arb(2)), (acb(1), arb(0))]


def waves(rows):
    odd = bool(next(iter(rows)) % 2)
    return SPACE.waves(rows, 20, odd=odd)


def exact(rows, mu, t):
    return sum((c * mu**m * (n * t).cos() for n, row in rows.items() for m, c in enumerate(row)),
               acb(0)) / 2**20


def value(f, mu, t):
    """At μ and t: the norm bounds the absolute value."""
    total = acb(0)
    for n in range(-f.degree, f.degree + 1):
        total += sum((c * mu**m for m, c in enumerate(f[n].coeffs())), acb(0)) * acb(0, n * t).exp()
    return total * arb(2) ** -BITS + acb(arb(0, f.error), arb(0, f.error))


@given(ROWS[0] | ROWS[1], ROWS[0] | ROWS[1])
def test_products_enclose_the_values_and_norms_are_submultiplicative(f, g):
    with ctx.workprec(128):
        product = waves(f) * waves(g)
        for mu, t in POINTS:
            assert value(product, mu, t).overlaps(exact(f, mu, t) * exact(g, mu, t))
        assert product.norm() <= waves(f).norm() * waves(g).norm() + arb(2) ** -60
        assert product.degree <= SPACE.top


def test_a_product_cut_off_is_bounded_by_what_it_misses():
    f = waves({6: [0, 0, 0, 2**20]})                              # μ³ cos 6t
    square = f * f                                               # μ⁶ (1 + cos 12t)/2
    assert square.center_norm == 0 and 1 <= square.error < 1 + 1e-9


@given(ROWS[0], ROWS[0])
def test_sums_and_the_factor_mu(f, g):
    with ctx.workprec(128):
        total = (waves(f) + waves(g) * -3).times_mu()
        for mu, t in POINTS:
            assert value(total, mu, t).overlaps(mu * (exact(f, mu, t) - 3 * exact(g, mu, t)))


@given(ROWS[1], ROWS[1])
def test_the_error_of_a_product_covers_its_members(f, g):
    size = waves(g).norm()
    wide = waves(f).widened(size) * waves(f)
    moved = (waves(f) + waves(g)) * waves(f)
    assert (moved + wide * -1).center_norm <= wide.error * (1 + 1e-8) + 1e-14


def test_slope():
    f = waves({1: [2**20], 3: [0, 2**20]}).slope()                # i (sin t + 3 μ sin 3t)
    mu, t = POINTS[0]
    assert value(f, mu, t).overlaps(acb(0, 1) * (t.sin() + 3 * mu * (3 * t).sin()))
    assert f[1] == -f[-1]


def test_negative_power():
    with ctx.workprec(128):
        space = Space(top=16, orders=12)
        w = space.waves({0: [8, 0, 1], 2: [0, 1]}, 3)             # 1 + (μ² + μ cos 2t)/8
        v = space.waves({0: [256, 0, -14], 2: [0, -16]}, 8)       # about w^(-1/2)
        for p in (1, 2, 3, 5):
            root = negative_power(w, p, v, space.one())
            for mu, t in POINTS:
                true = (1 + (mu * mu + mu * (2 * t).cos()) / 8) ** (-arb(p) / 2)
                assert value(root, mu, t).overlaps(true)
        with pytest.raises(NotProved, match="not below 1"):
            negative_power(w, 1, v * 2, space.one())


def test_what_has_no_meaning_is_refused():
    with pytest.raises(ValueError, match="parity"):
        waves({0: [1]}) + waves({1: [1]})
    with pytest.raises(ValueError, match="derivative"):
        waves({1: [1]}).widened(arb(1)).slope()
