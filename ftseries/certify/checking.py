r"""Check a certificate: prove its claims again, with none of the code that found them.

Formula.  The eight: :mod:`ftseries.certify.checking_eight`, its digits:
:mod:`ftseries.certify.checking_digits`, its series: :mod:`ftseries.certify.checking_convergence`.
The eigenvalue: everything in
:mod:`ftseries.certify.mathieu` is rational, so it is computed exactly here, and negative
eigenvalues are counted by Descartes' rule, which is exact for a polynomial with real roots only.
The oscillator: at a = 1, with m = 2λ/(3 + λ), K = K(m), E = E(m) and q = exp(-π K(1-m)/K), it has

.. math::  ω^2 = \frac{π^2 (3 + λ)}{K^2}, \quad A_0 = 2 - (3 + λ) \frac{E}{K}, \quad
           A_n = -2 ω^2 \frac{n (-q)^n}{1 - q^{2n}},

and \|A_n\| ≤ 2ω² n qⁿ/(1 - q²) sums up beyond N to at most
2ω² q^{N+1} (N + 1)/((1 - q²)(1 - q)²).
"""

from __future__ import annotations

from flint import acb, arb, fmpq, fmpq_mat

from ..aliases import FilePath, Json
from ..errors import FileError
from ..precision import working
from . import certificate
from .algebra import at_least, at_most
from .certificate import number, read_ball, require
from .checking_convergence import check_convergence
from .checking_digits import check_digits
from .checking_eight import check_eight

__all__ = ["check"]


def check(path: FilePath) -> str:
    """Prove again what a certificate claims.

    Parameters
    ----------
    path : str or path
        A file written by the method ``save`` of a theorem.

    Returns
    -------
    str
        What is proved.

    Raises
    ------
    FileError
        The file is damaged, or no certificate.
    NotProved
        The claims do not follow; the message names the first inequality that fails.
    """
    data = certificate.read(path)
    proofs = {"figure eight": check_eight, "convergence": check_convergence,
              "figure eight, digits": check_digits,
              "Mathieu eigenvalue": _mathieu, "cubic oscillator": _cubic}
    try:
        kind, precision = data["theorem"], data["precision"]
        if kind not in proofs:
            raise FileError(f"{str(path)!r} holds a theorem of unknown kind {kind!r}")
        if not 53 <= precision <= 100000:
            raise FileError(f"{str(path)!r} asks for {precision} bits; 53 to 100000 are possible")
        with working(bits=precision):
            proved: str = proofs[kind](data)
            return proved
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError) as error:
        raise FileError(f"{str(path)!r} is damaged: {error}; prove the theorem again") from None


def _exactly(text: str) -> fmpq:
    mantissa, exponent = (int(i) for i in text.split())
    return fmpq(mantissa) * fmpq(2) ** exponent


def _rational(text: str) -> fmpq:
    p, _, q = text.partition("/")
    return fmpq(int(p), int(q or 1))


def _mathieu(data: dict[str, Json]) -> str:
    lam, mu = _rational(data["lam"]), _rational(data["mu"])
    v, beta = [_exactly(x) for x in data["vector"]], _exactly(data["beta"])
    size, q, s = len(v), lam**2 / 2, lam**4 * mu / 2
    require(size > 2 and any(v), "v has at least three entries, one not 0")

    def times(x: list[fmpq], i: int) -> fmpq:
        total = (2 * i + 1) ** 2 * x[i]
        for step, factor in ((1, q), (2, s)):
            low = i - step
            total += factor * (x[i + step] + (x[low] if low >= 0 else -x[-low - 1]))
        return total

    padded = v + [fmpq(0)] * 4
    image = [times(padded, i) for i in range(size + 2)]
    square = sum((c * c for c in v), fmpq(0))
    eta = sum((c * y for c, y in zip(v, image)), fmpq(0)) / square
    rest = sum(((y - eta * c) ** 2 for y, c in zip(image, padded)), fmpq(0)) / square
    require(eta < beta, "η < β")
    norm = abs(q) + abs(s)
    tau = (2 * size + 1) ** 2 - 2 * norm - beta
    require(tau > 0, "τ > 0")
    block = fmpq_mat(size, size)
    for k in range(size):
        unit = [fmpq(int(i == k)) for i in range(size + 2)]
        for i in range(size):
            block[i, k] = times(unit, i) - (beta + norm**2 / tau if i == k else 0)
    signs = [c * (-1) ** i > 0 for i, c in enumerate(block.charpoly().coeffs()) if c]
    require(sum(a != b for a, b in zip(signs, signs[1:])) == 1, "one eigenvalue below β")
    mid, rad = (_exactly(c) for c in data["a"])
    require(mid - rad <= eta - rest / (beta - eta) and eta <= mid + rad, "the enclosure of a")
    return (f"Checked. For λ = {lam}, μ = {mu} the lowest eigenvalue of (M1) with odd modes is "
            f"{read_ball(data['a']).str(40)}, and the next is at least {at_least(arb(beta), 6)}.")


def _cubic(data: dict[str, Json]) -> str:
    lam = arb(_rational(data["lam"]) / _rational(data["a"]))
    modes, r = [arb(_rational(c)) for c in data["modes"]], number(data["radius"])
    require(lam > 0 and lam < 3, "0 < λ < 3a")
    m, top = 2 * lam / (3 + lam), len(modes) - 1
    k, e, other = (f.real for f in (acb(m).elliptic_k(), acb(m).elliptic_e(),
                                    acb(1 - m).elliptic_k()))
    q, square = (-arb.pi() * other / k).exp(), arb.pi() ** 2 * (3 + lam) / k**2
    error = abs(square - arb(_rational(data["square"]))) + abs(2 - (3 + lam) * e / k - modes[0])
    for n in range(1, top + 1):
        error += abs(-2 * square * n * (-q) ** n / (1 - q ** (2 * n)) - modes[n])
    error += 2 * square * q ** (top + 1) * (top + 1) / ((1 - q**2) * (1 - q) ** 2)
    require(error <= r, "|ω² - Ω̄| + Σ |A_n - Ā_n| ≤ r")
    return (f"Checked. At a = {data['a']}, λ = {data['lam']} the amplitudes in the file are within "
            f"{at_most(r)} a of the solution's.")
