"""Search for a C compiler for the tests, by the toolkit's rules."""

from __future__ import annotations

import os
import shlex
import shutil

NAMES = ("cc", "gcc", "clang")
MISSING = "no C compiler is found (install gcc and g++, or name one in the variable CC)"


def find() -> str | None:
    """Return the compiler named in CC, or None if it is missing; if CC is not set, the first compiler found."""
    named = shlex.split(os.environ.get("CC", ""))
    return next(filter(None, map(shutil.which, named[:1] or NAMES)), None)
