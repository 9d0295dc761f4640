"""Signatures of all kernel functions, and arguments for them."""

from __future__ import annotations

from collections.abc import Sequence
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

from derive.codegen.signatures import PUBLIC, Array
from tests.support import sampling


def kind(array: Array) -> str:
    """Return the kind of an argument: "v" for a vector, "w" for any dual vector, or its own name."""
    if array.vector:
        return "v"
    return "w" if array.shape == (6,) else array.name


class Signature(NamedTuple):
    """Kinds of the arguments (keys of SHAPES), and shape of the result."""

    arguments: str
    result: tuple[int, ...]
    complex: bool = True


SHAPES = {kind(array): array.shape for row in PUBLIC.values() for array in row.arguments}

# Functions that return one array and take axis= and out=. from_screw is excluded: an argument of it is named axis.
SIGNATURES = {
    name: Signature("".join(map(kind, row.arguments)), row.shape, not row.real)
    for row in PUBLIC.values()
    for name in (row.name, *row.aliases)
    if len(row.results) == 1 and row.name != "from_screw"
}

KINDS = {
    (row.arguments, row.result, row.complex, bool(PUBLIC[name].branch)): name
    for name, row in reversed(SIGNATURES.items())
    if name in PUBLIC
}
"""Sample of functions for tests of arrays, which pass one text in all: the first one of each kind."""


def inputs(
    kernel: ModuleType, name: str, order: int, shape: tuple[int, ...] = (), dtype: Any = np.float64
) -> list[np.ndarray]:
    """Draw different arguments of a function in a batch shape, with components last."""
    count = int(np.prod(shape))
    drawn = []
    for i, kind in enumerate(SIGNATURES[name].arguments):
        v = sampling.poses(order, "uniform", count=count + 3)[3 if i == 0 else 0 :][:count]
        if kind == "q":
            value = kernel.quaternion(v)
        elif kind == "R":
            value = kernel.tensor(v)
        elif kind == "T":
            value = kernel.pose(v)
        elif kind == "r":
            value = sampling.points(name, count=count)
        elif kind == "w":
            value = sampling.dual_vectors(name, count=count)
        elif kind == "t":
            value = sampling.points(name, count=count)[:, 0]
        else:
            value = v
        drawn.append(np.ascontiguousarray(value).reshape(shape + SHAPES[kind]).astype(dtype))
    return drawn


def components_first(array: Any, rank: int) -> np.ndarray:
    """Return an array with components first: the last `rank` axes move to the front."""
    array = np.asarray(array)
    return np.array(np.moveaxis(array, range(-rank, 0), range(rank)), order="C")


def rows_of(name: str, arguments: Sequence[Any]) -> list[np.ndarray]:
    """Return the arguments of a function with components first."""
    kinds = SIGNATURES[name].arguments
    return [components_first(a, len(SHAPES[kind])) for a, kind in zip(arguments, kinds, strict=True)]


def components_last(array: Any, rank: int) -> np.ndarray:
    return np.moveaxis(array, range(rank), range(-rank, 0))


def assert_nearly_equal(got: Any, expected: Any, eps: int = 16) -> None:
    """Require equality up to rounding, for one program run on other blocks or on Python floats."""
    assert got.shape == expected.shape
    assert got.dtype == expected.dtype
    unit = np.finfo(got.dtype).eps
    size = np.nanmax(np.abs(expected), initial=1)
    np.testing.assert_allclose(got, expected, rtol=eps * unit, atol=eps * unit * size)
