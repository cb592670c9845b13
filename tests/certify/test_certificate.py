"""Certificates as files: what is damaged is refused before anything is proved."""

import json

import pytest
from flint import arb

from ftseries.certify import certificate, check, cubic_bound
from ftseries.errors import FileError


@pytest.fixture
def saved(tmp_path):
    path = tmp_path / "theorem.json"
    cubic_bound(1, "0.5", 6).save(path)
    return path


def test_numbers_and_balls_survive():
    for x in (arb(0), arb("0.1"), arb(-3), arb(2) ** -300):
        assert certificate.number(certificate.exact(x)) == x.mid()
    ball = arb("0.1", "1e-9")
    again = certificate.read_ball(certificate.ball(ball))
    assert again.contains(ball) and again.rad() < ball.rad() * 1.001


def test_every_cut_is_refused(saved):
    text = saved.read_text()
    for n in range(0, len(text), 29):
        saved.write_text(text[:n])
        with pytest.raises(FileError):
            check(saved)


def test_a_changed_digit_is_refused(saved):
    text = saved.read_text()
    i = text.index('"modes"') + 15
    while not text[i].isdigit():
        i += 1
    saved.write_text(text[:i] + str((int(text[i]) + 1) % 10) + text[i + 1:])
    with pytest.raises(FileError, match="checksum"):
        check(saved)


@pytest.mark.parametrize("change, message", [
    ({"theorem": "Fermat"}, "unknown kind"), ({"precision": 10**9}, "from 53 to"),
    ({"modes": None}, "damaged"), ({"lam": "1/0"}, "damaged"), ({"radius": "x"}, "damaged"),
])
def test_nonsense_with_a_fresh_checksum(saved, change, message):
    certificate.write(saved, certificate.read(saved) | change)
    with pytest.raises(FileError, match=message):
        check(saved)


def test_other_files(tmp_path):
    path = tmp_path / "other.json"
    for content in ({}, [], {"format": "ftseries certificate", "version": 9}):
        path.write_text(json.dumps(content))
        with pytest.raises(FileError, match="certificate|version"):
            check(path)
    with pytest.raises(FileError, match="cannot read"):
        check(tmp_path / "nothing.json")
    with pytest.raises(FileError, match="cannot write"):
        cubic_bound(1, "0.5", 3).save(tmp_path / "no" / "folder.json")
