"""Inverse maps, screws, shadows and composition at given numbers: flat components in, flat components out."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache
from typing import Any

import mpmath

from ...algebra import Dual, Quaternion, Tensor, Vector
from ...algebra.functions import atan2
from ...maps.exponential import quaternion_exponential
from ...maps.inverse import polar
from ...maps.pose import Pose, Screw, pose_from_tensor, quaternion_from_screw, tensor_from_pose, tensor_from_screw
from ...maps.sign_tests import orientation
from .exact import matrix6
from .screws import covering
from .vectors import Vectors

Flat = tuple[Any, ...]

SMALL = 2.0**-8
"""Small components of a quaternion: a row of the rotation's matrix that belongs to one has lost two bytes."""

ORDINARY = 4
"""Screws first in a cover, near no selection: derivatives, which take many values, are seeded at these."""

NEAR_EDGE = 0.1
"""What `Vectors.finite` asks of a branch here: rounding of the principal v grows by its inverse."""


def _from_quaternion(chart: Vectors, branch: int, q: Flat) -> Flat:
    return flat(chart.of_quaternion(Quaternion.dual(q[:4], q[4:]), branch))


def _from_tensor(chart: Vectors, branch: int, tensor: Flat) -> Flat:
    re, du = map(Tensor.from_entries, (tensor[:9], tensor[9:]))
    return flat(chart.of_tensor(Tensor.dual(re, du), branch))


def _from_pose(chart: Vectors, branch: int, pose: Flat) -> Flat:
    rotation = Tensor.from_entries((*pose[0:3], *pose[4:7], *pose[8:11]))
    displacement = Vector(pose[3], pose[7], pose[11])
    return flat(chart.of_tensor(tensor_from_pose(Pose(rotation, displacement)), branch))


def _from_screw(chart: Vectors, branch: int, angle: Flat, line: Flat) -> Flat:
    return flat(chart.at(Screw(Dual(*angle), _dual(line)), branch))


def _to_screw(chart: Vectors, branch: int, v: Flat) -> Flat:
    screw, _ = chart.screw(_dual(v))
    return (screw.angle.re, screw.angle.du, *flat(screw.axis))


def _angle(chart: Vectors, branch: int, v: Flat) -> Flat:
    length, _ = polar(_dual(v))
    angle = chart.angle(length)
    return angle.re, angle.du


def _to_exponential(chart: Vectors, branch: int, v: Flat) -> Flat:
    length, u = polar(_dual(v))
    return flat(u * chart.angle(length))


def _from_exponential(chart: Vectors, branch: int, w: Flat) -> Flat:
    angle, u = polar(_dual(w))
    return flat(u * chart.size(reached(chart, angle)))


def reached(chart: Vectors, angle: Dual) -> Dual:
    """The angle, less whole turns while it is beyond the edge."""
    while angle.re > chart.edge:
        angle = angle - 2 * mpmath.pi
    return angle


def _shadow(chart: Vectors, branch: int, v: Flat) -> Flat:
    return flat(chart.shadow(_dual(v), branch))


def _principal(chart: Vectors, branch: int, v: Flat) -> Flat:
    screw, _ = chart.screw(_dual(v))
    return flat(chart.at(screw))


def _compose(chart: Vectors, branch: int, v2: Flat, v1: Flat) -> Flat:
    return flat(chart.of_quaternion(chart.quaternion(_dual(v2)) * chart.quaternion(_dual(v1))))


def _between(chart: Vectors, branch: int, v2: Flat, v1: Flat) -> Flat:
    if v2 == v1:
        return (mpmath.mpf(0),) * 6
    return flat(chart.of_quaternion(chart.quaternion(_dual(v1)).conjugate() * chart.quaternion(_dual(v2))))


