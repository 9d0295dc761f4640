"""Parts of terms: operators that occur, differences of relations, and what vanishes where a term does."""

from __future__ import annotations

from typing import Any

from ..language.operator_table import RELATIONS, Du, Re, both, cos, difference, epsilon, sin
from ..language.printed import Apply, Number, Symbol, Term, Trait, distinct, symbols, walk, with_trait
from ..numbers.kinds import BRANCH, KINDS, ORDER, QUANTITIES

WHOLE = (ORDER, BRANCH, QUANTITIES["index"], QUANTITIES["integer"])
"""Quantities of whole numbers."""
STRICT = {"less": True, "at most": False, "greater": True, "at least": False}
"""Order relations, with whether they exclude equality."""
SUMS = ("plus", "minus", "negative", "bracket")
"""Operators of sums."""
COMPONENTWISE = frozenset(("vector", "matrix", "block", "entry", "kron", "vec", "zeros"))
"""First words of operators that depend on the frame."""


def at_zero(statement: Term, zero: Term | None, dual: bool) -> Term:
    """Return a statement with 0 for both sides of the relations whose sides differ by a number that vanishes.

    Of dual numbers the real part vanishes alone, for the dual parts of a line are not those of a point.
    """
    if zero is None:
        return statement
    pairs = {node: node.arguments for node in walk(statement) if node.operator.name in RELATIONS}
    known = {node: node.operator(*[Number(0)] * len(sides)) for node, sides in pairs.items()
             if len(sides) < 3 and not (dual and _depends_on_dual_parts(*sides))
             and bare(difference(node)) == zero}  # fmt: skip
    found: Term = statement.xreplace(known)
    return found


def _depends_on_dual_parts(*sides: Term) -> bool:
    return any(map(is_dual, sides)) or Du.name in operators(*sides)


def takes_parts(*parts: Term) -> bool:
    """Return whether terms take or give dual parts."""
    return bool(with_trait(Trait.APART, *parts)) or epsilon in (a for part in parts for a in symbols(part))


def is_dual(side: Term) -> bool:
    """Return whether a side may have a dual part."""
    if not isinstance(side, Symbol):
        return side.operator not in (Re, Du) and any(map(is_dual, side.arguments))
    return side == epsilon or (side.quantity.name in KINDS and KINDS[side.quantity.name].dual)


def whole(side: Term) -> Term:
    """Return a side, or the magnitude of one, without the operators for its real part."""
    if side.operator.name == "norm":
        return side.operator(whole(side.arguments[0]))
    return whole(side.arguments[0]) if side.operator is Re else side


def is_frame_free(*statements: Term) -> bool:
    """Return whether all vectors may be turned together, as no component is taken."""
    return COMPONENTWISE.isdisjoint(name.split()[0] for name in operators(*statements) if name)


def conjuncts(domain: Term | None) -> list[Term]:
    """Return the relations that a domain joins by "and"."""
    if domain is None:
        return []
    return [part for one in domain.arguments for part in conjuncts(one)] if domain.operator is both else [domain]


def magnitudes(statement: Term) -> set[Term]:
    """Return the magnitudes in a statement that are no factors of powers with a slope at 0."""
    if statement.operator.name == "norm":
        return {statement, *magnitudes(statement.arguments[0])}
    parts = [statement.arguments[0]] if _is_smooth_power(statement) else statement.arguments
    found: set[Term] = set().union(*map(_magnitudes_of_factors if _is_smooth_power(statement) else magnitudes, parts))
    return found


def _magnitudes_of_factors(part: Term) -> set[Term]:
    if part.operator.name == "norm":
        return magnitudes(part.arguments[0])
    is_product = part.operator.name in ("times", "over", "bracket", "negative")
    found: set[Term] = set().union(*map(_magnitudes_of_factors, part.arguments)) if is_product else magnitudes(part)
    return found


def _is_smooth_power(node: Term) -> bool:
    """Return whether a term is a power, at least the second, which has a slope where a magnitude in its base is 0."""
    if node.operator.name != "power":
        return False
    exponent = node.arguments[1]
    return exponent.value >= 2 if isinstance(exponent, Number) else _is_even(exponent)


def _is_even(exponent: Term) -> bool:
    """Return whether an exponent is even by its form, as ``2*k`` and ``4*(m - 1) + 2`` are."""
    name, arguments = exponent.operator.name, exponent.arguments
    if isinstance(exponent, Number):
        return exponent.value % 2 == 0
    if name == "times":
        return any(map(_is_even, arguments)) and all(map(_is_whole, arguments))
    return name in SUMS and all(map(_is_even, arguments))


def _is_whole(term: Term) -> bool:
    """Return whether a term is a whole number by its form, of sums and products."""
    if isinstance(term, Number | Symbol):
        return term.value.denominator == 1 if isinstance(term, Number) else term.quantity in WHOLE
    return term.operator.name in (*SUMS, "times") and all(map(_is_whole, term.arguments))


def operators(*statements: Term) -> set[str]:
    return {node.operator.name for statement in statements for node in distinct(statement)}


def bare(part: Term) -> Term:
    """Return a part without signs, brackets, powers, magnitudes and divisors, which vanishes at the same points."""
    part = _quotient(part)[0]
    name, arguments = part.operator.name, part.arguments
    power = name == "power" and isinstance(arguments[1], Number) and arguments[1].value > 0
    return bare(arguments[0]) if power or name in ("negative", "bracket", "norm", "root", "Re") else part


def _quotient(part: Term) -> tuple[Term, Term | None]:
    """Return a term as numerator and divisor; without a divisor the term itself and None."""
    name, arguments = part.operator.name, part.arguments
    if name in ("tan", "cot"):
        above, below = (sin, cos) if name == "tan" else (cos, sin)
        return above(*arguments), below(*arguments)
    if name not in ("plus", "minus", "times", "over", "negative", "bracket"):
        return part, None
    (a, b), *rest = map(_quotient, arguments)
    if not rest:
        return (part, None) if b is None else (-a if name == "negative" else a, b)
    ((c, d),) = rest
    if name == "over":
        return _product(a, d), _product(c, b)
    if b is None and d is None:
        return part, None
    if name == "times":
        return Apply("times", a, c), _product(b, d)
    return Apply(name, _product(a, d), _product(c, b)), _product(b, d)


def _product(a: Term | None, b: Term | None) -> Any:
    return b if a is None else a if b is None else a * b
