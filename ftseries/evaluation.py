r"""Numbers from coefficients: evaluation of a truncated Fourier-Taylor series.

Formula.  u(t; λ) = Re Σ_n (A_n(λ) - i B_n(λ)) z^n with z = e^{iωt}, A_n(λ) = Σ_m A_{n,m} λ^m and
ω = ω(λ); both sums by Horner's rule.  Everything here works on plain tables
``{(sine, n): [coefficient of λ^0, λ^1, …]}`` in the paper's units.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

import mpmath
import numpy as np

from .aliases import Array, ArrayLike, Mode, Real
from .arguments import real, shown, whole
from .conversion import precise
from .errors import ConvergenceWarning, InputError
from .problem import Scalar

if TYPE_CHECKING:
    from .problem import Field, Problem

__all__ = ["SMALL", "amplitudes", "broadcastable", "check_lam", "doubt", "fourier_sum",
           "motion", "mp_evaluate", "radius_estimate", "times", "unknown", "warn"]

#: terms beyond this part of the largest ones before them are not small: above what good sums of
#: low order leave, below 1, where the terms grow
SMALL = 0.5

#: the coefficients of λ^0, λ^1, … by mode: floats, and what gives them in any precision
FloatTable: TypeAlias = Mapping[Mode, Sequence[float] | Array]
MpTable: TypeAlias = dict[Mode, list[Callable[[], Any]]]


def amplitudes(table: FloatTable, lam: ArrayLike) -> dict[Mode, Array]:
    """``{(sine, n): A_n(λ)}`` for an array ``lam``, each of its shape."""
    modes = list(table)
    if not modes:
        return {}
    rows = np.array([table[mode] for mode in modes], dtype=float)
    lam = np.asarray(lam, dtype=float)
    if lam.ndim == 0:
        with np.errstate(over="ignore", invalid="ignore"):
            total = np.zeros(len(modes))
            for column in rows.T[::-1]:
                total = total * lam + column
        return dict(zip(modes, total))
    total = np.zeros((len(modes),) + lam.shape)
    for column in rows.T[::-1]:
        total *= lam
        total += column.reshape((-1,) + (1,) * lam.ndim)
    return dict(zip(modes, total))


def fourier_sum(amplitude: Mapping[Mode, Real], tau: ArrayLike) -> Array:
    """Σ A_n cos nτ + B_n sin nτ, broadcasting the amplitudes with τ."""
    tau = np.asarray(tau, dtype=float)
    shape = np.broadcast_shapes(tau.shape, *(np.shape(a) for a in amplitude.values()))
    if not amplitude:
        return np.zeros(shape)
    orders = sorted({n for _, n in amplitude})
    step = int(np.gcd.reduce([n - orders[0] for n in orders])) or 1
    z = np.exp(1j * step * tau)
    total = np.zeros(shape, dtype=complex)
    for n in range(orders[-1], orders[0] - 1, -step):
        total = total * z + amplitude.get((0, n), 0.0) - 1j * amplitude.get((1, n), 0.0)
    return (total * np.exp(1j * orders[0] * tau)).real


def derivative(amplitude: Mapping[Mode, Real], order: int) -> dict[Mode, Real]:
    """The amplitudes of a derivative in τ.

    >>> derivative({(0, 2): 5.0}, 1), derivative({(0, 2): 5.0}, 2)             # 5 cos 2τ
    ({(1, 2): -10.0}, {(0, 2): -20.0})
    """
    for _ in range(order):
        amplitude = {(1 - sine, n): (n if sine else -n) * a for (sine, n), a in amplitude.items()}
    return dict(amplitude)


def motion(amplitude: Mapping[Mode, Real], t: ArrayLike, omega: Real = 1.0, order: int = 0) -> Real:
    """The field with these amplitudes at times t, or a derivative of it in t."""
    return omega**order * fourier_sum(derivative(amplitude, order), omega * np.asarray(t))


def unknown(problem: Problem, name: str) -> Field | Scalar:
    """The declaration of an unknown; refuses a name that is none."""
    try:
        return problem.unknowns[name]
    except (KeyError, TypeError):
        raise InputError(f"{name!r} is not an unknown of {problem!r}; it has "
                         f"{', '.join(map(repr, problem.unknowns))}; evaluate(…, derivative=1) "
                         "gives velocities") from None


def times(problem: Problem, name: str, t: ArrayLike | None, order: int) -> ArrayLike:
    """The times at which an unknown is asked, 0 for a scalar; refuses what cannot be meant."""
    whole("derivative", order)
    if isinstance(unknown(problem, name), Scalar):
        if t is not None or order:
            raise InputError(f"{name!r} does not depend on time; leave "
                             f"{'t' if t is not None else 'derivative'} out")
        return 0
    if t is None:
        raise InputError(f"{name!r} depends on time: evaluate({name!r}, t, lam=…)")
    return t


def check_lam(problem: Problem, name: str, t: Any, positional: tuple[Any, ...], lam: Any) -> None:
    """Refuse a λ that is missing or stands without its name; the sentence shows the call."""
    if lam is None or positional:
        scalar = isinstance(unknown(problem, name), Scalar)
        value = "…" if (t is None if scalar else not positional) else shown(
            t if scalar else positional[0])
        raise InputError(f"λ is given by its name: evaluate({name!r}, {'' if scalar else 't, '}"
                         f"lam={value})")


def radius_estimate(table: FloatTable, algebraic: bool = True) -> float | None:
    """The radius of convergence that the last two thirds of the coefficients suggest.

    Fits ``log c_m = α - m log R - p log m`` to c_m = Σ_n |A_{n,m}|, the form that an algebraic
    singularity gives, or without ``algebraic`` only a geometric sequence (p = 0); None with fewer
    than eight non-zero Taylor orders to fit.
    """
    rows = np.abs(np.array(list(table.values()), dtype=float))
    if not rows.size:
        return None
    sums = rows.sum(axis=0)
    m = np.flatnonzero(sums > 0)
    m = m[m >= max(len(sums) // 3, 1)]
    if len(m) < 8:
        return None
    design = np.stack([np.ones(len(m)), m, np.log(m)], axis=1)[:, :3 if algebraic else 2]
    return float(np.exp(-np.linalg.lstsq(design, np.log(sums[m]), rcond=None)[0][1]))


def doubt(table: FloatTable, name: str, lam: ArrayLike, given: int = 1,
          unit: float = 1.0) -> str | None:
    """Why the truncated sum may be no approximation at the largest of the |λ|, or None.

    Either |λ| is clearly outside the estimated radius of convergence, or, at any order, the terms
    Σ_n |A_{n,m} λ^m| of the last orders m are not small against those before.  Orders that are
    zero by parity do not count, and of the orders below ``given``, those of the seed, none is last.
    The table is one in (λ/``unit``)^m.
    """
    largest = float(np.max(np.abs(lam), initial=0.0))
    fits = [radius_estimate(table, algebraic) for algebraic in (True, False)]
    found = [radius for radius in fits if radius is not None]
    if len(found) == 2 and largest > 1.03 * unit * max(found):
        radius = unit * (found[0] * found[1]) ** 0.5
        return (f"λ = {largest:g} lies outside the radius of convergence of {name!r}, which its "
                f"coefficients put near {radius:.3g}; the truncated sum is not an approximation "
                "there")
    share = last_terms(table, largest / unit, given)
    if share > SMALL:
        return (f"at λ = {largest:g} the last terms of {name!r} are not small, but "
                f"{share:.2g} times the largest ones before: the truncated sum may be no "
                "approximation there, and whether the series converges is unknown; take a smaller "
                "λ or a higher order, or compare with resum() or refine()")
    return None


def last_terms(table: FloatTable, lam: float, given: int = 1) -> float:
    """The largest term of the last orders at λ, over the largest term before them.

    >>> last_terms({(0, 0): [1.0, 0.0, 0.25, 0.0, 0.125]}, 2.0)                # 1 + 1 + 2
    2.0
    """
    sums = np.abs(np.array(list(table.values()), dtype=float)).sum(axis=0)
    orders = np.flatnonzero(sums) if table else np.array([], dtype=int)
    if lam == 0 or not orders.size:
        return 0.0
    step = int(np.gcd.reduce(orders - orders[0]))
    last = orders >= max(len(sums) - max(step, 2), given)
    if last.all() or not last.any():
        return 0.0
    terms = np.log(sums[orders]) + orders * np.log(lam)             # they may be beyond all floats
    return float(np.exp(min(terms[last].max() - terms[~last].max(), 700.0)))


def warn(reason: str, kind: type[Warning] = ConvergenceWarning) -> None:
    """A warning that points at the line which called the package."""
    level, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals.get("__name__", "").partition(".")[0] == __package__:
        level, frame = level + 1, frame.f_back
    warnings.warn(reason, kind, stacklevel=level)


def mp_evaluate(table: MpTable, frequency: list[Callable[[], Any]] | None, t: Any, lam: Any,
                dps: int, order: int = 0) -> Any:
    """The same as :func:`motion` with mpmath numbers, from functions of the working precision."""
    with mpmath.workdps(dps + 10):
        def value(time: Any, parameter: Any) -> Any:
            parameter = precise(parameter)
            rows = {mode: mpmath.polyval([c() for c in row[::-1]], parameter)
                    for mode, row in table.items()}
            omega = mpmath.mpf(1) if frequency is None else mpmath.polyval(
                [c() for c in frequency[::-1]], parameter)
            tau = omega * precise(time)
            return omega**order * mpmath.fsum(a * (mpmath.sin if sine else mpmath.cos)(n * tau)
                                              for (sine, n), a in derivative(rows, order).items())
        result = np.frompyfunc(value, 2, 1)(np.asarray(t, object), np.asarray(lam, object))
    with mpmath.workdps(dps):
        return np.frompyfunc(lambda x: +x, 1, 1)(result)


def broadcastable(**values: Any) -> dict[str, Array]:
    """The values as finite float arrays whose shapes fit together."""
    arrays = {name: real(name, value) for name, value in values.items()}
    try:
        np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise InputError(f"these shapes do not broadcast: {shapes}; add axes, such as t[:, None]") \
            from None
    return arrays
