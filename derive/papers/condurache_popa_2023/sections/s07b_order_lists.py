"""Section 7, formulas for orders 1 … 5 and the claim that they hold for shadows: lines 270-285."""

from __future__ import annotations

from typing import Any

import mpmath

from ...equation import Equation, equation
from ...language.definitions import screw_quaternion, screw_tensor
from ...language.evaluation import let
from ...language.notation import *
from ...language.terms import Symbol
from ..definitions import cayley_maps, orders
from ..symbols import alpha, n, u, v, vector
from .s07_general_order import I as identity
from .s07_general_order import R, V, X, finite, k, q_hat, x
from .s07_general_order import p as p_n
from .s07_general_order import q as q_n
from .s07a_fractional_transform import turned

x2 = norm(v) ** 4
p3, p4, p5 = 1 - 3 * x, 1 - 6 * x + x2, 1 - 10 * x + 5 * x2
q5 = 5 - 10 * x + x2
v_k = vector("v_k", "v", "v")
skew_k = skew(v_k)
p = {i: Symbol(f"p{i}", "function", f"p_{{{i}}}", f"p{i}") for i in range(1, 6)}
q = {i: Symbol(f"q{i}", "function", f"q_{{{i}}}", f"q{i}") for i in range(1, 6)}


def polynomials(i: int, line: int, first: Any, second: Any, extract: str) -> Equation:
    """Return the entry about the polynomials of one order."""
    where = (let(p[i], orders.at_order(i, orders.p)), let(q[i], orders.at_order(i, orders.q)))
    statement = both(equal(p[i](X), first), equal(q[i](X), second))
    return equation(f"list-{i}-polynomials", f"p and q, n = {i}", line, statement, extract=extract, where=where)


def quaternion(i: int, line: int, value: Any, extract: str) -> Equation:
    """Return the entry about the unit dual quaternion of one order."""
    where = (let(q_hat, orders.at_order(i, orders.cayley), v),)
    return equation(f"list-{i}-quaternion", f"unit dual quaternion, n = {i}", line, equal(pm(q_hat), value),
                    extract=extract, where=where)


def parameter(slug: str, i: int, line: int) -> Equation:
    """Return the entry about the vector of one order."""
    where = (let(v, orders.at_order(i, orders.preimage), alpha, u),)
    return equation(f"{slug}-{i}-vector", f"vector, n = {i}", line, equal(v, tan(alpha / (2 * i)) * u),
                    extract=f"v _ = t a n α _ {2 * i} u _", where=where, condition=finite(alpha / (2 * i)),
                    also=lambda draw: {f"Re α = {i}π": {alpha: draw.number(i * mpmath.pi)}})


def tensor(i: int, line: int, value: Any, extract: str) -> Equation:
    """Return the entry about the orthogonal dual tensor of one order."""
    where = (let(R, orders.at_order(i, orders.rotation), v),)
    return equation(f"tensor-{i}", f"orthogonal dual tensor, n = {i}", line, equal(R, value), extract=extract,
                    where=where)


