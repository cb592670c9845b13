r"""One Taylor order of a Fourier-Taylor series: a finite Fourier sum.

Index convention and formula.  A sum

.. math::  f(τ) = \sum_{n \ge 0} A_n \cos nτ + \sum_{n \ge 1} B_n \sin nτ

is split into at most four *parts*, one for each **kind** = (parity of n) + 2·(0 cosine, 1 sine):

====  ==========  =====================
kind  modes       symmetries
====  ==========  =====================
0     cos, n even  even in τ, period π
1     cos, n odd   even in τ, antiperiod π
2     sin, n even  odd in τ, period π
3     sin, n odd   odd in τ, antiperiod π
====  ==========  =====================

The kind of a product is the exclusive or of the kinds of its factors, so symmetries cost nothing
to keep and absent parts cost nothing at all.  A mode is named ``(sine, n)`` with sine 0 or 1.

What a part holds is the business of a :class:`Ring`.  The rings of this module hold Laurent
polynomials in z = e^{iτ}: with w = z², a part is the pair (d, p) standing for

.. math::  z^{-d} p(w) \quad\text{(cosine kinds)}, \qquad i\, z^{-d} p(w) \quad\text{(sine kinds)},

where p has degree at most d and d has the parity of n.  So A_n/2 (for n > 0) is the coefficient of
w^{(d-n)/2} and w^{(d+n)/2}, and products are products of FLINT polynomials.  The float ring, which
holds values on a grid instead, is in :mod:`ftseries.grid`.
"""

from fractions import Fraction
from functools import reduce

from flint import Ordering, arb, arb_poly, fmpq, fmpq_mpoly_ctx, fmpq_poly, fmpz, fmpz_poly

from .errors import InputError, NonAnalyticError

__all__ = ["Trig", "Ring", "RationalRing", "PolynomialRing", "BallRing", "rational"]


def rational(x):
    """``x`` as an exact ``fmpq``: int, Fraction, decimal or SymPy rational; a float is taken bit by bit.

    >>> rational("0.1"), rational(0.5)
    (1/10, 1/2)
    """
    if isinstance(x, fmpq):
        return x
    try:
        f = Fraction(int(x.p), int(x.q)) if hasattr(x, "p") and hasattr(x, "q") else Fraction(x)
    except (TypeError, ValueError, OverflowError):
        raise InputError(f"{x!r} is not a rational number; give an int, a Fraction, a decimal "
                         "string or a SymPy Rational") from None
    return fmpq(f.numerator, f.denominator)


class Trig:
    """A finite Fourier sum: ``parts`` maps a kind to the ring's data for it."""

    __slots__ = ("ring", "parts")

    def __init__(self, ring, parts):
        self.ring, self.parts = ring, parts

    def __add__(self, other):
        parts = dict(self.parts)
        for kind, b in other.parts.items():
            parts[kind] = self.ring.add(parts[kind], b) if kind in parts else b
        return Trig(self.ring, parts)

    def __mul__(self, other):
        return self.ring.convolve([self], [other], 0, 0, 0)

    def scale(self, number):
        """The sum times a number of the ring."""
        return Trig(self.ring, {k: self.ring.scale(p, number) for k, p in self.parts.items()})

    def multiply_modes(self, multiplier):
        """The sum with every e^{inτ} replaced by (a + ib) e^{inτ}, (a, b) = multiplier(n, ring)."""
        parts = {}
        for kind, part in self.parts.items():
            for new, image in self.ring.multiply_modes(kind, part, multiplier):
                parts[new] = self.ring.add(parts[new], image) if new in parts else image
        return Trig(self.ring, parts)

    def modes(self):
        """The non-zero coefficients as a dict ``{(sine, n): number}``."""
        return self.ring.modes(self.parts)

    # The first coefficient of a power, exponential, sine, cosine -- where Taylor recurrences start.
    def constant(self, what):
        """The value of a sum that is a constant; ``what`` names the operation that needs one."""
        modes = self.modes()
        size = self.ring.size(modes)
        if any(mode != (0, 0) and not self.ring.negligible(c, size) for mode, c in modes.items()):
            raise NonAnalyticError(f"{what} needs an argument that is constant at λ = 0, but it "
                                   "oscillates there; expand about a constant state")
        return modes.get((0, 0), self.ring.number(0))

    def power(self, alpha):
        value = self.constant(f"the power {alpha}")
        if self.ring.is_zero(value):
            raise NonAnalyticError(f"the power {alpha} of a quantity that vanishes at λ = 0 is not "
                                   "analytic there, so no Fourier-Taylor series exists; choose "
                                   "other variables")
        return self.ring.from_modes({(0, 0): self.ring.root(value, alpha)})

    def exp(self):
        if not self.ring.is_zero(self.constant("exp")):
            raise NonAnalyticError("exp, sin and cos need an argument that is zero at λ = 0; "
                                   "split its constant off by an addition theorem")
        return self.ring.from_modes({(0, 0): self.ring.number(1)})

    def sincos(self):
        return self.ring.from_modes({}), self.exp()


