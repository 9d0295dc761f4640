"""Arguments of rotation functions, and the tolerance between two programs of the same function."""

from __future__ import annotations

import math
from types import ModuleType

import numpy as np
from scipy.spatial.transform import Rotation

from derive.codegen.rows import Function

ROUNDINGS = 4096
"""Largest difference between two programs of one function, in roundings of the largest component. There are at most
a thousand operations; each changes the result by a few roundings, except near singular angles."""


def arguments(row: Function, module: ModuleType, shape: tuple[int, ...] = (5,)) -> list[np.ndarray]:
    """Return rotations for arguments that must be rotations, and random numbers for all others."""
    rng = np.random.default_rng(11)
    vectors = [module.random(shape, max_angle=2.5, rng=seed) for seed in (1, 2)]
    made = {"v": vectors[0], "v2": vectors[1], "v1": vectors[0], "v0": vectors[1], "R": module.tensor(vectors[0])}
    axes = Rotation.random(math.prod(shape), rng=rng).as_quat()[..., :3].reshape(*shape, 3)
    made |= {"q": module.quaternion(vectors[0]), "u": axes}
    return [made[a.name] if a.name in made else rng.uniform(-1, 1, (*shape, *a.shape)) for a in row.arguments]
