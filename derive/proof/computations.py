"""What `derive.maps` computes at one order, each function in its own way, is what the theorems say.

Binomial sums, the addition law, the pair by squaring and its brackets, closed forms at any number, and the angles at
which dcay loses rank.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import sympy

from ..maps import closed_forms, polynomials
from .at_order import BASIS, METHOD, AtOrder, at_order, same_as_theorem
from .exact import Ring
from .identity import Check, Claim, Proof, decide
from .statement import Equation

Function = Callable[..., Any]


@dataclass(frozen=True)
class Computed:
    """The functions in question; a control has another one in place of one of them."""

    p_binomial: Function = polynomials.p_binomial
    q_binomial: Function = polynomials.q_binomial
    c_binomial: Function = polynomials.c_binomial
    d_binomial: Function = polynomials.d_binomial
    multiply: Function = polynomials.multiply
    pair_by_squaring: Function = polynomials.pair_by_squaring
    brackets: Function = polynomials.brackets
    quaternion: Function = closed_forms.quaternion
    tensor: Function = closed_forms.tensor
    tangent: Function = closed_forms.tangent
    tangent_inv: Function = closed_forms.tangent_inv
    singular_angles: Function = polynomials.singular_angles
    poles: Function = polynomials.poles


def computations(order: int, of: Computed | None = None) -> tuple[Proof, ...]:
    """Prove that what is computed at an order is what the theorems say.

    Parameters
    ----------
    order : int
    of : Computed, optional
        The functions, those of `derive.maps` by default.

    Returns
    -------
    tuple of Proof
        The binomial sums; pairs and brackets; the closed forms, a proof each; the singular angles, at which sin α/2
        and with it q_n vanishes, as many as q_n has zeros.
    """
    functions, at = of or Computed(), at_order(order)

    def sums() -> Iterator[Check]:
        found = [getattr(functions, f"{letter}_binomial")(order) for letter in "pqcd"]
        yield from at.same("pqcd", found, at.polynomials)

    def pairs() -> Iterator[Check]:
        halves = [polynomials.pair(k, at.x) if k else (1, 0) for k in (order // 2, order - order // 2)]
        yield from at.same("pq", functions.multiply(halves[0], halves[1], at.x), at.polynomials[:2])
        yield from at.same("pq", functions.pair_by_squaring(order, at.x), at.polynomials[:2])
        yield from at.same("cd", functions.brackets(order, at.x), at.polynomials[2:])

    def quaternion() -> Iterator[Check]:
        ring = Ring(root=True)  # of s = sqrt(1 + x), an odd power of which is the root for odd n
        square, root = ring.square("v"), ring.square_root() ** order
        stated, pair = functions.quaternion(order, square), polynomials.pair(order, square)
        for name, value, expected in zip(("scalar", "vector"), stated, pair, strict=True):
            yield name, value * root - expected

    def isotropic(name: str) -> Callable[[], Iterator[Check]]:
        return lambda: at.same(BASIS, getattr(functions, name)(order, at.x).coefficients, at.tensors[name])

    parts = ("multiply", "pq"), ("pair_by_squaring", "pq"), ("brackets", "cd")
    stated = [(letter, f"polynomials.{name}({order}).{letter}") for name, letters in parts for letter in letters]
    forms = {"quaternion": quaternion} | {name: isotropic(name) for name in ("tensor", "tangent", "tangent_inv")}
    return (
        same_as_theorem(order, [(letter, f"polynomials.{letter}_binomial({order})") for letter in "pqcd"], sums),
        same_as_theorem(order, stated, pairs),
        *(same_as_theorem(order, [(n, f"closed_forms.{n}({order}, x)")], form) for n, form in forms.items()),
        _singular_angles(order, at, functions),
    )


def _singular_angles(order: int, at: AtOrder, functions: Computed) -> Proof:
    """sin α/2 = 0 at all but the last, where α/2n is a right angle; tan α/2n are the poles; there are no others."""
    angles, poles = (sympy.Symbol(f"polynomials.{name}({order})") for name in ("singular_angles", "poles"))
    claim = (
        Equation(sympy.sin(angles / 2), sympy.Integer(0)),
        Equation(poles, sympy.tan(angles / (2 * order))),
    )

    def checks() -> Iterator[Check]:
        *full_turns, last = functions.singular_angles(order)
        found = functions.poles(order)
        yield "the number of poles less that of angles", len(found) - len(full_turns)
        for angle, pole in zip(full_turns, found, strict=False):
            yield f"sin of half {angle}", sympy.sin(angle / 2)
            yield f"pole at {angle}", pole - sympy.tan(angle / (2 * order))
        yield f"cos of {last} by {2 * order}", sympy.cos(last / (2 * order))
        q_n = at.polynomials[1].numer
        yield "their number less the degree of q", len(set(full_turns)) - q_n.degree()
        outside = [angle for angle in full_turns if not 0 < angle / sympy.pi < order]
        yield "how many are not between 0 and nπ", len(outside)

    return decide(Claim(f"{angles}, {poles}", claim, METHOD), checks, f"n = {order}")
