r"""Fourier-Taylor series: one lazily evaluated order-k step for every operation.

Index convention and formula.  A series is

.. math::  u(τ; λ) = \sum_k λ^k u_k(τ), \qquad u_k = \sum_n A_{n,k} \cos nτ + B_{n,k} \sin nτ,

and ``u[k]`` is its Taylor coefficient u_k, a :class:`ftseries.trig.Trig`.  Every operation is a
node that gives its coefficient k from coefficients ≤ k of its operands:

=============  ==========================================================================
product        c_k = Σ_j a_j b_{k-j}
power w = u^α  k u_0 w_k = Σ_{j≥1} ((α+1) j - k) u_j w_{k-j}      (from u w' = α u' w)
e = exp u      k e_k = Σ_{j≥1} j u_j e_{k-j}
sin u, cos u   k s_k = Σ_{j≥1} j u_j c_{k-j},   k c_k = -Σ_{j≥1} j u_j s_{k-j}
=============  ==========================================================================

(Knuth, TAOCP 2, 4.7; the prime is d/dλ.)  A solver changes the last few coefficients of the
unknowns again and again.  :meth:`Expansion.forget` makes every node drop what depends on them; the
*deep* part of each sum, which uses settled coefficients only, is kept, so that a second look at an
order costs a handful of products.
"""

from functools import cache

from flint import fmpq

from .errors import InputError
from .trig import rational

__all__ = ["Expansion", "Series", "exp", "sin", "cos"]

#: orders from either end of a Cauchy sum that are summed anew after a change
WINDOW = 3


class Expansion:
    """The graph of all series built over one ring; it makes constants, λ and unknowns."""

    def __init__(self, ring):
        self.ring, self.nodes, self.pairs = ring, [], {}

    def polynomial(self, coefficients):
        """The known series with Taylor coefficients given as a list of ``{(sine, n): number}``."""
        return Polynomial(self, [self.ring.from_modes(c) for c in coefficients])

    def constant(self, number):
        return self.polynomial([{(0, 0): self.ring.number(number)}])

    def parameter(self, name):
        """A named parameter of a :class:`ftseries.laurent.PolynomialRing`."""
        if name not in self.ring.names:
            raise InputError(f"{name!r} is not a parameter of this problem; list it in its "
                             "attribute 'parameters'")
        return self.polynomial([{(0, 0): self.ring.parameter(name)}])

    def cos(self, n):
        """The known function cos nτ."""
        return self.polynomial([{(0, n): self.ring.number(1)}])

    def sin(self, n):
        """The known function sin nτ."""
        return self.polynomial([{(1, n): self.ring.number(1)}])

    @property
    def lam(self):
        """The series parameter λ itself."""
        return self.polynomial([{}, {(0, 0): self.ring.number(1)}])

    def unknown(self):
        """A series whose coefficients are set from outside; those not yet set are zero."""
        return Unknown(self)

    def forget(self, k):
        """Drop the coefficients of order ≥ k of every node that computes its own."""
        for node in self.nodes:
            node.forget(k)


