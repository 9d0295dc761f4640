"""Section 1, dual vectors, their norm, and lines: lines 21-23 and 43-49."""

from ....algebra import Vector
from ....maps import pose as poses
from .. import k10_definitions as k10
from . import *

# ---- vectors --------------------------------------------------------------------------------------------------

v_hat, w_hat, u_hat = (hat(name, "dual vector") for name in "vwu")
v, v_ = arrow("v"), arrow("v", star=True)
a_hat, b_hat = (hat(name, "dual number") for name in "ab")
six = tuple(real("v", index, star) for star in (False, True) for index in (1, 2, 3))
v1, v2, v3, v1_, v2_, v3_ = six
size, axis = Symbol("size", "dual number"), Symbol("axis", "unit vector")
POLAR = (let(v_hat, multiple, size, axis), let(v, real_of, v_hat), let(v_, dual_of, v_hat))
unit_hat = hat("v", "unit vector")
UNIT = (let(v, real_of, unit_hat), let(v_, dual_of, unit_hat))
vr, vr_ = arrow("v", seen_as="r"), arrow("v", star=True, seen_as="r*")
SEEN = (let(vr, real_of, v_hat), let(vr_, dual_of, v_hat))

VECTORS = (
    equation("dual-vector", "dual vectors", 43, equal(v_hat, v + e * v_), extract=shown(
             r"\hat{v} = \stackrel{\mathbf{r}}{v} + \stackrel{\mathbf{r}}{e}v^*"), where=POLAR),
    equation("module", "dual vectors are a module over the dual numbers", 43,
             both(equal(a_hat * (v_hat + w_hat), a_hat * v_hat + a_hat * w_hat),
                  equal((a_hat + b_hat) * v_hat, a_hat * v_hat + b_hat * v_hat),
                  equal(group(a_hat * b_hat) * v_hat, a_hat * group(b_hat * v_hat)), equal(1 * v_hat, v_hat),
                  equal(v_hat + w_hat, w_hat + v_hat),
                  equal(group(v_hat + w_hat) + u_hat, v_hat + group(w_hat + u_hat)))),
    equation("dimension", "real dimension 6", 45,
             both(equal(v_hat, column(v1, v2, v3) + e * column(v1_, v2_, v3_)),
                  iff(zero(v_hat), both(*(zero(c) for c in six)))),
             where=(let(v_hat, plain(lambda *six: Vector.dual(six[:3], six[3:])), *six),),
             also=lambda draw: {"v̂ = 0": dict.fromkeys(six, draw.real() * 0)},
             remark="Six real coordinates; only all of them zero give the zero vector."),
    equation("degenerate", "the scalar product is degenerate", 45, equal(dot(group(e * v_hat), group(e * w_hat)), 0),
             remark="As a real form: what is left of two vectors without real parts is 0."),
    equation("norm", "norm of a dual vector", 47,
             equal(length(v_hat), square_root(dot(v_hat, v_hat)), square_root(dot(vr, vr) + (2 * e * dot(v, vr_))),
                   length(v) * square_root(group(1 + e * (dot(vr, vr_) / length(v)**2))**2),
                   length(v) + e * (dot(vr, vr_) / length(v)), parts(length(v), dot(vr, vr_) / length(v))),
             extract=shown(r"\left\| \hat{v} \right\| &= \left(\hat{v} \cdot \hat{v} \right)^{\frac{1}{2}} = "
                           r"\left(\mathbf{r} \cdot \mathbf{r} + 2\mathbf{e}\mathbf{v} \cdot \mathbf{r}^* "
                           r"\right)^{\frac{1}{2}} \\ &= \left\| \mathbf{v} \right\| \left[\left(1 + \mathbf{e} "
                           r"\frac{\mathbf{r} \cdot \mathbf{r}^*}{\left\| \mathbf{v} \right\|^2} \right)^2 "
                           r"\right]^{\frac{1}{2}} \\ &= \left\| \mathbf{v} \right\| + \mathbf{e} \frac{\mathbf{r} "
                           r"\cdot \mathbf{r}^*}{\left\| \mathbf{v} \right\|} = \left(\left\| \mathbf{v} \right\|, "
                           r"\frac{\mathbf{r} \cdot \mathbf{r}^*}{\left\| \mathbf{v} \right\|} \right)"),
             where=(*POLAR, *SEEN), condition=nonzero(v),
             remark="The extraction shows an arrow over v as r. Where v = 0 the norm is e ‖v*‖."),
    equation("unit", "the norm 1", 49, equal(1, parts(Number(1), Number(0))), extract=shown("1 = (1,0)")),
    equation("unit-vector", "dual unit vectors", 49, both(equal(length(v), 1), zero(dot(v, v_))),
             extract=shown(r"\|v\| = 1 v \cdot v^* = 0"), where=UNIT),
)

# ---- lines ----------------------------------------------------------------------------------------------------

l_a, l_b = hat("a", "unit vector"), hat("b", "unit vector")
direction, moment = arrow("a"), arrow("a", star=True)
foot = arrow("p")
frame = Symbol("Q", "orthogonal tensor")
f, f_, f_hat = real("f", quantity="real angle"), real("f", star=True), hat("f", "angle")
normal = Symbol("normal", "unit vector")
distance = Symbol("distance", "real", r"d\left(l_a, l_b\right)")
angle = Symbol("angle", "real", r"\angle\left(l_a, l_b\right)")
ONE = Symbol("one", "number")
LINES = (
    let(ONE, lambda env: 1), let(f_hat, from_parts, f, f_), let(normal, k10.axis_of, frame),
    let(l_a, k10.across, ONE, frame), let(l_b, k10.turned, l_a, f_hat, normal),
    let(distance, k10.distance, l_a, l_b), let(angle, k10.angle_between, l_a, l_b),
)

STUDY = (
    equation("study", "points of the dual unit sphere are oriented lines", 23,
             both(equal(length(direction), 1), equal(cross(foot, direction), moment)),
             where=(let(direction, real_of, l_a), let(moment, dual_of, l_a), let(foot, plain(poses.foot), l_a)),
             remark="The line through p with direction a. Every line is two points, one for each orientation."),
    equation("study-product", "scalar product of lines at the dual angle", 23, equal(dot(l_a, l_b), cos(f_hat)),
             where=LINES),
    equation("study-angle", "f is the angle of the lines", 23, equal(f, angle), where=LINES,
             condition=at_least(pi, f, 0), remark="The angle of two directions is at most π."),
    equation("study-distance", "f* is the distance of the lines", 23, equal(f_, distance), where=LINES,
             condition=at_least(f_, 0), remark="A distance has no sign: it is |f*|."),
)

ENTRIES = (*VECTORS, *STUDY)
