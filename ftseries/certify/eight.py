r"""Theorem: the figure eight exists, and the Fourier-Taylor series is this close to it.

Formula.  Let Z = X + iY = r_12 / 3^{1/3}, X even and Y odd cosine series of t without the modes
3, 6, 9, … (so S = 0) and mode 0.  Newton's equations are F(Z) = 0 with

.. math::  F_n = n^2 Z_n - [Z G]_n, \quad G = W^{-3/2}, \quad W = X^2 + Y^2, \quad n = 1, 2, 4, 5, …

The unknown u_n is the coefficient of cos nt in X (n even) or Y (n odd), with the norm of
:mod:`ftseries.certify.algebra`.  DF(u) h = n² h - [M h] with the multiplications

.. math::  M_{ij} = δ_{ij} G - 3 W^{-5/2} Z_i Z_j ,

and A is a float inverse of the block n ≤ N, and 1/n² beyond.  The bounds of the proof are in
:mod:`ftseries.certify.eight_bounds`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import acb, arb, arb_mat

from ..aliases import FilePath, Json
from ..arguments import scalar, whole
from ..errors import InputError
from ..precision import working
from ..problems.figure_eight import closure_zero, is_gravitational
from . import certificate
from .algebra import RING, Enclosure, given, largest_of, upper, written
from .balls import at_least, at_most
from .consequences import distance_from, initial_values, lambda_zero
from .eight_bounds import entries, inverse_norm, residual_bound, z1_bound, z2_bound
from .grammar import MOST_BITS
from .newton_kantorovich import Bounds, radius

if TYPE_CHECKING:
    from ..trig import Trig

__all__ = ["EightTheorem", "prove_eight", "waves"]


@dataclass(frozen=True)
class EightTheorem:
    """What was proved; lengths of the center are in units of 3^{1/3}.

    Attributes
    ----------
    radius : arb
        There is a true eight within this ℓ¹_ν distance of the center.
    uniqueness : arb
        It is the only one within this distance.
    distance : arb
        The center and the given r e^{iφ} are at most this far apart: the true eight is within
        radius + distance of the given series.
    lam : arb
        A ball that contains λ₀.
    positions, velocities : tuple of acb
        Balls that contain those of the three bodies at t = 0, in the units of the equations.
    center : dict
        ``{n: float}``, the coefficients ū_n.
    bounds : Bounds
    nu, modes, precision
        As given.
    """

    radius: arb
    uniqueness: arb
    distance: arb
    lam: arb
    positions: tuple[acb, ...]
    velocities: tuple[acb, ...]
    center: dict[int, float]
    root: dict[int, arb]
    inverse: list[list[float]]
    bounds: Bounds
    nu: str
    modes: int
    precision: int

    def __str__(self) -> str:
        b = self.bounds
        with working(bits=self.precision):
            total, alone = upper(self.radius + self.distance), self.uniqueness - self.distance
        return ("Theorem. Newton's equations of three equal bodies have exactly one solution with "
                "the symmetries of the figure eight within "
                f"{at_least(alone)} of the given series, and it lies "
                f"within {at_most(total)} of it (ℓ¹ norm, ν = {self.nu}, unit 3^(1/3)). "
                f"The bodies never collide. λ₀ = {self.lam.str(25)}. [N = {self.modes}, "
                f"Y = {at_most(b.y)}, Z₁ = {at_most(b.z1)}, Z₂ = {at_most(b.z2)}, "
                f"r* = {at_least(b.largest)}]")

    def save(self, path: FilePath) -> None:
        """Write a certificate: the claims, and what :func:`ftseries.certify.check` needs."""
        certificate.write(path, self.contents())

    def contents(self) -> dict[str, Json]:
        """What :meth:`save` writes."""
        return {
            "theorem": "figure eight", "nu": self.nu, "modes": self.modes,
            "precision": self.precision,
            "center": [[n, certificate.exact(arb(c))] for n, c in self.center.items()],
            "root": [[n, certificate.exact(c)] for n, c in self.root.items()],
            "inverse": [[certificate.exact(arb(c)) for c in row] for row in self.inverse],
            "largest": certificate.exact(self.bounds.largest),
            "radius": certificate.exact(self.radius),
            "uniqueness": certificate.exact(self.uniqueness),
            "lam": certificate.ball(self.lam),
            "positions": [[certificate.ball(x) for x in (z.real, z.imag)] for z in self.positions],
            "velocities": [[certificate.ball(x) for x in (z.real, z.imag)]
                           for z in self.velocities]}


def prove_eight(orbit: Any, lam: float | None = None, modes: int = 100, nu: Any = "1.02",
                precision: int = 256) -> EightTheorem:
    """Prove that a true figure eight lies near an approximate one.

    Parameters
    ----------
    orbit : Solution, Resummed or Orbit of FigureEight
        The approximation.  Its float coefficients are taken as exact numbers.
    lam : float, optional
        The value of λ of a series; its own zero of the closure when left out.
    modes : int
        N, the size of the finite block.
    nu : str or number
        The weight ν of the norm, above 1.
    precision : int
        Bits, 53 to 20000.

    Raises
    ------
    NotProved
        The data are too poor for the theorem; the message shows the constants.

    Examples
    --------
    >>> import ftseries as fts
    >>> theorem = fts.certify.prove_eight(fts.solve(fts.FigureEight(), order=6).refine())
    >>> theorem.radius < 1e-13 < 1e-8 < theorem.uniqueness, theorem.lam.str(12, radius=False)
    (True, '2.07568390885')
    """
    if not is_gravitational(orbit):
        raise InputError(f"{orbit!r} is not a figure eight under gravitation")
    modes, precision = whole("modes", modes, 4), whole("precision", precision, 53, MOST_BITS)
    lam = None if lam is None else scalar("lam", lam)
    with working(bits=precision):
        weight = given("nu", nu := written("nu", nu))
        if not weight > 1:
            raise InputError(f"nu={nu}: the weight must be above 1")
        own = getattr(orbit, "lam", lam)
        if lam is not None and own != lam:
            raise InputError(f"lam={lam}: {orbit!r} has its own λ; leave lam out")
        lam = float(closure_zero(orbit) if own is None else own)
        u = _center(orbit, lam, modes)
        proved = _prove(u, modes, weight)
        low, high, v = proved["radius"], proved["uniqueness"], proved.pop("v")
        x, y = waves(u, weight)
        distance = distance_from(orbit, lam, x, y, 2 * modes, low, high)
        positions, velocities = initial_values(u, low, weight)
        return EightTheorem(distance=distance, lam=lambda_zero(x, y, v, low), center=u,
                            positions=positions, velocities=velocities, nu=nu, modes=modes,
                            precision=precision, root={n: c for (_, n), c in v.modes().items()},
                            **proved)


def _center(orbit: Any, lam: float, modes: int) -> dict[int, float]:
    """u_n of the approximate solution, as floats, after a projection on the symmetric modes."""
    points = 8 * modes
    t = 2 * np.pi * np.arange(points) / points
    z = (orbit.evaluate("r", t, lam=lam) / 3 ** (1 / 3)
         * np.exp(1j * orbit.evaluate("phi", t, lam=lam)))
    x, y = (np.fft.rfft(part).real * 2 / points for part in (z.real, z.imag))
    return {n: float((y if n % 2 else x)[n]) for n in range(1, modes + 1) if n % 3}


def waves(u: Mapping[int, Any], nu: Any) -> list[Enclosure]:
    """X and Y."""
    return [Enclosure(RING.from_modes({(0, n): arb(c) for n, c in u.items() if n % 2 == i}), 0, nu)
            for i in (0, 1)]


def _prove(u: Mapping[int, Any], modes: int, nu: arb) -> dict[str, Any]:
    x, y = waves(u, nu)
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
    entry = entries(m)
    block = arb_mat([[(n * n if n == k else 0) - entry(n, k) for k in index] for n in index])
    floats = np.array([[float(block[i, j].mid()) for j in range(len(index))]
                       for i in range(len(index))])
    inverse = np.linalg.inv(floats)
    a = arb_mat([[arb(float(c)) for c in row] for row in inverse])
    weight = {n: nu**n for n in range(1, modes + 2 * top + 2)}
    norm_a = inverse_norm(a, index, modes, weight)
    y_bound = residual_bound(u, x, y, g, a, index, modes, weight, norm_a)
    z1 = z1_bound(a, block, entry, m, index, modes, top, weight, norm_a * rest)
    largest = arb(2) ** -20
    z2 = z2_bound(w, v, x, y, norm_a, largest)
    bounds = Bounds(y_bound, z1, z2, largest)
    low, high = radius(bounds)
    return {"radius": low, "uniqueness": high, "bounds": bounds, "v": v,
            "inverse": inverse.tolist()}


def _inverse_root(u: Mapping[int, Any], modes: int, w: Enclosure, top: int) -> Trig:
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