def _retract(body: bool) -> Callable[..., Flat]:
    """R(v) with exp(δ) on one side, on the branch whose angle is nearest that of v along the new axis."""

    def retracted(chart: Vectors, branch: int, v: Flat, delta: Flat) -> Flat:
        small, here = _turning(mpmath.mp.prec, *delta), chart.quaternion(_dual(v))
        q = here * small if body else small * here
        (length, u), (own, axis) = polar(q.vector), polar(_dual(v))
        angle = 2 * atan2(length, q.scalar)
        along = chart.angle(own.re) * axis.re.dot(u.re)
        turns = mpmath.nint((along - angle.re) / (2 * mpmath.pi))
        return flat(chart.at(Screw(angle + 2 * mpmath.pi * turns, u)))

    return retracted


@lru_cache(maxsize=16)  # most quotients of differences move another argument
def _turning(precision: int, *delta: Any) -> Quaternion:
    """exp(δ/2) in the working precision, which is named for what is kept."""
    return quaternion_exponential(_dual(delta) / 2)


def _interpolate(chart: Vectors, branch: int, v1: Flat, v2: Flat, t: Flat) -> Flat:
    """exp(t δ) R(v1): with the sign of sin(α/2) that v1 has, or about its own axis as the angle goes."""
    if v1 == v2:
        return v1
    first, second = chart.quaternion(_dual(v1)), chart.quaternion(_dual(v2))
    way = second * first.conjugate()
    way = way * orientation(way.scalar.re)
    length, axis = polar(way.vector)
    delta = axis * (2 * atan2(length, way.scalar))
    (extent, own), moved = polar(_dual(v1)), quaternion_exponential(delta * t[0] / 2) * first
    before = chart.angle(extent.re)
    size, u = polar(moved.vector)
    if delta.re.cross(own.re).magnitude() < mpmath.eps ** mpmath.mpf("0.8") and extent.re:
        side = orientation(moved.vector.re.dot(own.re))
        gone, turn = before + t[0] * delta.re.dot(own.re), 4
    else:
        side = orientation(first.vector.re.dot(own.re))
        gone, turn = 2 * mpmath.pi * mpmath.floor(before / (2 * mpmath.pi)) + mpmath.pi, 2
    angle = 2 * atan2(size, moved.scalar * side) if turn == 2 else 2 * atan2(size * side, moved.scalar)
    turns = mpmath.nint((gone - angle.re) / (turn * mpmath.pi))
    return flat(chart.at(Screw(angle + turn * turns * mpmath.pi, u * side)))


def _local(body: bool) -> Callable[..., Flat]:
    """δ = α u of what leads from v1 to v2."""

    def logarithm(chart: Vectors, branch: int, v2: Flat, v1: Flat) -> Flat:
        if v2 == v1:
            return (mpmath.mpf(0),) * 6
        later, sooner = chart.quaternion(_dual(v2)), chart.quaternion(_dual(v1)).conjugate()
        q = sooner * later if body else later * sooner
        q = q * orientation(q.scalar.re)
        length, u = polar(q.vector)
        return flat(u * (2 * atan2(length, q.scalar)))

    return logarithm


