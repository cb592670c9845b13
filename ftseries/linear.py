r"""The linear part of the equations, found by probing them.

Formula.  Let R(U; λ) be the residual and U the solution.  Its derivative along U is

.. math::  DR_e = λ^{s_e} (L_0 + λ L_1 + λ^2 L_2 + …)_e  \quad\text{for equation } e,

where the L_j do not depend on the Taylor order that is being solved.  A *column* (name, sine, n)
is one mode of one unknown, a *row* (equation, sine, n) one mode of one residual.  :func:`tangent`
gives DR·T for a series T of modes by running the problem's own equations over dual numbers u + ε v,
ε² = 0, in exact arithmetic.  :class:`Elimination` solves L₀ x = b and gives the kernel of L₀; what
cannot be solved is left over, and vanishes only if kernel coordinates of earlier orders are right.
"""

from flint import fmpq

from .errors import ContradictionError, InputError
from .series import Expansion
from .trig import Ring, rational

__all__ = ["Elimination", "Family", "LinearPart", "tangent"]

#: orders of λ within which every equation must begin to depend on some unknown
REACH = 6
#: the lowest modes of each unknown that are probed for it
_PROBES = 4


class Dual:
    """A Taylor coefficient u + ε v with ε² = 0; it has the operations of a ``Trig``."""

    __slots__ = ("value", "tangent")

    def __init__(self, value, tangent):
        self.value, self.tangent = value, tangent

    def __add__(self, other):
        return Dual(self.value + other.value, self.tangent + other.tangent)

    def __mul__(self, other):
        return Dual(self.value * other.value,
                    self.value * other.tangent + self.tangent * other.value)

    def scale(self, number):
        return Dual(self.value.scale(number), self.tangent.scale(number))

    def multiply_modes(self, multiplier):
        return Dual(self.value.multiply_modes(multiplier), self.tangent.multiply_modes(multiplier))

    def power(self, alpha):
        value = self.value.power(alpha)
        return Dual(value, self.value.power(alpha - 1).scale(alpha) * self.tangent)

    def exp(self):
        return Dual(self.value.exp(), self.tangent)

    def sincos(self):
        zero, one = self.value.sincos()
        return Dual(zero, self.tangent), Dual(one, zero)


class DualRing(Ring):
    """Dual numbers over an exact ring."""

    def __init__(self, base):
        self.base, self.number, self.names = base, base.number, base.names
        self.zero = base.from_modes({})

    def parameter(self, name):
        return self.base.parameter(name)

    def from_modes(self, modes):
        return Dual(self.base.from_modes(modes), self.zero)

    def convolve(self, a, b, k, lo, hi, alpha=1, beta=0):
        values = [[x.value for x in side] for side in (a, b)]
        tangents = [[x.tangent for x in side] for side in (a, b)]
        sum_ = self.base.convolve
        return Dual(sum_(*values, k, lo, hi, alpha, beta),
                    sum_(values[0], tangents[1], k, lo, hi, alpha, beta)
                    + sum_(tangents[0], values[1], k, lo, hi, alpha, beta))


def tangent(problem, ring, base, direction, top):
    """DR·T at the orders 0, …, ``top``, one after the other, each a dict ``{row: number}``.

    ``base`` maps names to lists of ``{mode: number}``, ``direction`` is the list of the T_j, each a
    dict ``{column: number}``.
    """
    expansion = Expansion(DualRing(ring))
    unknowns = {}
    for name in problem.unknowns:
        unknowns[name] = expansion.unknown()
        known = base[name]
        for k in range(top + 1):
            v = {(sine, n): c for (other, sine, n), c in
                 (direction[k] if k < len(direction) else {}).items() if other == name}
            unknowns[name].set(k, Dual(ring.from_modes(known[k] if k < len(known) else {}),
                                       ring.from_modes({m: ring.number(c) for m, c in v.items()})))
    residuals = problem.residuals(expansion.lam, unknowns)
    for k in range(top + 1):
        yield {(e, *mode): c for e, r in enumerate(residuals.values())
               for mode, c in r[k].tangent.modes().items()}


