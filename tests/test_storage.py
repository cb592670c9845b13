"""Saved solutions come back bit for bit; damage of any kind is refused; writing is atomic."""

import json
import os
import random
import re
import time
import warnings
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

import flint
import pytest
import sample_problems
import sympy as sp
from sample_problems import Duffing, LotkaVolterra, MassOnSpring

import ftseries as fts
from ftseries import FileError, FTSeriesError

KINDS = {
    "rational": (fts.CubicOscillator, "exact"), "polynomial": (fts.GeneralizedMathieu, "exact"),
    "own parameter": (MassOnSpring, "exact"), "both kinds": (LotkaVolterra, "exact"),
    "mu a number": (lambda: fts.GeneralizedMathieu("-3/10"), "float"),
    "a with a root": (lambda: fts.CubicOscillator(2 * sp.sqrt(3) / 7), "exact"),
    "float": (fts.FigureEight, "float"), "ball": (fts.FigureEight, "ball"),
}


@pytest.fixture
def saved(tmp_path):
    """A small file and its bytes."""
    path = tmp_path / "duffing.json"
    fts.solve(Duffing(), 3).save(path)
    return path, path.read_bytes()


@pytest.mark.parametrize("kind", KINDS)
def test_there_and_back(tmp_path, kind):
    make, arithmetic = KINDS[kind]
    solution = fts.solve(make(), 12, arithmetic, precision=200)
    path = tmp_path / "solution.json"
    solution.save(path)
    for back in (fts.load(path), fts.load(str(path)), fts.load(path, problem=make())):
        assert (back.order, back.arithmetic, back.precision) == (12, arithmetic,
                                                                 solution.precision)
        assert repr(back) == repr(solution)
        if arithmetic == "ball":
            assert all(x.mid() == y.mid() and x.rad() <= y.rad() <= x.rad() * (1 + 2**-28)
                       for name, rows in solution.coefficients.items()
                       for row, other in zip(rows, back.coefficients[name], strict=True)
                       for (mode, x), y in zip(sorted(row.items()),
                                               [other[m] for m in sorted(other)], strict=True))
        else:
            assert back.coefficients == solution.coefficients
    back.save(path)
    assert fts.load(path).truncate(4).order == 4


def test_a_symbol_comes_back_positive(tmp_path):
    a = sp.Symbol("a", positive=True)
    solution = fts.solve(fts.CubicOscillator(a), 6)
    solution.save(tmp_path / "a.json")
    back = fts.load(tmp_path / "a.json")
    assert back.problem.a == a
    assert back.coefficient("omega", 4) == solution.coefficient("omega", 4)


def test_exact_numbers_are_texts(saved):
    data = json.loads(saved[1])
    assert data["coefficients"]["x"][3] == [[0, 3, "1/32"]]
    assert data["coefficients"]["omega"][2] == [[0, 0, "3/8"]]


def test_balls_at_other_precision_than_the_one_in_force(tmp_path):
    """600 bits survive although FLINT works with 53 when the file is read."""
    solution = fts.solve(fts.FigureEight(), 8, "ball", precision=600)
    solution.save(tmp_path / "b.json")
    back = fts.load(tmp_path / "b.json")
    assert flint.ctx.prec == 53
    x, y = (s.coefficients["phi"][3][0, 3] for s in (solution, back))
    assert x.mid() == y.mid() and x.rad() <= y.rad() and float(y.rad()) < 1e-150


# --- damage -------------------------------------------------------------------------------------

def test_every_truncation_is_refused(saved):
    path, content = saved
    for length in range(len(content)):
        path.write_bytes(content[:length])
        with pytest.raises(FileError) as caught:
            fts.load(path)
        assert "duffing.json" in str(caught.value) and "\n" not in str(caught.value)


def test_every_changed_byte_is_refused_or_harmless(saved):
    """One bit of every byte in turn: never another solution."""
    path, content = saved
    original = fts.load(path)
    source = random.Random(1)
    for position in range(len(content)):
        damaged = bytearray(content)
        damaged[position] ^= 1 << source.randrange(8)
        path.write_bytes(bytes(damaged))
        try:
            back = fts.load(path)
        except FTSeriesError as error:
            assert isinstance(error, FileError) and "\n" not in str(error)
        else:                                        # a blank became another blank, say
            assert back.coefficients == original.coefficients
            assert repr(back) == repr(original)


