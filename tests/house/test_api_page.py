"""The page on the package describes all that is public."""

import pkgutil
import re
from pathlib import Path

import pytest

import ftseries

PAGE = (Path(__file__).parents[2] / "book" / "api.md").read_text(encoding="utf-8")
DESCRIBED = set(re.findall(r"^\.\. auto\w+:: ([\w.]+)$", PAGE, re.MULTILINE))
MODULES = [module.name for module in pkgutil.walk_packages(ftseries.__path__, "ftseries.")
           if "._" not in module.name]


@pytest.mark.parametrize("name", ftseries.__all__)
def test_every_public_name_is_described(name):
    home = getattr(getattr(ftseries, name), "__module__", "")
    assert f"ftseries.{name}" in DESCRIBED or home == "ftseries.errors" or name == "figure_eight"


@pytest.mark.parametrize("name", ["ftseries", *MODULES])
def test_every_module_is_described(name):
    view = re.fullmatch(r"ftseries\.explorers\.\w+", name)        # base, or one per explorer
    described = name in DESCRIBED or (view and not name.endswith(".base"))
    assert described, f"add '.. automodule:: {name}' to book/api.md"
