"""The command line: parse, call, show.

======== =======================================================================================================
options  order lists such as ``1-5,8``, and other parsed options
commands what the command takes, and exit codes
generate write kernels, or check those on disk
show     formulas, and what there is
compare  parameterizations side by side: `compared` has their figures, `compare_page` and `compare_plot` show them
verify   decide the papers' equations and report
display  progress, differences and messages
======== =======================================================================================================

`commands` imports Click alone: what is asked for is loaded when it is run.
"""

from .commands import run

__all__ = ["run"]
