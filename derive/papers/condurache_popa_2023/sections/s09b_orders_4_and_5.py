"""Section 9, explicit formulas for orders 4 and 5: lines 441-456."""

from __future__ import annotations

import mpmath

from ...equation import equation
from ...language.notation import *
from ..symbols import X, u, v
from .s07_general_order import VV, I, R, V, finite, q_hat, x
from .s09a_orders_1_to_3 import ROOT, Order, branch_of, branch_range

x2 = norm(v) ** 4

o4 = Order(4)
p4, q4 = 1 - 6 * x + x2, 4 * (1 - x)
FOURTH = (
    equation("113", "Rodrigues dual vectors, n = 4", 442, remark(equal(v, tan(branch_of(4)) * u), branch_range(4)),
             extract="v _ = t a n α _ + 2 k π 8 u _ ; k = 0,3", where=o4.preimage, condition=finite(branch_of(4)),
             branches=4),
    equation("114", "p₄", 443, equal(o4.p(X), 1 - 6 * X**2 + X**4), extract="p 4 X = 1 6 X 2 + X 4", where=o4.where),
    equation("115", "q₄", 444, equal(o4.q(X), 4 - 4 * X**2), extract="q 4 X = 4 4 X 2", where=o4.where),
    equation("116", "unit dual quaternion, n = 4", 445, equal(pm(q_hat), 1 / (1 + x) ** 2 * (p4 + q4 * v)),
             extract="± q ^ _ = 1 1 _ + v _ 2 2 1 6 v _ 2 + v _ 4 + 4 1 v _ 2 v _", where=o4.where),
    equation("117", "orthogonal dual tensor, n = 4", 446,
             equal(R, I + 8 * (1 - x) / (1 + x) ** 4 * (p4 * V + q4 * V**2)),
             extract="R _ = I _ + 8 1 v _ 2 1 + v _ 2 4 1 6 v _ 2 + v _ 4 v ~ _ + 4 1 v _ 2 v ~ _ 2", where=o4.where),
    equation("118", "tangent operator, n = 4", 447,
             equal(o4.dcay, 8 / (1 + x) ** 4 * (p4 * (1 - x) * I + q4 * V + (x2 - 3 * x + 10) * VV)),
             extract="d c a y 4 = 8 1 + v _ 2 4 1 6 v _ 2 + v _ 4 1 v _ 2 I _ + 4 1 v _ 2 v ~ _ "
                     "+ v _ 4 3 v _ 2 + 10 v _ v _",
             where=o4.where,
             remark="Contradicts (88) at n = 4 in the factors of ṽ and v ⊗ v.",
             corrected=equal(o4.dcay, 8 / (1 + x) ** 4 * (p4 * (1 - x) * I + 4 * (1 - x) ** 2 * V
                                                          + (2 * x2 - 4 * x + 10) * VV))),
    equation("119", "kinematic tensor, n = 4", 448,
             equal(o4.dcay_inv, p4 / (8 * (1 - x)) * I - half * V - (8 * x + 3) / (8 * (1 - x)) * VV),
             extract="d c a y 4 1 = 1 6 v _ 2 + v _ 4 8 1 v _ 2 I _ 1 2 v ~ _ 8 v _ 2 + 3 8 1 v _ 2 v _ v _",
             where=o4.where, condition=nonzero(Re(1 - x)),
             also=lambda draw: {"Re |v| = 1": {v: draw.unit()}},
             remark="Contradicts (89) at n = 4 in the factor of v ⊗ v.",
             corrected=equal(o4.dcay_inv, p4 / (8 * (1 - x)) * I - half * V + (3 - x) / (4 * (1 - x)) * VV)),
)

o5 = Order(5)
p5, q5 = 1 - 10 * x + 5 * x2, 5 - 10 * x + x2
p5_printed = 1 - 10 * x + x2
FIFTH = (
    equation("120", "Rodrigues dual vectors, n = 5", 450, remark(equal(v, tan(branch_of(5)) * u), branch_range(5)),
             extract="v _ = t a n α _ + 2 k π 10 u _ ; k = 0,4", where=o5.preimage, condition=finite(branch_of(5)),
             branches=5),
    equation("121", "p₅ and q₅", 451,
             both(equal(o5.p(X), 1 - 10 * X**2 + 5 * X**4), equal(o5.q(X), 5 - 10 * X**2 + X**4)),
             extract="p 5 X = 1 10 X 2 + 5 X 4 q 5 X = 5 10 X 2 + X 4", where=o5.where),
    equation("122", "unit dual quaternion, n = 5", 453, equal(pm(q_hat), 1 / root((1 + x) ** 5) * (p5 + q5 * v)),
             extract="± q ^ _ = 1 1 _ + v _ 2 5 1 10 v _ 2 + 5 v _ 4 + 5 10 v _ 2 + v _ 4 v _", where=o5.where,
             fixed_by=ROOT),
    equation("123", "orthogonal dual tensor, n = 5", 454,
             equal(R, I + 2 * q5 / (1 + x) ** 5 * (p5 * V + q5 * V**2)),
             extract="R _ = I _ + 2 5 10 v _ 2 + v _ 4 1 + v _ 2 5 1 10 v _ 2 + 5 v _ 4 v ~ _ "
                     "+ 5 10 v _ 2 + v _ 4 v ~ _ 2",
             where=o5.where),
    equation("124", "tangent operator, n = 5", 455,
             equal(o5.dcay, 2 / (1 + x) ** 5 * (p5_printed * q5 * I + q5 * V + (40 - 48 * x + 40 * x2) * VV)),
             extract="d c a y 5 = 2 1 + v _ 2 5 1 10 v _ 2 + v _ 4 5 10 v _ 2 + v _ 4 I _ + 5 10 v _ 2 + v _ 4 v ~ "
                     "+ 40 48 v _ 2 + 40 v _ 4 v _ v _", where=o5.where,
             remark="Contradicts (88) at n = 5 in all three factors, and (121) in p₅.",
             corrected=equal(o5.dcay, 2 / (1 + x) ** 5 * (p5 * q5 * I + q5**2 * V + (80 - 96 * x + 80 * x2) * VV))),
    equation("125", "kinematic tensor, n = 5", 456,
             equal(o5.dcay_inv, p5_printed / (2 * q5) * I - half * V + (45 - 16 * x + x2) / (10 * q5) * VV),
             extract="d c a y 5 1 = 1 10 v _ 2 + v _ 4 2 5 10 v _ 2 + v _ 4 I _ 1 2 v _ ~ + 45 16 v _ 2 + v _ 4 "
                     "10 5 10 v _ 2 + v _ 4 v _ v _", where=o5.where, condition=nonzero(Re(q5)),
             also=lambda draw: {"Re q₅ = 0": {v: draw.unit() * mpmath.tan(mpmath.pi / 5)}},
             remark="Contradicts (89) at n = 5 in the factors of I and v ⊗ v, and (121) in p₅.",
             corrected=equal(o5.dcay_inv, p5 / (2 * q5) * I - half * V + (45 - 34 * x + x2) / (10 * q5) * VV)),
)

ENTRIES = (*FOURTH, *FIFTH)
