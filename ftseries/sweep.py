"""A family of problems in bulk: one solve for each value, on any executor."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor, as_completed
from typing import TYPE_CHECKING, Any

from tqdm import tqdm

from .errors import FTSeriesError, InputError
from .solver import solve

if TYPE_CHECKING:
    from .problem import Problem
    from .solution import Solution

__all__ = ["Failure", "sweep"]


class Failure:
    """What stands in the place of a solution that could not be found; it is false.

    Attributes
    ----------
    value
        The parameter value.
    error : Exception
        Why there is no solution.
    """

    def __init__(self, value: Any, error: Exception) -> None:
        self.value, self.error = value, error

    def __bool__(self) -> bool:
        return False

    def __repr__(self) -> str:
        return f"<no solution at {self.value!r}: {type(self.error).__name__}: {self.error}>"


def sweep(make_problem: Callable[[Any], Problem], values: Iterable[Any], order: int,
          executor: Any = None, progress: bool = True, **options: Any) -> list[Solution | Failure]:
    """Solve a problem for many parameter values.

    Parameters
    ----------
    make_problem : callable
        Gives the problem for one value; with processes it must be importable.
    values : iterable
        Parameter values.
    order : int
        The Taylor order, as for :func:`ftseries.solve`.
    executor : optional
        Anything with ``submit`` as in :mod:`concurrent.futures`: a process pool, or
        ``client.get_executor()`` of Dask for several machines.  Left out, the values are solved
        one after the other.
    progress : bool
        Show a progress bar.
    **options
        Passed to :func:`ftseries.solve`, for example ``arithmetic="float"``.

    Returns
    -------
    list
        A :class:`ftseries.Solution` for each value, in order; a :class:`Failure` where the problem
        cannot be made or solved, so that one bad value does not lose the others.  An error that
        is none of ftseries's is raised if no value has a solution: then it is a mistake in
        ``make_problem``.

    Examples
    --------
    >>> import ftseries as fts
    >>> found = fts.sweep(fts.CubicOscillator, [1, -1, 4], order=4, progress=False)
    >>> found[0].coefficient("omega", 2), bool(found[1]), found[2].coefficient("omega", 0)
    (-sqrt(3)/24, False, 4*sqrt(3))
    """
    if not callable(make_problem):
        raise InputError(f"make_problem={make_problem!r} is not a function of one value; give one, "
                         "such as fts.CubicOscillator, without brackets")
    try:
        values = list(values)
    except TypeError:
        raise InputError(f"values={values!r} is not a list of values; give one, such as "
                         f"[{values!r}]") from None
    if executor is not None and not hasattr(executor, "submit"):
        raise InputError(f"executor={executor!r} has no method submit; give one like those of "
                         "concurrent.futures")
    results = _results(make_problem, values, order, executor, progress, options)
    if not any(results):
        for failure in results:
            if not isinstance(failure.error, FTSeriesError | BrokenExecutor):
                raise failure.error
    return results


def _results(make_problem: Callable[[Any], Problem], values: list[Any], order: int, executor: Any,
             progress: bool, options: dict[str, Any]) -> list[Any]:
    results: list[Any] = [None] * len(values)
    with tqdm(total=len(values), desc="sweep", delay=10, leave=False, disable=not progress) as bar:
        if executor is None:
            for i, value in enumerate(values):
                results[i] = _one(make_problem, value, order, options)
                bar.update()
            return results
        futures = {executor.submit(_one, make_problem, value, order, options): i
                   for i, value in enumerate(values)}
        for future in _completed(futures):
            i = futures[future]
            try:
                results[i] = future.result()
            except Exception as error:                # a worker that died, an unpicklable problem
                results[i] = Failure(values[i], error)
            bar.update()
    return results


def _completed(futures: Iterable[Any]) -> Iterator[Any]:
    try:
        yield from as_completed(futures)
    except (AttributeError, TypeError):              # futures of another library, asked in order
        yield from futures


def _one(make_problem: Callable[[Any], Problem], value: Any, order: int,
         options: dict[str, Any]) -> Solution | Failure:
    try:
        return solve(make_problem(value), order, progress=False, **options)
    except Exception as error:
        return Failure(value, error)
