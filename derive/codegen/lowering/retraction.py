"""Steps δ by the exponential, whose scalars all charts share: the vector after a step, and the step to a vector."""

from __future__ import annotations

from collections.abc import Sequence

from ...algebra import Quaternion, Vector
from ...maps.exponential import Exponential, PrincipalScalars, StepScalars
from ...maps.real_constants import NOISE_OF_STEPS, SMALL, at_turn
from ..programs.program import Number
from .calculus import matrix6, opposite, tangent, tangent_at, tangent_inverse_at
from .forward import tensor_at, translation
from .inverse import composed, displacement, dual_part, dual_part_at, dual_product, product
from .point import LAYOUTS, Geometry, Point, Results, dual_tensor

EXPONENTIAL = Exponential()
SCALARS = ("s", "w", "f", "g", "h", "fy", "gy", "hy")


def retracted(
    trace: Geometry, scalars: Sequence[Number], delta: Sequence[Number], v: Sequence[Number]
) -> tuple[Vector, Number, Number, Vector]:
    """Return the vector of exp(δ) R(v), f_i, the number of its angle, and half of ρ."""
    s, w, f, g, h = scalars
    *large, size, _, _, r1, r2, r3 = trace.apply(displacement, "{}_1", v)
    small = (s, *(w * Vector(*delta[:3])))
    rho = translation(Point(trace, delta, "d"), f, g, h)
    found = trace.apply(composed, "{}", small, f, g, delta, rho, large, (r1, r2, r3))
    *re, fe, angle, lost = trace.apply(followed, "{}", v[:3], found[:4], size, s)
    w, half = Vector(*re), trace.vector("shift", Vector(*found[4:]) / 2)
    return w, shifted(trace, fe, lost, w, half, (*v[3:], *delta[3:])), angle, half


def shifted(
    trace: Geometry, fe: Number, lost: Number, v: Vector, half: Vector, terms: Sequence[Number]
) -> Number:
    """Return f_i; it is infinite where no v has the pose, a translation across the axis at a whole turn.

    The translation is rounding noise there if it is noise beside its terms.
    """
    if trace.real:
        return fe
    across, size = (sum(map(trace.abs, group), start=0) for group in (v.cross(half), terms))
    scale = trace.name("scale", size)
    adrift = trace.name("adrift", trace.less(scale, trace.beside(scale, lost * across / NOISE_OF_STEPS)))
    return trace.name("fen", fe / trace.where(adrift, 0, 1))


def exponential_scalars(trace: Geometry) -> Results:
    """Scalars of exp(δ) at x = δ·δ: q̂ = s + w δ, f = 2 s w, g = 2 w², h, and slopes fy, gy, hy."""
    first, second, third = Point(trace, (*trace.real_vector("delta", "d"), 0, 0, 0)).squares
    at = StepScalars(trace.name("x", first + second + third), trace)
    return {name: getattr(at, name) for name in SCALARS}


def followed(trace: Geometry) -> Results:
    """Vector of a quaternion e on the branch nearest v, f_i there, the number of its angle, and 1 at a whole turn.

    The quaternion has a size; turn is the scalar part of the step.
    """
    v = trace.real_vector("v")
    e = Quaternion.from_components(trace.components("e", "e", 4))
    size, turn = trace.numbers("size", "turn")
    along = trace.name("along", v.dot(e.vector))
    of_e, of_v, *rest = trace.ask("followed", (Point(trace, (*v, 0, 0, 0)).x, along, *e, size, turn))
    results = (*trace.inside(of_e * e.vector + of_v * v), *rest)
    return dict(zip(("w1", "w2", "w3", "fe", "known", "lost"), results, strict=True))


