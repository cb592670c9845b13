"""The linear part found by probing: derivatives of the residual, elimination, kernels."""

from fractions import Fraction

import numpy as np
import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from sample_problems import SMALL, Duffing, VanDerPol

import ftseries as fts
from ftseries.expansion import Expansion
from ftseries.laurent import RationalRing
from ftseries.linear import Dual, Elimination, LinearPart, Tangent
from ftseries.trig import Ring

PROBLEMS = [fts.CubicOscillator, lambda: fts.GeneralizedMathieu("1/3"), fts.FigureEight, *SMALL]
IDS = ["cubic", "Mathieu", "eight", *(kind.__name__ for kind in SMALL)]

entries = st.integers(-3, 3)
matrices = st.integers(1, 5).flatmap(lambda rows: st.integers(1, 5).flatmap(
    lambda columns: st.lists(st.lists(entries, min_size=columns, max_size=columns),
                             min_size=rows, max_size=rows)))


def eliminated(matrix):
    return Elimination({j: {i: fmpq(row[j]) for i, row in enumerate(matrix) if row[j]}
                        for j in range(len(matrix[0]))})


def times(matrix, x):
    return [sum((fmpq(row[j]) * c for j, c in x.items()), fmpq(0)) for row in matrix]


@given(matrices)
def test_kernel(matrix):
    kernel = eliminated(matrix).kernel
    assert len(kernel) == len(matrix[0]) - np.linalg.matrix_rank(np.array(matrix, dtype=float))
    assert all(not any(times(matrix, vector)) for vector in kernel)
    # independent: each has a coordinate of its own
    assert all(any(j in v and not any(j in w for w in kernel if w is not v) for j in v)
               for v in kernel)


@given(matrices, st.data())
def test_solving(matrix, data):
    """L x + left = b, and left vanishes if and only if b is in the image."""
    x = data.draw(st.lists(entries, min_size=len(matrix[0]), max_size=len(matrix[0])))
    image = times(matrix, {j: fmpq(c) for j, c in enumerate(x)})
    for b in (image, [fmpq(c) for c in data.draw(
            st.lists(entries, min_size=len(matrix), max_size=len(matrix)))]):
        solution, left = eliminated(matrix).solve({i: c for i, c in enumerate(b) if c})
        total = [c + left.get(i, 0) for i, c in enumerate(times(matrix, solution))]
        assert total == b
        augmented = np.column_stack([np.array(matrix, dtype=float), [float(c.p / c.q) for c in b]])
        solvable = (np.linalg.matrix_rank(augmented)
                    == np.linalg.matrix_rank(np.array(matrix, dtype=float)))
        assert (not any(left.values())) == solvable


@given(matrices)
def test_conversion_to_floats_solves_the_same(matrix):
    elimination = eliminated(matrix)
    b = {i: fmpq(i + 1) for i in range(len(matrix))}
    x, left = elimination.solve(b)
    y, rest = elimination.converted(lambda c: int(c.p) / int(c.q)).solve(
        {i: float(i + 1) for i in b})
    assert all(abs(y.get(j, 0) - int(c.p) / int(c.q)) < 1e-9 for j, c in x.items())
    assert all(abs(rest.get(i, 0) - int(c.p) / int(c.q)) < 1e-9 for i, c in left.items())


@pytest.mark.parametrize("make", PROBLEMS, ids=IDS)
def test_the_tangent_is_the_derivative_of_the_residual(make):
    """(R(U + hλT) - R(U - hλT))/2h for h = 1 and 2.  Up to order 3 of λ the residual is a
    polynomial of degree 3 in h, so one step of Richardson's rule removes all but DR·λT, exactly."""
    problem, ring, top = make(), RationalRing(), 3
    base = {name: list(rows) for name, rows in problem.first_coefficients().items()}
    columns = [(name, *mode) for name, u in problem.unknowns.items() for mode in u.columns(3)][::2]
    direction = {c: fmpq(i + 1, 3) for i, c in enumerate(columns)}

    def residual(h):
        expansion = Expansion(ring)
        unknowns = {}
        for name in problem.unknowns:
            u = unknowns[name] = expansion.unknown()
            for k in range(top + 1):
                row = dict(base[name][k]) if k < len(base[name]) else {}
                if k == 1:                              # λT keeps the state at λ = 0 constant
                    for (other, sine, n), c in direction.items():
                        if other == name:
                            row[sine, n] = row.get((sine, n), fmpq(0)) + h * c
                u.set(k, ring.from_modes(row))
        return [{(e, *mode): c for e, r in enumerate(
                    problem.equations(expansion.lam, **unknowns).values())
                 for mode, c in r[k].modes().items()} for k in range(top + 1)]

    def difference(h):
        plus, minus = residual(h), residual(-h)
        return [{row: (p.get(row, fmpq(0)) - m.get(row, fmpq(0))) / (2 * h)
                 for row in set(p) | set(m)} for p, m in zip(plus, minus, strict=True)]

    found = list(Tangent(problem, ring, base).along([{}, direction], top))
    one, two = difference(fmpq(1)), difference(fmpq(2))
    for k in range(top + 1):
        limit = {row: (4 * one[k].get(row, fmpq(0)) - two[k].get(row, fmpq(0))) / 3
                 for row in set(one[k]) | set(two[k])}
        assert {row: c for row, c in limit.items() if c} == found[k]


