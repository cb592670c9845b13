"""The float ring: values on a quarter-period grid are finite Fourier sums without loss."""

from itertools import combinations_with_replacement

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ftseries.errors import InputError
from ftseries.expansion import Expansion
from ftseries.grid import FloatRing, GridTable

DEGREES = [0, 1, 2, 3, 4, 7, 10, 31]


def keys(degree):
    return [(s, n) for s in (0, 1) for n in range(degree + 1) if n or not s]


@pytest.mark.parametrize("degree", DEGREES)
def test_analysis_inverts_synthesis(degree):
    """Modes up to the degree: the transforms are orthogonal, so only rounding is lost."""
    ring = FloatRing(degree)
    rng = np.random.default_rng(degree)
    modes = {key: float(rng.normal()) for key in keys(degree)}
    back = ring.from_modes(modes).modes()
    assert all(abs(back.get(key, 0.0) - modes.get(key, 0.0)) < 1e-14 * (degree + 10)
               for key in set(back) | set(modes))


@pytest.mark.parametrize("degree", DEGREES)
def test_every_mode_that_fits_on_the_grid(degree):
    """Also those above the degree, sin 2Mτ for example, whose column has another length."""
    ring = FloatRing(degree)
    for kind, orders in enumerate(ring.n):
        for n in orders.tolist():
            mode = kind >> 1, n
            back = ring.from_modes({mode: 1.5}).modes()
            assert all(abs(c - 1.5 * (key == mode)) < 1e-13 for key, c in back.items())


@pytest.mark.parametrize("degree", DEGREES)
def test_the_values_of_each_kind_are_those_of_its_functions(degree):
    ring = FloatRing(degree)
    for sine, n in keys(degree):
        (kind, row), = ring.from_modes({(sine, n): 1.0}).parts.items()
        assert kind == n % 2 + 2 * sine
        assert np.allclose(row, (np.cos, np.sin)[sine](n * ring.tau), rtol=0, atol=1e-14)


@pytest.mark.parametrize("degree", [3, 8, 21])
def test_products_within_the_degree_are_exact(degree):
    """cos a cos b = ½ cos(a - b) + ½ cos(a + b), while a + b stays within the degree."""
    ring = FloatRing(degree)
    for a in range(degree + 1):
        for b in range(degree + 1 - a):
            product = (ring.from_modes({(0, a): 1.0}) * ring.from_modes({(0, b): 1.0})).modes()
            expected = {}
            for n in (abs(a - b), a + b):
                expected[0, n] = expected.get((0, n), 0) + 0.5
            assert all(abs(product.get(m, 0) - expected.get(m, 0)) < 1e-13
                       for m in set(product) | set(expected))


def test_numbers_become_floats():
    assert [FloatRing(2).number(x) for x in (0.1, "1/4", 3)] == [0.1, 0.25, 3.0]


@pytest.mark.parametrize("degree", DEGREES)
def test_the_first_mode_of_each_kind_beyond_the_grid_is_refused(degree):
    """The kinds end at 2M-2, 2M-1, 2M and 2M-1, where M = D//2 + 1."""
    points = degree // 2 + 1
    for sine, n in ((0, 2 * points), (0, 2 * points + 1), (1, 2 * points + 2), (1, 2 * points + 1)):
        with pytest.raises(InputError, match=f"Fourier order {n} .* {points} grid points"):
            FloatRing(degree).from_modes({(sine, n): 1.0})


@given(st.integers(1, 12))
def test_derivative_matrices(n):
    ring = FloatRing(12)
    cosine = ring.from_modes({(0, n): 1.0}).multiply_modes(lambda n, ring: (0, n)).modes()
    assert all(abs(c - (-n if m == (1, n) else 0)) < 1e-12 for m, c in cosine.items())


