"""One family of errors: every refusal is a :class:`FTSeriesError` and one clear sentence."""

__all__ = ["FTSeriesError", "InputError", "NonAnalyticError", "SolveError", "UndeterminedError",
           "ContradictionError", "FaultError", "FileError", "PrecisionError", "ConvergenceWarning",
           "PrecisionWarning"]


class FTSeriesError(Exception):
    """Anything that ftseries refuses; the message names the input and the way out."""


class InputError(FTSeriesError, ValueError):
    """A value given by the caller cannot be used."""


class NonAnalyticError(FTSeriesError, ArithmeticError):
    """An operation has no Taylor series at λ = 0, so no Fourier-Taylor series exists."""


class SolveError(FTSeriesError):
    """Comparing coefficients does not lead to a solution."""


class UndeterminedError(SolveError):
    """A coefficient stays free: λ has not been given a concrete meaning."""


class ContradictionError(SolveError):
    """Two equations of one order cannot hold together."""


class FaultError(SolveError):
    """What was found does not satisfy the equations: a fault of ftseries itself."""


class FileError(FTSeriesError):
    """A saved solution cannot be read or written."""


class PrecisionError(FTSeriesError):
    """The working precision was changed from outside during a computation."""


class ConvergenceWarning(UserWarning):
    """A series is evaluated where its coefficients say that it does not converge."""


class PrecisionWarning(UserWarning):
    """More digits are asked for than the coefficients have."""
