"""Functions of array libraries under the names that cores use; one class for each way in which libraries deviate."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from operator import add
from typing import Any

from ._chart import Array, Chart, Shape


class Namespace:
    """Functions of the array API standard under the names that cores use; ``like`` is an array of the arguments."""

    eager = True
    """True if values may be looked at: they are known, and reading them stops no other device."""
    differentiates = False
    """True if the library differentiates, by rules of this package where there are any."""

    def __init__(self, xp: Any, like: Array) -> None:
        self.xp, self.like = xp, like
        self.dtype = self.default() if _integral(like.dtype) else like.dtype
        self.abs, self.sqrt, self.tan, self.expm1, self.log1p = xp.abs, xp.sqrt, xp.tan, xp.expm1, xp.log1p
        self._atan2 = xp.atan2 if hasattr(xp, "atan2") else xp.arctan2

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

    def moved(self, array: Array, source: Any, target: Any) -> Array:
        """Return an array with one or several axes moved to other places."""
        return self.xp.moveaxis(array, source, target)

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
    differentiates = True
    by_text: tuple[str, ...] = ()
    """Kernels whose rules are not used."""

    own: Callable[[], Any]
    """Function that imports the module of this package for the library; compilers follow an import statement."""

    def __init__(self, xp: Any, like: Array) -> None:
        super().__init__(xp, like)
        own = self.own()
        self.held, self.carry = own.held, own.carry  # type: ignore[method-assign]
        self.ruled, self.unruled, self.derivative = own.ruled, own.unruled, own.derivative

    def scalars(self, chart: Chart) -> Any:
        from ._slopes import Ruled

        return Ruled(chart)


class Jax(Ruled, Unplaced):
    """Functions of JAX."""

    @staticmethod
    def own() -> Any:
        from . import _jax

        return _jax

    def __init__(self, xp: Any, like: Array) -> None:
        super().__init__(xp, like)
        # the slowest function, which fusions would call again; XLA's sine and cosine are fast for float32 alone
        tan = (lambda angle: xp.sin(angle) / xp.cos(angle)) if self.dtype == xp.float32 else xp.tan
        self.tan = lambda angle: self.once(tan(angle))

    def apart(self, values: Sequence[Any]) -> Sequence[Any]:
        found: Sequence[Any] = self.own().apart(values)
        return found


class Followed(Namespace):
    """Functions of PyTorch, which take ``dim``; a compiler that follows the text differentiates it without rules."""

    eager = False

    def default(self) -> Any:
        return self.xp.get_default_dtype()

    def floating(self, array: Array) -> Array:
        return array.to(self.dtype) if _integral(array.dtype) else array

    def stack(self, arrays: list[Array], axis: int) -> Array:
        return self.xp.stack(arrays, dim=axis)

    def moved(self, array: Array, source: Any, target: Any) -> Array:
        return self.xp.movedim(array, source, target)


class Torch(Ruled, Followed):
    """Functions of PyTorch with rules."""

    by_text: tuple[str, ...] = ("twist", "rate")  # linear in the last argument; backward mode needs their text for that

    @staticmethod
    def own() -> Any:
        from . import _torch

        return _torch


class Compiled(Torch):
    """Functions with rules in ``torch.compile``, which cannot follow rules that differentiate others."""

    by_text = (
        *Torch.by_text, "compose_jacobians", "between_jacobians", "retract_jacobians", "body_retract_jacobians",
    )  # fmt: skip


def of_torch(xp: Any, like: Array) -> Namespace:
    """Return functions of PyTorch, with rules unless a compiler would lose them.

    ``torch.compile`` keeps rules for ``backward`` alone; tracers and exporters keep none.
    """
    if not (xp.compiler.is_compiling() or xp.jit.is_tracing()):
        return Torch(xp, like)
    return (Compiled if xp.compiler.is_dynamo_compiling() and like.requires_grad else Followed)(xp, like)


class Dask(Unplaced):
    """Functions of Dask; stacked components are put into one chunk."""

    eager = False

    def floating(self, array: Array) -> Array:
        return array.astype(self.dtype) if _integral(array.dtype) else array

    def stack(self, arrays: list[Array], axis: int) -> Array:
        return self.xp.stack(arrays, axis=axis).rechunk({axis: len(arrays)})


UNNAMED = {"torch": "torch", "dask": "dask.array", "cupy": "cupy"}
"""Modules with the functions of libraries whose arrays may lack ``__array_namespace__``, by library."""

KINDS: Mapping[str, Callable[[Any, Array], Namespace]] = {"torch": of_torch, "dask": Dask, "jax": Jax, "cupy": Unplaced}
"""Namespaces of libraries that deviate from the standard, by library."""


def functions_of(name: str, array: Array) -> Namespace:
    """Return the functions of the library of an array."""
    xp = library_of(array)
    if xp is None:
        raise no_array(name, array)
    kind = Objects if kind_of(array.dtype) == "object" else Namespace
    return KINDS.get(called(xp).partition(".")[0], kind)(xp, array)


def functions_for(named: list[tuple[str, Array]]) -> Namespace:
    """Return the functions of the common library of all arguments; NumPy only if no other library occurs."""
    name, array = named[0]
    xp = library_of(array)
    for other, value in named[1:]:
        if type(value) is type(array) or (found := library_of(value)) is xp or found is None:
            continue
        if xp is None or called(xp) == "numpy":
            name, array, xp = other, value, found
        elif called(found) != "numpy":
            raise TypeError(
                f"arrays must be of one library, or of it and NumPy, "
                f"got {name} of {called(xp)} and {other} of {called(found)}"
            )
    return functions_of(name, array)


def library_of(array: Any) -> Any:
    """Return the namespace of an array, or None if the value is not an array."""
    if hasattr(array, "__array_namespace__"):
        return array.__array_namespace__()
    libraries = (base.__module__.partition(".")[0] for base in type(array).__mro__)
    return next((sys.modules[UNNAMED[library]] for library in libraries if library in UNNAMED), None)


def no_array(name: str, value: Any) -> TypeError:
    return TypeError(f"{name} must be an array of NumPy, JAX, PyTorch or the like, got {type(value).__name__}")


def called(xp: Any) -> str:
    """Return the name of a library."""
    return str(getattr(xp, "__name__", xp))


def kind_of(dtype: Any) -> str:
    """Return the name of a dtype without the name of its library."""
    return str(dtype).rpartition(".")[2]


def _integral(dtype: Any) -> bool:
    return kind_of(dtype).startswith(("int", "uint", "bool"))
