"""A robot arm by screws
=====================

Run ``python examples/arm.py [--figure FILE]``.

Three tasks for a UR5: forward kinematics and Jacobian as a product of exponentials; inverse kinematics by Gauss–Newton
along a path of poses; and the hand–eye problem A X = X B. The arm's lengths and screws are those of Lynch and Park,
Modern Robotics (Cambridge University Press, 2017), example 4.5. Exponential coordinates of a joint are its angle times
its screw.

.. image:: /figures/arm.svg
"""

# sphinx_gallery_thumbnail_path = 'reference/generated/thumbnail_arm.svg'

import argparse
from collections.abc import Sequence
from itertools import accumulate, pairwise

import numpy as np

from dualcay import exponential as chart
from dualcay import matrix6

H1, H2, W1, W2, L1, L2 = 0.089, 0.095, 0.109, 0.082, 0.425, 0.392  # m
DIRECTIONS = np.array([[0, 0, 1], [0, 1, 0], [0, 1, 0], [0, 1, 0], [0, 0, -1], [0, 1, 0]])
POINTS = np.array([[0, 0, 0], [0, 0, H1], [L1, 0, H1], [L1 + L2, 0, H1], [L1 + L2, W1, 0], [L1 + L2, 0, H1 - H2]])
SCREWS = np.hstack([DIRECTIONS, np.cross(POINTS, DIRECTIONS)])  # unit lines in space at joint angles 0
HOME = chart.from_pose([[-1, 0, 0, L1 + L2], [0, 0, 1, W1 + W2], [0, 1, 0, H1 - H2], [0, 0, 0, 1.0]])
CORNERS = [(0, [0, 0, 0]), (1, [0, 0, H1]), (1, [0, W1, H1]), (2, [L1, W1, H1]), (3, [L1 + L2, W1, H1]),
           (4, [L1 + L2, W1, H1 - H2]), (6, [L1 + L2, W1 + W2, H1 - H2])]  # link and point, to draw  # fmt: skip
TURN = np.array([0, 0, 1.5, 0, 0, 0.2])  # of the tool in space: 1.5 rad about z, 0.2 m up
BOOK = np.array([[0, -1, 0, 0.095], [1, 0, 0, 0.109], [0, 0, 1, 0.988], [0, 0, 0, 1]])  # to a millimetre
TOLERANCE = 1e-12  # rad and m: some hundred roundings of poses of size 1


def links(joints: np.ndarray) -> list[np.ndarray]:
    """Return the motion of each link from its place at joint angles 0, shape (..., 6); the last is the tool's."""
    turns = np.moveaxis(joints[..., None] * SCREWS, -2, 0)
    return list(accumulate(turns, chart.compose, initial=0 * turns[0]))


def tool(joints: np.ndarray) -> np.ndarray:
    return chart.compose(links(joints)[-1], HOME)


def jacobian(joints: np.ndarray) -> np.ndarray:
    """Return the matrix from joint rates to the space twist of the tool: each joint's screw, moved by those before."""
    moved = [np.einsum("...ij,j", chart.adjoint(motion), screw) for motion, screw in zip(links(joints), SCREWS)]
    return np.stack(moved, axis=-1)


def inverse_kinematics(goal: np.ndarray, joints: np.ndarray) -> tuple[np.ndarray, list[float]]:
    """Return joint angles that place the tool at `goal`, from `joints` on, and the error before each iteration."""
    errors: list[float] = []
    for _ in range(20):
        error = chart.local(goal, tool(joints))
        errors.append(np.abs(error).max())
        if errors[-1] < TOLERANCE:
            return joints, errors
        joints = joints + np.linalg.lstsq(jacobian(joints), error)[0]
    raise ArithmeticError(f"no joint angles found for the pose {goal} in 20 iterations; the error is {errors[-1]:.1e}")


def path(joints: np.ndarray, count: int) -> tuple[np.ndarray, list[list[float]]]:
    """Return joint angles while the tool moves by TURN, and the errors of Gauss–Newton at each pose."""
    found, errors = [joints], []
    for _ in range(count):
        goal = chart.retract(tool(joints), TURN / count)
        joints, history = inverse_kinematics(goal, joints)
        found, errors = [*found, joints], [*errors, history]
    return np.array(found), errors


