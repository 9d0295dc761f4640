"""Compare the public functions of a package on disk with their expectations."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from types import ModuleType
from typing import Any, TypeAlias

import mpmath
import numpy as np

from ...maps.chart import Chart
from ..cases import Batch, batches
from ..cases.decimals import DIGITS
from ..cases.exact import Expectation
from ..lowered import lower_chart
from ..rows import Table
from ..signatures import POSES
from .errors import ValidationFailed
from .loading import loaded, module_of
from .offered import offered
from .refusals import refuse
from .sample import Choose, everything

Objects: TypeAlias = "np.ndarray[Any, np.dtype[Any]]"


def validate(folder: Path, chart: Chart, choose: Choose = everything, tables: Sequence[Table] = (POSES,)) -> int:
    """Check the modules of a chart in a folder, one for each table; return how many function calls were compared.

    ``choose`` leaves out what other charts of the package have shown of its geometry.

    Raises
    ------
    ValidationFailed
        Naming the function, the layout and the first component that differs.
    """
    with loaded(folder) as package, mpmath.workdps(DIGITS):
        return sum(_validate(module_of(package, chart, table), chart, table, choose) for table in tables)


def _validate(module: ModuleType, chart: Chart, table: Table, choose: Choose) -> int:
    offered(module, chart, table)
    chosen = choose(lower_chart(chart, table), batches(chart, table))
    compared = sum(_check(module, batch, (-1, 0) if whole else (-1,)) for batch, whole in chosen)
    return compared + refuse(module, table)


def _check(module: ModuleType, batch: Batch, layouts: Sequence[int]) -> int:
    """Call one function on a batch in some layouts, and on its poses alone; return the number of calls.

    Objects in a batch run the in-place form of the kernel, those of a single pose its plain form.
    """
    function = getattr(module, batch.function)
    columns = zip(*(case.arguments for case in batch.cases), strict=True)
    kinds = batch.row.arguments
    arguments = [_array(rows, array.shape) for rows, array in zip(columns, kinds, strict=True)]
    place = f"{_name(module)}.{batch.function}"
    for axis in layouts:
        where = f"{place}(axis={axis})"
        given = [_components_first(a) if axis == 0 else a for a in arguments]
        parts = _call(function, given, batch.branch, axis, where)
        rows = [_batch_first(part) if axis == 0 else part for part in parts]
        results = np.concatenate([row.reshape(len(batch.cases), -1) for row in rows], axis=-1)
        for row, case in zip(results, batch.cases, strict=True):
            _compare(row, case, batch.agree, where)
    for pose, case in zip(zip(*arguments, strict=True), batch.cases, strict=True):
        parts = _call(function, pose, batch.branch, -1, place)
        _compare(np.concatenate([part.ravel() for part in parts]), case, batch.agree, place)
    return len(layouts) + len(batch.cases)


def _call(function: Any, arrays: Sequence[Objects], branch: tuple[int, ...], axis: int, where: str) -> tuple[Any, ...]:
    try:
        found = function(*arrays, *branch, axis=axis)
    except (ArithmeticError, TypeError, ValueError) as error:
        raise ValidationFailed(f"{where}, no component: {error}") from error
    return found if isinstance(found, tuple) else (found,)


def _compare(row: Any, case: Expectation, agree: Any, where: str) -> None:
    if len(row) != len(case.result):
        raise ValidationFailed(f"{where}: {len(row)} components, expected {len(case.result)}")
    for index, (got, expected) in enumerate(zip(row, case.result, strict=True)):
        try:
            right = agree(got, expected)
        except TypeError as error:
            raise ValidationFailed(f"{where}, component {index}: {error}") from error
        if not right:
            raise ValidationFailed(f"{where}, component {index}: {got} is not {expected}")


def _name(module: ModuleType) -> str:
    return module.__name__.rpartition(".")[2]


def _array(rows: tuple[tuple[Any, ...], ...], shape: tuple[int, ...]) -> Objects:
    """The components of a batch as an object array, in the shape of the argument."""
    array = np.empty((len(rows), len(rows[0])), object)
    for index, row in enumerate(rows):
        array[index] = row
    return array.reshape(len(rows), *shape)


def _components_first(array: Objects) -> Objects:
    return np.moveaxis(array, 0, -1)


def _batch_first(array: Objects) -> Objects:
    return np.moveaxis(array, -1, 0)
