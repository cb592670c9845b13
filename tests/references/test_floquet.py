"""Monodromy matrices by power series: closed forms, Wronskian, symplecticity."""

import mpmath
import numpy as np
import pytest

from ftseries.errors import InputError
from ftseries.references import floquet, mathieu


def test_hill_without_a_potential():
    with mpmath.workdps(40):
        exact = mpmath.matrix([[0, 2], [-0.5, 0]])  # a = 1/4 over π: cos(π/2), sin(π/2)/k, …
        gap = floquet.hill_monodromy("0.25", 0, dps=40) - exact
        assert mpmath.mnorm(gap) < 1e-38


def test_hill_has_a_constant_wronskian():
    with mpmath.workdps(40):
        m = floquet.hill_monodromy(2, 2, "-0.3", dps=40)
        assert abs(mpmath.det(m) - 1) < 1e-37


def test_hill_agrees_with_the_matrix_eigenvalue_in_50_digits():
    a = mathieu.eigenvalue(2, "-0.3", dps=50)
    with mpmath.workdps(50):
        m = floquet.hill_monodromy(a, 2, "-0.3", dps=50)
        assert abs(m[0, 1]) < 1e-46 and abs(m[0, 0] + 1) < 1e-46  # dD/da is about 100


def test_hill_over_several_ends():
    """From -π/2 to 0 it is the same as from π/2 to π."""
    with mpmath.workdps(30):
        half = floquet.hill_monodromy(3, 1, "0.2", mpmath.pi / 2)
        back = floquet.hill_monodromy(3, 1, "0.2", -mpmath.pi / 2)
        whole = floquet.hill_monodromy(3, 1, "0.2")
        assert mpmath.mnorm(back**-1 * half - whole) < 1e-27


def test_hill_refuses_what_is_too_large():
    with pytest.raises(InputError, match="too large"):
        floquet.hill_monodromy(1, 1000)


def test_eight_is_symplectic_and_keeps_its_symmetries():
    m = floquet.figure_eight_monodromy()
    j = np.block([[np.zeros((6, 6)), np.eye(6)], [-np.eye(6), np.zeros((6, 6))]])
    np.testing.assert_allclose(m.T @ j @ m, j, rtol=0, atol=1e-9)
    shift = np.tile([1.0, 0.0], 3)
    np.testing.assert_allclose(m @ np.r_[shift, 0 * shift], np.r_[shift, 0 * shift],
                               rtol=0, atol=1e-10)
    np.testing.assert_allclose(m @ np.r_[0 * shift, shift], np.r_[2 * np.pi * shift, shift],
                               rtol=0, atol=1e-10)
