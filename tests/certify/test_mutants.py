"""No altered certificate states what is not true; see :mod:`certify.mutants` for all of them."""

import hashlib
import json
import time

import pytest
from certify import mutants
from certify.altering import REFUSED

from ftseries.certify import NotProved, certificate, check, grammar
from ftseries.certify.digits import STORED
from ftseries.errors import FileError

#: so many of each, by name: a check of the last two takes a second
COUNTS = {"cubic": 150, "cubic, a = 3": 50, "eigenvalue": 150, "eigenvalue, λ = 1/2": 50,
          "eight": 40, "convergence": 6, "digits": 15}


@pytest.mark.parametrize("name", COUNTS)
def test_the_certificate_itself_is_accepted_and_true(name, tmp_path):
    data = mutants.certificates()[name]
    assert mutants.outcome(data, tmp_path / "x.json").startswith("Checked") and mutants.true(data)


@pytest.mark.parametrize("name", COUNTS)
def test_a_sample_of_mutants_is_refused_or_true_and_soon(name, tmp_path):
    results = list(mutants.tried(name, mutants.sample(name, COUNTS[name]), tmp_path / "x.json"))
    assert [result for result in results if result[2] not in ("refused", "accepted")] == []
    assert sum(result[2] == "refused" for result in results) > len(results) / 2


def doubled(data):
    for name in ("lambda_0", "y_1"):
        data["decimals"][name] = "--" + data["decimals"][name].lstrip("-")


def last_digit(data):
    """One more in the last digit and two signs: what was accepted once."""
    text = data["decimals"]["lambda_0"]
    data["decimals"]["lambda_0"] = "--" + text[:-1] + str((int(text[-1]) - 1) % 10)


#: several entries at once: the hypotheses of the theorems, and statements that only look alike
SEVERAL = {
    "a < 0": ("cubic", lambda d: d.update(a="-1", lam="-1/2")),
    "a < 0, λ > 0": ("cubic", lambda d: d.update(a="-1")),
    "λ = 0": ("cubic", lambda d: d.update(lam="0")),
    "λ = 3a": ("cubic", lambda d: d.update(lam="3", radius="1 5")),
    "not in lowest terms": ("cubic", lambda d: d.update(a="2/2", lam="2/4")),
    "another order": ("cubic", lambda d: d.update(order=7, radius="1 5")),
    "another order, cut": ("cubic", lambda d: d.update(order=7, modes=d["modes"][:-1],
                                                       radius="1 5")),
    "another order, filled": ("cubic", lambda d: d.update(order=9, modes=[*d["modes"], "0"],
                                                          radius="1 5")),
    "an order that is a float": ("cubic", lambda d: d.update(order=8.0)),
    "the modes of another series": ("cubic", lambda d: d.update(
        modes=mutants.certificates()["cubic, a = 3"]["modes"], order=4, radius="1 5")),
    "the series with λ for -λ": ("cubic", lambda d: d.update(lam="-1/2", modes=[
        c if n % 2 == 0 else "-" + c for n, c in enumerate(d["modes"])])),
    "a negative radius": ("eigenvalue", lambda d: d.update(a=[d["a"][0], "-" + d["a"][1]])),
    "the second eigenvalue": ("eigenvalue", lambda d: d.update(a=["7 0", "1 2"], beta="1 6")),
    "signs doubled": ("digits", doubled),
    "a wrong last digit": ("digits", last_digit),
    "digits without a zero": ("digits", lambda d: d["decimals"].update(
        x_1=d["decimals"]["x_1"].replace("0.", "."))),
    "fewer digits": ("digits", lambda d: d.update(digits=11)),
    "another theorem inside": ("digits", lambda d: d["eight"].update(theorem="convergence")),
    "modes given twice": ("eight", lambda d: d["center"].append(d["center"][-1])),
    "modes in another order": ("eight", lambda d: d["center"].reverse()),
    "a mode of a million": ("eight", lambda d: d["root"].append([10**6, "1 -300"])),
    "a radius that is a float": ("convergence", lambda d: d.update(lam=1.0)),
    "a radius that is a ball": ("convergence", lambda d: d.update(lam="1 +/- 1e-20")),
    "a sum that is not claimed": ("convergence", lambda d: d["norms"].update(psi="1 0")),
    "a remark": ("eigenvalue", lambda d: d.update(remark="so all odd solutions are known")),
    "a claim that is missing": ("eight", lambda d: d.pop("velocities")),
}


