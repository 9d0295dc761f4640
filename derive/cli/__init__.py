"""The command line: parse options, call the toolkit, show results.

======== ==================================================
options  order lists such as ``1-5,8``, and other parsed options
commands commands with their options, and exit codes
generate write kernels, or check those on disk
show     formulas
compare  parameterizations side by side
verify   decide the papers' equations and report
display  progress and differences
======== ==================================================

`commands` imports Click alone: each command loads its module when it runs.
"""

from .commands import run

__all__ = ["run"]
