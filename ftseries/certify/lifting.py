r"""A thousand digits from fifteen: Newton's iteration with an inverse in double precision.

Formula.  The unknowns and F are those of :mod:`ftseries.certify.eight`.  Let B be nearly the
inverse of DF at the solution u*, with ‖I - B DF‖ = q.  Then u ↦ u - B F(u) leaves the error

.. math::  u - B F(u) - u^* = (I - B\,DF)(u - u^*) + O(\|u - u^*\|^2),

so each pass gains the same number of digits, -log10 q, as long as F itself is evaluated with them
all.  In double precision q is about 1e-15.  B is applied as δ ← δ + A (F - DF δ), where A is the
inverse of a small block and 1/n² beyond, and DF δ is a product on a grid of times, by FFT.

Numbers are integers in units of 2^{-bits}; a function is the list of its coefficients a_n of
e^{int} for n = 0, 2, 4, … or n = 1, 3, 5, …, a_{-n} = a_n, and products are those of FLINT's
polynomials.  Nothing here is rigorous, nor need it be: the result is a guess, for
:mod:`ftseries.certify.digits`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from flint import fmpz, fmpz_poly

from ..aliases import Array, ArrayLike

__all__ = ["Pass", "lift"]

GAIN = 48               # bits per pass, of the 53 that a float has
GUARD = 30              # bits for the rounding of products, beyond those of the unknowns
SHORT = 120             # bits that matter in a factor of something small
#: u_n falls like e^{-σn}: |Z|² has a zero at the complex time π/2 + σi (measured in the book)
DECAY = 0.4947

Half: TypeAlias = list[fmpz]            # a_n for n = 0, 2, 4, … or n = 1, 3, 5, …


@dataclass(frozen=True)
class Pass:
    """Where the iteration stands.

    Attributes
    ----------
    bits : int
        Unit 2^{-bits}.
    u : dict
        ``{n: fmpz}``, the unknowns u_n in this unit.
    root : list of fmpz
        The coefficients 0, 2, 4, … of |Z|^{-1}, as in the module's formula, in the unit
        2^{-root_bits}.
    correction : float
        Sum of the absolute corrections of this pass, as a power of ten.
    """

    bits: int
    u: dict[int, fmpz]
    root: Half
    root_bits: int
    correction: float


def lift(center: Mapping[int, float], inverse: ArrayLike, bits: int) -> Iterator[Pass]:
    """Raise an approximate solution to more and more bits; yields a :class:`Pass` each.

    Parameters
    ----------
    center : dict
        ``{n: float}``, the unknowns in double precision.
    inverse : array_like
        A, the inverse of the block of the modes of ``center``.
    bits : int
        How many are wanted in the end.

    Examples
    --------
    >>> import ftseries as fts
    >>> theorem = fts.certify.prove_eight(fts.solve(fts.FigureEight(), order=6).refine())
    >>> [state.bits for state in lift(theorem.center, theorem.inverse, 200)]
    [98, 146, 194, 200]
    """
    known = 50
    u = {n: fmpz(int(np.ldexp(c, known))) for n, c in center.items()}
    v: Half = []
    matrix = np.asarray(inverse, dtype=float)
    while known < bits:
        step = min(GAIN, bits - known)
        known += step
        modes = int(known * np.log(2) / DECAY) + 10
        u = {n: u.get(n, fmpz(0)) << step for n in range(1, modes + 1) if n % 3}
        v = [c << step for c in v] if v else _first_root(center, known + GUARD)
        for _ in range(2 if known < 200 else 1):                # the float root is poor at first
            residual, v = _residual(u, v, known + GUARD, modes)
        delta = _solve(center, matrix, residual)
        for n in u:
            u[n] -= int(np.rint(delta[n]))
        if known == bits:
            _, v = _residual(u, v, known + GUARD, modes)        # the root of the last u
        yield Pass(known, dict(u), v, known + GUARD,
                   float(np.log10(np.abs(delta).sum() + 1) - known * np.log10(2)))


def _times(a: Half, odd_a: bool, b: Half, odd_b: bool, bits: int, length: int) -> list[fmpz]:
    """The product of two functions, at most ``length`` coefficients of it."""
    p, q = ([*f[::-1], *f[0 if odd else 1:]] for f, odd in ((a, odd_a), (b, odd_b)))
    product = fmpz_poly(p) * (fmpz_poly(q) if b is not a else fmpz_poly(p))
    start = (len(p) + len(q) - 1) // 2
    return [c >> bits for c in product.coeffs()[start:start + length]]


def _residual(u: Mapping[int, fmpz], v: Half, bits: int, modes: int) -> tuple[Array, list[fmpz]]:
    """F(u) as floats in the unit of u, and |Z|^{-1} improved."""
    length = modes // 2 + 40
    scale = GUARD - 1                                           # u_n = 2 a_n
    x = [u.get(n, fmpz(0)) << scale for n in range(0, modes + 1, 2)]
    y = [u.get(n, fmpz(0)) << scale for n in range(1, modes + 1, 2)]
    w = _plus(_times(x, False, x, False, bits, length), _times(y, True, y, True, bits, length))
    square = _times(v, False, v, False, bits, length)
    e = [-c for c in _times(square, False, w, False, bits, length)]
    e[0] += fmpz(1) << bits                                     # 1 - v² W, small
    double = _times(e, False, e, False, bits, length)
    cube = _times(square, False, v, False, bits, length)
    v, force = (_plus(f, _short(f, [(4 * c + (k + 2) * d) * k >> 3        # (1 - e)^{-k/2} - 1
                                    for c, d in zip(e, double)], bits, length))
                for f, k in ((v, 1), (cube, 3)))
    product = (_times(x, False, force, False, bits, length),
               _times(y, True, force, False, bits, length))
    residual = np.zeros(modes + 1)
    for n, c in u.items():
        residual[n] = int(c * n * n - (product[n % 2][n // 2] >> scale))
    return residual, v


def _short(f: Half, e: Half, bits: int, length: int) -> list[fmpz]:
    """The product of f with a small e: a few leading bits of f suffice."""
    cut = max(0, bits - SHORT)
    short = [c >> cut for c in f]
    while len(short) > 1 and abs(short[-1]) <= 1:
        short.pop()
    return _times(short, False, e, False, bits - cut, length)


def _plus(a: Half, b: Half) -> list[fmpz]:
    short, long = sorted((a, b), key=len)
    return [c + d for c, d in zip(short, long)] + long[len(short):]


def _first_root(center: Mapping[int, float], bits: int) -> list[fmpz]:
    points = 16 * max(center)
    x, y = _waves(center, points)
    a = np.fft.rfft((x * x + y * y)**-0.5).real[:3 * max(center):2] / points
    return [fmpz(int(np.ldexp(c, 60))) << (bits - 60) for c in a]


def _waves(h: Mapping[int, float], points: int) -> Any:
    """The even and the odd part of Σ h_n cos nt on a grid."""
    spectrum = np.zeros((2, points // 2 + 1))
    for n, c in h.items():
        spectrum[n % 2, n] = c * points / 2
    return np.fft.irfft(spectrum)


def _solve(center: Mapping[int, float], inverse: Array, residual: Array) -> Array:
    """B F: the solution δ of DF δ = F in double precision."""
    modes = len(residual) - 1
    points = 1 << (2 * modes + 400).bit_length()
    x, y = _waves(center, points)
    square = x * x + y * y
    g, h = square**-1.5, 3 * square**-2.5
    n = np.arange(modes + 1)
    kept, block = n % 3 > 0, list(center)

    def derivative(delta: Array) -> Array:
        spectrum = np.zeros((2, points // 2 + 1))
        for parity in (0, 1):
            spectrum[parity, parity:modes + 1:2] = delta[parity::2] * (points / 2)
        dx, dy = np.fft.irfft(spectrum)
        along = h * (x * dx + y * dy)
        force = np.fft.rfft(g * (dx + dy) - along * (x + y)).real[:modes + 1]
        return (n * n * delta - force * (2 / points)) * kept

    delta = np.zeros(modes + 1)
    for _ in range(10):
        rest = residual - derivative(delta)
        step = np.divide(rest, n * n, out=np.zeros(modes + 1), where=kept)
        step[block] = inverse @ rest[block]
        delta += step
    return delta