class TestTable:
    ring = FloatRing(degree=4, order=9)

    def row(self, c, n=0):
        return self.ring.from_modes({(0, n): float(c)})

    def test_grows_and_is_cut(self):
        table = GridTable(self.ring)
        for k in range(5):
            table.append(self.row(k))
        assert len(table) == 5
        assert table[3].modes()[0, 0] == pytest.approx(3)
        table.cut(2)
        assert len(table) == 2
        for k in (2, -1):
            with pytest.raises(IndexError):
                table[k]
        table.append(self.row(7, 1))
        assert table[2].modes()[0, 1] == pytest.approx(7)
        assert table[2].modes().get((0, 0), 0) == 0          # nothing of the old row is left

    def test_cutting_beyond_the_end_does_nothing(self):
        table = GridTable(self.ring)
        table.append(self.row(1))
        table.cut(5)
        assert len(table) == 1

    @pytest.mark.parametrize("powers_a", ["all", "even", "odd"])
    @pytest.mark.parametrize("powers_b", ["all", "even", "odd"])
    @pytest.mark.parametrize("lo", [0, 1, 2, 3])
    def test_cauchy_sums_with_rows_of_one_parity(self, powers_a, powers_b, lo):
        """Absent parities are stepped over; the sum is the plain one."""
        keep = {"all": (0, 1), "even": (0,), "odd": (1,)}
        a, b = GridTable(self.ring), GridTable(self.ring)
        for k in range(9):
            a.append(self.row(k + 1) if k % 2 in keep[powers_a] else self.ring.from_modes({}))
            b.append(self.row(2 * k + 1) if k % 2 in keep[powers_b] else self.ring.from_modes({}))
        for k in range(lo, 9):
            for alpha, beta in ((1, 0), (-1, 0), (3, 0), (2, 3)):
                pairs = [j for j in range(lo, k + 1)
                         if j % 2 in keep[powers_a] and (k - j) % 2 in keep[powers_b]]
                total = sum((alpha + beta * j) * (j + 1) * (2 * (k - j) + 1) for j in pairs)
                trig = self.ring.convolve(a, b, k, lo, k, alpha, beta)
                assert trig.modes().get((0, 0), 0.0) == pytest.approx(total, abs=1e-11)
                assert pairs or not trig.parts              # a sum of nothing has no part

    def test_cauchy_sums_of_tables_with_several_kinds(self):
        """Each is the sum of the products of rows: of cos (k mod 2)τ, whose two kinds have orders
        of one parity each, and of rows with four kinds at all orders."""
        rows = [[self.ring.from_modes({(0, k % 2): k + 1.0}) for k in range(7)],
                [self.ring.from_modes({(0, 1): 1.0 - k, (1, 1): 2.0, (0, 2): 3.0 + k, (1, 2): -1.0})
                 for k in range(7)]]
        tables = [GridTable(self.ring), GridTable(self.ring)]
        for table, trigs in zip(tables, rows):
            for trig in trigs:
                table.append(trig)
        for a, b in ((0, 0), (0, 1), (1, 0), (1, 1)):
            for lo, hi, k in combinations_with_replacement(range(7), 3):
                total = self.ring.from_modes({})
                for j in range(lo, hi + 1):
                    total = total + (rows[a][j] * rows[b][k - j]).scale(2.0 - j)
                found = self.ring.convolve(tables[a], tables[b], k, lo, hi, 2, -1).modes()
                # values below 10⁴ on the grid, a dozen roundings of each
                assert found == pytest.approx(total.modes(), rel=0, abs=1e-10)


def test_a_high_order_series_keeps_its_precision():
    """1/(1 - λ cos τ)² at λ⁶⁰ is 61 cos⁶⁰ τ: binomials, to the rounding of 60 products."""
    from math import comb
    ring = FloatRing(degree=60, order=60)
    expansion = Expansion(ring)
    modes = ((1 - expansion.lam * expansion.cos(1)) ** -2)[60].modes()
    for n in range(0, 61, 2):
        expected = 61 * comb(60, (60 - n) // 2) / 2**60 * (1 if n == 0 else 2)
        assert modes[0, n] == pytest.approx(expected, abs=1e-12 * 61)