@pytest.mark.parametrize("change", [
    lambda d: d["coefficients"]["x"][3].__setitem__(0, [0, 3, "1/33"]),
    lambda d: d["coefficients"]["x"][3].clear(),
    lambda d: d["coefficients"]["x"].pop(),
    lambda d: d["coefficients"].pop("omega"),
    lambda d: d.__setitem__("order", 2),
    lambda d: d.__setitem__("order", -1),
    lambda d: d.__setitem__("arithmetic", "float"),
    lambda d: d.__setitem__("precision", 10),
    lambda d: d["problem"].__setitem__("name", "Pendulum"),
    lambda d: d["problem"].__setitem__("arguments", {"a": "2"}),
    lambda d: d.pop("problem"),
    lambda d: d.pop("sha256"),
    lambda d: d.__setitem__("sha256", "0" * 64),
    lambda d: d.__setitem__("extra", 1),
])
def test_a_changed_file_is_refused(saved, change):
    path, content = saved
    data = json.loads(content)
    change(data)
    path.write_text(json.dumps(data))
    with pytest.raises(FileError, match="checksum"):
        fts.load(path)


@pytest.mark.parametrize("change, words", [
    (lambda d: d["coefficients"]["x"].pop(), "instead of 4"),
    (lambda d: d["coefficients"].pop("omega"), "damaged"),
    (lambda d: d.__setitem__("arithmetic", "decimal"), "damaged"),
    (lambda d: d["problem"].__setitem__("arguments", {"b": 1}),
     r"^Duffing\(b=1\) cannot be made again .*give load\(path, problem=…\)$"),
    (lambda d: d["problem"].__setitem__("name", "Unheard"), "'Unheard', which is not known here"),
    (lambda d: d.pop("problem"), "damaged"),
    (lambda d: d.__setitem__("coefficients", []), "damaged"),
    (lambda d: d["coefficients"]["x"][3].__setitem__(0, [0, 3, 0.5]), "not an exact number"),
    (lambda d: d["coefficients"]["x"][3].__setitem__(0, [0, 3]), "damaged"),
    (lambda d: d["coefficients"]["x"][3].__setitem__(0, [0, 3, "1/0"]), "damaged"),
])
def test_nonsense_with_a_right_checksum(saved, change, words):
    """Written by a program that is not ours."""
    from ftseries.jsonfile import digest
    path, content = saved
    data = json.loads(content)
    change(data)
    data.pop("sha256")
    path.write_text(json.dumps(data | {"sha256": digest(data)}))
    with pytest.raises(FileError, match=words):
        fts.load(path)


@pytest.mark.parametrize("text, words", [
    ("", "not JSON"), ("{", "not JSON"), ("hello", "not JSON"), ("\x00\x01", "not JSON"),
    ("[" * 100000, "not JSON"),
    ("null", "not a saved ftseries solution"), ("[]", "not a saved ftseries solution"),
    ("3", "not a saved ftseries solution"), ('{"a": 1}', "not a saved ftseries solution"),
    ('{"format": "other", "version": 1}', "not a saved ftseries solution"),
    ('{"format": "ftseries"}', "version None"),
    ('{"format": "ftseries", "version": 2}', "version 2"),
    ('{"format": "ftseries", "version": "1"}', "version '1'"),
    ('{"format": "ftseries", "version": 1}', "checksum"),
    ('{"format": "ftseries", "version": 1.0}', "version"),
    ('{"format": "ftseries", "version": NaN}', "NaN is no number"),
    ('{"format": "ftseries", "version": 1, "version": 1}', "stands twice"),
])
def test_foreign_files(tmp_path, text, words):
    path = tmp_path / "foreign.json"
    path.write_text(text)
    with pytest.raises(FileError, match=words):
        fts.load(path)


def test_bytes_that_are_no_text(tmp_path):
    path = tmp_path / "latin.json"
    path.write_bytes(b'{"format": "\xff\xfe"}')
    with pytest.raises(FileError, match="not JSON"):
        fts.load(path)


