"""Tangent operator and its inverse: as dual tensors, and applied to rates and twists in either frame.

Both operators have the form ``a I + skew(s) + c v⊗v``, where s is a multiple of v. The dual part of a scalar is its
slope times y = v·v°. Body forms are the transposes, which differ only in the sign of s, given by ``side``.
"""

from __future__ import annotations

from ...algebra import Tensor, Vector
from ..programs.program import Number
from .point import Geometry, Results


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
