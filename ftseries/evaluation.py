r"""Numbers from coefficients: evaluation of a truncated Fourier-Taylor series.

Formula.  u(t; λ) = Re Σ_n (A_n(λ) - i B_n(λ)) z^n with z = e^{iωt}, A_n(λ) = Σ_m A_{n,m} λ^m and
ω = ω(λ); both sums by Horner's rule.  Everything here works on plain tables
``{(sine, n): [coefficient of λ^0, λ^1, …]}`` in the paper's units.
"""

from __future__ import annotations

import sys
import unicodedata
import warnings
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from .aliases import Array, ArrayLike, Mode, Real
from .arguments import MOST_DERIVATIVES, real, shown, whole
from .errors import ConvergenceWarning, InputError
from .problem import Scalar

if TYPE_CHECKING:
    from .problem import Field, Problem

__all__ = ["amplitudes", "broadcastable", "check_lam", "derivative", "fitting",
           "fourier_sum", "motion", "radius_estimate", "times", "turned", "unknown", "warn"]

#: splits a float into two halves, of which products are exact
_SPLIT = 2.0**27 + 1

#: the coefficients of λ^0, λ^1, … by mode
FloatTable: TypeAlias = Mapping[Mode, Sequence[float] | Array]


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


def turned(turns: Real, rest: Real, t: Array) -> Real:
    """The phase 2π ν t without its whole turns, for ν = ``turns`` + ``rest``, twice as many digits.

    The product of two floats is a float and an error that is one too (Dekker 1971).

    >>> from fractions import Fraction
    >>> rest = float(Fraction(1, 10) - Fraction(0.1))
    >>> round(float(turned(0.1, rest, np.array(1e15 + 1)) / (2 * np.pi)), 15)
    0.1
    """
    product = turns * t
    (a, b), (c, d) = ((x * _SPLIT - (x * _SPLIT - x), x) for x in (turns, t))
    error = ((a * c - product) + a * (d - c) + (b - a) * c) + (b - a) * (d - c)
    return 2 * np.pi * ((product - np.rint(product)) + (error - np.rint(error) + rest * t))


def unknown(problem: Problem, name: str) -> Field | Scalar:
    """The declaration of an unknown; refuses a name that is none."""
    try:
        return problem.unknowns[name]
    except (KeyError, TypeError):
        written = unicodedata.normalize("NFKC", name) if isinstance(name, str) else name
        advice = "evaluate(…, derivative=1) gives velocities" if written == name else (
            f"names are written as Python writes them (NFKC), this one {written!r}")
        raise InputError(f"{name!r} is not an unknown of {problem!r}; it has "
                         f"{', '.join(map(repr, problem.unknowns))}; {advice}") from None


def times(problem: Problem, name: str, t: ArrayLike | None, order: int) -> ArrayLike:
    """The times at which an unknown is asked, 0 for a scalar; refuses what cannot be meant."""
    whole("derivative", order, most=MOST_DERIVATIVES)
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


def warn(reason: str, kind: type[Warning] = ConvergenceWarning) -> None:
    """A warning that points at the line which called the package."""
    level, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals.get("__name__", "").partition(".")[0] == __package__:
        level, frame = level + 1, frame.f_back
    warnings.warn(reason, kind, stacklevel=level)


def broadcastable(**values: Any) -> dict[str, Array]:
    """The values as finite float arrays whose shapes fit together."""
    return fitting({name: real(name, value) for name, value in values.items()})


def fitting(arrays: dict[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """The same arrays; refuses shapes that do not fit together."""
    try:
        np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise InputError(f"these shapes do not broadcast: {shapes}; add axes, such as t[:, None]") \
            from None
    return arrays
