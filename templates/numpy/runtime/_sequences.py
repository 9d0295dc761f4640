"""Branches along a sequence of vectors: those that a row may take, and the cheapest way through them.

Arrays have rows in time T, columns B side by side, and up to K branches by row.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import pi
from typing import Any

import numpy as np

from ._kernel import Array

WINDOW = 5
"""A chart with at most this number of branches may take all of them; else the one that turns on, 0 and −1."""

ROUNDING = 16
"""Units of rounding that do not count as a difference."""


TOLERANCE = 2**15
"""Units of rounding by which a row may miss a whole turn. Products of 10³ matrices lose a tenth of them."""


@dataclass(frozen=True)
class Rows:
    """Vectors in rows and columns, shape (T, B, n), with the angle and the axis that `shadow` takes.

    Angle and axis are those of the principal vectors. Rows ``resting`` at whole turns have the axis ``known`` from a
    neighbour, directed as their own one, and the angle ``along`` it. Rows ``apart`` are near whole turns too, but off
    this axis by more than the tolerance. Rows that are not finite have the values of the row before.
    """

    v: Array
    principal: Array
    angle: Array
    axis: Array
    along: Array
    known: Array
    own: Array
    resting: Array
    apart: Array
    last: Array
    valid: Array
    tolerance: float


def continued(module: Any, v: Array, switch_angle: float, tolerance: float | None) -> tuple[Array, Array]:
    """Return the vectors that continue a sequence, and their branches k."""
    count, eps = module.CHART.branches, np.finfo(v.dtype).eps
    with np.errstate(all="ignore"):
        rows = folded(module, v, tolerance)
        branches, angles, vectors = candidates(module, rows)
        usual = len(branches)
        if rows.apart.any():  # pass such a row as if it had the axis of a neighbour
            passing = replace(rows, axis=rows.known, angle=rows.along, resting=rows.apart)
            others = candidates(module, passing)
            others[2][:, ~rows.apart] = np.nan
            branches, angles, vectors = (np.concatenate(both) for both in zip((branches, angles, vectors), others))
        between, price = costs(module, rows, branches, vectors, usual, switch_angle)
        own = (branches[:, 0] == modulo(rows.own[0], count)) & np.isfinite(vectors[:, 0, :, 0])
        within = abs(angles[:, 0]) <= switch_angle * (1 + ROUNDING * eps)
        path = cheapest(between, np.where(own, 0, np.where(within, price / 2, np.inf)))
    time, column = np.ogrid[: len(path), : path.shape[1]]
    passed = path >= usual
    found = np.where(passed[..., None], rows.principal, vectors[path, time, column])
    k = np.where(passed, 0, branches[path, time, column])
    return np.where(rows.valid[..., None], found, v), np.where(rows.valid, k, 0)


def folded(module: Any, v: Array, tolerance: float | None = None) -> Rows:
    """Return the rows with their principal angle, axis and branch.

    Nearer to a whole turn than the root of the tolerance, errors of its size take half of the digits of an axis.
    """
    principal = module.principal(v)
    eps = float(np.finfo(v.dtype).eps)
    tolerance = TOLERANCE * eps if tolerance is None else tolerance
    angle, axis = module.to_screw(principal) if v.shape[-1] == 6 else module.to_angle_axis(principal)
    angle = angle[..., 0] if v.shape[-1] == 6 else angle
    vector = module.to_exponential(v)[..., :3]
    rounding = ROUNDING * eps * (1 + np.linalg.norm(vector, axis=-1))
    valid = np.isfinite(module.quaternion(v)).all(axis=-1) & (rounding < ROUNDING)
    near = valid & (angle <= np.sqrt(tolerance) + rounding)
    last, moving = latest(valid), latest(valid & ~near)
    known = np.nan_to_num(taken(np.where(near[..., None], taken(axis, moving), axis), last))
    turned = np.sum(module.to_exponential(principal)[..., :3] * known[..., :3], axis=-1)
    along = np.nan_to_num(taken(np.where(near, abs(turned), angle).astype(float), last))
    known = np.where((near & (turned < 0))[..., None], -known, known)
    resting = near & known.any(axis=-1)  # no axis is known if no row moves
    about = whole_turns(module, v[resting], known[resting], along[resting, None])
    resting[resting] = same_pose(module, about, v[resting], tolerance)
    axis = np.where(resting[..., None], known, np.nan_to_num(taken(axis, last)))
    angle = np.where(resting, along, np.nan_to_num(taken(angle.astype(float), last)))
    own = np.rint(np.nan_to_num((np.sum(taken(vector, last) * axis[..., :3], axis=-1) - angle) / (2 * pi))).astype(int)
    return Rows(v, principal, angle, axis, along, known, own, resting, near & ~resting, last, valid, tolerance)


def latest(selected: Array) -> Array:
    """Return for each row the last selected one up to it, or the first one after it."""
    rows = np.arange(len(selected))[:, None]
    last = np.maximum.accumulate(np.where(selected, rows, -1), axis=0)
    return np.where(last < 0, np.argmax(selected, axis=0), last)


def taken(values: Array, rows: Array) -> Array:
    """Return values at the given rows of each column."""
    return values[rows, np.arange(rows.shape[1])]


def modulo(branch: Array, count: int) -> Array:
    """Return branches modulo their number; 0 stands for infinitely many."""
    return branch % count if count else branch


def near(rows: Rows, count: int) -> Array:
    """Return the branches that each row may take, shape (K, T, B)."""
    if 0 < count <= WINDOW:
        return np.broadcast_to(np.arange(count)[:, None, None], (count, *rows.own.shape))
    # turn on from row to row about one axis, which may point to either side
    cosine = np.sum(rows.known[1:, :, :3] * rows.known[:-1, :, :3], axis=-1)
    side = np.cumprod(np.copysign(1, np.insert(cosine, 0, 1, axis=0)), axis=0)
    total = np.unwrap(side * rows.along, axis=0) + 2 * pi * rows.own[0]
    k = np.rint((side * total - rows.angle) / (2 * pi)).astype(int)
    return modulo(np.stack([k, 0 * k, 0 * k - 1]), count)


def turned(angle: Array, branches: Array, count: int) -> Array:
    """Return the angles on the given branches, for a finite number n of them in (−nπ, nπ]."""
    angles = np.asarray(angle + 2 * pi * branches)
    return angles - 2 * pi * count * np.ceil(angles / (2 * pi * count) - 0.5) if count else angles


def candidates(module: Any, rows: Rows) -> tuple[Array, Array, Array]:
    """Return branches that rows may take, the angles and the vectors there, shape (K, T, B, …).

    Vectors are NaN where they are infinite, or their digits do not tell the pose: beside whole turns about far axes,
    and near the edge of a chart. Candidates end a quarter turn before the edge.
    """
    count, still = module.CHART.branches, rows.resting
    branches = near(rows, count)
    angles = turned(rows.angle, branches, count)
    found = np.broadcast_to(rows.principal, (*branches.shape, rows.v.shape[-1])).copy()
    flat, steps = found.reshape(-1, rows.v.shape[-1]), branches.ravel()
    order = np.argsort(steps, kind="stable")
    for group in np.split(order, np.flatnonzero(np.diff(steps[order])) + 1):
        if step := int(steps[group[0]]):
            flat[group] = module.shadow(flat[group], step)
    found = np.where(((branches == modulo(rows.own, count)) & ~still)[..., None], rows.v, found)
    if still.any():
        made = whole_turns(module, rows.v[still], rows.axis[still], angles[:, still, None])
        found[:, still] = np.where((branches[:, still] != 0)[..., None], made, found[:, still])
    if (lone := rows.apart & ~still).any():
        told = same_pose(module, found[:, lone], rows.v[lone], rows.tolerance)
        found[:, lone] = np.where(told[..., None], found[:, lone], np.nan)
    if count:
        edge = module.singular_angles()[-1] * (1 + ROUNDING * np.finfo(rows.v.dtype).eps)
        found[abs(angles) > edge - pi / 2] = np.nan
    return branches, angles, found[:, rows.last, np.arange(rows.last.shape[1])]


def whole_turns(module: Any, v: Array, axis: Array, angle: Array) -> Array:
    """Return the vectors of rows near whole turns about the axis of a neighbour, and their translation along it."""
    screw = angle * axis
    if axis.shape[-1] == 6:
        shift = np.sum(module.pose(v)[..., :3, 3] * axis[..., :3], axis=-1, keepdims=True)
        screw[..., 3:] += shift * axis[..., :3]
    return np.asarray(module.from_exponential(screw))


def same_pose(module: Any, one: Array, other: Array, tolerance: float) -> Array:
    """Return whether vectors have the same pose within a tolerance, relative for translations above 1."""
    p, q = (module.quaternion(v).reshape(*v.shape[:-1], v.shape[-1] // 3, 4) for v in (one, other))
    sign = np.copysign(1, np.sum(p[..., :1, :] * q[..., :1, :], axis=-1, keepdims=True))
    gap = np.linalg.norm(p - sign * q, axis=-1)
    room = np.where(np.arange(q.shape[-2]), 1 + np.linalg.norm(q, axis=-1), 0.5)  # half angles in the real part
    return np.asarray((gap <= (tolerance + ROUNDING * np.finfo(other.dtype).eps) * room).all(axis=-1))


def costs(
    module: Any, rows: Rows, branches: Array, vectors: Array, usual: int, switch_angle: float
) -> tuple[Array, Array]:
    """Return the costs of steps from row to row, shape (K, K, T − 1, B), and the price of a jump by column.

    A step costs its length, and a jump its price too, which is above the length of any way. Steps to and from
    candidates after the ``usual`` ones count as jumps. A step longer than each one of the principal vectors costs
    infinity, be it longer as a whole or in its rotation part.
    """
    steps = np.empty((2, len(vectors), *vectors.shape[:1], len(rows.v) - 1, rows.v.shape[1]))
    for i, j in np.ndindex(steps.shape[1:3]):
        change = np.subtract(vectors[j, 1:], vectors[i, :-1], dtype=np.result_type(vectors, float))
        steps[:, i, j] = np.linalg.norm(change[..., :3], axis=-1), np.linalg.norm(change, axis=-1)
    first = np.argmax(branches == 0, axis=0)
    time, column = np.ogrid[: len(rows.v) - 1, : rows.v.shape[1]]
    longest = steps[:, first[:-1], first[1:], time, column].max(axis=1, initial=0)
    size = np.linalg.norm(vectors[..., :3], axis=-1)
    jump = steps[0] > explained(module, rows, size, switch_angle)
    jump[usual:] = jump[:, usual:] = True
    price = 1 + 2 * len(rows.v) * longest[0]
    allowed = (steps <= longest[:, None, None, None]).all(axis=0)
    return np.where(allowed, steps[0] + price * jump, np.inf), price


def explained(module: Any, rows: Rows, size: Array, switch_angle: float) -> Array:
    """Return the longest steps that are no jumps, from the rotations between rows; ``size`` is the length of v.

    The fastest rates of v within the switch angle are those at one of its ends, along the axis or across it.
    """
    screws = np.zeros((3, 1, rows.v.shape[-1]))
    screws[:, 0, 0] = 0, switch_angle, pi
    ends = module.from_exponential(screws)
    half_turn = abs(ends[2, 0, 0])
    rates = module.rate(ends[:2], np.eye(rows.v.shape[-1])[:2])
    fastest = np.linalg.norm(rates[..., :3], axis=-1).max()
    q = taken(module.quaternion(rows.v), rows.last)[..., :4]
    chord = np.minimum(*(np.linalg.norm(q[1:] + sign * q[:-1], axis=-1) for sign in (1, -1)))
    usual = np.minimum(fastest * 4 * np.arcsin(np.minimum(chord / 2, 1)), half_turn)
    eps = max(np.finfo(rows.v.dtype).eps, np.finfo(float).eps)
    return np.asarray(usual + ROUNDING * eps * (half_turn + size[:, None, :-1] + size[None, :, 1:]))


def cheapest(costs: Array, first: Array) -> Array:
    """Return the cheapest way, as one number below K for each row, shape (T, B); ``first`` is the cost of a start.

    The costs of ways over two, four, eight … steps follow by doubling, so that no loop runs over rows.
    """
    lengths, middles = [], []
    unmoved = np.where(np.eye(len(costs), dtype=bool), 0, np.inf)[..., None, None]
    while costs.shape[2] > 1:
        lengths.append(costs.shape[2])
        if costs.shape[2] % 2:
            costs = np.concatenate([costs, np.broadcast_to(unmoved, (*costs.shape[:2], 1, costs.shape[3]))], axis=2)
        before, after = costs[:, :, 0::2], costs[:, :, 1::2]
        costs, middle = np.full_like(before, np.inf), np.zeros(before.shape, np.int8)
        for m in range(len(costs)):
            total = before[:, m, None] + after[None, m]
            better = total < costs
            costs[better], middle[better] = total[better], m
        middles.append(middle)
    K, columns = first.shape
    whole = first[:, None] + (costs[:, :, 0] if costs.shape[2] else unmoved[..., 0])
    path = np.stack(np.unravel_index(np.argmin(whole.reshape(K * K, columns), axis=0), (K, K)))
    for length, middle in zip(lengths[::-1], middles[::-1], strict=True):
        between = middle[(path[:-1], path[1:], *np.ogrid[: len(path) - 1, :columns])]
        woven = np.empty((2 * len(path) - 1, columns), int)
        woven[::2], woven[1::2] = path, between
        path = woven[: length + 1]
    return path if costs.shape[2] else path[:1]
