"""Which kernels are tested and how they are found."""

from __future__ import annotations

import importlib
from types import ModuleType

ORDERS = (1, 2, 3, 4, 5, 8)


def load(order: int) -> ModuleType:
    """The committed kernel module of an order."""
    return importlib.import_module(f"dualcay.cayley{order}")
