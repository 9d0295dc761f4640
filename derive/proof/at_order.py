"""Proofs that the formulas and functions of `derive.maps` at one order are instances of the theorems.

The formulas are functions of x. The functions compute binomial sums, the addition law, pairs by squaring and their
brackets, closed forms, and the angles at which dcay loses rank.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache, partial
from itertools import product
from typing import Any

import sympy

from ..algebra import arithmetic
from ..maps import Cayley, any_order, cayley_scalars, polynomials
from .evaluation import NoValueError, tangent, tangent_inv, tensor
from .identity import Checks, Equation, Proof, decide
from .notation import R, Shifted, c, d, dcay, dcay_inv, n, p, q, q_hat, text, x
from .rings import Ring

METHOD = "instance of the theorem for all n, residues in Q(x), for the quaternion in Q(sqrt(1 + x))"
Function = Callable[..., Any]
Named = Mapping[str, tuple[sympy.Expr, Callable[[], Sequence[Any]]]]
"""Names in the code, each with its symbol in the theorems and a function that returns the coefficients."""

SYMBOLS = {
    "p": p, "q": q, "c": c, "d": d, "quaternion": q_hat, "tensor": R, "tangent": dcay, "tangent_inv": dcay_inv,
}  # fmt: skip
"""Symbols in the theorems, by the attribute of a Cayley map that holds the formula."""

SUMS = ("p_sum", "q_sum", "c_sum", "d_sum")
PAIRS = {"multiply": "pq", "pair_by_squaring": "pq", "brackets": "cd"}
FORMS = ("quaternion", "tensor", "tangent", "tangent_inv")
FUNCTIONS: Mapping[str, Function] = {
    **{name: getattr(any_order, name) for name in SUMS},
    "multiply": arithmetic.multiply,
    "pair_by_squaring": arithmetic.pair_by_squaring,
    "brackets": polynomials.brackets,
    **{name: getattr(cayley_scalars, name) for name in FORMS},
    "singular_angles": polynomials.singular_angles,
    "poles": polynomials.poles,
}
"""Functions compared with the theorems; each control replaces one of them."""


class AtOrder:
    """Formulas of the theorems at one order. Odd orders need sqrt(1 + x) for the quaternion."""

    def __init__(self, order: int) -> None:
        self.order = order
        self.ring = Ring(root=1)
        self.x, root = self.ring.x, self.ring.generator**order
        p_n, q_n = map(self.ring.element, arithmetic.pair(order, self.x))
        power = (1 + self.x) ** order
        tensors = {R: tensor, dcay: tangent, dcay_inv: tangent_inv}
        self.values: Mapping[sympy.Expr, tuple[Any, ...]] = {
            p: (p_n,),
            q: (q_n,),
            c: ((order * power / (1 + self.x) - p_n * q_n) / self.x,),
            d: (((1 + self.x) * q_n - order * p_n) / self.x,),
            q_hat: (p_n / root, q_n / root),
            **{symbol: formula(order, self.x, p_n, q_n) for symbol, formula in tensors.items()},
        }

    def same(self, name: sympy.Expr, stated: Sequence[Any], term: sympy.Expr) -> Checks:
        """Yield stated coefficients minus the theorems' coefficients for the symbol in `term`, at this order."""
        symbol, index, order = term.args
        if (index, order) != (n, self.order):
            raise NoValueError(f"{text(term)} is not at n = {self.order}")
        for place, (value, theorem) in enumerate(zip(stated, self.values[symbol], strict=True), 1):
            label = f"{text(name)}, component {place}" if len(stated) > 1 else text(name)
            found = self.ring.lift(value, {x: self.x}) if isinstance(value, sympy.Expr) else value
            yield label, self.ring.element(found) - theorem


at_order = lru_cache(maxsize=2)(AtOrder)
"""Formulas of the theorems at an order; the last two orders are cached."""


