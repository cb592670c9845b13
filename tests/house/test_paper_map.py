"""The page "Paper and book" is complete, its links lead somewhere, its numbers are asserted."""

import re
from pathlib import Path

import nbformat
import pytest

BOOK = Path(__file__).parents[2] / "book"
PAGE = (BOOK / "paper_and_book.md").read_text(encoding="utf-8")

#: every label of sections 2 to 4 of the paper's source, in its order
EQUATIONS = [
    "C1", "C2", "C3", "C3a", "C4a", "C4b", "C5a", "C5b", "C6a", "C6b", "C6c", "C7a", "C7b",
    "C8", "C9a", "C9b", "C10", "C11", "C12",
    "M1", "M2a", "M2b", "M3",
    "E0", "E_CM1", "E_CM2", "E1a", "E1b", "E2", "E3a", "E3b", "E4", "E4a", "E5a", "E5b", "E5c",
    "E5d", "E_lambda", "E_lambda_0", "E6a", "E6b", "E6c", "E6d", "E7a", "E7b", "E7",
]
#: source labels that the book writes in another way
SHOWN = {"E_CM1": "ECM1", "E_CM2": "ECM2", "E_lambda": "Eλ", "E_lambda_0": "Eλ₀"}
INTRODUCTION = ["I1", "I2a", "I2b"]
#: in the order of the paper, which numbers them from 1
FIGURES = {
    "FIGPW": "fig-potential",
    "FIGA1": "fig-oscillation",
    "FIGA2": "fig-oscillation-difference",
    "FIGM1": "fig-eigenvalue",
    "FIGM2": "fig-psi",
    "FIGM3": "fig-psi-difference",
    "FIGE1": "fig-choreography",
    "FIGE4": "fig-orbits",
    "FIGE2": "fig-closure",
    "FIGE7": "fig-zeros",
    "FIGE6": "fig-distance",
}
#: (printed number as the page shows it, chapter, what the asserting cell contains)
NUMBERS = [
    ("$E=-3$", "cubic", "== -3"),
    ("x_{min}=-1.5", "cubic", "(-1.5, -0.5)"),
    (r"\frac16", "cubic", "sp.Rational(1, 6)"),
    ("3.4458763864722597", "cubic", "3.4458763864722597"),
    ("1.8233925429960192", "cubic", "1.8233925429960192"),
    ("1.823392542996019014655", "cubic", "1.823392542996019014655"),
    ("K(5/7)", "cubic", "K57"),
    ("$g_2=13$, $g_3=6$", "cubic", "(13, 6)"),
    (r"5\times10^{-15}", "cubic", "5e-15"),
    (r"\frac1{192}", "cubic", "192 * a**2"),
    ("24576", "mathieu", "24576"),
    (r"\lambda_0\approx2.07568", "figure_eight", "2.07568"),
    (r"\lambda_6\approx2.09531", "figure_eight", "2.09531"),
    (r"\lambda_1=2.07552", "figure_eight", "2.07552"),
    (r"8\times10^{-5}", "figure_eight", "8e-5"),
    (r"1.6\times10^{-3}", "slips", "1.6e-3"),
]


def sources():
    """(name, text) of every page of the book; of a notebook, its cells and its figures' names."""
    for path in sorted(BOOK.glob("*.md")):
        yield path.name, path.read_text(encoding="utf-8")
    for path in sorted(BOOK.glob("*.ipynb")):
        cells = nbformat.read(path, as_version=4).cells
        names = [cell.metadata.get("mystnb", {}).get("figure", {}).get("name") for cell in cells]
        yield path.name, "\n".join([cell.source for cell in cells]
                                   + [f"({name})=" for name in names if name])


@pytest.fixture(scope="module")
def targets():
    """Target (in lower case, as Sphinx normalises it) to the pages that define it."""
    found = {}
    for page, text in sources():
        for name in re.findall(r"^\(([\w-]+)\)=$|^:label: ([\w-]+)$", text, re.MULTILINE):
            found.setdefault("".join(name).lower(), []).append(page)
    return found


@pytest.mark.parametrize("label", EQUATIONS)
def test_every_equation_is_on_the_page_and_shown_with_its_tag(label, targets):
    assert f"{{ref}}`({SHOWN.get(label, label)}) <eq-{label.lower()}>`" in PAGE
    (page,) = targets[f"eq-{label.lower()}"]
    text = dict(sources())[page]
    shown = re.search(rf"^\(eq-{label}\)=\n+((?:.+\n?)+)", text, re.MULTILINE)
    tag = SHOWN.get(label, label).replace("λ₀", r"$\lambda_0$").replace("λ", r"$\lambda$")
    assert shown and rf"\tag{{{tag}}}" in shown[1]


def test_equations_have_the_numbers_of_the_printed_paper():
    """The paper numbers each line of its equations, from (1) to (49)."""
    rows = re.findall(r"^\| (\([^|]+\)) \| ([^|]+) \|", PAGE, re.MULTILINE)
    pairs = [pair for labels, numbers in rows
             for pair in zip(labels.split(", "), numbers.split(", "), strict=True)]
    expected = [(f"({SHOWN.get(label, label)})", f"({number})")
                for number, label in enumerate([*INTRODUCTION, *EQUATIONS], 1)]
    assert pairs == expected and len(expected) == 49


def test_the_notation_names_the_printed_numbers_too():
    page = (BOOK / "notation.md").read_text(encoding="utf-8")
    named = re.findall(r"\{ref\}`[^`]+ <eq-(\w+)>` (\d+)", page)
    printed = {label.lower(): number
               for number, label in enumerate([*INTRODUCTION, *EQUATIONS], 1)}
    assert len(named) > 20
    assert [(label, number) for label, number in named if printed[label] != int(number)] == []


@pytest.mark.parametrize(("label", "name"), FIGURES.items())
def test_every_figure_is_on_the_page_and_in_one_chapter(label, name, targets):
    number = list(FIGURES).index(label) + 1
    row = rf"^\| {number} \| {label} \|.*\{{numref\}}`{name}` \|$"
    assert re.search(row, PAGE, re.MULTILINE)
    assert len(targets[name]) == 1


def test_every_link_of_the_page_leads_somewhere(targets):
    links = re.findall(r"\{(?:ref|numref|prf:ref)\}`(?:[^`<]*<)?([\w-]+)>?`", PAGE)
    assert len(links) > len(EQUATIONS)
    assert not [link for link in links if link.lower() not in targets]
    pages = set(re.findall(r"\{doc\}`(\w+)`", PAGE))
    assert pages <= {Path(name).stem for name, _ in sources()}


@pytest.mark.parametrize(("printed", "chapter", "code"), NUMBERS)
def test_every_number_is_on_the_page_and_asserted(printed, chapter, code):
    assert printed in PAGE
    cells = nbformat.read(BOOK / f"{chapter}.ipynb", as_version=4).cells
    asserting = [cell.source for cell in cells if cell.cell_type == "code"
                 and re.search(r"^\s*assert ", cell.source, re.MULTILINE)]
    assert any(code in source for source in asserting)
