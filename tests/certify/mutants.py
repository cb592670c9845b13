"""Certificates with one entry altered and a fresh checksum: none may state what is not true.

``make certificates`` tries all of them and says what became of them; the tests try a
sample.  What a checker accepts is held against values that no proof has touched: the 1000 stored
digits of the eight, Hill's matrix and elliptic functions in many digits, exact coefficients.
"""

import copy
import json
import random
import sys
import tempfile
import time
from base64 import b64decode
from collections import Counter
from functools import cache
from pathlib import Path

import mpmath
from flint import arb, fmpq, fmpz

import ftseries as fts
from ftseries import certify
from ftseries.arguments import rational
from ftseries.certify import NotProved, certificate, check
from ftseries.errors import FileError
from ftseries.precision import working
from ftseries.references import cubic, mathieu

LIMIT = 20                                  # seconds of one processor for one check
BITS, DIGITS = 400, 50


@cache
def certificates():
    """One of each kind, and of some two, by name."""
    series = fts.solve(fts.FigureEight(), 60, "float")
    orbit = fts.solve(fts.FigureEight(), 6).refine()
    theorems = {
        "cubic": certify.cubic_bound(1, "1/2", 8), "cubic, a = 3": certify.cubic_bound(3, 1, 4),
        "eigenvalue": certify.mathieu_eigenvalue(2, "-0.3", digits=20),
        "eigenvalue, λ = 1/2": certify.mathieu_eigenvalue("1/2", 1, digits=8),
        "eight": certify.prove_eight(orbit, modes=30, nu="1.001"),
        "convergence": certify.prove_convergence(series, lam=1, modes=20),
        "digits": certify.digits(12)}
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "theorem.json"
        found = {}
        for name, theorem in theorems.items():
            theorem.save(path)
            found[name] = certificate.read(path)
    return found


def mutants(data):
    """(path, value) of every altered entry."""
    for path, value in places(data):
        for other in hostile(value, data):
            if type(other) is not type(value) or other != value:
                yield path, other


def places(value, path=()):
    """Every entry, of long lists the first two and the last."""
    if path:
        yield path, value
    if isinstance(value, dict):
        for key in value:
            if key not in ("format", "version"):
                yield from places(value[key], (*path, key))
    elif isinstance(value, list):
        for i in sorted({0, 1, len(value) - 1} & set(range(len(value)))):
            yield from places(value[i], (*path, i))


def hostile(value, data):
    """What somebody may put in place of a value."""
    yield from (None, True, False, 0, -1, 1.5, "", "0", "1", "-1", [], {}, [value], "nan", "1/0")
    if isinstance(value, int):
        yield from (-value, value + 1, value - 1, 2 * value, float(value), str(value), 10**6,
                    2**70, -2**70, 10**400)
    elif isinstance(value, str):
        yield from ("-" + value, "--" + value, "+" + value, "0" + value, " " + value, value + " ",
                    value + "\n", value + "e0", value + "E1", value + "_0", value + ".0",
                    value + " +/- 1", value.replace(" ", "  "), value.replace("1", "١"),
                    value.replace(".", ","), value.lstrip("-"), value[:-1], value[1:],
                    value + "0", value + "1", "9" * 60000, "1" * 5000, "1/" + "7" * 3000,
                    "1e99999999", "0x10", "inf", "-0", "2/4", "1/3", "7/10", "0.7", "2.0", "1.0005",
                    "0 1", "2 0", "1 0", "-1 0", "-0 0", "1 -9", "1 -99999", "-1 -99999",
                    "1 999999", "1 -999999", "3 99999999999", "1 -40", "-1 40")
        if " " in value and len(value) < 10000:
            m, e = value.split(" ")[:2]
            if e.lstrip("-").isdigit():
                yield from (f"{m} {int(e) + 1}", f"{m} {int(e) - 1}", f"{int(m) + 2} {e}",
                            f"{int(m) - 2} {e}", f"{2 * int(m)} {int(e) - 1}", f"{-int(m)} {e}")
        yield from (other for other in data.values() if isinstance(other, str))
    elif isinstance(value, list):
        yield from (value[:-1], value[1:], value + value[-1:], value[::-1], value[:1] * 20000,
                    value[:1] * len(value), value + [value], [[]] * len(value))
        if value and isinstance(value[0], int):
            yield from ([10**6, *value[1:]], [-value[0], *value[1:]], [float(value[0]), *value[1:]])
    elif isinstance(value, dict):
        yield {**value, "note": "and so is everything else"}
        for key in value:
            yield {k: v for k, v in value.items() if k != key}


def altered(data, path, value):
    data = copy.deepcopy(data)
    place = data
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value
    return data


def outcome(data, file):
    """"refused", or what the checker says is proved."""
    try:
        certificate.write(file, data)
        return check(file)
    except (FileError, NotProved):
        return "refused"


# --- whether a certificate states the truth

def true(data):
    """Nothing that the certificate claims contradicts what is known without any proof."""
    with working(bits=BITS, digits=DIGITS):
        return TRUTH[data["theorem"]](data)


def number(text):
    return certificate.number(text)


def from_mpmath(x):
    return arb(mpmath.nstr(x, DIGITS), 0) + arb(0, abs(arb(mpmath.nstr(x, 10))) * arb(10)**-45)


@cache
def eigenvalues(*parameters):
    lam, mu = (mpmath.mpf(int(x.p)) / int(x.q) for x in map(rational, parameters))
    return [mathieu.eigenvalue(lam, mu, index, dps=DIGITS) for index in (0, 1)]


