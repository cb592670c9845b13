r"""How a problem is declared: unknowns, their ansatz, equations, first coefficients.

Index convention and formula.  An unknown :class:`Field` u is a Fourier-Taylor series

.. math::  u(τ; λ) = \sum_m λ^m \Big( \sum_{n \le m} A_{n,m} \cos nτ + B_{n,m} \sin nτ \Big),

of which the declaration keeps cosines, sines or both, all, even or odd Fourier orders n, and all,
even or odd Taylor orders m.  An unknown :class:`Scalar` is Σ_m c_m λ^m: a frequency, an eigenvalue.
A problem gives its equations as residuals (left side minus right side) and the *seed*: the first
coefficients, found by hand, which choose one of the solutions of the first non-linear equations.
"""

from dataclasses import dataclass

from .errors import InputError
from .trig import rational

__all__ = ["Field", "Scalar", "Problem"]

_PARITIES = {"all": (0, 1), "even": (0,), "odd": (1,)}


@dataclass(frozen=True)
class Field:
    """An unknown periodic function.

    Parameters
    ----------
    series : "cos", "sin" or "both"
        The Fourier modes of the ansatz.
    modes, powers : "all", "even" or "odd"
        Fourier orders n and Taylor orders m of the ansatz.
    fixed : tuple of int
        Fourier orders that the seed gives completely: their later coefficients are zero.  This is
        how λ gets the meaning "amplitude of that mode".
    """

    series: str = "cos"
    modes: str = "all"
    powers: str = "all"
    fixed: tuple = ()

    def __post_init__(self):
        if self.series not in ("cos", "sin", "both"):
            raise InputError(f"series={self.series!r}: choose 'cos', 'sin' or 'both'")
        _check_parity(self)

    def columns(self, top):
        """The modes (sine, n) of the ansatz with n ≤ top, highest first."""
        sines = {"cos": (0,), "sin": (1,), "both": (0, 1)}[self.series]
        return [(sine, n) for n in range(top, -1, -1) for sine in sines
                if n % 2 in _PARITIES[self.modes] and n not in self.fixed and (n or not sine)]

    def mode(self, key):
        """A mode given by hand: n, or (sine, n) where both kinds occur."""
        if isinstance(key, tuple):
            return key
        return (1 if self.series == "sin" else 0), key


@dataclass(frozen=True)
class Scalar:
    """An unknown number that depends on λ alone; ``powers`` as for :class:`Field`."""

    powers: str = "all"
    modes = "all"

    def __post_init__(self):
        _check_parity(self)

    def columns(self, top):
        return [(0, 0)]

    def mode(self, key):
        return 0, 0


def _check_parity(unknown):
    for what in ("modes", "powers"):
        if getattr(unknown, what) not in _PARITIES:
            raise InputError(f"{what}={getattr(unknown, what)!r}: choose 'all', 'even' or 'odd'")


class Problem:
    """A problem; subclasses declare the four attributes and :meth:`equations`.

    Attributes
    ----------
    unknowns : dict
        Name to :class:`Field` or :class:`Scalar`.
    seed : dict
        Name to the list of first Taylor coefficients, each a dict ``{n: number}`` (a number alone
        for a scalar), all of them rational.
    parameters : tuple of str
        Names carried as symbols; exact coefficients are polynomials in them.
    frequency : str or None
        The scalar ω in τ = ωt; None where the period is 2π.
    """

    unknowns = {}
    seed = {}
    parameters = ()
    frequency = None
    #: every problem class by name, so that a saved solution finds its own
    classes = {}

    def __init_subclass__(cls):
        super().__init_subclass__()
        Problem.classes[cls.__name__] = cls

    def equations(self, lam, **unknowns):
        """The residuals, a dict from the equation's name to a :class:`ftseries.series.Series`."""
        raise NotImplementedError

    def unit(self, name, m):
        """The SymPy number that turns the solver's coefficient of order m into the paper's."""
        return 1

    def arguments(self):
        """What the constructor needs to make this problem again, as plain JSON values."""
        return {}

    def __repr__(self):
        inner = ", ".join(f"{k}={v}" for k, v in self.arguments().items())
        return f"{type(self).__name__}({inner})"

    def allowed(self, name, n, m):
        """May mode n of an unknown have a coefficient of Taylor order m, beyond the seed?"""
        return (n <= m and m >= len(self.seed[name])
                and m % 2 in _PARITIES[self.unknowns[name].powers])

    def first_coefficients(self):
        """The seed as ``{name: [{(sine, n): fmpq}, …]}``; refuses a missing or foreign one."""
        missing = [name for name in self.unknowns if not self.seed.get(name)]
        if missing:
            raise InputError(f"{type(self).__name__} has no seed for {', '.join(missing)}: give "
                             "its first coefficients, found by hand, in the attribute 'seed'")
        foreign = set(self.seed) - set(self.unknowns)
        if foreign:
            raise InputError(f"the seed names {', '.join(sorted(foreign))}, which is not an "
                             f"unknown of {type(self).__name__}; it has {', '.join(self.unknowns)}")
        return {name: [{unknown.mode(n): rational(c) for n, c in
                        (row if isinstance(row, dict) else {0: row}).items() if c != 0}
                       for row in self.seed[name]]
                for name, unknown in self.unknowns.items()}
