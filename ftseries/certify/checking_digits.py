r"""Check the certificate of many digits, with none of the code that found them.

Formula.  The theorem on the eight, which the file contains, is proved again; that gives the
constants of :mod:`ftseries.certify.digits`.  From the Fourier coefficients in the file, and from
nothing else in it, follow a guess v of 1/\|Z\|, by Newton's iteration v ← v (3 - v² W)/2 in more
and more bits, a bound of their distance from the true eight, λ₀, the initial values from all three
relative vectors, the energy from all three bodies, and the decimals.
"""

from __future__ import annotations

from base64 import b64decode
from itertools import count

from flint import acb, arb, arb_poly, ctx, fmpz

from ..aliases import Json
from ..precision import working
from .certificate import number, read_ball, require
from .checking_eight import Laurent, lambda_zero, prove, residual, root_modes
from .grammar import MOST_BITS, cut, record, whole

__all__ = ["check_digits"]

FIRST = 40                  # bits that the root in the theorem's certificate has at least
_UNKNOWNS = 10000


def check_digits(data: dict[str, Json]) -> str:
    """What the certificate proves, as a sentence, or :class:`ftseries.certify.NotProved`."""
    record(data, "theorem digits decimals eight bits distance lam unknowns")
    digits, distance = whole(data["digits"], 1, 4000), number(data["distance"])
    decimals = {name: cut(text, digits) for name, text in record(
        data["decimals"], "lambda_0 x_1 y_1 vx_3 vy_3 energy").items()}
    theorem = dict(data["eight"])
    with working(bits=min(whole(theorem.pop("precision"), 53, MOST_BITS), ctx.prec)):
        eight = prove(theorem)
    if theorem["theorem"] != "figure eight":
        raise ValueError("its digits rest on another theorem")
    u = _unknowns(data["unknowns"], whole(data["bits"], 1, MOST_BITS))
    part = [Laurent.cosines({n: c for n, c in u.items() if n % 2 == i}, eight.nu) for i in (0, 1)]
    w = part[0] * part[0] + part[1] * part[1]
    v = _root(root_modes(theorem, eight.top), w, max(u) + 40)
    square = v * v
    defect = (Laurent.cosines({0: arb(1)}, eight.nu) + (square * w).times(-1)).norm()
    require(defect < 1, "‖1 - v²W‖ < 1")
    require(sum(v.poly.coeffs(), arb(0)) > 0, "v(0) > 0")
    cube = square * v
    force = cube.widened(cube.norm() * ((1 - defect) ** (-arb(3) / 2) - 1))
    gap = sum((abs(u.get(n, arb(0)) - eight.center.get(n, arb(0))) * eight.nu**n
               for n in u.keys() | eight.center.keys()), arb(0))
    require(gap <= eight.largest, "‖ū' - ū‖ ≤ r*")
    gain = 1 - eight.z1 - eight.z2 * gap.max(eight.low)
    require(gain > 0, "Z₁ + Z₂ d < 1")
    y = residual(u, [f * force for f in part], eight.inverse, eight.index, eight.top, eight.norm,
                 eight.nu)
    require(y / gain <= distance, "‖A F(ū')‖ / (1 - Z₁ - Z₂ d) ≤ the distance")
    lam = read_ball(data["lam"])
    require(lam.contains(lambda_zero(part, square, defect, v.norm(), distance)),
            "the enclosure of λ₀")
    for name, x in {"lambda_0": lam, **_state(part, distance, eight.nu)}.items():
        require(_begins(x, decimals[name], digits), f"the decimals of {name}")
    exponent = (distance.log() / arb(10).log()).upper().ceil().unique_fmpz()
    return (f"Checked. The {digits} digits of λ₀, of the initial values and of the energy of the "
            f"figure eight in the file are those of the true eight, and its {len(u)} Fourier "
            f"coefficients are within 10^{exponent} of the true ones.")


def _unknowns(text: Json, bits: int) -> dict[int, arb]:
    if type(text) is not str or len(words := text.split(" ")) > _UNKNOWNS:
        raise ValueError(f"its unknowns are not a text of at most {_UNKNOWNS} numbers")
    modes, unit = (n for n in count(1) if n % 3), arb(2) ** -bits
    return {n: arb(_integer(word, bits)) * unit for n, word in zip(modes, words)}


def _integer(word: str, bits: int) -> fmpz:
    """A number in two's complement, without superfluous bytes, below 2^(bits + 8)."""
    raw = b64decode(word, validate=True)
    value = int.from_bytes(raw, "big", signed=True)
    if len(raw) != value.bit_length() // 8 + 1 or value.bit_length() > bits + 8:
        raise ValueError("one of its unknowns is not a number of so many bits")
    return fmpz(value)


def _root(guess: dict[int, arb], w: Laurent, top: int) -> Laurent:
    """v ≈ W^{-1/2} to the precision in force, doubled step by step."""
    v, three = (Laurent.cosines(modes, w.nu) for modes in (guess, {0: arb(3)}))
    steps = [ctx.prec]
    while steps[-1] > FIRST:
        steps.append(steps[-1] // 2 + 2)
    for bits in reversed(steps):
        d = min(top, 2 * bits)                                  # more harmonics for more bits
        with working(bits=bits + 30):
            low = w.cut(d).times(arb(1))                        # rounded
            v = v * (three + ((v * v).cut(d) * low).cut(d).times(-1))
            v = v.times(arb(1) / 2).cut(d)
            v = Laurent(arb_poly([c.mid() for c in v.poly.coeffs()]), v.degree, w.nu)
    return v


def _state(part: list[Laurent], distance: arb, nu: arb) -> dict[str, arb]:
    """Balls around position 1, velocity 3 and the energy, from r_12, r_23 and r_31."""
    unit, bodies = arb(3).root(3), []
    for moment in (0, 1):
        pairs = []
        for turn in (0, -1, 1):                             # r_12, r_23, r_31 at t = 0
            z = acb.exp_pi_i(acb(2 * turn) / 3)
            waves = (f if moment == 0 else f.slope() for f in part)
            x, y = ((f.poly(z**2) / z**f.degree * acb(0, 1)**moment).real for f in waves)
            error = arb(0, (distance / (arb(1).exp() * nu.log()) ** moment).upper())
            pairs.append(acb(x + error, y + error) * unit)
        bodies.append([(pairs[i] - pairs[i - 1]) / 3 for i in range(3)])
    r, v = bodies
    energy = (sum((abs(z) ** 2 for z in v), arb(0)) / 2
              - sum((1 / abs(r[i] - r[i - 1]) for i in range(3)), arb(0)))
    return {"x_1": r[0].real, "y_1": r[0].imag, "vx_3": v[2].real, "vy_3": v[2].imag,
            "energy": energy}


def _begins(x: arb, decimals: tuple[bool, fmpz], digits: int) -> bool:
    """Whether every number in the ball x has these decimals."""
    negative, claimed = decimals
    low, high = (arb(c) / arb(10) ** digits for c in (claimed, claimed + 1))
    size = -x if negative else x
    return bool(size >= low and size < high)
