"""Control poses of splines through poses or near them, by Newton's method with sparse Jacobians."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from scipy.sparse import csc_matrix  # type: ignore[import, unused-ignore]
from scipy.sparse.linalg import splu  # type: ignore[import, unused-ignore]

from ._curve import Curve, Group, around, clamped
from ._factors import carried, inverse
from ._kernel import Array

ITERATIONS = 50
"""Largest number of steps; five are usual."""

TOLERANCE = 1e-9
"""Largest change in the last step, relative to the distance of poses: Newton's next error is about its square."""

LARGEST_TURN = 2.0
"""Largest rotation of a control pose in one step (rad)."""

HALVINGS = 20
"""Largest number of times that a step is halved because the equations are met worse after it."""

LOST = "no curve found: its control poses would be too far apart; add poses between, or take a chart of larger angles"

Rows = tuple[Array, Array, Array]
"""Equations: the unknown control poses (n, 4) of each, its derivatives (n, size, 4 size), and its value (n, size)."""


def interpolating(group: Group, t: Array, poses: Array, boundary: str, twists: Array | None) -> Curve:
    """Return the curve through the poses."""
    count, size = len(t) - 1, group.size
    if boundary == "periodic":
        closing = group.vector(group.between(poses[0], poses[-1]))
        if not np.linalg.norm(closing) <= 1e-6 * (1 + abs(poses).max()):
            raise ValueError(f"the last pose of a closed curve must be the first, got another in row {count}")
        unknown = np.arange(-1, count + 2) % count
        start = Curve(group, around(t), poses[unknown], group.steps(poses[unknown]))
        return _solved(start, unknown, t[:-1], poses[:-1], np.ones((count, size)))
    order, goal = 2 if boundary == "natural" else 1, np.zeros((2, size))
    if twists is not None:
        ends = [*np.moveaxis(poses[[0, -1], :3], 0, -1)]
        goal = np.stack(carried(inverse(ends), [*twists.T]), axis=-1)
    start = _near(group, clamped(t), t, poses)
    return _solved(start, np.arange(len(t) + 2), t, poses, np.ones((len(t), size)), order, goal)


def fitted(group: Group, breaks: Array, t: Array, poses: Array, weights: Array) -> Curve:
    """Return the curve whose weighted distance from the poses is least."""
    outside = np.flatnonzero((t < breaks[0]) | (t > breaks[-1]))
    if outside.size:
        raise ValueError(f"t must be within the knots [{breaks[0]:g}, {breaks[-1]:g}], got row {outside[0]} outside")
    knots = clamped(breaks)
    _require_data(knots, t[weights.reshape(len(t), -1).all(axis=-1)])
    roots = np.broadcast_to(np.sqrt(weights).reshape(len(t), -1), (len(t), group.size))
    return _solved(_near(group, knots, t, poses), np.arange(len(breaks) + 2), t, poses, roots)


def _require_data(knots: Array, t: Array) -> None:
    """Raise ValueError unless each control pose has a time of its own within its knots; an end is within."""
    place, t = 0, np.clip(t, np.nextafter(knots[0], np.inf), np.nextafter(knots[-1], -np.inf))
    for begin, end in zip(knots[:-4], knots[4:]):
        place = max(place, int(np.searchsorted(t, begin, side="right")))
        if place == len(t) or t[place] >= end:
            raise ValueError(f"fit needs more poses between t = {begin:g} and {end:g}, or fewer knots")
        place += 1


def _near(group: Group, knots: Array, t: Array, poses: Array) -> Curve:
    """Return a curve whose control poses are those at their times, on screws from pose to pose."""
    times = np.clip((knots[1:-3] + knots[2:-2] + knots[3:-1]) / 3, t[0], t[-1])
    row = np.clip(np.searchsorted(t, times, side="right") - 1, 0, len(t) - 2)
    part = (times - t[row]) / (t[row + 1] - t[row])
    step = group.vector(group.between(poses[row], poses[row + 1]))
    controls = poses[row] @ group.matrix(part[:, None] * step)
    return Curve(group, knots, controls, group.steps(controls))


