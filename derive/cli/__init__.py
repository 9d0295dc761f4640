"""The command line: parse, call, show.

======== =============================================================
commands generate, show, list (and their exit codes)
verify   decide the papers' equations and report
options  order lists such as ``1-5,8``, and other parsed options
display  tables, progress and errors on stderr
======== =============================================================
"""

from .commands import run

__all__ = ["run"]
