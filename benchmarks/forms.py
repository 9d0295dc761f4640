"""Other forms of our own formulas, as measures of kernels: SymPy's lambdify, compiled C, and a copy of the result."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache, partial
from typing import Any

import numpy as np
import sympy

from benchmarks import derivatives
from benchmarks.c_form import load as load_c
from benchmarks.timing import Call
from derive.maps import Cayley

COMPONENTS: dict[str, Callable[..., Iterator[sympy.Expr]]] = {
    "pose": lambda cayley, v: _pose(cayley, v),
    "quaternion": lambda cayley, v: _parts(cayley.quaternion.matrix(v)),
    "tangent": lambda cayley, v: _parts(cayley.tangent.matrix(v)),
    "rate": lambda cayley, v, w: iter(derivatives.applied(cayley.tangent_inv.matrix(v), w)),
} | derivatives.COMPONENTS
"""SymPy expressions of the components, by function."""

ROWS = {"pose": 1, "quaternion": 1, "tangent": 1, "rate": 2} | derivatives.ARGUMENTS
"""Functions measured with components first, with their number of arguments."""

DERIVED = {"compose_jacobians": 2}
"""Largest order at which SymPy derives a function in some ten seconds; functions not listed have no limit."""

ROOM = 4e9
"""Memory limit in bytes; functions by SymPy keep all intermediate values until they return."""


@cache
def lambdified(order: int, function: str) -> Callable[..., Any]:
    """Return a function by SymPy's ``lambdify(cse=True)``; it takes six rows for each argument."""
    symbols = [sympy.symbols(f"{letter}1:7") for letter in "vwz"[: ROWS[function]]]
    components = COMPONENTS[function](Cayley(order), *symbols)
    arguments = [symbol for vector in symbols for symbol in vector]
    compute: Callable[..., Any] = sympy.lambdify(arguments, list(components), "numpy", cse=True)
    return compute


def lambdify_call(order: int, function: str, rows: tuple[Any, ...]) -> Call | None:
    """Return a call of `lambdified` on these rows; None if derivation is slow or intermediate values exceed `ROOM`."""
    if order > DERIVED.get(function, order):
        return None
    compute, given = lambdified(order, function), [row for array in rows for row in array]
    room: int = compute.__code__.co_nlocals * given[0].nbytes
    return partial(compute, *given) if room <= ROOM else None


def filled(compute: Call, out: Any) -> Call:
    """Return a call that copies the components of a lambdified function into one result, as ours are."""
    targets = _rows_of(out)

    def fill() -> None:
        for target, value in zip(targets, compute(), strict=True):
            target[...] = value

    return fill


def _rows_of(out: Any) -> list[Any]:
    return [row for array in _arrays(out) for row in array.reshape(-1, array.shape[-1])]


def _parts(parts: tuple[sympy.Matrix, sympy.Matrix]) -> Iterator[sympy.Expr]:
    for part in parts:
        yield from part


def _pose(cayley: Cayley, v: tuple[sympy.Symbol, ...]) -> Iterator[sympy.Expr]:
    rho = cayley.tangent.matrix(v)[0] * sympy.Matrix(v[3:])
    yield from cayley.tensor.matrix(v)[0].row_join(rho)
    yield from map(sympy.Integer, (0, 0, 0, 1))


def compiled(order: int, function: str, rows: tuple[Any, ...], out: Any) -> Call | None:
    """Return a call of the C kernel on the same rows; None without a C compiler."""
    form = c_form(order)
    if form is None:
        return None
    given = [array.reshape(-1, array.shape[-1]) for array in rows]
    made = tuple(array.reshape(-1, array.shape[-1]) for array in _arrays(out))
    return partial(form.call, function, *given, out=made)


def _arrays(out: Any) -> tuple[Any, ...]:
    return out if isinstance(out, tuple) else (out,)


@cache
def c_form(order: int) -> Any:
    """Return the C kernels of an order, compiled once."""
    return load_c(order)


def copy_floor(rows: tuple[Any, ...], out: Any) -> Call:
    """Return a copy that writes each row of the result once, from rows of the arguments: a lower bound of the time."""
    targets = _rows_of(out)
    sources = np.concatenate(rows)
    pairs = [(target, sources[i % len(sources)]) for i, target in enumerate(targets)]

    def copy() -> None:
        for target, source in pairs:
            np.copyto(target, source)

    return copy
