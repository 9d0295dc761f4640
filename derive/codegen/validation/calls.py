"""Calls of the public functions of a kernel module on arrays of floats, and comparison with what is known of them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from types import ModuleType
from typing import Any

import numpy as np

from ..rows import Function
from .errors import ValidationFailed
from .known import Known, parts
from .rounding import Array

FLOATS = tuple(map(np.dtype, (np.float64, np.float32, np.longdouble)))


@dataclass(frozen=True, slots=True)
class Library:
    """Arrays as a target takes them: how they are made of those of NumPy, and the types replayed in them."""

    name: str
    make: Callable[[Array], Any]
    dtypes: tuple[np.dtype[Any], ...]


NUMPY = Library("numpy", np.asarray, FLOATS)


@dataclass(frozen=True)
class Call:
    """A call that is known: ``picks`` say, for each argument in its own batch shape, which of its rows stand where."""

    known: Known
    picks: tuple[Array, ...]
    dtype: np.dtype[Any]
    axis: int = -1
    branch: tuple[int, ...] = ()
    name: str = ""

    @property
    def row(self) -> Function:
        return self.known.row

    @property
    def batch(self) -> tuple[int, ...]:
        """The batch shape of the results."""
        return np.broadcast_shapes(*(pick.shape for pick in self.picks))

    @property
    def index(self) -> Array:
        """Which of the known combinations stands where."""
        picked = np.broadcast_arrays(*self.picks)
        return np.asarray(np.ravel_multi_index(tuple(picked), self.known.shape))

    def arguments(self) -> list[Array]:
        """The arguments, newly made."""
        made = []
        for kind, rows, pick in zip(self.row.arguments, self.known.arguments, self.picks, strict=True):
            array = rows[pick].astype(self.dtype).reshape(pick.shape + kind.shape)
            made.append(laid(array, len(kind.shape), self.axis))
        return made

    def result_shape(self, shape: tuple[int, ...]) -> tuple[int, ...]:
        return shape + self.batch if self.axis == 0 else self.batch + shape

    def __str__(self) -> str:
        given = ", ".join(str(pick.shape) for pick in self.picks)
        at = "".join(f", branch {k}" for k in self.branch or self.known.branch)
        return f"{self.name or self.row.name} ({self.dtype}, batches {given}, axis {self.axis}{at})"


@dataclass
class Caller:
    """Calls functions of a module, compares, and counts."""

    module: ModuleType
    library: Library
    count: int = 0

    def run(self, call: Call, given: Sequence[Array] | None = None, how: str = "", **options: Any) -> tuple[Array, ...]:
        """The results of a call, perhaps on other arrays of the same values; an exception or warning is a failure."""
        function = getattr(self.module, call.name or call.row.name)
        arrays = [self.library.make(array) for array in (call.arguments() if given is None else given)]
        try:
            found = function(*arrays, *(call.branch or call.known.branch), axis=call.axis, **options)
        except (ArithmeticError, TypeError, ValueError, Warning) as error:
            raise self.failure(call, how, repr(error)) from error
        self.count += 1
        results = found if isinstance(found, tuple) else (found,)
        if len(results) != len(call.row.results):
            raise self.failure(call, how, f"{len(results)} results")
        if self.library is NUMPY and "out" not in options and _share_memory(results, arrays):
            raise self.failure(call, how, "a result lies in the memory of an argument")
        return tuple(map(np.asarray, results))

    def refused(self, call: Call, given: Sequence[Array], words: str, **options: Any) -> None:
        """A call whose arguments are wrong, which has to say so in these words."""
        try:
            self.run(call, given, **options)
        except ValidationFailed as error:
            if words not in str(error.__cause__):
                raise self.failure(call, words, f"is refused otherwise: {error.__cause__!r}") from error
            self.count += 1
        else:
            raise self.failure(call, words, "is not refused")

    def check(self, call: Call, given: Sequence[Array] | None = None, how: str = "", **options: Any) -> None:
        """Call and compare every result array."""
        self.compare(call, self.run(call, given, how, **options), how)

    def compare(
        self,
        call: Call,
        results: Sequence[Array],
        how: str = "",
        *,
        spoilt: Array | None = None,
        position: int = 0,
        overflow: bool = False,
        dtype: np.dtype[Any] | None = None,
    ) -> None:
        """Compare the results of a call with what is known: types, shapes, and values within their bounds.

        What is known to be NaN has to be. Where ``spoilt`` says so, by the argument at a position, an element has to be
        NaN; with ``overflow`` any may be NaN or infinite, none wrong. A ``dtype`` other than the call's is that of an
        ``out``, into which results are rounded.
        """
        held = dtype or call.dtype
        for (array, part), got in zip(parts(call.row), results, strict=True):
            if (got.shape, got.dtype) != (call.result_shape(array.shape), held):
                raise self.failure(call, how, f"{array.name} is an array {got.dtype} {got.shape}")
            with np.errstate(all="ignore"):
                rows = flat(got, len(array.shape), call.axis)
                wanted, bound = (a[call.index][..., part] for a in (call.known.results, call.known.bound(call.dtype)))
                if held != call.dtype:
                    bound = bound + np.finfo(held).eps * abs(wanted)
                right = (abs(rows - wanted) <= bound) | (np.isnan(wanted) & np.isnan(rows))
                if overflow:
                    right |= ~np.isfinite(rows)
                if spoilt is not None:
                    nothing = np.isnan(rows) | call.known.free[position, part]
                    right = np.where(spoilt[..., np.newaxis], nothing, right)
            if not right.all():
                where = tuple(np.argwhere(~right)[0])
                text = f"{array.name}[{', '.join(map(str, where))}] is {rows[where]}, not {wanted[where]}"
                raise self.failure(call, how, f"{text} within {float(bound[where]):.2g}")

    def failure(self, call: Call, how: str, what: str) -> ValidationFailed:
        name = self.module.__name__.rpartition(".")[2]
        return ValidationFailed(f"{name}.{call}{f', {how}' if how else ''}, in {self.library.name}: {what}")


def _share_memory(results: Sequence[Array], arguments: Sequence[Array]) -> bool:
    return any(np.may_share_memory(result, given) for result in results for given in arguments)


def laid(array: Array, components: int, axis: int) -> Array:
    """An array whose components stand last, with them where an axis says, in memory too."""
    if axis == 0:
        array = np.moveaxis(array, range(array.ndim - components, array.ndim), range(components))
    return np.ascontiguousarray(array) if array.ndim else array


def flat(array: Array, components: int, axis: int) -> Array:
    """Components of a result as one last axis."""
    if axis == 0:
        array = np.moveaxis(array, range(components), range(array.ndim - components, array.ndim))
    batch = array.shape[: array.ndim - components]
    return array.reshape(*batch, math.prod(array.shape[len(batch) :]))


def several(known: Known, count: int) -> tuple[Array, ...]:
    """Picks for a batch of so many: all combinations in turn."""
    index = np.arange(count) % len(known.results)
    return tuple(map(np.asarray, np.unravel_index(index, known.shape)))


def alone(known: Known, combination: int) -> tuple[Array, ...]:
    """Picks for a single pose."""
    return tuple(map(np.asarray, np.unravel_index(combination, known.shape)))
