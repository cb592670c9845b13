"""The explorer of van der Pol's limit cycle: the series in ε, cut off and by Padé approximants."""

from __future__ import annotations

import base64
import warnings
from typing import TYPE_CHECKING, Any

import ipywidgets
import numpy as np
import traitlets
from matplotlib.axes import Axes

from ..analysis import pade
from ..errors import ConvergenceWarning, InputError
from ..figures.style import GREY
from ..problem import Field, Scalar
from ..references.van_der_pol import LimitCycle
from ..resum import at_phase
from ..solver import solve
from ..symbolic import Equations
from .base import Explorer, View, link, packed, picture

if TYPE_CHECKING:
    from ..solution import Solution

__all__ = ["VanDerPolView", "van_der_pol"]

LARGEST = 10.0                       # ε, as in js/van_der_pol.js
ORDERS = (8, 16, 24, 32)         # powers of ε
PHASES = np.linspace(0, np.pi / 2, 25)
NEAREST_ORDER = 120                  # of λ = √ε, for the nearest singularities


class VanDerPolView(View):
    """The cycle in the phase plane and over time, and its frequency, for one ε and order.

    ``pades`` maps each of ``ORDERS``, as text, to "omega", "x" and "slope": base64 of the float64
    coefficients of numerators and denominators, one approximant for each of ``PHASES`` (for ω one,
    in ε²), lowest power first.  ``nearest`` is |ε²| at the nearest singularities.
    """

    scripts = ("limit_cycle.js", "van_der_pol.js")
    eps = traitlets.Float(1.0).tag(sync=True)
    resummed = traitlets.Bool(True).tag(sync=True)
    nearest = traitlets.Float().tag(sync=True)
    pades = traitlets.Dict().tag(sync=True)


def van_der_pol(eps: float = 2.0, order: int = 24, resummed: bool = True) -> Explorer:
    """Explore x″ + x = ε (1 - x²) x′: ε from 0 past the radius of convergence to 10.

    Parameters
    ----------
    eps : float
        The ε shown first.
    order : int
        The power of ε shown first: 8, 16, 24 or 32.
    resummed : bool
        Whether the Padé approximants are shown first.

    Returns
    -------
    Explorer

    Examples
    --------
    >>> explorer = van_der_pol(eps=1.5, order=16)
    >>> explorer.view.eps, explorer.controls["order"].value, explorer.view.nearest
    (1.5, 16, 3.4202)
    """
    if order not in ORDERS:
        raise InputError(f"order={order!r}: the explorer has {', '.join(map(str, ORDERS))}")
    sol = solution(2 * ORDERS[-1] + 1)
    data = {"x": packed(_in_eps(sol, "y"), ORDERS[-1]),
            "omega": packed(_in_eps(sol, "omega"), ORDERS[-1])}
    sums = {n: approximants(sol, n) for n in ORDERS}
    view = VanDerPolView(data=data, eps=eps, order=order, resummed=resummed, nearest=nearest(),
                         pades={str(n): {name: _coded(found) for name, found in parts.items()}
                                for n, parts in sums.items()})
    controls = [
        link(ipywidgets.FloatSlider(description="ε", max=LARGEST, step=0.05), view, "eps"),
        link(ipywidgets.IntSlider(description="order", min=ORDERS[0], max=ORDERS[-1],
                                  step=ORDERS[1] - ORDERS[0]), view, "order"),
        link(ipywidgets.ToggleButton(description="Padé"), view, "resummed"),
    ]

    def draw(left: Axes, right: Axes) -> None:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ConvergenceWarning)
            _draw(left, right, sol.truncate(2 * order + 1), sums[order] if resummed else None, eps)

    return Explorer(controls, view, picture(draw, 2),
                    f"Left, the limit cycle in the phase plane at ε = {eps:g}, right, x(t): the "
                    f"series of order {order} in ε, its Padé approximants, and integrated.")


