"""Sums of binomial coefficients times a geometric sequence, by the binomial theorem for every order."""

from __future__ import annotations

from typing import Any

from ...algebra.element import NotExactError
from . import values
from .environment import Env
from .printed import Number, Term, letters, walk


def binomial_sum(env: Env, index: Term, first: Any, last: Any, body: Term) -> Any:
    """Return the sum over all k, even k or odd k from 0 to N of ``binomial(N, k) a b**k``, for a symbolic N.

    The terms are ``a r**j`` with j = k, k/2 or (k - 1)/2, and the sums over even and odd k are polynomials p_N and q_N.
    """
    node = next((part for part in walk(body) if part.operator.name == "binomial"), None)
    if node is None or index in letters(node.arguments[0]) or not _is_factor(body, node):
        raise NotExactError("a sum of n terms")
    field: Any = env.field
    count, rest = env.value(node.arguments[0]), body.xreplace({node: Number(1)})
    k = field.symbol(field.next_of("turn"))
    start, second, place = (env.bound(index, at).value(node.arguments[1]) for at in (0, 1, k))
    ends = {(1, 0): lambda: count, (2, 0): lambda: field.floor(count / 2),
            (2, 1): lambda: field.floor((count - 1) / 2)}  # fmt: skip
    every = second - start, start
    known = every in ends and place == every[0] * k + start and last == ends[every]()
    if first != 0 or not known or not field.is_positive(count):
        raise NotExactError("a sum of n terms")
    one, two, now, after = (env.bound(index, at).value(rest) for at in (0, 1, k, k + 1))
    ratio = values.divide(two, one)
    if not values.equal(field, after, values.multiply(now, ratio)):
        raise NotExactError("a sum of terms without a common ratio")
    if every == (1, 0):
        return values.multiply(one, field.power(values.add(1, ratio), count))
    return values.multiply(one, field.pair(count, -ratio)[start])


def _is_factor(body: Term, node: Term) -> bool:
    """Return whether a term is a product with this factor, which occurs once."""
    if body == node:
        return True
    name, parts = body.operator.name, body.arguments
    inside = [part for part in parts if node in walk(part)]
    return name in ("times", "bracket", "negative", "over") and len(inside) == 1 and (
        name != "over" or inside[0] is parts[0]) and _is_factor(inside[0], node)  # fmt: skip
