"""A family of problems in bulk: one solve for each value, on any executor."""

from __future__ import annotations

import inspect
import os
import pickle
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import BrokenExecutor, ProcessPoolExecutor, as_completed
from functools import partial
from typing import TYPE_CHECKING, Any

from tqdm import tqdm

from .arguments import shown, whole
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
        Why there is no solution.  An error that cannot travel between processes, and one that is
        meant to end a program, such as SystemExit, is a RuntimeError with its name and text.
    """

    def __init__(self, value: Any, error: Exception) -> None:
        self.value, self.error = value, error

    def __bool__(self) -> bool:
        return False

    def __repr__(self) -> str:
        return f"<no solution at {self.value!r}: {_text(self.error)}>"


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
        one after the other.  See the notes on starting workers.
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

    Raises
    ------
    InputError
        What is given is no function, no list of values (a table, a dict or a text is none), or no
        executor that takes tasks; an option that :func:`ftseries.solve` has not.
    KeyboardInterrupt
        When you interrupt it; the values that still wait are then cancelled.

    Notes
    -----
    A worker process is a new Python that imports the main module again: start pools and clusters
    below ``if __name__ == "__main__":`` in a script, not in one that is read from standard input,
    and expect 1 to 3 seconds for each worker (on a busy machine ten times as long) before the first
    value is solved.  So workers pay for sweeps of minutes.  In a notebook a pool that forks, as on
    Linux, needs no such line; elsewhere put ``make_problem`` into a module.  If a worker process is
    killed, a pool of :mod:`concurrent.futures` loses all values that wait; Dask starts another one.

    Examples
    --------
    >>> import ftseries as fts
    >>> found = fts.sweep(fts.CubicOscillator, [1, -1, 4], order=4, progress=False)
    >>> found[0].coefficient("omega", 2), bool(found[1]), found[2].coefficient("omega", 0)
    (-sqrt(3)/24, False, 4*sqrt(3))
    """
    values, order = _checked(make_problem, values, executor, options), whole("order", order)
    results = _results(make_problem, values, order, executor, progress, options)
    if not any(results):
        for failure in results:
            if not isinstance(failure.error, FTSeriesError | BrokenExecutor):
                raise failure.error
    return results


def _checked(make_problem: Any, values: Any, executor: Any,
             options: Mapping[str, Any]) -> list[Any]:
    """The values as a list; refuses what cannot be swept."""
    if not callable(make_problem):
        raise InputError(f"make_problem={shown(make_problem)} is not a function of one value; give "
                         "one, such as fts.CubicOscillator, without brackets")
    if isinstance(values, (Mapping, str, bytes)) or hasattr(values, "columns"):
        kind = type(values).__name__
        raise InputError(f"values is of type {kind}, not a list of values; give one, such as "
                         + ("one column of it, table['a'], or its rows, table.to_dict('records')"
                            if hasattr(values, "columns") else "list(values.values())"
                            if isinstance(values, Mapping) else f"[{shown(values)}]"))
    try:
        found: list[Any] = list(values)
    except TypeError:
        raise InputError(f"values={shown(values)} is not a list of values; give one, such as "
                         f"[{shown(values)}]") from None
    if executor is not None and not callable(getattr(executor, "submit", None)):
        raise InputError(f"executor={shown(executor)} has no method submit; give one like those of "
                         "concurrent.futures")
    known = set(inspect.signature(solve).parameters) - {"problem", "order", "progress"}
    for name in options:
        if name not in known:
            raise InputError(f"{name!r} is no option of solve; it has "
                             f"{', '.join(sorted(known))}")
    return found


def _results(make_problem: Callable[[Any], Problem], values: list[Any], order: int, executor: Any,
             progress: bool, options: dict[str, Any]) -> list[Any]:
    results: list[Any] = [None] * len(values)
    work = partial(_one, make_problem, order, options, os.getpid())
    with tqdm(total=len(values), desc="sweep", delay=10, leave=False, disable=not progress) as bar:
        if executor is None:
            for i, value in enumerate(values):
                results[i] = work(value)
                bar.update()
            return results
        pool = isinstance(executor, ProcessPoolExecutor)
        if pool:
            _check_picklable(work, make_problem)
        futures: dict[Any, int] = {}
        try:
            for i, value in enumerate(values):
                try:
                    futures[_submitted(executor, pool, work, value)] = i
                except InputError:
                    raise
                except Exception as error:            # a broken pool, an unpicklable value
                    results[i] = Failure(value, _named(error))
            for future in _completed(futures):
                i = futures[future]
                try:
                    results[i] = pickle.loads(future.result()) if pool else future.result()
                except Exception as error:            # a worker that died, an unpicklable problem
                    results[i] = Failure(None, _named(error))
                if isinstance(results[i], Failure):
                    results[i].value = values[i]
                bar.update()
        except BaseException:                         # the user's interruption among them
            for future in futures:
                future.cancel()
            raise
    return results


def _check_picklable(work: Any, make_problem: Any) -> None:
    try:
        pickle.dumps(work)
    except Exception as error:
        raise InputError(f"make_problem={shown(make_problem)} or an option cannot be sent to other "
                         f"processes ({error}); define it with def in a module") from error


def _submitted(executor: Any, pool: bool, work: Callable[[Any], Any], value: Any) -> Any:
    """The future of one value; a process pool gets bytes, as what it cannot unpickle breaks it."""
    task = (_unpacked, pickle.dumps((work, value))) if pool else (work, value)
    try:
        return executor.submit(*task)
    except BrokenExecutor:
        raise
    except RuntimeError as error:
        raise InputError(f"executor={shown(executor)} takes no more tasks ({error}); give a new one"
                         ) from error


def _unpacked(task: bytes) -> bytes:
    """Work on a pickled value, in a process; the result is pickled and can be read again."""
    try:
        work, value = pickle.loads(task)
        data = pickle.dumps(work(value))
        pickle.loads(data)
        return data
    except Exception as error:
        return pickle.dumps(Failure(None, _portable(error)))


def _completed(futures: Iterable[Any]) -> Iterator[Any]:
    try:
        yield from as_completed(futures)
    except (AttributeError, TypeError):              # futures of another library, asked in order
        yield from futures


def _one(make_problem: Callable[[Any], Problem], order: int, options: dict[str, Any], home: int,
         value: Any) -> Solution | Failure:
    try:
        return solve(make_problem(value), order, progress=False, **options)
    except KeyboardInterrupt:
        raise
    except Exception as error:
        return Failure(value, error if os.getpid() == home else _portable(error))
    except BaseException as error:                   # SystemExit, and others of its kind
        return Failure(value, _as_text(error))


def _named(error: Exception) -> Exception:
    """The same error; that of a broken pool in a sentence."""
    if not isinstance(error, BrokenExecutor):
        return error
    return type(error)(
        f"a worker ended without an answer ({' '.join(str(error).split())}): it was killed, had no "
        "memory left, or could not start, as in a script without if __name__ == '__main__'; the "
        "values that waited for this pool are lost, sweep them again with a new one")


def _portable(error: Exception) -> Exception:
    """An error that can travel between processes: the same, or its name and text."""
    try:
        if type(pickle.loads(pickle.dumps(error))) is type(error):
            return error
    except Exception:
        pass
    return _as_text(error)


def _as_text(error: BaseException) -> Exception:
    return RuntimeError(_text(error))


def _text(error: BaseException) -> str:
    try:
        return f"{type(error).__name__}: {error}"
    except Exception:                                # its own __str__ fails
        return type(error).__name__
