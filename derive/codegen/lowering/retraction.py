"""Small displacements by the exponential: what they make of v, and the one that leads from a vector to another.

The exponential's own scalars are traced in place: they are the same in every chart.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ...algebra import Quaternion, Tensor, Vector
from ...maps.dependent import DependentScalars
from ...maps.exponential_chart import Exponential, PrincipalScalars
from ..programs.program import Program
from ..programs.value import Number
from .calculus import HALF, matrix6
from .forward import named, rotate, start, translation
from .groups import dual_tensor, named_tensor, operator_tensor, opposite, tangent_at, twice_inverse
from .inputs import dual_vector
from .inverse import ray
from .kinematics import operator_of
from .point import Geometry, Point, Scope

EXPONENTIAL = Exponential()


def retract(trace: Geometry) -> Program:
    """R = exp(δ) R(v)."""
    return trace.program("retract", _vector(trace, _retracted(start(trace), step(trace), body=False)))


def body_retract(trace: Geometry) -> Program:
    """R = R(v) exp(δ)."""
    return trace.program("body_retract", _vector(trace, _retracted(start(trace), step(trace), body=True)))


def step(trace: Geometry) -> Point:
    """The step that is the second argument."""
    return Point(trace, dual_vector(trace, "delta", "d"), "d")


@dataclass(frozen=True, slots=True)
class _Placed:
    """A displacement on a branch: Re v, what it is of the vector of a quaternion, of which scalar, its angle, and ρ."""

    re: Vector
    fi: Number
    alpha: Number
    rho: Vector


def _vector(trace: Geometry, placed: _Placed) -> tuple[Number, ...]:
    """With v° = Re(T)⁻¹ rho."""
    (hi,) = trace.ask("inverse_at", (_square(trace, placed.re), placed.fi, placed.alpha), "w")
    return with_dual(trace, placed.fi, placed.rho, placed.re, hi)


def _square(trace: Geometry, re: Vector) -> Number:
    return Point(trace, (*re, 0, 0, 0), "w").x


def _retracted(point: Point, delta: Point, body: bool) -> _Placed:
    """The product on the branch nearest v."""
    trace, at = point.trace, exponential_scalars(delta)
    small = (Quaternion(at.s, named(trace, "wd", at.w * delta.re)), (at.f, at.g), translation(delta, at.f, at.g, at.h))
    turned, _, (f, g, h) = ray(trace, point)
    large = (turned, (f, g), translation(point, f, g, h))
    (after, (f2, g2), shift), (before, _, rho) = (large, small) if body else (small, large)
    outer = point if body else delta
    e = Quaternion.from_components(trace.name(f"z{i}", c) for i, c in enumerate(after * before))
    moved = rotate(outer, f2, g2, named(trace, "rhob", rho), "rhob")
    return _nearest(trace, point, e, named(trace, "rho", moved + shift))


def _nearest(trace: Geometry, point: Point, e: Quaternion, rho: Vector) -> _Placed:
    """φ(α) u of a quaternion, α within π of what v's own angle is along u."""
    scope = Scope(trace, "")  # whose names avoid those of a chart
    ss = scope.name("ss", e.vector.dot(e.vector))
    still, resting = scope.name("still", trace.equal(ss, 0)), scope.name("resting", trace.equal(point.x, 0))
    length = scope.name("length", trace.sqrt(trace.where(still, 1 + ss, ss)))
    r = scope.name("r", trace.sqrt(trace.where(resting, 1 + point.x, point.x)))
    (own,) = trace.ask("unfolded", (point.x, r))
    share = trace.where(resting, 0, own / r)
    along = scope.name("own", share * point.re.dot(e.vector) / length)
    sine = scope.name("sine", trace.where(still, ss, length))
    # within half a turn, so that near the identity it has all digits, whichever of e and −e is given
    falling = scope.name("falling", trace.less(e.scalar, 0))
    cosine = scope.name("cosine", trace.where(falling, -e.scalar, e.scalar))
    half = trace.atan2(sine, cosine)
    angle = scope.name("folded", trace.where(falling, -2, 2) * half)
    turn = trace.tan((angle - along) / 2)
    turns = scope.name("turns", along - angle + 2 * trace.atan2(turn, 1))
    # a multiple of 2π, but for rounding, which would be much near the identity: on the principal branch it is 0
    alpha = scope.name("angle", angle + trace.where(trace.less(trace.abs(turns), 1), 0, turns))
    size, slope = trace.ask("coefficient_of", (alpha, sine, e.scalar), "n")
    rest = 2 * slope / scope.name("z0s", trace.where(still, e.scalar, length))
    factor = scope.name("factor", trace.where(still, rest, size / length))
    return _Placed(named(trace, "v_", factor * e.vector), trace.name("fe", factor * e.scalar), alpha, rho)


