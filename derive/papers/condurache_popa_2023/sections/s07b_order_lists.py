"""Section 7, formulas for orders 1 … 5 and the claim that they hold for shadows: lines 270-285."""

from typing import Any

from ..definitions import cayley_maps, orders
from . import *
from .s07_general_order import *
from .s07a_fractional_transform import turned

x2 = norm(v) ** 4


class Order:
    """Order n with its symbols, their definitions, and the formulas printed in sections 7 and 9."""

    def __init__(self, n: int, p: Any, q: Any, q_hat_of_v: Any, R_of_v: Any) -> None:
        self.n, self.p_of_X, self.q_of_X, self.q_hat_of_v, self.R_of_v = n, p, q, q_hat_of_v, R_of_v
        self.p, self.q = (Symbol(f"{f}{n}", "function", f"{f}_{{{n}}}", f"{f}{n}") for f in "pq")
        self.dcay = Symbol(f"dcay{n}", "tensor", rf"\mathrm{{dcay}}_{{{n}}}", f"dcay{n}")
        self.dcay_inv = Symbol(f"dcay{n}⁻¹", "tensor", rf"\mathrm{{dcay}}_{{{n}}}^{{-1}}", f"dcay{n}-1")
        self.where = (
            *(let(symbol, orders.at_order(n, f)) for symbol, f in ((self.p, orders.p), (self.q, orders.q))),
            *(let(symbol, orders.at_order(n, f), v) for symbol, f in (
                (q_hat, orders.cayley), (R, orders.rotation), (self.dcay, orders.tangent))),
            let(self.dcay_inv, inverse_of, self.dcay),
        )
        self.preimage = (let(v, orders.at_order(n, orders.preimage), alpha, u),)

    def polynomials(self, number: str, title: str, line: int, extract: str) -> Entry:
        """Return the entry about p_n and q_n."""
        statement = both(equal(self.p(X), self.p_of_X), equal(self.q(X), self.q_of_X))
        return equation(number, title, line, statement, extract=extract, where=self.where)

    def entry(self, number: str, title: str, line: int, left: Term, right: Any, extract: str, **rest: Any) -> Entry:
        """Return the entry about a formula at this order."""
        return equation(number, f"{title}, n = {self.n}", line, equal(left, right), extract=extract, where=self.where,
                        **rest)

    def quaternion(self, number: str, line: int, extract: str, **rest: Any) -> Entry:
        """Return the entry about the unit dual quaternion."""
        return self.entry(number, "unit dual quaternion", line, pm(q_hat), self.q_hat_of_v, extract, **rest)

    def tensor(self, number: str, line: int, extract: str) -> Entry:
        """Return the entry about the orthogonal dual tensor."""
        return self.entry(number, "orthogonal dual tensor", line, R, self.R_of_v, extract)

    def vector(self, slug: str, line: int) -> Entry:
        """Return the entry about the Rodrigues dual vector on the principal branch."""
        angle = alpha / (2 * self.n)
        return equation(f"{slug}-{self.n}-vector", f"vector, n = {self.n}", line, equal(v, tan(angle) * u),
                        extract=f"v _ = t a n α _ {2 * self.n} u _", where=self.preimage, condition=finite(angle))


p3, p4, p5 = 1 - 3 * x, 1 - 6 * x + x2, 1 - 10 * x + 5 * x2
q4, q5 = 4 * (1 - x), 5 - 10 * x + x2
o1 = Order(1, 1, 1, 1 / root(1 + x) * (1 + v), I + 2 / (1 + x) * (V + V**2))
o2 = Order(2, 1 - X**2, 2, 1 / (1 + x) * ((1 - x) + 2 * v), I + 4 / (1 + x)**2 * ((1 - x) * V + 2 * V**2))
o3 = Order(3, 1 - 3 * X**2, 3 - X**2, 1 / root((1 + x)**3) * (p3 + (3 - x) * v),
           I + 2 * (3 - x) / (1 + x)**3 * (p3 * V + (3 - x) * V**2))
