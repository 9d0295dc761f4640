"""Times of kernels beside other programs of the same formulas: SymPy's, compiled C, JAX, complex steps, a copy."""

from __future__ import annotations

import importlib
from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

from benchmarks import derivatives
from benchmarks.forms import ROWS, compiled, copy_floor, filled, lambdify_call
from benchmarks.maps import NUMPY, drawn
from benchmarks.peers import load
from benchmarks.times import ORDERS, Data, Key, Timed, shown, timed
from benchmarks.timing import Call, markdown
from derive.codegen.signatures import lower_chart
from derive.maps import Cayley

ON_ROWS, DERIVATIVES, JACOBIANS = "rows", "derivatives", "jacobians"
SIZES = {ON_ROWS: (100, 10_000, 1_000_000), DERIVATIVES: (1, 10_000)}
LAMBDIFY, FILLED, C_FORM, COPY = "lambdify(cse=True)", "lambdify, filled", "C form", "copy floor"
JITTED, CALLED, STEPS = "JAX, jitted", "JAX, called", "complex steps"


def on_rows(sizes: Sequence[int] = SIZES[ON_ROWS], orders: Sequence[int] = ORDERS) -> Iterator[Timed]:
    """Yield times with components first and a given result, against lambdify, C and a copy."""
    cases = [(size, order, function) for size in sizes for order in orders for function in ROWS]
    return timed(ON_ROWS, ((function, size, row_calls(order, function, size)) for size, order, function in cases))


def row_calls(order: int, function: str, size: int) -> dict[Key, Call]:
    """Return the calls of a function on rows: ours, those of SymPy's and C's function, and a copy of the result."""
    chart = f"cayley{order}"
    poses, call = drawn(chart, size), getattr(_module(order), function)
    rows = (poses.v_rows, poses.w_rows, poses.z_rows)[: ROWS[function]]
    out = call(*rows, axis=0)
    given = {} if isinstance(out, tuple) else {"out": out}  # functions with two results have no ``out``
    text = f"{chart}.{function}({', '.join('vwz'[: len(rows)])}, axis=0{''.join(f', {name}=out' for name in given)})"
    by_sympy = f"lambdify({', '.join('vwz'[: len(rows)])}, {function}, 'numpy', cse=True)"
    lambdified = lambdify_call(order, function, rows)
    made = {
        (NUMPY, text): partial(call, *rows, axis=0, **given),
        (LAMBDIFY, by_sympy): lambdified,
        (FILLED, f"for row, value in zip(out, {by_sympy}): row[...] = value"): lambdified and filled(lambdified, out),
        (C_FORM, f"{chart}_{function}_rows"): compiled(order, function, rows, out),
        (COPY, "np.copyto of each row"): copy_floor(rows, out),
    }
    return {(by, chart, text): call for (by, text), call in made.items() if call is not None}


def of_derivatives(sizes: Sequence[int] = SIZES[DERIVATIVES], orders: Sequence[int] = ORDERS) -> Iterator[Timed]:
    """Yield times of derivatives with components last, against JAX in forward mode and complex steps."""
    cases = [(size, order, function) for size in sizes for order in orders for function in derivatives.ARGUMENTS]
    groups = ((function, size, derivative_calls(order, function, size)) for size, order, function in cases)
    return timed(DERIVATIVES, groups, kept=False)


def derivative_calls(order: int, function: str, size: int) -> dict[Key, Call]:
    """Return the calls of a derivative: ours, JAX compiled and called, and complex steps of the map."""
    chart, jax = f"cayley{order}", load("jax")
    poses, module = drawn(chart, size), _module(order)
    given = (poses.v, poses.w, poses.other)[: derivatives.ARGUMENTS[function]]
    steps, mapped = derivatives.stepped(module, function), function.partition("_")[0]
    by_jax = derivatives.jax_calls(jax, order, function, given) if jax else {}
    made = {
        (NUMPY, f"{chart}.{function}({', '.join('vwz'[: len(given)])})"): partial(getattr(module, function), *given),
        (JITTED, f"jax.jit of the forward derivative of {mapped}"): by_jax.get("jitted"),
        (CALLED, f"forward derivative of {mapped} by JAX"): by_jax.get("called"),
        (STEPS, f"{mapped} on complex numbers"): partial(steps, *given) if steps else None,
    }
    return {(by, chart, text): call for (by, text), call in made.items() if call is not None}


LARGER, ORDER, COUNT = ("between_jacobians", "retract_jacobians", "local_jacobians", "transition"), 2, 10_000
"""Functions of many operations, the order of the Cayley map, and the number of poses of their table."""

UNROUNDED = ("neg", "abs", "lt", "eq", "and", "or", "where")
"""Operations of listings that are exact."""


def of_jacobians(size: int = COUNT) -> Iterator[Timed]:
    """Yield times of functions of many operations on rows, by JAX with components last."""
    return timed(JACOBIANS, ((function, size, jacobian_calls(function, size)) for function in LARGER), kept=False)


def jacobian_calls(function: str, size: int) -> dict[Key, Call]:
    """Return the calls of a function in NumPy, in C and compiled by JAX, and a copy of the result."""
    chart, jax = f"cayley{ORDER}", load("jax")
    poses, kernel = drawn(chart, size), getattr(_module(ORDER), function)
    rows = poses.v_rows, poses.w_rows
    out = kernel(*rows, axis=0)
    one = getattr(derivatives.array_module(ORDER), function)
    fast = derivatives.jitted(jax, one, (poses.v, poses.w)) if jax else None
    made = {
        (NUMPY, f"{chart}.{function}(v, w, axis=0)"): partial(kernel, *rows, axis=0),
        (C_FORM, f"{chart}_{function}_rows"): compiled(ORDER, function, rows, out),
        (JITTED, f"jax.jit(jax.vmap({chart}.{function}))"): fast,
        (COPY, "np.copyto of each row"): copy_floor(rows, out),
    }
    return {(by, chart, text): call for (by, text), call in made.items() if call is not None}


def rounded_operations(function: str) -> int:
    """Return the number of rounded operations in the listing of a function."""
    counts = lower_chart(Cayley(ORDER)).operations[function]
    return sum(count for operation, count in counts.items() if operation not in UNROUNDED)


def section_of_jacobians(data: Data) -> str:
    """Return the table of `of_jacobians`: a line for each function."""
    forms = (C_FORM, NUMPY, JITTED, COPY)
    rows = [
        [f"`cayley{ORDER}.{function}`", str(rounded_operations(function)), *(
            shown(ns) if (ns := data.ns(JACOBIANS, by, function, f"cayley{ORDER}").get(COUNT)) else "–" for by in forms
        )]
        for function in LARGER
    ]  # fmt: skip
    head = ("function", "rounded operations", "C, ns per pose", "NumPy", "JAX, jitted", "copy floor")
    return f"{markdown('Functions of many operations', head, rows)}\n" + (
        f"N = {COUNT:,}. C and NumPy have components first, JAX last and all cores. Operations are those of the "
        "listing (`dualcay generate --target json`): sums, products, quotients, roots and functions. "
        "The copy floor writes each row of the result once.\n"
    )


def _module(order: int) -> Any:
    return importlib.import_module(f"dualcay.cayley{order}")