def test_no_file_and_a_folder(tmp_path):
    with pytest.raises(FileError, match="cannot read .*No such file"):
        fts.load(tmp_path / "nothing.json")
    with pytest.raises(FileError, match="cannot read"):
        fts.load(tmp_path)


def test_the_problem_must_fit(tmp_path):
    path = tmp_path / "c.json"
    fts.solve(fts.CubicOscillator(), 3).save(path)
    with pytest.raises(FileError, match=r"CubicOscillator\(a=1\), not of FigureEight\(\)"):
        fts.load(path, problem=fts.FigureEight())
    with pytest.raises(FileError, match=r"CubicOscillator\(a=1\), not of CubicOscillator\(a=2\)"):
        fts.load(path, problem=fts.CubicOscillator(2))
    with pytest.raises(FileError, match="not of 3"):
        fts.load(path, problem=3)


def spring(force, **attributes):
    """A problem with a constructor, as a reader may write it (and write it anew)."""
    def __init__(self, b):
        self.b = b

    def equations(self, lam, x, omega):
        return {"(spring)": omega**2 * x.diff(2) + x + self.b * force(x)}
    return type("Spring", (Duffing,), {"__init__": __init__, "equations": equations} | attributes)


@pytest.fixture
def forget_spring():
    yield
    fts.Problem.classes.pop("Spring", None)


ARGUMENTS = {"arguments": lambda self: {"b": self.b}}


def test_a_problem_that_does_not_say_its_arguments_is_not_saved(tmp_path, forget_spring):
    solution = fts.solve(spring(lambda x: x**3)(2), 4)
    with pytest.raises(FileError, match="^a solution of Spring cannot be saved, because it does "
                                        "not say which b it was made with; define its method "
                                        r"arguments, such as def arguments\(self\): return "
                                        "{'b': self.b}$"):
        solution.save(tmp_path / "s.json")
    assert list(tmp_path.iterdir()) == []
    derived = type("Spring", (fts.CubicOscillator,),
                   {"__init__": lambda self, a, b: fts.CubicOscillator.__init__(self, a)})
    with pytest.raises(FileError, match="which a, b it was made with"):
        fts.solve(derived(1, 2), 2).save(tmp_path / "s.json")


def test_a_problem_with_arguments_comes_back(tmp_path, forget_spring):
    kind, path = spring(lambda x: x**3, **ARGUMENTS), tmp_path / "s.json"
    solution = fts.solve(kind(2), 6)
    solution.save(path)
    assert fts.load(path).coefficients == solution.coefficients and fts.load(path).problem.b == 2
    with pytest.raises(FileError, match=r"of Spring\(b=2\), not of Spring\(b=3\)"):
        fts.load(path, problem=kind(3))
    spring(lambda x: x**3)                                   # now it is not known how to make one
    fts.Problem.classes["Spring"] = type("Spring", (Duffing,), {})
    with pytest.raises(FileError, match=r"^Spring\(b=2\) cannot be made again"):
        fts.load(path)
    assert fts.load(path, problem=kind(2)).order == 6


@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
@pytest.mark.parametrize("force, order", [(lambda x: x**3 / 2, 3), (lambda x: x**3 + x**5, 5),
                                          (lambda x: x + x**3, 1), (lambda x: x**3 + x**8, 8)])
def test_a_class_that_was_changed_since(tmp_path, forget_spring, arithmetic, force, order):
    path = tmp_path / "s.json"
    old = spring(lambda x: x**3, **ARGUMENTS)
    fts.solve(old(2), 12, arithmetic).save(path)
    new = spring(force, **ARGUMENTS)
    for problem in (None, new(2)):
        with pytest.raises(FileError, match=r"^the coefficients in the file contradict equation "
                                            rf"\(spring\) of Spring\(b=2\) at order {order} of λ"):
            fts.load(path, problem=problem)
    assert fts.load(path, problem=old(2)).order == 12


