def as_array(name: str, value: ArrayLike, part: Shape, axis: int, real: bool = False) -> Array:
    """Return an argument as an array of a supported type, after a check of its component axes."""
    if axis not in (-1, 0):
        raise ValueError(f"axis must be -1 (components last) or 0 (components first), got {axis!r}")
    array = np.asarray(value)
    if array.dtype != FLOAT and array.dtype != SINGLE:
        array = _supported(name, array, real)
    found = array.shape[: len(part)] if axis == 0 else array.shape[array.ndim - len(part) :]
    if found != part:
        raise shape_error(name, part, axis, array.shape)
    return array


def common_type(values: Sequence[ArrayLike], arrays: Sequence[Array]) -> np.dtype[Any]:
    """Return the dtype of a result; a plain number, such as a time, takes the dtype of the other arguments."""
    first = arrays[0].dtype
    if [array.dtype for array in arrays].count(first) == len(arrays):  # faster than ``np.result_type``
        return first
    return np.result_type(*(v if type(v) in (int, float) else a for v, a in zip(values, arrays, strict=True)))


def batch_shape(arguments: Sequence[tuple[str, Shape]], arrays: Sequence[Array], axis: int) -> Shape:
    """Return the broadcast shape of the batches."""
    shapes = []
    for (_, part), array in zip(arguments, arrays):  # faster than a list comprehension with ``strict``
        shape = array.shape
        shapes.append(shape[len(part) :] if axis == 0 else shape[: len(shape) - len(part)])
    if shapes.count(shapes[0]) == len(shapes):
        return shapes[0]
    try:
        return np.broadcast_shapes(*shapes)
    except ValueError:
        named = zip(shapes, arguments, strict=True)
        given = " and ".join(f"{shape} of {name}" for shape, (name, _) in named)
        raise ValueError(f"batch shapes must broadcast together, got {given}") from None


def _check(out: Array, shape: Shape, dtype: np.dtype[Any]) -> None:
    """Raise an error unless ``out`` is an array that can hold a result."""
    if not isinstance(out, np.ndarray):
        raise TypeError(f"out must be an array, got {type(out).__name__}")
    if out.shape != shape:
        raise ValueError(f"out must have shape {shape}, got {out.shape}")
    if out.dtype != dtype and not np.can_cast(dtype, out.dtype, "same_kind"):
        raise TypeError(f"out must be able to hold {dtype}, got dtype {out.dtype}")


def separate(found: Array, axis: int, *shapes: Shape) -> tuple[Array, ...]:
    """Split an array of results side by side into one array per shape."""
    results, start = [], 0
    for shape in shapes:
        size = math.prod(shape)
        if axis == 0:
            results.append(found[start : start + size].reshape(shape + found.shape[1:]))
        else:
            results.append(found[..., start : start + size].reshape(found.shape[:-1] + shape))
        start += size
    return tuple(results)


def filled(array: Array, out: Array | None) -> Array:
    """Return the array, or ``out`` filled with it."""
    if out is None:
        return array
    _check(out, array.shape, array.dtype)
    out[...] = array
    return out


# --- quaternions with the scalar last -----------------------------------------------------------------------------

SCALAR_LAST, SCALAR_FIRST = [1, 2, 3, 0, 5, 6, 7, 4], [3, 0, 1, 2, 7, 4, 5, 6]
"""Component orders of a dual quaternion; the first four entries are the component orders of a quaternion."""


def from_scalar_last(q: ArrayLike, axis: int, size: int) -> Array:
    """Convert a quaternion of ``size`` components from scalar last to scalar first in each half."""
    return as_array("q", q, (size,), axis).take(SCALAR_FIRST[:size], axis)


def to_scalar_last(q: Array, size: int, axis: int, out: Array | None) -> Array:
    """Convert a quaternion of ``size`` components from scalar first to scalar last in each half."""
    return filled(q.take(SCALAR_LAST[:size], axis), out)
