"""The command ``dualcay``, which reports missing libraries before it imports any."""

from __future__ import annotations

import importlib.util
import io
import sys

from .about import INSTALL, __version__

NEEDED = ("click", "flint", "jinja2", "latex2mathml", "mpmath", "pcpp", "pycparser", "rich", "sympy")
INTERRUPTED = 130


def main() -> int:
    """Run the command line and return its exit code: 3 if libraries are missing, except for help and version."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # independent of the locale; file names may be invalid UTF-8
            stream.reconfigure(encoding="utf-8", errors="surrogateescape")
    try:
        missing = [name for name in NEEDED if importlib.util.find_spec(name) is None]
        if missing:
            return _without(", ".join(missing), set(sys.argv[1:]))
        from .cli import run

        return run()
    except KeyboardInterrupt:
        print("dualcay: interrupted", file=sys.stderr)
        return INTERRUPTED


def _without(missing: str, arguments: set[str]) -> int:
    """Print help, the version, or the names of the missing libraries, and return the exit code."""
    if arguments & {"-V", "--version"}:
        print(f"dualcay, version {__version__}")
        return 0
    if arguments & {"-h", "--help"} or not arguments:
        print(f"dualcay {__version__}: derive, prove and emit kernels for rigid motion, for any order n\n")
        print(f"This command needs {missing}: install with  {INSTALL}")
        print("The kernels need NumPy alone:  python -m dualcay  lists them.")
        return 0
    print(f"dualcay: needs {missing}: install with  {INSTALL}", file=sys.stderr)
    return 3


if __name__ == "__main__":
    sys.exit(main())