o4 = Order(4, 1 - 6 * X**2 + X**4, 4 - 4 * X**2, 1 / (1 + x)**2 * (p4 + q4 * v),
           I + 8 * (1 - x) / (1 + x)**4 * (p4 * V + q4 * V**2))
o5 = Order(5, 1 - 10 * X**2 + 5 * X**4, 5 - 10 * X**2 + X**4, 1 / root((1 + x)**5) * (p5 + q5 * v),
           I + 2 * q5 / (1 + x)**5 * (p5 * V + q5 * V**2))
ORDERS = (o1, o2, o3, o4, o5)

v_k = vector("v_k", "v", "v")
power_k = (1 + norm(v_k)**2)**n
ON_BRANCH = (*SCREW, let(v_k, cayley_maps.branch, n, k, alpha, u))

ENTRIES = (
    o1.polynomials("list-1-polynomials", "p and q, n = 1", 271, "p 1 X = 1 ; q 1 X = 1"),
    o1.quaternion("list-1-quaternion", 271, "± q ^ _ = 1 1 + v _ 2 1 + v _"),
    o2.polynomials("list-2-polynomials", "p and q, n = 2", 272, "p 2 X = 1 X 2 ; q 2 ( X ) = 2"),
    o2.quaternion("list-2-quaternion", 272, "± q ^ _ = 1 1 + v _ 2 1 v _ 2 + 2 v _"),
    o3.polynomials("list-3-polynomials", "p and q, n = 3", 273, "p 3 X = 1 3 X 2 ; q 3 ( X ) = 3 X 2"),
    o3.quaternion("list-3-quaternion", 273, "± q ^ _ = 1 1 + v _ 2 3 1 3 v _ 2 + 3 v _ 2 v _"),
    o4.polynomials("list-4-polynomials", "p and q, n = 4", 274, "p 4 X = 1 6 X 2 + X 4 ; q 4 ( X ) = 4 4 X 2"),
    o4.quaternion("list-4-quaternion", 274, "± q ^ _ = 1 1 + v _ 2 2 1 6 v _ 2 + v _ 4 + 4 1 v _ 2 v _"),
    o5.polynomials("list-5-polynomials", "p and q, n = 5", 275,
                   "p 5 X = 1 10 X 2 + 5 X 4 ; q 5 ( X ) = 5 10 X 2 + X 4"),
    o5.quaternion("list-5-quaternion", 275, "± q ^ _ = 1 1 + v _ 2 5 1 10 v _ 2 + 5 v _ 4 + 5 10 v _ 2 + v _ 4 v _"),
    *(order.vector("list", 270 + order.n) for order in ORDERS),
    equation("list-shadows", "the equations hold for shadows too", 276,
             equal(pm(q_hat), 1 / root(power_k) * (p(norm(v_k)) + q(norm(v_k)) * v_k)), where=ON_BRANCH,
             condition=finite(turned)),
    equation("tensor-shadows", "so do the tensors", 276, equal(R, rotation_by(norm(v_k), power_k, skew(v_k))),
             where=ON_BRANCH, condition=finite(turned)),
    o1.tensor("tensor-1", 281, "R _ = I _ + 2 1 + v _ 2 v ~ _ + v ~ _ 2"),
    o2.tensor("tensor-2", 282, "R _ = I _ + 4 1 + v _ 2 2 1 v _ 2 v ~ _ + 2 v ~ _ 2"),
    o3.tensor("tensor-3", 283, "R _ = I _ + 2 3 v _ 2 1 + v _ 2 3 1 3 v _ 2 v ~ _ + 3 v _ 2 v ~ _ 2"),
    o4.tensor("tensor-4", 284, "R _ = I _ + 8 1 v _ 2 1 + v _ 2 4 1 6 v _ 2 + v _ 4 v ~ _ + 4 1 v _ 2 v ~ _ 2"),
    o5.tensor("tensor-5", 285, "R _ = I _ + 2 5 10 v _ 2 + v _ 4 1 + v _ 2 5 1 10 v _ 2 + 5 v _ 4 v ~ _ + 5 10 v _ 2 "
                               "+ v _ 4 v ~ _ 2"),
    *(order.vector("tensor", 280 + order.n) for order in ORDERS),
)
