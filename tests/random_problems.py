"""Random problems, and a verifier that shares nothing with the package.

    python -m random_problems 2000          (with tests/ on the path; ``make random N=2000``)

A problem is made from its number alone.  Its solution is asked for coefficients only.  They are
summed here at complex λ on a circle and put into the equations as text, which Python evaluates; the
Taylor coefficients of what is left, by a Fourier transform in λ, have to vanish up to the order.
Floats and balls are held against the exact numbers, and where there are as many equations as fields
one period is integrated.
"""

from __future__ import annotations

import random
import re
import signal
import sys
import time
import traceback
import warnings
from collections import Counter, defaultdict
from dataclasses import dataclass, field
from fractions import Fraction

import numpy as np
import sympy as sp
from flint import arb, ctx
from scipy.integrate import solve_ivp

import ftseries as fts
from ftseries import Field, Scalar

#: the circle in λ, if coefficients do not grow, its points, and some phases no symmetry maps on one
#: another
RADIUS, POINTS, PHASES = 0.2, 64, np.array([0.3, 1.1, 2.6, 3.9, 5.2])
#: rounding of the terms over RADIUS^order, for orders up to 10: 1e-16 · 10⁷, with a margin; of what
#: coefficients of their growth allow at the order
LEFT = 1e-7
#: λ of the integration, and what truncation and the integration itself may leave
LAM, GAP = 0.03, 1e-6


@dataclass
class Case:
    """A problem as text, and what it takes to declare it."""

    kind: str
    equations: list[str]
    unknowns: dict
    seed: dict | None
    order: int
    frequency: str | None = "omega"
    parameters: dict = field(default_factory=dict)
    ahead: int = 0
    #: (name, order of its derivative) of the fields that can be integrated; the sign of the delay
    motion: list | None = None

    def problem(self):
        if self.kind == "delay":
            return delayed(self)
        values = {k: v for k, v in self.parameters.items() if v != "symbol"}
        return fts.Equations(self.equations, unknowns=self.unknowns, frequency=self.frequency,
                             seed=self.seed, parameters=values or tuple(self.parameters),
                             ahead=self.ahead)


def delayed(case):
    """A problem with shifts by a part of the period, which has no form as text."""
    class Delayed(fts.Problem):
        unknowns, frequency, ahead = case.unknowns, case.frequency, case.ahead
        seed = {"x": [{}, {1: 1}], "omega": [1]}
        surd = True

        def equations(self, lam, x, omega):
            names = {"lam": lam, "x": x, "x_1": omega * x.diff(), "x_2": omega**2 * x.diff(2),
                     "omega": omega, "Q": Fraction,
                     "delayed": lambda u, q: u.shift(Fraction(1, q))}
            return {"(D)": eval(python(case.equations[0]), names)}
    fts.Problem.classes.pop("Delayed", None)
    return Delayed()


def python(equation):
    """Left side minus right side, with x'' written x_2 and fractions for quotients of integers."""
    left, _, right = equation.partition("=")
    text = f"({left}) - ({right or 0})"
    text = re.sub(r"([a-z])''", r"\1_2", text)
    text = re.sub(r"([a-z])'", r"\1_1", text)
    return re.sub(r"(?<![\w*.])(\d+)/(\d+)(?![\w.]|\*\*)", r"Q(\1, \2)", text)


# --- the kinds ---------------------------------------------------------------------------------

def make(number):
    """The case with this number."""
    rng = random.Random(number)
    kinds = list(KINDS)
    kind = kinds[number % len(kinds)]
    return KINDS[kind](rng, kind)


def q(rng, signed=True):
    """A small rational, not zero."""
    value = Fraction(rng.randint(1, 5), rng.randint(1, 4))
    return f"({-value if signed and rng.random() < 0.4 else value})"


def order(rng):
    return rng.choice([5, 6, 7, 8, 9, 10])


def oscillator(rng, kind, force, **more):
    unknowns = {"x": Field("cos", fixed=(1,)), "omega": Scalar()}
    seed = {"x": "lam*cos(omega*t)", "omega": "1"} if rng.random() < 0.8 else None
    return Case(kind, [f"x'' + x + {force} = 0"], unknowns, seed, order(rng), motion=[("x", 2)],
                **more)


