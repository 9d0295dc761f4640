"""What a module offers: its functions under their names, and the constants of its chart.

Each module says so itself, though the functions are the same in all: so every one is asked.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping
from types import ModuleType

from ...maps.chart import Chart
from ..rows import Table
from .errors import ValidationFailed

FURTHER = ("identity", "random")
"""Functions that are made otherwise than from a program."""

DIGITS = 30
ROUNDED = 2 * sys.float_info.epsilon
"""What an angle may be off by, by its own size: a multiple of π is one product of rounded numbers, rounded."""


def offered(module: ModuleType, chart: Chart, table: Table) -> None:
    """Compare names and constants of a module with its table and chart.

    Raises
    ------
    ValidationFailed
        Naming what is not what it is called.
    """
    names = _names(module, chart, table)
    for name, method in names.items():
        function = getattr(module, name, None)
        made = getattr(function, "__self__", None), getattr(function, "__name__", None)
        if made != (module.KERNELS, method):
            raise ValidationFailed(f"{module.__name__}.{name} is not the function {method} of KERNELS")
    if sorted(module.__all__) != sorted(names):
        raise ValidationFailed(f"{module.__name__}.__all__ holds other names than {', '.join(names)}")
    if chart.order != module.ORDER:
        raise ValidationFailed(f"{module.__name__}.ORDER is {module.ORDER}, not {chart.order}")
    _same_angles(module, chart)


def _names(module: ModuleType, chart: Chart, table: Table) -> Mapping[str, str]:
    """Names of functions in a module, and as methods."""
    own = (*table.public, "singular_angles", *(name for name in FURTHER if hasattr(module.KERNELS, name)))
    return {name: name for name in own} | table.aliases(chart)


def _same_angles(module: ModuleType, chart: Chart) -> None:
    found, stated = module.singular_angles(), [float(angle.evalf(DIGITS)) for angle in chart.singular_angles]
    same = [math.isclose(a, b, rel_tol=ROUNDED, abs_tol=0) for a, b in zip(found, stated, strict=False)]
    if not all(same) or len(found) != len(stated):
        raise ValidationFailed(f"{module.__name__}.singular_angles() is {found}, not {stated}")