def test_a_class_with_a_free_parameter_that_was_changed_since(tmp_path, forget_spring):
    def mass(force):
        return type("Spring", (Duffing,), {"parameters": ("mu",), "equations": lambda
                    self, lam, x, omega, mu: {"(s)": omega**2 * x.diff(2) + x + force(x, mu)}})
    path = tmp_path / "s.json"
    fts.solve(mass(lambda x, mu: mu * x**3)(), 4).save(path)
    assert str(fts.load(path).coefficient("omega", 2)) == "3*mu/8"
    mass(lambda x, mu: mu**2 * x**3)
    with pytest.raises(FileError, match=r"contradict equation \(s\) of Spring\(\) at order 3"):
        fts.load(path)


@pytest.mark.parametrize("path", [None, 7, 1.5, ["a"]])
def test_what_is_no_path(path):
    words = r"is not the name of a file; give a text such as 'solution.json' or a Path$"
    with pytest.raises(FileError, match=words):
        fts.load(path)
    with pytest.raises(FileError, match=words):
        fts.solve(Duffing(), 1).save(path)


def test_a_file_executes_nothing(tmp_path):
    """The length a is a text in the file: it may hold arithmetic and names, no calls."""
    from ftseries.jsonfile import digest
    path, trace = tmp_path / "evil.json", tmp_path / "trace"
    fts.solve(fts.CubicOscillator(), 1).save(path)
    data = json.loads(path.read_text())
    data.pop("sha256")
    data["problem"]["arguments"] = {"a": f"__import__('pathlib').Path({str(trace)!r}).touch()"}
    path.write_text(json.dumps(data | {"sha256": digest(data)}))
    with pytest.raises(FileError, match="not a number or a SymPy expression"):
        fts.load(path)
    assert not trace.exists()


# --- what a stranger may send -------------------------------------------------------------------

DATA = Path(__file__).parent / "data"


@pytest.mark.parametrize("kind, text", [
    ("exact", "<Solution of CubicOscillator(a=sqrt(3)/2), order 6, exact>"),
    ("parameters", "<Solution of GeneralizedMathieu(branch=a2), order 8, exact>"),
    ("float", "<Solution of FigureEight(exponent=0), order 8, float>"),
    ("ball", "<Solution of FigureEight(), order 6, ball, precision=100>"),
    ("equations", "<Solution of Equations(x - x'*(lam**2 - x**2) + x'' = 0), order 6, exact>"),
])
def test_files_of_version_0_1(kind, text):
    """Written by version 0.1.0; the coefficients are those of today."""
    solution = fts.load(DATA / f"{kind}.json")
    assert repr(solution) == text
    again = fts.solve(solution.problem, solution.order, solution.arithmetic,
                      precision=solution.precision or 128)
    for name, rows in again.coefficients.items():
        for m, row in enumerate(rows):
            for mode, c in row.items():
                old = solution.coefficients[name][m].get(mode, 0)
                if kind == "ball":
                    assert c.overlaps(old)
                else:
                    assert c == old or kind == "float" and abs(c - old) < 1e-15


def altered(path, change):
    """Change a file by a function of its contents, and renew the checksum."""
    from ftseries.jsonfile import digest
    data = json.loads(path.read_text())
    data.pop("sha256")
    change(data)
    path.write_text(json.dumps(data | {"sha256": digest(data)}))
    return path


def at(*keys):
    """A function that sets an entry of nested lists and dicts."""
    def change(data):
        for key in keys[:-2]:
            data = data[key]
        data[keys[-2]] = keys[-1]
    return change


#: those whose last coefficients are settled late: ω in the cubic, A_{0,2m} in the eight
LATE = {"cubic": fts.CubicOscillator, "eight": fts.FigureEight,
        "Mathieu": lambda: fts.GeneralizedMathieu("1/3"), "symbolic": fts.GeneralizedMathieu}


@pytest.mark.parametrize("kind, arithmetic", [("symbolic", "exact")] + [
    (kind, arithmetic) for kind in ("cubic", "eight", "Mathieu")
    for arithmetic in ("exact", "float", "ball")])
