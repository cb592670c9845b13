r"""Does `refine` stay on its family? Random problems, followed in small steps by other code.

    python benchmarks/refined.py [number] [seed]                # or: make refined

A row is one problem at one order and one λ.  Truth: the family followed from λ ≈ 0 in equal steps,
by a Galerkin method of its own with full derivatives, which shares nothing with the package but the
text of the equations.  A family that this cannot follow, or differently with twice the steps, is
left out.
"""

import re
import sys
import time
import warnings
from collections import Counter

import numpy as np
import sympy as sp

import ftseries as fts

MODES, POINTS = 24, 128
ORDERS = (1, 2, 4, 6, 8, 12)
TAU = 2 * np.pi * np.arange(POINTS) / POINTS
N = np.arange(MODES + 1)[:, None]
COS, SIN = np.cos(N * TAU), np.sin(N * TAU)


class Family:
    """Fields that are even in τ, and ω; ``left``: left sides in x_0, x_1, x_2, y_0, …, lam, t."""

    def __init__(self, left, free):
        names = ("x", "y")[:len(left)]
        symbols = [sp.Symbol(f"{name}_{k}") for name in names for k in range(3)]
        self.free, self.fields = free, len(left)
        self.sides = sp.lambdify([*symbols, *sp.symbols("lam t")], left, "numpy")

    def rest(self, v, lam):
        """The modes of the residuals, for v of shape (…, unknowns)."""
        omega = v[..., -1:] if self.free else 1.0
        waves = []
        for i in range(self.fields):
            c = v[..., i * (MODES + 1):(i + 1) * (MODES + 1)]
            waves += [c @ COS, -omega * ((c * N[:, 0]) @ SIN), -omega**2 * ((c * N[:, 0]**2) @ COS)]
        rest = [np.broadcast_to(side, waves[0].shape) @ COS.T * 2 / POINTS
                for side in self.sides(*waves, lam, TAU)]
        return np.concatenate([*rest, v[..., 1:2] - lam][:None if self.free else -1], axis=-1)

    def newton(self, v, lam):
        """Newton's method with the matrix of the first step."""
        with np.errstate(all="ignore"):
            matrix = self.rest(v + 1e-30j * np.eye(len(v)), lam).imag / 1e-30
            if not np.isfinite(matrix).all():
                return None
            inverse = np.linalg.pinv(matrix.T)
            for _ in range(30):
                step = inverse @ self.rest(v, lam)
                v = v - step
                if not np.abs(step).max() < 1:
                    return None
                if np.abs(step).max() < 1e-11 * np.abs(v).max():
                    return v
        return None

    def follow(self, lam, steps):
        """(ω, x) at λ, or None."""
        size = lam / steps
        before, tangent = self.start
        v = before + size * tangent
        for k in range(1, steps + 1):
            found = self.newton(v, k * size)
            if found is None or np.abs(found - v).max() > 0.05 * np.abs(found).max():
                return None
            v, before = 2 * found - before, found
        return before


def random_problem(random):
    """(texts, unknowns or None for a forced one, left sides, first tangent)."""
    def number():
        return sp.Rational(int(random.integers(-6, 7)), int(random.integers(1, 6)))
    x, xp, xpp, y, ypp, lam, t = sp.symbols("x_0 x_1 x_2 y_0 y_2 lam t")
    kind = random.integers(0, 5)
    c = sp.Rational(int(random.integers(1, 7)), int(random.integers(1, 4)))
    nonlinear = sum(number() * x**int(k) for k in random.choice([2, 3, 4, 5], 2, replace=False))
    if kind == 1:
        nonlinear += number() * x * xp**2 + number() * lam * x
    if kind == 2:
        nonlinear = c * x * (sp.exp(-xp**2) - 1) + number() * x**3
    left = [xpp + c * x + nonlinear]
    free = bool(kind != 3)
    if not free:
        left[0] -= lam * (number() + sp.cos(t))
    if kind == 4:
        d = c * sp.Rational(int(random.integers(5, 8)), 3)
        left = [left[0] + number() * x * y / 3, ypp + d * y + number() * x**2 / 2 + number() * y**2]
    return left, free, c


def declared(left, free):
    text = [re.sub(r"_(\d)", lambda order: "'" * int(order[1]), str(side)) for side in left]
    unknowns = {"x": fts.Field("cos", fixed=(1,) if free else ())}
    if len(left) > 1:
        unknowns["y"] = fts.Field("cos")
    if free:
        return fts.Equations(text, unknowns=unknowns | {"omega": fts.Scalar()}, frequency="omega",
                             choice=0 if len(left) > 1 else None)
    return fts.Equations(text, unknowns=unknowns)


def rows(random):
    """(outcome, text, order, λ, seconds) for one random problem."""
    left, free, c = random_problem(random)
    try:
        whole = fts.solve(declared(left, free), max(ORDERS), "float", progress=False)
    except fts.FTSeriesError:
        return
    family = Family(left, free)
    family.start = np.zeros((2, family.fields * (MODES + 1) + free))    # λ = 0, and the tangent
    for i, name in enumerate(("x", "y")[:family.fields]):
        for (_, n), column in whole._table(name, ()).items():
            if n <= 1:
                family.start[:, i * (MODES + 1) + n] = column[:2]
    if free:
        family.start[:, -1] = whole._table("omega", ())[0, 0][:2]
    for lam in np.exp(random.uniform(np.log(0.2), np.log(4), 3)).round(4):
        truth = family.follow(lam, 100)
        again = None if truth is None else family.follow(lam, 200)
        if again is None or np.abs(truth - again).max() > 1e-6 * np.abs(
                truth).max() or np.abs(truth[:MODES + 1][-3:]).max() > 1e-7:
            continue
        for order in ORDERS:
            begin = time.process_time()
            with warnings.catch_warnings(record=True) as said:
                warnings.simplefilter("always")
                try:
                    orbit = whole.truncate(order).refine(lam)
                except fts.FTSeriesError:
                    outcome = "refused"
                else:
                    off = max(abs(orbit.coefficients["x"].get((0, n), 0.0) - truth[n])
                              for n in range(MODES))
                    if free:
                        off = max(off, abs(orbit.evaluate("omega") - truth[-1]))
                    right = off < 1e-4 * np.abs(truth).max()
                    outcome = "right" if right else "wrong"
            yield (outcome + ", warned" * bool(said), str(left), order, float(lam),
                   time.process_time() - begin)


def main(number=100, seed=1):
    count, slow = Counter(), []
    for k in range(int(number)):
        for outcome, text, order, lam, seconds in rows(np.random.default_rng([int(seed), k])):
            count[outcome] += 1
            slow.append(seconds)
            if outcome == "wrong":
                print(outcome, text, order, lam, flush=True)
    print(dict(count))
    print(f"median {np.median(slow):.3f} s, mean {np.mean(slow):.3f} s, most "
          f"{max(slow):.2f} s")


if __name__ == "__main__":
    main(*sys.argv[1:])
