"""Section 9, explicit formulas for orders 1 to 5: lines 417-456."""

from . import *
from .s07_general_order import *
from .s07b_order_lists import Order, o1, o2, o3, o4, o5, p4, p5, q4, q5, x2

ROOT = "(102) and (116), where the exponents of the even orders 2 and 4 show that the exponent is n/2"


def vectors(order: Order, number: int, line: int) -> Entry:
    """Return the entry about the Rodrigues dual vectors of all branches."""
    n, angle = order.n, (alpha + 2 * k * pi) / (2 * order.n)
    statement = remark(equal(v, tan(angle) * u), words(rf"k = \overline{{0,{n - 1}}}", f"k=0,{n - 1}"))
    return equation(str(number), f"Rodrigues dual vectors, n = {n}", line, statement, where=order.preimage,
                    extract=f"v _ = t a n α _ + 2 k π {2 * n} u _ ; k = 0,{n - 1}", condition=finite(angle), branches=n)


p5_printed = 1 - 10 * x + x2

ENTRIES = (
    equation("92", "Rodrigues dual vector, n = 1", 418, equal(v, tan(alpha / 2) * u),
             extract="v _ = t a n α _ 2 u _", where=o1.preimage, condition=finite(alpha / 2)),
    equation("93", "p₁", 419, equal(o1.p(X), o1.p_of_X), extract="p 1 X = 1", where=o1.where),
    equation("94", "q₁", 420, equal(o1.q(X), o1.q_of_X), extract="q 1 X = 1", where=o1.where),
    o1.quaternion("95", 421, "± q ^ _ = 1 1 _ + v _ 2 1 + v _", fixed_by=ROOT),
    o1.tensor("96", 422, "R _ = I _ + 2 1 + v _ 2 v ~ _ + v ~ _ 2"),
    o1.entry("97", "tangent operator", 423, o1.dcay, 2 / (1 + x) * (I + V), "d c a y 1 = 2 1 + v _ 2 I _ + v ~ _"),
    o1.entry("98", "kinematic tensor", 424, o1.dcay_inv, half * I - half * V + half * VV,
             "d c a y 1 1 = 1 2 I _ 1 2 v ~ _ + 1 2 v _ v _"),
    vectors(o2, 99, 426),
    equation("100", "p₂", 427, equal(o2.p(X), o2.p_of_X), extract="p 2 X = 1 X 2", where=o2.where),
    equation("101", "q₂", 428, equal(o2.q(X), o2.q_of_X), extract="q 2 X = 2", where=o2.where),
    o2.quaternion("102", 429, "± q ^ _ = 1 1 _ + v _ 2 1 v _ 2 + 2 v _"),
    o2.tensor("103", 430, "R _ = I _ + 4 1 + v _ 2 2 1 v _ 2 v ~ _ + 2 v ~ _ 2"),
    o2.entry("104", "tangent operator", 431, o2.dcay, 4 / (1 + x)**2 * ((1 - x) * I + 2 * V + 2 * VV),
             "d c a y 2 = 4 1 + v _ 2 2 1 v _ 2 I _ + 2 v ~ _ + 2 v _ v _"),
    o2.entry("105", "kinematic tensor", 432, o2.dcay_inv, (1 - x) / 2 * I - half * V + half * VV,
             "d c a y 2 1 = 1 v _ 2 2 I _ 1 2 v ~ _ + 1 2 v _ v _",
             corrected=equal(o2.dcay_inv, (1 - x) / 4 * I - half * V + half * VV),
             remark="Contradicts (89) at n = 2, where p₂/2q₂ is (1 − |v|²)/4."),
    vectors(o3, 106, 434),
    equation("107", "p₃", 435, equal(o3.p(X), o3.p_of_X), extract="p 3 X = 1 3 X 2", where=o3.where),
    equation("108", "q₃", 436, equal(o3.q(X), o3.q_of_X), extract="q 3 X = 3 X 2", where=o3.where),
    o3.quaternion("109", 437, "± q ^ _ = 1 1 _ + v _ 2 3 1 3 v _ 2 + 3 v _ 2 v _", fixed_by=ROOT),
    o3.tensor("110", 438, "R _ = I _ + 2 3 v _ 2 1 + v _ 2 3 1 3 v _ 2 v ~ _ + 3 v _ 2 v ~ _ 2"),
    o3.entry("111", "tangent operator", 439, o3.dcay,
             2 / (1 + x)**3 * ((1 - 3 * x) * (3 - x) * I + (3 - x)**2 * V + (16 + 9 * x) * VV),
             "d c a y 3 = 2 1 + v _ 2 3 1 3 v _ 2 3 v _ 2 I _ + 3 v _ 2 2 v ~ _ + 16 + 9 v _ 2 v _ v _",
             remark="Contradicts (88) at n = 3, where the factor of v ⊗ v is 32/(1 + |v|²)³.",
             corrected=equal(o3.dcay, 2 / (1 + x)**3 * ((1 - 3 * x) * (3 - x) * I + (3 - x)**2 * V + 16 * VV))),
    o3.entry("112", "kinematic tensor", 440, o3.dcay_inv,
             (1 - 3 * x) / (3 - x) * I - half * V + (11 - x) / (6 * (3 - x)) * VV,
             "d c a y 3 1 = 1 3 v _ 2 3 v _ 2 I _ 1 2 v ~ _ + 11 v _ 2 6 3 v _ 2 v _ v _",
             condition=nonzero(Re(3 - x)),
             corrected=equal(o3.dcay_inv, (1 - 3 * x) / (2 * (3 - x)) * I - half * V + (11 - x) / (6 * (3 - x)) * VV),
             remark="Contradicts (89) at n = 3, where p₃/2q₃ is the factor of I."),
    vectors(o4, 113, 442),
    equation("114", "p₄", 443, equal(o4.p(X), o4.p_of_X), extract="p 4 X = 1 6 X 2 + X 4", where=o4.where),
    equation("115", "q₄", 444, equal(o4.q(X), o4.q_of_X), extract="q 4 X = 4 4 X 2", where=o4.where),
    o4.quaternion("116", 445, "± q ^ _ = 1 1 _ + v _ 2 2 1 6 v _ 2 + v _ 4 + 4 1 v _ 2 v _"),
    o4.tensor("117", 446, "R _ = I _ + 8 1 v _ 2 1 + v _ 2 4 1 6 v _ 2 + v _ 4 v ~ _ + 4 1 v _ 2 v ~ _ 2"),
    o4.entry("118", "tangent operator", 447, o4.dcay,
             8 / (1 + x)**4 * (p4 * (1 - x) * I + q4 * V + (x2 - 3 * x + 10) * VV),
             "d c a y 4 = 8 1 + v _ 2 4 1 6 v _ 2 + v _ 4 1 v _ 2 I _ + 4 1 v _ 2 v ~ _ "
             "+ v _ 4 3 v _ 2 + 10 v _ v _", remark="Contradicts (88) at n = 4 in the factors of ṽ and v ⊗ v.",
             corrected=equal(o4.dcay, 8 / (1 + x)**4 * (p4 * (1 - x) * I + 4 * (1 - x)**2 * V
                                                        + (2 * x2 - 4 * x + 10) * VV))),
    o4.entry("119", "kinematic tensor", 448, o4.dcay_inv,
             p4 / (8 * (1 - x)) * I - half * V - (8 * x + 3) / (8 * (1 - x)) * VV,
             "d c a y 4 1 = 1 6 v _ 2 + v _ 4 8 1 v _ 2 I _ 1 2 v ~ _ 8 v _ 2 + 3 8 1 v _ 2 v _ v _",
             condition=nonzero(Re(1 - x)),
             corrected=equal(o4.dcay_inv, p4 / (8 * (1 - x)) * I - half * V + (3 - x) / (4 * (1 - x)) * VV),
             remark="Contradicts (89) at n = 4 in the factor of v ⊗ v."),
    vectors(o5, 120, 450),
    o5.polynomials("121", "p₅ and q₅", 451, "p 5 X = 1 10 X 2 + 5 X 4 q 5 X = 5 10 X 2 + X 4"),
    o5.quaternion("122", 453, "± q ^ _ = 1 1 _ + v _ 2 5 1 10 v _ 2 + 5 v _ 4 + 5 10 v _ 2 + v _ 4 v _", fixed_by=ROOT),
    o5.tensor("123", 454, "R _ = I _ + 2 5 10 v _ 2 + v _ 4 1 + v _ 2 5 1 10 v _ 2 + 5 v _ 4 v ~ _ "
                          "+ 5 10 v _ 2 + v _ 4 v ~ _ 2"),
    o5.entry("124", "tangent operator", 455, o5.dcay,
             2 / (1 + x)**5 * (p5_printed * q5 * I + q5 * V + (40 - 48 * x + 40 * x2) * VV),
             "d c a y 5 = 2 1 + v _ 2 5 1 10 v _ 2 + v _ 4 5 10 v _ 2 + v _ 4 I _ + 5 10 v _ 2 + v _ 4 v ~ "
             "+ 40 48 v _ 2 + 40 v _ 4 v _ v _",
             remark="Contradicts (88) at n = 5 in all three factors, and (121) in p₅.",
             corrected=equal(o5.dcay, 2 / (1 + x)**5 * (p5 * q5 * I + q5**2 * V + (80 - 96 * x + 80 * x2) * VV))),
    o5.entry("125", "kinematic tensor", 456, o5.dcay_inv,
             p5_printed / (2 * q5) * I - half * V + (45 - 16 * x + x2) / (10 * q5) * VV,
             "d c a y 5 1 = 1 10 v _ 2 + v _ 4 2 5 10 v _ 2 + v _ 4 I _ 1 2 v _ ~ + 45 16 v _ 2 + v _ 4 "
             "10 5 10 v _ 2 + v _ 4 v _ v _", condition=nonzero(Re(q5)),
             corrected=equal(o5.dcay_inv, p5 / (2 * q5) * I - half * V + (45 - 34 * x + x2) / (10 * q5) * VV),
             remark="Contradicts (89) at n = 5 in the factors of I and v ⊗ v, and (121) in p₅."),
)
