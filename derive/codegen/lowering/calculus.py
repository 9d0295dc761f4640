"""Derivatives of the tangent operator and its inverse, by time and by v, in dual numbers.

The scalars are f, g, h of ``T = f I + side (g skew(v)) + h v⊗v`` and fi, hi of
``2 T⁻¹ = fi I − side skew(v) + hi v⊗v``, with slopes such as ``df = fy v·dv``. The side is 1 in space and −1 in the
body. A derivative by v is a dual tensor, returned as the real matrix with the same action on dual vectors.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from ...algebra import Dual, Tensor, Vector
from ..programs.program import Number
from .point import NINE, TABLE, Geometry, Results, dual_tensor


def assembled(trace: Geometry, a: Number, s: Vector, diagonal: Vector, off: tuple[Number, ...]) -> Tensor:
    """Return a I + skew(s) plus the symmetric tensor with this diagonal and the entries 12, 13, 23 in ``off``."""
    s1, s2, s3 = s
    d11, d22, d33 = (a + entry for entry in diagonal)
    d12, d13, d23 = (trace.name(name, entry) for name, entry in zip(("d12", "d13", "d23"), off, strict=True))
    return Tensor(((d11, d12 - s3, d13 + s2), (d12 + s3, d22, d23 - s1), (d13 - s2, d23 + s1, d33)))


def tangent_at(trace: Geometry) -> Results:
    """Tangent operator T = f I + g skew(v) + h v⊗v, CP23 (88).

    fy = 2 df/dx, gy and hy give the dual parts: that of f is fy v·v°.
    """
    f, g, h, fy, gy, hy = trace.numbers("f", "g", "h", "fy", "gy", "hy")
    point = trace.point()
    f, g, h = point.lift("f", f, fy), point.lift("g", g, gy), point.lift("h", h, hy)
    s, (c1, c2, c3), (v1, v2, v3) = trace.vector("gv", point.v * g), trace.vector("hv", point.v * h), point.v
    tensor = assembled(trace, f, s, Vector(c1 * v1, c2 * v2, c3 * v3), (c1 * v2, c1 * v3, c2 * v3))
    return *tensor.re, *tensor.du


def tangent_inverse_at(trace: Geometry) -> Results:
    """Inverse tangent operator T⁻¹ = (fi I − skew(v) + hi v⊗v)/2, CP23 (89).

    fiy = 2 dfi/dx and hiy give the dual parts: that of fi is fiy v·v°.
    """
    fi, hi, fiy, hiy = trace.numbers("fi", "hi", "fiy", "hiy")
    point = trace.point()
    fi, hi = point.lift("fi", fi, fiy), point.lift("hi", hi, hiy)
    # halve v, not fi or hi, which are integers in some charts
    half = trace.vector("half", point.v / 2)
    (c1, c2, c3), (v1, v2, v3) = trace.vector("hv", point.v * hi), point.v
    _, second, third = half
    diagonal = Vector(*((fi + c * v) / 2 for c, v in ((c1, v1), (c2, v2), (c3, v3))))
    tensor = assembled(trace, 0, -half, diagonal, (c1 * second, c1 * third, c2 * third))
    return *tensor.re, *tensor.du


def tangent(trace: Geometry) -> Results:
    """Tangent operator T = f I + g skew(v) + h v⊗v, CP23 (88)."""
    point = trace.point()
    return trace.apply(tangent_at, "T{}", *point.scalars("tangent_scalars"), point.components)


def body_tangent(trace: Geometry) -> Results:
    """Transposed tangent operator Tᵀ, which is T at −v, CP23 (86)."""
    point = trace.point()
    return trace.apply(tangent_at, "T{}", *point.scalars("tangent_scalars"), opposite(point.components))


def tangent_inv(trace: Geometry) -> Results:
    """Inverse tangent operator T⁻¹ = (fi I − skew(v) + hi v⊗v)/2, CP23 (89)."""
    point = trace.point()
    return trace.apply(tangent_inverse_at, "T{}", *point.scalars("tangent_inv_scalars"), point.components)


def body_tangent_inv(trace: Geometry) -> Results:
    """Transposed inverse tangent operator T⁻ᵀ, which is T⁻¹ at −v, CP23 (91)."""
    point = trace.point()
    return trace.apply(tangent_inverse_at, "T{}", *point.scalars("tangent_inv_scalars"), opposite(point.components))


def opposite(v: tuple[Number, ...]) -> tuple[Number, ...]:
    return tuple(-component for component in v)


def twist(trace: Geometry) -> Results:
    """Twist T v̇ = f v̇ + side g v × v̇ + h (v·v̇) v, CP23 (86); side −1 gives the body twist Tᵀ v̇."""
    point, w = trace.point(), trace.point("v_dot", "w").v
    (side,) = trace.inputs("table", ("side",))
    f, g, h = point.lifted("tangent_scalars", ("f", "g", "h"))
    s = trace.vector("gv", trace.name("gs", g * side) * point.v)
    scale = trace.name("hvw", h * trace.name("vw", point.v.dot(w)))
    image = f * w + s.cross(w) + scale * point.v
    return *image.re, *image.du


def rate(trace: Geometry) -> Results:
    """Rate T⁻¹ ω = (fi ω − side v × ω + hi (v·ω) v)/2, CP23 (87), (90); side −1 gives T⁻ᵀ ω of a body twist.

    The table holds side and half = side/2; half multiplies ``side fi ω − v × ω + side hi (v·ω) v``.
    """
    point, w = trace.point(), trace.point("omega", "w").v
    side, half = trace.inputs("table", ("side", "half"))
    fi, hi = point.lifted("tangent_inv_scalars", ("fi", "hi"))
    scale = trace.name("hvw", trace.name("his", hi * side) * trace.name("vw", point.v.dot(w)))
    image = trace.name("fis", fi * side) * w - point.v.cross(w) + scale * point.v
    return *(half * image.re), *(half * image.du)


HALF, QUARTER = Fraction(1, 2), Fraction(1, 4)


def tangent_dot(trace: Geometry) -> Results:
    """Time derivative of T, ``ḟ I + side skew(ġ v + g v̇) + v⊗c + c⊗v``, c = ḣ/2 v + h v̇."""
    point, w = trace.point(), trace.point("v_dot", "w").v
    (side,) = trace.inputs(TABLE, ("side",))
    g, h, fy, gy, hy = point.lifted("tangent_dot_scalars", ("g", "h", "fy", "gy", "hy"))
    v, along = point.v, trace.name("vw", point.v.dot(w))
    s = trace.vector("s", (trace.name("gt", gy * along) * v + trace.vector("gw", g * w)) * side)
    c = trace.vector("b", trace.name("ht", hy * along * HALF) * v + trace.vector("hw", h * w))
    (v1, v2, v3), (c1, c2, c3) = v, c
    diagonal = Vector(2 * (v1 * c1), 2 * (v2 * c2), 2 * (v3 * c3))
    off = (v1 * c2 + c1 * v2, v1 * c3 + c1 * v3, v2 * c3 + c2 * v3)
    tensor = assembled(trace, trace.name("ft", fy * along), s, diagonal, off)
    return *tensor.re, *tensor.du


def twist_dot(trace: Geometry) -> Results:
    """Time derivative of T v̇, ``f v̈ + (fy + h) a v̇ + side v × (g v̈ + gy a v̇) + (h (v·v̈ + v̇·v̇) + hy a²) v``, a = v·v̇."""
    point, w, z = trace.point(), trace.point("v_dot", "w").v, trace.point("v_ddot", "z").v
    (side,) = trace.inputs(TABLE, ("side",))
    f, g, h, fy, gy, hy = point.lifted("tangent_dot_scalars", ("f", "g", "h", "fy", "gy", "hy"))
    v, along = point.v, trace.name("vw", point.v.dot(w))
    turned = trace.vector("gz", g * z + trace.name("gt", gy * along) * w)
    pull, bend = trace.name("pull", v.dot(z) + _square(w)), trace.name("ht", hy * along)
    scale, drift = trace.name("cvv", h * pull + bend * along), trace.name("fh", trace.name("fyh", fy + h) * along)
    found = f * z + drift * w + v.cross(trace.vector("s", turned * side)) + scale * v
    return *found.re, *found.du


def screw_twist(trace: Geometry) -> Results:
    """Twist ``T d = (f + h x) d`` of a step d on the screw of v, and its derivative by s where v = s d."""
    point, d = trace.point(), trace.point("d").v
    f, h, fy, hy = point.lifted("tangent_dot_scalars", ("f", "h", "fy", "hy"))
    x, along = Dual(point.x, trace.name("yy", 2 * point.y)), trace.name("along", point.v.dot(d))
    slope = trace.name("slope", trace.name("bend", fy + 2 * h + hy * x) * along)
    found, change = trace.name("rate", f + h * x) * d, slope * d
    return *found.re, *found.du, *change.re, *change.du


def rate_dot(trace: Geometry) -> Results:
    """Time derivative of the rate v̇ = T⁻¹ ω: ``T⁻¹ ω̇ + (d/dt T⁻¹) ω``, in products of v, ω and ω̇ without v̇.

    Let a = v·ω, s = hi a and 2 v̇ = fi ω + side ω × v + s v. The result is half of
    ``fi ω̇ + side (ω̇ + s ω) × v + (fiy b + a + s fi)/2 ω + (hi (2 v·ω̇ + 2 a s + fi ω²) + hiy a b − ω²)/2 v``,
    where b = 2 v·v̇ = fi a + s v², since side² = 1 and ω × (ω × v) = a ω − ω² v.
    """
    point, w, z = trace.point(), trace.point("omega", "w").v, trace.point("omega_dot", "z").v
    (side,) = trace.inputs(TABLE, ("side",))
    fi, hi, fiy, hiy = point.lifted("tangent_inv_dot_scalars", ("fi", "hi", "fiy", "hiy"))
    v, along, length = point.v, trace.name("vw", point.v.dot(w)), trace.name("ww", _square(w))
    spread, half = trace.name("hvw", hi * along), trace.name("hs", side * HALF)
    change = trace.name("vu", trace.name("fvw", fi * along) + spread * Dual(point.x, 2 * point.y))
    pull = trace.name("pull", 2 * (v.dot(z) + spread * along) + fi * length)
    drift = trace.name("ft", (fiy * change + along + spread * fi) * QUARTER)
    bend = trace.name("ht", hiy * change)
    scale = trace.name("cvv", (hi * pull + bend * along - length) * QUARTER)
    turned = trace.vector("s", z + spread * w).cross(v) * half
    found = fi * trace.vector("zh", z * HALF) + drift * w + turned + scale * v
    return *found.re, *found.du


def twist_jacobian(trace: Geometry) -> Results:
    """Derivative of the twist T w by v, at constant w = v̇.

    The formula is ``(fy w + side gy v × w + hy (v·w) v)⊗v + h (v⊗w + (v·w) I) − side g skew(w)``,
    where v⊗w = w⊗v − skew(v × w).
    """
    point, w = trace.point(), trace.point("v_dot", "w").v
    (side,) = trace.inputs(TABLE, ("side",))
    g, h, fy, gy, hy = point.lifted("tangent_dot_scalars", ("g", "h", "fy", "gy", "hy"))
    v, along = point.v, trace.name("vw", point.v.dot(w))
    turned, gs = trace.vector("t", v.cross(w)), trace.name("gs", g * side)
    pull, turn, bend = trace.name("fh", fy + h), trace.name("gt", gy * side), trace.name("ht", hy * along)
    image = trace.vector("b", pull * w + turn * turned + bend * v)
    s = trace.vector("s", gs * w + h * turned)
    return _jacobian(trace, Tensor.dyad(image, v), trace.name("ha", h * along), -s)


def rate_jacobian(trace: Geometry) -> Results:
    """Derivative of the rate T⁻¹ w by v, at constant w = ω.

    The formula is half of ``(fiy w + hiy (v·w) v)⊗v + hi (v⊗w + (v·w) I) + side skew(w)``. With
    w⊗v = v⊗w − skew(w × v) one dyad is left, v⊗b, which is 0 where fiy = −hi, as for n = 2.
    """
    point, w = trace.point(), trace.point("omega", "w").v
    (side,) = trace.inputs(TABLE, ("side",))
    half_side = trace.name("hs", side * HALF)
    hi, fiy, hiy = point.lifted("tangent_inv_dot_scalars", ("hi", "fiy", "hiy"))
    # halve w, not the scalars, which are integers in some charts
    v, half = point.v, trace.vector("wh", w * HALF)
    along = trace.name("vwh", v.dot(half))
    image = trace.vector("b", trace.name("fh", hi + fiy) * half + trace.name("ht", hiy * along) * v)
    s = trace.vector("s", half_side * w - fiy * trace.vector("t", half.cross(v)))
    a = trace.name("ha", hi * along)
    return _jacobian(trace, Tensor.dyad(v, image), a, s)


def _jacobian(trace: Geometry, dyad: Tensor, a: Number, s: Vector) -> Results:
    """Return the entries of a dyad plus ``a I + skew(s)``."""
    spread = Tensor.skew(s) + Tensor(((a, 0, 0), (0, a, 0), (0, 0, a)))
    return entries6(trace, dyad + spread)


def matrix6(trace: Geometry) -> Results:
    """Real matrix [[Re D, 0], [Du D, Re D]] of a dual tensor D, with the same action on dual vectors."""
    return entries6(trace, dual_tensor(trace.components("D", "D", 18)))


def entries6(trace: Geometry, tensor: Tensor) -> Iterator[Number]:
    """Yield the entries of the real matrix of a dual tensor, as in `matrix6`."""
    re = list(tensor.re)
    if not trace.real:  # each entry occurs twice, so it needs a name
        re = [trace.name(f"J{place}", entry) for place, entry in zip(NINE, re, strict=True)]
    du = list(tensor.du)
    for i in (0, 3, 6):
        yield from (*re[i : i + 3], 0, 0, 0)
    for i in (0, 3, 6):
        yield from (*du[i : i + 3], *re[i : i + 3])


def _square(w: Vector) -> Dual:
    return Dual(w.re.dot(w.re), 2 * w.re.dot(w.du))
