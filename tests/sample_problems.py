"""Small problems with known answers, declared as a reader would declare them."""

from fractions import Fraction

from ftseries import Field, Problem, Scalar, exp, sin


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


SMALL = [Duffing, Pendulum, Relativistic, Quotient, Exponential, LotkaVolterra, VanDerPol, Coupled]