def polynomial(rng, kind):
    terms = [f"{q(rng)}*x**{rng.randint(2, 5)}" for _ in range(rng.randint(1, 3))]
    if rng.random() < 0.4:
        terms.append(f"{q(rng)}*x'**2" + rng.choice(["", "*x"]))
    if rng.random() < 0.4:
        terms.append(f"{q(rng)}*lam**{rng.randint(1, 2)}*x")
    return oscillator(rng, kind, " + ".join(terms))


def rational(rng, kind):
    force = rng.choice([f"{q(rng)}*x**2/(1 + {q(rng)}*x)", "1 - 1/(1 + x) - x",
                        f"x/sqrt(1 + {q(rng, False)}*x**2) - x", f"{q(rng)}*x**3/(1 + x**2)",
                        f"{q(rng)}*x**2*(4 + x)**(1/2)", f"x*(1 + {q(rng)}*x)**(-3/2) - x"])
    return oscillator(rng, kind, force)


def transcendental(rng, kind):
    a = q(rng)
    force = rng.choice([f"sin({a}*x)/{a} - x", "exp(x) - 1 - x", f"{q(rng)}*(1 - cos(x))",
                        f"{q(rng)}*x*sin(x)", f"{q(rng)}*x**2*exp({a}*x)", f"{a}*sin(x)**2"])
    return oscillator(rng, kind, force)


def planar(rng, kind):
    """Hamilton's equations of (x² + y²)/2 + a x³ + b x y² + c y⁴, even in y."""
    a, b, c = (q(rng) for _ in range(3))
    unknowns = {"x": Field("cos", fixed=(1,)), "y": Field("sin"), "omega": Scalar()}
    seed = {"x": "lam*cos(omega*t)", "y": "-lam*sin(omega*t)", "omega": "1"}
    return Case(kind, [f"x' - y - 2*{b}*x*y - 4*{c}*y**3 = 0",
                       f"y' + x + 3*{a}*x**2 + {b}*y**2 = 0"], unknowns, seed, order(rng),
                motion=[("x", 1), ("y", 1)])


def coupled(rng, kind):
    """Two springs with frequencies 1 and √c, the potential a x²y + b x²y² + d x⁴."""
    a, b, d, c = q(rng), q(rng), q(rng), rng.choice(["5", "3", "7/2", "2/3"])
    unknowns = {"x": Field("cos", fixed=(1,)), "y": Field("cos"), "omega": Scalar()}
    seed = {"x": "lam*cos(omega*t)", "y": "0", "omega": "1"}
    return Case(kind, [f"x'' + x + 2*{a}*x*y + 2*{b}*x*y**2 + 4*{d}*x**3 = 0",
                       f"y'' + {c}*y + {a}*x**2 + 2*{b}*x**2*y = 0"], unknowns, seed, order(rng),
                motion=[("x", 2), ("y", 2)])


def forced(rng, kind):
    damping = rng.choice(["", f" + {q(rng, False)}*x'"])
    n = rng.choice([1, 2])
    text = f"x''{damping} + {rng.choice(['3', '1/2', '7/3'])}*x + {q(rng)}*x**{rng.choice([2, 3])}"
    return Case(kind, [f"{text} = lam*{rng.choice(['cos', 'sin'])}({n}*t)"],
                {"x": Field("both")}, {"x": "0"}, order(rng), None, ahead=10 * (n - 1),
                motion=[("x", 2)])


def cycle(rng, kind):
    extra = rng.choice(["", f" + {q(rng)}*x**3", f" + {q(rng)}*x'**3", f" + {q(rng)}*x**2*x'"])
    strength = rng.choice(["lam**2 - x**2", "lam**2 - x**2 + x**4"])
    unknowns = {"x": Field("both", modes="odd", powers="odd", fixed=((1, 1),)),
                "omega": Scalar("even")}
    seed = {"x": "2*lam*cos(omega*t)", "omega": "1"} if "x'" not in extra else None
    return Case(kind, [f"x'' + x{extra} = ({strength})*x'"], unknowns, seed, order(rng),
                motion=[("x", 2)])


