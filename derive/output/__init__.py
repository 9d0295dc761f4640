"""Output of texts: rendered from templates, written to disk, compared with files on disk.

========= ==================================================
templates the template environment
files     write all or none, compare
exchange  replace files of a folder, safe against a kill
tables    tables as text, of any width
listing   lists of results, as lines and as HTML
========= ==================================================

This package contains no mathematics and imports no other package of the toolkit.
"""

from .files import Difference, RefusedError, compare, write
from .templates import render

__all__ = ["Difference", "RefusedError", "compare", "render", "write"]
