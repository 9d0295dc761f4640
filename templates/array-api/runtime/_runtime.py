"""Shared path of all kernel functions on arrays of any library: split into components, run the core, stack the result.

A core is straight-line code on the components of its arguments; ``m`` holds the functions it needs beyond + - * /.
Nothing is written in place and no branch depends on data. Kernels therefore compile (``jax.jit``), batch (``vmap``),
differentiate (``grad``, autograd) and stay lazy (Dask). Both sides of a selection are computed on safe arguments, so
gradients are finite wherever the result is finite.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from typing import Any

from ._chart import Array, Call, Chart, Components, Shape, shape_error
from ._libraries import Namespace, functions_for, functions_of, kind_of, library_of, no_array


def call(chart: Chart, name: str, axis: int, *values: Array, table: tuple[str, ...] = (), last: str = "") -> Array:
    """Run a kernel of a chart.

    ``table`` holds decimal constants for the last argument of the kernel. ``last`` is another name for the last array
    argument, used by functions that share a kernel.
    """
    kernel = chart.kernels[name]
    arguments = (*kernel.arguments[:-1], (last, kernel.arguments[-1][1])) if last else kernel.arguments
    pairs = list(zip(arguments, values, strict=True))
    in_turn = sorted(pairs, key=lambda pair: not pair[0][1])  # scalars last: they may be Python numbers
    m = functions_for([(name, value) for (name, _), value in in_turn])
    arrays = [as_array(m, name, value, part, axis, kernel.real) for (name, part), value in pairs]
    asked = Call(chart, name, arguments, table)
    if m.differentiates:
        from ._rules import run  # imports this module; compilers follow an import, but no call that imports

        return run(m, asked, axis, arrays)
    return computed(m, asked, axis, arrays)


def computed(m: Namespace, kernel_call: Call, axis: int, arrays: Sequence[Array]) -> Array:
    """Run a kernel on arrays returned by `as_array`."""
    kernel, given = kernel_call.kernel, list(zip(arrays, kernel_call.arguments, strict=True))
    rows = [components(m, array, part, axis) for array, (_, part) in given]
    batch = _batch({name: _batch_of(array, part, axis) for array, (name, part) in given})
    extra = (constants(kernel_call.table, arrays[0]),) if kernel_call.table else ()
    return pack(m, kernel.core(m, m.scalars(kernel_call.chart), *rows, *extra), kernel.shape, batch, axis, rows[0][0])


def as_array(m: Namespace, name: str, value: Array, part: Shape, axis: int, real: bool = False) -> Array:
    """Return an argument as a floating-point array, after a check of its component axes."""
    if axis not in (-1, 0):
        raise ValueError(f"axis must be -1 (components last) or 0 (components first), got {axis!r}")
    if type(value) is not type(m.like) and (xp := library_of(value)) is not m.xp:
        if xp is None and part and not isinstance(value, list | tuple):
            raise no_array(name, value)
        value = m.taken(value)
    shape = tuple(value.shape)
    found = shape[: len(part)] if axis == 0 else shape[len(shape) - len(part) :]
    if found != part:
        raise shape_error(name, part, axis, shape)
    if real and kind_of(value.dtype).startswith("complex"):
        raise TypeError(f"{name} must be real: this function selects branches; got dtype {kind_of(value.dtype)}")
    return m.floating(value)


def components(m: Namespace, array: Array, part: Shape, axis: int) -> list[Array]:
    """Return the components of an argument in C order, each an array over its batch."""
    indices = product(*map(range, part))
    return [m.part(array, (*index, ...) if axis == 0 else (..., *index)) for index in indices]


def pack(m: Namespace, values: Components, shape: Shape, batch: Shape, axis: int, like: Array) -> Array:
    """Stack the components of a result; constants and unbatched components are broadcast."""
    full = [m.broadcast(value if hasattr(value, "shape") else m.filled(like, value), batch) for value in values]
    return m.reshape(m.stack(full, axis), shape + batch if axis == 0 else batch + shape)


def _batch_of(array: Array, part: Shape, axis: int) -> Shape:
    return tuple(array.shape[len(part) :] if axis == 0 else array.shape[: array.ndim - len(part)])


def _batch(shapes: dict[str, Shape]) -> Shape:
    """Return the broadcast shape of the batches."""
    longest = max(map(len, shapes.values()))
    aligned = [(1,) * (longest - len(shape)) + shape for shape in shapes.values()]
    batch = [next((size for size in sizes if size != 1), 1) for sizes in zip(*aligned, strict=True)]
    # sizes that a compiler does not know can be compared, but not put into a set
    if any(size not in (1, full) for shape in aligned for size, full in zip(shape, batch, strict=True)):
        given = " and ".join(f"{tuple(map(int, shape))} of {name}" for name, shape in shapes.items())
        raise ValueError(f"batch shapes must broadcast together, got {given}")
    return tuple(batch)


def separate(found: Array, axis: int, *shapes: Shape) -> tuple[Array, ...]:
    """Split an array of results side by side into one array per shape."""
    m, batch = functions_of("found", found), tuple(found.shape[1:] if axis == 0 else found.shape[:-1])
    results, start = [], 0
    for shape in shapes:
        end = start + math.prod(shape)
        part = found[start:end, ...] if axis == 0 else found[..., start:end]
        results.append(m.reshape(part, shape + batch if axis == 0 else batch + shape))
        start = end
    return tuple(results)


def constants(texts: Sequence[str], like: Array) -> list[Any]:
    """Return decimal constants as Python floats, or as exact fractions if ``like`` holds objects."""
    exact = kind_of(like.dtype) == "object"
    return [Fraction(text) if exact else float(text) for text in texts]


# --- quaternions with the scalar last -----------------------------------------------------------------------------

SCALAR_LAST, SCALAR_FIRST = [1, 2, 3, 0, 5, 6, 7, 4], [3, 0, 1, 2, 7, 4, 5, 6]
"""Component orders of a dual quaternion; the first four entries are the component orders of a quaternion."""


def from_scalar_last(q: Array, axis: int, size: int) -> Array:
    """Convert a quaternion of ``size`` components from scalar last to scalar first in each half."""
    return _ordered(q, SCALAR_FIRST[:size], axis)


def to_scalar_last(q: Array, size: int, axis: int) -> Array:
    """Convert a quaternion of ``size`` components from scalar first to scalar last in each half."""
    return _ordered(q, SCALAR_LAST[:size], axis)


def _ordered(q: Array, order: list[int], axis: int) -> Array:
    m, shape = functions_of("q", q), (len(order),)
    rows = components(m, as_array(m, "q", q, shape, axis), shape, axis)
    return pack(m, [rows[i] for i in order], shape, _batch_of(q, shape, axis), axis, rows[0])
