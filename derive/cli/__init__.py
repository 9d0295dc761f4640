"""The command line: parse options, call the toolkit, show results.

`commands` imports Click alone. A command loads its module when it runs.
"""

from .commands import run

__all__ = ["run"]
