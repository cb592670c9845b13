r"""The float ring: a finite Fourier sum kept as its values on a grid.

Index convention and formula.  A part of kind (parity, sine) (see :mod:`ftseries.trig`) with modes
n ≤ D is the vector of its values at the M = D//2 + 1 points

.. math::  τ_j = (j + 1/2) \frac{π}{2M}, \qquad j = 0, …, M-1,

of a quarter period; the kind says how it continues.  The modes of a kind are n = 0, 2, …, 2M-2;
1, 3, …, 2M-1; 2, 4, …, 2M; 1, 3, …, 2M-1, and the M × M matrices cos(n τ_j), sin(n τ_j) are the
discrete cosine and sine transforms of types III and IV, orthogonal up to a factor.  A product is a
product of values, exact as long as its degree stays within D; a Cauchy sum over Taylor orders is
one sum over rows of two arrays.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from .aliases import Array, Exact, Modes, Multiplier, Number, Parts, Terms
from .arguments import quotient, rational
from .errors import InputError
from .rounding import NEGLIGIBLE
from .trig import Ring, Trig

__all__ = ["FloatRing"]


class FloatRing(Ring):
    """Float64 values on the quarter-period grid that carries all modes up to ``degree``."""

    name = "float"
    exact = False

    def __init__(self, degree: int, order: int = 0) -> None:
        self.points = m = degree // 2 + 1
        self.rows = order + 1
        self.matrices: dict[tuple[int, Multiplier], list[tuple[int, Array]]] = {}
        self.tau = tau = (np.arange(m) + 0.5) * np.pi / (2 * m)
        #: the modes of each kind; row i of ``values[kind]`` is cos or sin of n[kind][i] τ
        self.n = [np.arange(0, 2 * m, 2), np.arange(1, 2 * m, 2),
                  np.arange(2, 2 * m + 1, 2), np.arange(1, 2 * m, 2)]
        self.values = [(np.cos, np.sin)[kind >> 1](np.outer(n, tau))
                       for kind, n in enumerate(self.n)]
        self.analysis = [v * (2 / m) for v in self.values]
        self.analysis[0][0] /= 2
        self.analysis[2][-1] /= 2

    def number(self, x: Exact) -> float:
        if isinstance(x, float):
            return x
        return quotient(rational(x))

    def part(self, kind: int, modes: dict[int, Number]) -> Array:
        coefficients = np.zeros(self.points)
        first = self.n[kind][0]
        for n, value in modes.items():
            if n > self.n[kind][-1]:
                raise InputError(f"Fourier order {n} does not fit on {self.points} grid points")
            coefficients[(n - first) // 2] = value
        row: Array = coefficients @ self.values[kind]
        return row

    def modes(self, parts: Parts) -> Modes:
        return {(kind >> 1, n): c for kind, row in parts.items()
                for n, c in zip(self.n[kind].tolist(), (self.analysis[kind] @ row).tolist())}

    def add(self, a: Array, b: Array) -> Array:
        return a + b

    def scale(self, part: Array, number: float) -> Array:
        return part * number

    def is_zero(self, number: float) -> bool:
        return number == 0.0

    def negligible(self, number: float, scale: float) -> bool:
        return abs(number) <= NEGLIGIBLE * scale

    def root(self, value: float, alpha: Exact) -> float:
        alpha = rational(alpha)
        if value < 0 and alpha.q != 1:
            raise InputError(f"({value})^({alpha}), a root of a negative number, is not real")
        return float(value ** (int(alpha.p) / int(alpha.q)))

    def size(self, modes: Modes) -> float:
        return max(map(abs, modes.values()), default=0.0)

    def turn(self, fraction: Exact) -> tuple[Number, Number]:
        angle = 2 * np.pi * float(fraction)
        return np.cos(angle), np.sin(angle)

    def multiply_modes(self, kind: int, part: Array,
                       multiplier: Multiplier) -> list[tuple[int, Array]]:
        key = kind, multiplier
        if key not in self.matrices:
            pairs = np.array([multiplier(int(n), self) for n in self.n[kind]], dtype=float).T
            images = []
            for new, factor in ((kind, pairs[0]), (kind ^ 2, pairs[1] * (1 if kind & 2 else -1))):
                if factor.any():
                    function = (np.cos, np.sin)[new >> 1](np.outer(self.n[kind], self.tau))
                    images.append((new, function.T @ (factor[:, None] * self.analysis[kind])))
            self.matrices[key] = images
        return [(new, matrix @ part) for new, matrix in self.matrices[key]]

    def table(self) -> GridTable:
        return GridTable(self)

    def convolve(self, a: Terms, b: Terms, k: int, lo: int, hi: int, alpha: int = 1,
                 beta: int = 0) -> Trig:
        if isinstance(a, list):                       # of Trig: a single product
            (u,), (v,) = a, b
            return Trig(self, _merge((ku ^ kv, p * q) for ku, p in u.parts.items()
                                     for kv, q in v.parts.items()))
        terms = []
        for ku, (p, parity_p) in a.parts.items():
            for kv, (q, parity_q) in b.parts.items():
                first, step = lo, 1
                if len(parity_p) == 1:
                    first, step = first + (first - min(parity_p)) % 2, 2
                if len(parity_q) == 1:
                    wanted = (k - min(parity_q)) % 2
                    if step == 2 and first % 2 != wanted:
                        continue
                    first, step = first + (first - wanted) % 2, 2
                if first > hi:
                    continue
                last = first + (hi - first) // step * step
                u = p[first:last + 1:step]
                v = q[k - last:k - first + 1:step][::-1]
                if beta:
                    weights = alpha + beta * np.arange(first, last + 1, step)
                    row = np.einsum("i,ij,ij->j", weights, u, v)
                else:
                    row = np.einsum("ij,ij->j", u, v) * alpha
                terms.append((ku ^ kv, row))
        return Trig(self, _merge(terms))


def _merge(terms: Iterable[tuple[int, Array]]) -> Parts:
    parts: Parts = {}
    for kind, row in terms:
        parts[kind] = parts[kind] + row if kind in parts else row
    return parts


class GridTable:
    """Taylor coefficients as rows of one array per kind, with the parities of the rows in use."""

    def __init__(self, ring: FloatRing) -> None:
        self.ring, self.length = ring, 0
        self.parts: dict[int, tuple[Array, set[int]]] = {}

    def __len__(self) -> int:
        return self.length

    def append(self, trig: Trig) -> None:
        k = self.length
        for kind, row in trig.parts.items():
            if kind not in self.parts:
                self.parts[kind] = np.zeros((self.ring.rows, self.ring.points)), set()
            rows, parities = self.parts[kind]
            rows[k] = row
            parities.add(k % 2)
        self.length += 1

    def __getitem__(self, k: int) -> Trig:
        if not 0 <= k < self.length:
            raise IndexError(k)
        return Trig(self.ring, {kind: rows[k] for kind, (rows, parities) in self.parts.items()
                                if k % 2 in parities})

    def cut(self, k: int) -> None:
        for rows, _ in self.parts.values():
            rows[k:self.length] = 0
        self.length = min(k, self.length)
