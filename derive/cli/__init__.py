"""The command line: parse options, call the toolkit, show results.

`commands` imports Click alone. Each command loads the module with its name when it runs.
"""

from .commands import run

__all__ = ["run"]
