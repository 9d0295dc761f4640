"""Shared path of all kernel functions on arrays of any library: split into components, run the core, stack the result.

A core is straight-line code on the components of its arguments; ``m`` holds the functions it needs beyond + - * /.
Nothing is written in place and no branch depends on data. Kernels therefore compile (``jax.jit``), batch (``vmap``),
differentiate (``grad``, autograd) and stay lazy (Dask). Both sides of a selection are computed on safe arguments, so
gradients are finite wherever the result is finite.
"""

from __future__ import annotations

import importlib
import math
import sys
from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from operator import add
from typing import Any

from ._chart import Array, Call, Chart, Components, Shape


class Namespace:
    """Functions of the array API standard under the names that cores use; ``like`` is an array of the arguments."""

    eager = True
    """True if values may be looked at: they are known, and reading them stops no other device."""

    def __init__(self, xp: Any, like: Array) -> None:
        self.xp, self.like = xp, like
        self.dtype = self.default() if _integral(like.dtype) else like.dtype
        self.abs, self.sqrt, self.tan, self.expm1, self.log1p = xp.abs, xp.sqrt, xp.tan, xp.expm1, xp.log1p
        self._atan2 = xp.atan2 if hasattr(xp, "atan2") else xp.arctan2

    def run(self, kernel_call: Call, axis: int, arrays: Sequence[Array]) -> Array:
        return computed(self, kernel_call, axis, arrays)

    def scalars(self, chart: Chart) -> Any:
        """Return the scalar programs of a chart."""
        return chart.scalars

    def held(self, value: Any) -> Any:
        """Return a value as a constant of differentiation, if the library differentiates."""
        return value

    def carry(self, slope: Any, results: Sequence[Array], given: Sequence[Array]) -> Sequence[Array]:
        """Return results whose derivative by the given arrays is a rule, if the library differentiates."""
        return results

    def apart(self, values: Sequence[Any]) -> Sequence[Any]:
        """Return values that a compiler stores, rather than compute them again for each result that needs them."""
        return values

    def once(self, value: Any) -> Any:
        """Return a value that a compiler computes once."""
        return self.apart([value])[0]

    def taken(self, value: Any) -> Array:
        """Return a Python value or a NumPy array as an array of this library; numbers take the arguments' type."""
        return self.xp.asarray(value, dtype=None if hasattr(value, "dtype") else self.dtype, **self.place())

    def place(self) -> dict[str, Any]:
        """Return the option that puts a new array on the device of the arguments."""
        return {"device": self.like.device}

    def part(self, array: Array, index: Any) -> Array:
        """Return one component, an array over the batch."""
        return array[index]

    beside = staticmethod(add)

    def reciprocals(self, like: Any, *integers: int) -> list[Any]:
        """Return numbers that take the type of the arguments."""
        return [1 / integer for integer in integers]

    def atan2(self, a: Array, b: Any) -> Array:
        return self._atan2(a, b if hasattr(b, "shape") else self.filled(a, b))

    def where(self, condition: Array, a: Any, b: Any) -> Array:
        """Select between arrays or numbers by a condition; two numbers give an array of the arguments' type."""
        if not hasattr(a, "shape") and not hasattr(b, "shape"):
            b = self.xp.full_like(condition, b, dtype=self.dtype)
        return self.xp.where(condition, a, b)

    def filled(self, like: Array, value: Any) -> Array:
        """Return an array filled with a value, of the shape, type and device of another array."""
        return self.xp.full_like(like, value)

    def default(self) -> Any:
        """Return the type to which integers are converted."""
        return self.xp.asarray(0.0).dtype

    def eps(self) -> float:
        """Return the machine epsilon of the arguments' type, twice the unit roundoff."""
        return float(self.xp.finfo(self.dtype).eps)

    def floating(self, array: Array) -> Array:
        return self.xp.astype(array, self.dtype) if _integral(array.dtype) else array

    def stack(self, arrays: list[Array], axis: int) -> Array:
        return self.xp.stack(arrays, axis=axis)

    def broadcast(self, array: Array, shape: Shape) -> Array:
        return array if tuple(array.shape) == shape else self.xp.broadcast_to(array, shape)

    def reshape(self, array: Array, shape: Shape) -> Array:
        return array if tuple(array.shape) == shape else self.xp.reshape(array, shape)


class Objects(Namespace):
    """NumPy arrays of objects: fractions, symbols, numbers of many digits. A single object is not an array."""

    def part(self, array: Array, index: Any) -> Any:
        return array[index][()]

    def reciprocals(self, like: Any, *integers: int) -> list[Any]:
        return [(like - like + 1) / integer for integer in integers]

    def eps(self) -> float:
        """Return the machine epsilon of floats, because exact numbers get the same tolerance as floats."""
        return sys.float_info.epsilon

    def where(self, condition: Array, a: Any, b: Any) -> Any:
        if getattr(condition, "shape", ()):
            return super().where(condition, a, b)
        return a if condition else b


class Unplaced(Namespace):
    """Functions of libraries whose new arrays follow their operands (JAX) or the current device (CuPy)."""

    eager = False

    def place(self) -> dict[str, Any]:
        return {}


