"""The working precision: FLINT and mpmath have one for the whole process, so one thread at a time.

``flint.ctx`` and ``mpmath.mp`` are global: what one thread sets, all others compute with.  Every
computation of this package that depends on them, or that changes them inside of the libraries,
stands in a :func:`working` block, and while one thread is in such a block the others wait.  Blocks
may be nested; none is left open by a generator that others go on with.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from threading import RLock

from flint import ctx
from mpmath import mp

from .errors import PrecisionError

__all__ = ["working"]

_ALONE = RLock()
if hasattr(os, "register_at_fork"):         # a child must not inherit what another thread holds
    os.register_at_fork(before=_ALONE.acquire, after_in_parent=_ALONE.release,
                        after_in_child=_ALONE.release)


@contextmanager
def working(*, bits: int | None = None, digits: int | None = None,
            terms: int | None = None) -> Iterator[None]:
    """Compute with this precision, alone; what is left out stays as it is.

    Parameters
    ----------
    bits : int, optional
        Of FLINT's balls.
    digits : int, optional
        Decimal digits of mpmath's numbers.
    terms : int, optional
        At which FLINT cuts power series.

    Raises
    ------
    PrecisionError
        At the end of the block: a thread that is in none has changed the precision meanwhile.

    Examples
    --------
    >>> from flint import arb
    >>> with working(bits=200):
    ...     root = arb(2).sqrt()
    >>> root.rel_accuracy_bits() > 190
    True
    """
    with _ALONE:
        before = ctx.prec, ctx.cap, mp.prec
        try:
            ctx.prec, ctx.cap = bits or ctx.prec, terms or ctx.cap
            if digits:
                mp.dps = digits
            inside = ctx.prec, ctx.cap, mp.prec
            yield
            if (ctx.prec, ctx.cap, mp.prec) != inside:
                raise PrecisionError(
                    "the precision of FLINT or mpmath was changed from outside while ftseries "
                    "computed with it; compute again, and let threads that set it themselves do "
                    "so in a block `with ftseries.precision.working(): …`")
        finally:
            try:
                ctx.prec, ctx.cap, mp.prec = before
            finally:                            # once more: Ctrl-C may have come in between
                ctx.prec, ctx.cap, mp.prec = before
