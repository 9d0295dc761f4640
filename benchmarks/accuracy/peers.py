"""Exponential maps of rigid displacements in double precision, from this project and from optional libraries.

All maps share one convention: screws (N, 6) with the rotation first, homogeneous matrices (N, 4, 4), and left (space)
Jacobians (N, 6, 6) with rows and columns ordered like screws.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.peers import SWAP, versions

Map = Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Peer:
    """Maps of a library, None if missing. With `through_log`, the inverse Jacobian comes from log and ends at π."""

    name: str
    exp: Map
    log: Map
    jacobian: Map | None = None
    jacobian_inv: Map | None = None
    through_log: bool = False


def ours() -> Peer:
    """Return the maps of `dualcay.exponential`."""
    from dualcay import exponential

    def matrix(operator: Any) -> Map:
        def jacobian(screws: np.ndarray) -> np.ndarray:
            re, du = np.moveaxis(operator(screws), -3, 0)
            return np.block([[re, np.zeros_like(re)], [du, re]])

        return jacobian

    return Peer(
        "exponential", exponential.pose, exponential.from_pose, matrix(exponential.tangent),
        matrix(exponential.tangent_inv),
    )  # fmt: skip


def scipy() -> Peer:
    from scipy.spatial.transform import RigidTransform

    return Peer(
        "SciPy",
        lambda screws: RigidTransform.from_exp_coords(screws).as_matrix(),
        lambda poses: RigidTransform.from_matrix(poses).as_exp_coords(),
    )


def pytransform3d() -> Peer:
    from pytransform3d import trajectories, transformations

    def each(function: Any) -> Map:
        return lambda screws: np.stack([function(screw) for screw in screws])

    return Peer(
        "pytransform3d",
        trajectories.transforms_from_exponential_coordinates,
        trajectories.exponential_coordinates_from_transforms,
        each(transformations.left_jacobian_SE3),
        each(transformations.left_jacobian_SE3_inv),
    )


def jaxlie() -> Peer:
    import jax

    jax.config.update("jax_enable_x64", True)
    from jaxlie import SE3

    def exp(screws: np.ndarray) -> np.ndarray:
        return np.asarray(SE3.exp(screws[:, SWAP]).as_matrix())

    def log(poses: np.ndarray) -> np.ndarray:
        return np.asarray(SE3.from_matrix(poses).log())[:, SWAP]

    # The right (body) Jacobian of log at exp(−ξ) equals its left Jacobian at exp ξ.
    right = jax.jit(jax.vmap(lambda screw: SE3.exp(screw).jlog()))

    def jacobian_inv(screws: np.ndarray) -> np.ndarray:
        return np.asarray(right(-screws[:, SWAP]))[:, SWAP][:, :, SWAP]

    return Peer("jaxlie", exp, log, None, jacobian_inv, through_log=True)


def pinocchio() -> Peer:
    import pinocchio as pin

    def exp(screws: np.ndarray) -> np.ndarray:
        return np.stack([pin.exp6(screw[SWAP]).homogeneous for screw in screws])

    def log(poses: np.ndarray) -> np.ndarray:
        return np.stack([pin.log6(pose).vector[SWAP] for pose in poses])

    def jacobian(screws: np.ndarray) -> np.ndarray:
        return np.stack([pin.Jexp6(-screw[SWAP])[SWAP][:, SWAP] for screw in screws])

    def jacobian_inv(screws: np.ndarray) -> np.ndarray:
        return np.stack([pin.Jlog6(pin.exp6(-screw[SWAP]))[SWAP][:, SWAP] for screw in screws])

    return Peer("pinocchio", exp, log, jacobian, jacobian_inv, through_log=True)


MAKERS: dict[str, Callable[[], Peer]] = {
    "SciPy": scipy, "pytransform3d": pytransform3d, "jaxlie": jaxlie, "pinocchio": pinocchio,
}  # fmt: skip
"""Function that returns the peer, by name of the library."""


def installed() -> list[Peer]:
    return [MAKERS[name]() for name, version in versions(*MAKERS).items() if version]
