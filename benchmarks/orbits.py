"""The figure eight by other methods: shooting with two integrators, and Fourier collocation.

Shooting varies r_1 and v_3 at t = 0 until after a twelfth of the period body 1 crosses the y-axis
horizontally and the other two mirror each other.  All start from three digits and give the
positions, of shape (3,) + t.shape, with period 2π.
"""

from functools import cache

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import root

#: real and imaginary parts of r_1 and v_3 at t = 0, to three digits
START = np.array([-0.242, 0.966, -0.867, -0.935])
#: Fourier coefficients 1, 2, 4, 5 of r_3 = x + iy, to two digits; x has the even, y the odd ones
GUESS = {1: -1.10, 2: -0.34, 4: -0.056, 5: 0.025}
TOLERANCE = 1e-13


def state(start):
    """The twelve numbers (x, y of bodies 1, 2, 3; then their velocities) from the four unknowns."""
    r, v = start[:2], start[2:]
    return np.concatenate([r, -r, 0 * r, -v / 2, -v / 2, v])


def mismatch(end):
    """What vanishes at the end of the arc."""
    r, v = end[:6].reshape(3, 2), end[6:].reshape(3, 2)
    return np.array([r[0, 0], v[0, 1], r[1, 1] - r[2, 1], v[1, 0] - v[2, 0]])


def shooting(flow, t):
    """Positions at times t by the ``flow`` (state, times) → states."""
    arc = np.array([0.0, np.pi / 6])
    found = root(lambda start: mismatch(flow(state(start), arc)[-1]), START, tol=1e-15)
    path = flow(state(found.x), t)[:, :6].reshape(-1, 3, 2)
    return (path[..., 0] + 1j * path[..., 1]).T


def runge_kutta(start, times):
    """The flow by SciPy's DOP853."""
    def slope(_, y):
        r = y[0:6:2] + 1j * y[1:6:2]
        d = r - r[:, None]
        a = (d / (np.abs(d) ** 3 + np.eye(3))).sum(1)
        return np.concatenate([y[6:], np.stack([a.real, a.imag], axis=1).ravel()])
    return solve_ivp(slope, (0, times[-1]), start, "DOP853", t_eval=times, rtol=TOLERANCE,
                     atol=TOLERANCE / 100).y.T


@cache
def taylor():
    """The flow by heyoka's Taylor method; its code is compiled here."""
    import heyoka as hy
    names = [f"{v}{c}{i}" for v in ("", "v") for i in range(3) for c in "xy"]
    q = dict(zip(names, hy.make_vars(*names), strict=True))
    system = [(q[n], q["v" + n]) for n in names[:6]]
    for i in range(3):
        for c in "xy":
            system.append((q[f"v{c}{i}"], hy.sum([
                (q[f"{c}{j}"] - q[f"{c}{i}"])
                * hy.sum([(q[f"{d}{j}"] - q[f"{d}{i}"]) ** 2 for d in "xy"]) ** -1.5
                for j in range(3) if j != i])))
    integrator = hy.taylor_adaptive(system, [1.0] * 12)

    def flow(start, times):
        integrator.time, integrator.state[:] = times[0], start
        return integrator.propagate_grid(times)[-1]
    return flow


def collocation(t, top=70):
    """Positions at times t: Newton's method for the Fourier coefficients of r_3(t) = r_1(t + 2π/3)
    = r_2(t - 2π/3), x odd with even orders, y odd with odd orders, none divisible by three."""
    n = np.array([k for k in range(1, top) if k % 3])
    weight = np.where(n % 2, 1j, 1)
    times = np.pi / 2 * (np.arange(top // 2) + 0.5) / (top // 2)
    here, before, after = (weight * np.sin(np.outer(times + s, n))
                           for s in (0, -2 * np.pi / 3, 2 * np.pi / 3))
    c = np.array([GUESS.get(k, 0.0) for k in n])
    for _ in range(12):
        residual, matrix = -(here * n**2) @ c, -here * n**2
        for other in (before, after):
            step = other - here
            d = step @ c
            size = np.abs(d)[:, None]
            residual = residual - d / np.abs(d) ** 3
            matrix = matrix - (step / size**3
                               - 3 * d[:, None] * (d.conj()[:, None] * step).real / size**5)
        delta = np.linalg.lstsq(np.concatenate([matrix.real, matrix.imag]),
                                -np.concatenate([residual.real, residual.imag]), rcond=None)[0]
        c = c + delta
        if np.abs(delta).max() < 1e-12:
            break
    shifts = np.array([-2, 2, 0]) * np.pi / 3
    return np.sin(np.add.outer(shifts, t)[..., None] * n) @ (weight * c)
