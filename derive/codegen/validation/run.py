"""Run the functions of a Python package on exact numbers, and compare their results with the expected ones."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Collection, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

from ...maps.chart import Chart
from ..rows import Table
from ..signatures import POSES, geometry, lower_chart
from . import reals
from .batches import Batch, ValidationFailed, batches, compare
from .decimals import EXACT_DIGITS
from .loading import loaded, module_of

WIRED = ("quaternion", "shadow", "principal")
"""Functions that together read a chart's scalar programs, its ``turns`` and its ``returns``."""

ANGLE_ROUNDING = 2 * sys.float_info.epsilon
"""Relative error of a singular angle: a multiple of π is a rounded product of rounded numbers."""


def validate(folder: Path, chart: Chart, geometry: bool, tables: Sequence[Table] = (POSES,)) -> int:
    """Compare the modules of a chart, one for each table, with its formulas; return the number of calls that agree.

    With ``geometry`` all functions are called, which also tests the geometry programs that all charts share; otherwise
    only `own_functions`. `ValidationFailed` names the function and the first wrong component.
    """
    import numpy as np  # here and below: printing does without it

    with loaded(folder) as package, reals.digits(EXACT_DIGITS), np.errstate(all="ignore"):
        count = 0
        for table in tables:
            module = module_of(package, chart, table)
            require_module(module, chart, table)
            count += sum(_check(module, batch) for batch in chosen(chart, table, geometry))
        return count


def chosen(chart: Chart, table: Table, whole: bool) -> list[Batch]:
    """Return the cases of all functions if ``whole``, else the cases of `own_functions`."""
    return list(batches(chart, table, None if whole else frozenset(own_functions(chart, table))))


def own_functions(chart: Chart, table: Table) -> Collection[str]:
    """Return functions that together read every result of a chart's scalar programs, and functions that only copy v.

    A module for rotations shares the scalars of the module for poses: calls of the functions `WIRED` check this.
    """
    lowered, programs = lower_chart(chart, table), geometry(table)
    shown = {} if table is POSES else lower_chart(chart, POSES).scalars
    found = dict.fromkeys(WIRED if shown else ())
    read: set[tuple[str, int]] = set()
    for name, row in table.public.items():
        program = programs[row.kernel]
        operands = program.operands
        called = (call for call in program.calls if call.function not in shown)
        pairs = ((call.function, place, name) for call in called for place, name in enumerate(call.names))
        results = {(function, place) for function, place, name in pairs if name in operands}
        if row.kernel not in lowered.operations or results - read:
            found[name] = None
            read |= results
    return found


def _check(module: ModuleType, batch: Batch) -> int:
    """Call one function on all cases of a batch at once, then on the last alone; return the number of cases called.

    Programs run objects case by case: one case alone shows the difference, a batch without axes.
    """
    import numpy as np

    function = getattr(module, batch.function)
    columns = zip(*(case.arguments for case in batch.cases), strict=True)
    arguments = [_array(rows, array.shape) for rows, array in zip(columns, batch.row.arguments, strict=True)]
    where = f"{module.__name__.rpartition('.')[2]}.{batch.function}"
    parts = [part.reshape(len(batch.cases), -1) for part in _call(function, arguments, batch.branch, where)]
    for row, case in zip(np.concatenate(parts, axis=-1), batch.cases, strict=True):
        compare(where, row, case.result, batch.agree)
    alone = _call(function, [array[-1] for array in arguments], batch.branch, where)
    compare(where, np.concatenate([np.ravel(part) for part in alone]), batch.cases[-1].result, batch.agree)
    return len(batch.cases) + 1


def _call(function: Callable[..., Any], arrays: Sequence[Any], branch: Sequence[int], where: str) -> tuple[Any, ...]:
    try:
        found = function(*arrays, *branch)
    except (ArithmeticError, AttributeError, NameError, TypeError, ValueError) as error:
        raise ValidationFailed(f"{where}, no component: {error}") from error
    return found if isinstance(found, tuple) else (found,)


def _array(rows: tuple[tuple[Any, ...], ...], shape: tuple[int, ...]) -> Any:
    """Return an argument of all cases as an object array, each case in the shape of the argument."""
    import numpy as np

    array = np.empty((len(rows), len(rows[0])), object)
    for index, row in enumerate(rows):
        array[index] = row
    return array.reshape(len(rows), *shape)


def require_module(module: ModuleType, chart: Chart, table: Table) -> None:
    """Compare the names and constants of a module with its table and chart."""
    makers = (name for name in ("identity", "random") if hasattr(module.KERNELS, name))
    own = (*table.public, "singular_angles", "switch", *makers)
    names = {name: name for name in own} | table.aliases(chart)
    for name, method in names.items():
        function = getattr(module, name, None)
        if (getattr(function, "__self__", None), getattr(function, "__name__", None)) != (module.KERNELS, method):
            raise ValidationFailed(f"{module.__name__}.{name} is not the function {method} of KERNELS")
    if sorted(module.__all__) != sorted(names):
        raise ValidationFailed(f"{module.__name__}.__all__ holds other names than {', '.join(names)}")
    if chart.order != module.ORDER:
        raise ValidationFailed(f"{module.__name__}.ORDER is {module.ORDER}, not {chart.order}")
    found, stated = module.singular_angles(), [float(angle.evalf(EXACT_DIGITS)) for angle in chart.singular_angles]
    near = [math.isclose(a, b, rel_tol=ANGLE_ROUNDING, abs_tol=0) for a, b in zip(found, stated, strict=False)]
    if not all(near) or len(found) != len(stated):
        raise ValidationFailed(f"{module.__name__}.singular_angles() is {found}, not {stated}")
