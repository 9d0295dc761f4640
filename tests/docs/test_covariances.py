"""Table of conventions of covariances: poses drawn as each library moves them have the covariance that the row says."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np
from pytransform3d import trajectories, uncertainty
from scipy.spatial.transform import Rotation

from dualcay import compose_covariance, exponential, mean
from tests.support import pages

COUNT = 10**5
TEXT = (pages.ROOT / "docs" / "howto" / "covariances.md").read_text(encoding="utf-8")
Row = tuple[str, str, str, str]
ROWS: list[Row] = re.findall(r"^\| (.+) \| (.+) \| (\w+tion, \w+tion) \| `(.+)` \|$", TEXT, re.M)
Moved = Callable[[np.ndarray, np.ndarray], np.ndarray]


def fixed_axes(M: np.ndarray, step: np.ndarray) -> np.ndarray:
    """Return poses whose position changes by a step, and whose rotation turns about the fixed axes x, y, z in turn."""
    moved = np.tile(M, (len(step), 1, 1))
    moved[:, :3, :3] = Rotation.from_euler("xyz", step[:, :3]).as_matrix() @ M[:3, :3]
    moved[:, :3, 3] += step[:, 3:]
    return moved


def exp(step: np.ndarray) -> np.ndarray:
    return np.asarray(trajectories.transforms_from_exponential_coordinates(step))


MOVES: dict[str, Moved] = {
    "M exp(ξ)": lambda M, step: M @ exp(step), "exp(ξ) M": lambda M, step: exp(step) @ M,
    "position + ξ, rotation about fixed axes by ξ": fixed_axes,
}  # fmt: skip
"""Poses from steps [rotation, translation], by the second column; exponentials are those of pytransform3d."""


def names_of_the_page() -> dict[str, Any]:
    names: dict[str, Any] = {}
    for session in pages.blocks(TEXT, "python"):
        exec("\n".join(line[4:] for line in session.splitlines() if line.startswith((">>>", "..."))), names)
    return names


def agrees(row: Row, names: dict[str, Any]) -> bool:
    """Tell whether poses drawn as a row says have the covariance P in the body; their angles are up to 0.03 rad.

    Entries of a sample covariance have the deviation √((Pii Pjj + Pij²)/count); 5 of them are allowed, 2 % on the
    diagonal. Terms of fourth order are 0.03² of the diagonal.
    """
    P, (_, move, order, theirs) = names["P"] / 100, row
    steps = np.random.default_rng(1).multivariate_normal(np.zeros(6), eval(theirs, names | {"P": P}), COUNT)
    steps = steps if order.startswith("rotation") else np.roll(steps, 3, axis=1)
    drawn = exponential.from_pose(MOVES[move](names["cayley2"].pose(names["m"]), steps))
    squares = np.outer(np.diag(P), np.diag(P))
    bound = 5 * np.sqrt((squares + P**2) / COUNT) + 0.03**2 * np.sqrt(squares)
    return bool((abs(mean(exponential, drawn, covariance=True)[1] - P) < bound).all())


def test_poses_drawn_as_libraries_move_them_have_this_covariance() -> None:
    names = names_of_the_page()
    assert [row[0].split(",")[0] for row in ROWS] == [
        "dualcay", "dualcay", "GTSAM", "manif", "Sophus", "ROS", "pytransform3d", "pytransform3d",
    ]  # fmt: skip
    assert [row[0] for row in ROWS if not agrees(row, names)] == []
    for move, order, theirs in (
        ("M exp(ξ)", "rotation, translation", "A @ P @ A.T"), ("exp(ξ) M", "rotation, translation", "P"),
        ("M exp(ξ)", "translation, rotation", "P"),
        ("position + ξ, rotation about fixed axes by ξ", "rotation, translation", "P"),
    ):  # fmt: skip
        assert not agrees(("wrong", move, order, theirs), names)


def test_pytransform3d_composes_covariances_alike() -> None:
    """Allow the terms of fourth order that it adds for global uncertainty: 1e-8 times squares of lengths."""
    v, w = exponential.random((2,), max_angle=2.0, rng=3)
    V, W, P, Q = *exponential.pose([v, w]), np.diag(np.arange(1, 7) / 3e4), np.diag(np.arange(6, 0, -1) / 3e4)
    space = uncertainty.concat_globally_uncertain_transforms(V, P, W, Q)[1]
    np.testing.assert_allclose(compose_covariance(exponential, w, v, Q, P, frame="space"), space, rtol=0, atol=1e-7)
    body = uncertainty.concat_locally_uncertain_transforms(V, W, P, Q)[1]
    np.testing.assert_allclose(compose_covariance(exponential, w, v, Q, P), body, rtol=0, atol=1e-16)
