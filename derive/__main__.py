"""The command ``dualcay``: says what to install before it imports anything that may be missing."""

from __future__ import annotations

import importlib.util
import sys

NEEDED = ("click", "jinja2", "latex2mathml", "pcpp", "pycparser", "rich", "sympy")


def main() -> int:
    """Run the command line; 3 when the toolkit's libraries are not installed."""
    missing = [name for name in NEEDED if importlib.util.find_spec(name) is None]
    if missing:
        print(f'dualcay: needs {", ".join(missing)}: install with  pip install "dualcay[derive]"', file=sys.stderr)
        return 3
    from .cli import run

    return run()


if __name__ == "__main__":
    sys.exit(main())