class Elimination:
    """Gauss-Jordan elimination of a sparse exact matrix, replayed on right-hand sides.

    ``columns`` maps each column to its ``{row: fmpq}``; columns are taken in the given order.

    >>> e = Elimination({"x": {0: fmpq(2), 1: fmpq(1)}, "y": {0: fmpq(4), 1: fmpq(2)}})
    >>> e.kernel
    [{'y': 1, 'x': -2}]
    >>> e.solve({0: fmpq(6), 1: fmpq(4)})                 # 2x + 4y = 6, x + 2y = 4: no solution
    ({'x': 4}, {0: -2})
    """

    def __init__(self, columns):
        rows, where = {}, {col: set(entries) for col, entries in columns.items()}
        for col, entries in columns.items():
            for row, value in entries.items():
                rows.setdefault(row, {})[col] = value
        self.steps, pivots, free = [], {}, []
        for col in columns:
            usable = [row for row in where[col] if row not in pivots]
            if not usable:
                free.append(col)
                continue
            pivot = max(usable, key=_height)
            value = rows[pivot][col]
            changes = []
            for row in where[col] - {pivot}:
                factor = rows[row][col] / value
                changes.append((row, factor))
                for c, v in rows[pivot].items():
                    new = rows[row].get(c, 0) - factor * v
                    if new:
                        rows[row][c] = new
                        where[c].add(row)
                    else:
                        rows[row].pop(c, None)
                        where[c] -= {row} if c != col else set()
            where[col] = {pivot}
            pivots[pivot] = col
            self.steps.append((pivot, col, 1 / value, changes))
        self.kernel = [{f: fmpq(1)} | {col: -rows[row][f] / rows[row][col]
                                       for row, col in pivots.items() if f in rows[row]}
                       for f in free]

    def converted(self, number):
        """The same elimination with its factors as numbers of another ring."""
        other = object.__new__(Elimination)
        other.kernel = self.kernel
        other.steps = [(pivot, col, number(inverse), [(row, number(f)) for row, f in changes])
                       for pivot, col, inverse, changes in self.steps]
        return other

    def solve(self, b):
        """(x, left): L x = b up to the rows in ``left``, which no column can change."""
        b = dict(b)
        for pivot, _, _, changes in self.steps:
            value = b.get(pivot)
            if value is not None:
                for row, factor in changes:
                    b[row] = b[row] - factor * value if row in b else -factor * value
        x = {col: b.pop(pivot) * inverse for pivot, col, inverse, _ in self.steps if pivot in b}
        return x, b


def _height(row):
    return (row[2], -row[0], row[1]) if isinstance(row, tuple) else (row,)


class Family:
    """A kernel direction of L₀ with its consequences in the following orders.

    ``terms[j]`` is its response T_j (T_0 lies in the kernel), ``effects[j]`` what DR·T leaves over
    at order j.  Both are the same for every Taylor order at which the direction starts.
    """

    def __init__(self, linear, terms):
        self.linear, self.terms, self.effects = linear, terms, [{}] * len(terms)

    def effect(self, late):
        """What a unit coordinate leaves over ``late`` orders after its own."""
        while len(self.effects) <= late:
            j = len(self.effects)
            x, left = self.linear.elimination.solve(self.linear.rows(self.terms, j))
            self.terms.append({col: -c for col, c in x.items() if c})
            self.effects.append({row: c for row, c in left.items() if c})
        return self.effects[late]


class LinearPart:
    """L₀ of a problem for all modes up to ``top``, its kernel and the families it opens."""

    def __init__(self, problem, ring, base, top):
        self.problem, self.ring, self.base = problem, ring, base
        columns = [(name, *mode) for name, unknown in problem.unknowns.items()
                   for mode in unknown.columns(top)]
        columns.sort(key=lambda c: -c[2])
        self.shifts = self._leading_orders([c for name in problem.unknowns for c in
                                            [c for c in columns if c[0] == name][-_PROBES:]])
        self.elimination = Elimination({c: self.rows([{c: fmpq(1)}], 0) for c in columns})
        self.families = [Family(self, [vector]) for vector in self.elimination.kernel]

    def _leading_orders(self, columns):
        """s_e for every equation."""
        blank = Expansion(DualRing(self.ring))
        self.names = list(self.problem.residuals(
            blank.lam, {name: blank.unknown() for name in self.problem.unknowns}))
        probes = [tangent(self.problem, self.ring, self.base, [{c: fmpq(1)}], REACH)
                  for c in columns]
        shifts = {}
        for k, step in enumerate(zip(*probes, strict=True)):
            for e, *_ in (row for rows in step for row in rows):
                shifts.setdefault(e, k)
            if len(shifts) == len(self.names):
                break
        for e, name in enumerate(self.names):
            if e not in shifts:
                raise ContradictionError(f"equation {name} does not depend on any unknown up to "
                                         f"order {REACH} of λ; check it or the seed")
        return [shifts[e] for e in range(len(self.names))]

    def rows(self, direction, late):
        """(DR·T) at order ``late`` above the leading order of each equation, as rationals."""
        probe = list(tangent(self.problem, self.ring, self.base, direction,
                             late + max(self.shifts)))
        return {(e, sine, n): self._rational(c, e) for e, s in enumerate(self.shifts)
                for (row, sine, n), c in probe[late + s].items() if row == e}

    def _rational(self, number, e):
        if isinstance(number, fmpq):
            return number
        if not number.is_constant():
            raise InputError(f"the linear part of equation {self.names[e]} depends on a parameter "
                             f"({number}), so the coefficients are not polynomials in it; give the "
                             "parameter a value")
        return rational(number.leading_coefficient()) if number else fmpq(0)
