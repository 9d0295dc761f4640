"""The command line: parse options, call the toolkit, show results.

`commands` imports Click alone. A command loads the module of its own name when it runs.
"""

from .commands import run

__all__ = ["run"]
