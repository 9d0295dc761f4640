"""What is committed, where, and the commands that make it."""

from __future__ import annotations

import re
from pathlib import Path

from ..maps.chart import Chart

ORDERS = (1, 2, 3, 4, 5, 8)
"""Orders whose modules are committed."""

TARGET = "numpy"
"""Target of the committed modules."""

MAX_ORDER = 64
"""Largest order generated without being asked twice: proof times beyond it are not measured."""

CHECKOUT = Path(__file__).parent.parent.parent
COMMITTED = CHECKOUT / "generated" / "dualcay"
"""Where the committed kernels lie in a checkout."""


def is_checkout() -> bool:
    """Whether the toolkit runs from a checkout of the project, whose kernels it may rewrite."""
    return (CHECKOUT / "templates").is_dir() and (CHECKOUT / "pyproject.toml").is_file()


def command(target: str, chart: Chart) -> str:
    """The command that writes the module of a chart, wherever it is put."""
    return f"python -m derive generate {chart.selection} --target {target}"


def order_of(line: str) -> int | None:
    """The order in the command of a module; None for the command of shared files."""
    found = re.search(r" -n (\d+)\b", line)
    return int(found.group(1)) if found else None