def _jacobians(function: Callable[..., Flat]) -> Callable[..., Flat]:
    """The derivatives of a function of dual vectors by each of its arguments, as quotients of small differences."""

    def quotients(chart: Vectors, branch: int, *arguments: Flat) -> Flat:
        with mpmath.workprec(2 * mpmath.mp.prec):
            step = mpmath.mpf(2) ** (-mpmath.mp.prec // 2)
            start = function(chart, branch, *arguments)
            found: list[Any] = []
            for place, argument in enumerate(arguments):
                columns = []
                for j in range(3):
                    moved = (*argument[:j], argument[j] + step, *argument[j + 1 :])
                    there = function(chart, branch, *arguments[:place], moved, *arguments[place + 1 :])
                    columns.append(_dual(tuple((b - a) / step for a, b in zip(start, there, strict=True))))
                found += matrix6(columns)
        return tuple(+entry for entry in found)

    return quotients


def _shadow_jacobian(chart: Vectors, branch: int, v: Flat) -> Flat:
    """Of no branch exactly I."""
    if not branch:
        return matrix6([Vector(*row) for row in Tensor.identity().rows])
    return _jacobians(_shadow)(chart, branch, v)


MAPS: Mapping[str, Callable[..., Flat]] = {
    "from_quaternion": _from_quaternion,
    "from_tensor": _from_tensor,
    "from_pose": _from_pose,
    "from_screw": _from_screw,
    "to_screw": _to_screw,
    "angle": _angle,
    "to_exponential": _to_exponential,
    "from_exponential": _from_exponential,
    "shadow": _shadow,
    "principal": _principal,
    "compose": _compose,
    "between": _between,
    "retract": _retract(body=False),
    "body_retract": _retract(body=True),
    "interpolate": _interpolate,
    "local": _local(body=False),
    "body_local": _local(body=True),
    "compose_jacobians": _jacobians(_compose),
    "between_jacobians": _jacobians(_between),
    "shadow_jacobian": _shadow_jacobian,
    "retract_jacobians": _jacobians(_retract(body=False)),
    "body_retract_jacobians": _jacobians(_retract(body=True)),
}
"""By kernel function: its value for a chart, a branch and arguments."""


def seeded_arguments(
    chart: Vectors, draw: random.Random, nearby: Callable[[Any], Any]
) -> Iterator[tuple[str, int | None, tuple[Flat, ...]]]:
    """Function, branch and arguments at seeded screws; v, angles and lines are numbers that ``nearby`` returns."""

    def short(values: Flat) -> Flat:
        return tuple(map(nearby, values))

    screws = list(covering(draw, SMALL))
    for screw, other in zip(screws, [*screws[1:], screws[0]], strict=True):
        v, v2 = (short(flat(chart.at(s))) for s in (screw, other))
        yield "from_screw", None, (short((screw.angle.re, screw.angle.du)), short(flat(screw.axis)))
        for name in ("to_screw", "angle", "to_exponential", "principal"):
            yield name, None, (v,)
        yield "from_exponential", None, (short(flat(screw.axis * screw.angle)),)
        for name in ("compose", "between", "local", "body_local"):
            yield name, None, (v2, v)
        yield "interpolate", None, (v, v2, (nearby(draw.uniform(0, 1)),))
        delta = tuple(nearby(draw.uniform(-1, 1)) for _ in range(6))
        for name in ("retract", "body_retract"):
            yield name, None, (v, delta)
        if screw in screws[:ORDINARY]:
            for name in ("compose", "between"):
                yield f"{name}_jacobians", None, (v2, v)
            for name in ("retract", "body_retract"):
                yield f"{name}_jacobians", None, (v, delta)
        yield from _on_branch(screw, 0, v)
    for branch in chart.tried[1:]:
        turned = screws[branch % len(screws) :] + screws
        reached = [s for s in turned if chart.finite(s, branch, NEAR_EDGE)]
        if not reached:  # of this φ no vector is so many turns on
            continue
        screw = reached[0]
        v, v_k = (short(flat(chart.at(screw, k))) for k in (0, branch))
        yield from _on_branch(screw, branch, v)
        for name, k in (("principal", None), ("to_screw", None), ("angle", None), ("shadow", chart.back(branch))):
            yield name, k, (v_k,)
        yield "to_exponential", None, (v_k,)


def _on_branch(screw: Screw, k: int, v: Flat) -> Iterator[tuple[str, int | None, tuple[Flat, ...]]]:
    q, R = quaternion_from_screw(screw), tensor_from_screw(screw)
    pose = pose_from_tensor(R)
    Q, rho = pose.rotation, tuple(pose.displacement)
    rows = (entry for i in range(3) for entry in (Q[i, 0], Q[i, 1], Q[i, 2], rho[i]))
    yield "from_quaternion", k, ((*q.re, *q.du),)
    yield "from_quaternion", k, (tuple(-c for c in (*q.re, *q.du)),)
    yield "from_tensor", k, ((*R.re, *R.du),)
    yield "from_pose", k, ((*rows, 0, 0, 0, 1),)
    for name in ("shadow", "shadow_jacobian"):
        yield name, k, (v,)


def _dual(components: Flat) -> Vector:
    return Vector.dual(components[:3], components[3:])


def flat(v: Vector) -> Flat:
    """The six components."""
    return (*v.re, *v.du)
