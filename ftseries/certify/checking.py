r"""Check a certificate: prove its claims again, with none of the code that found them.

Formula.  The eight: :mod:`ftseries.certify.checking_eight`, its digits:
:mod:`ftseries.certify.checking_digits`, its series: :mod:`ftseries.certify.checking_convergence`.
The oscillator: :mod:`ftseries.certify.checking_cubic`.  The eigenvalue: what is rational in
:mod:`ftseries.certify.mathieu` is computed exactly here, with v scaled to integers.  Only the signs
of the pivots are decided in balls.

Every entry has to obey :mod:`ftseries.certify.grammar`, and no entry may be there that is not read:
what an accepted file says is proved.
"""

from __future__ import annotations

from flint import arb, fmpq, fmpz

from ..aliases import FilePath, Json
from ..errors import FileError
from ..precision import working
from . import certificate
from .balls import at_least
from .certificate import read_ball, require
from .checking_convergence import check_convergence
from .checking_cubic import check_cubic
from .checking_digits import check_digits
from .checking_eight import check_eight
from .grammar import MOST_BITS, dyadic, entries, exactly, rational, record, whole

__all__ = ["check"]

_PARAMETER = 10000                  # characters of λ and μ
_EXPONENT = 40000                   # of two, in the eigenvector


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
              "Mathieu eigenvalue": _mathieu, "cubic oscillator": check_cubic}
    try:
        kind, precision = data["theorem"], data["precision"]
        if kind not in proofs:
            raise FileError(f"{str(path)!r} holds a theorem of unknown kind {kind!r}")
        with working(bits=whole(precision, 53, MOST_BITS)):
            proved: str = proofs[kind]({name: entry for name, entry in data.items()
                                        if name not in ("format", "version", "precision")})
            return proved
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError) as error:
        raise FileError(f"{str(path)!r} is damaged: {error}; prove the theorem again") from None


def _mathieu(data: dict[str, Json]) -> str:
    record(data, "theorem lam mu a beta vector")
    lam, mu = (rational(data[key], _PARAMETER) for key in ("lam", "mu"))
    beta, v = exactly(data["beta"]), _scaled(data["vector"])
    size, q, s = len(v), lam**2 / 2, lam**4 * mu / 2
    require(any(v), "v is not 0")
    common = q.q * s.q

    def times(x: list[fmpz], i: int) -> fmpz:
        """Entry i of ``common`` H x."""
        total = common * (2 * i + 1) ** 2 * x[i]
        for step, factor in ((1, q.p * s.q), (2, s.p * q.q)):
            low = i - step
            total += factor * (x[i + step] + (x[low] if low >= 0 else -x[-low - 1]))
        return total

    padded = v + [fmpz(0)] * 4
    image = [times(padded, i) for i in range(size + 2)]
    square = sum((c * c for c in v), fmpz(0))
    along = sum((c * y for c, y in zip(v, image)), fmpz(0))
    across = sum(((y * square - along * c) ** 2 for y, c in zip(image, padded)), fmpz(0))
    eta, rest = fmpq(along, common * square), fmpq(across, common**2 * square**3)
    require(eta < beta, "η < β")
    norm = abs(q) + abs(s)
    tau = (2 * size + 1) ** 2 - 2 * norm - beta
    require(tau > 0, "τ > 0")
    require(_negative_pivots(size, arb(q), arb(s), arb(beta + norm**2 / tau)) == 1,
            "one eigenvalue below β")
    mid, rad = (exactly(c) for c in data["a"])
    require(mid - rad <= eta - rest / (beta - eta) and eta <= mid + rad, "the enclosure of a")
    return (f"Checked. For λ = {lam}, μ = {mu} the lowest eigenvalue of (M1) with odd modes is "
            f"{read_ball(data['a']).str(40)}, and the next is at least {at_least(arb(beta), 6)}.")


def _scaled(vector: Json) -> list[fmpz]:
    """Dyadic numbers times a power of two that makes them integers."""
    pairs = [dyadic(x) for x in entries(vector, 3, 512)]
    least = min(whole(e, -_EXPONENT, _EXPONENT) for _, e in pairs)
    return [m << (e - least) for m, e in pairs]


def _negative_pivots(size: int, q: arb, s: arb, shift: arb) -> int:
    """How many pivots of the corner of H - shift are negative, once the signs are certain.

    Three rows of what is left of the matrix are enough, for it has five diagonals.
    """
    def entry(i: int, j: int) -> arb:
        total = arb((2 * i + 1) ** 2) - shift if i == j else arb(0)
        for step, factor in ((1, q), (2, s)):
            total += factor * ((abs(i - j) == step) - (i + j + 1 == step))
        return total

    negative, left = 0, {(i, j): entry(i, j) for i in range(2) for j in range(2)}
    for k in range(size):
        left |= {(i, k + 2): entry(i, k + 2) for i in range(k, k + 3)}
        left |= {(k + 2, j): left[j, k + 2] for j in range(k, k + 2)}
        pivot = left[k, k]
        require(pivot > 0 or pivot < 0, "a pivot is not 0")
        negative += bool(pivot < 0)
        for i in (k + 1, k + 2):
            for j in (k + 1, k + 2):
                left[i, j] -= left[i, k] * left[k, j] / pivot
    return negative
