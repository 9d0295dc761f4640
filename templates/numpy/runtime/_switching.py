"""Branches along a motion: an event that asks for a switch, and branches that make a sequence continuous."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike

from ._arguments import vector_size
from ._kernel import Array
from ._runtime import as_array
from ._sequences import continued
from ._tools import ChartModule

Event = Callable[[float, Array], float]

ROWS = 2**17
"""Number of rows whose branches are chosen at once; a longer sequence is one block."""


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


def switch_event(module: ChartModule, state: Any = slice(0, 6), angle: float | None = None) -> Event:
    """Return a terminal event for ``scipy.integrate.solve_ivp`` that stops where v must change its branch.

    The event crosses zero upwards at a rotation angle halfway between π and the first singular angle of the chart, or
    at ``angle``. After `switch` the angle is below π, so that the event does not occur again at once.

    ``solve_ivp`` looks for events between steps only. Set ``max_step`` below the distance from the event to the first
    singular angle over the largest angular velocity; then no step passes this range.

    The event never occurs in a motion that starts beyond its angle. Switch such a v first: the event raises ValueError
    if v is beyond the angle in its first call. Take a new event for each motion.

    Parameters
    ----------
    module : module
        Kernel module, of poses or of rotations alone.
    state : slice or index array
        Place of v in the state; the rotation part of v comes first.
    angle : float, optional
        Rotation angle of the event, from π to below the first singular angle. Controllers with modified Rodrigues
        parameters take π, where ``|σ| = 1``.

    Returns
    -------
    callable
        Function of t and the state, with the attributes ``terminal`` and ``direction``.

    Raises
    ------
    ValueError
        If the chart is singular at π, as n = 1: use `propagate`, which takes a new centre there. If the angle is out
        of range.

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import cayley2, switch_event
    >>> event = switch_event(cayley2)
    >>> event.terminal, event.direction, event(0.0, np.zeros(6)) < 0
    (True, 1.0, True)

    The loop around ``solve_ivp``, for ``|ω|`` up to 1 rad/s; ``rhs(t, y)`` begins with the rate of v::

        y0[:6] = cayley2.switch(y0[:6])
        event, pieces = switch_event(cayley2), []
        while True:
            piece = solve_ivp(rhs, (t0, t1), y0, events=event, max_step=np.pi / 2)
            pieces.append(piece)
            if piece.status != 1:  # the end, or a failure
                break
            t0, y0 = piece.t[-1], piece.y[:, -1]
            y0[:6] = cayley2.switch(y0[:6])
    """
    size, first, limit = vector_size(module), float(module.singular_angles()[0]), switch_angle(module)
    if angle is not None:
        if not pi <= angle < first:
            raise ValueError(f"angle must be from π to below {first:.6g}, got {angle!r}")
        limit = max(angle, pi + 1e-9)  # at π itself `switch` keeps the side that is given
    axis = np.zeros(size)
    axis[0] = limit
    square = float(module.from_exponential(axis)[0]) ** 2
    begun = False

    def event(t: float, y: Array) -> float:
        nonlocal begun
        real = y[state][:3]
        value = float(real @ real) - square
        if value > 0 and not begun:
            raise ValueError(f"v starts beyond the angle {limit:.6g} of the event, at t = {t:g}: switch it first")
        begun = True
        return value

    event.terminal, event.direction = True, 1.0  # type: ignore[attr-defined]
    return event


@overload
def unwrap(
    module: ChartModule, v: ArrayLike, *, branch: Literal[False] = False, tolerance: float | None = None
) -> Array: ...
@overload
def unwrap(
    module: ChartModule, v: ArrayLike, *, branch: Literal[True], tolerance: float | None = None
) -> tuple[Array, Array]: ...
def unwrap(
    module: ChartModule, v: ArrayLike, *, branch: bool = False, tolerance: float | None = None
) -> Array | tuple[Array, Array]:
    """Return the vectors on the branches that make a sequence of poses continuous, as ``numpy.unwrap`` does for angles.

    The branches are chosen over the whole sequence: those with the fewest jumps, among them the shortest way. There are
    no more jumps than in `principal`, and no step is longer than its longest one. The first vector keeps its branch,
    unless another one within the switch angle of the chart (see `switch_event`) saves a jump or a longer step. A
    sequence that has continuous vectors within the switch angle gets vectors without a jump.

    A step is the change of the rotation part of v from row to row. It is a jump if it is longer than φ(π), the length
    of v at half a turn. It is also a jump if it is longer than C θ, where θ is the angle of the rotation between the
    rows. C is the largest ratio of the rates of v and of the rotation within the switch angle.

    A vector with NaN stays, and the next one continues from the last before it. At a whole turn the pose has no axis of
    its own: such a vector takes the axis of a neighbour, and its pose changes by the tolerance at most. Nearer to a
    whole turn than the root of the tolerance, a row may be off that axis by more. If that saves jumps, such a row alone
    gets its principal vector, and the steps to and from it may be long.

    Parameters
    ----------
    module : module
        Kernel module, of poses or of rotations alone.
    v : array, shape (T, ..., 6)
        Vectors of the chart along the first axis; (T, ..., 3) for rotations. They may be on any branch.
    branch : bool
        True returns the branches too.
    tolerance : float, optional
        How near a whole turn a row counts as being there: rotation (rad), and translation relative to one above 1.
        The default is 2¹⁵ units of rounding, 7e-12 for float64 and 4e-3 for float32. Products of 10³ matrices lose
        a tenth of it. Set it above the noise of a recording.

    Returns
    -------
    v : array, shape (T, ..., 6)
        Vectors of the same poses, at whole turns within the tolerance.
    branch : array of int, shape (T, ...)
        k of ``φ(α + 2kπ) u``, modulo the number of branches, with the axis u that `shadow` takes; only if asked for.

    Raises
    ------
    TypeError
        If v is complex.
    ValueError
        If v has no first axis, or another number of components. If the tolerance is not from 0 to 1.

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import exponential, unwrap
    >>> turning = np.linspace(0, 10, 21)[:, None] * np.array([0, 0, 1.0, 0.2, 0, 0])
    >>> np.allclose(unwrap(exponential, exponential.principal(turning)), turning)
    True
    """
    shape, n = np.shape(v), vector_size(module)
    if len(shape) < 2 or shape[-1] != n:
        raise ValueError(f"v must have shape (T, ..., {n}), got {shape}")
    if tolerance is not None and not 0 <= tolerance <= 1:
        raise ValueError(f"tolerance must be from 0 to 1, got {tolerance!r}")
    found = np.array(as_array("v", v, (n,), -1, real=True), order="C")
    branches = np.zeros(shape[:-1], int)
    if found.size and module.singular_angles()[0] > pi * (1 + 1e-9):  # else no other branch helps
        rows, numbers = found.reshape(shape[0], -1, n), branches.reshape(shape[0], -1)
        for i in range(0, rows.shape[1], width := max(1, ROWS // len(rows))):
            columns = slice(i, i + width)
            rows[:, columns], numbers[:, columns] = continued(module, rows[:, columns], switch_angle(module), tolerance)
    return (found, branches) if branch else found