QUATERNIONS = (
    polynomials(1, 271, 1, 1, "p 1 X = 1 ; q 1 X = 1"),
    quaternion(1, 271, 1 / root(1 + x) * (1 + v), "± q ^ _ = 1 1 + v _ 2 1 + v _"),
    polynomials(2, 272, 1 - X**2, 2, "p 2 X = 1 X 2 ; q 2 ( X ) = 2"),
    quaternion(2, 272, 1 / (1 + x) * ((1 - x) + 2 * v), "± q ^ _ = 1 1 + v _ 2 1 v _ 2 + 2 v _"),
    polynomials(3, 273, 1 - 3 * X**2, 3 - X**2, "p 3 X = 1 3 X 2 ; q 3 ( X ) = 3 X 2"),
    quaternion(3, 273, 1 / root((1 + x)**3) * (p3 + (3 - x) * v),
               "± q ^ _ = 1 1 + v _ 2 3 1 3 v _ 2 + 3 v _ 2 v _"),
    polynomials(4, 274, 1 - 6 * X**2 + X**4, 4 - 4 * X**2, "p 4 X = 1 6 X 2 + X 4 ; q 4 ( X ) = 4 4 X 2"),
    quaternion(4, 274, 1 / (1 + x)**2 * (p4 + 4 * (1 - x) * v),
               "± q ^ _ = 1 1 + v _ 2 2 1 6 v _ 2 + v _ 4 + 4 1 v _ 2 v _"),
    polynomials(5, 275, 1 - 10 * X**2 + 5 * X**4, 5 - 10 * X**2 + X**4,
                "p 5 X = 1 10 X 2 + 5 X 4 ; q 5 ( X ) = 5 10 X 2 + X 4"),
    quaternion(5, 275, 1 / root((1 + x)**5) * (p5 + q5 * v),
               "± q ^ _ = 1 1 + v _ 2 5 1 10 v _ 2 + 5 v _ 4 + 5 10 v _ 2 + v _ 4 v _"),
    *(parameter("list", i, 270 + i) for i in range(1, 6)),
)

SHADOWS = (
    equation("list-shadows", "the equations hold for shadows too", 276,
             equal(pm(q_hat), 1 / root((1 + norm(v_k)**2)**n) * (p_n(norm(v_k)) + q_n(norm(v_k)) * v_k)),
             where=(let(p_n, orders.p, n), let(q_n, orders.q, n), let(v_k, cayley_maps.branch, n, k, alpha, u),
                    let(q_hat, screw_quaternion, alpha, u)),
             condition=finite(turned)),
    equation("tensor-shadows", "so do the tensors", 276,
             equal(R, identity + 2 * p_n(norm(v_k)) * q_n(norm(v_k)) / (1 + norm(v_k)**2)**n * skew_k
                   + 2 * (q_n**2)(norm(v_k)) / (1 + norm(v_k)**2)**n * skew_k**2),
             where=(let(p_n, orders.p, n), let(q_n, orders.q, n), let(v_k, cayley_maps.branch, n, k, alpha, u),
                    let(R, screw_tensor, alpha, u)),
             condition=finite(turned)),
)

TENSORS = (
    tensor(1, 281, identity + 2 / (1 + x) * (V + V**2), "R _ = I _ + 2 1 + v _ 2 v ~ _ + v ~ _ 2"),
    tensor(2, 282, identity + 4 / (1 + x)**2 * ((1 - x) * V + 2 * V**2),
           "R _ = I _ + 4 1 + v _ 2 2 1 v _ 2 v ~ _ + 2 v ~ _ 2"),
    tensor(3, 283, identity + 2 * (3 - x) / (1 + x)**3 * (p3 * V + (3 - x) * V**2),
           "R _ = I _ + 2 3 v _ 2 1 + v _ 2 3 1 3 v _ 2 v ~ _ + 3 v _ 2 v ~ _ 2"),
    tensor(4, 284, identity + 8 * (1 - x) / (1 + x)**4 * (p4 * V + 4 * (1 - x) * V**2),
           "R _ = I _ + 8 1 v _ 2 1 + v _ 2 4 1 6 v _ 2 + v _ 4 v ~ _ + 4 1 v _ 2 v ~ _ 2"),
    tensor(5, 285, identity + 2 * q5 / (1 + x)**5 * (p5 * V + q5 * V**2),
           "R _ = I _ + 2 5 10 v _ 2 + v _ 4 1 + v _ 2 5 1 10 v _ 2 + 5 v _ 4 v ~ _ + 5 10 v _ 2 + v _ 4 v ~ _ 2"),
    *(parameter("tensor", i, 280 + i) for i in range(1, 6)),
)

ENTRIES = (*QUATERNIONS, *SHADOWS, *TENSORS)
