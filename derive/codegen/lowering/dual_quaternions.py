"""Dual quaternions of a motion under a twist: product, normalization, and the pose and the tensor of a unit one."""

from __future__ import annotations

from ...algebra import Quaternion, Vector
from ...maps import Cayley
from ..programs.value import Number
from .forward import crossed, flat, rotation, rows_of
from .point import Geometry, Point, Results

LOCAL = Cayley(2)  # chart of the displacement within a step: the lowest order that is regular up to a whole turn


def product(trace: Geometry) -> Results:
    """Product a b of two dual quaternions.

    The dual part is a b° + a° b.
    """
    (a, ao), (b, bo) = _parts(_given(trace, "a")), _parts(_given(trace, "b"))
    return *(a * b), *(a * bo + ao * b)


def normalized(trace: Geometry) -> Results:
    """Unit dual quaternion q/√(q q*) of a dual quaternion q."""
    q, qo = _parts(_given(trace, "q"))
    square = trace.name("square", q.norm2())
    along = trace.name("along", (q.scalar * qo.scalar + q.vector.dot(qo.vector)) / square)
    size = trace.name("size", trace.sqrt(square))
    return *(q / size), *((qo - q * along) / size)


def pose_of(trace: Geometry) -> Results:
    """Rows [Q, ρ] of the pose of a unit dual quaternion."""
    q, qo = _parts(_given(trace, "q"))
    Q = rotation(Point(trace, (*q.vector, 0, 0, 0)), trace.name("f", 2 * q.scalar), 2)
    rho = 2 * (q.scalar * qo.vector - qo.scalar * q.vector + q.vector.cross(qo.vector))
    return flat((*row, last) for row, last in zip(Q, rho, strict=True))


def tensor_of(trace: Geometry) -> Results:
    """Orthogonal dual tensor Q of a unit dual quaternion.

    The dual part is skew(ρ) Q.
    """
    rows = trace.apply(pose_of, "P{}", _given(trace, "q"))
    Q = (*rows[0:3], *rows[4:7], *rows[8:11])
    return *Q, *crossed(Vector(*rows[3::4]), rows_of(Q))


PROGRAMS = product, normalized, pose_of, tensor_of  # recipes; each follows the ones that it calls


def _given(trace: Geometry, argument: str) -> tuple[Number, ...]:
    """Declare a dual quaternion of eight components."""
    return trace.inputs(argument, [f"{argument}{i}{mark}" for mark in ("", "o") for i in range(4)])


def _parts(components: tuple[Number, ...]) -> tuple[Quaternion, Quaternion]:
    return Quaternion.from_components(components[:4]), Quaternion.from_components(components[4:])
