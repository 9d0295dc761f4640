"""Section 4, the conclusion: lines 254-265."""

from .. import k10_definitions as k10
from . import *
from .s3a_rodrigues import f, f_, f_hat, forward
from .s3b_components import SCREW, equations, relation, solution

b1_, right_22 = equations["22"]

RESTATED = (
    relation("conclusion-22", "dual Rodrigues parameter b1*, restated", 256,
             (Reading(equal(b1_, right_22), "with the star of f"),
              Reading(equal(b1_, right_22.xreplace({f_: f})), "without",
                      supported_by="line 256 itself, where the other stars are legible")),
             extract=shown(r"b_1^* = s_1^* Tan \frac{f}{2} + s_1 \frac{f}{2} (1 + Tan^2 \frac{f}{2})"),
             where=SCREW, lost="*", condition=forward, fixed_by="(22), line 247, and (20), (21) beside it: f*/2",
             remark="f/2 as it is legible there is wrong; whether its star was printed cannot be told."),
    solution("20", 259, 2, restated=True), solution("21", 262, 3, restated=True),
)

# ---- the lines of figure 2 ------------------------------------------------------------------------------------

axis = Symbol("axis", "unit vector", r"\hat{s}")
before, after = Symbol("l_a", "unit vector", "l_a"), Symbol("l_b", "unit vector", "l_b")
POSITIONS = (let(f_hat, from_parts, f, f_), let(after, k10.turned, before, f_hat, axis))

LINES = (
    equation("positions", "f̂ is the dual angle of two positions of a line of the body", 265,
             equal(dot(before, after), cos(f_hat)), where=POSITIONS,
             condition=implies(nonzero(1 - cos(f)), zero(Re(dot(before, axis)))), also=k10.crossing_lines(before, axis),
             because=equal(dot(before, after), cos(f_hat) + (1 - cos(f_hat)) * dot(before, axis)**2),
             remark="Only of lines at right angles to the screw axis. For any other line "
             "l_a · l_b = cos f̂ + (1 − cos f̂)(l_a · ŝ)²."),
)

ENTRIES = (*RESTATED, *LINES)
