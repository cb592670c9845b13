r"""How far a truncated sum may be from the solution: from its last terms, and from rounding.

Everything here works on plain tables as :mod:`ftseries.evaluation` does, and estimates; bounds are
the business of :mod:`ftseries.enclosure`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from .aliases import Array
from .evaluation import FloatTable, radius_estimate

__all__ = ["Place", "Terms", "digits", "front", "nonzero"]

#: what may be left out of a truncated sum without a word, as part of its size
_LIMIT = 0.01
#: how many of the last terms are raised to a concave sequence
_CONCAVE = 6
#: how many places of a front are looked at
_PLACES = 64
#: below its neighbours by this factor, as a logarithm, a coefficient is rounding
_ROUNDING = math.log(1e9)


class Terms:
    r"""What the last terms of a series say of those left out.

    Formula.  T_m = Σ_n n^k |A_{n,m} λ^m|, k = 0 or the order of a derivative.  The last six log T_m
    that are not zero are raised to the least concave sequence above them, since dips, which complex
    singularities make, do not count.  A straight line goes through the fifth to last and the second
    to last of these; what is left out is the geometric sum of its continuation.  It is infinite
    where the line does not fall, and where nothing is known: there are fewer than two terms, or
    none beyond those given by hand.

    Parameters
    ----------
    table : dict
        ``{(sine, n): [coefficient of λ^0, λ^1, …]}``.
    given : int
        How many orders were given by hand.
    ended : bool
        Is the series known to have no further terms?
    derivative : int
        k.

    Examples
    --------
    The margin is twice that sum, and more where there are few terms.  Σ_m λ^m at λ = 1/2:

    >>> terms = Terms({(0, 0): [1.0] * 20})
    >>> round(terms.left_out(0.5) / 0.5**19, 2), terms.left_out(1.5)
    (2.02, inf)
    """

    def __init__(self, table: FloatTable, given: int = 1, ended: bool = False,
                 derivative: int = 0) -> None:
        self.table, self.ended, self.derivative = table, ended, derivative
        self.n = np.array([n for _, n in table], dtype=float)
        self.rows = np.array(list(table.values()) or np.zeros((0, 1)), dtype=float)
        sums = self.n**derivative @ np.abs(self.rows)
        orders = nonzero(sums)
        self.known = bool(orders.size > 1 and orders[-1] >= given)
        if self.known:
            last = orders[-_CONCAVE:]
            logs = _concave(last, np.log(sums[last]))
            i, j = max(len(last) - 5, 0), max(len(last) - 2, 1)
            self.slope = (logs[j] - logs[i]) / (last[j] - last[i])
            self.step = int(np.gcd.reduce(np.diff(orders)))
            self.next = int(last[-1]) + self.step
            self.log_next = logs[j] + self.slope * (self.next - last[j])
            self.margin = 2 + 9 / (orders.size - 1) ** 2

    def left_out(self, lam: float) -> float:
        """A margin for the sum of the terms left out at λ."""
        if self.ended or lam == 0:
            return 0.0
        ratio = self.step * (self.slope + math.log(abs(lam))) if self.known else 0.0
        if ratio >= 0:
            return math.inf
        log_next = self.log_next + self.next * math.log(abs(lam))
        return self.margin * math.exp(min(log_next, 700.0)) / -math.expm1(ratio)

    def sizes(self, lam: float) -> tuple[float, float, float]:
        """Σ n^k |A_n| at λ; Σ n^{k+1} |A_n|; and the first, if all terms had the same sign."""
        powers = lam ** np.arange(self.rows.shape[1])
        amplitude, weights = np.abs(self.rows @ powers), self.n**self.derivative
        return (float(weights @ amplitude), float((self.n * weights) @ amplitude),
                float(weights @ (np.abs(self.rows) @ np.abs(powers))))


def nonzero(sums: Array) -> NDArray[np.intp]:
    """The orders m at which c_m is not zero, nor, far below its neighbours, rounding.

    >>> nonzero(np.array([1.0, 0, 1e-3, 1e-17, 1e-6])).tolist()
    [0, 2, 4]
    """
    orders = np.flatnonzero(sums)
    logs = np.log(sums[orders])
    return orders[_concave(orders, logs) - logs < _ROUNDING]


def _concave(x: NDArray[np.intp], y: Array) -> Array:
    """The least concave sequence above y at the places x."""
    hull: list[tuple[float, float]] = []
    for point in zip(x.tolist(), y.tolist()):
        while len(hull) > 1 and _below(hull[-1], hull[-2], point):
            hull.pop()
        hull.append(point)
    places, heights = np.transpose(hull) if hull else ([0.0], [0.0])
    return np.interp(x, places, heights)


def _below(middle: tuple[float, float], left: tuple[float, float],
           right: tuple[float, float]) -> bool:
    """Is the point in the middle not above the line through the others?"""
    return ((middle[1] - left[1]) * (right[0] - left[0])
            <= (right[1] - left[1]) * (middle[0] - left[0]))


@dataclass(frozen=True)
class Place:
    r"""An unknown at one λ and the latest time: how errors of its series reach its value.

    Formula.  With the errors δA of Σ n^k |A_n| and δω of ω, the error of the derivative of order k,
    relative to its size ω^k Σ n^k |A_n|, is at most

    .. math::  \frac{δA}{\sum n^k |A_n|}
               + \frac{δω}{ω} \Big( k + ωt\, \frac{\sum n^{k+1} |A_n|}{\sum n^k |A_n|} \Big).

    Parameters
    ----------
    names : sequence of str
        The unknown, and the frequency where a phase ωt goes with it.
    terms : sequence of Terms
        Of these.
    lam, phase : float
        λ in the unit of the tables, and |ωt|.
    unit : float
        Of λ.
    """

    names: Sequence[str]
    terms: Sequence[Terms]
    lam: float
    phase: float
    unit: float = 1.0

    @cached_property
    def sizes(self) -> tuple[float, float, float]:
        """Those of the unknown, as :meth:`Terms.sizes`."""
        with np.errstate(all="ignore"):
            return self.terms[0].sizes(self.lam)

    @cached_property
    def turn(self) -> float:
        """The relative change of the value for a relative change of ω."""
        return self.terms[0].derivative + _ratio(self.phase * self.sizes[1], self.sizes[0])

    def relative(self, errors: Sequence[float]) -> list[float]:
        """The relative errors of the value from errors of the unknown and of the frequency."""
        with np.errstate(all="ignore"):
            parts = [_ratio(errors[0], self.sizes[0])]
            if len(errors) > 1 and self.turn:
                parts.append(_ratio(errors[1] * self.turn, self.terms[1].sizes(self.lam)[0]))
        return parts

    def doubt(self) -> str | None:
        """Why the truncated sum may be off by more than a hundredth of its size, or None."""
        shares = self.relative([terms.left_out(self.lam) for terms in self.terms])
        if sum(shares) <= _LIMIT:
            return None
        at = f"λ = {self.unit * self.lam:g}"
        for name, terms in zip(self.names, self.terms):
            if radius := outside(terms.table, self.lam):
                return (f"{at} lies outside the radius of convergence of {name!r}, which its "
                        f"coefficients put near {self.unit * radius:.3g}; the truncated sum is not "
                        "an approximation there")
        share, name, terms = max(zip(shares, self.names, self.terms), key=lambda part: part[0])
        if not terms.known:
            return (f"of {name!r} only the first terms are known, and nothing says how far their "
                    f"sum is from the solution at {at}; take a higher order, or compare with "
                    "refine()")
        if share == math.inf:
            return (f"at {at} the last terms of {name!r} do not fall: the truncated sum may be no "
                    "approximation there, and whether the series converges is unknown; take a "
                    "smaller λ or a higher order, or compare with resum() or refine()")
        late = "" if name == self.names[0] else f" and the phase ωt = {self.phase:.3g}"
        much = f"{100 * share:.2g} % of its size" if share < 1 else "more than its size"
        return (f"at {at}{late} the orders of {name!r} that are left out may change "
                f"{self.names[0]!r} by {much}; take a higher order or a smaller λ, or compare with "
                "resum() or refine()")

    def rounding(self, unit: float) -> float:
        """The relative error that floats bring, with the phase known to ``unit`` of itself."""
        return (_ratio(self.sizes[2], self.sizes[0]) * 2.0**-53
                + _ratio(self.phase * self.sizes[1], self.sizes[0]) * unit)


def _ratio(part: float, whole: float) -> float:
    """part / whole, where nothing is no part of anything."""
    return part / whole if part and whole else math.inf if part else 0.0


def front(lam: Array, t: Array) -> list[tuple[float, float]]:
    """Those of the pairs (λ, |t|) to which no other has both a larger |λ| and a later time.

    Positive and negative λ are told apart; of long fronts only some pairs.

    >>> front(np.array([1.0, 2.0, 3.0]), np.array([5.0, -9.0, 4.0]))
    [(3.0, 4.0), (2.0, 9.0)]
    """
    found: list[tuple[float, float]] = []
    lam, t = (a.ravel() for a in np.broadcast_arrays(lam, np.abs(t)))
    for here in (lam >= 0, lam < 0):
        order = np.flatnonzero(here)[np.lexsort((-t[here], -np.abs(lam[here])))]
        later = np.maximum.accumulate(np.concatenate([[-1.0], t[order]]))
        order = order[t[order] > later[:-1]]
        order = order[np.unique(np.linspace(0, max(len(order) - 1, 0), _PLACES).astype(int))[
            :len(order)]]
        found += zip(lam[order].tolist(), t[order].tolist())
    return found


def digits(relative: float) -> int:
    """How many digits a number has whose error is this part of its size.

    >>> digits(1e-7), digits(3.0)
    (7, 0)
    """
    return math.floor(-math.log10(relative)) if 0 < relative < 1 else 0


def outside(table: FloatTable, lam: float) -> float | None:
    """The estimated radius of convergence, if |λ| is clearly larger."""
    fits = [radius_estimate(table, algebraic) for algebraic in (True, False)]
    found = [radius for radius in fits if radius is not None]
    if len(found) < 2 or abs(lam) <= 1.03 * max(found):
        return None
    return float((found[0] * found[1]) ** 0.5)
