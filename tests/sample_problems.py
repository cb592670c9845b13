"""Small problems with known answers, declared as a reader would declare them."""

from fractions import Fraction

import numpy as np
from scipy.special import ellipk

from ftseries import Field, FigureEight, Problem, Scalar, cos, exp, sin


class Duffing(Problem):
    """ω² x″ + x + x³ = 0; λ is the amplitude of cos τ."""

    unknowns = {"x": Field("cos", modes="odd", powers="odd", fixed=(1,)), "omega": Scalar("even")}
    seed = {"x": [{}, {1: 1}], "omega": [1]}
    frequency = "omega"

    def equations(self, lam, x, omega):
        return {"(Duffing)": omega**2 * x.diff(2) + x + x**3}


class Pendulum(Duffing):
    """ω² x″ + sin x = 0."""

    def equations(self, lam, x, omega):
        return {"(pendulum)": omega**2 * x.diff(2) + sin(x)}


class Relativistic(Duffing):
    """ω² x″ + x (1 - ω² x′²)^{3/2} = 0, the oscillator with a speed limit of 1."""

    def equations(self, lam, x, omega):
        return {"(relativistic)": omega**2 * x.diff(2)
                + x * (1 - (omega * x.diff())**2) ** Fraction(3, 2)}


class Quotient(Duffing):
    """ω² x″ + x/(1 + x²) = 0."""

    def equations(self, lam, x, omega):
        return {"(quotient)": omega**2 * x.diff(2) + x / (1 + x * x)}


class Exponential(Problem):
    """ω² x″ + e^x - 1 = 0, one particle of Toda's lattice."""

    unknowns = {"x": Field("cos", fixed=(1,)), "omega": Scalar("even")}
    seed = {"x": [{}, {1: 1}], "omega": [1]}
    frequency = "omega"

    def equations(self, lam, x, omega):
        return {"(Toda)": omega**2 * x.diff(2) + exp(x) - 1}


class LotkaVolterra(Problem):
    """ω u′ = -(1 + u) v, ω v′ = (1 + v) u: two equations of first order, cosines and sines."""

    unknowns = {"u": Field("both", fixed=(1,)), "v": Field("both"), "omega": Scalar()}
    seed = {"u": [{}, {(0, 1): 1}], "v": [{}, {(1, 1): 1}], "omega": [1]}
    frequency = "omega"

    def equations(self, lam, u, v, omega):
        return {"(prey)": omega * u.diff() + (1 + u) * v,
                "(predator)": omega * v.diff() - (1 + v) * u}


class VanDerPol(Problem):
    """ω² y″ + y = (λ² - y²) ω y′ with λ² = ε: the phase is chosen, the amplitude is not."""

    unknowns = {"y": Field("both", modes="odd", powers="odd", fixed=((1, 1),)), "omega": Scalar()}
    seed = {"y": [{}, {(0, 1): 2}], "omega": [1]}
    frequency = "omega"

    def equations(self, lam, y, omega):
        return {"(van der Pol)": omega**2 * y.diff(2) + y - (lam**2 - y**2) * omega * y.diff()}


class Coupled(Problem):
    """ω² x″ + 2x - y + x³ = 0, ω² y″ + 2y - x = 0: the nonlinear mode that starts in phase."""

    unknowns = {"x": Field("cos", modes="odd", powers="odd", fixed=(1,)),
                "y": Field("cos", modes="odd", powers="odd"), "omega": Scalar("even")}
    seed = {"x": [{}, {1: 1}], "y": [{}, {1: 1}], "omega": [1]}
    frequency = "omega"

    def equations(self, lam, x, y, omega):
        return {"(first)": omega**2 * x.diff(2) + 2 * x - y + x**3,
                "(second)": omega**2 * y.diff(2) + 2 * y - x}


class MassOnSpring(Duffing):
    """ω² x″ + x + μ x³ = 0 with μ kept as a symbol."""

    parameters = ("mu",)

    def equations(self, lam, x, omega):
        return {"(D)": omega**2 * x.diff(2) + x + lam.expansion.parameter("mu") * x**3}


class CentralEight(FigureEight):
    """Z″ = -Q(Z f(|Z|)) with f(1) = 1, in lengths of |Z| at λ = 0."""

    def equations(self, lam, r, phi):
        c, s = cos(phi), sin(phi)
        force = self.force(r)
        x, y = (force * c).neighbours(), (force * s).neighbours()
        return {"(radial)": r.diff(2) - r * phi.diff()**2 + (2 * force - (c * x + s * y)) / 3,
                "(angular)": r * phi.diff(2) + 2 * r.diff() * phi.diff() + (s * x - c * y) / 3}


class PowerLawEight(CentralEight):
    """The force |d|^{-(α+1)} between two bodies at distance d."""

    def __init__(self, alpha):
        self.alpha = Fraction(alpha)

    def force(self, r):
        return r ** -(self.alpha + 1)

    def scale(self, name):
        return 3 ** (1 / (float(self.alpha) + 2)) if name == "r" else 1


class LemniscateEight(CentralEight):
    """Fujiwara, Fukuda, Ozaki: pair potential ½ ln r - (√3/24) r², on Bernoulli's lemniscate.

    With the period T = 4K(k²), k² = (2 + √3)/4, and W = (2π/T)² the force is α/ρ - βρ in lengths c,
    β = √3/(4W), α = 3/(2Wc²) = 1 + β.
    """

    period = 4 * ellipk((2 + np.sqrt(3)) / 4)
    W = (2 * np.pi / period) ** 2
    beta = Fraction(float(np.sqrt(3) / (4 * W)))

    def force(self, r):
        return (1 + self.beta) / r - self.beta * r

    def scale(self, name):
        return float(np.sqrt(3 / (2 * self.W * (1 + self.beta)))) if name == "r" else 1


SMALL = [Duffing, Pendulum, Relativistic, Quotient, Exponential, LotkaVolterra, VanDerPol, Coupled]
