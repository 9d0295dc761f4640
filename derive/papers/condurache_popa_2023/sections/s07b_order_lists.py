"""Section 7, formulas for orders 1 … 5 and the claim that they hold for shadows: lines 270-285."""

from typing import Any

from ..definitions import cayley_maps, orders
from . import *
from .general_order import *
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

    def polynomials(self, number: str) -> Entry:
        return equation(number, both(*self._polynomials), where=self.where)

    def each_polynomial(self, *numbers: str) -> tuple[Entry, ...]:
        return tuple(map(self.equation, numbers, self._polynomials))

    @property
    def _polynomials(self) -> tuple[Term, Term]:
        return equal(self.p(X), self.p_of_X), equal(self.q(X), self.q_of_X)

    def equation(self, number: str, statement: Term, **rest: Any) -> Entry:
        return equation(number, statement, where=self.where, **rest)

    def quaternion(self, number: str) -> Entry:
        return self.equation(number, equal(pm(q_hat), self.q_hat_of_v))

    def tensor(self, number: str) -> Entry:
        return self.equation(number, equal(R, self.R_of_v))

    def vector(self, number: str) -> Entry:
        """Return the entry about the Rodrigues dual vector on the principal branch."""
        angle = alpha / (2 * self.n)
        return equation(number, equal(v, tan(angle) * u), where=self.preimage, condition=finite(angle))

    def vectors(self, number: str) -> Entry:
        n, angle = self.n, (alpha + 2 * k * pi) / (2 * self.n)
        statement = remark(equal(v, tan(angle) * u), words(rf"k = \overline{{0,{n - 1}}}", f"k=0,{n - 1}"))
        return equation(number, statement, where=self.preimage, condition=finite(angle), branches=n)


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
    *(entry for o in ORDERS
      for entry in (o.polynomials(f"list-{o.n}-polynomials"), o.quaternion(f"list-{o.n}-quaternion"))),
    *(o.vector(f"list-{o.n}-vector") for o in ORDERS),
    equation("list-shadows", equal(pm(q_hat), 1 / root(power_k) * (p(norm(v_k)) + q(norm(v_k)) * v_k)), where=ON_BRANCH,
             condition=finite(turned)),
    equation("tensor-shadows", equal(R, rotation_by(norm(v_k), power_k, skew(v_k))), where=ON_BRANCH,
             condition=finite(turned)),
    *(o.tensor(f"tensor-{o.n}") for o in ORDERS),
    *(o.vector(f"tensor-{o.n}-vector") for o in ORDERS),
)
