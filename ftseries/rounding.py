r"""What rounding leaves of float coefficients that vanish.

Formula.  With S_j the largest term of order λ^j, the products that enter order k, and their second
derivatives by τ, are rounded to about

.. math::  100 \cdot 2^{-53} \, k^2 \max_{0<j<k} S_j S_{k-j}.

Where an order vanishes, as the odd ones of ω do, that is all that S_k consists of, and no measure
for what is left over.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

__all__ = ["NEGLIGIBLE", "size", "sizes"]

#: of its terms: rounding of a Cauchy sum over hundreds of orders stays far below, a fault far above
NEGLIGIBLE = 1e-9
_ROUNDING = 100 * 2.0**-53


def sizes(terms: Sequence[Any]) -> list[float]:
    """:func:`size` of every order."""
    return [size(terms[:k + 1]) for k in range(len(terms))]


def size(terms: Sequence[Any]) -> float:
    """What a left-over of the last order is negligible against.

    The largest term of this order, or more where products of others are rounded to more.

    Parameters
    ----------
    terms : sequence of numbers
        S_0, …, S_k.

    Examples
    --------
    >>> size([1, 1, 1, 1])
    1.0
    >>> 1e-5 < size([1, 1, 0.5, 0]) < 1e-3
    True
    """
    sizes = np.array([float(term) for term in terms])
    products = sizes[1:-1] * sizes[-2:0:-1]
    k = len(sizes) - 1
    return max(float(sizes[-1]),
               _ROUNDING / NEGLIGIBLE * k**2 * float(products.max(initial=0.0)))