def logarithm(trace: Geometry) -> Results:
    """Logarithm δ of a displacement, from a positive multiple e, of a given size, of the quaternion of exp(δ).

    The dual part is T⁻¹ ρ.
    """
    e = Quaternion.from_components(trace.components("e", "e", 4))
    (size,) = trace.numbers("size")
    rho = trace.real_vector("rho", dual="°")
    ss = e.vector.dot(e.vector)
    factor = trace.name("factor", EXPONENTIAL.gain(e, size, trace) + (ss - ss))  # NaN where the square overflows
    re = trace.vector("d", factor * e.vector)
    first, second, third = Point(trace, (*re, 0, 0, 0)).squares
    at = PrincipalScalars(trace.name("x", first + second + third), trace)
    fe = trace.name("fe", factor * e.scalar)
    return *re, *dual_part(trace, fe, at.hi, re, rho / 2)


def retract(trace: Geometry) -> Results:
    """Vector of exp(δ) R(v), on the branch nearest v."""
    v, delta = trace.components("v", "v", 6), trace.components("delta", "d", 6)
    s, w, f, g, h, *_ = trace.apply(exponential_scalars, "{}", delta[:3])
    re, fi, angle, half = retracted(trace, (s, w, f, g, h), delta, v)
    hi, ai = trace.ask("inverse_at", (Point(trace, (*re, 0, 0, 0)).x, fi, angle))
    return *re, *dual_part_at(trace, fi, hi, ai, re, half)


def body_retract(trace: Geometry) -> Results:
    """Vector of R(v) exp(δ), on the branch nearest v: −w for the vector w of exp(−δ) R(−v)."""
    v, delta = trace.components("v", "v", 6), trace.components("delta", "d", 6)
    return opposite(trace.apply(retract, "w{}", opposite(v), opposite(delta)))


def retract_jacobians(trace: Geometry) -> Results:
    """Derivatives T(w)⁻¹ exp(δ) T(v) and T(w)⁻¹ dexp(δ) of w = retract(v, δ), by v and by δ."""
    v, delta = trace.components("v", "v", 6), trace.components("delta", "d", 6)
    s, w, f, g, h, *slopes = trace.apply(exponential_scalars, "{}", delta[:3])
    re, fe, angle, half = retracted(trace, (s, w, f, g, h), delta, v)
    fi, hi, ai, fiy, hiy = trace.ask("tangent_inv_at", (Point(trace, (*re, 0, 0, 0)).x, fe, angle))
    du = dual_part_at(trace, fi, hi, ai, re, half)
    back = trace.apply(tangent_inverse_at, "back{}", fi, hi, fiy, hiy, (*re, *du))
    R = trace.apply(tensor_at, "R{}", f, g, h, delta)
    turned = trace.apply(dual_product, "RT{}", R, trace.apply(tangent, "T{}", v))
    dexp = trace.apply(tangent_at, "dexp{}", f, g, h, *slopes, delta)
    by_v, by_delta = (trace.apply(dual_product, letter, back, D) for letter, D in (("D1{}", turned), ("D2{}", dexp)))
    return *trace.apply(matrix6, "by_v{}", by_v), *trace.apply(matrix6, "by_delta{}", by_delta)


def body_retract_jacobians(trace: Geometry) -> Results:
    """Derivatives T(w)⁻¹ T(v) and T(w)⁻¹ R(v) dexp(δ) of w = −retract(−v, −δ), by v and by δ."""
    v, delta = trace.components("v", "v", 6), trace.components("delta", "d", 6)
    return trace.apply(retract_jacobians, "J{}", opposite(v), opposite(delta))


def local(trace: Geometry) -> Results:
    """Step δ from v1 to v2 in space, exp(δ) = R(v2) R(v1)⁻¹."""
    v2, v1 = trace.components("v2", "b", 6), trace.components("v1", "a", 6)
    e, rho, size = product(trace, v2, opposite(v1))
    return trace.apply(logarithm, "d{}", e, size, rho)


def body_local(trace: Geometry) -> Results:
    """Step δ from v1 to v2 in the body, exp(δ) = R(v1)⁻¹ R(v2) = R(−v1) R(−v2)⁻¹."""
    v2, v1 = trace.components("v2", "b", 6), trace.components("v1", "a", 6)
    return trace.apply(local, "d{}", opposite(v1), opposite(v2))