def hand_eye(A: np.ndarray, B: np.ndarray) -> tuple[np.ndarray, np.ndarray, list[float]]:
    """Return X with A X = X B by least squares for motions (count, 6), the Jacobian, and the size of each step.

    The residual r is the step from X B to A X. As X becomes exp(δ) X, r changes by T(r)⁻¹ Ad(A) δ − T(r)⁻ᵀ δ.
    """
    X, sizes = chart.identity(), []
    for _ in range(30):
        residual = chart.local(chart.compose(A, X), chart.compose(X, B))
        left, right = matrix6(chart.tangent_inv(residual)), matrix6(chart.body_tangent_inv(residual))
        slope = (left @ chart.adjoint(A) - right).reshape(-1, 6)
        step = np.linalg.lstsq(slope, -residual.ravel())[0]
        X, sizes = chart.retract(X, step), [*sizes, np.abs(step).max()]
        if sizes[-1] < TOLERANCE:
            return X, slope, sizes
    raise ArithmeticError(f"no X found in 30 iterations; the last step is {sizes[-1]:.1e}")


def main(argv: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description="A robot arm by screws")
    parser.add_argument("--poses", type=int, default=40, help="number of poses on the path, and of hand motions")
    parser.add_argument("--figure", help="file for the picture")
    options, rng = parser.parse_args(argv), np.random.default_rng(0)
    upright = chart.pose(tool(np.array([0, -1, 0, 0, 1, 0]) * np.pi / 2))
    print("tool at joint angles (0, −90, 0, 0, 90, 0)°:", *upright[:3, 3].round(3), "m; in the book", *BOOK[:3, 3])
    assert np.abs(upright - BOOK).max() < 5.001e-4
    joints, errors = path(np.array([0.2, -1.2, 1.5, -0.5, 0.8, 0.3]), options.poses)
    print(f"path of {options.poses} poses: {np.mean([len(e) - 1 for e in errors]):.1f} iterations each")
    histories = {"inverse kinematics": inverse_kinematics(chart.retract(tool(joints[0]), TURN / 2), joints[0])[1]}
    print("half of the path in one go, errors:", *(f"{e:.0e}" for e in histories["inverse kinematics"]))
    assert all(after < 100 * before**2 + TOLERANCE for before, after in pairwise(histories["inverse kinematics"]))
    truth, hands = chart.random(rng=rng, max_angle=2.0), tool(rng.uniform(-2, 2, (options.poses + 1, 6)))
    A = chart.compose(hands[1:], chart.inverse(hands[:-1]))
    B = chart.compose(chart.inverse(truth), chart.compose(A, truth))
    for label, sigma in (("exact", 0.0), ("noisy", 1e-3)):  # rad and m
        X, slope, steps = hand_eye(chart.retract(A, sigma * rng.normal(size=A.shape)), B)
        error, deviation = np.abs(chart.local(X, truth)), sigma * np.sqrt(np.diag(np.linalg.inv(slope.T @ slope)))
        histories[f"hand–eye, {label}"] = steps
        print(f"hand–eye, {label}: {len(steps)} iterations, error {max(error):.0e}, deviation {max(deviation):.0e}")
        assert np.all(error < 4 * deviation + TOLERANCE)
        assert len(steps) <= 8
    if options.figure:
        from matplotlib.figure import Figure

        figure = Figure(figsize=(8.2, 4.5), layout="constrained")
        space, right = figure.add_subplot(1, 2, 1, projection="3d"), figure.add_subplot(1, 2, 2)
        for motions in map(links, joints[:: max(1, len(joints) // 5)]):
            space.plot(*np.transpose([chart.transform_point(motions[k], r) for k, r in CORNERS]), "C0o-", markersize=3)
        space.plot(*chart.pose(tool(joints))[:, :3, 3].T, "k:")
        space.set(xlabel="x (m)", ylabel="y (m)", title="tool turned by 1.5 rad, raised by 0.2 m", aspect="equal")
        space.locator_params(nbins=4)
        for label, history in histories.items():
            right.semilogy(history, "o-", label=label)
        right.set(xlabel="iteration of Gauss–Newton", ylabel="largest component, error or step (rad, m)")
        right.legend()
        figure.savefig(options.figure, metadata={"Date": None})


if __name__ == "__main__":
    main()
