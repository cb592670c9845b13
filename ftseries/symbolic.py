r"""Problems from SymPy equations or from text.

Formula.  Each equation becomes left side minus right side and is walked once.  With t the time,
τ = ωt and unknowns u(t) = s_u U(τ; λ), ω = s_ω Ω, where the *scales* s are the irrational leading
coefficients of the seed,

====================  ==================================
d^k u/dt^k            ω^k d^k U/dτ^k
u(t + c)              U(τ + ωc), ωc a rational part of 2π
cos nωt, sin nωt      known functions
+ - * / powers        the same, exponents rational
exp, sin, cos         the same, of an argument that vanishes at λ = 0
====================  ==================================

A subexpression is translated to (factor, function): the SymPy number ``factor`` collects the
scales, the function builds the rest from series.  Terms of a sum must have rational ratios of their
factors; anything else is refused by name.  No term is ever dropped.
"""

import ast
import re

import sympy as sp

from .errors import InputError
from .first_steps import first_steps
from .problem import Field, Problem, Scalar
from .trig import rational

__all__ = ["Equations"]

_SAFE = (ast.Expression, ast.BinOp, ast.UnaryOp, ast.Constant, ast.Name, ast.Load, ast.Call,
         ast.operator, ast.unaryop, ast.Tuple)
_FUNCTIONS = {"sin": sp.sin, "cos": sp.cos, "exp": sp.exp, "sqrt": sp.sqrt, "pi": sp.pi}


