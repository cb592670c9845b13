"""JSON files with a checksum.

Format.  ``{"format": kind, "version": 1, …, "sha256"}``, the last one of everything else, so that
no damage goes unnoticed.  A file appears complete or not at all.
"""

from __future__ import annotations

import hashlib
import json
import os

from .aliases import FilePath, Json
from .errors import FileError

__all__ = ["read", "write"]


def write(path: FilePath, kind: str, data: dict[str, Json]) -> None:
    """Write ``data``, plain JSON values, as a file of this kind.

    Raises
    ------
    FileError
        ``path`` is no path, or its folder does not exist or cannot be written.
    TypeError, ValueError
        The data are no plain JSON values.
    """
    path = _name(path)
    data = {"format": kind, "version": 1} | data
    text = json.dumps(data | {"sha256": digest(data)})
    temporary = f"{path}.{os.getpid()}.part"
    try:
        with open(temporary, "w", encoding="utf-8") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except OSError as error:
        raise FileError(f"cannot write {path!r}: {error.strerror}; choose another place") from error
    finally:
        if os.path.exists(temporary):
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
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
    except OSError as error:
        raise FileError(f"cannot read {path!r}: {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise FileError(f"{path!r} is damaged or not JSON ({error}); {way_out}") from None
    if not isinstance(data, dict) or data.get("format") != kind:
        raise FileError(f"{path!r} is not {what}")
    if data.get("version") != 1:
        raise FileError(f"{path!r} has format version {data.get('version')!r}; this reads 1")
    if data.pop("sha256", None) != digest(data):
        raise FileError(f"{path!r} is damaged: its contents do not match their checksum; {way_out}")
    return data


def _name(path: FilePath) -> str:
    try:
        return os.fsdecode(path)
    except TypeError:
        raise FileError(f"{path!r} is not the name of a file; give a text such as 'solution.json' "
                        "or a Path") from None


def digest(data: Json) -> str:
    """SHA-256 of the data as JSON with sorted keys."""
    return hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()
