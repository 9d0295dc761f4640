"""Inverse maps, screws, shadows and composition at given numbers: flat components in, flat components out."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from ...algebra import Dual, Quaternion, Tensor, Vector
from ...algebra.functions import atan
from ...maps.closed_forms import quaternion_from_vector
from ...maps.inverse import axis, principal, shadow, vector_from_quaternion, vector_from_screw, vector_from_tensor
from ...maps.pose import Pose, Screw, pose_from_tensor, quaternion_from_screw, tensor_from_pose, tensor_from_screw
from .screws import covering, finite

Flat = tuple[Any, ...]

SMALL = 2.0**-8
"""Small components of a quaternion: a row of the rotation's matrix that belongs to one has lost two bytes."""

NEAR_POLE = 0.1
"""Cosine of half the angle of v below which a branch is left out: rounding of the principal v grows by its inverse."""

MAX_BRANCHES = 8


def _from_quaternion(n: int, branch: int, q: Flat) -> Flat:
    return _flat(vector_from_quaternion(n, Quaternion.dual(q[:4], q[4:]), branch))


def _from_tensor(n: int, branch: int, tensor: Flat) -> Flat:
    re, du = map(Tensor.from_entries, (tensor[:9], tensor[9:]))
    return _flat(vector_from_tensor(n, Tensor.dual(re, du), branch))


def _from_pose(n: int, branch: int, pose: Flat) -> Flat:
    rotation = Tensor.from_entries((*pose[0:3], *pose[4:7], *pose[8:11]))
    displacement = Vector(pose[3], pose[7], pose[11])
    return _flat(vector_from_tensor(n, tensor_from_pose(Pose(rotation, displacement)), branch))


def _from_screw(n: int, branch: int, angle: Flat, line: Flat) -> Flat:
    return _flat(vector_from_screw(n, Screw(Dual(*angle), _dual(line)), branch))


def _to_screw(n: int, branch: int, v: Flat) -> Flat:
    u, r = axis(n, principal(n, _dual(v)))
    angle = 2 * n * atan(r)
    return (angle.re, angle.du, *_flat(u))


def _shadow(n: int, branch: int, v: Flat) -> Flat:
    return _flat(shadow(n, _dual(v), branch))


def _principal(n: int, branch: int, v: Flat) -> Flat:
    return _flat(principal(n, _dual(v)))


def _compose(n: int, branch: int, v2: Flat, v1: Flat) -> Flat:
    product = quaternion_from_vector(n, _dual(v2)) * quaternion_from_vector(n, _dual(v1))
    return _flat(vector_from_quaternion(n, product))


MAPS: Mapping[str, Callable[..., Flat]] = {
    "from_quaternion": _from_quaternion,
    "from_tensor": _from_tensor,
    "from_pose": _from_pose,
    "from_screw": _from_screw,
    "to_screw": _to_screw,
    "shadow": _shadow,
    "principal": _principal,
    "compose": _compose,
}
"""By kernel function: its value for an order, a branch and arguments."""


def seeded_arguments(
    n: int, draw: random.Random, nearby: Callable[[Any], Any]
) -> Iterator[tuple[str, int | None, tuple[Flat, ...]]]:
    """Function, branch and arguments at seeded screws; v, angles and lines are numbers that ``nearby`` returns."""

    def short(values: Flat) -> Flat:
        return tuple(map(nearby, values))

    screws = list(covering(draw, SMALL))
    for screw, other in zip(screws, [*screws[1:], screws[0]], strict=True):
        v, v2 = (short(_flat(vector_from_screw(n, s))) for s in (screw, other))
        yield "from_screw", None, (short((screw.angle.re, screw.angle.du)), short(_flat(screw.axis)))
        yield "to_screw", None, (v,)
        yield "principal", None, (v,)
        yield "compose", None, (v2, v)
        yield from _on_branch(n, screw, 0, v)
    for branch in range(1, min(n, MAX_BRANCHES)):
        screw = next(s for s in screws[branch % len(screws) :] + screws if finite(n, s, branch, NEAR_POLE))
        v, v_k = (short(_flat(vector_from_screw(n, screw, k))) for k in (0, branch))
        yield from _on_branch(n, screw, branch, v)
        for name, k in (("principal", None), ("to_screw", None), ("shadow", n - branch)):
            yield name, k, (v_k,)


def _on_branch(n: int, screw: Screw, k: int, v: Flat) -> Iterator[tuple[str, int | None, tuple[Flat, ...]]]:
    q, R = quaternion_from_screw(screw), tensor_from_screw(screw)
    pose = pose_from_tensor(R)
    Q, rho = pose.rotation, tuple(pose.displacement)
    rows = (entry for i in range(3) for entry in (Q[i, 0], Q[i, 1], Q[i, 2], rho[i]))
    yield "from_quaternion", k, ((*q.re, *q.du),)
    yield "from_quaternion", k, (tuple(-c for c in (*q.re, *q.du)),)
    yield "from_tensor", k, ((*R.re, *R.du),)
    yield "from_pose", k, ((*rows, 0, 0, 0, 1),)
    yield "shadow", k, (v,)


def _dual(components: Flat) -> Vector:
    return Vector.dual(components[:3], components[3:])


def _flat(v: Vector) -> Flat:
    return (*v.re, *v.du)
