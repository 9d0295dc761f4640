"""Definitions of the paper's symbols, against which its printed formulas are checked.

Each function takes the arguments of `derive.papers.language.environment.Definition`: the environment, then values.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from ...algebra import Dual, Tensor, Vector, dual_part, real_part
from ...maps import pose, rodrigues
from ..language import values
from ..language.common_definitions import component_of, plain, screw_tensor
from ..language.environment import Definition, Env, let
from ..language.printed import Symbol
from ..numbers.draw import Draw
from ..numbers.kinds import drawn


def components(vector: Symbol, real_parts: Iterable[Symbol], dual_parts: Iterable[Symbol]) -> tuple[Definition, ...]:
    """Return the definitions of the six real components of a dual vector."""
    return tuple(let(symbol, component_of(n, part), vector) for part, symbols in (
        (real_part, real_parts), (dual_part, dual_parts)) for n, symbol in enumerate(symbols, 1))


# ---- displacements --------------------------------------------------------------------------------------------


def turned(env: Env, x: Vector, angle: Any, axis: Vector) -> Vector:
    """Return x displaced by a dual angle about an axis."""
    return screw_tensor(env, angle, axis) @ x


def cross_matrix(env: Env, b: Vector) -> Tensor:
    """Return the matrix of ``y -> b × y``."""
    columns = (b.cross(Vector(*row)) for row in Tensor.identity().rows)
    return Tensor.from_entries(entry for column in columns for entry in column).transpose


def cayley_map(env: Env) -> values.Map:
    """Return the Cayley map from skew-symmetric to orthogonal matrices; the preimage of A is ``(A − I)(A + I)⁻¹``."""

    def preimages(A: Tensor) -> list[Tensor]:
        try:
            return [rodrigues.cayley_matrix(A)]
        except ArithmeticError as error:
            raise values.MissedError("A + I is singular") from error

    def image(B: Tensor) -> Tensor:
        return (Tensor.identity() + B) @ (Tensor.identity() - B).inverse()

    return values.Map(image, preimages)


def screw_rodrigues(env: Env, angle: Any, axis: Vector) -> Vector:
    """Return the Rodrigues vector b̂ of the displacement with this angle and axis."""
    return rodrigues.rodrigues_vector(screw_tensor(env, angle, axis))


def direction(env: Env, b: Vector) -> Vector:
    """Return ``b̂/‖b̂‖``."""
    return rodrigues.direction(b, env.field)


# ---- the rhombus of figure 1, in a frame Q whose third axis is the rotation axis --------------------------------


axis_of = plain(lambda Q: Vector(*Q.transpose.rows[2]))
across = plain(lambda size, Q: Vector(*Q.transpose.rows[0]) * size)
raised = plain(lambda size, height, Q: Q @ Vector(size, 0, height))
"""Vector with components along the first and third axes: any vector in a suitable frame."""
projected = plain(lambda x, axis: x - axis * x.dot(axis))
"""Part of a vector orthogonal to an axis."""


# ---- lines ----------------------------------------------------------------------------------------------------


def distance(env: Env, a: Vector, b: Vector) -> Any:
    """Return the shortest distance of two lines."""
    normal = a.re.cross(b.re)
    if env.field.same(normal.dot(normal), 0):
        return pose.distance_of_parallels(a, b, env.field)
    return pose.distance(a, b, env.field)


def angle_between(env: Env, a: Vector, b: Vector) -> Any:
    """Return the angle of two directions in [0, π]; the tangent of half the angle is ``|a − b| / |a + b|``."""
    apart, together = a.re - b.re, a.re + b.re
    size = together.dot(together)
    if env.field.same(size, 0):
        return env.field.pi
    return 2 * env.field.atan(env.field.sqrt(apart.dot(apart) / size))


# ---- points -----------------------------------------------------------------------------------------------------


def special_axes(axis: Symbol) -> Callable[[Draw], dict[str, dict[Symbol, Any]]]:
    """Return further points for ``also``: unit dual vectors with one or two zero real components."""

    def points(draw: Draw) -> dict[str, dict[Symbol, Any]]:
        found = {}
        for zeros, direction in ((2, (1, 0, 0)), (2, (-1, 0, 0)), (1, (3, 4, 0))):
            for turn in range(3):
                turned = tuple(direction[(n - turn) % 3] for n in range(3))
                unit = Vector(*(draw.plain(c) for c in turned)) / (5 if zeros == 1 else 1)
                point = Vector(draw.signed(), draw.signed(), draw.signed())
                found[f"{axis.name}: direction {turned}"] = {axis: Vector.dual(unit, point.cross(unit))}
        return found

    return points


def crossing_lines(line: Symbol, axis: Symbol) -> Callable[[Draw], dict[str, dict[Symbol, Any]]]:
    """Return further points: a line at right angles to the axis that crosses it, and one that misses it."""

    def points(draw: Draw) -> dict[str, dict[Symbol, Any]]:
        frame = drawn("orthogonal tensor", draw)
        u, crossing = Vector(*frame.rows[0]), Vector(*frame.rows[1])
        passing = crossing + u * Dual(0, draw.real())
        return {"l_a crosses the axis": {axis: u, line: crossing}, "l_a passes the axis": {axis: u, line: passing}}

    return points
