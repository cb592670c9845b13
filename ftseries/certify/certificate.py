"""Certificates of theorems as JSON files.

Numbers are exact: the dyadic number m 2^e is the string "m e", a ball two of them.  The file
carries a SHA-256 of everything else, against damage.  Against an altered file with a new checksum
stands the proof itself, which :mod:`ftseries.certify.checking` does again.
"""

import hashlib
import json
import os

from flint import arb

from ..errors import FileError
from .algebra import NotProved

__all__ = ["ball", "exact", "number", "read", "read_ball", "require", "write"]


def exact(x):
    """The midpoint of x, bit by bit."""
    return "{} {}".format(*(int(i) for i in x.mid().man_exp()))


def ball(x):
    """[midpoint, radius]."""
    return [exact(x), exact(x.rad())]


def number(text):
    """The number that :func:`exact` wrote."""
    mantissa, exponent = (int(i) for i in text.split())
    return arb((mantissa, exponent))


def read_ball(pair):
    """A ball that contains the one :func:`ball` wrote, hardly larger."""
    return number(pair[0]) + arb(0, number(pair[1]))


def write(path, data):
    """Write a certificate.

    Raises
    ------
    FileError
        The file cannot be written.
    """
    data = {"format": "ftseries certificate", "version": 1} | data
    try:
        with open(path, "w", encoding="utf-8") as file:
            json.dump(data | {"sha256": _digest(data)}, file)
    except OSError as error:
        raise FileError(f"cannot write {os.fspath(path)!r}: {error.strerror}") from error


def read(path):
    """The contents of a certificate.

    Raises
    ------
    FileError
        The file cannot be read, is none, or is damaged.
    """
    path = os.fspath(path)
    try:
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
    except OSError as error:
        raise FileError(f"cannot read {path!r}: {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise FileError(f"{path!r} is damaged or not JSON ({error})") from None
    if not isinstance(data, dict) or data.get("format") != "ftseries certificate":
        raise FileError(f"{path!r} is not a certificate of ftseries")
    if data.get("version") != 1:
        raise FileError(f"{path!r} has format version {data.get('version')!r}; this reads 1")
    if data.pop("sha256", None) != _digest(data):
        raise FileError(f"{path!r} is damaged: its contents do not match their checksum; prove the "
                        "theorem again")
    return data


def require(holds, inequality):
    """Raise :class:`NotProved` unless an inequality holds."""
    if not holds:
        raise NotProved(f"not proved: {inequality} fails for the numbers of this certificate")


def _digest(data):
    return hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()