@pytest.mark.parametrize("order", [8, 30])
def test_every_order_counts(tmp_path, kind, arithmetic, order):
    """Coefficients of the last orders are altered by a thousandth, one at a time: all refused."""
    path, exact = tmp_path / "s.json", fts.solve(LATE[kind](), order).coefficients
    fts.solve(LATE[kind](), order, arithmetic).save(path)
    contents = path.read_text()
    assert fts.load(path).order == order
    tried = 0
    for name, rows in json.loads(contents)["coefficients"].items():
        for m in range(order - 3, order + 1):
            sizes = [abs(size(c[2])) for c in rows[m]]
            for i, (sine, n, c) in enumerate(rows[m]):
                if (sine, n) not in exact[name][m] or not sizes[i] > 1e-3 * max(sizes) or \
                        order == 30 and sizes[i] < max(sizes):
                    continue                    # in floats a small one may be rounding
                tried += 1
                altered(path, at("coefficients", name, m, i, 2, wrong(c)))
                with pytest.raises(FileError, match="contradict|differ"):
                    fts.load(path)
                path.write_text(contents)
    assert tried > 2


def size(c):
    """The size of a number as files have it, or of one term of a polynomial."""
    if isinstance(c, dict):
        return max(map(size, c.values()))
    return float(c if isinstance(c, float) else Fraction(c) if isinstance(c, str)
                 else int(c[0]) * Fraction(2) ** int(c[1]))


def wrong(c):
    """The number, a thousandth larger; of a polynomial, its first term."""
    if isinstance(c, dict):
        key = next(iter(c))
        return c | {key: wrong(c[key])}
    if isinstance(c, list):
        return [str(int(c[0]) * 1001), str(int(c[1]) - 10), *c[2:]] if int(c[0]) else c
    return c * 1.001 if isinstance(c, float) else str(Fraction(c) * Fraction(1001, 1000))


@pytest.mark.parametrize("problem, order", [
    (fts.GeneralizedMathieu(0, "b50"), 20), (fts.GeneralizedMathieu(0, "b7"), 60),
    (fts.Equations("x'' + x/(1 + x) = 0", frequency="omega", unknowns={
        "x": fts.Field("cos", fixed=(1,)), "omega": fts.Scalar()}), 40)], ids=repr)
