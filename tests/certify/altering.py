"""Certificates that say something else, with a checksum that fits."""

import pytest

from ftseries.certify import NotProved, certificate, check
from ftseries.errors import FileError

#: an inequality does not hold, or an entry cannot stand there
REFUSED = "fails for the numbers of this certificate|is damaged: .*; prove the theorem again"


def set_at(*keys, value):
    """A change: what stands at data[key][key]… becomes ``value``."""
    def change(data):
        for key in keys[:-1]:
            data = data[key]
        data[keys[-1]] = value
    return change


def refused(path, change):
    """The altered certificate proves nothing, although its checksum is fresh."""
    data = certificate.read(path)
    change(data)
    certificate.write(path, data)
    with pytest.raises((NotProved, FileError), match=REFUSED):
        check(path)
