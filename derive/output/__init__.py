"""Texts on their way out: rendered from templates, put on disk, compared with what is there.

========= ==================================================
templates the template environment
files     write all or none, compare
exchange  replace files of a folder, safe against a kill
tables    tables as text, of any width
listing   lists of results, as lines and as HTML
========= ==================================================

This room knows nothing of the mathematics, and imports no other.
"""

from .files import Difference, RefusedError, compare, write
from .templates import render

__all__ = ["Difference", "RefusedError", "compare", "render", "write"]
