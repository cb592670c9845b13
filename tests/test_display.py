"""LaTeX of solutions: as printed in the paper, balanced, and true."""

import pytest
import sympy as sp
from sample_problems import Coupled, LotkaVolterra

import ftseries as fts

a = sp.Symbol("a", positive=True)


def test_C7_and_E6_read_like_the_paper():
    cubic = fts.solve(fts.CubicOscillator(), 3)
    assert cubic.to_latex("x", order=3) == (
        r"x(t) = -1 + \frac{1}{12} \lambda^{2} + "
        r"\left(\lambda - \frac{1}{192} \lambda^{3}\right) \cos \omega t "
        r"- \frac{1}{12} \lambda^{2} \cos 2\omega t "
        r"+ \frac{1}{192} \lambda^{3} \cos 3\omega t + \mathcal{O}(\lambda^{4})")   # (C7a) lacks it
    eight = fts.solve(fts.FigureEight(), 3)
    assert eight.to_latex("phi", order=3) == (
        r"\varphi(t) = \lambda \cos t - \frac{1}{48} \lambda^{3} \cos 3t "
        r"+ \mathcal{O}(\lambda^{4})")
    assert eight.to_latex("r", order=2) == (
        r"r(t) = \sqrt[3]{3} - \frac{\sqrt[3]{3}}{16} \lambda^{2} "
        r"+ \frac{\sqrt[3]{3}}{8} \lambda^{2} \cos 2t + \mathcal{O}(\lambda^{3})")


def test_polynomials_in_mu_are_bracketed():
    latex = fts.solve(fts.GeneralizedMathieu(), 8).to_latex("a", order=6)
    assert latex == (r"a = 1 - \frac{1}{2} \lambda^{2} - \frac{1}{32} \lambda^{4} "
                     r"+ \left(\frac{\mu}{16} + \frac{1}{512}\right) \lambda^{6} "
                     r"+ \mathcal{O}(\lambda^{7})")


def test_a_leading_minus_and_nothing_at_all():
    class Still(Coupled):
        def equations(self, lam, x, y, omega):
            return {"1": x - lam * 0 - lam.expansion.cos(1) * lam,
                    "2": y + lam.expansion.cos(1) * lam, "3": omega - 1}
        seed = {"x": [{}, {1: 1}], "y": [{}, {1: -1}], "omega": [1]}
    del fts.Problem.classes["Still"]
    solution = fts.solve(Still(), 2)
    assert solution.to_latex("y", order=2) == (
        r"y(t) = -\lambda \cos \omega t + \mathcal{O}(\lambda^{3})")
    assert solution.to_latex("y", order=0) == r"y(t) = 0 + \mathcal{O}(\lambda^{1})"


def evaluated(latex, phase, values):
    """The right-hand side of a printed equation as a number, by a small reader of its own."""
    import re
    text = latex.split(" = ", 1)[1].rsplit(r" + \mathcal", 1)[0]
    text = text.replace(r"\left(", "(").replace(r"\right)", ")")
    text = re.sub(r"\\sqrt\[3\]\{3\}", "(3**(1/3))", text)
    text = re.sub(r"\\sqrt\{(\d+)\}", r"(\1**.5)", text)
    text = re.sub(r"\\(sin|cos) (\d*)" + re.escape(phase) + r"(?![a-z])",
                  lambda m: f"np.{m[1]}({m[2] or 1}*tau)", text)
    for _ in range(3):
        text = re.sub(r"\\frac\{([^{}]*)\}\{([^{}]*)\}", r"((\1)/(\2))", text)
    text = re.sub(r"\^\{(\d+)\}", r"**\1", text).replace(r"\lambda", "lam").replace(r"\mu", "mu")
    text = re.sub(r"(?<=[\w)]) (?=[(\w])", "*", text)
    import numpy as np
    return eval(text, {"np": np}, values)                # our own digits and names only


@pytest.mark.parametrize("problem, name, phase", [
    (fts.CubicOscillator(), "x", r"\omega t"), (fts.CubicOscillator(), "omega", r"\omega t"),
    (fts.FigureEight(), "r", "t"), (fts.FigureEight(), "phi", "t"),
    (fts.GeneralizedMathieu("-3/10"), "psi", "x"), (fts.GeneralizedMathieu("-3/10"), "a", "x"),
    (LotkaVolterra(), "u", r"\omega t"), (LotkaVolterra(), "v", r"\omega t"),
    (Coupled(), "y", r"\omega t"),
])
def test_what_is_printed_is_what_is_evaluated(problem, name, phase):
    solution = fts.solve(problem, 6)
    lam, t = 0.3, 0.8
    scalar = isinstance(problem.unknowns[name], fts.Scalar)
    omega = solution.evaluate("omega", lam=lam) if problem.frequency else 1.0
    printed = evaluated(solution.to_latex(name), phase, {"lam": lam, "tau": omega * t})
    value = solution.evaluate(name, None if scalar else t, lam=lam)
    assert printed == pytest.approx(value, abs=1e-14)


def test_floats_and_balls_are_displayed():
    for arithmetic in ("float", "ball"):
        latex = fts.solve(fts.FigureEight(), 4, arithmetic).to_latex("phi", order=4)
        assert r"\lambda \cos t" in latex and "0.0208333" in latex and "/-" not in latex


@pytest.mark.parametrize("problem", [fts.CubicOscillator(), fts.CubicOscillator(a),
                                     fts.GeneralizedMathieu(), fts.FigureEight(), LotkaVolterra()])
def test_notebook_display(problem):
    latex = fts.solve(problem, 9)._repr_latex_()
    assert latex.startswith(r"$\displaystyle \begin{aligned}") and latex.endswith("$")
    assert latex.count("&=") == len(problem.unknowns)
    assert latex.count(r"\mathcal{O}(\lambda^{5})") == len(problem.unknowns)
    assert latex.count("{") == latex.count("}") and latex.count(r"\left") == latex.count(r"\right")


def test_default_order_is_at_most_six():
    assert r"\mathcal{O}(\lambda^{7})" in fts.solve(fts.FigureEight(), 9).to_latex("r")
    assert r"\mathcal{O}(\lambda^{4})" in fts.solve(fts.FigureEight(), 3).to_latex("r")
    assert r"\mathcal{O}(\lambda^{10})" in fts.solve(fts.FigureEight(), 9).to_latex("r", order=9)
