"""Pictures by what they contain: number and ends of lines, names of axes, breaks at changes of branch."""

from __future__ import annotations

import pickle
import sys
from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np
import pytest

from dualcay import Motion, PoseSpline, cayley2, cayley3, plot, propagate, transform_point_covariance

figures = pytest.importorskip("matplotlib.figure")
POSES = cayley2.pose(cayley2.random(5, rng=0))
SPLINE = PoseSpline(cayley2, [0, 1], np.zeros((2, 6)))


@pytest.fixture(params=["3d", None], ids=["space", "plane"])
def axes(request: pytest.FixtureRequest) -> Any:
    return figures.Figure().add_subplot(projection=request.param)


@pytest.fixture(autouse=True)
def _closed() -> Iterator[None]:
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pyplot.switch_backend("agg")
    yield
    pyplot.close("all")


@pytest.fixture(scope="module")
def motion() -> Motion:
    """Return a motion by more than a turn, with two changes of branch."""
    return propagate(cayley3, cayley3.identity(), [0.3, 0.4, 0, 0, 0, 0.1], np.linspace(0, 30, 7))


def points(line: Any) -> np.ndarray:
    """Return the points of a line, shape (points, 2 or 3)."""
    return np.stack(line.get_data_3d() if hasattr(line, "get_data_3d") else line.get_data(), axis=-1)


def test_frames_are_three_lines_from_the_origins_to_the_tips(axes: Any) -> None:
    assert plot.frames(POSES, axes, length=0.5, plane="zx") is axes
    shown = [0, 1, 2] if axes.name == "3d" else [2, 0]
    assert [line.get_color() for line in axes.lines] == ["tab:red", "tab:green", "tab:blue"]
    for k, line in enumerate(axes.lines):
        pieces = np.append(points(line), np.full((1, len(shown)), np.nan), axis=0).reshape(5, 3, -1)
        np.testing.assert_array_equal(pieces[:, 0], POSES[:, shown, 3])
        np.testing.assert_allclose(pieces[:, 1] - pieces[:, 0], 0.5 * POSES[:, shown, k], atol=1e-15)
        assert np.isnan(pieces[:, 2]).all()
    names = [axes.get_xlabel(), axes.get_ylabel(), *([axes.get_zlabel()] if axes.name == "3d" else [])]
    assert names == ["xyz"[k] for k in shown]
    assert axes.get_aspect() in ("equal", 1.0)


def test_frames_have_a_length_of_their_own() -> None:
    extent = np.ptp(POSES[:, :3, 3], axis=0).max()
    for poses, length in ((POSES, 0.08 * extent), (np.eye(4), 1.0)):
        origin, tip = points(plot.frames(poses).lines[0])[:2]
        assert np.linalg.norm(tip - origin) == pytest.approx(length)


def test_a_trajectory_is_the_way_of_the_origin(axes: Any, motion: Motion) -> None:
    axes.set_xlabel("mine")
    plot.trajectory(motion, axes, label="body", color="k")
    plot.trajectory(motion.pose, axes)
    first, second = axes.lines
    np.testing.assert_array_equal(points(first), motion.pose[:, : points(first).shape[1], 3])
    np.testing.assert_array_equal(points(first), points(second))
    assert (first.get_label(), first.get_color(), axes.get_xlabel()) == ("body", "k", "mine")
    low, high = axes.get_ylim()
    assert low <= motion.pose[:, 1, 3].min()
    assert high >= motion.pose[:, 1, 3].max()


def test_ellipsoids_have_the_extent_of_their_covariance(axes: Any, motion: Motion) -> None:
    """The extent of an ellipsoid along a space axis is a multiple of the deviation of that component."""
    P = transform_point_covariance(cayley3, motion.v, np.zeros(3), np.diag([1e-2] * 3 + [1e-4, 4e-4, 9e-4]))
    plot.ellipsoids(motion.pose[:, :3, 3], P, axes, deviations=2)
    [line] = axes.lines
    found = points(line)
    pieces = np.append(found, np.full((1, found.shape[1]), np.nan), axis=0).reshape(-1, 62, found.shape[1])[:, :-1]
    sections = 3 if axes.name == "3d" else 1
    pieces = pieces.reshape(sections, 7, 61, -1) - motion.pose[:, : found.shape[1], 3][:, None]
    if sections == 1:  # the outline is found at 60 directions
        extent = 2 * np.sqrt(np.diagonal(P, axis1=1, axis2=2)[:, :2])
        np.testing.assert_allclose(pieces.max(axis=(0, 2)), extent, rtol=(np.pi / 60) ** 2)
    inverse = np.linalg.inv(P[:, : found.shape[1], : found.shape[1]])
    np.testing.assert_allclose(np.einsum("sntj,njk,sntk->snt", pieces, inverse, pieces), 4, rtol=1e-9)


def test_angles_break_at_changes_of_branch(motion: Motion) -> None:
    axes = plot.angles(pickle.loads(pickle.dumps(motion)), color="C2")
    line, *switches = axes.lines
    assert [one.get_xdata()[0] for one in switches] == motion.switches.tolist()
    assert len(switches) == 2
    t, angle = points(line).T
    assert np.isin(motion.switches, t[np.isnan(angle)]).all()
    kept = ~np.isnan(angle)
    np.testing.assert_allclose(angle[kept], np.degrees(cayley3.angle(motion(t[kept]))[:, 0]), rtol=1e-12)
    turned = np.degrees(0.5 * t[kept]) % 360
    np.testing.assert_allclose(np.cos(np.radians(angle[kept])), np.cos(np.radians(turned)), atol=1e-8)
    assert (line.get_color(), axes.get_xlabel(), axes.get_ylabel()) == ("C2", "time (s)", "rotation angle of v (°)")


def test_missing_matplotlib_is_an_error_that_says_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ImportError, match=r'^dualcay\.plot needs Matplotlib: pip install "matplotlib>=3\.9"$'):
        plot.frames(POSES)


def test_new_axes_show_a_plane_if_one_is_named(motion: Motion) -> None:
    for draw in (plot.frames, plot.trajectory):
        assert [draw(motion.pose, plane=plane).name for plane in (None, "xz")] == ["3d", "rectilinear"]


def test_wrong_arguments_are_refused(motion: Motion) -> None:
    for call, error, message in (
        (lambda: plot.frames(np.eye(3)), ValueError, r"poses must have shape \(\.\.\., 4, 4\), got \(3, 3\)"),
        (lambda: plot.trajectory(np.eye(4)[None], plane="xx"), ValueError, "plane must be two of the letters x, y, z"),
        (lambda: plot.frames(SPLINE), TypeError, "such as those of its pose, got PoseSpline"),
        (lambda: plot.trajectory(np.zeros((5, 6))), ValueError, r"such as cayley2\.pose\(v\), got vectors"),
        *((partial(draw, axes=figures.Figure()), TypeError, r"figure\.add_subplot\(\), got Figure") for draw in (
            partial(plot.frames, POSES), partial(plot.angles, motion), partial(plot.ellipsoids, np.zeros(3), np.eye(3)),
        )),
        (lambda: plot.angles(POSES), TypeError, "motion must be a Motion of propagate, got ndarray"),
        (lambda: plot.ellipsoids(np.zeros((2, 3)), np.eye(3)), ValueError, "a matrix for each point, got 1 for 2"),
    ):
        with pytest.raises(error, match=message):
            call()
