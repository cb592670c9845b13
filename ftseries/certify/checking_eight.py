r"""Check the certificate of a figure eight, with none of the code that found it.

Formula.  The guesses in the file (ū, v ≈ W^{-1/2} and the matrix a) are only read; all bounds are
computed here.  A cosine series Σ c_n cos nt is the Laurent polynomial Σ a_n z^n with a_0 = c_0 and
a_{±n} = c_n/2, kept as a FLINT polynomial of z² shifted by its degree; its norm is Σ |a_n| ν^{|n|}.
The inequalities are those of :mod:`ftseries.certify.eight_bounds` and
:mod:`ftseries.certify.newton_kantorovich`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from flint import acb, arb, arb_mat, arb_poly

from ..aliases import Json
from ..precision import working
from .balls import at_least, at_most
from .certificate import number, read_ball, require, upper_bound
from .grammar import decimal, entries, modes, record, whole

__all__ = ["Laurent", "Proved", "check_eight", "lambda_zero", "prove", "residual", "root_modes"]

_MODES = 400


class Laurent:
    """A Laurent polynomial with the powers -d, -d + 2, …, d, known up to ``error`` in norm."""

    def __init__(self, poly: arb_poly, degree: int, nu: arb, error: Any = 0) -> None:
        self.poly, self.degree, self.nu, self.error = poly, degree, nu, arb(error)

    @classmethod
    def cosines(cls, modes: dict[int, arb], nu: arb) -> Laurent:
        """Σ modes[n] cos nt, all n of one parity."""
        d = max(modes)
        return cls(arb_poly([modes.get(abs(i), arb(0)) / (2 if i else 1)
                             for i in range(-d, d + 1, 2)]), d, nu)

    @property
    def powers(self) -> range:
        return range(-self.degree, self.degree + 1, 2)

    def __getitem__(self, n: int) -> arb:
        return self.poly[(self.degree + n) // 2] if n in self.powers else arb(0)

    def size(self) -> arb:
        """Norm of what is known."""
        with working(bits=64):
            return sum((abs(self[n]) * self.nu ** abs(n) for n in self.powers), arb(0)).upper()

    def norm(self) -> arb:
        return (self.size() + self.error).upper()

    def __mul__(self, other: Laurent) -> Laurent:
        error = (self.size() * other.error + other.size() * self.error
                 + self.error * other.error).upper()
        return Laurent(self.poly * other.poly, self.degree + other.degree, self.nu, error)

    def __add__(self, other: Laurent) -> Laurent:
        low, high = sorted((self, other), key=lambda f: f.degree)
        poly = low.poly.left_shift((high.degree - low.degree) // 2) + high.poly
        return Laurent(poly, high.degree, self.nu, self.error + other.error)

    def times(self, factor: Any) -> Laurent:
        return Laurent(self.poly * factor, self.degree, self.nu, self.error * abs(factor))

    def widened(self, error: Any) -> Laurent:
        return Laurent(self.poly, self.degree, self.nu, (self.error + error).upper())

    def slope(self) -> Laurent:
        """1/i times the derivative by t."""
        return Laurent(arb_poly([self[n] * n for n in self.powers]), self.degree, self.nu)

    def cut(self, d: int) -> Laurent:
        """The powers up to d only; the rest goes into the error."""
        d -= (self.degree - d) % 2
        if d >= self.degree:
            return self
        rest = sum((abs(self[n]) * self.nu ** abs(n) for n in self.powers if abs(n) > d), arb(0))
        return Laurent(arb_poly([self[n] for n in range(-d, d + 1, 2)]), d, self.nu,
                       (self.error + rest).upper())


@dataclass(frozen=True)
class Proved:
    """The constants of the theorem, proved again."""

    nu: arb
    top: int
    center: dict[int, arb]
    index: list[int]
    inverse: arb_mat
    norm: arb
    z1: arb
    z2: arb
    low: arb
    high: arb
    largest: arb


def check_eight(data: dict[str, Json]) -> str:
    """What the certificate proves, as a sentence, or :class:`ftseries.certify.NotProved`."""
    proved = prove(data)
    return ("Checked. Newton's equations of three equal bodies have exactly one solution with the "
            f"symmetries of the figure eight within {at_least(proved.high)} of the Fourier sum in "
            f"the file (ℓ¹ norm, ν = {data['nu']}, unit 3^(1/3)); it lies within "
            f"{at_most(proved.low)} of it, never collides, and λ₀ = "
            f"{read_ball(data['lam']).str(25)}.")


def prove(data: dict[str, Json]) -> Proved:
    """:class:`Proved`, or :class:`ftseries.certify.NotProved`."""
    record(data, "theorem nu modes center root inverse largest radius uniqueness lam positions "
                 "velocities")
    nu, top = decimal(data["nu"]), whole(data["modes"], 4, _MODES)
    u = {n: number(c) for n, (c,) in modes(data["center"], top).items()}
    low, high, largest = (number(data[key]) for key in ("radius", "uniqueness", "largest"))
    require(nu > 1 and low >= 0 and low < high and high <= largest, "0 ≤ r < R ≤ r*, ν > 1")
    require(all(0 < n <= top and n % 3 for n in u), "ū has the modes 1, 2, 4, …, N")
    index = [n for n in range(1, top + 1) if n % 3]
    shape = (len(index),) * 2
    a = arb_mat([[number(c) for c in entries(row, *shape)]
                 for row in entries(data["inverse"], *shape)])
    v = Laurent.cosines(root_modes(data, top), nu)
    part = [Laurent.cosines({n: c for n, c in u.items() if n % 2 == i}, nu) for i in (0, 1)]
    one = Laurent.cosines({0: arb(1)}, nu)
    w = part[0] * part[0] + part[1] * part[1]
    square = v * v
    require(sum(v.poly.coeffs(), arb(0)) > 0, "v(0) > 0")
    defect = one + (square * w).times(-1)
    z = (part[0].norm() + part[1].norm() + largest).upper()
    wide = (defect.norm() + square.norm() * (2 * z * largest + largest**2)).upper()
    require(wide < 1, "‖1 - v²W‖ < 1 on the ball of radius r*")
    e, size = defect.norm(), v.norm()

    def power(p: int, f: Laurent) -> Laurent:
        return f.widened(f.norm() * ((1 - e) ** (-arb(p) / 2) - 1)).cut(2 * top)

    g = power(3, square * v)
    h = power(5, square * square * v)
    m = [[(h * part[i] * part[j]).times(-3).cut(2 * top) for j in (0, 1)] for i in (0, 1)]
    m = [[m[i][j] + g if i == j else m[i][j] for j in (0, 1)] for i in (0, 1)]
    norm_a = upper_bound([*_column_norms(a, index, index, nu), 1 / arb(top + 1) ** 2])
    y = residual(u, [part[i] * g for i in (0, 1)], a, index, top, norm_a, nu)
    z1 = _first(a, m, index, top, norm_a, nu)
    s = (size * (1 - wide) ** (-arb(1) / 2)).upper()
    z2 = norm_a * (9 * s**5 * z + 15 * s**7 * z**3)
    require(y - (1 - z1) * low + z2 * low**2 / 2 <= 0, "p(r) ≤ 0")
    require(z1 + z2 * high < 1, "Z₁ + Z₂ R < 1")
    require(read_ball(data["lam"]).contains(lambda_zero(part, square, e, size, low)),
            "the enclosure of λ₀")
    _initial_values(data, part, low, nu)
    return Proved(nu, top, u, index, a, norm_a, z1, z2, low, high, largest)


def root_modes(data: dict[str, Json], top: int) -> dict[int, arb]:
    """The Fourier coefficients of v."""
    v = {n: number(c) for n, (c,) in modes(data["root"], 2 * top).items()}
    require(all(n % 2 == 0 for n in v), "v has even modes")
    return v


def _column_norms(matrix: arb_mat, rows: list[int], columns: list[int], nu: arb) -> Iterator[arb]:
    for j, k in enumerate(columns):
        yield sum((abs(matrix[i, j]) * nu**n for i, n in enumerate(rows)), arb(0)) / nu**k


def residual(u: dict[int, arb], product: Sequence[Laurent], a: arb_mat, index: list[int], top: int,
             norm_a: arb, nu: arb) -> arb:
    """Y, a bound of ‖A F(u)‖; u may have more modes than the block."""
    def force(n: int) -> arb:
        return 2 * product[n % 2][n]

    inside = a * arb_mat([[n * n * u.get(n, arb(0)) - force(n)] for n in index])
    total = sum((abs(inside[i, 0]) * nu**n for i, n in enumerate(index)), arb(0))
    for n in range(top + 1, max(f.degree for f in product) + 1):
        if n % 3:
            total += abs(n * n * u.get(n, arb(0)) - force(n)) / n**2 * nu**n
    return (total + norm_a * (product[0].error + product[1].error)).upper()


def _first(a: arb_mat, m: list[list[Laurent]], index: list[int], top: int, norm_a: arb,
           nu: arb) -> arb:
    """Z₁: columns up to N + 2N are summed up, all others stay beyond the block."""
    def entry(n: int, k: int) -> arb:
        f = m[n % 2][k % 2]
        return f[n - k] + f[n + k]

    beyond = [k for k in range(top + 1, 3 * top + 1) if k % 3]
    columns = index + beyond
    derivative = arb_mat([[(n * n if n == k else 0) - entry(n, k) for k in columns]
                          for n in index])
    product = a * derivative
    sums = []
    for j, k in enumerate(columns):
        total = arb(0)
        for i, n in enumerate(index):
            total += abs((n == k) - product[i, j]) * nu**n
        for n in range(top + 1, k + 2 * top + 1):
            if n % 3:
                total += abs(entry(n, k)) / n**2 * nu**n
        sums.append(total / nu**k)
    far = [(m[0][j].norm() + m[1][j].norm()) / (top + 1) ** 2 for j in (0, 1)]
    error = upper_bound(m[0][j].error + m[1][j].error for j in (0, 1))
    return (upper_bound([*sums, *far]) + norm_a * error).upper()


def lambda_zero(part: Sequence[Laurent], square: Laurent, e: arb, size: arb, low: arb) -> arb:
    """λ₀ = 2c_1, where φ' = Σ i c_n e^{int}."""
    root = square.widened(square.norm() * (1 / (1 - e) - 1))
    rate = (part[0] * part[1].slope() + (part[1] * part[0].slope()).times(-1)) * root
    angle = low * size * (1 - e) ** (-arb(1) / 2)
    require(angle < 1, "the distance from a collision")
    error = rate.error / rate.nu + 4 / arb.pi() * angle / (1 - angle)
    return 2 * rate[1] + arb(0, error.upper())


def _initial_values(data: dict[str, Json], part: Sequence[Laurent], low: arb, nu: arb) -> None:
    unit = arb(3).root(3)
    for name, moment in (("positions", 0), ("velocities", 1)):
        sums = []
        for turn in (0, -1, 1):                             # r_12, r_23, r_31 at t = 0
            z = acb.exp_pi_i(acb(2 * turn) / 3)
            x, y = (sum((f[n] * (acb(0, n) ** moment) * z**n
                         for n in range(-f.degree, f.degree + 1)), acb(0)).real for f in part)
            sums.append(acb(x, y))
        error = 2 * low * unit / 3 / (arb(1).exp() * nu.log()) ** moment
        for i, claims in enumerate(entries(data[name], 3, 3)):
            body = (sums[i] - sums[i - 1]) * unit / 3
            for claim, value in zip(entries(claims, 2, 2), (body.real, body.imag)):
                require(read_ball(claim).contains(value + arb(0, error.upper())),
                        f"the enclosure of the {name}")
