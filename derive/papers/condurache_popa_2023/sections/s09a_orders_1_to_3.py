"""Section 9, explicit formulas for orders 1, 2 and 3: lines 417-440."""

from __future__ import annotations

from ...equation import equation
from ...language.definitions import inverse_of
from ...language.evaluation import let
from ...language.notation import *
from ...language.terms import Symbol, Term
from ..definitions import orders
from ..symbols import X, alpha, u, v
from .s07_general_order import VV, I, R, V, finite, k, q_hat, x


class Order:
    """Symbols of one order, with their definitions."""

    def __init__(self, n: int) -> None:
        self.p, self.q = (Symbol(f"{f}{n}", "function", f"{f}_{{{n}}}", f"{f}{n}") for f in "pq")
        self.dcay = Symbol(f"dcay{n}", "tensor", rf"\mathrm{{dcay}}_{{{n}}}", f"dcay{n}")
        self.dcay_inv = Symbol(f"dcay{n}⁻¹", "tensor", rf"\mathrm{{dcay}}_{{{n}}}^{{-1}}", f"dcay{n}-1")
        of_x = ((self.p, orders.p), (self.q, orders.q))
        of_v = ((q_hat, orders.cayley), (R, orders.rotation), (self.dcay, orders.tangent))
        self.where = (
            *(let(symbol, orders.at_order(n, definition)) for symbol, definition in of_x),
            *(let(symbol, orders.at_order(n, definition), v) for symbol, definition in of_v),
            let(self.dcay_inv, inverse_of, self.dcay),
        )
        self.preimage = (let(v, orders.at_order(n, orders.preimage), alpha, u),)


def branch_of(n: int) -> Term:
    """Return the angle of branch k, ``(α + 2kπ)/2n``."""
    return (alpha + 2 * k * pi) / (2 * n)


def branch_range(n: int) -> Term:
    """Return the printed range of k."""
    return words(rf"k = \overline{{0,{n - 1}}}", f"k=0,{n - 1}")


ROOT = "(102) and (116), where the exponents of the even orders 2 and 4 show that the exponent is n/2"

o1 = Order(1)
FIRST = (
    equation("92", "Rodrigues dual vector, n = 1", 418, equal(v, tan(alpha / 2) * u),
             extract="v _ = t a n α _ 2 u _", where=o1.preimage, condition=finite(alpha / 2)),
    equation("93", "p₁", 419, equal(o1.p(X), 1), extract="p 1 X = 1", where=o1.where),
    equation("94", "q₁", 420, equal(o1.q(X), 1), extract="q 1 X = 1", where=o1.where),
    equation("95", "unit dual quaternion, n = 1", 421, equal(pm(q_hat), 1 / root(1 + x) * (1 + v)),
             extract="± q ^ _ = 1 1 _ + v _ 2 1 + v _", where=o1.where, fixed_by=ROOT),
    equation("96", "orthogonal dual tensor, n = 1", 422, equal(R, I + 2 / (1 + x) * (V + V**2)),
             extract="R _ = I _ + 2 1 + v _ 2 v ~ _ + v ~ _ 2", where=o1.where),
    equation("97", "tangent operator, n = 1", 423, equal(o1.dcay, 2 / (1 + x) * (I + V)),
             extract="d c a y 1 = 2 1 + v _ 2 I _ + v ~ _", where=o1.where),
    equation("98", "kinematic tensor, n = 1", 424, equal(o1.dcay_inv, half * I - half * V + half * VV),
             extract="d c a y 1 1 = 1 2 I _ 1 2 v ~ _ + 1 2 v _ v _", where=o1.where),
)

