"""JSON files with a checksum.

Format.  ``{"format": kind, "version": 1, …, "sha256"}``, the last one of everything else, so that
no damage goes unnoticed.  A file appears complete or not at all, whoever else writes or reads it:
each writer has a temporary file of its own beside it.

A file may come from strangers, so what Python would take in silence is refused: keys that occur
twice, NaN and infinities, and what is larger than any file that ftseries writes.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import secrets
from collections import Counter
from typing import Any

from .aliases import FilePath, Json
from .arguments import shown
from .errors import FileError

__all__ = ["LARGEST", "read", "write"]

#: bytes of a file: exact series of the figure eight fit up to about order 220
LARGEST = 2**26


def write(path: FilePath, kind: str, data: dict[str, Json]) -> None:
    """Write ``data``, plain JSON values, as a file of this kind.

    Raises
    ------
    FileError
        ``path`` is no path, or a device or a pipe is there, or its folder does not exist or cannot
        be written; the data are too large to be read again.
    TypeError, ValueError
        The data are no plain JSON values.
    """
    path = _name(path)
    if os.path.exists(path) and not (os.path.isfile(path) or os.path.isdir(path)):
        raise FileError(f"cannot write {path!r}: a device or a pipe is there, which a file would "
                        "replace; choose another place")
    path = os.path.realpath(path)                                   # a link stays, its file is new
    data = {"format": kind, "version": 1} | data
    text = json.dumps(data | {"sha256": digest(data)})
    if len(text) > LARGEST:
        raise FileError(f"cannot write {path!r}: it would have {len(text)} bytes, and files of up "
                        f"to {LARGEST} can be read again; truncate the solution")
    temporary = os.path.join(os.path.dirname(path), f".{secrets.token_hex(8)}.part")
    try:
        with open(temporary, "x", encoding="utf-8") as file:        # with the usual permissions
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except OSError as error:
        raise FileError(f"cannot write {path!r}: {error.strerror}; choose another place") from error
    finally:
        with contextlib.suppress(OSError):
            os.unlink(temporary)


def read(path: FilePath, kind: str, what: str, way_out: str) -> dict[str, Json]:
    """The contents of a file of this kind, without its checksum.

    ``what`` and ``way_out`` are for the sentences of errors: "a saved ftseries solution", "save
    the solution again".

    Raises
    ------
    FileError
        The file cannot be read, is of another kind, or is damaged.
    """
    path = _name(path)
    try:
        with open(path, "rb") as file:
            content = file.read(LARGEST + 1)
    except OSError as error:
        raise FileError(f"cannot read {path!r}: {error.strerror}") from error
    if len(content) > LARGEST:
        raise FileError(f"{path!r} has more than {LARGEST} bytes, so it is not {what}")
    try:
        data = json.loads(content.decode("utf-8"), object_pairs_hook=_object,
                          parse_constant=_constant)
    except (ValueError, RecursionError) as error:
        reason = str(error).partition(";")[0]
        raise FileError(f"{path!r} is damaged or not JSON ({reason}); {way_out}") from None
    if not isinstance(data, dict) or data.get("format") != kind:
        raise FileError(f"{path!r} is not {what}")
    if data.get("version") != 1 or isinstance(data["version"], (bool, float)):
        raise FileError(f"{path!r} has format version {shown(data.get('version'))}; this reads 1")
    stated = data.pop("sha256", None)
    try:
        checksum = digest(data)
    except (ValueError, RecursionError) as error:                    # 1e999, or too deep
        raise FileError(f"{path!r} is damaged ({error}); {way_out}") from None
    if stated != checksum:
        raise FileError(f"{path!r} is damaged: its contents do not match their checksum; {way_out}")
    return data


def _name(path: FilePath) -> str:
    try:
        name = os.fsdecode(path)
        os.fsencode(name)
    except (TypeError, UnicodeError):
        name = "\0"
    if "\0" in name:
        raise FileError(f"{shown(path)} is not the name of a file; give a text such as "
                        "'solution.json' or a Path")
    return name


def digest(data: Json) -> str:
    """SHA-256 of the data as JSON with sorted keys."""
    text = json.dumps(data, sort_keys=True, allow_nan=False)
    return hashlib.sha256(text.encode()).hexdigest()


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    data = dict(pairs)
    if len(data) < len(pairs):
        twice, _ = Counter(key for key, _ in pairs).most_common(1)[0]
        raise ValueError(f"the key {shown(twice)} stands twice")
    return data


def _constant(name: str) -> None:
    raise ValueError(f"{name} is no number")
