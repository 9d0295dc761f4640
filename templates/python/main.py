"""Command line entry point that lists the contents of the package."""

from __future__ import annotations

from collections import Counter

from . import __version__, _modules, backend


def main() -> None:
    """Print the version, the kernel modules, and the number of functions on each backend."""
    print(f"{__package__} {__version__}")
    print(f"modules  {', '.join(_modules())}")
    for name, count in Counter(backend().values()).items():
        print(f"backend  {name}: {count} functions")


if __name__ == "__main__":
    main()
