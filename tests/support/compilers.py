"""Search for the C compiler of the tests, by the rules of the toolkit."""

from __future__ import annotations

import os
import shlex
import shutil

NAMES = ("cc", "gcc", "clang")
MISSING = "no C compiler is found (install gcc and g++, or name one in the variable CC)"


def find() -> str | None:
    """Return the compiler named in CC, or None if it is missing; without CC, the first one found."""
    named = shlex.split(os.environ.get("CC", ""))
    return next(filter(None, map(shutil.which, named[:1] or NAMES)), None)
