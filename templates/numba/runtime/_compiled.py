"""Compiled loops around cores on scalars.

A core takes tuples of components and returns a tuple. It calls scalar programs such as ``c_pose_scalars``. A kernel is
bound to a chart, which has its own scalar programs. Numba then inlines both into a loop over the columns of (6, N)
arrays, which LLVM vectorises, and into a generalised ufunc over the last axis. Loops are compiled on first use, for
each type. Arrays of objects (fractions, symbols) run the same source uncompiled.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from importlib import import_module
from types import FunctionType
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

# type checkers see Any, whether Numba is installed there or not
numba: Any = import_module("numba")
prange: Any = numba.prange
extending: Any = import_module("numba.extending")
support: Any = import_module("numba.np.numpy_support")

Array: TypeAlias = NDArray[Any]
Components: TypeAlias = Sequence[Any] | Array
Result: TypeAlias = tuple[Any, ...]
Shape: TypeAlias = tuple[int, ...]
Core: TypeAlias = Callable[..., Result]
Loop: TypeAlias = Callable[..., None]


# --- functions of cores -----------------------------------------------------------------------------------------


def number(value: Any, like: Any) -> Any:
    """Return a constant in the type of a number or an array of components."""
    return value


@extending.overload(number)
def _number(value, like):  # type: ignore[no-untyped-def]
    kind = support.as_dtype(getattr(like, "dtype", like)).type
    return lambda value, like: kind(value)


def reciprocal(like: Any, b: Any) -> Any:
    """Return 1/b as a number like another one."""
    return (like - like + 1) / b


@extending.overload(reciprocal)
def _reciprocal(like, b):  # type: ignore[no-untyped-def]
    return lambda like, b: number(1, like) / b


sqrt, tan, atan2, expm1, log1p = np.sqrt, np.tan, np.arctan2, np.expm1, np.log1p


def where(condition: Any, a: Any, b: Any) -> Any:
    """Return one of two numbers, which are both computed."""
    return a if condition else b


@extending.intrinsic
def _select(_, condition, a, b):  # type: ignore[no-untyped-def]
    """Emit the select instruction, so that a loop has no jump and can be vectorised."""

    def generate(context, builder, signature, arguments):  # type: ignore[no-untyped-def]
        return builder.select(*arguments)

    return (a(condition, a, b), generate) if a == b else None


@extending.overload(where)
def _where(condition, a, b):  # type: ignore[no-untyped-def]
    return lambda condition, a, b: _select(condition, a, b)


# --- loops ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Kernel:
    """Functions of one map, with the names and shapes of its arguments and the shape of its result.

    ``core`` computes one pose on tuples, and ``row`` on arrays. Each of ``rows`` computes some components of all poses.
    """

    core: Core
    rows: tuple[Loop, ...]
    row: Loop
    arguments: tuple[tuple[str, Shape], ...]
    shape: Shape
    real: bool


@dataclass(frozen=True, slots=True)
class Geometry:
    """Kernels of all charts, and the geometry programs that they call."""

    programs: tuple[Core, ...]
    kernels: Mapping[str, Kernel]


class Programs:
    """Geometry programs with the scalar programs of one chart; ``owner`` is their name in Numba's cache."""

    def __init__(self, programs: Sequence[Core], scalars: Mapping[str, Core], owner: str) -> None:
        self._programs = programs
        self._scalars = scalars
        self._owner = owner

    @cached_property
    def compiled(self) -> dict[str, Core]:
        """Compiled programs by name, callable from other compiled functions."""
        return self._bound(_core)

    @cached_property
    def uncompiled(self) -> dict[str, Core]:
        """Programs by name as plain Python functions, for numbers of any type."""
        return self._bound(lambda function: function)

    def kernel(self, kernel: Kernel, names: Mapping[str, Core]) -> Kernel:
        """Return a copy of a kernel whose loops call the named programs."""
        functions = {**kernel.row.__globals__, **names}
        rows = tuple(self._copy(loop, functions) for loop in kernel.rows)
        return replace(kernel, core=names[kernel.core.__name__], rows=rows, row=self._copy(kernel.row, functions))

    def _bound(self, wrap: Callable[[Core], Core]) -> dict[str, Core]:
        """Return all programs by name, bound to one another and to the scalar programs."""
        names = {f"c_{name}": wrap(function) for name, function in self._scalars.items()}
        for program in self._programs:
            names[program.__name__] = wrap(self._copy(program, names))
        return names

    def _copy(self, function: Callable[..., Any], names: dict[str, Any]) -> Callable[..., Any]:
        """Return a copy of a function with other globals; Numba's cache identifies it by file and qualified name."""
        for name, value in function.__globals__.items():
            names.setdefault(name, value)
        copied = FunctionType(function.__code__, names)
        copied.__qualname__ = f"{self._owner}.{function.__name__}"
        return copied


