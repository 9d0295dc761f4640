"""Texts on their way out: filled into templates, put on disk, compared with what is there.

========= ==================================================
templates the template environment; every hole, nothing more
files     write all or none, compare
========= ==================================================

This room knows nothing of the mathematics, and imports no other.
"""

from .files import Difference, RefusedError
from .templates import render

__all__ = ["Difference", "RefusedError", "render"]
