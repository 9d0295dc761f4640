"""The example of inverse kinematics by JAX: derivatives, solutions checked by NumPy kernels, postures."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path

import numpy as np
import pytest

from examples import arm
from tests.support.libraries import Late

example = Late("examples.inverse_kinematics_jax")
RNG = np.random.default_rng(2)
COUNT = 24
pytestmark = pytest.mark.thorough  # each compilation takes seconds


@pytest.fixture(scope="module")
def chart(tmp_path_factory: pytest.TempPathFactory):
    folder = str(tmp_path_factory.mktemp("kernels"))
    yield example.kernels(folder)
    sys.path.remove(folder)


@pytest.fixture(scope="module")
def solve(chart):
    return example.compiled(chart, "forward", COUNT)


@pytest.mark.parametrize("mode", ["forward", "reverse"])
def test_derivative_is_the_jacobian_by_screws(chart, mode):
    """Compare with the arm's Jacobian: at the pose itself, the derivative of `local` is the twist in space."""
    there = arm.tool(example.JOINTS)
    found = example.MODES[mode](lambda joints: chart.local(example.tool(chart, joints), there))(example.JOINTS)
    # products of six matrices of size 1
    assert np.abs(found - arm.jacobian(example.JOINTS)).max() < 1e-13
    assert np.abs(found - arm.jacobian(example.JOINTS)[:, ::-1]).max() > 0.1


def test_solutions_from_near_and_out_of_reach(solve):
    goals = np.tile(arm.tool(example.JOINTS), (COUNT, 1))
    starts = example.JOINTS + RNG.uniform(-0.2, 0.2, (COUNT, 6))
    goals[-1] = arm.chart.retract(goals[-1], [0, 0, 0, 3, 0, 0])
    joints, errors = map(np.asarray, solve(goals, starts))
    # joint angles err by the tolerance times the inverse of the Jacobian, which is below 100 here
    assert np.abs(joints[:-1] - example.JOINTS).max() < 1e-10
    assert np.all(errors[:-1, -1] < arm.TOLERANCE)
    assert errors[-1, -1] > 0.1
    assert np.isfinite(joints[-1]).all()


def test_postures_differ_and_reach_the_target(solve):
    starts = RNG.uniform(-np.pi, np.pi, (COUNT, 6))
    joints, errors = map(np.asarray, solve(np.tile(arm.tool(example.JOINTS), (COUNT, 1)), starts))
    found = example.postures(joints[errors[:, -1] < arm.TOLERANCE])
    assert 3 <= len(found) <= 8
    # some tens of roundings of poses of size 1, beside the tolerance
    assert np.abs(arm.chart.local(arm.tool(found), arm.tool(example.JOINTS))).max() < 2 * arm.TOLERANCE
    assert len(example.postures(np.vstack([found, found + 2 * np.pi]))) == len(found)


def test_printed_results_and_figure(chart, solve, capsys, tmp_path: Path, monkeypatch):
    pytest.importorskip("matplotlib")
    module = importlib.import_module("examples.inverse_kinematics_jax")
    monkeypatch.setattr(module, "kernels", lambda _: chart)
    monkeypatch.setattr(module, "compiled", lambda *_: solve)
    example.main(["--targets", "3", "--starts", str(COUNT // 3), "--figure", str(tmp_path / "picture.png")])
    assert "of targets" in capsys.readouterr().out
    assert (tmp_path / "picture.png").stat().st_size > 10_000
