"""Certificates of theorems as JSON files.

Numbers are exact: the dyadic number m 2^e is the string "m e", a ball two of them; see
:mod:`ftseries.certify.grammar`.  The file carries a SHA-256 of everything else, against damage.
Against an altered file with a new checksum stands the proof itself, which
:mod:`ftseries.certify.checking` does again.
"""

from __future__ import annotations

from collections.abc import Iterable

from flint import arb

from .. import jsonfile
from ..aliases import FilePath, Json
from . import grammar
from .balls import NotProved

__all__ = ["ball", "exact", "number", "read", "read_ball", "require", "upper_bound",
           "write"]

_KIND = "ftseries certificate"


def exact(x: arb) -> str:
    """The midpoint of x, bit by bit."""
    return "{} {}".format(*x.mid().man_exp())


def ball(x: arb) -> list[str]:
    """[midpoint, radius]."""
    return [exact(x), exact(x.rad())]


def number(text: Json) -> arb:
    """The number that :func:`exact` wrote."""
    return arb(grammar.dyadic(text))


def read_ball(pair: Json) -> arb:
    """A ball that contains the one :func:`ball` wrote, hardly larger."""
    mid, radius = grammar.ball(pair)
    return mid + arb(0, radius)


def write(path: FilePath, data: dict[str, Json]) -> None:
    """Write a certificate; errors as for :func:`ftseries.jsonfile.write`."""
    jsonfile.write(path, _KIND, data)


def read(path: FilePath) -> dict[str, Json]:
    """The contents of a certificate; errors as for :func:`ftseries.jsonfile.read`."""
    return jsonfile.read(path, _KIND, "a certificate of ftseries", "prove the theorem again")


def require(holds: bool, inequality: str) -> None:
    """Raise :class:`NotProved` unless an inequality holds."""
    if not holds:
        raise NotProved(f"not proved: {inequality} fails for the numbers of this certificate")


def upper_bound(values: Iterable[arb]) -> arb:
    """An upper bound of all of them, for a checker."""
    worst = arb(0)
    for x in values:
        x = x.upper()
        require(x.is_finite(), "a finite norm")
        worst = x if x > worst else worst
    return worst
