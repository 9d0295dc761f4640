"""Functions of PyTorch with rules of differentiation: scalar programs and kernels of ``_slopes`` and ``_rules``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from importlib import import_module
from typing import Any

from ._chart import Array, Call
from ._rules import Values, slope_of, text_of, value_of

# type checkers see Any, whether PyTorch is installed there or not
torch: Any = import_module("torch")
forward_ad: Any = import_module("torch.autograd.forward_ad")

Slope = Callable[[Values, Values, Values], Values]
"""Function of results, arguments and rates that returns the rates of the results, linear in the rates."""


class Carry(torch.autograd.Function):  # type: ignore[misc]
    """Copies of arrays: the first ``count`` are results with the derivative of a rule, the others its arguments."""

    generate_vmap_rule = True

    @staticmethod
    def forward(slope: Slope, count: int, *arrays: Array) -> tuple[Array, ...]:
        return tuple(array.clone() for array in arrays)

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple[Any, ...], output: tuple[Array, ...]) -> None:
        ctx.slope, ctx.count, *_ = inputs
        # unlike the arguments, their copies have no rates inside `jvp`, which would otherwise call itself
        ctx.save_for_backward(*output)
        ctx.save_for_forward(*output)

    @staticmethod
    def backward(ctx: Any, *weights: Array) -> tuple[Array | None, ...]:
        return gradients(ctx, ctx.saved_tensors, weights)

    @staticmethod
    def jvp(ctx: Any, *rates: Array | None) -> tuple[Array, ...]:
        saved = ctx.saved_tensors  # read once: a checkpoint computes them for one reading
        found, given = saved[: ctx.count], saved[ctx.count :]
        pairs = zip(given, rates[2 + ctx.count :], strict=True)
        moved = [torch.zeros_like(array) if rate is None else rate for array, rate in pairs]
        # PyTorch disables forward mode here, so that forward mode over forward mode would return zeros
        with forward_ad._set_fwd_grad_enabled(True):
            return (*ctx.slope(found, given, moved), *moved)


class Compiled(torch.autograd.Function):  # type: ignore[misc]
    """Copies with the derivative of a rule in ``torch.compile``, which follows backward mode alone, and once."""

    @staticmethod
    def forward(ctx: Any, slope: Slope, count: int, *arrays: Array) -> tuple[Array, ...]:
        ctx.slope, ctx.count, copies = slope, count, Carry.forward(slope, count, *arrays)
        ctx.save_for_backward(*copies)
        return copies

    @staticmethod
    def backward(ctx: Any, *weights: Array) -> tuple[Array | None, ...]:
        return gradients(ctx, [*map(held, ctx.saved_tensors)], weights)


def gradients(ctx: Any, saved: Values, weights: Values) -> tuple[Array | None, ...]:
    """Return the derivatives of weighted copies by the arrays; results and rules are constants."""
    found, given = saved[: ctx.count], saved[ctx.count :]
    rates = map(torch.zeros_like, given)
    _, back = torch.func.vjp(lambda *moved: tuple(ctx.slope(found, given, moved)), *rates)
    of_given = zip(back(weights[: ctx.count]), weights[ctx.count :], strict=True)
    return (None, None, *(None for _ in found), *(one + other for one, other in of_given))


def held(value: Any) -> Any:
    """Return a value as a constant of differentiation."""
    return value.detach() if hasattr(value, "shape") else value


def carry(slope: Slope, results: Sequence[Array], given: Sequence[Array]) -> Sequence[Array]:
    """Return results whose derivative by the given arrays is a rule."""
    copying: Any = Compiled if torch.compiler.is_compiling() else Carry
    if copying is Compiled and not any(array.requires_grad for array in given):
        return results
    found: tuple[Array, ...] = copying.apply(slope, len(results), *results, *given)
    return found[: len(results)]


def ruled(kernel_call: Call) -> Callable[..., Array]:
    """Return a kernel with its rule."""

    def run(*given: Array) -> Array:
        result = value_of(kernel_call, *map(held, given))
        return carry(lambda found, at, rates: (slope_of(kernel_call, found[0], at, rates),), [result], given)[0]

    return run


def unruled(kernel_call: Call, axis: int) -> Callable[..., Array]:
    """Return a kernel without a rule."""
    return partial(text_of, kernel_call, axis)


def derivative(function: Callable[..., Array], values: Values, rates: Values) -> Array:
    """Return the derivative of a function along the rates of its arguments.

    It is the derivative of the reverse mode by its weights. Forward mode cannot be nested outside ``torch.func``.
    """
    result, back = torch.func.vjp(function, *values)
    found: Array = torch.func.vjp(back, torch.zeros_like(result))[1](tuple(rates))[0]
    return found