def weak(rng, kind):
    """A factor λ² or λ⁴ in front of the damping: the amplitude is settled late."""
    k = rng.choice([1, 2, 2, 3, 4])
    extra = rng.choice(["x**3", "x**3 + x**5", "sin(x) - x", f"{q(rng)}*x**3"])
    unknowns = {"x": Field("both", modes="odd", powers="odd", fixed=((1, 1),)),
                "omega": Scalar("even")}
    k += k % 2
    return Case(kind, [f"x'' + x + {extra} = lam**{k}*(lam**2 - x**2)*x'"], unknowns,
                {"x": "2*lam*cos(omega*t)", "omega": "1"}, order(rng), motion=[("x", 2)])


def hill(rng, kind):
    unknowns = {"x": Field("cos", fixed=(1,)), "a": Scalar()}
    waves = " + ".join(f"{q(rng)}*lam**{n}*cos({n}*t)" for n in rng.sample([2, 4, 6], 2))
    return Case(kind, [f"x'' + (a + {waves})*x = 0"], unknowns, {"x": "cos(t)", "a": "1"},
                order(rng), None, ahead=1)


def with_parameter(rng, kind):
    case = oscillator(rng, kind, f"mu*x**{rng.choice([2, 3])} + {q(rng)}*x**3")
    case.parameters = {"mu": rng.choice(["symbol", "1/3", "-2"])}
    return case


def energy(rng, kind):
    """The energy as a further unknown, or a field that follows."""
    a = q(rng)
    if rng.random() < 0.5:
        unknowns = {"x": Field("cos", fixed=(1,)), "omega": Scalar(), "E": Scalar()}
        return Case(kind, [f"x'' + x + {a}*x**3 = 0", f"x'**2/2 + x**2/2 + {a}*x**4/4 - E = 0"],
                    unknowns, {"x": "lam*cos(omega*t)", "omega": "1", "E": "0"}, order(rng))
    unknowns = {"x": Field("cos", fixed=(1,)), "y": Field("cos"), "omega": Scalar()}
    return Case(kind, [f"x'' + x + {a}*x**3 = 0", f"y'' + {rng.choice(['5', '1/3'])}*y = x**2"],
                unknowns, {"x": "lam*cos(omega*t)", "y": "0", "omega": "1"}, order(rng),
                motion=[("x", 2), ("y", 2)])


def slow(rng, kind):
    k, m = rng.randint(1, 5), rng.randint(1, 2)
    f = rng.choice([f"{q(rng)}*y**2", f"{q(rng)}*x*y", f"{q(rng)}*x*y**2", f"{q(rng)}*x**2*y",
                    f"{q(rng)}*x**3 + {q(rng)}*y*x", f"{q(rng)}*y**3", f"{q(rng)}*y*x'**2"])
    g = rng.choice([f"{q(rng)}*lam**{m}", f"{q(rng)}*x**2", f"{q(rng)}*lam**{m} + {q(rng)}*x**2",
                    f"{q(rng)}*x**2 + {q(rng)}*y**2", f"{q(rng)}*lam**{m}*(1 + x**2)"])
    unknowns = {"x": Field("cos", fixed=(1,)), "y": Field("cos"), "omega": Scalar()}
    seed = {"x": "lam*cos(omega*t)", "y": "0", "omega": "1"}
    equations = [f"x'' + x + {f} = 0", f"y'' = lam**{k}*({g} - y)"]
    motion = [("x", 2), ("y", 2)]
    if rng.random() < 0.3:
        unknowns["z"], seed["z"] = Field("cos"), "0"
        equations = [f"x'' + x + {f} + {q(rng)}*z*x = 0", equations[1],
                     f"z'' = lam**{rng.randint(1, 3)}*(y**2 - z)"]
        motion.append(("z", 2))
    return Case(kind, equations, unknowns, seed, order(rng), motion=motion)