class Series:
    """A Fourier-Taylor series; ``u[k]`` is the Taylor coefficient of order k."""

    def __init__(self, expansion):
        self.expansion, self.ring = expansion, expansion.ring
        self.table = self.ring.table()
        expansion.nodes.append(self)

    def __getitem__(self, k):
        while len(self.table) <= k:
            self.table.append(self.step(len(self.table)))
        return self.table[k]

    def step(self, k):
        """Coefficient k from lower ones and from the operands."""
        raise NotImplementedError

    def forget(self, k):
        self.table.cut(k)

    def __add__(self, other):
        return Sum(self, self._series(other))

    __radd__ = __add__

    def __neg__(self):
        return self * -1

    def __sub__(self, other):
        return self + -self._series(other)

    def __rsub__(self, other):
        return self._series(other) + -self

    def __mul__(self, other):
        return Product(self, other) if isinstance(other, Series) else Multiple(self, other)

    __rmul__ = __mul__

    def __truediv__(self, other):
        if isinstance(other, Series):
            return self * other**-1
        number = rational(other)
        if number == 0:
            raise InputError("a series is divided by the number zero")
        return Multiple(self, 1 / number)

    def __rtruediv__(self, other):
        return self**-1 * other

    def __pow__(self, alpha):
        alpha = rational(alpha)
        if alpha.q == 1 and alpha > 0:
            if alpha == 1:
                return self
            half = self ** int(alpha.p // 2) if alpha > 1 else self
            return half * half * self if alpha.p % 2 else half * half
        return self._series(1) if alpha == 0 else Power(self, alpha)

    def diff(self, times=1):
        """The derivative d/dτ, or one of higher order."""
        if times not in DERIVATIVES:
            raise InputError(f"a derivative of order {times!r} is not offered; use 1 or 2")
        return ModeMultiple(self, DERIVATIVES[times])

    def shift(self, fraction):
        """The series at τ + 2π·fraction, for a rational fraction of a period."""
        fraction = rational(fraction)
        return ModeMultiple(self, lambda n, ring: ring.turn(fraction * n))

    def neighbours(self, bodies=3):
        """The sum of the series at τ + 2πj/bodies, j = 1 … bodies-1: what the others of a
        choreography contribute.  Mode n is multiplied by bodies - 1 if bodies divides n, else
        by -1, so it is rational although the single shifts are not."""
        return ModeMultiple(self, _neighbours(bodies))

    def sin(self):
        return self._sincos()[0]

    def cos(self):
        return self._sincos()[1]

    def exp(self):
        return Exp(self)

    def _sincos(self):
        pairs = self.expansion.pairs
        if self not in pairs:
            s, c = pairs[self] = SinCos(self, True), SinCos(self, False)
            s.partner, c.partner = c, s
        return pairs[self]

    def _series(self, x):
        return x if isinstance(x, Series) else self.expansion.constant(x)


@cache
def _neighbours(bodies):
    return lambda n, ring: (bodies - 1 if n % bodies == 0 else -1, 0)


#: how d/dτ and d²/dτ² multiply the modes
DERIVATIVES = {1: lambda n, ring: (0, n), 2: lambda n, ring: (-n * n, 0)}


class Unknown(Series):
    """Coefficients set from outside."""

    def set(self, k, trig):
        """Give coefficient k; the caller forgets what depends on it."""
        self.table.cut(k)
        self[k - 1] if k else None
        self.table.append(trig)

    def step(self, k):
        return self.ring.from_modes({})

    def forget(self, k):
        pass


class Polynomial(Series):
    """Finitely many known coefficients."""

    def __init__(self, expansion, coefficients):
        super().__init__(expansion)
        self.coefficients = coefficients

    def step(self, k):
        known = self.coefficients
        return known[k] if k < len(known) else self.ring.from_modes({})

    def forget(self, k):
        pass


class Sum(Series):
    def __init__(self, a, b):
        super().__init__(a.expansion)
        self.a, self.b = a, b

    def step(self, k):
        return self.a[k] + self.b[k]


class Multiple(Series):
    def __init__(self, a, number):
        super().__init__(a.expansion)
        self.a, self.number = a, self.ring.number(number)

    def step(self, k):
        return self.a[k].scale(self.number)


class ModeMultiple(Series):
    """Every Fourier mode multiplied by a number of its own: d/dτ, shifts."""

    def __init__(self, a, multiplier):
        super().__init__(a.expansion)
        self.a, self.multiplier = a, multiplier

    def step(self, k):
        return self.a[k].multiply_modes(self.multiplier)


class Convolution(Series):
    """A node that needs Cauchy sums Σ_{j=first}^{k} (α + β j) a_j b_{k-j}."""

    def __init__(self, expansion):
        super().__init__(expansion)
        self.deep = {}

    def forget(self, k):
        super().forget(k)
        for key in [key for key in self.deep if key >= k + WINDOW]:
            del self.deep[key]

    def sum(self, a, b, k, first=0, alpha=1, beta=0):
        a[k], b[k - first]
        low, high = WINDOW, k - WINDOW
        if high < low:
            return self.ring.convolve(a.table, b.table, k, first, k, alpha, beta)
        if k not in self.deep:
            self.deep[k] = self.ring.convolve(a.table, b.table, k, low, high, alpha, beta)
            self.deep.pop(k - 3 * WINDOW, None)
        near = self.ring.convolve(a.table, b.table, k, first, low - 1, alpha, beta)
        far = self.ring.convolve(a.table, b.table, k, high + 1, k, alpha, beta)
        return self.deep[k] + near + far


class Product(Convolution):
    def __init__(self, a, b):
        super().__init__(a.expansion)
        self.a, self.b = a, b

    def step(self, k):
        return self.sum(self.a, self.b, k)


class Power(Convolution):
    def __init__(self, u, alpha):
        super().__init__(u.expansion)
        self.u, self.alpha = u, alpha

    def step(self, k):
        if k == 0:
            first = self.u[0].power(self.alpha)
            self.inverse = self.u[0].power(-1)
            return first
        p, q = int(self.alpha.p), int(self.alpha.q)
        if p == -q:
            return self.inverse * self.sum(self.u, self, k, 1, -1)
        total = self.sum(self.u, self, k, 1, -k * q, p + q)
        return (self.inverse * total).scale(self.ring.number(fmpq(1, k * q)))


class Exp(Convolution):
    def __init__(self, u):
        super().__init__(u.expansion)
        self.u = u

    def step(self, k):
        if k == 0:
            return self.u[0].exp()
        return self.sum(self.u, self, k, 1, 0, 1).scale(self.ring.number(fmpq(1, k)))


class SinCos(Convolution):
    """sin u or cos u; each keeps the other as ``partner``."""

    def __init__(self, u, sine):
        super().__init__(u.expansion)
        self.u, self.sine, self.partner = u, sine, None

    def step(self, k):
        if k == 0:
            return self.u[0].sincos()[0 if self.sine else 1]
        sign = 1 if self.sine else -1
        return self.sum(self.u, self.partner, k, 1, 0, sign).scale(self.ring.number(fmpq(1, k)))


def sin(u):
    """sin u of a series that vanishes at λ = 0."""
    return u.sin()


def cos(u):
    """cos u of a series that vanishes at λ = 0."""
    return u.cos()


def exp(u):
    """exp u of a series that vanishes at λ = 0."""
    return u.exp()
