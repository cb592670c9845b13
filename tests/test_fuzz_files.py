"""Altered solution files and certificates, their checksums renewed: refused in time, or right.

`make test` tries 150 of them, `make fuzz` some thousands.
"""

import contextlib
import json
import signal
import warnings
from pathlib import Path

import fuzz
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import ftseries as fts
from ftseries import certify

DATA = Path(__file__).parent / "data"
SOLUTIONS = [json.loads(path.read_text()) for path in sorted(DATA.glob("*.json"))]
#: of one file, on a busy machine
SECONDS = 20


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return tmp_path_factory.mktemp("fuzz") / "altered.json"


@given(text=fuzz.altered(SOLUTIONS, st.one_of(fuzz.ATOMS, fuzz.ATOMS, fuzz.ABSURD)))
@settings(max_examples=fuzz.TRIES)
def test_a_file_is_refused_or_holds_a_solution(path, text):
    """What is loaded is what solving the same problem gives."""
    path.write_text(text)
    with fuzz.limited(SECONDS), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            found = fts.load(path)
        except fts.FileError as error:
            assert "\n" not in str(error) and len(str(error)) < 2000
            return
        again = fts.solve(found.problem, found.order, found.arithmetic,
                          precision=found.precision or 128)
    for name, rows in again.coefficients.items():
        for row, other in zip(rows, found.coefficients[name], strict=True):
            for mode in {*row, *other}:
                a, b = row.get(mode, 0), other.get(mode, 0)
                if found.arithmetic == "ball":
                    assert (a - b).contains(0)
                else:                   # float: a thousand times what rounding does
                    assert a == b or found.arithmetic == "float" and abs(a - b) < 1e-9


@pytest.fixture(scope="module")
def proofs(tmp_path_factory):
    """Small certificates, as data."""
    folder = tmp_path_factory.mktemp("proofs")
    certify.cubic_bound(1, "0.5", 6).save(folder / "cubic.json")
    certify.mathieu_eigenvalue(1, "-0.3", digits=4).save(folder / "mathieu.json")
    return [json.loads(path.read_text()) for path in sorted(folder.iterdir())]


@given(data=st.data())
@settings(max_examples=fuzz.TRIES)
def test_a_certificate_is_refused_or_checked(path, proofs, data):
    path.write_text(data.draw(fuzz.altered(proofs)))
    with fuzz.limited(SECONDS):
        try:
            assert certify.check(path).startswith("Checked. ")
        except fts.FTSeriesError as error:
            assert "\n" not in str(error)


@pytest.mark.skipif(not hasattr(signal, "SIGVTALRM"), reason="no clock of computing time")
def test_what_hangs_is_stopped_and_nothing_swallows_it():
    with pytest.raises(fuzz.Hung), fuzz.limited(0.1):
        while True:
            with contextlib.suppress(Exception):
                sum(range(1000))
