"""Quantities of a spline at one time, as programs on components: a product of factors Cay(λ(t) d) and its motion.

A pose is a list of three rows [Q, p], a rotation of three rows Q. A motion is a pose with its twist and the derivative
of its twist, as far as they are asked for.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache, partial, reduce
from itertools import chain
from typing import Any, TypeAlias

from ._chart import Chart
from ._derived import screw_twist
from ._kernel import Components, Kernel, Result

Rows: TypeAlias = Sequence[Components]
Motion: TypeAlias = tuple[Rows, list[Components]]

ORDERS = {
    "pose": 0, "v": 0, "v_dot": 1, "v_ddot": 2, "twist": 1, "body_twist": 1, "acceleration": 2, "body_acceleration": 2,
}  # fmt: skip
"""Number of time derivatives by quantity."""

POSES, ROTATIONS = ("pose", "from_pose"), ("tensor", "from_tensor")
"""Kernels from a vector to a matrix, and back."""

COEFFICIENTS, STEPS = 1, 13
"""Places in the data of a span: 1/length, then four coefficients of three parts λ, then three steps and a pose."""


@cache
def programs(chart: Chart) -> Chart:
    """Return a chart whose kernels are the quantities of a spline, named ``spline_pose`` and so on."""
    (size,), kernels = chart.kernels["principal"].shape, {}
    matrix = chart.kernels["pose" if size == 6 else "tensor"].shape
    arguments = ("share", ()), ("span", (STEPS + 3 * size + 3 * matrix[0],))
    for name in ORDERS:
        plain, shape = partial(evaluated, name, chart.kernels, size), matrix if name == "pose" else (size,)
        kernels[f"spline_{name}"] = Kernel(plain, arguments, shape, real=True)
    return replace(chart, kernels=kernels)


def evaluated(
    name: str, kernels: Mapping[str, Kernel], size: int, m: Any, c: Any, share: Components, span: Components
) -> Result:
    """Return a quantity where a share of a span has passed.

    Twist and step of a factor have one screw, so its twist is equal in both of its frames. The inverse of a product has
    the twists of the body as its own in space, with the opposite sign.
    """
    order, (u,), (matrix, vector) = ORDERS[name], share, POSES if size == 6 else ROTATIONS
    side = 1 if name in ("pose", "v", "twist", "acceleration") else -1

    def moving(k: int) -> Motion:
        d = span[STEPS + k * size : STEPS + (k + 1) * size]
        coefficients = span[COEFFICIENTS + 4 * k : COEFFICIENTS + 4 * k + 4]
        part, rate, change = (side * one for one in shares(u, span[0], coefficients))
        v, zeros = [part * one for one in d], [0] * (6 - size)
        along = screw_twist(m, c, [*v, *zeros], [*d, *zeros]) if order else ()
        twist, slope = along[:size], along[6 : 6 + size]
        twists = [rate * w for w in twist], [change * w + rate * rate * x for w, x in zip(twist, slope)]
        return rows_of(kernels[matrix].plain(m, c, v)), [*twists[:order]]

    (X, twists), start = reduce(composed, map(moving, range(3)[::side])), rows_of(span[STEPS + 3 * size :])
    if name in ("twist", "acceleration"):
        return tuple(carried(start, twists[-1]))
    body = [[-one for one in w] for w in twists]
    if name.startswith("body"):
        return tuple(body[-1])
    pose = [*chain(*product(start, X if side > 0 else inverse(X))), *(0, 0, 0, 1)[: 4 * (size == 6)]]
    if name == "pose":
        return tuple(pose)
    v = kernels[vector].plain(m, c, pose)
    rate, table = (("principal", ()), ("rate", (-1, -0.5)), ("rate_dot", (-1,)))[order]
    return kernels[rate].plain(m, c, v, *body, table) if order else v


def shares(u: Any, rate: Any, coefficients: Components) -> tuple[Any, Any, Any]:
    """Return a part λ and two time derivatives from its coefficients by powers of u, which grows at a rate."""
    a, b, c, d = coefficients
    return a + u * (b + u * (c + u * d)), rate * (b + u * (2 * c + u * (3 * d))), rate * rate * (2 * c + u * (6 * d))


def composed(first: Motion, second: Motion) -> Motion:
    """Return the motion of a product, with twists in the frame of space."""
    (X, own), (Y, other) = first, second
    before = [carried(X, w) for w in other]
    twists = [added(w, x) for w, x in zip(own, before)]
    return product(X, Y), [*twists[:1], *(added(w, bracket(own[0], before[0])) for w in twists[1:])]


def product(X: Rows, Y: Rows) -> Rows:
    turned = [[dot(row, column) for column in zip(*Y)] for row in X]
    return [added(row, [0, 0, 0, *place[3:]]) for row, place in zip(turned, X)]


def inverse(X: Rows) -> Rows:
    turned = [*zip(*X)]
    return [[*row, *(-dot(row, p) for p in turned[3:])] for row in turned[:3]]


def carried(X: Rows, w: Components) -> Components:
    """Return the twist w after a motion by X."""
    turned, *moved = ([dot(row, half) for row in X] for half in (w[:3], w[3:]) if half)
    return [*turned, *(one for half in moved for one in added(half, cross([row[3] for row in X], turned)))]


def bracket(w: Components, x: Components) -> Components:
    """Return the bracket of twists, the derivative of x if the twist w carries it."""
    turned = cross(w, x)
    return [*turned, *added(cross(w, x[3:]), cross(w[3:], x))] if len(x) == 6 else turned


def rows_of(entries: Components) -> Rows:
    """Return the first three rows of a matrix of four columns, or of three if it has nine entries."""
    width = 3 if len(entries) == 9 else 4
    return [entries[width * i : width * (i + 1)] for i in range(3)]


def dot(a: Components, b: Components) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Components, b: Components) -> Components:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def added(a: Components, b: Components) -> Components:
    return [one + other for one, other in zip(a, b)]
