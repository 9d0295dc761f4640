"""Inverse kinematics by JAX: ``python -m examples.inverse_kinematics_jax [--mode reverse] [--figure FILE]``.

The arm of ``examples/arm.py`` is a chain of six `compose` of array-API kernels, which JAX differentiates and compiles.
Levenberg–Marquardt minimizes |r|², where r is the step from the tool to its target. The damping is |r|²/2, as in
Sugihara (IEEE Trans. Robotics 27, 2011): steps are safe far away, and convergence is quadratic.
`vmap` solves all targets at once, each from several random starts: the arm has up to eight postures for a target.
"""

import argparse
import importlib
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from functools import cache, reduce
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

import derive
from examples import arm

jax.config.update("jax_enable_x64", True)
MODES: dict[str, Callable[..., Any]] = {"forward": jax.jacfwd, "reverse": jax.jacrev}
ITERATIONS = 50
Solver = Callable[[Any, Any], tuple[jax.Array, jax.Array]]


@cache
def kernels() -> Any:
    """Return the module of exponential coordinates, generated for array-API libraries and imported."""
    with tempfile.TemporaryDirectory() as folder:
        derive.generate(families=["exponential"], target="array-api", output=f"{folder}/arm_kernels")
        sys.path.insert(0, folder)
        try:
            return importlib.import_module("arm_kernels.exponential")
        finally:
            sys.path.remove(folder)


def tool(joints: jax.Array) -> jax.Array:
    """Return exponential coordinates of the tool, shape (6,), for joint angles of shape (6,)."""
    return reduce(kernels().compose, [*joints[:, None] * arm.SCREWS, jnp.asarray(arm.HOME)])


def residual(joints: jax.Array, goal: jax.Array) -> jax.Array:
    """Return the step δ from the tool to the goal, in rad and m."""
    return kernels().local(goal, tool(joints))


def solve(mode: str, goal: jax.Array, start: jax.Array) -> tuple[jax.Array, jax.Array]:
    """Return joint angles in [−π, π] near the goal, shape (6,), and the error before each iteration."""

    def step(joints: jax.Array, _: None) -> tuple[jax.Array, jax.Array]:
        error, slope = residual(joints, goal), MODES[mode](residual)(joints, goal)
        normal = slope.T @ slope + error @ error / 2 * jnp.eye(6)
        size = jnp.abs(error).max()
        return joints - jnp.where(size < arm.TOLERANCE, 0, jnp.linalg.solve(normal, slope.T @ error)), size

    joints, errors = jax.lax.scan(step, start, length=ITERATIONS)
    return (joints + jnp.pi) % (2 * jnp.pi) - jnp.pi, errors
