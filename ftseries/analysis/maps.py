r"""Change of the series variable: Euler's transformation and other maps.

Formula.  Given f(z) = Σ c_k z^k and a map z = φ(w) with φ(0) = 0, the series of f(φ(w)) in w.
Euler's map w = z/(z + p) sends a singularity z = -p to infinity and the half plane Re z > -p/2 into
the unit disc, so that a series hindered by singularities on the left converges there.
"""

from flint import fmpq, fmpq_series

from ..errors import InputError
from ..trig import rational

__all__ = ["compose", "euler_map"]


def compose(c, inner):
    """The Taylor coefficients of f(φ(w)), as many as of f; ``inner`` are those of φ.

    >>> from flint import fmpq
    >>> compose([fmpq(1)] * 4, [fmpq(0), fmpq(1), fmpq(1)])       # 1/(1 - w - w²): Fibonacci
    [1, 1, 2, 3]
    """
    c, inner = [rational(x) for x in c], [rational(x) for x in inner]
    if not inner or inner[0] != 0:
        raise InputError("the inner series must vanish at w = 0: its first coefficient is not zero")
    n = len(c)
    result = fmpq_series(c, prec=n)(fmpq_series(inner, prec=n))
    return [result[k] for k in range(n)]


def euler_map(c, p):
    """(d, w): the coefficients of f in Euler's variable w = z/(z + p), and w itself as a function.

    >>> from flint import fmpq
    >>> d, w = euler_map([fmpq((-1) ** k) for k in range(6)], 1)          # 1/(1 + z) = 1 - w
    >>> d, w(1.0)
    ([1, -1, 0, 0, 0, 0], 0.5)
    """
    p = rational(p)
    if p == 0:
        raise InputError("p=0: Euler's map needs the place -p of a singularity, not zero")
    inner = [fmpq(0)] + [p] * (len(c) - 1)                         # z = p w / (1 - w)
    scale = int(p.p) / int(p.q)
    return compose(c, inner), lambda z: z / (z + scale)
