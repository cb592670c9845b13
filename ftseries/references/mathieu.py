"""The generalized Mathieu equation (M1) by the truncated Hill matrix and by direct integration.

(M1), with the factor ψ that its print lacks, is the Hill equation

    ψ'' + (a - λ² cos 2x - λ⁴ μ cos 4x) ψ = 0.

Odd solutions that change sign over half a period are ψ = Σ c_n sin(nx), n = 1, 3, 5, …. From
2 cos(2jx) sin(nx) = sin((n + 2j)x) + sin((n - 2j)x) follows the infinite symmetric matrix equation

    n² c_n + Σ_k [λ²/2 M¹_nk + λ⁴μ/2 M²_nk] c_k = a c_n,      Mʲ_nk = δ(|n - k|, 2j) - δ(n + k, 2j).

Cut off at a size beyond which the c_n are below rounding, it gives a and the c_n. For real λ and μ
this is a Sturm-Liouville problem on [0, π/2] (ψ(0) = ψ'(π/2) = 0): the eigenvalues are simple, and
`index` = 0, 1, 2, … numbers them from the lowest. At λ = 0 they are 1, 9, 25, …. For complex λ or μ
`index` names the branch that starts there, followed along the straight line from λ = 0.

At μ = 0 this is Mathieu's equation y'' + (a - 2q cos 2x) y = 0 with q = λ²/2 ≥ 0: without change of
sign, the odd solution of index k is se_{2k+1}(x, q) and its eigenvalue b_{2k+1}(q).
"""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
from scipy import special
from scipy.integrate import solve_ivp

from ftseries.aliases import ArrayLike
from ftseries.arguments import MOST_DERIVATIVES, real, whole
from ftseries.errors import InputError
from ftseries.precision import working
from ftseries.references._digits import GUARD, in_digits, number

__all__ = [
    "band_edges", "eigenfunction", "eigenvalue", "hill_matrix", "integrate", "mathieu_b",
    "sine_coefficients",
]

LARGEST = 1000  # size of a truncated Hill matrix
TOLERANCES = {"rtol": 3e-14, "atol": 1e-16, "max_step": 0.025}  # of DOP853 and its dense output


def hill_matrix(lam: Any, mu: Any = 0, size: int = 32) -> Any:
    """The matrix above for n = 1, 3, …, 2 size - 1, of shape (broadcast of lam, mu) + (size, size).

    >>> hill_matrix(1, 0, size=3)
    array([[ 0.5,  0.5,  0. ],
           [ 0.5,  9. ,  0.5],
           [ 0. ,  0.5, 25. ]])
    """
    squares, first, second = _parts(size)
    q, s = (part[..., None, None] for part in _couplings(lam, mu))
    return squares + q * first + s * second


def eigenvalue(lam: Any, mu: Any = 0, index: int = 0, dps: int | None = None) -> Any:
    """The eigenvalue a; lam and mu broadcast, or are single numbers with `dps`.

    >>> mpmath.nstr(eigenvalue(2, "-0.3", dps=30), 30)
    '-2.99598182880538532934260736841'
    """
    index = whole("index", index)
    if dps is None:
        return _eigenpair(lam, mu, index)[0]
    return in_digits(dps, lambda: _eigenpair_in_digits(lam, mu, index)[0])


def sine_coefficients(lam: Any, mu: Any = 0, index: int = 0, dps: int | None = None) -> Any:
    """[c_1, c_3, c_5, …] on the last axis, with λ as the coefficient that leads at λ = 0.

    For index 0 this is c_1 = λ, as in (M2a). With `dps`: a tuple of mpmath numbers.
    """
    index = whole("index", index)
    if dps is None:
        vector = _eigenpair(lam, mu, index)[1]
        return np.asarray(lam)[..., None] * vector / _leading(vector[..., index : index + 1])

    def value() -> Any:
        vector = _eigenpair_in_digits(lam, mu, index)[1]
        return tuple(vector * (number("lam", lam) / _leading(vector[index])))
    return in_digits(dps, value)


def eigenfunction(x: Any, lam: Any, mu: Any = 0, index: int = 0, derivative: int = 0) -> Any:
    """ψ(x), normalized as in `sine_coefficients`, or a derivative of it; x, lam and mu broadcast.

    >>> np.round(eigenfunction([0, np.pi / 2, np.pi], lam=0.001), 6) + 0
    array([0.   , 0.001, 0.   ])
    """
    c = sine_coefficients(lam, mu, index)
    n = 1 + 2 * np.arange(c.shape[-1])
    whole("derivative", derivative, most=MOST_DERIVATIVES)
    phase = real("x", x)[..., None] * n + derivative * np.pi / 2
    return np.sum(c * n**float(derivative) * np.sin(phase), axis=-1)


def mathieu_b(lam: Any, index: int = 0) -> Any:
    """The eigenvalue at μ = 0 by SciPy: b_{2 index + 1}(λ²/2), for real λ."""
    return special.mathieu_b(2 * whole("index", index) + 1, real("lam", lam) ** 2 / 2)


def band_edges(lam: Any, mu: Any = 0, count: int = 5) -> Any:
    """The lowest a with a solution of period π or 2π, in ascending order, on the last axis.

    Between the first and the second, the third and the fourth, … all solutions are bounded: these
    are the bands; between the second and the third, … are the gaps. Real lam and mu broadcast.

    >>> band_edges(0)                                       # 0, and all other squares twice
    array([0., 1., 1., 4., 4.])
    """
    n = np.arange(-24, 25)
    distance = abs(n[:, None] - n)
    q, s = (part[..., None, None] for part in _couplings(real("lam", lam), real("mu", mu)))
    matrix = np.diag(n**2.0) + q * (distance == 2) + s * (distance == 4)
    return np.linalg.eigvalsh(matrix)[..., :whole("count", count)]


