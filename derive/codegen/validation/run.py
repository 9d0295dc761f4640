"""Load a package of kernels from disk and compare its public functions with their expectations."""

from __future__ import annotations

import importlib
import importlib.util
import itertools
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any, TypeAlias

import mpmath
import numpy as np

from ...maps import Cayley
from . import digits, exact
from .exact import Expectation

SHAPES = {
    "q": (8,), "R": (2, 3, 3), "T": (4, 4), "r": (3,), "angle": (2,),
}  # fmt: skip
"""Component shapes of arguments which are not dual vectors, by parameter name."""

Objects: TypeAlias = "np.ndarray[Any, np.dtype[Any]]"

_serial = itertools.count()


class ValidationFailed(Exception):
    """An emitted kernel does not compute its formula."""


def validate(folder: Path, cayley: Cayley) -> int:
    """Check the module of an order in a folder; return how many function calls were compared.

    Raises
    ------
    ValidationFailed
        Naming the function, the layout and the first component that differs.
    """
    with _package(folder) as package, mpmath.workdps(digits.DIGITS):
        module = importlib.import_module(f"{package}.cayley{cayley.order}")
        exactly = sum(_check(module, (case,), _same) for case in exact.expectations(cayley))
        batches = (tuple(map(_decimal, batch)) for batch in digits.expectations(cayley))
        closely = sum(_check(module, batch, digits.close) for batch in batches)
    return exactly + closely


@contextmanager
def _package(folder: Path) -> Iterator[str]:
    """Import a folder as a package under a name of its own, so that no other copy answers for it."""
    name = f"_dualcay_validated_{next(_serial)}"
    init = folder / "__init__.py"
    spec = importlib.util.spec_from_file_location(name, init, submodule_search_locations=[str(folder)])
    if spec is None or spec.loader is None:
        raise ValidationFailed(f"{folder} is not a package")
    package = importlib.util.module_from_spec(spec)
    sys.modules[name] = package
    writes, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    try:
        spec.loader.exec_module(package)
        yield name
    finally:
        sys.dont_write_bytecode = writes
        for loaded in [key for key in sys.modules if key == name or key.startswith(name + ".")]:
            del sys.modules[loaded]


def _decimal(case: Expectation) -> Expectation:
    arguments = tuple(tuple(digits.Decimal(c) for c in argument) for argument in case.arguments)
    return Expectation(case.function, arguments, case.result)


def _check(module: ModuleType, batch: tuple[Expectation, ...], agree: Any) -> int:
    """Call one function on a batch in both layouts, and on its poses alone; return the number of calls.

    Objects in a batch run the in-place form of the kernel, those of a single pose its plain form.
    """
    name, *branch = batch[0].function.split()
    function = getattr(module, name)
    code = function.__code__
    parameters = code.co_varnames[: code.co_argcount]
    columns = zip(*(case.arguments for case in batch), strict=True)
    arguments = [_array(rows, parameter) for rows, parameter in zip(columns, parameters, strict=False)]
    k = tuple(map(int, branch))
    place = f"{_name(module)}.{batch[0].function}"
    for axis in (-1, 0):
        where = f"{place}(axis={axis})"
        parts = _call(function, [_components_first(a) if axis == 0 else a for a in arguments], k, axis, where)
        rows = [_batch_first(part) if axis == 0 else part for part in parts]
        results = np.concatenate([row.reshape(len(batch), -1) for row in rows], axis=-1)
        for row, case in zip(results, batch, strict=True):
            _compare(row, case, agree, where)
    for pose, case in zip(zip(*arguments, strict=True), batch, strict=True):
        parts = _call(function, pose, k, -1, place)
        _compare(np.concatenate([part.ravel() for part in parts]), case, agree, place)
    return 2 + len(batch)


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
        if not agree(got, expected):
            raise ValidationFailed(f"{where}, component {index}: {got} is not {expected}")


def _name(module: ModuleType) -> str:
    return module.__name__.rpartition(".")[2]


def _array(rows: tuple[tuple[Any, ...], ...], parameter: str) -> Objects:
    """The components of a batch as an object array, in the shape of the parameter."""
    array = np.empty((len(rows), len(rows[0])), object)
    for index, row in enumerate(rows):
        array[index] = row
    return array.reshape(len(rows), *SHAPES.get(parameter, (len(rows[0]),)))


def _components_first(array: Objects) -> Objects:
    return np.moveaxis(array, 0, -1)


def _batch_first(array: Objects) -> Objects:
    return np.moveaxis(array, -1, 0)


def _same(got: Any, expected: Any) -> bool:
    return bool(got == expected)
