"""Checks of arguments; an error names the argument, and the row where it is wrong."""

from __future__ import annotations

from typing import Any, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike

from ._kernel import Array

Frame: TypeAlias = Literal["space", "body"]
FRAMES = get_args(Frame)


def finite(name: str, value: ArrayLike, shape: tuple[int, ...], rows: bool = False) -> Array:
    """Return an argument as an array of floats, after a check of its shape and values; ``rows`` names a wrong row."""
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ValueError(f"{name} must have shape {shape}, got rows of several shapes") from error
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{name} must hold real numbers, got dtype {array.dtype}")
    if array.shape != shape:
        raise ValueError(f"{name} must have shape {shape}, got {array.shape}")
    if not np.isfinite(array).all():
        wrong = tuple(np.argwhere(~np.isfinite(array))[0])
        raise ValueError(f"{name} must be finite, got {array[wrong]} in {f'row {wrong[0]}' if rows else 'it'}")
    return array.astype(float)


def increasing(name: str, t: ArrayLike) -> Array:
    """Return at least two times, after a check that they increase."""
    shape = np.shape(t)
    if len(shape) != 1 or shape[0] < 2:
        raise ValueError(f"{name} must have shape (T,) with at least two times, got {shape}")
    times = finite(name, t, shape, rows=True)
    wrong = np.flatnonzero(np.diff(times) <= 0) + 1
    if wrong.size:
        former, later = times[wrong[0] - 1 : wrong[0] + 1]
        raise ValueError(f"{name} must increase, got {later:g} after {former:g} in row {wrong[0]}")
    return times


def vector_size(module: Any, poses: bool = False) -> int:
    """Return the number of components of v; raise TypeError unless the module is a chart, or one of poses."""
    size = len(module.identity()) if hasattr(module, "from_exponential") else 0
    if size not in ((6,) if poses else (3, 6)):
        raise TypeError(f"module must be a kernel module{' of poses' * poses}, as cayley2 is, got {module!r}")
    return size


def require_one_of(name: str, value: str, allowed: tuple[str, ...]) -> str:
    """Return a value; raise ValueError unless it is one of those allowed."""
    if value not in allowed:
        raise ValueError(f"{name} must be one of {', '.join(map(repr, allowed))}, got {value!r}")
    return value
