r"""Values of a solution: its truncated series summed at numbers, and what is to be said of them.

The methods of this class belong to :class:`ftseries.Solution`; the sums are those of
:mod:`ftseries.evaluation` and :mod:`ftseries.enclosure`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

import numpy as np
from flint import arb, fmpq

from . import enclosure, evaluation
from .aliases import Array, ArrayLike, Exact, Real
from .arguments import MOST_BITS, MOST_DPS, computed, decimal, objects, rational, whole
from .doubt import Place, digits, front
from .errors import ConvergenceWarning, InputError, PrecisionWarning
from .precision import working
from .problem import Scalar
from .tables import Point, Tables

__all__ = ["Values"]

#: why a value may not be what was asked, by the kind of the warning
Reasons: TypeAlias = dict[type[Warning], str]

#: decimal digits of a float, and the part of a value that may be lost without a word to rounding
_DIGITS, _LOST = 15, 1e-8
#: beyond this phase ωt, its whole turns are taken off with twice as many digits
_LATE = 1e4
#: the unit of rounding of a phase: that of a frequency in floats, and what is left otherwise
_FLOAT, _TWICE = 2.0**-53, 2.0**-100
#: how often the precision is doubled where digits are lacking
_DOUBLINGS = 8


class Values(Tables):
    """A solution's unknowns at numbers."""

    def evaluate(self, name: str, t: ArrayLike | None = None, *positional: Any,
                 lam: ArrayLike | None = None, dps: int | None = None, derivative: int = 0,
                 **parameters: ArrayLike) -> Real:
        """The value of an unknown at times t and parameter λ.

        Parameters
        ----------
        name : str
            A field (then ``t`` is needed) or a scalar.
        t : array_like
            Times; the phase is ωt where the problem has an unknown frequency.
        lam : array_like
            The series parameter, given by its name; broadcasts with ``t``.
        dps : int, optional
            Decimal digits; the result then consists of mpmath numbers.  Python prints as many of
            them as ``mpmath.mp.dps`` says; ``mpmath.nstr(value, dps)`` shows all.  A float is the
            decimal that it looks like, ``lam=0.1`` is a tenth; of mpmath's numbers all bits count.
        derivative : int
            Of a field, its derivative of this order in the time t, for example 1 for the velocity.
        **parameters
            Values of the problem's free parameters, for example ``mu=-0.3``.

        Returns
        -------
        float, numpy.ndarray, or mpmath numbers

        Warns
        -----
        ConvergenceWarning
            What the orders left out may change, extrapolated from the last terms of the series and
            of that of the frequency, times t, is more than a hundredth of the value's size
            Σ_n |A_n|; or nothing is known of it, as where only the first terms, those given by
            hand, are known.  It is an estimate, not a bound.
        PrecisionWarning
            The coefficients are balls, and their radii leave fewer digits of the size than asked:
            ``dps``, or 15 without it; or ``dps`` is more than the digits of floats; or the rounding
            of floats, that of ωt at late times among it, leaves fewer than 8 digits.

        Examples
        --------
        >>> import ftseries as fts
        >>> sol = fts.solve(fts.CubicOscillator(a=1), order=24)
        >>> round(sol.evaluate("omega", lam=0.5), 13), sol.evaluate("x", [0.0, 0.1], lam=0.5).shape
        (3.4458763864723, (2,))
        >>> round(sol.evaluate("x", 0.3, lam=0.5, derivative=1), 10)                 # x'(0.3)
        -1.3518076837
        """
        evaluation.check_lam(self.problem, name, t, positional, lam)
        t = evaluation.times(self.problem, name, t, derivative)
        self._check_parameters(parameters)
        values = evaluation.broadcastable(t=t, lam=lam, **parameters)
        time, places, reasons = values.pop("t"), values.pop("lam"), Reasons()
        if dps is not None:
            result = self._evaluate_mp(name, t, lam, dps, derivative, parameters, reasons)
        elif all(v.ndim == 0 for v in values.values()):
            point = tuple((k, float(v)) for k, v in values.items())
            result = self._evaluate(name, time, places, derivative, point, reasons)
        else:
            result = self._evaluate_many(name, time, places, derivative, values, reasons)
        for kind, reason in reasons.items():
            evaluation.warn(reason, kind)
        return result if dps or np.ndim(result) else float(result)

    def enclosure(self, name: str, t: Any = None, *, lam: Any, derivative: int = 0,
                  precision: int | None = None, **parameters: Exact) -> Any:
        """A ball that encloses the value of the truncated series, rounding and radii included.

        It says nothing of the orders that are left out.

        Parameters
        ----------
        name, t, derivative, **parameters
            As for :meth:`evaluate`; one value of each parameter.
        lam : number or array of numbers
            As ``t``: an int, Fraction, decimal (which is the decimal that it looks like, not its
            binary neighbour), SymPy number, ``fmpq``, or a ball, of which every point is meant.
        precision : int, optional
            The bits to compute with; left out, those of the solution's balls, or 128.

        Returns
        -------
        flint.arb, or a numpy.ndarray of them

        Raises
        ------
        InputError
            The coefficients are floats, of whose errors nothing is known.

        Examples
        --------
        >>> import ftseries as fts
        >>> sol = fts.solve(fts.CubicOscillator(a=1), order=24, arithmetic="ball", precision=64)
        >>> sol.enclosure("omega", lam=0.5)
        [3.44587638647226 +/- 2.76e-16]
        """
        if self.arithmetic == "float":
            raise InputError("float coefficients have errors that nobody knows; solve with "
                             "arithmetic='exact' or 'ball' for values in balls")
        t = evaluation.times(self.problem, name, t, derivative)
        evaluation.fitting({"t": objects("t", t), "lam": objects("lam", lam)})
        self._check_parameters(parameters)
        bits = whole("precision", self.precision or 128 if precision is None else precision, 2,
                     max(MOST_BITS, self.precision or 0))
        point = [decimal(parameters[p]) for p in self.problem.parameters]
        return self._enclosed(name, t, lam, derivative, point, bits, decimal)[0]

    # --- floats ---------------------------------------------------------------------------------

    def _evaluate(self, name: str, t: Array, lam: Array, order: int, parameters: Point,
                  reasons: Reasons) -> Real:
        late = self._look(name, lam, t, order, parameters, reasons)
        amplitude, *frequency = (self._amplitudes(which, lam, parameters)
                                 for which in self._summed(name))
        if isinstance(self.problem.unknowns[name], Scalar):
            return amplitude.get((0, 0), np.zeros(lam.shape))
        omega = frequency[0].get((0, 0), 0.0) if frequency else 1.0
        tau = omega * t
        if late:
            tau = evaluation.turned(*self._turns(lam, parameters), t)
        return omega**order * evaluation.fourier_sum(
            evaluation.derivative(amplitude, order), tau + 0 * lam)

    def _turns(self, lam: Array, parameters: Point) -> tuple[Real, Real]:
        """ω/2π at each λ as the sum of two floats."""
        with working(bits=max(256, self.precision or 0)):
            if not self.problem.frequency:
                return enclosure.turns(arb(1))
            unique, where = np.unique(lam, return_inverse=True)
            sums = self._sums([self.problem.frequency], unique.astype(object),
                              self._point(dict(parameters)), rational)
            first, rest = np.transpose([enclosure.turns(each.amplitudes[0, 0]) for each in sums])
        return first[where].reshape(lam.shape), rest[where].reshape(lam.shape)

    def _evaluate_many(self, name: str, t: Array, lam: Array, order: int,
                       values: dict[str, Array], reasons: Reasons) -> Array:
        arrays = np.broadcast_arrays(t, lam, *values.values())
        result = np.empty(arrays[0].shape)
        points = np.stack([a.ravel() for a in arrays[2:]], axis=1)
        unique, where = np.unique(points, axis=0, return_inverse=True)
        for i, point in enumerate(unique):
            here = (where.ravel() == i).reshape(result.shape)
            result[here] = self._evaluate(name, arrays[0][here], arrays[1][here], order,
                                          tuple(zip(values, map(float, point))), reasons)
        return result

    # --- balls ----------------------------------------------------------------------------------

    def _enclosed(self, name: str, t: Any, lam: Any, order: int, point: list[fmpq], bits: int,
                  read: Callable[[Exact], fmpq]) -> Any:
        """The values and their sizes."""
        with working(bits=bits):
            sums = self._sums(self._summed(name), np.asarray(lam, object), point, read)
            return np.frompyfunc(lambda each, time: each.value(enclosure.ball(time, read), order),
                                 2, 2)(sums, np.asarray(t, object))

    def _evaluate_mp(self, name: str, t: Any, lam: Any, dps: int, order: int,
                     parameters: Mapping[str, Any], reasons: Reasons) -> Any:
        if any(np.ndim(value) for value in parameters.values()):
            raise InputError(f"with dps, give one value of {', '.join(parameters)} at a time")
        bits = math.ceil(whole("dps", dps, 1, MOST_DPS) * math.log2(10)) + 32
        point = self._point(parameters)
        for _ in range(2 if self.arithmetic == "ball" else _DOUBLINGS):
            values, sizes = self._enclosed(name, t, lam, order, point, bits, computed)
            found = min(map(enclosure.good, np.ravel(values), np.ravel(sizes)), default=math.inf)
            if found > dps + 1:
                break
            bits *= 2
        if self.arithmetic == "float" and dps > _DIGITS:
            reasons[PrecisionWarning] = (
                f"dps={dps}: in float arithmetic the coefficients have {_DIGITS} digits, and the "
                "rest is noise; solve with arithmetic='exact' for more")
        elif found < dps:
            reasons[PrecisionWarning] = self._few_digits(name, math.floor(max(found, 0)), dps)
        said: Reasons = {}
        self._look(name, np.asarray(lam, float), np.asarray(t, float), order,
                   tuple((k, float(v)) for k, v in parameters.items()), said)
        if ConvergenceWarning in said:
            reasons[ConvergenceWarning] = said[ConvergenceWarning]
        return np.frompyfunc(lambda value: enclosure.rounded(value, dps), 1, 1)(values)

    # --- doubts ---------------------------------------------------------------------------------

    def _look(self, name: str, lam: Array, t: Array, derivative: int, parameters: Point,
              reasons: Reasons) -> bool:
        """Add what is to be said, one sentence of each kind; is any phase late?

        First at the extreme λ, the larger one before, and the latest time; if there is anything,
        where these meet.
        """
        if not lam.size or not t.size:
            return False
        latest = float(np.max(np.abs(t)))
        places = [self._place(name, each, latest, derivative, parameters)
                  for each in sorted({float(lam.min()), float(lam.max())}, key=abs, reverse=True)]
        found = self._said(places)
        if found and lam.ndim and t.ndim:
            found = self._said([self._place(name, *pair, derivative, parameters)
                                for pair in front(lam, t)])
        for kind, reason in found.items():
            reasons.setdefault(kind, reason)
        return any(place.phase > _LATE for place in places)

    def _said(self, places: list[Place]) -> Reasons:
        found = ((ConvergenceWarning, next(filter(None, (p.doubt() for p in places)), None)),
                 (PrecisionWarning, next(filter(None, map(self._loss, places)), None)))
        return {kind: reason for kind, reason in found if reason}

    def _place(self, name: str, lam: float, time: float | None, derivative: int,
               parameters: Point) -> Place:
        """The unknown at λ and a time; without one, at the end of a period."""
        names, lam = self._summed(name), lam / self._lam_scale
        terms = [self._terms(which, derivative * (i == 0), parameters)
                 for i, which in enumerate(names)]
        omega = terms[1].sizes(lam)[0] * self._scale(names[1]) if names[1:] else 1.0
        phase = 2 * math.pi if time is None else abs(omega) * time
        return Place(names, terms, lam, phase, self._lam_scale)

    def _doubt(self, name: str, lam: ArrayLike, parameters: Point) -> str | None:
        """Why the truncated sum may be no approximation at λ within a period, or None."""
        places = (self._place(name, float(each), None, 0, parameters)
                  for each in {np.min(lam), np.max(lam)} if np.size(lam))
        return next(filter(None, (place.doubt() for place in places)), None)

    def _loss(self, place: Place) -> str | None:
        """Why a float value has fewer digits than it seems to have, or None."""
        if self.arithmetic == "ball":
            powers = abs(place.lam) ** np.arange(self.order + 1)
            lost = sum(place.relative([float(self._radii(which, terms.derivative) @ powers)
                                       for which, terms in zip(place.names, place.terms)]))
            if not lost <= 10.0**-_DIGITS:
                return self._few_digits(place.names[0], digits(lost), _DIGITS)
        of_floats = self.arithmetic == "float" and len(place.names) > 1
        lost = place.rounding(_FLOAT if of_floats else _TWICE)
        if not lost <= _LOST:
            return (f"at λ = {place.unit * place.lam:g} and the phase ωt = {place.phase:.3g} the "
                    f"rounding of floats leaves {digits(lost)} digits of {place.names[0]!r}; solve "
                    "with arithmetic='exact' and evaluate(…, dps=…) for more")
        return None

    def _few_digits(self, name: str, found: int, asked: int) -> str:
        if self.arithmetic != "ball":
            return f"the terms of {name!r} cancel here, and leave {found} of {asked} digits"
        return (f"the coefficients are balls of {self.precision} bits, and their radii leave "
                f"{found} of {asked} digits of {name!r} here; enclosure() gives the ball; solve "
                "with a larger precision for more")
