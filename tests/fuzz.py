"""Altered files: generators for hypothesis, and a limit of time.

`make fuzz` sets FTSERIES_FUZZ; then the tests that use them try thousands of files.
"""

import json
import os
import signal
from contextlib import contextmanager

from hypothesis import strategies as st

from ftseries.jsonfile import digest

#: how many files a test tries
TRIES = int(os.environ.get("FTSERIES_FUZZ", 225)) // 3

ATOMS = st.one_of(
    st.none(), st.booleans(), st.integers(-3, 12), st.sampled_from([10**9, -10**9, 10**30]),
    st.floats(allow_nan=False, allow_infinity=False), st.text(max_size=6),
    st.sampled_from(["0", "1", "-1", "1/3", "-7/2", "1/0", "1e9", "nan", "oo", "x", "lam", "exact",
                     "float", "ball", "cos", "sin", "both", "odd", "b1", "a2", "--1", "1 2", "1 -9",
                     "lam*cos(omega*t)", "2*lam*cos(omega*t)", "9" * 5000, "x" * 5000]),
    st.lists(st.integers(-2, 3), max_size=3), st.dictionaries(st.text(max_size=3), st.integers(),
                                                              max_size=2),
)
#: what asks for absurd sizes
ABSURD = st.sampled_from(["1e999999999", "1/1e999999", "1 999999999", "b999999999", 10**18,
                          ["1", "999999999", "1", "0"], "9" * 200_000])


def places(data, path=()):
    """All places in nested lists and dicts."""
    items = data.items() if isinstance(data, dict) else enumerate(data) \
        if isinstance(data, list) else ()
    for key, value in items:
        yield (*path, key)
        yield from places(value, (*path, key))


@st.composite
def altered(draw, files, atoms=ATOMS):
    """The text of one of the files with one to three changes and a right checksum."""
    data = json.loads(json.dumps(draw(st.sampled_from(files))))
    data.pop("sha256", None)
    for _ in range(draw(st.integers(1, 3))):
        *path, last = draw(st.sampled_from(list(places(data))))
        holder = data
        for key in path:
            holder = holder[key]
        kind = draw(st.sampled_from(["replace", "replace", "nudge", "nudge", "delete", "repeat"]))
        if kind == "replace":
            holder[last] = draw(atoms)
        elif kind == "nudge":
            holder[last] = nudged(holder[last], draw(st.integers(-2, 2)))
        elif kind == "delete":
            del holder[last]
        elif isinstance(holder, list):
            holder.insert(last, holder[last])
    return json.dumps(data | {"sha256": digest(data)})


def nudged(value, by):
    """Nearly the same value."""
    if isinstance(value, bool) or value is None:
        return not value
    if isinstance(value, (int, float)):
        return value + by
    if isinstance(value, str) and value:
        return value[:-1] + chr(ord(value[-1]) + by) if ord(value[-1]) + by > 0 else value
    return value[::-1] if isinstance(value, list) else value


class Hung(BaseException):
    """No Exception, so that nothing swallows it."""


@contextmanager
def limited(seconds):
    """Stops after so many seconds of computing, on machines that can."""
    def stop(*_):
        raise Hung
    if not hasattr(signal, "SIGVTALRM"):
        yield
        return
    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)