def slow_damped(rng, kind):
    """y' in place of y'': the slow variable lags behind, and may feed or brake the motion."""
    k = rng.randint(1, 4)
    f = rng.choice([f"{q(rng)}*x*y", f"{q(rng)}*y**2", f"{q(rng)}*x**2*y"])
    g = rng.choice([f"{q(rng)}*lam", f"{q(rng)}*lam**2 + {q(rng)}*lam*y"])
    unknowns = {"x": Field("both", fixed=(1,)), "y": Field("both"), "omega": Scalar()}
    return Case(kind, [f"x'' + x + {f} = 0", f"y' = lam**{k}*({g} - y)"], unknowns,
                {"x": "lam*cos(omega*t)", "y": "0", "omega": "1"}, order(rng),
                motion=[("x", 2), ("y", 1)])


def line(rng, kind):
    """Two equal oscillators; what couples them breaks the exchange of x and y, but not y = x."""
    a, b, n = q(rng), q(rng), rng.randint(1, 3)
    odd = rng.random() < 0.6
    unknowns = {"x": Field("cos", fixed=(1,), **({"modes": "odd", "powers": "odd"} if odd else {})),
                "y": Field("cos", **({"modes": "odd", "powers": "odd"} if odd else {})),
                "omega": Scalar("even" if odd else "all")}
    seed = {"x": "lam*cos(omega*t)", "y": "lam*cos(omega*t)", "omega": "1"}
    square = "x*(x**2 + y**2)" if odd else "x*y"
    mirror = "y*(x**2 + y**2)" if odd else "y*x"
    top = 5 if odd else 4
    n = min(n, top - 1)
    return Case(kind, [f"x'' + x + {a}*{square} + {b}*x**{n}*y**{top - n} = 0",
                       f"y'' + y + {a}*{mirror} + {b}*y**{n}*x**{top - n} = 0"], unknowns, seed,
                order(rng), motion=[("x", 2), ("y", 2)])


def hopf(rng, kind):
    a, b, c = (q(rng) for _ in range(3))
    unknowns = {"x": Field("both", fixed=(1,)), "y": Field("both"), "omega": Scalar(),
                "b": Scalar()}
    seed = {"x": "lam*cos(omega*t)", "y": "lam*sin(omega*t)", "omega": "1", "b": "0"}
    return Case(kind, [f"x' - b*x + y + {a}*x*(x**2 + y**2) + {b}*x**2 = 0",
                       f"y' - x - b*y + {a}*y*(x**2 + y**2) + {c}*x*y = 0"], unknowns, seed,
                rng.choice([5, 6, 7]), motion=[("x", 1), ("y", 1)])


def delay(rng, kind):
    part = rng.choice([2, 3, 4, 6])
    force = rng.choice([f"delayed(x, {part})**2", f"x*delayed(x, {part})",
                        f"x*delayed(x, {part})**2"])
    unknowns = {"x": Field("both", fixed=(1,)), "omega": Scalar()}
    return Case(kind, [f"x'' + x + {q(rng)}*{force} = 0"], unknowns, None, rng.choice([4, 5, 6]))


KINDS = {"polynomial": polynomial, "rational": rational, "transcendental": transcendental,
         "planar": planar, "coupled": coupled, "forced": forced, "cycle": cycle, "weak": weak,
         "hill": hill, "parameter": with_parameter, "energy": energy, "slow": slow,
         "slow damped": slow_damped, "line": line, "hopf": hopf, "delay": delay}


# --- the verifier ------------------------------------------------------------------------------

class Wrong(AssertionError):
    """A solution that does not solve its equations, or disagrees with itself or the motion."""


def solved(case, arithmetic="exact"):
    problem = case.problem()
    symbolic = [name for name, value in case.parameters.items() if value == "symbol"]
    if symbolic and arithmetic != "exact":
        return None
    return fts.solve(problem, case.order, arithmetic, progress=False)


def table(case, solution):
    """``{name: {(sine, n): [c_0, …]}}`` of complex numbers; free parameters count 2/7."""
    result = {}
    for name, unknown in case.unknowns.items():
        rows = {}
        scalar = isinstance(unknown, Scalar)
        sines = [None] if scalar else [False, True] if unknown.series == "both" else [None]
        for sine in sines:
            for n in range(0 if not sine else 1, 1 if scalar else case.order + case.ahead + 1):
                column = []
                for m in range(case.order + 1):
                    index = (m,) if scalar else (n, m)
                    c = solution.coefficient(name, *index, **(
                        {} if sine is None else {"sine": sine}))
                    column.append(complex(sp.sympify(c).subs("mu", sp.Rational(2, 7))
                                          if hasattr(c, "free_symbols") else float(c)))
                key = (int(sine if sine is not None else getattr(unknown, "series", "") == "sin"),
                       n)
                if any(column):
                    rows[key] = column
        result[name] = rows
    return result


