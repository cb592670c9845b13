"""A hundred random problems of sixteen kinds, against the equations as text and an integration."""

import pytest
import random_problems
from flint import fmpq
from random_problems import KINDS, Wrong, judged, make, solved, verify

COUNT = 7 * len(KINDS)


@pytest.mark.parametrize("first", range(0, COUNT, len(KINDS)))
def test_random_problems(first):
    """None is wrong, and most are solved; every refusal is one of ftseries."""
    verdicts = [judged(number) for number in range(first, first + len(KINDS))]
    assert not [(case.kind, case.equations, detail) for verdict, case, detail in verdicts
                if verdict not in ("right", "refused")]
    assert sum(verdict == "right" for verdict, *_ in verdicts) >= len(KINDS) // 2


@pytest.mark.parametrize("number", range(len(KINDS)))
def test_the_verifier_sees_a_wrong_coefficient(number):
    """Any unknown, altered by a part in a thousand of the largest coefficient."""
    case = make(number)
    while judged(number)[0] != "right":
        number += len(KINDS)
        case = make(number)
    for name in case.unknowns:
        solution = solved(case)
        m = len(case.problem().first_coefficients()[name])
        row = next((row for row in solution.coefficients[name][m:case.order - 1] if row), None)
        if row is None:
            continue
        mode = next(iter(row))
        row[mode] = row[mode] + fmpq(1, 1000) * (1 if hasattr(row[mode], "p") else row[mode])
        with pytest.raises(Wrong):
            verify(case, solution)


def test_equations_as_python():
    assert random_problems.python("x'' + 3/4*y' = x**2/2") == "(x_2 + Q(3, 4)*y_1 ) - ( x**2/2)"