def _solved(
    curve: Curve, unknown: Array, t: Array, poses: Array, roots: Array, order: int = 0, goal: Array | None = None
) -> Curve:
    """Return the curve nearest to the poses, with derivatives of an order at its ends.

    ``unknown`` are numbers of the control poses; equal ones move alike.
    """
    group, far = curve.group, abs(poses[..., :3, -1]).max(initial=0)
    apart = abs(group.between(poses[:-1], poses[1:])[..., :3, -1]).max(initial=0)
    allowed = TOLERANCE * np.repeat([1.0, apart + far / 1000], 3)[: group.size]

    def equations(curve: Curve) -> tuple[csc_matrix, Array]:
        rows = [_distances(curve, t, poses, roots)]
        if goal is not None:
            rows.append(_ends(curve, order, goal))
        return _sparse([(unknown[index], by_step, value) for index, by_step, value in rows])

    J, value = equations(curve)
    for _ in range(ITERATIONS):
        change = _step(J, value).reshape(-1, group.size)
        settled = (abs(change) <= allowed).all()
        change *= LARGEST_TURN / max(LARGEST_TURN, np.linalg.norm(change[:, :3], axis=-1).max())
        for _ in range(HALVINGS):
            controls = curve.controls @ group.matrix(group.module.from_exponential(change))[unknown]
            later = replace(curve, controls=controls, steps=group.steps(controls, curve.steps))
            J, others = equations(later)
            if settled:
                return later
            if others @ others <= (1 + TOLERANCE) * (value @ value):
                break
            change = change / 2
        else:
            break
        curve, value = later, others
    raise ArithmeticError(LOST)


def _step(J: Any, value: Array) -> Array:
    """Return the step to the zero of as many equations as unknowns, or to the least square of more equations."""
    if J.shape[0] > J.shape[1]:
        J, value = (J.T @ J).tocsc(), J.T @ value
    try:
        return np.asarray(-splu(J).solve(value))
    except (RuntimeError, ValueError) as error:  # singular, or not finite
        raise ArithmeticError(LOST) from error


def _distances(curve: Curve, t: Array, poses: Array, roots: Array) -> Rows:
    """Return the weighted body steps from the poses to the curve."""
    group, module = curve.group, curve.group.module
    apart = group.vector(group.between(poses, curve.values("pose", t)))
    index, by_control = curve.variations(t, 0)
    by_step = group.operator(module.body_tangent_inv(apart)) @ by_control
    roots = roots * module.body_tangent(module.identity()).flat[0]
    return index, roots[..., None] * by_step, roots * apart


def _ends(curve: Curve, order: int, goal: Array) -> Rows:
    """Return the differences of twist or acceleration from the goal at both ends, times powers of the spans."""
    ends, lengths = curve.breaks[[0, -1]], np.diff(curve.breaks)[[0, -1], None] ** order
    index, _, *by_control = curve.jacobians(ends)
    by_step = by_control[order - 1].swapaxes(1, 2).reshape(2, curve.group.size, -1)
    value = lengths * (curve.values(("body_twist", "body_acceleration")[order - 1], ends) - goal)
    return index, lengths[..., None] * by_step, value


def _sparse(rows: list[Rows]) -> tuple[csc_matrix, Array]:
    """Return the sparse matrix and the values of all equations."""
    index, blocks, values = (np.concatenate(parts) for parts in zip(*rows))
    size = values.shape[1]
    columns = (index[:, :, None] * size + np.arange(size)).reshape(len(index), 1, 4 * size)
    places = np.broadcast_to(np.arange(values.size).reshape(-1, size, 1), blocks.shape)
    matrix = csc_matrix((blocks.ravel(), (places.ravel(), np.broadcast_to(columns, blocks.shape).ravel())))
    return matrix, values.ravel()