def digest(functions: Mapping[str, Core]) -> str:
    """Return a digest of the code of functions, because Numba's cache tracks the file of a loop but not its callees."""
    codes = ((name, function.__code__) for name, function in sorted(functions.items()))
    parts = [(name, code.co_code, code.co_consts, code.co_names) for name, code in codes]
    return hashlib.sha256(repr(parts).encode()).hexdigest()[:16]


@cache
def _core(function: Core) -> Any:
    """Compile a core for inlining into its loop, with division by zero as in IEEE arithmetic."""
    return numba.njit(inline="always", error_model="numpy")(function)


@cache
def _like(size: int, dtype: np.dtype[Any]) -> Array:
    """Return an array of the length of a result; only its length is used."""
    return np.empty(size, dtype)


class Compiled:
    """Kernel with the programs of one chart, and its compiled loops."""

    def __init__(self, kernel: Kernel, programs: Programs) -> None:
        self.source = kernel
        self.programs = programs
        self.parts = [part for _, part in kernel.arguments]
        self.sizes = [math.prod(part) for part in self.parts]
        self.size = math.prod(kernel.shape)
        self._ufuncs: dict[np.dtype[Any], Any] = {}

    @property
    def tabled(self) -> bool:
        """Tell whether the kernel takes constants as its last argument."""
        return self.source.row.__code__.co_argcount > len(self.parts) + 2  # besides the arguments: `like` and `out`

    @cached_property
    def kernel(self) -> Kernel:
        """Kernel bound to compiled programs."""
        return self.programs.kernel(self.source, self.programs.compiled)

    @cached_property
    def uncompiled(self) -> Kernel:
        """Kernel of plain Python functions, for numbers of any type."""
        return self.programs.kernel(self.source, self.programs.uncompiled)

    @cached_property
    def loops(self) -> tuple[Loop, ...]:
        """Loops over the columns of arrays of components. A table follows the arrays as a tuple; the result is last."""
        return tuple(numba.njit(cache=True, error_model="numpy")(function) for function in self.kernel.rows)

    @cached_property
    def parallel_loops(self) -> tuple[Loop, ...]:
        """Loops as in ``loops``, on all threads."""
        return tuple(numba.njit(parallel=True, error_model="numpy")(function) for function in self.kernel.rows)

    def ufunc(self, dtype: np.dtype[Any]) -> Any:
        """Return the generalised ufunc over last axes: arguments, an array of the length of the result, the result."""
        if dtype not in self._ufuncs:
            row = self.kernel.row
            count = row.__code__.co_argcount
            layout = ",".join([*(f"(a{i})" for i in range(count - 2)), "(m)"]) + "->(m)"
            signature = (numba.from_dtype(dtype)[:],) * count
            self._ufuncs[dtype] = numba.guvectorize([signature], layout, cache=True)(row)
        return self._ufuncs[dtype]

    def over_rows(self, arrays: Sequence[Components], out: Array, parallel: bool) -> None:
        """Run on arrays of shape (components, N). A table is a tuple, because reading an array would slow the loop."""
        if out.dtype.hasobject:
            loops: Sequence[Loop] = self.uncompiled.rows
        else:
            loops = self.parallel_loops if parallel else self.loops
        for loop in loops:
            loop(*arrays, out)

    def over_last(self, arrays: list[Array], out: Array) -> None:
        """Run on arrays of shape (..., components)."""
        like = _like(self.size, out.dtype)
        if not out.dtype.hasobject:
            with np.errstate(all="ignore"):
                self.ufunc(out.dtype)(*arrays, like, out)
            return
        batch = out.shape[:-1]
        full = [np.broadcast_to(array, (*batch, array.shape[-1])) for array in arrays]
        for index in np.ndindex(batch):
            self.uncompiled.row(*(array[index] for array in full), like, out[index])