class Equations(Problem):
    """A problem written as equations.

    Parameters
    ----------
    equations : SymPy Eq or expression, text, or a list or dict of them
        An expression means expression = 0.  In a text, ``x''`` is the second time derivative of the
        field x, a bare ``x`` means x(t), and ``=`` separates the sides.
    unknowns : dict
        SymPy function (or its name) to :class:`Field`, SymPy symbol (or name) to :class:`Scalar`.
    seed : dict, optional
        Unknown to its first terms, such as ``lam*cos(omega*t)``; left out, the first steps are
        solved automatically where they have finitely many solutions.
    frequency : symbol or name, optional
        The unknown scalar ω with τ = ωt; left out, the period is 2π.
    parameters : tuple of symbols or names
        Carried as symbols; coefficients are polynomials in them.
    time, lam : symbol or name
        t and λ.
    choice : int, optional
        Which solution of the first steps to take, where there are several.

    Examples
    --------
    The oscillator of Duffing, λ the amplitude of cos ωt:

    >>> import ftseries as fts
    >>> duffing = fts.Equations("x'' + x + x**3 = 0", frequency="omega", unknowns={
    ...     "x": fts.Field("cos", modes="odd", fixed=(1,)), "omega": fts.Scalar()},
    ...     seed={"x": "lam*cos(omega*t)", "omega": 1})
    >>> sol = fts.solve(duffing, order=6)
    >>> sol.coefficient("omega", 2), sol.coefficient("x", 3, 3)
    (3/8, 1/32)
    """

    def __init__(self, equations, unknowns, seed=None, frequency=None, parameters=(), time="t",
                 lam="lam", choice=None):
        self.unknowns = {_name(key): _declared(value) for key, value in unknowns.items()}
        self.parameters = tuple(_name(p) for p in parameters)
        self.frequency = None if frequency is None else _name(frequency)
        self.time, self.lam_name = sp.Symbol(_name(time)), _name(lam)
        self.variable = self.time.name
        fields = [name for name, u in self.unknowns.items() if isinstance(u, Field)]
        known = {self.time.name, self.lam_name, *self.parameters, *self.unknowns}
        self._vocabulary = {name: sp.Symbol(name) for name in known} | {
            name: sp.Function(name) for name in fields}
        if not isinstance(equations, dict):
            equations = equations if isinstance(equations, (list, tuple)) else [equations]
            equations = {f"({i})": e for i, e in enumerate(equations, 1)}
        self.expressions = {name: self._parse(e) for name, e in equations.items()}
        self.scales, self.surd = {}, False
        self._translated = {name: self._translate(e, name)[1] for name, e in
                            self.expressions.items()} if seed is None else None
        if seed is None:
            seed = first_steps(self, choice)
        self._set_seed({_name(key): value for key, value in seed.items()})
        self._translated = {name: self._translate(e, name)[1]
                            for name, e in self.expressions.items()}

    def equations(self, lam, **unknowns):
        env = {"lam": lam, **unknowns}
        return {name: build(env) for name, build in self._translated.items()}

    def scale(self, name):
        return self.scales.get(name, sp.S.One)

    def arguments(self):
        plain = {name: vars(u) | {"kind": type(u).__name__} for name, u in self.unknowns.items()}
        return {"equations": {name: self._written(e) for name, e in self.expressions.items()},
                "unknowns": plain, "seed": self.seed_texts, "frequency": self.frequency,
                "parameters": list(self.parameters), "time": self.time.name, "lam": self.lam_name}

    def __reduce__(self):
        return _again, (self.arguments(),)

    def __repr__(self):
        lines = (f"{self._written(e)} = 0" for e in self.expressions.values())
        return f"Equations({'; '.join(lines)})"

    def _written(self, e):
        """An expression as text that can be read again: x'' for derivatives."""
        def primed(f, times):
            shift = f.args[0] != self.time
            return sp.Symbol(f"{f.func.__name__}{chr(39) * times}" + (f"({f.args[0]})" if shift
                                                                       else ""))
        e = e.replace(sp.Subs, lambda inner, variables, point: inner.xreplace(
            dict(zip(variables, point, strict=True))) if not inner.has(sp.Derivative) else primed(
                inner.expr.xreplace({variables[0]: point[0]}), int(inner.derivative_count)))
        e = e.replace(lambda d: isinstance(d, sp.Derivative),
                      lambda d: primed(d.expr, int(d.derivative_count)))
        return str(e)

    # --- reading -----------------------------------------------------------------------------

    def _parse(self, source):
        """Text, Eq or expression as an expression that is to vanish."""
        if isinstance(source, str):
            sides = source.split("=")
            if len(sides) > 2:
                raise InputError(f"{source!r} has more than one '='; write one equation")
            parts = [self._read(side, source) for side in sides]
            expression = parts[0] - parts[1] if len(parts) == 2 else parts[0]
        elif isinstance(source, sp.Equality):
            expression = source.lhs - source.rhs
        else:
            expression = sp.sympify(source)
        if not isinstance(expression, sp.Expr):
            raise InputError(f"{source!r} is not an equation; give a SymPy Eq, expression or text")
        own = {s: self._vocabulary[s.name] for s in expression.free_symbols
               if s.name in self._vocabulary}
        return expression.subs(own).doit()

    def _read(self, text, whole):
        """One side of an equation given as text."""
        fields = [n for n, u in self.unknowns.items() if isinstance(u, Field)]
        source = text.replace("^", "**").strip()
        for name in fields:
            source = re.sub(
                rf"\b{re.escape(name)}\b('*)(\(([^()]*)\))?",
                lambda m, name=name: (
                    f"diff({name}({m[3] or self.time.name}), {self.time.name}, {len(m[1])})"
                    if m[1] else f"{name}({m[3] or self.time.name})"), source)
        try:
            nodes = list(ast.walk(ast.parse(source, mode="eval")))
        except SyntaxError:
            raise InputError(f"{whole!r} cannot be read: {text.strip()!r} is not an expression") \
                from None
        names = {n.id for n in nodes if isinstance(n, ast.Name)}
        strange = names - set(self._vocabulary) - set(_FUNCTIONS) - {"diff"}
        if strange:
            raise InputError(f"{whole!r} contains {', '.join(sorted(strange))}, which is neither "
                             "an unknown, a parameter, λ, the time nor a function known here (sin, "
                             "cos, exp, sqrt); declare it or correct it")
        if not all(isinstance(n, _SAFE) for n in nodes):
            raise InputError(f"{whole!r} cannot be read: use numbers, names, + - * / ** and calls")
        calls = {getattr(n.func, "id", "?") for n in nodes if isinstance(n, ast.Call)}
        wrong = calls - set(fields) - set(_FUNCTIONS) - {"diff"}
        if wrong:
            raise InputError(f"{whole!r} calls {', '.join(sorted(wrong))}, which is not a function "
                             "of time; declare it as a Field")
        return sp.sympify(source, locals={**self._vocabulary, **_FUNCTIONS, "diff": sp.diff},
                          rational=True)

    # --- the seed ----------------------------------------------------------------------------

    def _set_seed(self, seed):
        """``self.seed`` and ``self.scales`` from expressions in λ and the modes."""
        foreign = set(seed) - set(self.unknowns)
        if foreign:
            raise InputError(f"the seed names {', '.join(sorted(foreign))}, not an unknown")
        self.seed, self.seed_texts = {}, {}
        lam = self._vocabulary[self.lam_name]
        for name, value in seed.items():
            text = value if isinstance(value, str) else None
            value = sp.expand(self._read(text, text) if text else sp.sympify(value).subs(
                {s: self._vocabulary[s.name] for s in sp.sympify(value).free_symbols
                 if s.name in self._vocabulary}))
            self.seed_texts[name] = str(value)
            rows = {}
            for term in sp.Add.make_args(value):
                m, mode, c = self._seed_term(name, term, lam)
                row = rows.setdefault(m, {})
                row[mode] = row.get(mode, 0) + c
            rows = [rows.get(m, {}) for m in range(max(rows) + 1)]
            leading = next((c for row in rows for c in row.values() if c != 0), sp.S.One)
            scale = leading if not leading.is_Rational else sp.S.One
            if scale != 1:
                self.scales[name] = scale
            rows = [{mode: self._rational(c / scale, f"the seed of {name}")
                     for mode, c in row.items()} for row in rows]
            if isinstance(self.unknowns[name], Scalar):
                rows = [row.get((0, 0), 0) for row in rows]
            self.seed[name] = rows

    def _seed_term(self, name, term, lam):
        """(Taylor order, mode, coefficient) of one term of a seed."""
        number, rest = term.as_independent(lam, self.time, as_Add=False)
        m, mode = 0, (0, 0)
        for factor in sp.Mul.make_args(rest):
            base, exponent = factor.as_base_exp()
            if base == lam and exponent.is_Integer and exponent > 0:
                m += int(exponent)
            elif isinstance(factor, (sp.sin, sp.cos)):
                mode = int(isinstance(factor, sp.sin)), self._harmonic(factor)
            elif factor != 1:
                raise InputError(f"the seed of {name} has the term {term}; terms are number · "
                                 "λ^m · cos or sin of nωt")
        return m, mode, number

    def _harmonic(self, function):
        """n in cos(nωt) or sin(nωt)."""
        omega = self._vocabulary[self.frequency] if self.frequency else sp.S.One
        n = sp.simplify(function.args[0] / (omega * self.time))
        if not (n.is_Integer and n > 0):
            raise InputError(f"{function} is not a mode of the ansatz: write cos(n*{omega}*"
                             f"{self.time}) with a whole n > 0")
        return int(n)

    def _rational(self, number, where):
        number = sp.nsimplify(sp.simplify(number)) if not number.is_Rational else number
        if not number.is_Rational:
            raise InputError(f"{where} has the irrational number {number} beside others; measure "
                             "the unknown in a unit that removes it")
        return number

    # --- translation: expression to (factor, builder) ------------------------------------------

    def _translate(self, e, where):
        """(factor, build): e = factor · build(env), the factor a SymPy number."""
        if e.is_Number:
            if not e.is_Rational:
                e = sp.nsimplify(e, rational=True)
            return e, _one
        if not e.free_symbols and not e.atoms(sp.core.function.AppliedUndef):
            return e, _one                                   # sqrt(3), pi
        if e.is_Symbol:
            return self._symbol(e, where)
        if e.is_Add:
            return self._sum(e, where)
        if e.is_Mul:
            factor, builds = sp.S.One, []
            for arg in e.args:
                f, build = self._translate(arg, where)
                factor *= f
                if build is not _one:
                    builds.append(build)
            return factor, _product(builds)
        if e.is_Pow and e.exp.is_Rational:
            f, build = self._translate(e.base, where)
            exponent = rational(e.exp)
            return f**e.exp, lambda env: build(env) ** exponent
        if isinstance(e, (sp.Derivative, sp.Subs, sp.core.function.AppliedUndef)):
            return self._field(e, where)
        if isinstance(e, (sp.sin, sp.cos, sp.exp)):
            return self._function(e, where)
        raise InputError(f"equation {where} contains {e}, which has no Fourier-Taylor series here; "
                         "only + - * /, rational powers, exp, sin and cos are known")

    def _symbol(self, e, where):
        name = e.name
        if name == self.lam_name:
            return sp.S.One, lambda env: env["lam"]
        if name in self.parameters:
            return sp.S.One, lambda env: env["lam"].expansion.parameter(name)
        if isinstance(self.unknowns.get(name), Scalar):
            return self.scale(name), lambda env: env[name]
        if isinstance(self.unknowns.get(name), Field):
            raise InputError(f"equation {where} contains the bare symbol {name}; write {name}(t)")
        raise InputError(f"equation {where} contains {name}, which is neither an unknown, a "
                         "parameter nor λ; declare it, or give it a value")

    def _sum(self, e, where):
        parts = [self._translate(arg, where) for arg in e.args]
        common = parts[0][0]
        weighted = []
        for arg, (factor, build) in zip(e.args, parts, strict=True):
            ratio = sp.nsimplify(sp.radsimp(sp.powsimp(sp.simplify(factor / common), force=True)))
            if not ratio.is_Rational:
                raise InputError(f"equation {where}: the term {arg} differs from {e.args[0]} by "
                                 f"the irrational factor {ratio}; choose other units")
            weighted.append((rational(ratio), build))

        def build(env):
            total = None
            for weight, part in weighted:
                term = part(env)
                if isinstance(term, int):
                    term = env["lam"].expansion.constant(weight)
                elif weight != 1:
                    term = term * weight
                total = term if total is None else total + term
            return total
        return common, build

    def _field(self, e, where):
        """u(t + c) or a time derivative of it."""
        times, inner = 0, e
        if isinstance(inner, sp.Subs):
            variable, point = inner.variables[0], inner.point[0]
            inner = inner.expr.xreplace({variable: self.time})
            shift = point - self.time
        else:
            shift = sp.S.Zero
        if isinstance(inner, sp.Derivative):
            (variable, times), = inner.variable_count
            inner, times = inner.expr, int(times)
            if variable != self.time:
                raise InputError(f"equation {where}: {e} is not a derivative by {self.time}")
        name = getattr(inner.func, "__name__", "")
        if not isinstance(self.unknowns.get(name), Field) or len(inner.args) != 1:
            raise InputError(f"equation {where} contains {e}; {name or e} is not a declared Field")
        shift += inner.args[0] - self.time
        if times > 2:
            raise InputError(f"equation {where} contains {e}: derivatives up to the second are "
                             "known; write the equation as a system")
        frequency = self.frequency
        omega = self._vocabulary[frequency] if frequency else sp.S.One
        turn = sp.simplify(shift * omega / (2 * sp.pi))
        if not turn.is_Rational:
            raise InputError(f"equation {where}: in {e} the shift is not a rational part of the "
                             "period")
        fraction = rational(turn)
        self.surd = self.surd or 4 % fraction.q != 0

        def build(env):
            series = env[name]
            if times:
                series = series.diff(times)
                if frequency:
                    series = env[frequency] ** times * series
            return series.shift(fraction) if fraction else series
        return self.scale(name) * (self.scale(frequency) ** times if frequency else 1), build

    def _function(self, e, where):
        argument = e.args[0]
        if argument.has(self.time) and not argument.atoms(sp.core.function.AppliedUndef):
            n, which = self._harmonic(e), "sin" if isinstance(e, sp.sin) else "cos"
            if isinstance(e, sp.exp):
                raise InputError(f"equation {where}: {e} is not periodic in {self.time}")
            return sp.S.One, lambda env: getattr(env["lam"].expansion, which)(n)
        factor, build = self._translate(argument, where)
        weight = rational(self._rational(factor, f"equation {where}, in {e}:"))
        which = type(e).__name__

        def apply(env):
            inner = build(env)
            return getattr(inner * weight if weight != 1 else inner, which)()
        return sp.S.One, apply


def _again(arguments):
    return Equations(**arguments)


def _one(env):
    return 1


def _product(builds):
    if not builds:
        return _one

    def build(env):
        total = None
        for part in builds:
            total = part(env) if total is None else total * part(env)
        return total
    return build


def _name(key):
    name = key if isinstance(key, str) else getattr(key, "name", None) or getattr(
        key, "__name__", None)
    if not name or not name.isidentifier():
        raise InputError(f"{key!r} is not a name; give a SymPy symbol or function, or its name")
    return name


def _declared(unknown):
    if isinstance(unknown, dict):
        kind = {"Field": Field, "Scalar": Scalar}[unknown["kind"]]
        values = {k: tuple(map(_mode, v)) if isinstance(v, list) else v
                  for k, v in unknown.items() if k != "kind"}
        return kind(**values)
    return unknown


def _mode(x):
    return tuple(x) if isinstance(x, list) else x