def integrate(x: Any, a: Any, lam: Any, mu: Any = 0, start: ArrayLike = (0, 1)) -> Any:
    """ψ and ψ' at the real points x by the Runge-Kutta method DOP853, from ψ(0), ψ'(0) = `start`.

    Returns an array of shape (2,) + x.shape. a, lam and mu are single real numbers. Steps are short
    and local errors near rounding, so that some 1e-12 is lost over ten periods at λ = 2.

    >>> np.round(integrate([-np.pi, np.pi], a=1, lam=0), 12) + 0
    array([[ 0.,  0.],
           [-1., -1.]])
    """
    x, a, lam, mu = real("x", x), real("a", a), real("lam", lam), real("mu", mu)
    start = real("start", start)
    q, s = lam**2, lam**4 * mu

    def slope(x: Any, y: Any) -> Any:
        return y[1], (-a + q * np.cos(2 * x) + s * np.cos(4 * x)) * y[0]

    values = np.empty((2, x.size))
    for side in (x.ravel() < 0, x.ravel() >= 0):
        points, back = np.unique(x.ravel()[side], return_inverse=True)
        if points.size:
            end = points[np.argmax(abs(points))]
            path = solve_ivp(slope, (0, end), start, "DOP853", dense_output=True, **TOLERANCES)
            values[:, side] = path.sol(points)[:, back]
    return values.reshape((2, *x.shape))


def _couplings(lam: Any, mu: Any) -> Any:
    lam, mu = np.asarray(lam), np.asarray(mu)
    return np.broadcast_arrays(lam**2 / 2 + 0 * mu, lam**4 * mu / 2)


def _parts(size: int) -> Any:
    row, column = np.indices((size, size))
    matrices = [(abs(row - column) == j) * 1.0 - (row + column + 1 == j) for j in (1, 2)]
    return np.diag((1.0 + 2 * np.arange(size)) ** 2), *matrices


def _size(lam: Any, mu: Any, index: int, digits: int) -> Any:
    """The size at which ratios |c_{n+2}/c_n| of about q/n² + √s/n have made c_n negligible."""
    q, s = (np.max(abs(part)) for part in _couplings(lam, mu))
    gap = (3.0 + 2 * np.arange(index, LARGEST)) ** 2 - (2 * index + 1) ** 2
    ratio = np.minimum(1, q / gap + np.sqrt(s / gap))
    enough = np.cumsum(np.log10(ratio + 1e-300)) < -digits
    if not enough.any():
        raise InputError(f"lam and mu are too large for a Hill matrix of size {LARGEST}.")
    return index + int(np.argmax(enough)) + 3


def _eigenpair(lam: Any, mu: Any, index: int) -> Any:
    lam, mu = _finite("lam", lam), _finite("mu", mu)
    matrix = hill_matrix(lam, mu, _size(lam, mu, index, 20))
    if np.iscomplexobj(matrix):
        vector = _followed(lam, mu, index, matrix.shape[-1])
    else:
        vector = np.linalg.eigh(matrix)[1][..., index]
    image = np.einsum("...ij,...j->...i", matrix, vector)  # Rayleigh's quotient loses no digit
    return np.sum(vector * image, -1) / np.sum(vector**2, -1), vector


def _followed(lam: Any, mu: Any, index: int, size: int, steps: int = 64) -> Any:
    """The eigenvector followed from λ = 0; a linear forecast picks the eigenvalue at each step."""
    before: Any = float((2 * index + 1) ** 2)
    now = before
    for part in np.linspace(0, 1, steps + 1)[1:]:
        values, vectors = np.linalg.eig(hill_matrix(part * lam, mu, size))
        forecast = np.asarray(2 * now - before)[..., None]
        nearest = np.argmin(abs(values - forecast), axis=-1, keepdims=True)
        before, now = now, np.take_along_axis(values, nearest, -1)[..., 0]
    return np.take_along_axis(vectors, nearest[..., None, :], -1)[..., 0]


def _eigenpair_in_digits(lam: Any, mu: Any, index: int) -> Any:
    """Rayleigh's quotient iteration from the float64 pair: each step triples the correct digits."""
    lam, mu = number("lam", lam), number("mu", mu)
    kind = complex if mpmath.im(lam) or mpmath.im(mu) else float
    rough = kind(lam), kind(mu), index
    size = _size(*rough, mpmath.mp.dps)
    squares, first, second = map(mpmath.matrix, _parts(size))
    matrix = squares + lam**2 / 2 * first + lam**4 * mu / 2 * second
    vector = mpmath.matrix(list(_eigenpair(*rough)[1]) + [0] * size)[:size]
    with working(digits=mpmath.mp.dps + GUARD):
        for _ in range(20):
            vector /= mpmath.norm(vector)
            image = matrix * vector
            a = (vector.T * image)[0] / (vector.T * vector)[0]
            if mpmath.norm(image - a * vector) < mpmath.mpf(10) ** (GUARD - mpmath.mp.dps):
                return a, vector
            vector = mpmath.lu_solve(matrix - a * mpmath.eye(size), vector)
    raise ArithmeticError("Rayleigh's quotient iteration did not converge")


def _leading(coefficient: Any) -> Any:
    if np.any(abs(coefficient) < 1e-12):
        raise InputError("The leading sine is absent from the eigenfunction at this lam and mu.")
    return coefficient


def _finite(name: str, value: Any) -> Any:
    value = np.asarray(value)
    if not np.iscomplexobj(value):
        return real(name, value)
    return real(name, value.real) + 1j * real(name, value.imag)
