"""What can be generated: targets, their committed modules, and the files every package of a target holds."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

ORDERS = (1, 2, 3, 4, 5, 8)
"""Orders whose modules are committed."""

MAX_ORDER = 64
"""Largest order generated without being asked twice: beyond it proofs take minutes."""

CHECKOUT = Path(__file__).parent.parent.parent
COMMITTED = CHECKOUT / "generated" / "dualcay"
"""Where the committed kernels lie in a checkout."""


def is_checkout() -> bool:
    """Whether the toolkit runs from a checkout of the project, whose kernels it may rewrite."""
    return (CHECKOUT / "templates").is_dir() and (CHECKOUT / "pyproject.toml").is_file()


@dataclass(frozen=True, slots=True)
class Target:
    """A language kernels are printed in, and the files its packages share."""

    name: str
    shared: tuple[str, ...]


TARGETS = {"numpy": Target("numpy", ("__init__.py", "_runtime.py", "_tools.py", "py.typed"))}


def module_name(order: int) -> str:
    """File name of the module of an order."""
    return f"cayley{order}.py"


def order_of(command: str) -> int | None:
    """The order in a module's header command; None for the command of shared files."""
    found = re.search(r" -n (\d+)\b", command)
    return int(found.group(1)) if found else None
