"""Texts on their way out: filled into templates, put on disk, compared with what is there.

========= ==================================================
templates the template environment; every hole, nothing more
files     write all or none, compare
exchange  a folder's files for new ones, whenever the process is killed
tables    tables as text, of any width
listing   lists of results, as lines and as HTML
========= ==================================================

This room knows nothing of the mathematics, and imports no other.
"""

from .files import Difference, RefusedError, compare, write
from .templates import render

__all__ = ["Difference", "RefusedError", "compare", "render", "write"]
