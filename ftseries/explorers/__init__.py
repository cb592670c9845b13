"""Explorers: pictures that move with their sliders, in a notebook and in the built page alike.

Each function returns an ipywidgets layout to be shown by the cell that calls it.  The browser
evaluates the series itself, so an explorer works with no kernel, no server and no network.
"""

from .cubic import cubic

__all__ = ["cubic"]
