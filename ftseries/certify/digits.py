r"""The figure eight to n certified digits: initial values, λ₀, energy and Fourier coefficients.

Formula.  :func:`ftseries.certify.prove_eight` gives a ball around ū in ℓ¹_ν, in which exactly one
zero u* of F lies, and constants with ‖I - A DF(u)‖ ≤ Z_1 + Z_2 ‖u - ū‖ there.  Let ū' be any other
approximation in that ball, and d the larger one of ‖ū' - ū‖ and ‖u* - ū‖.  On the segment from u*
to ū' the bound is at most q = Z_1 + Z_2 d, and the mean value theorem gives A F(ū') =
(I - E)(ū' - u*) with ‖E‖ ≤ q.  So if q < 1,

.. math::  \|ū' - u^*\| \le \frac{\|A F(ū')\|}{1 - q} .

One evaluation of F in balls thus certifies whatever :mod:`ftseries.certify.lifting` has guessed.
With Z = Σ u_n cos nt, n not a multiple of 3, and \cos(2πn/3) = -1/2, \sin(2πn/3) = ±√3/2,

.. math::  r_1(0) = -r_2(0) = \tfrac12 3^{1/3} Z(0), \quad r_3(0) = 0, \quad
           v_3(0) = -2 v_1(0) = -2 v_2(0) = \tfrac23 3^{1/3} Z'(2π/3),

.. math::  r_3(t) = ∓3^{-1/6} \sum u_n \sin nt \; (n ≡ ±1 \bmod 3), \qquad
           E = \tfrac34 |v_3(0)|^2 - \frac{5}{2 |r_1(0)|} .

A decimal is *truncated*: the first n digits after the point of the true number, none rounded, so
that a longer run begins with a shorter one.

File.  A certificate (:mod:`ftseries.certify.certificate`) with "digits", "decimals", "eight" (the
theorem's certificate), "bits", "distance", "lam" and "unknowns": the integers ū'_n 2^bits for
n = 1, 2, 4, 5, 7, …, in two's complement, big-endian, base64, separated by blanks.
"""

from __future__ import annotations

import os
from base64 import b64decode, b64encode
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from flint import acb, arb, arb_mat, fmpz

from ..aliases import FilePath, Json
from ..arguments import whole
from ..errors import FileError
from ..precision import working
from ..problems.figure_eight import FigureEight
from ..solver import solve
from . import certificate
from .algebra import RING, upper
from .balls import NotProved, at_most, decimal, power_of_ten
from .consequences import ROOM, lambda_zero
from .eight import EightTheorem, prove_eight, waves
from .eight_bounds import inverse_norm, residual_bound
from .lifting import Pass, lift

__all__ = ["EightDigits", "certified", "digits", "load_digits", "thousand_digits"]

LARGEST = 4000                  # digits; Python prints integers up to 4300
GUARD = 12                      # digits that rounding and the bounds may cost
STORED = Path(__file__).parent / "data" / "eight_1000.json"
PROOF: dict[str, Any] = {"modes": 60, "nu": "1.001"}


