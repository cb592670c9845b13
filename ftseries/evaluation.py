r"""Numbers from coefficients: evaluation of a truncated Fourier-Taylor series.

Formula.  u(t; λ) = Re Σ_n (A_n(λ) - i B_n(λ)) z^n with z = e^{iωt}, A_n(λ) = Σ_m A_{n,m} λ^m and
ω = ω(λ); both sums by Horner's rule.  Everything here works on plain tables
``{(sine, n): [coefficient of λ^0, λ^1, …]}`` in the paper's units.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeAlias

import mpmath
import numpy as np

from .aliases import Array, ArrayLike, Mode, Real
from .arguments import real
from .errors import ConvergenceWarning, InputError

__all__ = ["amplitudes", "broadcastable", "fourier_sum", "radius_estimate",
           "warn_outside", "mp_evaluate"]

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


def warn_outside(table: FloatTable, name: str, lam: ArrayLike) -> None:
    """Warn when |λ| is clearly outside the estimated radius of convergence."""
    largest = float(np.max(np.abs(lam), initial=0.0))
    fits = [radius_estimate(table, algebraic) for algebraic in (True, False)]
    found = [radius for radius in fits if radius is not None]
    if len(found) == 2 and largest > 1.03 * max(found):
        radius = (found[0] * found[1]) ** 0.5
        warnings.warn(f"λ = {largest:g} lies outside the radius of convergence of {name!r}, which "
                      f"its coefficients put near {radius:.3g}; the truncated sum is not an "
                      "approximation there", ConvergenceWarning, stacklevel=4)


def mp_evaluate(table: MpTable, frequency: list[Callable[[], Any]] | None, t: Any, lam: Any,
                dps: int) -> Any:
    """The same sum with mpmath numbers; the tables hold functions of the working precision."""
    with mpmath.workdps(dps + 10):
        def value(time: Any, parameter: Any) -> Any:
            parameter = _mpf(parameter)
            rows = {mode: mpmath.polyval([c() for c in row[::-1]], parameter)
                    for mode, row in table.items()}
            tau = _mpf(time)
            if frequency is not None:
                tau *= mpmath.polyval([c() for c in frequency[::-1]], parameter)
            return mpmath.fsum(a * (mpmath.sin if sine else mpmath.cos)(n * tau)
                               for (sine, n), a in rows.items())
        result = np.frompyfunc(value, 2, 1)(np.asarray(t, object), np.asarray(lam, object))
    with mpmath.workdps(dps):
        return np.frompyfunc(lambda x: +x, 1, 1)(result)


def _mpf(x: Any) -> Any:
    """A number in the working precision; SymPy may hold it exactly."""
    return mpmath.mpmathify(x.evalf(mpmath.mp.dps) if hasattr(x, "evalf") else x)


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
