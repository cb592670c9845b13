r"""A problem's equations at one value of λ: functions sampled on a uniform grid of τ.

Formula.  A :class:`Samples` object makes functions u(τ_j), τ_j = 2πj/M, with the operations of
:class:`ftseries.series.Series`, so the same declaration of a problem gives its residual at a
number λ.  Derivatives and shifts act on the discrete Fourier transform.  Values may be complex and
may have leading axes: a step i·h along many modes at once gives the exact derivative.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from flint import fmpq
from numpy.typing import NDArray

from .aliases import ArrayLike, Exact
from .arguments import quotient, rational
from .errors import InputError
from .function import Function

__all__ = ["Samples", "Sampled"]

#: what stands beside a function in a formula: another one, or a number
Operand: TypeAlias = Any


class Samples:
    """The grid with M points; it makes λ, parameters, known functions as an ``Expansion`` does."""

    def __init__(self, points: int, lam: ArrayLike = 0.0,
                 parameters: Mapping[str, float] | None = None) -> None:
        self.points, self.parameters = points, parameters or {}
        self.tau = 2 * np.pi * np.arange(points) / points
        self.n = np.fft.fftfreq(points, 1 / points)
        if points % 2 == 0:
            self.n[points // 2] = 0                      # this mode has no derivative on the grid
        self.lam = self.constant(lam)

    def constant(self, number: Any) -> Sampled:
        """A number, or an array of them along leading axes."""
        if not isinstance(number, (int, float, complex, np.ndarray, np.number)):
            number = quotient(rational(number))
        return Sampled(self, (np.asarray(number) + 0.0)[..., None])

    def parameter(self, name: str) -> Sampled:
        return self.constant(self.parameters[name])

    def cos(self, n: int) -> Sampled:
        return Sampled(self, np.cos(n * self.tau))

    def sin(self, n: int) -> Sampled:
        return Sampled(self, np.sin(n * self.tau))


class Sampled(Function):
    """One function on the grid; ``derivatives`` are known where its coefficients are.

    The derivative of samples alone multiplies their rounding by n, the second one by n².
    """

    def __init__(self, samples: Samples, values: NDArray[Any],
                 derivatives: Sequence[NDArray[Any]] = ()) -> None:
        self.expansion, self.values, self.derivatives = samples, values, derivatives

    def _new(self, values: NDArray[Any]) -> Sampled:
        return Sampled(self.expansion, values)

    def _sum(self, other: Sampled) -> Sampled:
        return self._new(self.values + other.values)

    def _product(self, other: Sampled) -> Sampled:
        return self._new(self.values * other.values)

    def _multiple(self, number: Operand) -> Sampled:
        return self._product(self.expansion.constant(number))

    def __truediv__(self, other: Operand) -> Sampled:
        return self._new(self.values / self._function(other).values)    # rounds once

    def __rtruediv__(self, other: Operand) -> Sampled:
        return self._function(other) / self

    def __pow__(self, alpha: Exact) -> Sampled:
        return self._power(rational(alpha))

    def _power(self, alpha: fmpq) -> Sampled:
        if alpha.q == 1:
            return self._new(self.values ** int(alpha.p))
        return self._new(self.values ** (int(alpha.p) / int(alpha.q)))

    def sin(self) -> Sampled:
        return self._new(np.sin(self.values))

    def cos(self) -> Sampled:
        return self._new(np.cos(self.values))

    def exp(self) -> Sampled:
        return self._new(np.exp(self.values))

    def diff(self, times: int = 1) -> Sampled:
        if times not in (1, 2):
            raise InputError(f"a derivative of order {times!r} is not offered; use 1 or 2")
        if self.derivatives:
            return self._new(self.derivatives[times - 1])
        return self._filter((1j * self.expansion.n) ** times)

    def shift(self, fraction: Exact) -> Sampled:
        fraction = rational(fraction)
        turns = int(fraction.p) / int(fraction.q) * np.fft.fftfreq(
            self.expansion.points, 1 / self.expansion.points)
        return self._filter(np.exp(2j * np.pi * turns))

    def neighbours(self, bodies: int = 3) -> Sampled:
        n = np.rint(np.fft.fftfreq(self.expansion.points, 1 / self.expansion.points))
        return self._filter(np.where(n % bodies == 0, bodies - 1.0, -1.0))

    def _filter(self, multiplier: NDArray[Any]) -> Sampled:
        if np.iscomplexobj(self.values):     # apart, or rounding of one would drown the other
            real, imag = self._new(self.values.real), self._new(self.values.imag)
            return self._new(real._filter(multiplier).values + 1j * imag._filter(multiplier).values)
        points = self.expansion.points
        full = np.broadcast_to(self.values, self.values.shape[:-1] + (points,))
        half = np.fft.rfft(full, axis=-1) * multiplier[:points // 2 + 1]
        return self._new(np.fft.irfft(half, points, axis=-1))
