"""Output of texts: rendered templates, files written together or compared, tables, and lists of results.

This package contains no mathematics and imports no other package of the toolkit.
"""

from .files import Difference, RefusedError, compare, write
from .pages import generated, render, source

__all__ = ["Difference", "RefusedError", "compare", "generated", "render", "source", "write"]
