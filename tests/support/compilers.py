"""C compiler of the tests, by the toolkit's rules; its warnings, and macros of other libraries."""

from __future__ import annotations

import os
import shlex
import shutil

NAMES = ("cc", "gcc", "clang")
MISSING = "no C compiler is found (install gcc and g++, or name one in the variable CC)"
WARNINGS = (
    "-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Wstrict-aliasing", "-Wundef", "-Wdouble-promotion",
    "-Wfloat-equal", "-Werror", "-pedantic",
)  # fmt: skip
FOREIGN = (
    "near", "far", "small", "hyper", "interface", "pascal", "cdecl", "IN", "OUT", "OPTIONAL", "CONST", "VOID", "ERROR",
    "DELETE", "TRUE", "FALSE", "PI", "HALF_PI", "TWO_PI", "EULER", "DEG_TO_RAD", "HIGH", "LOW", "INPUT", "OUTPUT",
    "CHANGE", "RISING", "FALLING", "DEFAULT", "EXTERNAL", "SERIAL", "DISPLAY", "SS", "A0", "A1", "A2", "A3", "None",
    "Bool", "Status", "True", "False", "Success", "Always", "Above", "Below", "Unsorted", "Complex", "B0", "B50", "B75",
    "B110", "B300", "ECHO", "TAB0", "CR0", "NL0", "FF0", "VT0", "BS0", "I", "complex", "imaginary", "unix",
    "linux", "sun",
)  # fmt: skip
FOREIGN_FUNCTIONS = (
    "min", "max", "round", "sq", "bit", "radians", "degrees", "constrain", "word", "F", "lowByte", "highByte",
)  # fmt: skip
"""Macros of windows.h, Arduino.h, X.h, termios.h and complex.h that begin with no prefix: names, and functions."""


def find() -> str | None:
    """Return the compiler named in CC, or None if it is missing; if CC is not set, the first compiler found."""
    named = shlex.split(os.environ.get("CC", ""))
    return next(filter(None, map(shutil.which, named[:1] or NAMES)), None)
