r"""Problems from SymPy equations or from text.

Formula.  Each equation becomes left side minus right side, is read by :mod:`ftseries.reading` and
built from series by :mod:`ftseries.translate`.  The seed of a field is a sum of terms
c λ^m cos nωt and c λ^m sin nωt, that of a scalar a sum of c λ^m; an irrational leading c becomes
the unit in which the unknown or λ is measured (:mod:`ftseries.seeds`).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from .aliases import Expr, Function, Json, Mode
from .arguments import decimal, whole
from .errors import InputError, NonAnalyticError
from .expansion import Expansion
from .expressions import by_name, expression, name_of, quoted
from .first_steps import first_steps
from .laurent import PolynomialRing, SurdRing
from .problem import Field, Problem, Scalar
from .reading import Language
from .seeds import measured, ratio, read, units
from .translate import LAM, Translator, harmonic, lead

__all__ = ["Equations"]


class Equations(Problem):
    """A problem written as equations.

    Parameters
    ----------
    equations : SymPy Eq or expression, text, or a list or dict of them
        An expression means expression = 0.  In a text, ``x''`` is the second time derivative of the
        field x, a bare ``x`` means x(t), and ``=`` separates the sides.  A text has at most 10,000
        characters and 1000 names and numbers, exponents go up to 100, and so on, as
        :mod:`ftseries.expressions` lists; for SymPy the same bounds hold.
    unknowns : dict
        SymPy function (or its name) to :class:`Field`, SymPy symbol (or name) to :class:`Scalar`.
        A name is any identifier of Python, also θ or ω, normalized as Python does it (NFKC).
    seed : dict, optional
        Unknown to its first terms, such as ``lam*cos(omega*t)``; left out, the first steps are
        solved automatically: about states of rest that are roots of polynomials of few terms, such
        as x² - 2 or x³ - 3, and where the equations are not polynomial about rest at 0.  A motion
        about another state of rest needs a seed.  With a parameter of the equations among the
        unknowns, the motion is found that is born as rest becomes unstable (Hopf bifurcation).
    frequency : symbol or name, optional
        The unknown scalar ω with τ = ωt; left out, the period is 2π.
    parameters : tuple of symbols or names, or dict from them to values
        Without a value (or with None) a parameter is carried as a symbol, and the coefficients are
        polynomials in it.  Each of them has to occur in the equations.
    time, lam : symbol or name
        t and λ; in texts λ itself may be written too, unless something else is called so.
    choice : int, optional
        Which solution of the first steps to take, where there are several; the refusal without it
        shows them.
    ahead : int
        How far Fourier orders may run ahead of Taylor orders: n ≤ m + ahead.

    Raises
    ------
    InputError, NonAnalyticError
        What cannot be read, or has no Fourier-Taylor series; the message quotes it.

    Examples
    --------
    The oscillator of Duffing, λ the amplitude of cos ωt:

    >>> import ftseries as fts
    >>> duffing = fts.Equations("x'' + x + x**3 = 0", frequency="omega", unknowns={
    ...     "x": fts.Field("cos", modes="odd", fixed=(1,)), "omega": fts.Scalar()})
    >>> duffing.seed_texts
    {'x': 'lam*cos(omega*t)', 'omega': '1'}
    >>> sol = fts.solve(duffing, order=6)
    >>> sol.coefficient("omega", 2), sol.coefficient("x", 3, 3)
    (3/8, 1/32)
    """

    def __init__(self, equations: Any, unknowns: Mapping[Any, Any],
                 seed: Mapping[Any, Any] | None = None, frequency: Any = None, parameters: Any = (),
                 time: Any = "t", lam: Any = "lam", choice: int | None = None,
                 ahead: int = 0) -> None:
        if not isinstance(unknowns, dict):
            raise InputError(f"unknowns={unknowns!r}: give a dict from each unknown to its Field "
                             "or Scalar")
        self.unknowns = {name: _declared(name, u) for name, u in by_name(unknowns).items()}
        if not isinstance(parameters, (dict, tuple, list)):
            raise InputError(f"parameters={parameters!r}: give a tuple of names, such as ('mu',), "
                             "or a dict with values, such as {'mu': 2}")
        values = by_name(parameters if isinstance(parameters, dict)
                         else {key: None for key in parameters})
        self.parameters = tuple(name for name, value in values.items() if value is None)
        self.frequency = None if frequency is None else name_of(frequency)
        self.variable, self.ahead = name_of(time), whole("ahead", ahead)
        self.check()
        fields = [name for name, u in self.unknowns.items() if isinstance(u, Field)]
        self.language = Language(
            self.variable, name_of(lam), tuple(fields), tuple(set(self.unknowns) - set(fields)),
            self.parameters, {k: _value(k, v) for k, v in values.items() if v is not None})
        if not isinstance(equations, dict):
            equations = equations if isinstance(equations, (list, tuple)) else [equations]
            equations = {f"({i})": e for i, e in enumerate(equations, 1)}
        self.expressions = {n: self.language.equation(e) for n, e in equations.items()}
        self._check_count(fields)
        if seed is not None and choice is not None:
            raise InputError(f"choice={choice!r} selects one of the first steps that are solved "
                             "automatically; leave it out where a seed is given")
        self.scales: dict[str, Expr] = {}
        self._translate()
        self._check_lead()
        self._begin(self._choose(first_steps(self), choice) if seed is None else seed)
        self._check_analytic()

    def equations(  # type: ignore[override]     # an unknown may be called lam or self
            self, lam: Function, /, **unknowns: Function) -> dict[str, Function]:
        env = {LAM: lam, **unknowns}
        return {name: build(env) for name, build in self._residuals.items()}

    def scale(self, name: str) -> Expr:
        return self.scales.get(name, sp.S.One)

    def arguments(self) -> dict[str, Json]:
        plain_values = {name: vars(u) | {"kind": type(u).__name__} for name, u in
                        self.unknowns.items()}
        for values in plain_values.values():
            if "fixed" in values:
                values["fixed"] = [list(m) if isinstance(m, tuple) else m for m in values["fixed"]]
        return {"equations": self._texts(), "unknowns": plain_values, "seed": self.seed_texts,
                "frequency": self.frequency, "parameters": list(self.parameters),
                "time": self.variable, "lam": self.language.lam, "ahead": self.ahead}

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self.arguments(),)

    def __repr__(self) -> str:
        return f"Equations({'; '.join(f'{text} = 0' for text in self._texts().values())})"

    @property
    def delicate(self) -> list[str]:
        """The powers, exp, sin and cos of the equations that may not be analytic at λ = 0."""
        return [self.language.written(e) for _, e, _ in self._translator.delicate]

    @property
    def forcing(self) -> set[Mode]:
        """The modes (sine, n) of the known functions in the equations."""
        omega = sp.Symbol(self.frequency) if self.frequency else sp.S.One
        waves = {(w, harmonic(w, sp.Symbol(self.variable), omega))
                 for e in self.expressions.values() for w in e.atoms(sp.sin, sp.cos)}
        return {(int(isinstance(w, sp.sin)), n) for w, n in waves if n}

    def _texts(self) -> dict[str, str]:
        return {name: self.language.written(e) for name, e in self.expressions.items()}

    def _translate(self) -> None:
        self._translator = Translator(self, self.language, self.scales, self.lam_scale)
        self._residuals = {n: self._translator.residual(e, n) for n, e in self.expressions.items()}
        self.surd = self._translator.surd

    # --- what is refused --------------------------------------------------------------------

    def _check_count(self, fields: list[str]) -> None:
        number, total = len(self.expressions), len(self.unknowns)
        if not len(fields) <= number <= total:
            raise InputError(f"equations: {number}, fields: {len(fields)} "
                             f"({', '.join(fields)}), scalars: {total - len(fields)}; give one "
                             "equation for each field, and at most one more for each scalar")
        mentioned = set().union(*(
            {s.name for s in e.free_symbols} | {f.func.__name__ for f in
                                                e.atoms(sp.core.function.AppliedUndef)}
            for e in self.expressions.values()))
        silent = [n for n in self.unknowns if n not in mentioned and n != self.frequency]
        if silent:
            raise InputError(f"no equation contains {', '.join(silent)}; correct the equations or "
                             "leave that unknown out")
        language = self.language
        idle = [name for name in (*self.parameters, *language.values)
                if name not in mentioned | language.used]
        if idle:
            raise InputError(f"no equation contains the parameter {', '.join(idle)}; correct the "
                             "equations or leave it out")

    def _check_lead(self) -> None:
        for where, e in self.expressions.items():
            for term in sp.Add.make_args(sp.expand(e)):
                excess = lead(term, self, self.language)
                if excess > self.ahead:
                    lam = self.language.lam
                    raise InputError(
                        f"equation {where}: the term {self.language.written(term)} brings a "
                        f"Fourier order n before the power {lam}**n, which n ≤ m + {self.ahead} "
                        f"leaves out; put a power of {lam} in front, or give a larger ahead")

    def _check_analytic(self) -> None:
        """Evaluate every power, exp, sin and cos at λ = 0 on the seed."""
        ring = (SurdRing if self.surd else PolynomialRing)(self.parameters)
        expansion = Expansion(ring)
        env: dict[str, Function] = {LAM: expansion.lam}
        for name, rows in self.first_coefficients().items():
            env[name] = expansion.unknown()
            env[name].set(0, ring.from_modes({k: ring.number(v) for k, v in rows[0].items()}))
        for where, e, build in self._translator.delicate:
            try:
                build(env)[0]
            except (NonAnalyticError, InputError) as error:
                raise type(error)(f"equation {where}, in {self.language.written(e)}: {error}") \
                    from None

    # --- the seed ----------------------------------------------------------------------------

    def _begin(self, seed: Any) -> None:
        """Set ``seed``, ``scales`` and ``lam_scale`` so that the equations become rational."""
        self.seed_texts, terms = read(self, seed)
        refusals = []
        for unit in units(terms):
            try:
                self.seed, self.scales = measured(self, terms, unit)
                self.lam_scale = unit
                self._translate()
                return
            except InputError as error:
                refusals.append(error)
        raise refusals[0]

    def _choose(self, seeds: list[dict[str, Expr]], choice: int | None) -> dict[str, Expr]:
        """One of the first steps; refuses those whose coefficients are rational in no units."""
        if choice is not None and choice not in range(len(seeds)):
            raise InputError(f"choice={choice!r}: the number of solutions of the first steps is "
                             f"{len(seeds)}, counted from 0")
        if choice is not None or len(seeds) == 1:
            seed = seeds[choice or 0]
            why = self._hindrance(seed)
            if why:
                raise InputError(f"the motion {_shown(seed)} has no series with rational "
                                 f"coefficients, because {why}")
            return seed
        hindrances = [self._hindrance(seed) for seed in seeds]
        offers = "; ".join(f"choice={i}: {_shown(seed)}"
                           + " (with irrational coefficients)" * bool(why)
                           for i, (seed, why) in enumerate(zip(seeds, hindrances, strict=True)))
        if all(hindrances):
            raise InputError(f"the first steps have {len(seeds)} solutions, none of which leads to "
                             f"rational coefficients ({offers}), because {hindrances[0]}")
        raise InputError(f"the first steps have {len(seeds)} solutions, select one of them: "
                         f"{offers}")

    def _hindrance(self, seed: dict[str, Expr]) -> str | None:
        try:
            self._begin(seed)
        except InputError as error:
            pair = ratio(read(self, seed)[1])
            if pair is None:
                return str(error)
            return (f"the ratio of the amplitudes of {pair[0]} and {pair[1]}, {pair[2]}, is "
                    "irrational; take normal coordinates as unknowns, or change a number in the "
                    "equations so that the ratio becomes rational")
        return None


def _again(arguments: dict[str, Json]) -> Equations:
    return Equations(**arguments)


def _declared(key: str, unknown: Any) -> Field | Scalar:
    """A Field or Scalar, also from its JSON form."""
    if isinstance(unknown, dict) and unknown.get("kind") in ("Field", "Scalar"):
        values = {k: v for k, v in unknown.items() if k != "kind"}
        if "fixed" in values:
            values["fixed"] = tuple(tuple(m) if isinstance(m, list) else m for m in values["fixed"])
        return Field(**values) if unknown["kind"] == "Field" else Scalar(**values)
    if isinstance(unknown, (Field, Scalar)):
        return unknown
    raise InputError(f"the unknown {key} is {unknown!r}; declare it as a Field or a Scalar")


def _value(name: str, value: Any) -> Expr:
    try:
        number = decimal(expression(value) if isinstance(value, str) else value)
    except InputError as error:
        raise InputError(f"the parameter {name} has the value {quoted(value)}, which is not a "
                         f"rational number; give an int, a Fraction or a float ({error})") from None
    return sp.Rational(int(number.p), int(number.q))


def _shown(seed: dict[str, Expr]) -> str:
    return ", ".join(f"{name} = {value}" for name, value in seed.items())