def local_jacobians(trace: Geometry) -> Results:
    """Derivatives dexp(δ)⁻¹ T(v2) and −dexp(−δ)⁻¹ T(v1) of δ = local(v2, v1), by v2 and by v1."""
    v2, v1 = trace.components("v2", "b", 6), trace.components("v1", "a", 6)
    return trace.apply(step_jacobians, "J{}", trace.apply(local, "d{}", v2, v1), v2, v1)


def body_local_jacobians(trace: Geometry) -> Results:
    """Derivatives dexp(−δ)⁻¹ T(−v2) and −dexp(δ)⁻¹ T(−v1) of δ = body_local(v2, v1), by v2 and by v1."""
    v2, v1 = trace.components("v2", "b", 6), trace.components("v1", "a", 6)
    delta = trace.apply(body_local, "d{}", v2, v1)
    return trace.apply(step_jacobians, "J{}", *map(opposite, (delta, v2, v1)))


def step_jacobians(trace: Geometry) -> Results:
    """Matrices dexp(δ)⁻¹ T(v2) and −dexp(−δ)⁻¹ T(v1), where dexp(−δ) is the transpose of dexp(δ)."""
    # in space T(v2) v̇2 − exp(δ) T(v1) v̇1 = dexp(δ) δ̇; in the body with opposite signs of all vectors
    delta = trace.components("delta", "d", 6)
    v2, v1 = trace.components("v2", "b", 6), trace.components("v1", "a", 6)
    at = EXPONENTIAL.scalars(0, trace)
    vars(at).update(zip(SCALARS, trace.apply(exponential_scalars, "{}", delta[:3]), strict=True))
    back = trace.apply(tangent_inverse_at, "back{}", at.fi, at.hi, at.fiy, at.hiy, delta)
    turned = dual_tensor(opposite(back)).transpose
    found: list[Number] = []
    for place, D, v in (("2", back, v2), ("1", (*turned.re, *turned.du), v1)):
        product = trace.apply(dual_product, f"D{place}{{}}", D, trace.apply(tangent, f"T{place}{{}}", v))
        found += trace.apply(matrix6, f"by_v{place}{{}}", product)
    return found


HALF_TURN = 3
"""Bound of α at v1, in rad. A motion that begins below it and ends before a whole turn passes through no whole turn."""

OWN_AXIS = 64
"""Limit of δ × v in units of |v| eps/2. Smaller values count as 0: the rounding of two quaternions and their product
stays below this limit."""


def interpolate(trace: Geometry) -> Results:
    """Vector v of exp(t δ) R(v1) with exp(δ) = R(v2) R(v1)⁻¹, on the branch followed from v1."""
    v1, v2 = trace.components("v1", "a", 6), trace.components("v2", "b", 6)
    (t,) = trace.inputs("time", ("t",))
    delta = trace.apply(local, "d{}", v2, v1)
    step = [trace.name(f"td{place}", t * c) for place, c in zip(LAYOUTS[6], delta, strict=True)]
    s, w, f, g, h, *_ = trace.apply(exponential_scalars, "{}", step[:3])
    *first, _, _, _, r1, r2, r3 = trace.apply(displacement, "{}_1", v1)
    small = (s, *trace.vector("wd", w * Vector(*step[:3])))
    rho = translation(Point(trace, step, "t"), f, g, h)
    found = trace.apply(composed, "{}", small, f, g, step, rho, first, (r1, r2, r3))
    before = Point(trace, v1, "a")
    followed = _Followed(trace, before, Quaternion.from_components(first), Vector(*delta[:3]), Vector(*step[:3]))
    return followed.vector(Quaternion.from_components(found[:4]), Vector(*found[4:]), (*v1[3:], *step[3:]))