def same_as_theorem(at: AtOrder, named: Named) -> Proof:
    """Decide whether named formulas of the code equal the theorems' formulas for their symbols."""
    claim = tuple(
        Equation(sympy.Symbol(name, commutative=symbol.is_commutative), Shifted(symbol, n, sympy.Integer(at.order)))
        for name, (symbol, _) in named.items()
    )

    def checks() -> Checks:
        for equation in claim:
            _, stated = named[equation.left.name]
            yield from at.same(equation.left, stated(), equation.right)

    return decide(", ".join(named), claim, METHOD, checks, f"n = {at.order}")


def instances(cayley: Cayley) -> tuple[Proof, ...]:
    """Prove that the formulas of a Cayley map equal the theorems' formulas at its order."""

    def proof(*names: str) -> Proof:
        named = {
            f"Cayley({cayley.order}).{name}": (SYMBOLS[name], partial(_coefficients, getattr(cayley, name)))
            for name in names
        }
        return same_as_theorem(at_order(cayley.order), named)

    return (proof("p", "q", "c", "d"), *map(proof, FORMS))


def computations(order: int, functions: Mapping[str, Function] = FUNCTIONS) -> tuple[Proof, ...]:
    """Prove that functions (sums, pairs, closed forms, singular angles) agree with the theorems at an order."""
    at = at_order(order)
    halves = [arithmetic.pair(k, at.x) if k else (1, 0) for k in (order // 2, order - order // 2)]
    arguments = {"multiply": (*halves, at.x), **dict.fromkeys(SUMS, (sympy.Integer(order),))}

    def computed(name: str, place: int = 0) -> tuple[Any, ...]:
        found = functions[name](*arguments.get(name, (order, at.x)))
        return _coefficients(found[place] if name in PAIRS else found)

    pairs: Named = {
        f"polynomials.{name}({order}).{symbol}": (SYMBOLS[symbol], partial(computed, name, place))
        for name, symbols in PAIRS.items()
        for place, symbol in enumerate(symbols)
    }
    return (
        same_as_theorem(at, {f"any_order.{a}({order})": (SYMBOLS[a[0]], partial(computed, a)) for a in SUMS}),
        same_as_theorem(at, pairs),
        *(same_as_theorem(at, {f"cayley_scalars.{a}({order}, x)": (SYMBOLS[a], partial(computed, a))}) for a in FORMS),
        _singular_angles(at, functions),
    )


def _coefficients(found: Any) -> tuple[Any, ...]:
    return found if isinstance(found, tuple) else tuple(getattr(found, "coefficients", (found,)))


def _singular_angles(at: AtOrder, functions: Mapping[str, Function]) -> Proof:
    """Decide that the last singular angle is nπ, sin α/2 = 0 at the others, and their tan α/2n are the poles."""
    names = [f"polynomials.{name}({at.order})" for name in ("singular_angles", "poles")]
    turns, last, poles = map(sympy.Symbol, (f"{names[0]}[:-1]", f"{names[0]}[-1]", names[1]))
    claim = (
        Equation(sympy.sin(turns / 2), 0),
        Equation(poles, sympy.tan(turns / (2 * at.order))),
        Equation(last, at.order * sympy.pi),
    )

    def checks() -> Checks:
        *full_turns, end = functions["singular_angles"](at.order)
        found = functions["poles"](at.order)
        yield "the number of poles less that of angles", len(found) - len(full_turns)
        places = [{turns: angle, poles: pole} for angle, pole in zip(full_turns, found, strict=False)]
        for equation, values in (*product(claim[:2], places), (claim[2], {last: end})):
            yield f"{equation.text} at {values}", (equation.left - equation.right).xreplace(values)
        yield "their number less the degree of q", len(set(full_turns)) - at.values[q][0].numerator.degrees()[-1] // 2
        outside = [angle for angle in full_turns if not 0 < angle / sympy.pi < at.order]
        yield "how many are not between 0 and nπ", len(outside)

    return decide(", ".join(names), claim, METHOD, checks, f"n = {at.order}")