class Ruled(Namespace):
    """Functions of a library that differentiates; scalar programs and some kernels have rules of differentiation."""

    eager = False
    by_text: tuple[str, ...] = ()
    """Kernels whose rules are not used."""

    library = ""
    """Module of this package with functions of the library."""

    def __init__(self, xp: Any, like: Array) -> None:
        super().__init__(xp, like)
        own = importlib.import_module(self.library, __package__)
        self.held, self.carry = own.held, own.carry  # type: ignore[method-assign]
        self.ruled, self.derivative = own.ruled, own.derivative

    def scalars(self, chart: Chart) -> Any:
        return importlib.import_module("._slopes", __package__).Ruled(chart)

    def run(self, kernel_call: Call, axis: int, arrays: Sequence[Array]) -> Array:
        return importlib.import_module("._rules", __package__).run(self, kernel_call, axis, arrays)


class Jax(Ruled, Unplaced):
    """Functions of JAX."""

    library = "._jax"

    def __init__(self, xp: Any, like: Array) -> None:
        super().__init__(xp, like)
        # the slowest function, which fusions would call again; XLA's sine and cosine are fast for float32 alone
        tan = (lambda angle: xp.sin(angle) / xp.cos(angle)) if self.dtype == xp.float32 else xp.tan
        self.tan = lambda angle: self.once(tan(angle))

    def apart(self, values: Sequence[Any]) -> Sequence[Any]:
        found: Sequence[Any] = importlib.import_module(self.library, __package__).apart(values)
        return found


class Torch(Ruled):
    """Functions of PyTorch: its tensors have no namespace attribute, and its functions take ``dim``."""

    by_text = ("twist", "rate")  # linear in the last argument; backward mode needs their text for that
    library = "._torch"

    def default(self) -> Any:
        return self.xp.get_default_dtype()

    def floating(self, array: Array) -> Array:
        return array.to(self.dtype) if _integral(array.dtype) else array

    def stack(self, arrays: list[Array], axis: int) -> Array:
        return self.xp.stack(arrays, dim=axis)


class Dask(Unplaced):
    """Functions of Dask; stacked components are put into one chunk."""

    eager = False

    def floating(self, array: Array) -> Array:
        return array.astype(self.dtype) if _integral(array.dtype) else array

    def stack(self, arrays: list[Array], axis: int) -> Array:
        return self.xp.stack(arrays, axis=axis).rechunk({axis: len(arrays)})


UNNAMED = {"torch": "torch", "dask": "dask.array", "cupy": "cupy"}
"""Modules with the functions of libraries whose arrays may lack ``__array_namespace__``, by library."""

KINDS = {"torch": Torch, "dask": Dask, "jax": Jax, "cupy": Unplaced}
"""Namespaces of libraries that deviate from the standard, by library."""


def functions_of(name: str, array: Array) -> Namespace:
    """Return the functions of the library of an array."""
    xp = _library(array)
    if xp is None:
        raise _no_array(name, array)
    kind = Objects if _kind(array.dtype) == "object" else Namespace
    return KINDS.get(_called(xp).partition(".")[0], kind)(xp, array)


def functions_for(named: list[tuple[str, Array]]) -> Namespace:
    """Return the functions of the common library of all arguments; NumPy only if no other library occurs."""
    name, array = named[0]
    xp = _library(array)
    for other, value in named[1:]:
        if type(value) is type(array) or (found := _library(value)) is xp or found is None:
            continue
        if xp is None or _called(xp) == "numpy":
            name, array, xp = other, value, found
        elif _called(found) != "numpy":
            raise TypeError(
                f"arrays must be of one library, or of it and NumPy, "
                f"got {name} of {_called(xp)} and {other} of {_called(found)}"
            )
    return functions_of(name, array)


def _library(array: Any) -> Any:
    """Return the namespace of an array, or None if the value is not an array."""
    if hasattr(array, "__array_namespace__"):
        return array.__array_namespace__()
    name = UNNAMED.get(type(array).__module__.partition(".")[0])
    return name and sys.modules[name]


def _no_array(name: str, value: Any) -> TypeError:
    return TypeError(f"{name} must be an array of NumPy, JAX, PyTorch or the like, got {type(value).__name__}")


def _called(xp: Any) -> str:
    """Return the name of a library."""
    return str(getattr(xp, "__name__", xp))


def _kind(dtype: Any) -> str:
    """Return the name of a dtype without the name of its library."""
    return str(dtype).rpartition(".")[2]


def _integral(dtype: Any) -> bool:
    return _kind(dtype).startswith(("int", "uint", "bool"))


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
    return m.run(Call(chart, name, arguments, table), axis, arrays)


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
    if type(value) is not type(m.like) and (xp := _library(value)) is not m.xp:
        if xp is None and part and not isinstance(value, list | tuple):
            raise _no_array(name, value)
        value = m.taken(value)
    shape = tuple(value.shape)
    found = shape[: len(part)] if axis == 0 else shape[len(shape) - len(part) :]
    if found != part:
        inner = ", ".join(map(str, part))
        expected = f"({inner}, ...)" if axis == 0 else f"(..., {inner})"
        raise ValueError(f"{name} must have shape {expected}, got {shape}")
    if real and _kind(value.dtype).startswith("complex"):
        raise TypeError(f"{name} must be real: this function selects branches; got dtype {_kind(value.dtype)}")
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
    for sizes in zip(*aligned, strict=True):
        if len({size for size in sizes if size != 1}) > 1:
            given = " and ".join(f"{shape} of {name}" for name, shape in shapes.items())
            raise ValueError(f"batch shapes must broadcast together, got {given}")
    return tuple(next((size for size in sizes if size != 1), 1) for sizes in zip(*aligned, strict=True))


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
    exact = _kind(like.dtype) == "object"
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
