"""Checks of the benchmarks: peers and kernels compute equal results, reports name missed gates; GPU script."""

from __future__ import annotations

import importlib
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from benchmarks import derivatives, forms, kernels, timing
from benchmarks.peers import Poses
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


def test_jax_derivatives_are_by_the_named_argument(monkeypatch: pytest.MonkeyPatch) -> None:
    """Replace the kernels by ``v²`` and ``v² w``, functions with known derivatives."""
    jax = pytest.importorskip("jax")
    square = SimpleNamespace(tangent=lambda v: v * v, twist=lambda v, w: v * v * w)
    square.rate = square.compose = square.twist
    monkeypatch.setattr(derivatives, "array_module", lambda _: square)
    v, w, z = np.arange(1.0, 19).reshape(3, 6)
    expected = {
        "tangent_dot": 2 * v * w,
        "twist_jacobian": np.diag(2 * v * w),
        "rate_jacobian": np.diag(2 * v * w),
        "rate_dot": 2 * v * (v * v * w) * w + v * v * z,
        "compose_jacobians": np.stack([np.diag(2 * v * w), np.diag(v * v)]),
    }
    for function in FUNCTIONS:
        arguments = (v, w, z)[: derivatives.ARGUMENTS[function]]
        calls = derivatives.jax_calls(jax, ORDER, function, arguments)
        assert set(calls) == {"jitted", "called"}
        np.testing.assert_allclose(np.asarray(calls["jitted"]()), expected[function], rtol=1e-14)


def test_benchmarks_respect_the_memory_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    rows = tuple(np.ascontiguousarray(a.T) for a in given("rate_jacobian"))
    assert forms.lambdify_call(ORDER, "rate_jacobian", rows) is not None
    monkeypatch.setattr(forms, "ROOM", 12 * rows[0][0].nbytes)
    assert forms.lambdify_call(ORDER, "rate_jacobian", rows) is None
    assert forms.lambdify_call(3, "compose_jacobians", rows) is None


def test_missed_speed_gates_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    """Replace measured times: our call takes one unit, a JAX call 30 units, a compiled JAX call 10 units."""
    units = {"ours": 1.0, "called": 30.0, "jitted": 10.0, "steps": 2.0}
    monkeypatch.setattr(kernels, "measured", lambda calls, *_, **__: {name: units[name] for name in calls})
    monkeypatch.setattr(derivatives, "jax_calls", lambda *_: {"jitted": int, "called": int})
    monkeypatch.setattr(kernels, "load", importlib.import_module)
    found = [gate for _, gates in kernels.of_derivatives(load(ORDER), 1) for gate in gates]
    assert {gate.what for gate in found if not gate.met} == {f"{f}, n = 1, N = 1: JAX, jitted" for f in FUNCTIONS}
    assert {gate.what for gate in found if gate.met} == {f"{f}, n = 1, N = 1: JAX, called" for f in FUNCTIONS}


def test_gate_that_a_copy_misses_is_marked() -> None:
    said = [kernels.Gate("a", *ratios).row()[-1] for ratios in ((1.0, 2.0, 3.0), (1.0, 2.0, 1.5), (2.5, 2.0, 3.0))]
    assert said == ["SHORT", "SHORT, of a copy 1.5 x", "met"]


def test_rows_are_timed_with_one_result_and_with_two(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(timing, "SECONDS", 1e-5)
    monkeypatch.setattr(kernels, "ROWS", {"rate_dot": 3, "compose_jacobians": 2})
    monkeypatch.setattr(kernels, "compiled", lambda *_: None)
    for row, _ in kernels.on_rows(load(ORDER), 100):
        assert float(row[3]) > 0
        assert " x)" in row[4]


def test_gates_depend_on_the_chart(monkeypatch: pytest.MonkeyPatch) -> None:
    """Expect two gates for exponential coordinates, and only gates of forward maps for a chart of order 3."""
    units = {"ours": 1.0, "scipy": 7.0, "pytransform3d": 2.0}
    monkeypatch.setattr(kernels, "measured", lambda calls, *_, **__: {k: units[k] for k, call in calls.items() if call})
    decided = {}
    for name in ("exponential", "lambert", "sine3"):
        lines = [*kernels.against_libraries(importlib.import_module(f"dualcay.{name}"), 1)]
        assert [row[:2] for row, _ in lines] == [(name, function) for function in kernels.OF_ALGEBRAIC]
        decided[name] = {gate.what.split(",")[0]: gate.met for _, gates in lines for gate in gates}
    assert decided["exponential"] == {"pose": True, "from_pose": True}
    assert decided["lambert"] == dict.fromkeys(kernels.OF_ALGEBRAIC, False)
    assert decided["sine3"] == dict.fromkeys(kernels.FORWARD, False)


@pytest.mark.parametrize("name", kernels.FAMILIES)
def test_chart_vectors_and_library_arguments_are_the_same_poses(name: str) -> None:
    """Compare v and w. At 3 rad, the angle computed from sin(α/2) has an error of 14 roundings."""
    module = importlib.import_module(f"dualcay.{name}")
    poses = Poses.draw(module, 5)
    np.testing.assert_allclose(module.to_exponential(poses.v), poses.exponential, rtol=0, atol=1e-13)
    np.testing.assert_allclose(module.to_exponential(poses.w), poses.other, rtol=0, atol=1e-13)


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


@pytest.mark.thorough
def test_libraries_report_a_missing_gpu():
    done = run("--device", "gpu", "--poses", "1e2", "-n", "1")
    missing = [line for line in done.stdout.splitlines() if "sees no GPU" in line or "not installed" in line]
    assert (len(missing) == 4 and done.returncode == 3) or "PyTorch" in done.stdout or "JAX" in done.stdout
