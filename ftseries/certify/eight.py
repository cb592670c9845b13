r"""Theorem: the figure eight exists, and the Fourier-Taylor series is this close to it.

Formula.  Let Z = X + iY = r_12 / 3^{1/3}, X even and Y odd cosine series of t without the modes
3, 6, 9, … (so S = 0) and mode 0.  Newton's equations are F(Z) = 0 with

.. math::  F_n = n^2 Z_n - [Z G]_n, \quad G = W^{-3/2}, \quad W = X^2 + Y^2, \quad n = 1, 2, 4, 5, …

The unknown u_n is the coefficient of cos nt in X (n even) or Y (n odd), with the norm of
:mod:`ftseries.certify.algebra`.  DF(u) h = n² h - [M h] with the multiplications

.. math::  M_{ij} = δ_{ij} G - 3 W^{-5/2} Z_i Z_j ,

and A is a float inverse of the block n ≤ N, and 1/n² beyond.  With s = ‖W^{-1/2}‖ and z = ‖Z‖ over
the whole ball of radius r*, the second derivative of Z ↦ Z G is at most 9 s⁵ z + 15 s⁷ z³.
"""

from dataclasses import dataclass

import numpy as np
from flint import arb, arb_mat, ctx

from ..errors import InputError
from ..problems.figure_eight import FigureEight, closure_zero
from ..series import DERIVATIVES
from .algebra import RING, Enclosure, NotProved, largest_of, norm, upper
from .newton_kantorovich import Bounds, radius

__all__ = ["EightTheorem", "prove_eight"]


@dataclass(frozen=True)
class EightTheorem:
    """What was proved.

    Attributes
    ----------
    radius : arb
        There is a true eight within this ℓ¹_ν distance (in units of 3^{1/3}) of the coefficients.
    uniqueness : arb
        It is the only one within this distance.
    lam : arb
        A ball that contains λ₀.
    coefficients : dict
        ``{n: float}``, the center ū.
    bounds : Bounds
    nu : arb
    """

    radius: arb
    uniqueness: arb
    lam: arb
    coefficients: dict
    bounds: Bounds
    nu: arb

    def __str__(self):
        b = self.bounds
        return ("Theorem. Newton's equations of three equal bodies have exactly one solution with "
                f"the symmetries of the figure eight within {float(self.uniqueness):.2e} of the "
                f"given Fourier sum, and it lies within {float(self.radius):.2e} of it "
                f"(ℓ¹ norm, ν = {float(self.nu):g}). The bodies never collide. λ₀ = "
                f"{self.lam.str(25)}. [Y = {float(b.y):.2e}, Z₁ = {float(b.z1):.2e}, "
                f"Z₂ = {float(b.z2):.2e}]")


def prove_eight(orbit, modes=100, nu="1.02", precision=256):
    """Prove that a true figure eight lies near an approximate one.

    Parameters
    ----------
    orbit : Solution, Resummed or Orbit of FigureEight
        Anything with ``evaluate`` and, for a series, an attribute ``lam`` or its own zero.
    modes : int
        N, the size of the finite block.
    nu : str or number
        The weight ν of the norm, at least 1.
    precision : int
        Bits.

    Raises
    ------
    NotProved
        The data are too poor for the theorem.
    """
    if not isinstance(getattr(orbit, "problem", None), FigureEight):
        raise InputError(f"{orbit!r} is not a figure eight")
    with ctx.workprec(precision):
        nu = arb(str(nu))
        if not nu >= 1:
            raise InputError(f"nu={nu}: the weight must be at least 1")
        return _prove(_center(orbit, modes), modes, nu)


def _center(orbit, modes):
    """u_n of the approximate solution, as floats, after a projection on the symmetric modes."""
    points = 8 * modes
    t = 2 * np.pi * np.arange(points) / points
    lam = getattr(orbit, "lam", None)
    if lam is None:
        lam = closure_zero(orbit)
    z = (orbit.evaluate("r", t, lam=lam) / 3 ** (1 / 3)
         * np.exp(1j * orbit.evaluate("phi", t, lam=lam)))
    x, y = (np.fft.rfft(part).real * 2 / points for part in (z.real, z.imag))
    return {n: float((y if n % 2 else x)[n]) for n in range(1, modes + 1) if n % 3}