def values(case, coefficients, lam, tau):
    """All that an equation may contain, for λ of shape (L, 1) and τ of shape (T,)."""
    names = {"lam": lam, "t": tau, "Q": lambda a, b: a / b, "sin": np.sin, "cos": np.cos,
             "exp": np.exp, "sqrt": np.sqrt}
    for name, value in case.parameters.items():
        names[name] = 2 / 7 if value == "symbol" else float(Fraction(value))
    amplitude = {name: {mode: np.polynomial.polynomial.polyval(lam, column)
                        for mode, column in rows.items()} for name, rows in coefficients.items()}
    omega = amplitude[case.frequency].get((0, 0), 0) if case.frequency else 1.0

    def at(name, times, shift=0.0):
        total = 0j * lam * tau
        for (sine, n), a in amplitude[name].items():
            total = total + a * omega**times * n**times * np.cos(
                n * (tau + shift) + (times - sine) * np.pi / 2)
        return total
    for name, unknown in case.unknowns.items():
        if isinstance(unknown, Scalar):
            names[name] = amplitude[name].get((0, 0), 0) + 0 * tau
        else:
            names |= {name: at(name, 0), name + "_1": at(name, 1), name + "_2": at(name, 2)}
    names["delayed"] = lambda u, q: at("x", 0, 2 * np.pi / q)
    return names


def residual_orders(case, coefficients):
    """The largest Taylor coefficient of each order that the equations leave, over some phases.

    In units of g^k: the coefficients of the unknowns grow like g^m, and the circle is so small that
    their sums are far from where they, or roots and quotients of them, would end.
    """
    growth = max([1.0] + [abs(c)**(1 / m) for rows in coefficients.values()
                          for column in rows.values() for m, c in enumerate(column) if m])
    lam = RADIUS / growth * np.exp(2j * np.pi * np.arange(POINTS) / POINTS)[:, None]
    names = values(case, coefficients, lam, PHASES)
    worst = np.zeros(case.order + 1)
    for equation in case.equations:
        left = eval(python(equation), dict(names)) + 0j * names["lam"] * PHASES
        taylor = np.fft.fft(left, axis=0) / POINTS
        k = np.arange(case.order + 1)
        worst = np.maximum(worst, np.abs(taylor[:case.order + 1]).max(axis=1) / RADIUS**k)
    return worst


def verify(case, solution):
    """Raise :class:`Wrong` where something does not fit."""
    exact = table(case, solution)
    scale = max([1.0] + [abs(c) for rows in exact.values() for column in rows.values()
                         for c in column])
    left = residual_orders(case, exact)
    if not (left < LEFT).all():
        raise Wrong(f"the equations leave {left.max():.1e} at order {int(left.argmax())}")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", fts.PrecisionWarning)
        floats, balls = solved(case, "float"), solved(case, "ball")
    if floats is not None:
        other = table(case, floats)
        for name, rows in exact.items():
            for mode in rows.keys() | other[name].keys():
                for m in range(case.order + 1):
                    a, b = (t[name].get(mode, [0] * (m + 1))[m] for t in (exact, other))
                    if not abs(a - b) < 1e-9 * scale:   # rounding of orders up to 10, hundredfold
                        raise Wrong(f"float: {name} {mode} at order {m} is {b.real}, not {a.real}")
    if balls is not None:
        enclosed(case, solution, balls)
    if case.motion and not any(v == "symbol" for v in case.parameters.values()):
        gap = period(case, exact)
        if not gap < GAP * scale:
            raise Wrong(f"after one period the integrated motion is {gap:.1e} away")


