"""Cases of run-time parts of the NumPy target: motions, branches of sequences, multiples and other libraries.

Expected poses come from the matrix exponential, by its series. Expected branches and switches come from the rotation
angle of a motion about a fixed axis.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import pi, tan
from typing import Any

import numpy as np

from ..signatures import POSES, ROTATIONS
from .runtime import FAR, NEAR, RATES, Array, Case, Loaded, differences

AXIS = np.array([0.36, 0.48, 0.8])
SCREW, OTHER = np.array([*AXIS, 0.4, -0.2, 0.6]), np.array([*AXIS, -0.3, 0.5, 0.2])
"""Twists of 1 rad/s about parallel axes: a motion has the twist (1 + t²/10) SCREW, and OTHER gives its start."""

STARTS = {("lie", "space"): 0.6, ("lie", "body"): 4.0, ("chart", "space"): 5.0, ("chart", "body"): 0.6}
"""Rotation angle at t = 0 by method and frame: below π, beyond π, and beyond the limit where v changes its branch."""

LIMIT = 3 * pi / 2  # angle where v changes its branch in a chart whose first singular angle is 2π
TIMES = np.linspace(0, 4.4, 5)
DELAY = 2.0**-12
SPREAD, NOISE = np.diag([1.0, 2, 3, 4, 5, 6]) + 0.5, np.diag([0.3, 0.1, 0.2, 0.4, 0.2, 0.1]) + 0.05

FACTOR = Fraction(3, 2)  # factor of a multiple of the chart, which needs a multiplication and a division
MULTIPLES = (
    "quaternion", "pose", "transform_line", "twist", "rate", "twist_dot", "rate_dot", "transition", "from_quaternion",
    "from_pose", "from_screw", "to_screw", "angle", "to_exponential", "from_exponential", "shadow", "shadow_jacobian",
    "principal", "compose", "between", "local", "retract", "interpolate",
)  # fmt: skip
"""Functions that together call the scalar programs of a multiple."""


def exponential(screw: Array, times: Any = 1.0) -> Array:
    """Return the matrix exponential of a twist times numbers, by its series at a 1024th and ten squarings."""
    small = np.multiply.outer(times, hat(screw)) / 1024
    found = term = np.broadcast_to(np.eye(4), small.shape)
    for k in range(1, 9):
        term = term @ small / k
        found = found + term
    for _ in range(10):
        found = found @ found
    return np.asarray(found)


def hat(screw: Array) -> Array:
    """Return the 4x4 matrix of a twist."""
    matrix = np.zeros((4, 4))
    matrix[:3, :3], matrix[:3, 3] = np.cross(np.eye(3), screw[:3]), screw[3:]
    return matrix


def adjoint(pose: Array) -> Array:
    """Return the matrix that moves twists, from X hat(e) X⁻¹ of the unit twists e."""
    moved = (pose @ hat(unit) @ np.linalg.inv(pose) for unit in np.eye(6))
    return np.array([[m[2, 1], m[0, 2], m[1, 0], *m[:3, 3]] for m in moved]).T


def twist(t: float) -> Array:
    return (1 + t**2 / 10) * SCREW


@dataclass(frozen=True)
class Turning:
    """Motion with the twist (1 + t²/10) SCREW in a frame, from a pose with a rotation about the same axis."""

    module: Any
    frame: str
    start: float

    def pose(self, t: float) -> Array:
        moved, begun = exponential(SCREW, t + t**3 / 30), exponential(OTHER, self.start)
        return moved @ begun if self.frame == "space" else begun @ moved

    def angle(self, t: float) -> float:
        return self.start + t + t**3 / 30 - 2 * pi * int(np.sum(self.switches <= t))

    @property
    def switches(self) -> Array:
        """Return the times where t + t³/30 is the angle left to the limit; 0 for a start beyond it."""
        left = np.maximum(LIMIT - self.start + 2 * pi * np.arange(3), 0)
        times = np.array([max(np.roots([1 / 30, 0, 1, -angle]).real) for angle in left])
        return np.asarray(times[times <= TIMES[-1]])

    def vector(self, pose: Array, angle: float) -> Array:
        """Return the vector φ(angle) u of a pose."""
        turns = round(angle / (2 * pi))
        return np.asarray(self.module.from_pose(pose, turns if angle > 2 * pi * turns else -turns))

    def slope(self, pose: Array, angle: float) -> Array:
        """Return the derivative of v by a step that the twist keeps: at the right of the pose in the space frame."""

        def stepped(delta: Array) -> Array:
            steps = exponential(delta)
            return self.vector(pose @ steps if self.frame == "space" else steps @ pose, angle)

        return differences(stepped, np.zeros(6))

    def covariance(self, t: float) -> Array:
        """Return the covariance of v for SPREAD at t = 0 and NOISE, by 20 points of Gauss."""
        nodes, weights = np.polynomial.legendre.leggauss(20)
        poses = [self.pose(t * (1 + node) / 2) for node in nodes]
        moved = [adjoint(np.linalg.inv(pose) if self.frame == "space" else pose) for pose in poses]
        noise = sum(t / 2 * weight * A @ NOISE @ A.T for weight, A in zip(weights, moved, strict=True))
        back, J = np.linalg.inv(self.slope(self.pose(0), self.start)), self.slope(self.pose(t), self.angle(t))
        return np.asarray(J @ (back @ SPREAD @ back.T + noise) @ J.T)


def motion(at: Loaded) -> Iterator[Case]:
    """Cases of ``propagate``: poses, vectors, branches, switches, derivatives and covariances."""
    module, propagate = at.module(), at.part("_propagate").propagate
    for (method, frame), start in STARTS.items():
        case, turning = f"propagate, {method}, {frame}", Turning(module, frame, start)
        twists: Any = twist if start < 4 else np.array([twist(t) for t in TIMES])
        options = {"frame": frame, "method": method, "covariance": SPREAD, "noise": NOISE}
        found = propagate(module, turning.vector(turning.pose(0), start), twists, TIMES, **options)
        angles, poses = [turning.angle(t) for t in TIMES], np.array([turning.pose(t) for t in TIMES])
        vectors = [turning.vector(*both) for both in zip(poses, angles, strict=True)]
        yield f"{case}: poses", found.pose, poses
        yield f"{case}: switches", found.switches, turning.switches
        yield f"{case}: vectors", found.v, vectors
        yield f"{case}: real parts", found.v[:, :3], [tan(a / (2 * at.chart.order)) * AXIS for a in angles]
        yield f"{case}: branches", found.branch, [-int(a > pi) % at.chart.branches for a in angles]
        yield f"{case}: covariances", found.covariance, [turning.covariance(t) for t in TIMES]
        t = TIMES[1:-1]
        rate = module.rate if frame == "space" else module.body_rate
        before, after = ([turning.vector(turning.pose(s + h), turning.angle(s)) for s in t] for h in (-DELAY, DELAY))
        slopes = [rate(v, [twist(s + h) for s in t]) for v, h in ((before, -DELAY), (after, DELAY))]
        yield f"{case}: first derivatives", found(t, 1), np.subtract(after, before) / (2 * DELAY)
        yield f"{case}: second derivatives", found(t, 2), np.subtract(*slopes[::-1]) / (2 * DELAY)
        v0, moved = np.array(FAR) / 4, exponential(SCREW, 0.7)
        found, begun = propagate(module, v0, SCREW, [0, 0.7], frame=frame, method=method), module.pose(v0)
        yield f"{case}: any start", found.pose[-1], moved @ begun if frame == "space" else begun @ moved


def dual_quaternions(at: Loaded) -> Iterator[Case]:
    """Cases of the printed programs of dual quaternions, by kernels and products of matrices."""
    module, derived = at.module(), at.part("_derived")
    p, q = (module.quaternion(v) for v in (FAR, NEAR))
    rows = np.reshape(derived.pose_of(derived.product(p, q)), (3, 4))
    yield "product of dual quaternions", rows, (module.pose(FAR) @ module.pose(NEAR))[:3]
    multiple = [*(1.5 * q[:4]), *(1.5 * q[4:] + 0.25 * q[:4])]  # by 1.5 + 0.25 ε
    yield "normalized dual quaternion", derived.normalized(np, multiple), q
    yield "tensor of a dual quaternion", np.reshape(derived.tensor_of(q), (2, 3, 3)), module.tensor(NEAR)


def branches(at: Loaded) -> Iterator[Case]:
    """Cases of ``unwrap`` and ``switch_event``, about a fixed axis."""
    switching, count, order = at.part("_switching"), at.chart.branches, at.chart.order
    for table in (POSES, ROTATIONS):
        module, n = at.module(table), 6 if table is POSES else 3
        event = switching.switch_event(module)
        values = [event(0.0, np.array([*(tan(angle / (2 * order)) * AXIS), 0, 0, 0])[:n]) for angle in (1.0, LIMIT)]
        yield f"switch_event of {n} components", values, [tan(0.5 / order) ** 2 - tan(LIMIT / 2 / order) ** 2, 0]
        angles = np.multiply.outer(np.sin(np.linspace(1, 8, 50)), [4.5, -4.0])
        angles[[0, 5, 9], [0, 0, 1]] = np.nan
        turns = np.rint(angles / (2 * pi))
        wanted, given = (np.tan(a / (2 * order))[..., None] * AXIS for a in (angles, angles - 2 * pi * turns))
        given[[1, 0], [0, 1]] = wanted[[1, 0], [0, 1]]  # the first ones
        branch = np.nan_to_num(np.where(angles < 2 * pi * turns, -turns, turns) % count)
        found, k = switching.unwrap(module, np.pad(given, ((0, 0), (0, 0), (0, n - 3))), branch=True)
        yield f"unwrap of {n} components: vectors", found[..., :3], wanted
        yield f"unwrap of {n} components: branches", k, branch


def multiples(at: Loaded) -> Iterator[Case]:
    """Cases of a multiple K v of the chart: arguments and results named v or v_… are K times those of the chart."""
    module, K = at.module(), float(FACTOR)
    factor = FACTOR.numerator, FACTOR.denominator
    chart = at.part("_multiple").multiple(module.CHART, module.__name__, *factor, constant=(), programs="")
    kernels = at.part("_interface").PoseKernels(chart)
    limit = K * np.array([*(tan(LIMIT / (2 * at.chart.order)) * AXIS), 0, 0, 0])
    event = at.part("_switching").switch_event(kernels)
    yield "switch_event of a multiple of the chart", [event(0.0, 0 * limit) < 0, event(0.0, limit)], [1, 0]
    angle, line = module.to_screw(NEAR)
    values = {
        "v": FAR, "v2": FAR, "v1": NEAR, "v0": NEAR, "v_dot": RATES[0], "v_ddot": RATES[1], "omega": RATES[0],
        "omega_dot": RATES[1], "line": line, "angle": angle, "w": RATES[0], "delta": RATES[0], "t": 0.3,
        "q": module.quaternion(FAR), "T": module.pose(FAR),
    }  # fmt: skip
    for name in MULTIPLES:
        row = POSES.functions[name]
        given = [np.array(values[array.name]) for array in row.arguments]
        scaled = [K * a if array.name.startswith("v") else a for a, array in zip(given, row.arguments, strict=True)]
        found, there = getattr(kernels, name)(*scaled), getattr(module, name)(*given)
        many = len(row.results) > 1
        pairs = zip(found, there, strict=True) if many else [(found, there)]
        for array, (one, other) in zip(row.results, pairs, strict=True):
            yield f"{name} of a multiple of the chart", one, K * other if array.name.startswith("v") else other


def other_libraries(at: Loaded) -> Iterator[Case]:
    """Cases of ``interop``: orders of twists, the Cayley map of 4x4 matrices, quaternions of ROS and SciPy."""
    module, interop, n, v = at.module(), at.part("interop"), at.chart.order, np.array(NEAR)
    omega, pose, q = np.array(RATES[0]), module.pose(NEAR), module.quaternion(NEAR)
    swapped = np.concatenate([omega[3:], omega[:3]])
    matrix = module.adjoint(v)
    yield "to_linear_angular", interop.to_linear_angular(omega), swapped
    yield "from_linear_angular", interop.from_linear_angular(swapped), omega
    turned = interop.to_linear_angular_matrix(matrix)
    yield "to_linear_angular_matrix", turned @ swapped, np.roll(matrix @ omega, 3)
    yield "from_linear_angular_matrix", interop.from_linear_angular_matrix(turned), matrix
    for scale in (1.0, 2.0 * n):
        vector = interop.to_cayley_4x4(scale * v, scale)
        A, one = hat(vector) / scale, np.eye(4)
        yield f"to_cayley_4x4, scale {scale:g}", np.linalg.matrix_power(np.linalg.solve(one - A, one + A), n), pose
        yield f"from_cayley_4x4, scale {scale:g}", interop.from_cayley_4x4(vector, scale), scale * v
    xyz, xyzw = interop.to_ros(module, v)
    yield "to_ros: position", xyz, pose[:3, 3]
    yield "to_ros: orientation", xyzw, [*q[1:4], q[0]]
    yield "from_ros", interop.from_ros(module, pose[:3, 3], [*q[1:4], q[0]]), v
    for kind in interop.FIELDS:
        message = interop.to_ros_message(module, v, kind)
        numbers = [number for part in message.values() for number in part.values()]
        yield f"to_ros_message, {kind}", numbers, [*pose[:3, 3], *q[1:4], q[0]]
        yield f"from_ros_message, {kind}", interop.from_ros_message(module, message), v
    for name, size, wanted in (("rigid_transform", 8, v), ("rotation", 4, [*v[:3], 0, 0, 0])):
        there = getattr(interop, f"to_{name}")(module, v)
        yield f"to_{name}", there.components(scalar_first=True), q[:size]
        yield f"from_{name}", getattr(interop, f"from_{name}")(module, there), wanted


def random(at: Loaded) -> Iterator[Case]:
    """Cases of ``random``: bounds of angles and translations, and the mean trace 0 of uniform rotations."""
    module, rotations = at.module(), at.module(ROTATIONS)
    v = module.random(100, max_angle=1.0, max_translation=2.0, rng=1)
    sizes = np.linalg.norm([module.to_exponential(v)[:, :3], module.pose(v)[:, :3, 3]], axis=-1).max(axis=-1)
    turned = np.linalg.norm(rotations.to_exponential(rotations.random(100, max_angle=1.0, rng=1)), axis=-1).max()
    yield "random: bounds", [0.9 < size < 1 for size in (*sizes / (1, 2), turned)], [True] * 3
    traces = [np.trace(rotations.tensor(rotations.random(4000, rng=1)), axis1=-2, axis2=-1).mean()]
    traces += [np.trace(module.pose(module.random(4000, rng=1))[:, :3, :3], axis1=-2, axis2=-1).mean()]
    yield "random: mean traces near 0", [abs(trace) < 0.1 for trace in traces], [True] * 2


CHECKS = dual_quaternions, motion, branches, multiples, other_libraries, random
