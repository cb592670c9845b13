r"""The ansatz: which Fourier and Taylor orders an unknown has.

Index convention and formula.  An unknown :class:`Field` u is a Fourier-Taylor series

.. math::  u(τ; λ) = \sum_m λ^m \Big( \sum_{n \le m} A_{n,m} \cos nτ + B_{n,m} \sin nτ \Big),

of which the declaration keeps cosines, sines or both, all, even or odd Fourier orders n, and all,
even or odd Taylor orders m.  An unknown :class:`Scalar` is Σ_m c_m λ^m: a frequency, an eigenvalue.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .aliases import Mode
from .errors import InputError

__all__ = ["Field", "Scalar", "in_parity"]

_PARITIES = {"all": (0, 1), "even": (0,), "odd": (1,)}
_SINES = {"cos": (0,), "sin": (1,), "both": (0, 1)}


@dataclass(frozen=True)
class Field:
    """An unknown periodic function.

    Parameters
    ----------
    series : "cos", "sin" or "both"
        The Fourier modes of the ansatz.
    modes, powers : "all", "even" or "odd"
        Fourier orders n and Taylor orders m of the ansatz.
    fixed : tuple of int or of (sine, n)
        Modes that the equations do not determine: they keep the coefficients of the seed, and are
        zero where it has none.  A Fourier order n means the cosine and the sine; (0, n) the cosine
        alone, (1, n) the sine alone.

        - ``fixed=(1,)`` with the seed λ cos τ gives λ the meaning "amplitude of cos τ", and the
          sine is zero.  :class:`ftseries.Equations` without a seed takes this one for you:
          λ cos nτ, or λ sin nτ where the ansatz has only sines.
        - ``fixed=((1, 1),)`` alone chooses a phase: there is no sin τ, and the amplitude of cos τ
          is left to the equations.  ``Equations`` without a seed takes such a mode as zero; with
          a seed it stays what the seed gives.

    Examples
    --------
    λ is the amplitude of cos ωt; of a limit cycle the equation settles the amplitude, and only the
    phase is left to choose:

    >>> import ftseries as fts
    >>> free = fts.Equations("x'' + x + x**3 = 0", frequency="omega", unknowns={
    ...     "x": fts.Field("both", modes="odd", fixed=(1,)), "omega": fts.Scalar()})
    >>> free.seed_texts["x"]
    'lam*cos(omega*t)'
    >>> cycle = fts.Equations("x'' + x = (lam**2 - x**2)*x'", frequency="omega", unknowns={
    ...     "x": fts.Field("both", modes="odd", fixed=((1, 1),)), "omega": fts.Scalar()})
    >>> cycle.seed_texts["x"]
    '2*lam*cos(omega*t)'
    """

    series: str = "cos"
    modes: str = "all"
    powers: str = "all"
    fixed: tuple[int | Mode, ...] = ()

    def __post_init__(self) -> None:
        if self.series not in tuple(_SINES):
            raise InputError(f"series={self.series!r}: choose 'cos', 'sin' or 'both'")
        _check_parity(self)
        if not isinstance(self.fixed, tuple) or not all(
                self.has(mode if isinstance(mode, tuple) else self.mode(mode))
                for mode in self.fixed):
            raise InputError(f"fixed={self.fixed!r}: give a tuple of Fourier orders n of the "
                             "ansatz, such as (1,), or of modes (sine, n)")

    def columns(self, top: int) -> list[Mode]:
        """The modes (sine, n) of the ansatz with n ≤ top, highest first."""
        return [(sine, n) for n in range(top, -1, -1) for sine in (0, 1)
                if self.has((sine, n)) and not self.is_fixed((sine, n))]

    def has(self, mode: tuple[Any, ...]) -> bool:
        """Is this mode (sine, n) part of the ansatz?"""
        sine, n = mode if len(mode) == 2 else (None, None)
        return (type(n) is type(sine) is int and n >= 0 and sine in _SINES[self.series]
                and in_parity(self.modes, n) and (n > 0 or not sine))

    def is_fixed(self, mode: Mode) -> bool:
        """Does the seed give this mode (sine, n) completely?"""
        return mode in self.fixed or mode[1] in self.fixed

    def mode(self, key: int | Mode) -> Mode:
        """A mode given by hand: n, or (sine, n) where both kinds occur."""
        if isinstance(key, tuple):
            return key
        return (1 if self.series == "sin" else 0), key


@dataclass(frozen=True)
class Scalar:
    """An unknown number that depends on λ alone; ``powers`` as for :class:`Field`."""

    powers: str = "all"
    modes = "all"

    def __post_init__(self) -> None:
        _check_parity(self)

    def columns(self, top: int) -> list[Mode]:
        return [(0, 0)]

    def has(self, mode: tuple[Any, ...]) -> bool:
        return mode == (0, 0)

    def is_fixed(self, mode: Mode) -> bool:
        return False

    def mode(self, key: int) -> Mode:
        return 0, key


def in_parity(which: str, n: int) -> bool:
    """Is n among "all", "even" or "odd" numbers?"""
    return n % 2 in _PARITIES[which]


def _check_parity(unknown: Field | Scalar) -> None:
    for what in ("modes", "powers"):
        if getattr(unknown, what) not in tuple(_PARITIES):
            raise InputError(f"{what}={getattr(unknown, what)!r}: choose 'all', 'even' or 'odd'")
