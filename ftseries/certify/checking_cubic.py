r"""Check the certificate of the oscillator's series, with none of the code that found it.

Formula.  At a = 1, with m = 2λ/(3 + λ), K = K(m), E = E(m) and q = exp(-π K(1-m)/K), it has

.. math::  ω^2 = \frac{π^2 (3 + λ)}{K^2}, \quad A_0 = 2 - (3 + λ) \frac{E}{K}, \quad
           A_n = -2 ω^2 \frac{n (-q)^n}{1 - q^{2n}},

and \|A_n\| ≤ 2ω² n qⁿ/(1 - q²) sums up beyond N to at most
2ω² q^{N+1} (N + 1)/((1 - q²)(1 - q)²).  The truncated series, too, follows from these: with
2K/π = ₂F₁(½, ½; 1; m), 2E/π = ₂F₁(-½, ½; 1; m) and d ln q/dm = π²/(4m(1 - m)K²) they are power
series in λ with rational coefficients, and so is ω/√12.
"""

from __future__ import annotations

from math import comb

from flint import acb, arb, fmpq, fmpq_poly, fmpq_series

from ..aliases import Json
from ..precision import working
from .balls import at_most
from .certificate import number, require
from .grammar import entries, rational, record, whole

__all__ = ["check_cubic"]

_ORDER = 200
_PARAMETER = 1000                   # characters of a and λ


def check_cubic(data: dict[str, Json]) -> str:
    """What the certificate proves, as a sentence, or :class:`ftseries.certify.NotProved`."""
    record(data, "theorem a lam order square modes radius")
    a, lam = (rational(data[key], _PARAMETER) for key in ("a", "lam"))
    order, r = whole(data["order"], 0, _ORDER), number(data["radius"])
    modes = [rational(c) for c in entries(data["modes"], order + 1, order + 1)]
    require(a > 0 and lam > 0 and lam < 3 * a, "a > 0, 0 < λ < 3a")
    square = rational(data["square"])
    _require_truncated(order, lam / a, square, modes)
    error = _distance(arb(lam / a), square, modes)
    require(error <= r, "|ω² - Ω̄| + Σ |A_n - Ā_n| ≤ r")
    return (f"Checked. At a = {a}, λ = {lam} the series of Taylor order {order} is within "
            f"{at_most(r)} a of the solution: so large is at most the sum of the errors of its "
            "amplitudes.")


def _distance(lam: arb, square: fmpq, modes: list[fmpq]) -> arb:
    """\\|ω² - Ω̄\\| + Σ \\|A_n - Ā_n\\|, at a = 1."""
    m, top = 2 * lam / (3 + lam), len(modes) - 1
    k, e, other = (f.real for f in (acb(m).elliptic_k(), acb(m).elliptic_e(),
                                    acb(1 - m).elliptic_k()))
    q, true = (-arb.pi() * other / k).exp(), arb.pi() ** 2 * (3 + lam) / k**2
    error = abs(true - arb(square)) + abs(2 - (3 + lam) * e / k - arb(modes[0]))
    for n in range(1, top + 1):
        error += abs(-2 * true * n * (-q) ** n / (1 - q ** (2 * n)) - arb(modes[n]))
    return error + 2 * true * q ** (top + 1) * (top + 1) / ((1 - q**2) * (1 - q) ** 2)


def _require_truncated(order: int, lam: fmpq, square: fmpq, modes: list[fmpq]) -> None:
    """Ω̄ and the Ā_n have to be the Taylor polynomials of that order, at λ; one after the other."""
    terms = order + 2                                   # one is lost to the division by m
    with working(terms=terms):
        k = fmpq_series([fmpq(comb(2 * j, j) ** 2, 16**j) for j in range(terms)])
        e = fmpq_series([k[j] / (1 - 2 * j) for j in range(terms)])
        m, one = fmpq_series([0, 1]), fmpq_series([1])
        nome = m / 16 * ((one / ((one - m) * k * k) - one) / m).integral().exp()
        stretch = fmpq_series([3, 1])
        k, e, q = (f(fmpq_series([0, 2]) / stretch) for f in (k, e, nome))
        true, wave = 4 * stretch / (k * k), one

        def follows(series: fmpq_series, power: int, claim: fmpq) -> None:
            require(series.prec > order, "enough terms of the series")
            polynomial = fmpq_poly([series[j] for j in range(order + 1)])
            require(polynomial(lam) ** power == claim,
                    f"the truncated series of order {order} is the one in the file")

        follows((true / 12).sqrt(), 2, square / 12)
        follows(2 - stretch * e / k, 1, modes[0])
        for n, mode in enumerate(modes[1:], 1):
            wave = wave * -q
            follows(-2 * n * true * wave / (one - wave * wave), 1, mode)
