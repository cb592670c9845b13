r"""Where series begin: constants, λ, known functions, and unknowns.

Formula.  An expansion is the graph of all series over one ring; its leaves are

.. math::  u(τ; λ) = \sum_k λ^k u_k(τ) \quad\text{with } u_k \text{ given},

either as a finite list, or set from outside one order after the other.  All other nodes come from
the operations of :mod:`ftseries.series`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .aliases import Exact, Modes, Term
from .arguments import decimal
from .errors import InputError
from .series import Series

if TYPE_CHECKING:
    from .trig import Ring

__all__ = ["Expansion"]


class Expansion:
    """The graph of all series built over one ring; it makes constants, λ and unknowns."""

    def __init__(self, ring: Ring) -> None:
        self.ring = ring
        self.nodes: list[Series] = []
        #: (sin u, cos u) of each u that has them
        self.pairs: dict[Series, tuple[Series, Series]] = {}

    def polynomial(self, coefficients: list[Modes]) -> Polynomial:
        """The known series with Taylor coefficients given as a list of ``{(sine, n): number}``."""
        return Polynomial(self, [self.ring.from_modes(c) for c in coefficients])

    def constant(self, number: Exact) -> Polynomial:
        return self.polynomial([{(0, 0): self.ring.number(decimal(number))}])

    def parameter(self, name: str) -> Polynomial:
        """A named parameter of a :class:`ftseries.laurent.PolynomialRing`."""
        if name not in self.ring.names:
            raise InputError(f"{name!r} is not a parameter of this problem; list it in its "
                             "attribute 'parameters'")
        return self.polynomial([{(0, 0): self.ring.parameter(name)}])

    def cos(self, n: int) -> Polynomial:
        """The known function cos nτ."""
        return self.polynomial([{(0, n): self.ring.number(1)}])

    def sin(self, n: int) -> Polynomial:
        """The known function sin nτ."""
        return self.polynomial([{(1, n): self.ring.number(1)}])

    @property
    def lam(self) -> Polynomial:
        """The series parameter λ itself."""
        return self.polynomial([{}, {(0, 0): self.ring.number(1)}])

    def unknown(self) -> Unknown:
        """A series whose coefficients are set from outside; those not yet set are zero."""
        return Unknown(self)

    def forget(self, k: int) -> None:
        """Drop the coefficients of order ≥ k of every node that computes its own."""
        for node in self.nodes:
            node.forget(k)


class Unknown(Series):
    """Coefficients set from outside."""

    def set(self, k: int, trig: Term) -> None:
        """Give coefficient k; the caller forgets what depends on it."""
        self.table.cut(k)
        self[k - 1] if k else None
        self.table.append(trig)

    def step(self, k: int) -> Term:
        return self.ring.from_modes({})

    def forget(self, k: int) -> None:
        pass


class Polynomial(Series):
    """Finitely many known coefficients."""

    def __init__(self, expansion: Expansion, coefficients: list[Term]) -> None:
        super().__init__(expansion)
        self.coefficients = coefficients

    def step(self, k: int) -> Term:
        known = self.coefficients
        return known[k] if k < len(known) else self.ring.from_modes({})

    def forget(self, k: int) -> None:
        pass
