"""Check certificates: ``python -m ftseries.certify FILE …`` proves what each of them claims."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from ..errors import FTSeriesError
from .checking import check


def main(paths: Sequence[str]) -> int:
    """Exit status: the number of certificates that are refused."""
    if not paths:
        print("usage: python -m ftseries.certify FILE …", file=sys.stderr)
        return 2
    refused = 0
    for path in paths:
        try:
            print(f"{path}: {check(path)}")
        except FTSeriesError as error:
            refused += 1
            print(f"{path}: {error}", file=sys.stderr)
    return refused


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