o2 = Order(2)
SECOND = (
    equation("99", "Rodrigues dual vectors, n = 2", 426,
             remark(equal(v, tan(branch_of(2)) * u), branch_range(2)),
             extract="v _ = t a n α _ + 2 k π 4 u _ ; k = 0,1", where=o2.preimage, condition=finite(branch_of(2)),
             branches=2),
    equation("100", "p₂", 427, equal(o2.p(X), 1 - X**2), extract="p 2 X = 1 X 2", where=o2.where),
    equation("101", "q₂", 428, equal(o2.q(X), 2), extract="q 2 X = 2", where=o2.where),
    equation("102", "unit dual quaternion, n = 2", 429, equal(pm(q_hat), 1 / (1 + x) * ((1 - x) + 2 * v)),
             extract="± q ^ _ = 1 1 _ + v _ 2 1 v _ 2 + 2 v _", where=o2.where),
    equation("103", "orthogonal dual tensor, n = 2", 430,
             equal(R, I + 4 / (1 + x)**2 * ((1 - x) * V + 2 * V**2)),
             extract="R _ = I _ + 4 1 + v _ 2 2 1 v _ 2 v ~ _ + 2 v ~ _ 2", where=o2.where),
    equation("104", "tangent operator, n = 2", 431,
             equal(o2.dcay, 4 / (1 + x)**2 * ((1 - x) * I + 2 * V + 2 * VV)),
             extract="d c a y 2 = 4 1 + v _ 2 2 1 v _ 2 I _ + 2 v ~ _ + 2 v _ v _", where=o2.where),
    equation("105", "kinematic tensor, n = 2", 432,
             equal(o2.dcay_inv, (1 - x) / 2 * I - half * V + half * VV),
             extract="d c a y 2 1 = 1 v _ 2 2 I _ 1 2 v ~ _ + 1 2 v _ v _", where=o2.where,
             remark="Contradicts (89) at n = 2, where p₂/2q₂ is (1 − |v|²)/4.",
             corrected=equal(o2.dcay_inv, (1 - x) / 4 * I - half * V + half * VV)),
)

o3 = Order(3)
THIRD = (
    equation("106", "Rodrigues dual vectors, n = 3", 434,
             remark(equal(v, tan(branch_of(3)) * u), branch_range(3)),
             extract="v _ = t a n α _ + 2 k π 6 u _ ; k = 0,2", where=o3.preimage, condition=finite(branch_of(3)),
             branches=3),
    equation("107", "p₃", 435, equal(o3.p(X), 1 - 3 * X**2), extract="p 3 X = 1 3 X 2", where=o3.where),
    equation("108", "q₃", 436, equal(o3.q(X), 3 - X**2), extract="q 3 X = 3 X 2", where=o3.where),
    equation("109", "unit dual quaternion, n = 3", 437,
             equal(pm(q_hat), 1 / root((1 + x)**3) * ((1 - 3 * x) + (3 - x) * v)),
             extract="± q ^ _ = 1 1 _ + v _ 2 3 1 3 v _ 2 + 3 v _ 2 v _", where=o3.where, fixed_by=ROOT),
    equation("110", "orthogonal dual tensor, n = 3", 438,
             equal(R, I + 2 * (3 - x) / (1 + x)**3 * ((1 - 3 * x) * V + (3 - x) * V**2)),
             extract="R _ = I _ + 2 3 v _ 2 1 + v _ 2 3 1 3 v _ 2 v ~ _ + 3 v _ 2 v ~ _ 2", where=o3.where),
    equation("111", "tangent operator, n = 3", 439,
             equal(o3.dcay, 2 / (1 + x)**3 * ((1 - 3 * x) * (3 - x) * I + (3 - x)**2 * V + (16 + 9 * x) * VV)),
             extract="d c a y 3 = 2 1 + v _ 2 3 1 3 v _ 2 3 v _ 2 I _ + 3 v _ 2 2 v ~ _ + 16 + 9 v _ 2 v _ v _",
             where=o3.where,
             remark="Contradicts (88) at n = 3, where the factor of v ⊗ v is 32/(1 + |v|²)³.",
             corrected=equal(o3.dcay, 2 / (1 + x)**3 * ((1 - 3 * x) * (3 - x) * I + (3 - x)**2 * V + 16 * VV))),
    equation("112", "kinematic tensor, n = 3", 440,
             equal(o3.dcay_inv, (1 - 3 * x) / (3 - x) * I - half * V + (11 - x) / (6 * (3 - x)) * VV),
             extract="d c a y 3 1 = 1 3 v _ 2 3 v _ 2 I _ 1 2 v ~ _ + 11 v _ 2 6 3 v _ 2 v _ v _", where=o3.where,
             condition=nonzero(Re(3 - x)), also=lambda draw: {"Re |v|² = 3": {v: draw.vector(re=(1, -1, 1))}},
             remark="Contradicts (89) at n = 3, where p₃/2q₃ is the factor of I.",
             corrected=equal(o3.dcay_inv,
                             (1 - 3 * x) / (2 * (3 - x)) * I - half * V + (11 - x) / (6 * (3 - x)) * VV)),
)

ENTRIES = (*FIRST, *SECOND, *THIRD)