def test_rounding_is_no_reason_to_refuse(tmp_path, problem, order):
    """Floats that have lost most of their digits: small late ones, small ones of large terms."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", fts.PrecisionWarning)
        solution = fts.solve(problem, order, "float")
    for cut in (order, order - 3, order // 2):
        solution.truncate(cut).save(tmp_path / "s.json")
        assert fts.load(tmp_path / "s.json").order == cut


def test_a_coefficient_is_compared_to_its_last_digits(tmp_path):
    """An exact number is altered by one part in 10^30."""
    path = tmp_path / "s.json"
    fts.solve(fts.CubicOscillator(), 20).save(path)
    c = json.loads(path.read_text())["coefficients"]["omega"][20][0][2]
    c = str(Fraction(c) * (1 + Fraction(1, 10**30)))
    altered(path, at("coefficients", "omega", 20, 0, 2, c))
    with pytest.raises(FileError, match="contradict|differ"):
        fts.load(path)


@pytest.mark.parametrize("branch", ["a1", "b3", "b900"])
def test_another_branch_of_mathieu(tmp_path, branch):
    path = tmp_path / "b1.json"
    fts.solve(fts.GeneralizedMathieu(0), 6).save(path)
    altered(path, at("problem", "arguments", "branch", branch))
    with pytest.raises(FileError, match="not those of the seed of Generalized.* for another seed"):
        fts.load(path)


@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
def test_another_seed(tmp_path, arithmetic):
    """x'' + 2x = λ cos 3t begins with -λ/7 cos 3t: no float and no ball is exactly that."""
    problem = fts.Equations("x'' + 2*x = lam*cos(3*t)", unknowns={"x": fts.Field("cos")}, ahead=2)
    path = tmp_path / "s.json"
    fts.solve(problem, 7, arithmetic).save(path)
    assert fts.load(path).arithmetic == arithmetic
    altered(path, at("problem", "arguments", "seed", {"x": "-lam*cos(3*t)/8"}))
    with pytest.raises(FileError, match="seed"):
        fts.load(path)


@pytest.mark.parametrize("mode", [[1, 3], [0, 2], [0, 5], [0, 10**9], [0, -1], [2, 1], [0, 1]])
def test_modes_outside_the_ansatz(tmp_path, mode):
    """A sine in a cosine series, an even mode in an odd one, n > m, the fixed amplitude."""
    path = tmp_path / "duffing.json"
    fts.solve(Duffing(), 3).save(path)
    altered(path, at("coefficients", "x", 3, 0, [*mode, "1/32"]))
    with pytest.raises(FileError, match="which the ansatz of Duffing.* leaves out"):
        fts.load(path)


@pytest.mark.parametrize("arithmetic, change, words", [
    ("exact", at("order", 3.0), "order=3.0: give a whole"),
    ("exact", at("order", "3"), "order='3'"), ("exact", at("order", True), "order=True"),
    ("exact", at("order", 10**9), "hold Fourier orders up to 1000"),
    ("exact", at("precision", 128), "precision=128 in exact"),
    ("float", at("precision", 53), "precision=53 in float"),
    ("ball", at("precision", None), "precision=None in ball"),
    ("ball", at("precision", 1), "precision=1: give"), ("ball", at("precision", 99.5), "99.5"),
    ("ball", at("precision", True), "precision=True"), ("ball", at("precision", "9"), "'9'"),
    ("ball", at("precision", 10**9), "up to 100000 bits"),
    ("exact", at("arithmetic", ["exact"]), "is none that"),
    ("exact", at("coefficients", "y", [[], [], [], []]), "unknowns of Duffing.* are x, omega"),
    ("exact", at("coefficients", "x", 3, 0, [False, 3, "1/32"]), "not two integers"),
    ("exact", at("coefficients", "x", 3, 0, [0, 3.0, "1/32"]), "not two integers"),
    ("exact", at("coefficients", "x", 3, [[0, 3, "1/32"], [0, 3, "1/32"]]), "occurs twice"),
    ("exact", at("coefficients", "omega", 2, 0, 2, "1e999999999"), "not an exact number"),
    ("exact", at("coefficients", "omega", 2, 0, 2, "0.375"), "not an exact number"),
    ("exact", at("coefficients", "omega", 2, 0, 2, "٣/8"), "not an exact number"),
    ("exact", at("coefficients", "omega", 2, 0, 2, "3/-8"), "not an exact number"),
    ("exact", at("coefficients", "omega", 2, 0, 2, "1" * 100001), "more than 100000 digits"),
    ("float", at("coefficients", "omega", 2, 0, 2, "0.375"), "not a float"),
    ("float", at("coefficients", "omega", 2, 0, 2, True), "not a float"),
    ("float", at("coefficients", "omega", 2, 0, 2, 1e308), "contradict"),
    ("ball", at("coefficients", "omega", 2, 0, 2, ["3", "-3", "-1", "0"]), "not a ball of four"),
    ("ball", at("coefficients", "omega", 2, 0, 2, ["3", "-3", "0"]), "not a ball of four"),
    ("ball", at("coefficients", "omega", 2, 0, 2, ["3", "9" * 99, "0", "0"]), "not a ball of four"),
    ("ball", at("coefficients", "omega", 2, 0, 2, [3, -3, 0, 0]), "not a ball of four"),
    ("exact", at("problem", "name", ["Duffing"]), "is damaged"),
    ("exact", at("problem", "arguments", []), "is damaged"),
    ("exact", at("problem", {}), "'name' is missing"),
])
def test_types_and_ranges(tmp_path, arithmetic, change, words):
    path = tmp_path / "duffing.json"
    fts.solve(Duffing(), 3, arithmetic).save(path)
    start = time.monotonic()
    with pytest.raises(FileError, match=words) as caught:
        fts.load(altered(path, change))
    assert "\n" not in str(caught.value) and len(str(caught.value)) < 1000
    assert time.monotonic() - start < 5


@pytest.mark.parametrize("text, words", [
    ('{"format": "ftseries", "format": "ftseries"}', "the key 'format' stands twice"),
    ('{"format": "ftseries", "version": 1, "x": NaN}', "damaged"),
    ('{"format": "ftseries", "version": 1, "x": 1e999}', "damaged"),
    ('{"format": "ftseries", "version": 1, "x": -Infinity}', "damaged"),
    ('{"format": "ftseries", "version": true}', "version True"),
    ('{"format": "ftseries", "version": 1.0}', "version 1.0"),
    ('{"format": "ftseries", "version": 1, "x": ' + "[" * 900 + "]" * 900 + "}", "damaged"),
    ('{"format": "ftseries", "version": 1, "x": ' + "[" * 10**6, "recursion"),
    ('{"a":' * 10**6, "recursion"), ("9" * 10**6, "Exceeds the limit .4300 digits"),
    ("\ufeff{}", "BOM"),
])
def test_damaged_deep_and_repeated(tmp_path, text, words):
    path = tmp_path / "{odd}.json"
    path.write_text(text, encoding="utf-8")
    start = time.monotonic()
    with pytest.raises(FileError, match=words) as caught:
        fts.load(path)
    assert "\n" not in str(caught.value) and time.monotonic() - start < 2


def test_huge_files_are_not_read(tmp_path, monkeypatch):
    path = tmp_path / "huge.json"
    with open(path, "wb") as file:
        file.truncate(10**12)                            # a hole: nothing is written
    start = time.monotonic()
    with pytest.raises(FileError, match="has more than 67108864 bytes, so it is not a saved"):
        fts.load(path)
    assert time.monotonic() - start < 5
    monkeypatch.setattr("ftseries.jsonfile.LARGEST", 200)
    with pytest.raises(FileError, match="files of up to 200 can be read again; truncate"):
        fts.solve(Duffing(), 9).save(tmp_path / "d.json")


def test_what_is_too_large_to_be_read_again_is_not_saved(tmp_path):
    path = tmp_path / "s.json"
    for solution in (fts.solve(Duffing(), 2, "ball", precision=100001),
                     fts.solve(fts.GeneralizedMathieu(0, branch="b1001"), 1)):
        with pytest.raises(FileError, match="files hold Fourier orders up to 1000 and up to 1000"):
            solution.save(path)
    assert not path.exists()


def test_long_numbers_come_back(tmp_path):
    """More than the 4300 digits that Python reads by itself."""
    path = tmp_path / "s.json"
    for solution in (fts.solve(fts.CubicOscillator(), 4, "ball", precision=30000),
                     fts.solve(fts.Equations("x'' + x + k*x**3 = 0", frequency="omega", unknowns={
                         "x": fts.Field("cos", fixed=(1,)), "omega": fts.Scalar()},
                         parameters={"k": Fraction(1, 3**1000)}), 20)):
        solution.save(path)
        assert max(map(len, re.findall("[0-9]+", path.read_text()))) > 4300
        assert fts.load(path).order == solution.order


def test_arguments_come_back_as_json_has_them(tmp_path, forget_spring):
    """A tuple is a list in a file; it still is the same problem."""
    kind = spring(lambda x: x**3, arguments=lambda self: {"b": (self.b, {1: 2})})
    solution = fts.solve(kind(2), 3)
    solution.save(tmp_path / "s.json")
    assert fts.load(tmp_path / "s.json", problem=kind(2)).order == 3


def test_a_constructor_that_fails_is_told(tmp_path, forget_spring):
    kind, path = spring(lambda x: x**3, **ARGUMENTS), tmp_path / "s.json"
    fts.solve(kind(2), 3).save(path)

    def fails(self, b):
        raise MemoryError("too much")
    kind.__init__ = fails
    with pytest.raises(FileError, match=r"is damaged: MemoryError\('too much'\); save"):
        fts.load(path)


@pytest.mark.parametrize("path", ["a\0b", b"a\0b", "\ud800"])
def test_names_that_no_file_has(path):
    for attempt in (lambda: fts.load(path), lambda: fts.solve(Duffing(), 1).save(path)):
        with pytest.raises(FileError, match="is not the name of a file"):
            attempt()


# --- writers and readers at once ----------------------------------------------------------------

SECONDS = 15 if os.environ.get("FTSERIES_FUZZ") else 2


def write_on(path, order, until):
    solution, count = fts.solve(Duffing(), order), 0
    while time.time() < until:
        solution.save(path)
        count += 1
    return count


def read_on(path, until):
    count = 0
    while time.time() < until:
        assert fts.load(path).order in (1, 9)
        count += 1
    return count


@pytest.mark.parametrize("kind", [ThreadPoolExecutor, ProcessPoolExecutor])
def test_two_writers_and_a_reader(tmp_path, kind):
    """No reader ever sees a damaged file, no writer fails, and nothing stays behind."""
    path = tmp_path / "s.json"
    fts.solve(Duffing(), 1).save(path)
    with kind(3) as executor:
        list(executor.map(abs, range(3)))                # they have started
        until = time.time() + SECONDS
        counts = [future.result() for future in (
            executor.submit(write_on, path, 1, until), executor.submit(write_on, path, 9, until),
            executor.submit(read_on, path, until))]
    print("saved", counts[:2], "read", counts[2], "in", SECONDS, "s, damaged 0")
    assert min(counts) > 0 and [p.name for p in tmp_path.iterdir()] == ["s.json"]


# --- writing ------------------------------------------------------------------------------------

@pytest.mark.parametrize("name, failure", [
    ("fsync", OSError(28, "No space left on device")),
    ("replace", OSError(13, "Permission denied")),
    ("fsync", KeyboardInterrupt()), ("replace", KeyboardInterrupt()),
])
def test_a_failed_write_leaves_the_old_file(saved, monkeypatch, name, failure):
    path, content = saved
    longer = fts.solve(Duffing(), 9)

    def fail(*_):
        raise failure

    with monkeypatch.context() as patch:
        patch.setattr(os, name, fail)
        with pytest.raises(FileError if isinstance(failure, OSError) else KeyboardInterrupt):
            longer.save(path)
    assert path.read_bytes() == content
    assert [p.name for p in path.parent.iterdir()] == ["duffing.json"]      # no scrap stays behind
    longer.save(path)
    assert fts.load(path).order == 9


def test_the_reason_of_a_failed_write_is_given(tmp_path):
    solution = fts.solve(Duffing(), 1)
    with pytest.raises(FileError, match="cannot write .*No such file or directory"):
        solution.save(tmp_path / "no" / "such" / "folder.json")
    with pytest.raises(FileError, match="cannot write"):
        solution.save(tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_a_problem_that_cannot_be_written_leaves_nothing(tmp_path):
    class Unwritable(Duffing):
        def arguments(self):
            return {"f": object()}
    solution = fts.solve(Unwritable(), 1)
    del fts.Problem.classes["Unwritable"]
    with pytest.raises(FTSeriesError, match="arguments"):
        solution.save(tmp_path / "u.json")
    assert list(tmp_path.iterdir()) == []


def test_a_relative_path(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    fts.solve(Duffing(), 1).save("here.json")
    assert fts.load("here.json").order == 1


def test_a_saved_file_is_readable_by_others(tmp_path):
    """A temporary file is private; the finished one gets the usual permissions."""
    path = tmp_path / "d.json"
    fts.solve(Duffing(), 1).save(path)
    plain = tmp_path / "plain"
    plain.touch()
    assert path.stat().st_mode == plain.stat().st_mode


SAMPLES = [kind for kind in vars(sample_problems).values()
           if isinstance(kind, type) and issubclass(kind, fts.Problem) and kind is not fts.Problem]


@pytest.mark.parametrize("arithmetic", ["exact", "float", "ball"])
@pytest.mark.parametrize("kind", SAMPLES, ids=lambda kind: kind.__name__)
def test_no_sample_problem_is_refused(tmp_path, kind, arithmetic):
    """Whatever is solved and saved is loaded, at every order."""
    if kind().parameters and arithmetic != "exact":
        return
    solution = fts.solve(kind(), 18, arithmetic)
    for order in (0, 1, 2, 5, 9, 17, 18):
        solution.truncate(order).save(tmp_path / "s.json")
        assert fts.load(tmp_path / "s.json", problem=kind()).order == order


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no named pipes")
def test_what_is_no_file_is_not_replaced(tmp_path):
    """As /dev/null would be, where the rights allow it."""
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with pytest.raises(FileError, match="a device or a pipe is there"):
        fts.solve(Duffing(), 3).save(pipe)
    assert pipe.is_fifo()


def test_a_link_stays_and_its_file_is_written(tmp_path):
    folder, link = tmp_path / "real", tmp_path / "link.json"
    folder.mkdir()
    link.symlink_to(folder / "file.json")
    fts.solve(Duffing(), 3).save(link)
    assert link.is_symlink() and fts.load(folder / "file.json").order == fts.load(link).order == 3