def part(problem, top=6):
    ring = RationalRing()
    return LinearPart(problem, ring, problem.first_coefficients(), top)


def test_leading_orders():
    """(C3) is quadratic in x′ and P′(-a) = 0, so it begins at order 1; the others at order 0."""
    assert part(fts.CubicOscillator()).shifts == [1]
    assert part(fts.FigureEight()).shifts == [0, 0]
    assert part(fts.GeneralizedMathieu(1)).shifts == [0]
    assert part(Duffing()).shifts == [0]


def kernel_names(problem):
    return sorted(tuple(sorted(f.terms[0])) for f in part(problem).families)


def test_kernels():
    """A_0 in the eight, ω in the oscillators, a in Mathieu's equation, amplitude and ω together
    in van der Pol's."""
    assert kernel_names(fts.FigureEight()) == [(("r", 0, 0),)]
    assert kernel_names(fts.GeneralizedMathieu(1)) == [(("a", 0, 0),)]
    assert kernel_names(Duffing()) == [(("omega", 0, 0),)]
    assert kernel_names(VanDerPol()) == [(("omega", 0, 0),), (("y", 0, 1),)]


def test_the_eight_is_diagonal_in_the_mode():
    """L₀ of (E3) by hand at ρ = 1, φ = 0."""
    linear = part(fts.FigureEight())
    for n in (2, 4, 6):
        rows = linear.rows([{("r", 0, n): fmpq(1)}], 0)
        # δ(ρ⁻²) = -2 δρ: twice its own force, minus the neighbours' (2 or -1 times), over 3
        expected = -n * n + Fraction(-4, 3) + Fraction(2, 3) * (2 if n % 3 == 0 else -1)
        assert rows == {(0, 0, n): fmpq(expected.numerator, expected.denominator)}
    for n in (1, 3, 5):
        rows = linear.rows([{("phi", 0, n): fmpq(1)}], 0)
        expected = -n * n + (0 if n % 3 == 0 else 1)            # -Q(iφ) without the modes 3k
        assert {k: v for k, v in rows.items() if v} == (
            {(1, 0, n): fmpq(expected)} if expected else {})


def test_no_rotation_of_mode_3_is_lost():
    """n = 1 is φ's resonance, which λ fixes: it is no column."""
    assert ("phi", 0, 1) not in fts.FigureEight().unknowns["phi"].columns(9)


def test_families_carry_their_consequences():
    """ω of Duffing's equation acts one order late, on mode 1: 2ω₀ω_k x₁″ = -2 ω_k cos τ."""
    family, = part(Duffing()).families
    assert family.effect(0) == {}
    assert family.effect(1) == {(0, 0, 1): fmpq(-2)}


def test_dual_numbers_are_a_ring_of_their_own():
    from ftseries.linear import DualRing
    assert issubclass(DualRing, Ring)
    assert DualRing(RationalRing()).names == ()


@pytest.mark.parametrize("alpha, value, slope", [(fmpq(1, 2), fmpq(2), fmpq(1, 4)),
                                                 (fmpq(-1), fmpq(1, 4), fmpq(-1, 16)),
                                                 (fmpq(3, 2), fmpq(8), fmpq(3))])
def test_powers_of_a_dual_number(alpha, value, slope):
    """(4 + ε cos τ)^α."""
    ring = RationalRing()
    u = Dual(ring.from_modes({(0, 0): fmpq(4)}), ring.from_modes({(0, 1): fmpq(1)}))
    power = u.power(alpha)
    assert power.value.modes() == {(0, 0): value}
    assert power.tangent.modes() == {(0, 1): slope}


@pytest.mark.parametrize("make", PROBLEMS, ids=IDS)
def test_the_elimination_inverts_each_column(make):
    """L₀ x = L₀ e_c for a column c: x is e_c up to the kernel, and nothing is left over."""
    linear = part(make())
    columns = {step[1] for step in linear.elimination.steps}
    for column in columns:
        x, left = linear.elimination.solve(linear.rows([{column: fmpq(1)}], 0))
        assert {c: v for c, v in x.items() if v} == {column: 1}
        assert not any(left.values())
    assert linear.elimination.converted(fmpq).kernel == linear.elimination.kernel


@pytest.mark.parametrize("make", [fts.FigureEight, lambda: fts.GeneralizedMathieu("1/3"), Duffing],
                         ids=["eight", "Mathieu", "Duffing"])
def test_the_response_of_a_family_leaves_only_its_effects(make):
    """DR·(T_0 + λ T_1 + …) vanishes in every row that some column can change."""
    linear = part(make(), top=9)
    for family in linear.families:
        family.effect(2)
        for late in (1, 2):
            rows = linear.rows(family.terms, late)
            assert {row: c for row, c in rows.items() if c} == family.effect(late)