def true_eigenvalue(data):
    low, second = eigenvalues(data["lam"], data["mu"])
    return (certificate.read_ball(data["a"]).overlaps(from_mpmath(low))
            and number(data["beta"]) <= from_mpmath(second))


@cache
def oscillator():
    return fts.solve(fts.CubicOscillator(), 12)


def true_bound(data):
    a, lam, order = rational(data["a"]), rational(data["lam"]), data["order"]
    if not 0 < lam < 3 * a:
        return False
    series = oscillator().truncate(order)
    modes = [fmpq(0)] * (order + 1)
    for m, row in enumerate(series.coefficients["x"]):
        for (_, n), c in row.items():
            modes[n] += rational(c) * (lam / a)**m
    if [rational(c) for c in data["modes"]] != modes:
        return False
    at = mpmath.mpf(int((lam / a).p)) / int((lam / a).q)
    error = abs(from_mpmath(cubic.frequency(at, dps=DIGITS))**2 - arb(rational(data["square"])))
    for n in range(order + 12):
        mode = arb(modes[n]) if n <= order else arb(0)
        error += abs(from_mpmath(cubic.fourier_coefficient(n, at, dps=DIGITS)) - mode)
    return bool(error.lower() <= number(data["radius"]))


@cache
def eight():
    return certify.thousand_digits()


@cache
def true_coefficients():
    with working(bits=3500):
        return {n: eight().unknown(n) for n in eight().unknowns}


@cache
def true_state():
    return [part for name in ("positions", "velocities") for z in getattr(eight(), name)
            for part in (z.real, z.imag)]


def true_eight(data):
    nu, best, mine = arb(data["nu"]), true_coefficients(), dict(data["center"])
    gap = sum((abs(best.get(n, arb(0)) - number(mine.get(n, "0 0"))) * nu**n
               for n in best.keys() | mine.keys()), arb(0))
    claims = [claim for name in ("positions", "velocities") for z in data[name] for claim in z]
    return (gap.lower() <= number(data["radius"]) and number(data["uniqueness"]) <= 2**-20
            and certificate.read_ball(data["lam"]).overlaps(eight().lam)
            and all(certificate.read_ball(claim).overlaps(part)
                    for claim, part in zip(claims, true_state())))


def true_digits(data):
    n = data["digits"]
    known = {name: text[:text.index(".") + 1 + n] for name, text in eight().decimals().items()}
    best, words = true_coefficients(), data["unknowns"].split(" ")
    index = [k for k in range(1, 2 * len(words)) if k % 3]
    mine = {k: arb(fmpz(int.from_bytes(b64decode(w), "big", signed=True)))
            * arb(2)**-data["bits"] for k, w in zip(index, words)}
    gap = sum((abs(best[k] - mine[k]) for k in mine), arb(0))
    return (data["decimals"] == known and gap.lower() <= number(data["distance"])
            and certificate.read_ball(data["lam"]).overlaps(eight().lam)
            and true_eight(data["eight"]))


@cache
def exact_series():
    return fts.solve(fts.FigureEight(), 40)


def true_convergence(data):
    """The disc is inside the known radius, and no partial sum is above the claimed sums."""
    kappa = arb(data["lam"])
    sums = {name: sum((abs(arb(rational(c))) * kappa**m
                       for m, row in enumerate(exact_series().coefficients[name])
                       for c in row.values()), arb(0)) for name in ("r", "phi")}
    sums["r"] *= arb(3).root(3)
    return (kappa < arb("2.2095") and number(data["uniqueness"]) <= 2**-16
            and 0 <= number(data["radius"]) < number(data["uniqueness"])
            and all(sums[name].lower() <= number(data["norms"][name]) for name in sums))


TRUTH = {"Mathieu eigenvalue": true_eigenvalue, "cubic oscillator": true_bound,
         "figure eight": true_eight, "figure eight, digits": true_digits,
         "convergence": true_convergence}


def tried(name, chosen, file):
    """(path, "refused" | "accepted" | "wrong" | "slow", seconds) for these mutants of one."""
    for path, value in chosen:
        data, start = altered(certificates()[name], path, value), time.process_time()
        said = outcome(data, file)
        spent = time.process_time() - start
        if said != "refused":
            said = "accepted" if true(data) else "wrong"
        yield path, value, "slow" if spent > LIMIT else said, spent


def sample(name, count, seed=0):
    """Mutants of one certificate, some of every entry."""
    every = list(mutants(certificates()[name]))
    return random.Random(seed).sample(every, min(count, len(every)))


def main(*names):
    total, accepted, longest = Counter(), Counter(), 0.0
    with tempfile.TemporaryDirectory() as folder:
        for name, data in certificates().items():
            if names and name not in names:
                continue
            counts = Counter()
            for path, value, said, spent in tried(name, mutants(data), Path(folder) / "x.json"):
                counts[said] += 1
                longest = max(longest, spent)
                if said == "accepted":
                    accepted[name, path[0] if path[0] != "eight" else path[:2]] += 1
                elif said != "refused":
                    print(f"{name} {path}: {json.dumps(value)[:60]} {said} ({spent:.1f} s)")
            print(f"{name}: {dict(counts)}", flush=True)
            total += counts
    print(f"all: {dict(total)}; longest check {longest:.1f} s\naccepted and true, by entry:")
    for (name, entry), count in accepted.items():
        print(f"  {name}, {entry}: {count}")
    return total["wrong"] + total["slow"]


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
