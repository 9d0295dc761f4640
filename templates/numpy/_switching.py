"""Branches along a motion: an event that asks for a switch, and branches that make a sequence continuous."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._kernel import Array

Event = Callable[[float, Array], float]


def switch_angle(module: Any) -> float:
    """Return the rotation angle where a motion changes branch: halfway between π and the first singular angle.

    Raises
    ------
    ValueError
        If the chart is singular at π or before, as n = 1 is: no other branch helps.
    """
    first = float(module.singular_angles()[0])
    if first < pi * (1 + 1e-9):
        raise ValueError(f"{module.__name__} is singular at the angle {first:.6g}, where no other branch helps")
    return (pi + first) / 2


def switch_event(module: Any, state: Any = slice(0, 6)) -> Event:
    """Return a terminal event for ``scipy.integrate.solve_ivp`` that stops where v must change its branch.

    The event crosses zero upwards at an angle halfway between π and the first singular angle of the chart. After
    `switch` the angle is below π, so that the event does not occur again at once.

    ``solve_ivp`` looks for events between steps only. Set ``max_step`` below ``(first singular angle − π)/2`` over
    the largest angular velocity; then no step passes the range between the event and the singular angle.

    Parameters
    ----------
    module : module
        Kernel module, of poses or of rotations alone.
    state : slice or index array
        Place of v in the state; the rotation part of v comes first.

    Returns
    -------
    callable
        Function of t and the state, with the attributes ``terminal`` and ``direction``.

    Raises
    ------
    ValueError
        If the chart is singular at π, as n = 1: use `propagate`, which takes a new centre there.

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import cayley2, switch_event
    >>> event = switch_event(cayley2)
    >>> event.terminal, event.direction, event(0.0, np.zeros(6)) < 0
    (True, 1.0, True)

    The loop around ``solve_ivp``, for ``|ω|`` up to 1 rad/s; ``rhs(t, y)`` begins with the rate of v::

        event, pieces = switch_event(cayley2), []
        while True:
            piece = solve_ivp(rhs, (t0, t1), y0, events=event, max_step=np.pi / 2)
            pieces.append(piece)
            if piece.status != 1:  # the end, or a failure
                break
            t0, y0 = piece.t[-1], piece.y[:, -1]
            y0[:6] = cayley2.switch(y0[:6])
    """
    axis = np.zeros(len(module.identity()))
    axis[0] = switch_angle(module)
    limit = float(module.from_exponential(axis)[0]) ** 2

    def event(t: float, y: Array) -> float:
        real = y[state][:3]
        return float(real @ real) - limit

    event.terminal, event.direction = True, 1.0  # type: ignore[attr-defined]
    return event


def unwrap(module: Any, v: ArrayLike, *, branch: bool = False) -> Array | tuple[Array, Array]:
    """Return the vectors on the branches that make a sequence of poses continuous, as ``numpy.unwrap`` does for angles.

    The first vector keeps its branch. Successive poses must differ by less than half a turn. A vector at NaN stays,
    and the next one continues from the last before it. The identity stays too: its other branches have no axis.

    Parameters
    ----------
    module : module
        Kernel module, of poses or of rotations alone.
    v : array, shape (T, ..., 6)
        Vectors of the chart along the first axis; (T, ..., 3) for rotations. They may be on any branch.
    branch : bool
        True returns the branches too.

    Returns
    -------
    v : array, shape (T, ..., 6)
        Vectors of the same poses. NaN where the chart has no such branch.
    branch : array of int, shape (T, ...)
        k of ``φ(α + 2kπ) u``, modulo the number of branches; only if asked for.

    Raises
    ------
    ValueError
        If v has no first axis, or another number of components.

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import exponential, unwrap
    >>> turning = np.linspace(0, 10, 21)[:, None] * np.array([0, 0, 1.0, 0.2, 0, 0])
    >>> np.allclose(unwrap(exponential, exponential.principal(turning)), turning)
    True
    """
    array, n = np.asarray(v), len(module.identity())
    if array.ndim < 2 or array.shape[-1] != n:
        raise ValueError(f"v must have shape (T, ..., {n}), got {array.shape}")
    angle, axis, own = _folded(module, array)
    valid = np.isfinite(angle) & np.any(axis != 0, axis=-1)
    steps = _continued(angle, axis, own, valid) - own if len(array) else own
    found = module.inverse(module.inverse(array))
    count = module.CHART.branches
    for step in map(int, np.unique(steps[valid])):
        chosen = valid & (steps == step)
        if step % count if count else step:
            found[chosen] = module.shadow(array[chosen], step)
    branches = np.where(valid, own + steps, 0)
    return (found, branches % count if count else branches) if branch else found


def _folded(module: Any, v: Array) -> tuple[Array, Array, Array]:
    """Return the principal angle, its axis (0 at the identity), and the branch of each vector."""
    q = np.asarray(module.quaternion(v), float)
    vector, scalar = q[..., 1:4], q[..., 0]
    size = np.linalg.norm(vector, axis=-1)
    side = np.where(scalar < 0, -1.0, 1.0)
    axis = side[..., None] * vector / np.where(size > 0, size, 1)[..., None]
    angle = 2 * np.arctan2(size, abs(scalar))
    own = np.sum(np.asarray(module.to_exponential(v), float)[..., :3] * axis, axis=-1)
    return angle, axis, np.rint(np.nan_to_num((own - angle) / (2 * pi))).astype(int)


def _continued(angle: Array, axis: Array, own: Array, valid: Array) -> Array:
    """Return the branch of each element that continues the sequence; the first valid one keeps its own."""
    rows = np.arange(len(angle)).reshape(-1, *(1,) * (angle.ndim - 1))
    last = np.maximum.accumulate(np.where(valid, rows, -1), axis=0)
    last = np.where(last < 0, np.argmax(valid, axis=0), last)  # rows before the first valid one take it
    angle = np.nan_to_num(np.take_along_axis(angle, last, 0))
    axis = np.nan_to_num(np.take_along_axis(axis, last[..., None], 0))
    same = np.sum(axis[1:] * axis[:-1], axis=-1) >= 0
    side = np.cumprod(np.concatenate([np.ones((1, *same.shape[1:])), np.where(same, 1.0, -1.0)]), axis=0)
    first = np.take_along_axis(own, last[:1], 0)
    turned = np.unwrap(side * angle, axis=0) + 2 * pi * first
    return np.rint((side * turned - angle) / (2 * pi)).astype(int)
