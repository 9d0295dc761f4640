"""Functions of JAX with rules of differentiation: scalar programs and kernels of ``_slopes`` and ``_rules``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, partial
from importlib import import_module
from typing import Any

from ._chart import Array, Call
from ._rules import Values, slope_of, text_of, value_of

# type checkers see Any, whether JAX is installed there or not
jax: Any = import_module("jax")
jnp: Any = jax.numpy


def held(value: Any) -> Any:
    """Return a value as a constant of differentiation."""
    return jax.lax.stop_gradient(value) if hasattr(value, "shape") else value


def apart(values: Values) -> Values:
    """Return values that XLA stores on a CPU; its fusions compute shared values again for each result.

    XLA sees a choice whose outcome it cannot know. Fusions do not cross a choice, and other devices need none. Unlike
    a product with the unit matrix, a choice keeps NaN in its place.
    """
    places = [i for i, value in enumerate(values) if isinstance(value, jax.core.Tracer)]
    if not places:
        return values
    chosen = jax.lax.optimization_barrier(jnp.array(True))
    stored = jax.lax.platform_dependent(*(values[i] for i in places), cpu=partial(_chosen, chosen), default=_same)
    found = dict(zip(places, stored, strict=True))
    return [found.get(i, value) for i, value in enumerate(values)]


def _same(*arrays: Array) -> Values:
    return arrays


def _zeros(*arrays: Array) -> Values:
    return tuple(map(jnp.zeros_like, arrays))


def _chosen(chosen: Array, *arrays: Array) -> Values:
    found: Values = jax.lax.cond(chosen, _same, _zeros, *arrays)
    return found


def carry(slope: Callable[[Values, Values, Values], Values], results: Values, given: Values) -> Sequence[Array]:
    """Return results whose derivative by the given arrays is a rule, a function of results, arguments and rates."""

    def both(values: tuple[Values, Values], rates: tuple[Values, Values]) -> tuple[Values, Values]:
        found = carried(*values)
        return found, list(slope(found, values[1], rates[1]))

    carried = jax.custom_jvp(lambda found, at: found)
    carried.defjvp(both)
    kept: Sequence[Array] = carried(list(results), list(given))
    return kept


@cache
def ruled(kernel_call: Call) -> Callable[..., Array]:
    """Return a kernel with its rule, each compiled once for all calls with equal shapes."""
    compiled = jax.custom_jvp(jax.jit(partial(value_of, kernel_call)))
    compiled_slope = jax.jit(partial(slope_of, kernel_call))

    def both(values: Values, rates: Values) -> tuple[Array, Array]:
        result = compiled(*values)
        # without the barrier, XLA merges each derivative with the calls before it and takes twice the time
        at_result, at_values = jax.lax.optimization_barrier((result, values))
        return result, compiled_slope(at_result, at_values, rates)

    compiled.defjvp(both)
    jitted: Callable[..., Array] = jax.jit(compiled)
    return jitted


@cache
def unruled(kernel_call: Call, axis: int) -> Callable[..., Array]:
    """Return a kernel without a rule, compiled once for all calls with equal shapes."""
    jitted: Callable[..., Array] = jax.jit(partial(text_of, kernel_call, axis))
    return jitted


def derivative(function: Callable[..., Array], values: Values, rates: Values) -> Array:
    """Return the derivative of a function along the rates of its arguments."""
    return jax.jvp(function, tuple(values), tuple(rates))[1]
