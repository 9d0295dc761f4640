"""Examples as commands on little data: each asserts what its text promises, and draws its figure."""

from __future__ import annotations

import importlib
import sys
import tracemalloc
from pathlib import Path

import numpy as np
import pytest

from examples import arm
from tests.support.libraries import Late

OPTIONS = {
    "arm": "--poses 8", "attitude_filter": "--runs 40 --steps 240", "heavy_top": "--end 0.04",
    "camera_path": "--rate 20", "pose_cloud": "--runs 400 --steps 30", "preintegration": "--rate 40 --frames 2",
    "rendezvous": "--runs 400", "rotation_vectors": "--rate 5", "stream": "--count 20000 --chunk 5000",
    "inverse_kinematics_jax": "--targets 2 --starts 12",
}  # fmt: skip
SLOW = {"inverse_kinematics_jax": pytest.mark.thorough}  # compiled


@pytest.mark.parametrize("name", [pytest.param(name, marks=SLOW.get(name, ())) for name in OPTIONS])
def test_an_example_holds_and_draws_its_figure(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("matplotlib")
    monkeypatch.setattr(sys, "path", [*sys.path])
    figure = tmp_path / "figure.png"
    importlib.import_module(f"examples.{name}").main([*OPTIONS[name].split(), "--figure", str(figure)])
    assert figure.stat().st_size > 10_000


@pytest.mark.smoke
def test_a_pose_out_of_reach_is_an_error() -> None:
    joints = np.array([0.2, -1.2, 1.5, -0.5, 0.8, 0.3])
    with pytest.raises(ArithmeticError, match="no joint angles found"):
        arm.inverse_kinematics(arm.chart.retract(arm.tool(joints), [0, 0, 0, 3, 0, 0]), joints)


def peak(chunks: int) -> int:
    """Return the largest memory in use, in bytes, for a number of chunks of 20 000 poses."""
    dask, stream = Late("dask"), Late("examples.stream")
    with dask.config.set(scheduler="synchronous"):
        tracemalloc.start()
        stream.moments(stream.points(20_000 * chunks, 20_000, 1))
        found = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
    return found


def test_memory_of_the_stream_depends_on_its_chunk_only() -> None:
    peak(2)  # imports and scratch memory
    few, many = peak(5), peak(15)
    # 10 more chunks of 48 bytes per pose would be 10 MB; their tasks in the graph take some 30 kB each
    assert many - few < 0.1 * 10 * 48 * 20_000