@dataclass(frozen=True)
class EightDigits:
    """The figure eight, certified; G = m = 1 and T = 2π, as in the equations.

    Attributes
    ----------
    digits : int
        Digits after the point that :meth:`decimals` gives.
    bits : int
        The approximate unknowns are integers over 2^bits.
    unknowns : dict
        ``{n: fmpz}``, these integers: ū'_n of the module's formula.
    distance : arb
        The true eight is within this ℓ¹_ν distance of them.
    lam : arb
        A ball that contains λ₀.
    proof : dict
        The certificate of the theorem on which all rests.
    """

    digits: int
    bits: int
    unknowns: dict[int, fmpz]
    distance: arb
    lam: arb
    proof: dict[str, Json]

    #: exactly, because r_3 = 0, r_1 = -r_2 and v_1 = v_2 at t = 0
    angular_momentum = 0

    @property
    def precision(self) -> int:
        """Bits in which its balls should be computed with."""
        return self.bits + 64

    @property
    def positions(self) -> tuple[acb, acb, acb]:
        """Balls around r_1, r_2, r_3 at t = 0, complex as in x + iy."""
        with working(bits=self.precision):
            z = self._sum(lambda n: 1, self.distance) * arb(3).root(3) / 2
            return z, -z, acb(0)

    @property
    def velocities(self) -> tuple[acb, acb, acb]:
        """Balls around the velocities of the three bodies at t = 0."""
        with working(bits=self.precision):
            rate = self.distance / (arb(1).exp() * arb(self.proof["nu"]).log())
            half = arb(3).sqrt() / 2
            z = self._sum(lambda n: (-n if n % 3 == 1 else n) * half, rate)
            v = z * arb(3).root(3) / 3
            return -v, -v, 2 * v

    @property
    def energy(self) -> arb:
        """A ball around the energy."""
        with working(bits=self.precision):
            return 3 * abs(self.velocities[2])**2 / 4 - 5 / (2 * abs(self.positions[0]))

    @property
    def coefficients(self) -> dict[int, arb]:
        """``{n: ball}``, in x_3 (n even) and y_3 (n odd) the coefficient of sin nt; see (E7)."""
        with working(bits=self.precision):
            unit = 1 / arb(3).root(6)
            error = arb(0, upper(self.distance))
            return {n: (self.unknown(n) + error) * (-unit if n % 3 == 1 else unit)
                    for n in self.unknowns}

    def decimals(self) -> dict[str, str]:
        """The named quantities as decimals, truncated: λ₀, r_1(0), v_3(0) and the energy."""
        r, v = self.positions[0], self.velocities[2]
        balls = {"lambda_0": self.lam, "x_1": r.real, "y_1": r.imag, "vx_3": v.real,
                 "vy_3": v.imag, "energy": self.energy}
        return {name: decimal(x, self.digits) for name, x in balls.items()}

    def normal_form(self) -> dict[str, Any]:
        """Position of body 1, velocity of body 3, period and energy of the eight lying, |r_1| = 1.

        That is how initial values are usually printed.
        """
        with working(bits=self.precision):
            r, v = self.positions[0], self.velocities[2]
            size, turn = abs(r), acb(0, 1)
            return {"position_1": turn * acb(r.real, -r.imag) / size,
                    "velocity_3": turn * acb(v.real, -v.imag) * size.sqrt(),
                    "period": 2 * arb.pi() / size.sqrt()**3, "energy": self.energy * size}

    def save(self, path: FilePath) -> None:
        """Write a certificate, for :func:`ftseries.certify.check` and :func:`load_digits`."""
        numbers = (int(self.unknowns.get(n, 0)) for n in range(1, max(self.unknowns) + 1) if n % 3)
        text = (b64encode(c.to_bytes(c.bit_length() // 8 + 1, "big", signed=True)).decode()
                for c in numbers)
        certificate.write(path, {
            "theorem": "figure eight, digits", "precision": self.precision, "digits": self.digits,
            "decimals": self.decimals(), "eight": self.proof, "bits": self.bits,
            "distance": certificate.exact(self.distance), "lam": certificate.ball(self.lam),
            "unknowns": " ".join(text)})

    def __str__(self) -> str:
        lines = [f"{name} = {text}" for name, text in self.decimals().items()]
        return "\n".join([f"The figure eight to {self.digits} digits after the point, truncated.",
                          "G = m = 1, T = 2π, angular momentum 0; at t = 0",
                          "r_1 = -r_2 = (x_1, y_1), r_3 = 0, v_3 = (vx_3, vy_3) = -2 v_1 = -2 v_2.",
                          *lines, f"[{len(self.unknowns)} Fourier coefficients within "
                          f"{power_of_ten(self.distance)}]"])

    def unknown(self, n: int) -> arb:
        """ū'_n as a number."""
        return arb(self.unknowns[n]) * arb(2)**-self.bits

    def _sum(self, factor: Callable[[int], Any], error: arb) -> acb:
        """Σ factor(n) u_n, even n in the real and odd n in the imaginary part."""
        parts = [arb(0, upper(error)), arb(0, upper(error))]
        for n in self.unknowns:
            parts[n % 2] += self.unknown(n) * factor(n)
        return acb(*parts)


def digits(n: int) -> EightDigits:
    """Compute and certify the figure eight to ``n`` digits after the point.

    Parameters
    ----------
    n : int
        1 to 4000.  Fifty digits take less than a second, a thousand half a minute on one core,
        twice as many up to eight times as long.

    Returns
    -------
    EightDigits

    Raises
    ------
    InputError
        ``n`` is no such number.

    Examples
    --------
    >>> import ftseries as fts
    >>> eight = fts.figure_eight.digits(30)
    >>> print(eight.decimals()["lambda_0"])
    2.075683908849089472039075994880
    >>> eight.lam.rad() < 1e-38
    True
    """
    n = whole("n", n, 1, LARGEST)
    theorem = prove_eight(solve(FigureEight(), order=6).refine(), **PROOF)
    for guard in (GUARD, 2 * GUARD, 4 * GUARD):         # a longer run of nines needs more
        *_, last = lift(theorem.center, theorem.inverse, max(64, int((n + guard) * 3.33)))
        found = certified(theorem, last, n)
        try:
            found.decimals()
        except NotProved:
            continue
        return found
    raise NotProved(f"not proved: some digit of {n} is not decided by {guard} digits more")


def certified(theorem: EightTheorem, guess: Pass, n: int) -> EightDigits:
    """What a guess of :func:`ftseries.certify.lifting.lift` proves; see the module's formula.

    Raises
    ------
    NotProved
        The guess is outside the ball of the theorem, or its root is too poor.
    """
    with working(bits=guess.bits + 64):
        nu, unit = arb(theorem.nu), arb(2)**-guess.bits
        u = {k: arb(c) * unit for k, c in guess.u.items()}
        scale = arb(2)**-guess.root_bits
        v = RING.from_modes({(0, 2 * k): arb(c) * (scale if k == 0 else 2 * scale)
                             for k, c in enumerate(guess.root)})
        x, y = waves(u, nu)
        g = (x * x + y * y).negative_power(3, v)
        index, top = list(theorem.center), theorem.modes
        weight = {k: nu**k for k in range(1, 3 * max(u) + 3 * len(guess.root) * 2)}
        a = arb_mat([[arb(c) for c in row] for row in theorem.inverse])
        gap = sum((abs(u.get(k, arb(0)) - arb(theorem.center.get(k, 0.0))) * nu**k
                   for k in u.keys() | theorem.center.keys()), arb(0))
        reach, bounds = upper(gap.max(theorem.radius)), theorem.bounds
        gain = 1 - bounds.z1 - bounds.z2 * reach
        if not (reach <= bounds.largest and gain > 0):
            raise NotProved(f"not proved: the guess is {at_most(reach)} away from the center of "
                            "the theorem")
        norm_a = inverse_norm(a, index, top, weight)
        y_bound = residual_bound(u, x, y, g, a, index, top, weight, norm_a)
        distance = upper(y_bound / gain * ROOM)
        return EightDigits(n, guess.bits, guess.u, distance, lambda_zero(x, y, v, distance),
                           theorem.contents())


def load_digits(path: Any) -> EightDigits:
    """Read what :meth:`EightDigits.save` wrote.

    The file is checked against damage and for consistency, but nothing is proved again; that is
    what :func:`ftseries.certify.check` does.

    Raises
    ------
    FileError
        The file cannot be read, is damaged, or holds another theorem.

    Examples
    --------
    >>> load_digits(STORED).digits
    1000
    """
    data, path = certificate.read(path), os.fspath(path)
    if data.get("theorem") != "figure eight, digits":
        raise FileError(f"{path!r} is no certificate of digits; give a file that the result of "
                        "ftseries.figure_eight.digits(n) has saved")
    try:
        index = (n for n in range(1, 10**6) if n % 3)
        unknowns = {n: fmpz(int.from_bytes(b64decode(text), "big", signed=True))
                    for text, n in zip(data["unknowns"].split(), index)}
        with working(bits=data["precision"]):
            found = EightDigits(data["digits"], data["bits"], unknowns,
                                certificate.number(data["distance"]),
                                certificate.read_ball(data["lam"]), data["eight"])
        if found.decimals() != data["decimals"]:
            raise ValueError("its decimals are not those of its numbers")
        return found
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError,
            NotProved) as error:
        raise FileError(f"{path!r} is damaged: {error}; compute the digits again") from None


def thousand_digits() -> EightDigits:
    """The thousand digits that come with the package.

    They are read, not proved: ``ftseries.certify.check(ftseries.certify.digits.STORED)`` proves
    them again, ``ftseries.figure_eight.digits(1000).save(path)`` makes the file anew.

    Examples
    --------
    >>> thousand_digits().decimals()["energy"][:12]
    '-1.292970857'
    """
    return load_digits(STORED)
