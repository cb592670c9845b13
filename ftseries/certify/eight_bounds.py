r"""The bounds Y, Z₁, Z₂ of the proof that the figure eight exists.

Formula.  The equations, the unknowns u_n, M and A are those of :mod:`ftseries.certify.eight`.  In
the modes n > N, where A is 1/n², and for modes k > N, the bounds are those of their norms.  With
s = ‖W^{-1/2}‖ and z = ‖Z‖ over the whole ball of radius r*, the second derivative of Z ↦ Z G is at
most 9 s⁵ z + 15 s⁷ z³.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, TypeAlias

from flint import arb, arb_mat

from .algebra import Enclosure, largest_of, upper

if TYPE_CHECKING:
    from ..trig import Trig

__all__ = ["entries", "inverse_norm", "residual_bound", "z1_bound", "z2_bound"]

#: the operators M_ij
Blocks: TypeAlias = dict[tuple[int, int], Enclosure]


def entries(m: Blocks) -> Callable[[int, int], arb]:
    """(n, k) ↦ the coefficient of cos nt in M cos kt."""
    modes = {key: e.center.modes() for key, e in m.items()}

    def entry(n: int, k: int) -> arb:
        series = modes[n % 2, k % 2]
        low, high = abs(n - k), n + k
        total: arb = series.get((0, high), arb(0))
        total += series.get((0, low), arb(0)) * (2 if low == 0 else 1)
        return total / 2
    return entry


def inverse_norm(a: arb_mat, index: list[int], modes: int, weight: dict[int, arb]) -> arb:
    """‖A‖: the largest column of the block, or 1/(N + 1)²."""
    worst = arb(1) / (modes + 1) ** 2
    for j, k in enumerate(index):
        total = arb(0)
        for i, n in enumerate(index):
            total += upper(a[i, j]) * weight[n]
        worst = largest_of((worst, total / weight[k]))
    return worst


def residual_bound(u: Mapping[int, Any], x: Enclosure, y: Enclosure, g: Enclosure, a: arb_mat,
                   index: list[int], modes: int, weight: dict[int, arb], norm_a: arb) -> arb:
    """Y: a bound of ‖A F(u)‖; ``u`` may have more modes than the block."""
    product = {0: x * g, 1: y * g}
    values = {}
    for i in (0, 1):
        for (_, n), c in product[i].center.modes().items():
            if n % 3:
                values[n] = -c
    for n, c in u.items():
        values[n] = values.get(n, arb(0)) + n * n * arb(c)
    inside = a * arb_mat([[values.get(n, arb(0))] for n in index])
    total = arb(0)
    for i, n in enumerate(index):
        total += upper(inside[i, 0]) * weight[n]
    for n, c in values.items():
        if n > modes:
            total += upper(c) / n**2 * weight[n]
    return upper(total + norm_a * (product[0].radius + product[1].radius))


def z1_bound(a: arb_mat, block: arb_mat, entry: Callable[[int, int], arb], m: Blocks,
             index: list[int], modes: int, top: int, weight: dict[int, arb], rest: arb) -> arb:
    """Z₁: a bound of ‖1 - A DF(u)‖, column by column; ``rest`` is what the entries leave out."""
    size = len(index)
    unit = arb_mat(size, size, [int(i == j) for i in range(size) for j in range(size)])
    inside = unit - a * block
    worst = arb(0)
    # the columns of the block: the error of the inverse, and what M sends beyond the block
    for j, k in enumerate(index):
        total = arb(0)
        for i, n in enumerate(index):
            total += upper(inside[i, j]) * weight[n]
        for n in range(modes + 1, modes + top + 1):
            if n % 3:
                total += upper(entry(n, k)) / n**2 * weight[n]
        worst = largest_of((worst, total / weight[k]))
    # the next columns: what M sends into the block and beyond
    beyond = [k for k in range(modes + 1, modes + top + 1) if k % 3]
    coupling = a * arb_mat([[entry(n, k) for k in beyond] for n in index])
    for j, k in enumerate(beyond):
        total = arb(0)
        for i, n in enumerate(index):
            total += upper(coupling[i, j]) * weight[n]
        for n in range(modes + 1, k + top + 1):
            if n % 3 and n <= modes + 2 * top:
                total += upper(entry(n, k)) / n**2 * weight[n]
        worst = largest_of((worst, total / weight[k]))
    # all others: they stay beyond the block
    far = largest_of(m[0, j].norm() + m[1, j].norm() for j in (0, 1)) / (modes + 1) ** 2
    return upper(largest_of((worst, far)) + rest)


def z2_bound(w: Enclosure, v: Trig, x: Enclosure, y: Enclosure, norm_a: arb, largest: arb) -> arb:
    """Bound of the second derivative over the ball of radius ``largest``."""
    size = upper(x.norm() + y.norm() + largest)
    wide = Enclosure(w.center, w.radius + 2 * size * largest + largest**2, w.nu)
    s = wide.negative_power(1, v).norm()
    return upper(norm_a * (9 * s**5 * size + 15 * s**7 * size**3))
