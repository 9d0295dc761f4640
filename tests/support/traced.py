"""Functions and derivatives by JAX without its compiler, which takes seconds for each: NumPy runs what JAX traces."""

from __future__ import annotations

import functools
import operator
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np


def _broadcast(a: Any, shape: Sequence[int], broadcast_dimensions: Sequence[int], **_: Any) -> Any:
    sizes = dict(zip(broadcast_dimensions, np.shape(a), strict=True))
    return np.broadcast_to(np.reshape(a, [sizes.get(axis, 1) for axis in range(len(shape))]), shape)


def _part(a: Any, start_indices: Sequence[int], limit_indices: Sequence[int], strides: Any) -> Any:
    return a[tuple(map(slice, start_indices, limit_indices, strides or [None] * a.ndim))]


def _padded(a: Any, value: Any, padding_config: Sequence[tuple[int, int, int]]) -> Any:
    """Spread an array and put values around it; negative widths cut it."""
    low, high, within = np.array(padding_config, int).reshape(-1, 3).T
    spread = np.maximum(np.array(np.shape(a), int) * (within + 1) - within, 0)
    found = np.full(spread + np.maximum(low, 0) + np.maximum(high, 0), value, np.asarray(a).dtype)
    begin = np.maximum(low, 0)
    found[tuple(map(slice, begin, begin + spread, within + 1))] = a
    return found[tuple(map(slice, np.maximum(-low, 0), np.array(found.shape) - np.maximum(-high, 0)))]


def _split(a: Any, sizes: Sequence[int], axis: int) -> Sequence[Any]:
    return np.split(a, np.cumsum(sizes)[:-1], axis)


def _plain(function: Callable[..., Any]) -> Callable[..., Any]:
    return lambda *given, **_: function(*given)


OPERATIONS: Mapping[str, Callable[..., Any]] = {
    **{name: _plain(function) for name, function in {
        "add": operator.add, "add_any": operator.add, "sub": operator.sub, "mul": operator.mul, "neg": operator.neg,
        "div": np.divide, "sqrt": np.sqrt, "abs": np.abs, "tan": np.tan, "sin": np.sin, "cos": np.cos,
        "atan2": np.arctan2, "lt": np.less, "gt": np.greater, "ge": np.greater_equal, "eq": np.equal,
        "and": np.logical_and, "or": np.logical_or, "not": np.logical_not, "square": np.square,
        "stop_gradient": np.asarray,
    }.items()},
    "integer_pow": lambda a, y: a**y,
    "select_n": lambda where, *cases: np.where(where, cases[1], cases[0]),
    "squeeze": lambda a, dimensions: np.squeeze(a, tuple(dimensions)),
    "reshape": lambda a, new_sizes, **_: np.reshape(a, new_sizes),
    "transpose": lambda a, permutation: np.transpose(a, permutation),
    "reduce_sum": lambda a, axes, **_: np.sum(a, axis=tuple(axes)),
    "concatenate": lambda *given, dimension: np.concatenate(given, axis=dimension),
    "convert_element_type": lambda a, new_dtype, **_: np.asarray(a, new_dtype),
    "broadcast_in_dim": _broadcast,
    "slice": _part,
    "pad": _padded,
    "split": _split,
    "unstack": lambda a, axis: tuple(np.moveaxis(a, axis, 0)),
    "iota": lambda dtype, shape, dimension, **_: np.indices(shape)[dimension].astype(dtype),
    "stack": lambda *given, axis: np.stack(given, axis),
    "platform_index": lambda **_: 0,
    "optimization_barrier": lambda *given: given,
}  # fmt: skip
"""Operations of JAX in NumPy. JAX runs the others itself."""


def run(function: Callable[..., Any], *given: Any, **options: Any) -> Any:
    """Return the results of a function of arrays; arguments that are no arrays are constants of the trace."""
    import jax

    arrays = [a for a in given if isinstance(a, np.ndarray)]
    shapes = tuple(jax.ShapeDtypeStruct(a.shape, a.dtype) if isinstance(a, np.ndarray) else a for a in given)
    traced, tree = _traced(function, shapes, tuple(options.items()))
    with np.errstate(all="ignore"):
        return jax.tree.unflatten(tree, map(np.asarray, _run(traced, *arrays)))


@functools.cache
def _traced(function: Callable[..., Any], given: tuple[Any, ...], options: tuple[tuple[str, Any], ...]) -> Any:
    """Return the trace of a function for shapes and constants, and the tree of its results."""
    import jax

    places = [place for place, one in enumerate(given) if isinstance(one, jax.ShapeDtypeStruct)]

    def of_arrays(*arrays: Any) -> Any:
        known = dict(zip(places, arrays, strict=True))
        return function(*(known.get(place, one) for place, one in enumerate(given)), **dict(options))

    traced, shapes = jax.make_jaxpr(of_arrays, return_shape=True)(*(given[place] for place in places))
    return traced, jax.tree.structure(shapes)


def derivative(function: Callable[..., Any], points: np.ndarray, along: np.ndarray) -> Iterator[list[Any]]:
    """Yield the arrays of a function's derivative along a direction at each point, in forward mode."""
    import jax

    traced = jax.make_jaxpr(lambda z: jax.jvp(function, (z,), (along,))[1])(points[0])
    with np.errstate(all="ignore"):
        for at in points:
            yield _run(traced, at)


def _run(traced: Any, *given: Any) -> list[Any]:
    """Run a traced function: each equation reads values by name and makes others."""
    jaxpr = traced.jaxpr
    known = dict(zip((*jaxpr.constvars, *jaxpr.invars), map(np.asarray, (*traced.consts, *given)), strict=True))

    def values(names: Sequence[Any]) -> list[Any]:
        return [name.val if hasattr(name, "val") else known[name] for name in names]

    for equation in jaxpr.eqns:
        known |= zip(equation.outvars, _results(equation, values(equation.invars)), strict=True)
    return values(jaxpr.outvars)


def _results(equation: Any, given: list[Any]) -> Sequence[Any]:
    name, options = equation.primitive.name, equation.params
    if name == "cond":  # of the platform: which branch runs changes no value
        return _run(options["branches"][int(given[0])], *given[1:])
    for inner in _inner(options):
        return _run(inner, *given)
    found = OPERATIONS.get(name, equation.primitive.bind)(*given, **options)
    return found if equation.primitive.multiple_results else [found]


def _inner(options: Mapping[str, Any]) -> Iterator[Any]:
    """Yield the function that an equation calls, if any."""
    yield from (options[name] for name in ("jaxpr", "call_jaxpr") if name in options)
