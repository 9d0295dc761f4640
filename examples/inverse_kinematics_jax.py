"""Inverse kinematics by JAX
=========================

Run ``python -m examples.inverse_kinematics_jax [--mode reverse] [--figure FILE]``.

The arm of ``examples/arm.py`` is a chain of six `compose` of array-API kernels, which JAX differentiates and compiles.
Levenberg–Marquardt minimizes ‖r‖², where r is the step from the tool to its target. The damping is ‖r‖²/2, as in
Sugihara (IEEE Trans. Robotics 27, 2011): it keeps steps short far away and vanishes at the target.
`jax.vmap` solves all targets at once, each from several random starts: an arm reaches a target in several postures.

.. image:: /figures/inverse_kinematics_jax.svg
"""

# sphinx_gallery_thumbnail_path = 'reference/generated/thumbnail_inverse_kinematics_jax.svg'

import argparse
import importlib
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from types import ModuleType
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

import derive
from examples import arm

jax.config.update("jax_enable_x64", True)
MODES: dict[str, Callable[..., Any]] = {"forward": jax.jacfwd, "reverse": jax.jacrev}
ITERATIONS = 60
JOINTS = np.array([0.2, -1.2, 1.5, -0.5, 0.8, 0.3])  # rad, of the target in the picture
Solver = Callable[[np.ndarray, np.ndarray], tuple[jax.Array, jax.Array]]


def kernels(folder: str) -> ModuleType:
    """Write kernels of exponential coordinates for array-API libraries into a folder; return their module."""
    derive.generate(families=["exponential"], target="array-api", output=f"{folder}/arm_kernels")
    sys.path.insert(0, folder)
    return importlib.import_module("arm_kernels.exponential")


def tool(chart: ModuleType, joints: jax.Array) -> jax.Array:
    """Return exponential coordinates of the tool, shape (6,). The loop over joints compiles `compose` once."""
    turns = jnp.flip(joints[:, None] * arm.SCREWS, 0)
    return jax.lax.scan(lambda v, turn: (chart.compose(turn, v), None), jnp.asarray(arm.HOME), turns)[0]


def compiled(chart: ModuleType, mode: str, count: int) -> Solver:
    """Return the compiled function of `count` goals and starts, shape (count, 6).

    Its results are joint angles in [−π, π) and the error before each iteration, shape (count, ITERATIONS).
    """

    def solve(goal: jax.Array, start: jax.Array) -> tuple[jax.Array, jax.Array]:
        def residual(joints: jax.Array) -> tuple[jax.Array, jax.Array]:
            error = chart.local(goal, tool(chart, joints))
            return error, error

        def step(joints: jax.Array, _: None) -> tuple[jax.Array, jax.Array]:
            slope, error = MODES[mode](residual, has_aux=True)(joints)
            change = jnp.linalg.solve(slope.T @ slope + error @ error / 2 * jnp.eye(6), slope.T @ error)
            size = jnp.abs(error).max()
            return joints - jnp.where(size < arm.TOLERANCE, 0, change), size

        joints, errors = jax.lax.scan(step, start, length=ITERATIONS)
        return (joints + jnp.pi) % (2 * jnp.pi) - jnp.pi, errors

    shape = jax.ShapeDtypeStruct((count, 6), float)
    return jax.jit(jax.vmap(solve)).lower(shape, shape).compile()


def postures(joints: np.ndarray) -> np.ndarray:
    """Return the joint angles that differ by more than 1e-6 in some sine or cosine."""
    circles = np.hstack([np.cos(joints), np.sin(joints)]).round(6)
    return joints[np.unique(circles, axis=0, return_index=True)[1]]


def main(argv: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description="Inverse kinematics by JAX")
    parser.add_argument("--targets", type=int, default=100, help="number of random targets")
    parser.add_argument("--starts", type=int, default=32, help="number of random starts for each target")
    parser.add_argument("--mode", choices=MODES, default="forward", help="mode of differentiation")
    parser.add_argument("--figure", help="file for the picture")
    options, rng = parser.parse_args(argv), np.random.default_rng(0)
    goals = arm.tool(np.vstack([JOINTS, rng.uniform(-np.pi, np.pi, (options.targets - 1, 6))]))
    starts = rng.uniform(-np.pi, np.pi, (options.targets * options.starts, 6))
    with tempfile.TemporaryDirectory() as folder:
        chart, start = kernels(folder), time.perf_counter()
        solve = compiled(chart, options.mode, len(starts))
    slope = MODES[options.mode](lambda joints: chart.local(tool(chart, joints), arm.tool(JOINTS)))(JOINTS)
    assert np.abs(slope - arm.jacobian(JOINTS)).max() < 1e-13  # products of six matrices of size 1
    print(f"{options.mode} mode compiled in {time.perf_counter() - start:.1f} s")
    start = time.perf_counter()
    joints, errors = map(np.asarray, solve(np.repeat(goals, options.starts, 0), starts))
    print(f"{len(starts)} starts solved in {time.perf_counter() - start:.2f} s")
    found = errors[:, -1] < arm.TOLERANCE
    reached = found.reshape(-1, options.starts)
    counts = (errors[found] >= arm.TOLERANCE).sum(1)
    check = np.abs(arm.chart.local(arm.tool(joints), np.repeat(goals, options.starts, 0))[found]).max()
    print(f"reached: {found.mean():.1%} of starts, {reached.any(1).mean():.1%} of targets")
    print(f"median of iterations {np.median(counts):.0f}, largest error by NumPy kernels {check:.0e} (rad, m)")
    assert check < 2 * arm.TOLERANCE
    assert reached[0].any()
    shown = postures(joints[: options.starts][reached[0]])
    print(f"first target: {len(shown)} postures")
    if options.figure:
        from matplotlib.figure import Figure

        figure = Figure(figsize=(8.2, 4.5), layout="constrained")
        space, right = figure.add_subplot(1, 2, 1, projection="3d"), figure.add_subplot(1, 2, 2)
        for motions in map(arm.links, shown):
            points = [arm.chart.transform_point(motions[k], r) for k, r in arm.CORNERS]
            space.plot(*np.transpose(points), "o-", markersize=3)
        space.set(xlabel="x (m)", ylabel="y (m)", title=f"{len(shown)} postures for one target", aspect="equal")
        space.locator_params(nbins=4)
        right.semilogy(errors[found][:20, :40].T, "C0", linewidth=1)
        right.axhline(arm.TOLERANCE, color="k", linestyle=":", label="tolerance")
        right.set(xlabel="iteration", ylabel="largest component of error (rad, m)")
        right.legend()
        figure.savefig(options.figure, metadata={"Date": None})


if __name__ == "__main__":
    main()
