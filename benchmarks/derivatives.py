"""Derivatives computed without our closed forms: by SymPy, by JAX, and by complex steps of kernels.

Functions are named as in the kernels; arguments are v, and w and z if the function takes them.
"""

from __future__ import annotations

import importlib
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np
import sympy

from benchmarks.timing import Call
from derive.maps import Cayley
from derive.maps.polynomials import x
from tests.support import packages

STEP = 1e-40
"""Complex step; it may be far below eps, because complex steps subtract nothing."""

Symbols = Sequence[sympy.Symbol]
Parts = tuple[sympy.Matrix, sympy.Matrix]

# --- SymPy --------------------------------------------------------------------------------------------------------


def applied(parts: Parts, w: Symbols) -> sympy.Matrix:
    """Apply a dual tensor to a dual vector; return six components."""
    real, dual = sympy.Matrix(w[:3]), sympy.Matrix(w[3:])
    return sympy.Matrix.vstack(parts[0] * real, parts[0] * dual + parts[1] * real)


def along(matrix: sympy.Matrix, v: Symbols, rates: Sequence[Any]) -> sympy.Matrix:
    """Return the derivative of a matrix along the given rates of v."""
    return sum((matrix.diff(c) * rate for c, rate in zip(v, rates, strict=True)), start=matrix * 0)


def tangent_dot(cayley: Cayley, v: Symbols, w: Symbols) -> Iterator[sympy.Expr]:
    for part in cayley.tangent.matrix(v):
        yield from along(part, v, w)


def twist_jacobian(cayley: Cayley, v: Symbols, w: Symbols) -> Iterator[sympy.Expr]:
    yield from applied(cayley.tangent.matrix(v), w).jacobian(v)


def rate_jacobian(cayley: Cayley, v: Symbols, w: Symbols) -> Iterator[sympy.Expr]:
    yield from applied(cayley.tangent_inv.matrix(v), w).jacobian(v)


def rate_dot(cayley: Cayley, v: Symbols, w: Symbols, z: Symbols) -> Iterator[sympy.Expr]:
    operator = cayley.tangent_inv.matrix(v)
    rate = applied(operator, w)
    yield from along(rate, v, list(rate)) + applied(operator, z)


def compose_jacobians(cayley: Cayley, v: Symbols, w: Symbols) -> Iterator[sympy.Expr]:
    """Yield the Jacobians of tan(atan2(|U|, S)/n) U/|U|; S + U is the product of both quaternions."""
    s, u = quaternion_product(cayley, v[:3], w[:3])
    length = sympy.sqrt(u.dot(u))
    real = u * (sympy.tan(sympy.atan2(length, s) / cayley.order) / length)
    moving, rates = [*v[:3], *w[:3]], [*v[3:], *w[3:]]
    for given in (v[:3], w[:3]):
        jacobian = real.jacobian(given)
        zero, dual = sympy.zeros(3), along(jacobian, moving, rates)
        yield from sympy.Matrix(sympy.BlockMatrix([[jacobian, zero], [dual, jacobian]]))


def quaternion_product(cayley: Cayley, v: Symbols, w: Symbols) -> tuple[sympy.Expr, sympy.Matrix]:
    """Return the product of the unnormalized quaternions p + q v of two vectors."""
    one, other = sympy.Matrix(v), sympy.Matrix(w)
    (p2, q2), (p1, q1) = ([f.subs(x, a.dot(a)) for f in (cayley.p, cayley.q)] for a in (one, other))
    s = p2 * p1 - q2 * q1 * one.dot(other)
    return s, p1 * q2 * one + p2 * q1 * other + q2 * q1 * one.cross(other)


COMPONENTS: dict[str, Callable[..., Iterator[sympy.Expr]]] = {
    function.__name__: function
    for function in (tangent_dot, twist_jacobian, rate_jacobian, rate_dot, compose_jacobians)
}
"""Generators of SymPy components, by measured function."""

ARGUMENTS = {name: 3 if name == "rate_dot" else 2 for name in COMPONENTS}
"""Number of dual vectors that each function takes."""

# --- complex steps ------------------------------------------------------------------------------------------------


def stepped(module: Any, function: str) -> Callable[..., Any] | None:
    """Return a derivative by complex steps of kernels; None for kernels that choose branches and need real input."""
    name = function.partition("_")[0]
    whole = getattr(module, name)
    if function.endswith("_jacobians"):
        return None
    if function.endswith("_jacobian"):
        return partial(_by_columns, whole)
    if name == "rate":
        return lambda v, w, z: whole(v + 1j * STEP * whole(v, w), w + 1j * STEP * z).imag / STEP
    return lambda v, w: whole(v + 1j * STEP * w).imag / STEP


def _by_columns(whole: Callable[..., Any], v: Any, w: Any) -> Any:
    moved = v[..., np.newaxis, :] + 1j * STEP * np.eye(6)
    return np.swapaxes(whole(moved, w[..., np.newaxis, :]).imag / STEP, -1, -2)


# --- JAX ----------------------------------------------------------------------------------------------------------


def differentiated(jax: Any, order: int, function: str) -> Callable[..., Any]:
    """Return a derivative at one pose: JAX in forward mode, applied to our array-api kernels."""
    module = array_module(order)
    name = function.partition("_")[0]
    whole = getattr(module, name)
    if function.endswith("_jacobians"):
        made: Callable[..., Any] = jax.jacfwd(whole, argnums=(0, 1))
    elif function.endswith("_jacobian"):
        made = jax.jacfwd(whole)
    elif name == "rate":

        def made(v: Any, w: Any, z: Any) -> Any:
            return jax.jvp(whole, (v, w), (whole(v, w), z))[1]

    else:

        def made(v: Any, w: Any) -> Any:
            return jax.jvp(whole, (v,), (w,))[1]

    return made


def jax_calls(jax: Any, order: int, function: str, arguments: Sequence[Any]) -> dict[str, Call]:
    """Return a call of the compiled derivative, mapped over poses; for one pose, also a call without compilation."""
    one = differentiated(jax, order, function)
    calls = {"jitted": jitted(jax, one, arguments)}
    if arguments[0].ndim > 1:
        return calls
    given = [jax.numpy.asarray(a) for a in arguments]
    return calls | {"called": lambda: jax.block_until_ready(one(*given))}


def jitted(jax: Any, one: Callable[..., Any], arguments: Sequence[Any]) -> Call:
    """Return a call of a function of one pose, compiled by JAX and mapped over poses, that waits for its results."""
    jax.config.update("jax_enable_x64", True)
    given = [jax.numpy.asarray(a) for a in arguments]
    fast = jax.jit(one if given[0].ndim == 1 else jax.vmap(one))
    call = partial(_waited, jax, fast, given)
    call()  # the first call compiles
    return call


def _waited(jax: Any, function: Callable[..., Any], given: Sequence[Any]) -> object:
    return jax.block_until_ready(function(*given))


@cache
def array_module(order: int) -> Any:
    """Return the array-api kernels of an order, printed once per process."""
    folder = Path(_folder().name) / f"dualcay_arrays{order}"
    packages.write([order], "array-api", folder)
    sys.path.insert(0, str(folder.parent))
    try:
        return importlib.import_module(f"{folder.name}.cayley{order}")
    finally:
        sys.path.remove(str(folder.parent))


@cache
def _folder() -> tempfile.TemporaryDirectory[str]:
    """Make a folder that lasts as long as the process: kernels import their rules for JAX at the first call."""
    return tempfile.TemporaryDirectory(prefix="dualcay-arrays-")