def enclosed(case, solution, balls):
    """Every exact coefficient lies in its ball."""
    with ctx.workprec(2000):
        for name, rows in solution.coefficients.items():
            for m, row in enumerate(rows):
                for mode in row.keys() | balls.coefficients[name][m].keys():
                    ball = arb(balls.coefficients[name][m].get(mode, 0))
                    if not ball.contains(arb(row.get(mode, 0))):
                        raise Wrong(f"ball: {name} {mode} at order {m} is not in {ball}")


def period(case, coefficients):
    """How far the state is from its beginning after one period, by DOP853."""
    lam = np.array([[LAM + 0j]])
    start = values(case, coefficients, lam, np.array([0.0]))
    size = [(name, order) for name, order in case.motion]
    begin = [float(np.real(start[name + f"_{j}" * (j > 0)]).ravel()[0])
             for name, order in size for j in range(order)]
    omega = float(np.real(start[case.frequency]).ravel()[0]) if case.frequency else 1.0
    scalars = {name: float(np.real(v).ravel()[0]) for name, v in start.items()
               if isinstance(case.unknowns.get(name), Scalar)}
    code = [compile(python(e), "equation", "eval") for e in case.equations]
    constants = {"lam": LAM, "Q": lambda a, b: a / b, "sin": np.sin, "cos": np.cos, "exp": np.exp,
                 "sqrt": np.sqrt} | scalars | {
                     name: float(Fraction(v)) for name, v in case.parameters.items()}

    def right(t, state):
        names, i, out = constants | {"t": t}, 0, []
        for name, order in size:
            for j in range(order):
                names[name + f"_{j}" * (j > 0)] = state[i + j]
            names[f"{name}_{order}"] = 0.0              # the equations begin with it, factor 1
            i += order
        i = 0
        for (_, order), equation in zip(size, code):
            out += [*state[i + 1:i + order], -eval(equation, names)]
            i += order
        return out
    run = solve_ivp(right, (0, 2 * np.pi / omega), begin, method="DOP853", rtol=1e-11, atol=1e-13)
    return float(np.abs(run.y[:, -1] - begin).max())


# --- many of them ------------------------------------------------------------------------------

def judged(number):
    """(verdict, case, detail) of one problem: right, refused, WRONG or CRASHED."""
    case = make(number)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            warnings.simplefilter("ignore", fts.PrecisionWarning)
            verify(case, solved(case))
        return "right", case, ""
    except fts.FaultError as error:
        return "WRONG", case, str(error)
    except fts.FTSeriesError as error:
        return "refused", case, f"{type(error).__name__}: {error}"
    except Wrong as error:
        return "WRONG", case, str(error)
    except Exception:
        return "CRASHED", case, traceback.format_exc(limit=-2)


def main(count, first=0, limit=60):
    """Print the table of ``count`` problems from number ``first`` on."""
    def slow(*_):
        raise TimeoutError(f"longer than {limit} s")
    counts, refusals, bad = defaultdict(Counter), {}, []
    for number in range(first, first + count):
        begin = time.process_time()
        signal.signal(signal.SIGALRM, slow)
        signal.alarm(limit)
        verdict, case, detail = judged(number)
        signal.alarm(0)
        counts[case.kind][verdict] += 1
        counts[case.kind]["seconds"] += time.process_time() - begin
        if verdict == "refused":
            template = re.sub(r"-?\d+(/\d+)?(\.\d+)?", "#", detail)[:140]
            refusals.setdefault((case.kind, template), []).append((number, case.equations))
        elif verdict != "right":
            bad.append((number, verdict, case.equations, detail))
    print(f"{'kind':16}{'right':>7}{'refused':>9}{'WRONG':>7}{'CRASHED':>9}{'s':>8}")
    for kind, c in counts.items():
        print(f"{kind:16}{c['right']:7}{c['refused']:9}{c['WRONG']:7}{c['CRASHED']:9}"
              f"{c['seconds']:8.1f}")
    total = sum(counts.values(), Counter())
    print(f"{'all':16}{total['right']:7}{total['refused']:9}{total['WRONG']:7}"
          f"{total['CRASHED']:9}{total['seconds']:8.1f}")
    for (kind, template), numbers in sorted(refusals.items()):
        print(f"refused, {kind}, {len(numbers)} times: {template}\n    such as {numbers[0]}")
    for each in bad:
        print(*each, sep="\n    ")
    return bool(bad)


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