class _Followed:
    """Branch of v that is followed from v1 while the quaternion turns about the axis of δ."""

    def __init__(self, trace: Geometry, start: Point, first: Quaternion, delta: Vector, gone: Vector) -> None:
        self.trace = trace
        name, where = trace.name, trace.where
        resting = name("resting", trace.equal(start.x, 0))
        r = name("r", trace.sqrt(where(resting, 1 + start.x, start.x)))
        (own,) = trace.ask("unfolded", (start.x, r))
        self.own = name("alpha", where(resting, start.x, own))
        along = trace.vector("along", start.re / r)
        # normalize again: if the square of v is subnormal, its root has few digits
        unit = name("unit", trace.sqrt(where(resting, r, along.dot(along))))
        self.axis = trace.vector("axis", along / unit)
        self.gone = name("gone", gone.dot(self.axis))
        end = name("end", trace.abs(self.own + self.gone))
        inside = trace.both(trace.less(self.own, HALF_TURN), trace.either(resting, trace.less(25 * end, 157)))
        across = sum(map(trace.abs, delta.cross(start.re)), start=0)
        self.apart = name("apart", trace.either(inside, trace.less(r, trace.beside(r, across / OWN_AXIS))))
        self.side = name("side", where(trace.less(first.vector.dot(start.re), 0), -1, 1))
        _, self.begun = self._half(first, "1")

    def _half(self, q: Quaternion, mark: str) -> tuple[Number, Number]:
        """Return the signed ``sin(α/2)`` along the followed axis, and α/2 up to whole turns."""
        trace, name = self.trace, self.trace.name
        ss = name("ss" + mark, q.vector.dot(q.vector))
        still = name("still" + mark, trace.equal(ss, 0))
        # never take the root of 0: its infinite slope times 0 would spoil the gradient; NaN where the square overflows
        root = name("root" + mark, trace.sqrt(trace.where(still, 1 + ss, ss)) + (ss - ss))
        length = trace.where(still, ss, self.side * root)
        sine = name("sine" + mark, trace.where(self.apart, length, q.vector.dot(self.axis)))
        sign = name("sign" + mark, trace.where(self.apart, self.side, 1))
        return sine, name("half" + mark, trace.atan2(sign * sine, sign * q.scalar))

    def vector(self, z: Quaternion, rho: Vector, terms: Sequence[Number]) -> tuple[Number, ...]:
        """Return v of the quaternion z and the translation rho, which is computed from the terms."""
        trace, name, where = self.trace, self.trace.name, self.trace.where
        sine, half = self._half(z, "t")
        turns = name("turns", self.own + where(self.apart, -2 * self.begun, self.gone - 2 * half))
        near = name("first", trace.less(trace.abs(turns), 1))
        whole = where(near, 0, turns)  # a multiple of 2π, up to rounding
        principal = name("principal", trace.either(self.apart, near))
        still = name("still", trace.both(trace.equal(sine, 0), principal))
        angle = name("angle", where(still, sine, whole + 2 * half))
        size, slope, known = trace.ask("coefficient_of", (angle, sine, z.scalar), "n")
        cosine, length = name("cosine", trace.abs(z.scalar)), name("length", trace.abs(sine))
        lost = name("lost", where(principal, 0, at_turn(sine, cosine, size, trace)))
        # use the vector part even if its square underflows to 0
        below = where(still, z.scalar, where(name("sharp", trace.equal(lost, 0)), sine, cosine / SMALL))
        factor = name("factor", where(still, 2 * slope, size) / name("below", below))
        # near whole turns take the axis of v1; elsewhere the axis of z is as accurate and has the slope of the motion
        clear = name("clear", trace.either(self.apart, trace.less(cosine, length)))
        pairs = zip(factor * z.vector, size * self.axis, strict=True)
        re = trace.vector("v_", trace.inside(Vector(*(where(clear, one, other) for one, other in pairs))))
        shift = trace.vector("shift", rho / 2)
        fi = shifted(trace, name("fe", factor * z.scalar), lost, re, shift, terms)
        hi, ai = trace.ask("inverse_at", (Point(trace, (*re, 0, 0, 0), "w").x, fi, known))
        return (*re, *dual_part_at(trace, fi, hi, ai, re, shift))