@pytest.mark.parametrize("name", SEVERAL)
def test_several_entries(name, tmp_path):
    kind, change = SEVERAL[name]
    data = json.loads(json.dumps(mutants.certificates()[kind]))
    change(data)
    certificate.write(tmp_path / "x.json", data)
    start = time.perf_counter()
    with pytest.raises((NotProved, FileError), match=REFUSED):
        check(tmp_path / "x.json")
    assert time.perf_counter() - start < 5


def test_a_decimal_out_of_form_is_refused_before_the_proof(tmp_path):
    """The proof of a thousand digits takes ten seconds."""
    data = certificate.read(STORED)
    data["decimals"]["energy"] += " "
    certificate.write(tmp_path / "x.json", data)
    start = time.process_time()
    with pytest.raises(FileError, match="is not cut after 1000 digits"):
        check(tmp_path / "x.json")
    assert time.process_time() - start < 2


def test_a_theorem_in_other_units_is_true(tmp_path):
    """a and λ doubled: the same amplitudes in units of a."""
    data = mutants.certificates()["cubic"] | {"a": "2", "lam": "1"}
    assert "At a = 2, λ = 1 " in mutants.outcome(data, tmp_path / "x.json") and mutants.true(data)


@pytest.mark.parametrize("old, new", [
    ('"order": 8', '"order": 8, "order": 8'), ('"order": 8', '"order": NaN'),
    ('"order": 8', '"order": Infinity'), ('"version": 1', '"version": true'),
    ('"version": 1', '"version": 1.0')])
def test_json_is_read_strictly(old, new, tmp_path):
    path = tmp_path / "x.json"
    data = mutants.certificates()["cubic"]
    certificate.write(path, data)
    text = path.read_text().replace(old, new, 1)
    kept = json.loads(text)
    sha = kept.pop("sha256")
    fresh = hashlib.sha256(json.dumps(kept, sort_keys=True).encode()).hexdigest()
    path.write_text(text.replace(sha, fresh))
    with pytest.raises(FileError, match="damaged|version"):
        check(path)


@pytest.mark.parametrize("read, good, bad", [
    (grammar.rational, ["0", "7", "-3/10"], ["-0", "+7", "07", "7/1", "2/4", "1/-2", "0/3", "1 /2",
                                             "7\n", "٣", "1_0", "", "1e3", "0.5", 7, None, True]),
    (grammar.decimal, ["0", "2", "1.02", "2.080"], ["-1", "01", ".5", "1.", "1e0", "1 +/- 1", "nan",
                                                    "1.0\n", "9" * 5001, 1.02, 2]),
    (grammar.dyadic, ["0 0", "1 0", "-3 -17"], ["0 1", "2 0", "1  0", "1 -0", "--1 0", "1 01", "1",
                                                "1 0 0", " 1 0", "1 1234567", "01 0", [1, 0]]),
    (grammar.ball, [["0 0", "0 0"], ["-1 3", "1 -9"]], [["1 0"], ["1 0", "-1 -9"], "1 0", None]),
    (lambda text: grammar.cut(text, 2), ["0.00", "-1.29", "10.05"], [
        "-0.00", "00.12", ".12", "1.2", "1.234", "--1.29", "+1.29", " 1.29", "1,29", "1.2e", 1.29]),
    (lambda value: grammar.whole(value, 0, 9), [0, 9], [-1, 10, True, 1.0, "1", None]),
    (lambda value: grammar.modes(value, 9), [[[0, 1]], [[1, "x"], [5, "y", "z"]]],
     [[], [[1]], [[10, 1]], [[1, 1], [1, 2]], [[2, 1], [1, 2]], [[True, 1]], {"1": 2}]),
])
def test_grammar(read, good, bad):
    for value in good:
        read(value)
    for value in bad:
        with pytest.raises(ValueError):
            read(value)


def test_what_is_written_obeys_the_grammar():
    for x in ("0", "0.1", "-3", "1e300", "1e-300"):
        assert certificate.exact(certificate.number(certificate.exact(certificate.arb(x)))) == \
            certificate.exact(certificate.arb(x))
