"""Explorers in the built page, without a kernel: they render, every control works, numbers agree."""

import numpy as np
import pytest

import ftseries as fts
from ftseries.references import cubic, mathieu

from browser.pages import NAMES, Explorer

pytestmark = pytest.mark.filterwarnings("ignore::ftseries.ConvergenceWarning")

CASES = 6           # random states of each explorer
TOLERANCE = 1e-10   # what the page promises; it shows 13 digits


def test_every_explorer_renders(visit, address):
    page = visit(f"{address}/explorers.html")
    explorers = [Explorer(page, number) for number in range(len(NAMES))]
    assert page.locator(".ft-explorer").count() == len(NAMES)
    assert page.locator(".ft-error").count() == 0
    for explorer in explorers:
        assert "order" in explorer.status
        assert all(len(picture) > 2000 for picture in explorer.pictures())     # not blank
    assert page.locator("mjx-container").count() > 0                        # formulas beside them