class Ring:
    """Arithmetic of finite Fourier sums; subclasses say what a number and a part are."""

    #: is the residual decided exactly (or by balls), or up to rounding?
    exact = True

    def from_modes(self, modes):
        """The :class:`Trig` with the given ``{(sine, n): number}``."""
        kinds = {}
        for (sine, n), value in modes.items():
            kinds.setdefault(n % 2 + 2 * sine, {})[n] = value
        return Trig(self, {k: self.part(k, m) for k, m in kinds.items()})

    def table(self):
        """An empty table of Taylor coefficients."""
        return Table()

    def is_zero(self, number):
        return number == 0

    def size(self, modes):
        """A scale for :meth:`negligible`: the largest of these coefficients."""
        return 1

    def turn(self, fraction):
        """(cos, sin) of that fraction of a full turn, where the ring has them."""
        quarters = 4 * rational(fraction)
        if quarters.q != 1:
            raise InputError(f"a shift by {fraction} of a period multiplies some mode by an irrational "
                             "number; in exact arithmetic use the sum over opposite shifts "
                             "(Series.neighbours) or arithmetic='float' or 'ball'")
        return ((1, 0), (0, 1), (-1, 0), (0, -1))[int(quarters.p) % 4]

    def negligible(self, number, scale):
        """Is this number of a residual zero?  ``scale`` is the size of the terms behind it."""
        return number == 0

    def convolve(self, a, b, k, lo, hi, alpha=1, beta=0):
        """The Cauchy sum Σ_{j=lo}^{hi} (alpha + beta j) a_j b_{k-j} of two tables."""
        pairs = {}
        fold = a is b and not beta and lo + hi == k     # a square: take each pair once, twice
        for j in range(lo, (k // 2 if fold else hi) + 1):
            u, v = a[j].parts, b[k - j].parts
            if not (u and v):
                continue
            weight = alpha + beta * j
            if fold and 2 * j != k:
                weight = 2 * weight
            for ku, p in u.items():
                for kv, q in v.items():
                    sign = -weight if ku & kv & 2 else weight       # i·i = -1
                    pairs.setdefault(ku ^ kv, []).append((p, q, sign))
        return Trig(self, {kind: self.dot(terms) for kind, terms in pairs.items()})


class Table(list):
    """The Taylor coefficients 0, 1, 2, … of a series, as :class:`Trig`."""

    def cut(self, k):
        del self[k:]


class _LaurentRing(Ring):
    """Parts are triples (d, p, c) for z^{-d} p(w) / c; only the rational ring has c other than 1."""

    def modes(self, parts):
        out = {}
        for kind, part in parts.items():
            sine, d = kind >> 1, part[0]
            for i, value in self.coefficients(part):
                n = 2 * i - d
                if n >= 0 and not self.is_zero(value):
                    out[sine, n] = value if n == 0 else -2 * value if sine else 2 * value
        return out

    def part(self, kind, modes):
        sine, d = kind >> 1, max(modes)
        values = {}
        for n, value in modes.items():
            if n == 0:
                values[d // 2] = value
            else:
                half = value * self.number(fmpq(1, 2))
                values[(d + n) // 2] = -half if sine else half
                values[(d - n) // 2] = half
        return self.pack(d, values)

    def multiply_modes(self, kind, part, multiplier):
        d = part[0]
        stay, swap = {}, {}
        for i, value in self.coefficients(part):
            a, b = multiplier(2 * i - d, self)
            if a:
                stay[i] = value * a
            if b:
                swap[i] = value * -b if kind & 2 else value * b
        return [(new, self.pack(d, values)) for new, values in ((kind, stay), (kind ^ 2, swap))
                if values]

    def add(self, a, b):
        one = self.one
        return self.dot([(a, one, 1), (b, one, 1)])

    def scale(self, part, number):
        return part[0], part[1] * self.number(number), 1

    def dot(self, terms):
        """Σ weight · p · q over the terms (p, q, weight), all of one kind."""
        top = max(p[0] + q[0] for p, q, _ in terms)
        total = None
        for (d, p, _), (e, q, _), weight in terms:
            product = p * q
            if weight != 1:
                product *= self.number(weight)
            if d + e != top:
                product = self.raise_degree(product, (top - d - e) // 2)
            total = product if total is None else total + product
        return top, total, 1


class RationalRing(_LaurentRing):
    """Exact rational numbers: FLINT integer polynomials over one common denominator."""

    name = "exact"
    one = (0, fmpz_poly([1]), fmpz(1))
    number = staticmethod(rational)

    def coefficients(self, part):
        return ((i, fmpq(value, part[2])) for i, value in enumerate(part[1].coeffs()))

    def pack(self, d, values):
        return self.reduced(d, fmpq_poly([values.get(i, 0) for i in range(d + 1)]))

    def reduced(self, d, q):
        return d, q.numer(), q.denom()

    def scale(self, part, number):
        d, p, c = part
        return self.reduced(d, fmpq_poly(p, c) * rational(number))

    def root(self, value, alpha):
        alpha = rational(alpha)
        degree = int(alpha.q)
        if degree > 1:
            roots = [part.root(degree) for part in (value.p, value.q)] if value > 0 else None
            if not roots or fmpq(*roots) ** degree != value:
                raise InputError(f"({value})^({alpha}) is not rational; choose units in which the "
                                 "value at λ = 0 has a rational power")
            value = fmpq(*roots)
        return value ** int(alpha.p)

    def dot(self, terms):
        top = max(p[0] + q[0] for p, q, _ in terms)
        scales = [fmpq(1, p[2] * q[2]) * weight for p, q, weight in terms]
        common = reduce(fmpz.lcm, (s.q for s in scales))
        total = fmpz_poly()
        for ((d, p, _), (e, q, _), _), s in zip(terms, scales):
            product = p * q * (s.p * (common // s.q))
            total += product.left_shift((top - d - e) // 2) if d + e != top else product
        return self.reduced(top, fmpq_poly(total, common))


class PolynomialRing(_LaurentRing):
    """Polynomials with rational coefficients in named parameters."""

    name = "exact"

    def __init__(self, names):
        self.names = tuple(names)
        self.context = fmpq_mpoly_ctx.get(["w", *self.names], Ordering.lex)
        self.w, *self.parameters = self.context.gens()
        self.one = (0, self.context.constant(1), 1)

    def number(self, x):
        if isinstance(x, type(self.w)):
            return x
        return self.context.constant(rational(x))

    def parameter(self, name):
        return self.parameters[self.names.index(name)]

    def coefficients(self, part):
        rows = {}
        for (i, *rest), c in part[1].to_dict().items():
            rows.setdefault(i, {})[(0, *rest)] = c
        return ((i, self.context.from_dict(terms)) for i, terms in rows.items())

    def pack(self, d, values):
        total = self.context.constant(0)
        for i, value in values.items():
            total += self.number(value) * self.w**i
        return d, total, 1

    def raise_degree(self, p, i):
        return p * self.w**i

    def root(self, value, alpha):
        if not value.is_constant():
            raise InputError("a power of an expression that depends on a parameter at λ = 0 is not "
                             "a polynomial; give the parameter a value")
        return self.number(RationalRing().root(fmpq(value.leading_coefficient()), alpha))


class BallRing(_LaurentRing):
    """Real balls of FLINT: midpoint and radius, rounded outwards at the precision in force."""

    name = "ball"
    one = (0, arb_poly([1]), 1)

    def number(self, x):
        if isinstance(x, arb):
            return x
        x = rational(x)
        return arb(x.p) / x.q if x.q != 1 else arb(x.p)

    def coefficients(self, part):
        return enumerate(part[1].coeffs())

    def pack(self, d, values):
        return d, arb_poly([values.get(i, 0) for i in range(d + 1)]), 1

    def raise_degree(self, p, i):
        return p.left_shift(i)

    def root(self, value, alpha):
        alpha = rational(alpha)
        return value ** arb(alpha)

    def is_zero(self, number):
        return number.is_zero() if isinstance(number, arb) else number == 0

    def turn(self, fraction):
        fraction = 2 * rational(fraction)
        return arb.cos_pi_fmpq(fraction), arb.sin_pi_fmpq(fraction)

    def negligible(self, number, scale):
        return number.contains(0)