def _draw(left: Axes, right: Axes, sol: Solution, sums: Any, eps: float) -> None:
    cycle, tau = LimitCycle(eps), np.linspace(0, 2 * np.pi, 401)
    left.plot(cycle(tau), cycle.speed(tau), color=GREY, linewidth=5, alpha=0.5, label="integrated")
    right.plot(tau / cycle.omega, cycle(tau), color=GREY, linewidth=5, alpha=0.5)
    if eps > 0:
        lam, w = eps**0.5, sol.evaluate("omega", lam=eps**0.5)
        x = sol.evaluate("y", tau / w, lam=lam) / lam
        left.plot(x, w * np.gradient(x, tau), label="series")
        right.plot(tau / w, x)
    if sums:
        omega, x, v = resum(sums, eps)
        left.plot(x, v, "--", label="Padé")
        right.plot(np.linspace(0, np.pi, len(x)) / omega, x, "--")
    left.set(xlabel="$x$", ylabel="$dx/dt$", xlim=(-2.6, 2.6),
             ylim=np.array([-1.2, 1.2]) * np.abs(cycle.speed(tau)).max())
    right.set(xlabel="$t$", ylabel="$x(t)$", xlim=(0, 2 * np.pi / cycle.omega), ylim=(-2.6, 2.6))
    left.legend()


def solution(order: int) -> Solution:
    """The series of y = λx in λ = √ε, in ball arithmetic."""
    problem = Equations("y'' + y = (lam**2 - y**2)*y'", frequency="omega", unknowns={
        "y": Field("both", modes="odd", powers="odd", fixed=((1, 1),)), "omega": Scalar("even")})
    return solve(problem, order=order, arithmetic="ball", precision=512)


def nearest() -> Any:
    """|ε²| at the nearest singularities of ω, to four decimals."""
    return round(float(solution(NEAREST_ORDER).singularities("omega")[0].radius.value), 4)


def approximants(sol: Solution, order: int) -> Any:
    """The diagonal Padé approximants in ε of x and dx/dτ at each of ``PHASES``, and of ω in ε².

    x at τ + π is -x, and x at π - τ is -x at τ with -ε for ε, so a quarter of the period is enough.

    >>> found = approximants(solution(17), 8)
    >>> found["x"][0].degrees, found["omega"][0].degrees, len(found["slope"])
    ((4, 4), (2, 2), 25)
    """
    found = {name: [pade(at_phase(sol, "y", tau, slope=name == "slope")[1:2 * order + 2:2])
                    for tau in PHASES] for name in ("x", "slope")}
    omega = [sol.coefficient("omega", m) for m in range(0, 2 * order + 1, 4)]
    return found | {"omega": [pade(omega)]}


def resum(found: Any, eps: float) -> Any:
    """ω, and x and dx/dt at phases from 0 to π (``PHASES`` and their mirror images).

    >>> omega, x, v = resum(approximants(solution(65), 32), 3.0)
    >>> bool(abs(omega - LimitCycle(3.0).omega) < 1e-4), len(x)
    (True, 49)
    """
    both = np.array([eps, -eps], dtype=float)
    x, slope = (np.array([p(both) for p in found[name]]).T for name in ("x", "slope"))
    omega = found["omega"][0](both[:1]**2)[0]
    return (omega, np.concatenate([x[0], -x[1, -2::-1]]),
            omega * np.concatenate([slope[0], slope[1, -2::-1]]))


def _in_eps(sol: Solution, name: str) -> Any:
    """Tables as :func:`packed` wants them, of y/λ and ω in powers of ε = λ²."""
    first = 1 if name == "y" else 0
    return {(*mode, 0): dict(enumerate(row[first::2]))
            for mode, row in sol.table(name).items()}


def _coded(found: Any) -> Any:
    numbers = [np.pad(part, (0, degree + 1 - len(part))) for p in found
               for part, degree in zip((p.numerator, p.denominator), p.asked)]
    return base64.b64encode(np.concatenate(numbers).astype("<f8").tobytes()).decode()
