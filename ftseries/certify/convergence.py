r"""Theorem: the Fourier-Taylor series of the figure eight converges.

Formula.  In units of 3^{1/3} let Z = ρ e^{iφ} and, for a radius κ, λ² = κ² μ.  Then Z = u + i √μ y
with u = ρ cos φ and y = ρ sin φ / √μ, both power series in μ, and with W = ρ² = u² + μ y²

.. math::  F_n = n^2 x_n - [x W^{-3/2}]_n \ (n = 1, 2, 4, 5, …), \qquad F_0 = [χ]_1 - κ .

The unknowns x_n are the amplitudes of cos nt in u (n even) or y (n odd); x_0 = [u]_0 stays free,
since the equations lack the mode 0, and F_0 is the meaning of λ: φ = √μ χ and
dχ = (u dy - y du)/W.  All this takes place in the algebra of
:mod:`ftseries.certify.fourier_taylor`: a zero of F *is* a family analytic in |λ| < κ.  Its Taylor
coefficients solve the equations order by order, so they are those of the paper.

A is a matrix of polynomials in μ for n ≤ N, and 1/n² beyond; the bounds are those of
:mod:`ftseries.certify.convergence_bounds`.  A is injective as in
:mod:`ftseries.certify.newton_kantorovich`: a square matrix over a commutative ring, here the power
series in μ, that is onto has an inverse.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb

from ..aliases import Array, ComplexArray, Exact, FilePath
from ..arguments import whole
from ..errors import InputError
from ..precision import working
from ..problems.figure_eight import is_gravitational
from . import certificate
from .algebra import given, upper, written
from .balls import NotProved, at_least, at_most
from .convergence_bounds import GUESS, INVERSE, Matrix, Rows, block, prove
from .eight import EightTheorem
from .fourier_taylor import Integers, Space
from .newton_kantorovich import Bounds

__all__ = ["ConvergenceTheorem", "prove_convergence"]

PRECISION = 128


@dataclass(frozen=True)
class ConvergenceTheorem:
    """What was proved.

    Attributes
    ----------
    lam : str
        The series converge absolutely for all complex λ up to this modulus, κ.
    norms : dict
        ``{"r": arb, "phi": arb}``, bounds of Σ |A_{n,m}| κ^m (in the paper's unit of length) and
        of Σ |B_{n,m}| κ^m.
    radius, uniqueness : arb
        The distance of u and y from the center, and how far they are alone.
    sizes, rest : dict
        For r and φ: Σ_n |amplitudes| at each power of μ, and a bound on what they miss.
    center, root : dict
        ``{n: [integers]}``, x̄ and v in units of 2^-60; ``inverse`` the matrix in units of 2^-30.
    bounds : Bounds
    modes, orders : int
        N, and the number of powers of μ.
    """

    lam: str
    norms: dict[str, arb]
    radius: arb
    uniqueness: arb
    sizes: dict[str, list[arb]]
    rest: dict[str, arb]
    center: Rows
    root: Rows
    inverse: Matrix
    bounds: Bounds
    modes: int
    orders: int

    def __str__(self) -> str:
        b = self.bounds
        return ("Theorem. The Fourier-Taylor series of the figure eight converge absolutely for "
                f"all |λ| ≤ {self.lam}: Σ|A_nm||λ|^m ≤ {at_most(self.norms['r'])}, "
                f"Σ|B_nm||λ|^m ≤ {at_most(self.norms['phi'])}. [N = {self.modes}, "
                f"{self.orders} powers of λ², Y = {at_most(b.y)}, Z₁ = {at_most(b.z1)}, "
                f"Z₂ = {at_most(b.z2)}, within {at_most(self.radius)}, alone within "
                f"{at_least(self.uniqueness)}]")

    def tail(self, name: str, order: int, lam: Exact) -> arb:
        """A bound of all terms of r or φ beyond the Taylor order ``order``, at |λ| ≤ ``lam``.

        Examples
        --------
        >>> import ftseries as fts
        >>> series = fts.solve(fts.FigureEight(), order=60, arithmetic="float")
        >>> theorem = fts.certify.prove_convergence(series, lam="1.5", modes=30)
        >>> theorem.tail("r", 30, "1.2") < 1e-9
        True
        """
        if name not in self.sizes:
            raise InputError(f"{name!r} is not an unknown of the figure eight: 'r' or 'phi'")
        with working(bits=PRECISION):
            q = given("lam", lam) / arb(self.lam)
            if not (q >= 0 and q <= 1):
                raise InputError(f"lam={lam}: the theorem is about 0 ≤ λ ≤ {self.lam}")
            odd = int(name == "phi")
            powers = [2 * m + odd for m in range(len(self.sizes[name]))]
            first = min(m for m in (order + 1, order + 2) if m % 2 == odd)
            known = sum((upper(s) * q**m for m, s in zip(powers, self.sizes[name]) if m > order),
                        arb(0))
            return upper(known + self.rest[name] * q**first)

    def identify(self, eight: EightTheorem) -> arb:
        """Prove that the sum of the series at λ₀ is the proved figure eight.

        Parameters
        ----------
        eight : EightTheorem

        Returns
        -------
        arb
            A bound on the distance of its u and y from the center, below ``uniqueness``.

        Raises
        ------
        NotProved
            λ₀ is not in the disc, or the two are not close enough to be the same.
        """
        with working(bits=PRECISION):
            root_mu = eight.lam / arb(self.lam)
            if not root_mu < 1:
                raise NotProved(f"not proved: λ₀ = {eight.lam.str(8)} is not below {self.lam}")
            gap = upper(eight.radius / root_mu)
            for n in set(self.center) | set(eight.center):
                value = sum((c * root_mu ** (2 * m)
                             for m, c in enumerate(self.center.get(n, ()))), arb(0))
                own = arb(eight.center.get(n, 0.0)) / (root_mu if n % 2 else 1)
                gap += upper(value / 2**GUESS - own)
            if not gap < self.uniqueness:
                raise NotProved(f"not proved: the sum at λ₀ and the eight may be {float(gap):.3g} "
                                f"apart, and the sum is alone within {float(self.uniqueness):.3g}")
            return upper(gap)

    def save(self, path: FilePath) -> None:
        """Write a certificate: the claims, and what :func:`ftseries.certify.check` needs."""
        exact = certificate.exact
        certificate.write(path, {
            "theorem": "convergence", "precision": PRECISION, "lam": self.lam,
            "modes": self.modes, "orders": self.orders,
            "center": [[n, *row] for n, row in self.center.items()],
            "root": [[n, *row] for n, row in self.root.items()], "inverse": self.inverse,
            "radius": exact(self.radius), "uniqueness": exact(self.uniqueness),
            "largest": exact(self.bounds.largest),
            "norms": {name: exact(value) for name, value in self.norms.items()}})


def prove_convergence(series: Any, lam: Exact = "2.08", modes: int = 40,
                      orders: int | None = None) -> ConvergenceTheorem:
    """Prove that the Fourier-Taylor series of the figure eight converges in a disc of λ.

    Parameters
    ----------
    series : Solution of FigureEight
        Its coefficients, as floats, are the approximation; its order limits how far one gets.
    lam : str or number
        The radius κ of the disc.
    modes : int
        N, the size of the finite block.
    orders : int, optional
        The number of powers of λ², when it is to be another than that of the series: the
        approximation is then improved by Newton's method at many λ with |λ| = κ.

    Raises
    ------
    NotProved
        The data are too poor for the theorem; the message shows the constants.

    Examples
    --------
    >>> import ftseries as fts
    >>> series = fts.solve(fts.FigureEight(), order=60, arithmetic="float")
    >>> print(fts.certify.prove_convergence(series, lam=1, modes=20))  # doctest: +ELLIPSIS
    Theorem. The Fourier-Taylor series of the figure eight converge absolutely for all |λ| ≤ 1: ...
    """
    if not is_gravitational(series) or not hasattr(series, "table"):
        raise InputError(f"{series!r} is not a series of the figure eight")
    modes = whole("modes", modes, 4)
    orders = orders if orders is None else whole("orders", orders, 1)
    with working(bits=PRECISION):
        kappa = given("lam", lam := written("lam", lam))
        if not (kappa > 0 and kappa < 10):
            raise InputError(f"lam={lam}: the radius of the disc must be above 0 (and below 10)")
        space = Space(2 * modes, orders or series.order // 2 + 1)
        center, root, inverse = _guesses(series, float(kappa), space, modes, 4 * bool(orders))
        return ConvergenceTheorem(lam=lam, center=center, root=root, inverse=inverse,
                                  modes=modes, orders=space.orders,
                                  **prove(center, root, inverse, kappa, space, modes))


# --- guesses, in floats: values on the circle |μ| = 1, whose Fourier sums in μ are Taylor's

def _guesses(series: Any, kappa: float, space: Space, modes: int,
             polish: int) -> tuple[Integers, Integers, list[list[list[int]]]]:
    turns, points = 4 * space.orders, 8 * modes
    root_mu = np.exp(1j * np.pi * np.arange(turns) / turns)[:, None]
    t = 2 * np.pi * np.arange(points) / points
    powers = (kappa * root_mu) ** np.arange(series.order + 1)

    def values(name: str) -> ComplexArray:
        total: ComplexArray = np.zeros((turns, points), complex)
        for (_, n), row in series.table(name).items():
            total += np.outer(powers[:, :len(row)] @ np.array(row), np.cos(n * t))
        return total

    rho, phi = values("r") / 3 ** (1 / 3), values("phi")
    try:
        with np.errstate(all="ignore"):
            u, y, v = rho * np.cos(phi), rho * np.sin(phi) / root_mu, rho**-1
            for _ in range(polish):
                u, y, v = _newton_step(u, y, v, root_mu**2, kappa, t, modes, space.top)
            if not max(abs(f).max() for f in (u, y, v)) < 2**10:
                raise NotProved(f"not proved: the given series grows too fast at {kappa:.6g}")
            inverse = np.linalg.inv(_derivative(u, y, v, root_mu**2, modes)).astype(complex)
    except np.linalg.LinAlgError:
        raise NotProved(f"not proved: DF has no inverse at some |λ| = {kappa:.6g}") from None
    table, root = _taylor(_fourier(u + y), space.orders), _taylor(_fourier(v), space.orders)
    matrix = _taylor(inverse, space.orders)
    rest = np.cumsum(abs(matrix[::-1]).sum(axis=1), axis=0)[::-1] * (1 + np.square(block(modes)))
    matrix = matrix[:max(1, np.count_nonzero(rest.max(axis=1) > 0.01))]
    whole = np.rint(matrix * 2**INVERSE).astype(int)
    return ({n: _integers(table[:, n]) for n in block(space.top)},
            {n: _integers(root[:, n]) for n in range(0, space.top + 1, 2)},
            np.moveaxis(whole, 0, 2).tolist())


def _newton_step(u: ComplexArray, y: ComplexArray, v: ComplexArray, mu: ComplexArray, kappa: float,
                 t: Array, modes: int, top: int) -> tuple[Any, Any, Any]:
    """Newton's method for n ≤ N, and x_n = [x W^{-3/2}]_n / n² beyond, at each value of μ."""
    x, force, n = _fourier(u + y), _fourier((u + y) * v**3), np.arange(top + 1)
    waves, slopes = np.cos(np.outer(n, t)), -n[:, None] * np.sin(np.outer(n, t))
    du, dy = (x[:, i:top + 1:2] @ slopes[i::2] for i in (0, 1))
    residual = n**2 * x[:, :top + 1] - force[:, :top + 1]
    residual[:, 0] = -2 * ((u * dy - y * du) * v * v * np.sin(t)).mean(axis=1) - kappa
    inner, outer = block(modes), [k for k in block(top) if k > modes]
    new = np.zeros((len(x), top + 1), complex)
    step = np.linalg.solve(_derivative(u, y, v, mu, modes), residual[:, inner, None])
    new[:, inner], new[:, outer] = x[:, inner] - step[:, :, 0], force[:, outer] / n[outer] ** 2
    u, y = (new[:, i::2] @ waves[i::2] for i in (0, 1))
    root = (u * u + mu * y * y) ** -0.5
    return u, y, np.where(abs(root - v) < abs(root + v), root, -root)


def _integers(row: Array) -> list[int]:
    return [int(c) for c in np.rint(np.ldexp(row, GUESS))]


def _taylor(values: ComplexArray, orders: int) -> Any:
    taylor: Array = np.fft.fft(values, axis=0).real[:orders] / len(values)
    return taylor


def _fourier(f: ComplexArray) -> Any:
    """Amplitudes of cos nt at each value of μ."""
    c: ComplexArray = np.fft.fft(f, axis=1)[:, :f.shape[1] // 2] * 2 / f.shape[1]
    c[:, 0] /= 2
    return c


def _derivative(u: ComplexArray, y: ComplexArray, v: ComplexArray, mu: ComplexArray,
                modes: int) -> Any:
    """The block of DF at each value of μ."""
    g, h = v**3, v**5
    m = [[_fourier(g - 3 * u * u * h), _fourier(-3 * mu * u * y * h)],
         [_fourier(-3 * u * y * h), _fourier(g - 3 * mu * y * y * h)]]
    angle = [_fourier(-y * v * v), _fourier(u * v * v)]

    def entry(n: int, k: int) -> Any:
        f, row = (m[n % 2][k % 2], n) if n else (angle[k % 2], 1)
        low = abs(row - k)
        value: ComplexArray = (f[:, low] * (1 if low else 2) + f[:, row + k]) / 2
        return (n * n if n == k else 0) - value if n else value

    index = block(modes)
    return np.moveaxis(np.array([[entry(n, k) for k in index] for n in index]), 2, 0)
