"""Arguments and results of the kernel functions as flat arrays, for languages that pass pointers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Array:
    """A named array of components; ``parts`` are the sizes of its real part, its dual part and so on, in order."""

    name: str
    parts: tuple[int, ...]

    @property
    def size(self) -> int:
        """How many components."""
        return sum(self.parts)

    @property
    def part_of(self) -> tuple[int, ...]:
        """Which part each component belongs to."""
        return tuple(part for part, size in enumerate(self.parts) for _ in range(size))


@dataclass(frozen=True, slots=True)
class Signature:
    """A kernel function: arrays in, whether a branch is chosen, arrays out."""

    arguments: tuple[Array, ...]
    results: tuple[Array, ...]
    branch: bool = False


def _dual(name: str) -> Array:
    return Array(name, (3, 3))


V, OMEGA, V_DOT, LINE, SHADOW = map(_dual, ("v", "omega", "v_dot", "line", "v_k"))
QUATERNION = Array("q", (4, 4))
TENSOR, TANGENT = (Array(name, (9, 9)) for name in ("tensor", "tangent"))
POSE = Array("pose", (3, 1, 3, 1, 3, 1, 4))
ANGLE = Array("angle", (1, 1))

SIGNATURES: Mapping[str, Signature] = {
    "quaternion": Signature((V,), (QUATERNION,)),
    "tensor": Signature((V,), (TENSOR,)),
    "pose": Signature((V,), (POSE,)),
    "transform_point": Signature((V, Array("r", (3,))), (Array("moved", (3,)),)),
    "transform_line": Signature((V, LINE), (_dual("moved"),)),
    "tangent": Signature((V,), (TANGENT,)),
    "tangent_inv": Signature((V,), (TANGENT,)),
    "twist": Signature((V, V_DOT), (OMEGA,)),
    "rate": Signature((V, OMEGA), (V_DOT,)),
    "body_twist": Signature((V, V_DOT), (OMEGA,)),
    "body_rate": Signature((V, OMEGA), (V_DOT,)),
    "from_quaternion": Signature((QUATERNION,), (V,), branch=True),
    "from_tensor": Signature((TENSOR,), (V,), branch=True),
    "from_pose": Signature((POSE,), (V,), branch=True),
    "from_screw": Signature((ANGLE, LINE), (V,)),
    "to_screw": Signature((V,), (ANGLE, LINE)),
    "shadow": Signature((V,), (SHADOW,), branch=True),
    "principal": Signature((V,), (SHADOW,)),
    "compose": Signature((_dual("v2"), _dual("v1")), (V,)),
}
"""Every function of a kernel module that takes arrays, in the order of the recipes they are made by."""
