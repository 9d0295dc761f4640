"""Checks of what benchmarks time: peers and kernels compute equal results; GPU script."""

from __future__ import annotations

import importlib
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from benchmarks import derivatives, forms, maps, peers
from benchmarks.peers import Poses
from dualcay import exponential
from tests.support.kernels import load

ORDER = 1  # order at which SymPy derives every function in a second
CLOSE = {"rtol": 1e-12, "atol": 1e-12}  # tolerances for sums of some hundred terms of size 1 to 10, away from poles
FUNCTIONS = tuple(derivatives.ARGUMENTS)


def given(function: str, size: int = 20) -> tuple[np.ndarray, ...]:
    """Draw vectors near the origin, none of which compose to half a turn: SymPy's formula does not cover it."""
    poses = Poses.draw(load(ORDER), size)
    return tuple(0.1 * a for a in (poses.v, poses.w, poses.other))[: derivatives.ARGUMENTS[function]]


def flat(result: Any) -> np.ndarray:
    arrays = result if isinstance(result, tuple) else (result,)
    return np.concatenate([array.reshape(len(array), -1) for array in arrays], axis=-1)


@pytest.mark.parametrize("function", FUNCTIONS)
def test_derivatives_agree_with_sympy_and_complex_steps(function: str) -> None:
    arguments = given(function)
    ours = flat(getattr(load(ORDER), function)(*arguments))
    found = forms.lambdified(ORDER, function)(*(row for a in arguments for row in a.T))
    np.testing.assert_allclose(np.stack(np.broadcast_arrays(*found), axis=-1), ours, **CLOSE)
    steps = derivatives.stepped(load(ORDER), function)
    assert (steps is None) == (function == "compose_jacobians")
    if steps:
        np.testing.assert_allclose(flat(steps(*arguments)), ours, **CLOSE)
        np.testing.assert_allclose(steps(*(a[0] for a in arguments)).ravel(), ours[0], **CLOSE)


@pytest.mark.thorough
def test_derivatives_by_jax_agree() -> None:
    """Compare those by either argument, compiled, at one pose."""
    jax = pytest.importorskip("jax")
    for function in FUNCTIONS:
        calls = derivatives.jax_calls(jax, ORDER, function, tuple(a[0] for a in given(function)))
        assert set(calls) == {"jitted", "called"}
        ours = getattr(load(ORDER), function)(*(a[0] for a in given(function)))
        np.testing.assert_allclose(np.asarray(calls["jitted"]()), np.stack(ours), **CLOSE)


@pytest.mark.parametrize("name", maps.FORMS[maps.NUMPY])
def test_chart_vectors_and_library_arguments_are_the_same_poses(name: str) -> None:
    """Compare v and w. At 3 rad, the angle computed from sin(α/2) has an error of 14 roundings."""
    module, poses = importlib.import_module(f"dualcay.{name}"), maps.drawn(name, 5)
    np.testing.assert_allclose(module.to_exponential(poses.v), poses.exponential, rtol=0, atol=1e-13)
    np.testing.assert_allclose(module.to_exponential(poses.w), poses.other, rtol=0, atol=1e-13)


def as_pose(library: str, result: Any) -> np.ndarray:
    """Return homogeneous matrices from a result of a library: matrices, a transform of its own, or coordinates."""
    if isinstance(result, list):
        return np.stack([as_pose(library, each) for each in result])
    for convert in ("as_matrix", "homogeneous", "to_homogenous_matrix"):
        if hasattr(result, convert):
            found = getattr(result, convert)
            return np.asarray(found() if callable(found) else found)
    found = np.asarray(result)
    if found.shape[-1] == 4:
        return found
    if found.shape[-1] == 7:  # jaxlie's parameters: quaternion, translation
        return np.asarray(importlib.import_module("jaxlie").SE3(found).as_matrix())
    if found.shape[-1] == 8:
        return np.asarray(exponential.pose(exponential.from_quaternion(found)))
    order = peers.SWAP if library in ("jaxlie", "pinocchio") else np.arange(6)
    return np.asarray(exponential.pose(found[..., order]))


SLOWLY = {"jaxlie": pytest.mark.thorough}  # compiled
WHOLE = [name for name in peers.LIBRARIES if name != "SymForce"]  # which leaves the translation as it is


@pytest.mark.parametrize("size", [1, 3])
@pytest.mark.parametrize("library", [pytest.param(name, marks=SLOWLY.get(name, ())) for name in WHOLE])
def test_calls_of_libraries_compute_the_same_poses(library: str, size: int) -> None:
    """Allow 1e-9: logarithms of two libraries lose digits at 3 rad. A library that is not installed has no calls."""
    poses = maps.drawn("exponential", size)
    for function in maps.FUNCTIONS:
        expected = poses.T if function != "compose" else exponential.pose(exponential.compose(poses.w, poses.v))
        for text, call in peers.LIBRARIES[library].calls(function, poses, size).items():
            found = as_pose(library, call())
            np.testing.assert_allclose(found.reshape(expected.shape), expected, rtol=0, atol=1e-9, err_msg=text)


QUICKLY = {"XLA_FLAGS": "--xla_backend_optimization_level=0"}
"""Options of XLA for quick compilation; tests do not need fast maps."""

SCRIPT = Path(__file__).parents[2] / "benchmarks" / "gpu.py"


def run(*options: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(SCRIPT), *options]
    environment = {"PYTHONPATH": str(SCRIPT.parents[1]), "PATH": "/usr/bin:/bin", "JAX_PLATFORMS": "cpu", **QUICKLY}
    return subprocess.run(command, capture_output=True, text=True, check=False, env=environment)


@pytest.mark.thorough
def test_the_cpu_path_prints_a_row_for_every_map_and_size():
    done = run("--device", "cpu", "--poses", "1e2,1e3", "-n", "2", "--dtype", "float64")
    assert done.returncode == 0, done.stderr
    for name in ("quaternion", "pose", "rate", "from_pose"):
        assert sum("JAX" in line and f" {name} " in line for line in done.stdout.splitlines()) == 2
    assert "cupy: runs on GPUs only" in done.stdout
