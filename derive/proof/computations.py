"""Comparison of functions of `derive.maps` with the theorems, at one order.

The functions compute binomial sums, the addition law, pairs by squaring and their brackets, closed forms, and the
angles at which dcay loses rank.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from itertools import product
from typing import Any

import sympy

from ..maps import closed_forms, polynomials
from .at_order import METHOD, SYMBOLS, AtOrder, Stated, at_order, same_as_theorem
from .identity import Check, Claim, Proof, decide
from .notation import q
from .statement import Equation

Function = Callable[..., Any]


@dataclass(frozen=True)
class Computed:
    """Functions compared with the theorems; each control replaces one of them."""

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
    """Prove that the functions agree with the theorems at an order.

    Parameters
    ----------
    order : int
    of : Computed, optional
        Functions to compare, by default from `derive.maps`.

    Returns
    -------
    tuple of Proof
        Proofs for binomial sums, pairs and brackets, each closed form, and singular angles (sin α/2 and q_n vanish).
    """
    functions, at = of or Computed(), at_order(order)

    def sums(symbol: str) -> Stated:
        return lambda: (getattr(functions, f"{symbol}_binomial")(order),)

    def multiplied() -> Any:
        halves = [polynomials.pair(k, at.x) if k else (1, 0) for k in (order // 2, order - order // 2)]
        return functions.multiply(*halves, at.x)

    def isotropic(name: str) -> Stated:
        return lambda: getattr(functions, name)(order, at.x).coefficients

    pairs: Mapping[str, tuple[str, Callable[[], Any]]] = {
        "multiply": ("pq", multiplied),
        "pair_by_squaring": ("pq", lambda: functions.pair_by_squaring(order, at.x)),
        "brackets": ("cd", lambda: functions.brackets(order, at.x)),
    }
    forms: dict[str, Stated] = {"quaternion": lambda: functions.quaternion(order, at.x)}
    forms |= {name: isotropic(name) for name in ("tensor", "tangent", "tangent_inv")}
    return (
        same_as_theorem(at, {f"polynomials.{a}_binomial({order})": (SYMBOLS[a], sums(a)) for a in "pqcd"}),
        same_as_theorem(
            at,
            {
                f"polynomials.{name}({order}).{symbol}": (SYMBOLS[symbol], partial(_part, pair, place))
                for name, (symbols, pair) in pairs.items()
                for place, symbol in enumerate(symbols)
            },
        ),
        *(same_as_theorem(at, {f"closed_forms.{a}({order}, x)": (SYMBOLS[a], form)}) for a, form in forms.items()),
        _singular_angles(at, functions),
    )


def _part(pair: Callable[[], Any], place: int) -> tuple[Any]:
    return (pair()[place],)


def _singular_angles(at: AtOrder, functions: Computed) -> Proof:
    """Decide whether sin α/2 = 0 at all singular angles except the last, nπ, and whether tan α/2n are all poles."""
    names = [f"polynomials.{name}({at.order})" for name in ("singular_angles", "poles")]
    turns, last, poles = map(sympy.Symbol, (f"{names[0]}[:-1]", f"{names[0]}[-1]", names[1]))
    claim = (
        Equation(sympy.sin(turns / 2), sympy.Integer(0)),
        Equation(poles, sympy.tan(turns / (2 * at.order))),
        Equation(last, at.order * sympy.pi),
    )

    def checks() -> Iterator[Check]:
        *full_turns, end = functions.singular_angles(at.order)
        found = functions.poles(at.order)
        yield "the number of poles less that of angles", len(found) - len(full_turns)
        places = [{turns: angle, poles: pole} for angle, pole in zip(full_turns, found, strict=False)]
        for equation, values in (*product(claim[:2], places), (claim[2], {last: end})):
            yield f"{equation.text} at {values}", (equation.left - equation.right).xreplace(values)
        yield "their number less the degree of q", len(set(full_turns)) - at.values[q][0].numerator.degrees()[-1] // 2
        outside = [angle for angle in full_turns if not 0 < angle / sympy.pi < at.order]
        yield "how many are not between 0 and nπ", len(outside)

    return decide(Claim(", ".join(names), claim, METHOD), checks, f"n = {at.order}")