def with_dual(trace: Geometry, fi: Number, rho: Vector, re: Vector, hi: Number) -> tuple[Number, ...]:
    """``fi`` is the factor times the scalar of e on whichever branch v is."""
    along = Scope(trace, "").name("hvr", hi * re.dot(rho))
    return (*re, *((fi * rho - re.cross(rho) + along * re) / 2))


def exponential_scalars(delta: Point) -> DependentScalars:
    """The exponential's at a step."""
    return EXPONENTIAL.scalars(delta.x, Scope(delta.trace, delta.mark))


def retract_jacobians(trace: Geometry) -> Program:
    """``(T(v')⁻¹ exp(δ) T(v), T(v')⁻¹ dexp(δ))``."""
    return _by_step(trace, "retract_jacobians", body=False)


def body_retract_jacobians(trace: Geometry) -> Program:
    """``(T(v')⁻¹ T(v), T(v')⁻¹ R(v) dexp(δ))``."""
    return _by_step(trace, "body_retract_jacobians", body=True)


def _by_step(trace: Geometry, name: str, body: bool) -> Program:
    point, delta = Point(trace, dual_vector(trace, "v", "v"), "p"), step(trace)
    back = _twice_inverse(trace, _retracted(point, delta, body))
    at = exponential_scalars(delta)
    dexp = operator_tensor(operator_of(delta, (at.f, at.g, at.h, at.fy, at.gy, at.hy)), "D")
    T = tangent_at(trace, (*point.re, *point.du), "F")
    if body:
        R = named_tensor(trace, "R", dual_tensor(point, *point.scalars("ray")[3:]))
        dexp = named_tensor(trace, "RD", R @ dexp)
    else:
        R = named_tensor(trace, "R", dual_tensor(delta, at.f, at.g, at.h))
        T = named_tensor(trace, "RT", R @ T)
    by_v, by_delta = (back @ T) * HALF, (back @ dexp) * HALF
    return trace.program(name, (*matrix6(trace, by_v, "V"), *matrix6(trace, by_delta, "S")))


def _twice_inverse(trace: Geometry, placed: _Placed) -> Tensor:
    """2 T⁻¹ where a displacement is placed."""
    fi, hi, fiy, hiy = trace.ask("tangent_inv_at", (_square(trace, placed.re), placed.fi, placed.alpha), "n")
    vector = with_dual(trace, fi, placed.rho, placed.re, hi)
    found = Point(trace, [trace.name(f"w{i}", c) for i, c in enumerate(vector, 1)], "n")
    return operator_tensor(twice_inverse(found, (fi, hi, fiy, hiy)), "I")


def local(trace: Geometry) -> Program:
    """exp(δ) = R(v2) R(v1)ᵀ."""
    second, first = (dual_vector(trace, letter, letter) for letter in ("b", "a"))
    return trace.program("local", _quotient(trace, second, opposite(trace, "a", first)))


def body_local(trace: Geometry) -> Program:
    """exp(δ) = R(v1)ᵀ R(v2)."""
    first, second = (dual_vector(trace, letter, letter) for letter in ("a", "b"))
    return trace.program("body_local", _quotient(trace, opposite(trace, "b", second), first))


def _quotient(trace: Geometry, second: Sequence[Number], first: Sequence[Number]) -> tuple[Number, ...]:
    """The exponential's vector of a product."""
    after, before = Point(trace, second, "b"), Point(trace, first, "a")
    ray2, _, (f, g, h) = ray(trace, after)
    ray1, _, coefficients = ray(trace, before)
    e = Quaternion.from_components(trace.name(f"z{i}", c) for i, c in enumerate(ray2 * ray1))
    moved = rotate(after, f, g, named(trace, "rhoa", translation(before, *coefficients)), "rho")
    return logarithm(trace, e, named(trace, "rho", moved + translation(after, f, g, h)))


def logarithm(trace: Geometry, e: Quaternion, rho: Vector) -> tuple[Number, ...]:
    """The exponential's vector of a positive multiple of a quaternion: by its angle, however large the multiple is."""
    scope = Scope(trace, "e")
    factor = EXPONENTIAL.gain(e, 1, scope)
    re = named(trace, "d", factor * e.vector)
    at = PrincipalScalars(Point(trace, (*re, 0, 0, 0), "e").x, scope)
    return with_dual(trace, scope.name("fe", factor * e.scalar), rho, re, at.hi)