def _prove(u, modes, nu):
    wave = {0: RING.from_modes({(0, n): arb(c) for n, c in u.items() if n % 2 == 0}),
            1: RING.from_modes({(0, n): arb(c) for n, c in u.items() if n % 2 == 1})}
    x, y = (Enclosure(wave[i], 0, nu) for i in (0, 1))
    w = x * x + y * y
    top = 2 * modes
    v = _inverse_root(u, modes, w, top)
    g = w.negative_power(3, v).cut(top)
    h = w.negative_power(5, v).cut(top)
    part = {0: x, 1: y}
    m = {(i, j): ((g if i == j else g * 0) + h * part[i] * part[j] * -3).cut(top)
         for i in (0, 1) for j in (0, 1)}
    rest = largest_of(m[i, 0].radius + m[i, 1].radius for i in (0, 1)) * 2
    index = [n for n in range(1, modes + 1) if n % 3]
    entry = _entries(m)
    block = arb_mat([[(n * n if n == k else 0) - entry(n, k) for k in index] for n in index])
    floats = np.array([[float(block[i, j].mid()) for j in range(len(index))]
                       for i in range(len(index))])
    inverse = np.linalg.inv(floats)
    a = arb_mat([[arb(float(c)) for c in row] for row in inverse])
    weight = {n: nu**n for n in range(1, modes + 2 * top + 2)}
    norm_a = _column_norm(a, index, index, weight)
    norm_a = largest_of((norm_a, arb(1) / (modes + 1) ** 2))
    y_bound = _y(u, x, y, g, a, index, modes, weight, norm_a)
    z1 = _z1(a, block, entry, m, index, modes, top, weight, norm_a * rest)
    largest = arb("1e-6")
    z2 = _z2(w, v, x, y, norm_a, largest)
    bounds = Bounds(y_bound, z1, z2, largest)
    low, high = radius(bounds)
    return EightTheorem(low, high, _lam(x, y, w, v, low), u, bounds, nu)


def _inverse_root(u, modes, w, top):
    """A finite sum close to W^{-1/2}: from floats, then Newton's iteration in balls."""
    points = 8 * modes
    t = 2 * np.pi * np.arange(points) / points
    x = sum(c * np.cos(n * t) for n, c in u.items() if n % 2 == 0)
    y = sum(c * np.cos(n * t) for n, c in u.items() if n % 2)
    coefficients = np.fft.rfft((x * x + y * y) ** -0.5).real * 2 / points
    coefficients[0] /= 2
    v = RING.from_modes({(0, n): arb(float(coefficients[n])) for n in range(0, top + 1, 2)})
    three = RING.from_modes({(0, 0): arb(3)})
    for _ in range(2):
        v = v * (three + (v * v * w.center).scale(arb(-1)))
        modes_of_v = {mode: c.mid() / 2 for mode, c in v.modes().items() if mode[1] <= top}
        v = RING.from_modes(modes_of_v)
    return v


def _entries(m):
    """(n, k) ↦ the coefficient of cos nt in M cos kt."""
    modes = {key: e.center.modes() for key, e in m.items()}

    def entry(n, k):
        series = modes[n % 2, k % 2]
        low, high = abs(n - k), n + k
        total = series.get((0, high), arb(0))
        total += series.get((0, low), arb(0)) * (2 if low == 0 else 1)
        return total / 2
    return entry


def _column_norm(matrix, rows, columns, weight):
    worst = arb(0)
    for j, k in enumerate(columns):
        total = arb(0)
        for i, n in enumerate(rows):
            total += upper(matrix[i, j]) * weight[n]
        worst = largest_of((worst, total / weight[k]))
    return worst


def _y(u, x, y, g, a, index, modes, weight, norm_a):
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


def _z1(a, block, entry, m, index, modes, top, weight, rest):
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


def _z2(w, v, x, y, norm_a, largest):
    """Bound of the second derivative over the ball of radius ``largest``."""
    size = norm(x.center, x.nu) + norm(y.center, x.nu) + largest
    wide = Enclosure(w.center, w.radius + 2 * size * largest + largest**2, w.nu)
    s = wide.negative_power(1, v).norm()
    return upper(norm_a * (9 * s**5 * size + 15 * s**7 * size**3))


def _lam(x, y, w, v, distance):
    """λ₀ = amplitude of cos t in φ = arg Z, from φ' = (X Y' - Y X') / W."""
    derivative = [_derivative(part) for part in (x, y)]
    rate = (x * derivative[1] + y * derivative[0] * -1) * w.negative_power(2, v)
    value = -rate.center.modes()[1, 1]
    s = w.negative_power(1, v).norm()
    error = rate.radius / w.nu + 4 / arb.pi() * (distance * s / (1 - distance * s))
    return value + arb(0, upper(error))


def _derivative(part):
    if not part.radius == 0:
        raise NotProved("not proved: the derivative of an enclosure needs a finite sum")
    return Enclosure(part.center.multiply_modes(DERIVATIVES[1]), 0, part.nu)
