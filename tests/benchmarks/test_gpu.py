"""Test of the GPU script on the CPU."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.thorough

QUICKLY = {"XLA_FLAGS": "--xla_backend_optimization_level=0"}
"""Options of XLA for quick compilation; tests do not need fast maps."""

SCRIPT = Path(__file__).parents[2] / "benchmarks" / "gpu.py"


def run(*options: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(SCRIPT), *options]
    environment = {"PYTHONPATH": str(SCRIPT.parents[1]), "PATH": "/usr/bin:/bin", "JAX_PLATFORMS": "cpu", **QUICKLY}
    return subprocess.run(command, capture_output=True, text=True, check=False, env=environment)


def test_the_cpu_path_prints_a_row_for_every_map_and_size():
    done = run("--device", "cpu", "--poses", "1e2,1e3", "-n", "2", "--dtype", "float64")
    assert done.returncode == 0, done.stderr
    for name in ("quaternion", "pose", "rate", "from_pose"):
        assert sum("JAX" in line and f" {name} " in line for line in done.stdout.splitlines()) == 2
    assert "cupy: runs on GPUs only" in done.stdout


def test_libraries_report_a_missing_gpu():
    done = run("--device", "gpu", "--poses", "1e2", "-n", "1")
    missing = [line for line in done.stdout.splitlines() if "sees no GPU" in line or "not installed" in line]
    assert (len(missing) == 4 and done.returncode == 3) or "PyTorch" in done.stdout or "JAX" in done.stdout
