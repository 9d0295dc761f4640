"""Proof of a claim at independent generators: for every order at once, then exactly or modulo a random prime.

Such a proof shows that both sides are equal wherever both have a value; it shows no value. Modulo a prime a proof is
fast, and large formulas have no other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import lru_cache, partial
from itertools import permutations
from math import lcm, prod
from typing import Any

from ...algebra.element import NotExactError
from ..equation import Entry
from ..language.environment import Env
from ..language.matrices import unlike
from ..language.operations import written
from ..language.operator_table import Du, Re, difference, equal, over, pi
from ..language.printed import Number, Symbol, Term, Trait, symbols, walk
from ..language.values import coefficients
from ..numbers.fields import innermost
from ..numbers.generators import Generators
from ..numbers.kinds import BRANCH, KINDS, ORDER
from ..numbers.residues import SURE_BITS, Residues, UnluckyError
from .claim import Claim
from .constrained import gaps
from .frames import with_frames_at_rest, with_free_product
from .polar import Polar, Way, bounds, closed_letters
from .solved import with_solved_equations
from .terms import STRICT, is_frame_free, operators, takes_parts

PRIMES_MAX = 40
"""Largest number of primes that are tried for one with all roots."""
TESTS = 2**20
"""More equalities than a proof tests."""
MODULO, EVERY = "proved modulo a random prime", "exact, all n"
"""Words for a proof modulo a prime, and for one of every order."""
CUT = frozenset(("floor of number", "negated", "implies", "iff", "cases"))
"""Operators that jump: a claim that is true at generic values may be false at special ones."""
ANGLES = frozenset(("real", "real angle", "dual number", "angle"))
"""Kinds of numbers that may be any number."""
INTEGERS = frozenset(("integer", "order", "branch"))
ABSENT = (ArithmeticError, TypeError, AttributeError, KeyError, ValueError, IndexError)
"""Errors of a number that a field does not have."""
Make = Callable[..., Generators]


def proved(claim: Claim) -> str | None:
    """Return how a claim is proved where both sides have a value, or None."""
    modulo = f"{MODULO}, error < 2^-{SURE_BITS}"
    if orders_of(claim):
        return _first_proof(claim, (proved_for_all_orders, EVERY), (proved_by_roots, EVERY))
    return _first_proof(claim, (proved_exactly, "exact"), (proved_modulo, modulo), (proved_by_roots, "exact"))


def proved_at_orders(claim: Claim) -> str | None:
    """Return at which orders a claim about every order is proved, which is no proof of it; or None."""
    return _first_proof(claim, (proved_exactly, f"exact{orders_of(claim)}")) if orders_of(claim) else None


def _first_proof(claim: Claim, *ways: tuple[Callable[[Claim], bool], str]) -> str | None:
    for prove, how in ways:
        with suppress(NotExactError):
            if prove(claim):
                return how
    return None


def orders_of(claim: Claim) -> str:
    """Return the orders at which a claim is proved here, if it is about more of them."""
    if claim.entry.orders is not None:
        return ""
    found = {value: None for fixed in claim.choices for a, value in fixed.items() if a.quantity is ORDER}
    return f", n = {', '.join(map(str, found))}" if found else ""


def proved_modulo(claim: Claim) -> bool:
    """Return whether a claim is true for all signs of roots, modulo a random prime."""
    for attempt in range(PRIMES_MAX):
        seed = f"{written(claim.statement)} {attempt}"
        try:
            return _for_all_signs(claim, partial(Residues, seed=seed))
        except UnluckyError:
            continue
    return False


def proved_exactly(claim: Claim) -> bool:
    """Return whether a claim is true for all signs of roots, exactly."""
    return _for_all_signs(claim, Generators)


def proved_for_all_orders(claim: Claim) -> bool:
    """Return whether a claim is true for letters as its orders and branches, exactly."""
    return _for_all_signs(claim, Generators, claim.general)


def proved_by_roots(claim: Claim) -> bool:
    """Return whether a claim with π is true if sines of multiples of π are written by square roots."""
    roots = partial(Generators, radicals=True)
    return pi in symbols(claim.statement) and _for_all_signs(claim, roots, claim.general)


def every_sign(setting_of: Callable[[tuple[int, ...]], Env]) -> Iterator[Env]:
    """Yield the environments for all signs of the roots of unknown sign, which evaluation in the one before finds."""
    waiting: list[tuple[int, ...]] = [()]
    while waiting:
        signs = waiting.pop()
        env = setting_of(signs)
        yield env
        field: Any = env.field
        waiting += [(*field.signs[:i], -1) for i in range(len(signs), len(field.roots))]


def _for_all_signs(claim: Claim, make: Make, choices: Sequence[Mapping[Symbol, int]] | None = None) -> bool:
    """Return whether a claim is true for all orders and for all signs of roots whose sign is unknown.

    Raise NotExactError if the field cannot tell.
    """
    claim, _ = with_free_product(with_solved_equations(claim)[0])
    claim, _ = with_frames_at_rest(claim)
    try:
        every = claim.choices if choices is None else choices
        envs = (env for fixed in every for env in every_sign(partial(setting, claim, make, fixed)))
        return all(_is_true(env, claim.statement) for env in envs)
    except (NotExactError, UnluckyError):
        raise
    except ABSENT as error:
        raise NotExactError("no generic value") from error


def _is_true(env: Env, statement: Term) -> bool:
    true = bool(env.value(statement))
    if isinstance(env.field, Residues) and not env.field.is_sure(TESTS):
        raise NotExactError("a formula too large for the prime")
    return true


def jumps(statement: Term) -> bool:
    """Return whether a statement has an operator that jumps; the name of ``cases`` ends with its number of arms.

    Equations as alternatives do not: one that is true at generic values is true wherever both sides have values. Nor
    does the floor of integers, which a proof takes for odd and for even ones.
    """
    if statement.operator.name == "or":
        return any(jumps(part) or part.operator.name not in ("or", "equal") for part in statement.arguments)
    if statement.operator.name == "floor of number":
        return not {letter.quantity.name for letter in symbols(statement)} <= {"index", *INTEGERS}
    return statement.operator.name.rstrip("0123456789") in CUT or any(map(jumps, statement.arguments))


def setting(
    claim: Claim, make: Make, fixed: Mapping[Symbol, int], signs: Sequence[int] = (), way: Way = Way.POLAR,
    steps: int = 0,
) -> Env:  # fmt: skip
    """Return the environment of a claim over independent generators, for one choice of orders.

    Dual letters have their real parts alone unless the claim takes dual parts: an identity of differentiable functions
    also holds for dual numbers. Angles are taken in `steps` or finer parts.
    """
    domain = claim.domain
    steps = steps or 2 * lcm(2, whole_steps(claim.statement))
    steps = lcm(steps, *(4 * n for a, n in fixed.items() if a.quantity is ORDER))
    field = partial(make, steps=steps, signs=signs)
    if claim.constraints:
        way = Way.COMPONENTS
    dual = takes_parts(claim.statement, *claim.constraints) or Du.name in operators(*claim.parts)
    counts = [a for a in claim.letters if a.quantity in (ORDER, BRANCH) and a not in fixed]
    turning = bool(counts) and is_frame_free(*claim.parts)
    given = bounds(domain), field, closed_letters(domain), dual, way, counts, turning
    letters = Polar(claim.coordinates, claim.depth, *given)
    env = Env(letters.field, letters.values | dict(fixed), dual, claim.depth)
    for letter, turns in _turned(claim.statement).items():
        if letter in env.values and letter.name not in {name.partition("/")[0] for name in given[0]}:
            env.values[letter] = env.values[letter] - env.value(turns)
    if claim.constraints:
        letters.field.restrict_to([letters.field.element(gap) for gap in gaps(env, claim.constraints)])
    for part in domain:
        if part.operator.name in STRICT:
            with suppress(*ABSENT):
                letters.field.assumed.append(letters.field.element(not_negative(env, part)))
    return env


def _turned(statement: Term) -> dict[Symbol, Term]:
    """Return the multiples of π that a statement adds to numbers, of which new letters then are the sum."""
    found: dict[Symbol, Term] = {}
    for node in walk(statement):
        for a, b in permutations(node.arguments) if node.operator.name in ("plus", "minus") else ():
            names = {letter.quantity.name for letter in symbols(b)}
            if isinstance(a, Symbol) and a.quantity.name in ANGLES and "π" in names and names <= {"π", *INTEGERS}:
                found.setdefault(a, b if node.operator.name == "plus" else -b)
    return found


def contradicts_itself(claim: Claim) -> bool:
    """Return whether the domain, where its equations hold, says that 0 is not 0 or that another number is."""
    solved, _ = with_solved_equations(claim)
    parts = solved.domain
    if claim.entry.claimed in (None, solved.entry.claimed) or not parts:
        return False
    return any(_is_never_true(solved.on(None), part) for part in parts)


@lru_cache(maxsize=256)
def vanishes_without(part: Term, letter: Symbol) -> bool:
    """Return whether the real part of a term is 0 where that of a letter is."""
    claim, _ = with_solved_equations(Claim(Entry("", ()), Re(part)).on(equal(Re(letter), 0)))
    return _is_never_true(claim, unlike(claim.statement, 0))


def _is_never_true(claim: Claim, part: Term) -> bool:
    """Return whether a relation of no order, branch or sign is false for all signs of roots."""
    if not all(a.quantity.name in KINDS or not a.quantity.varies for a in symbols(part)):
        return False
    try:
        envs = every_sign(partial(setting, claim, Generators, claim.choices[0]))
        return not any((takes_parts(part) and not env.dual) or not _is_false(env, part) for env in envs)
    except ABSENT:
        return False


def _is_false(env: Env, part: Term) -> bool:
    """Return whether a relation says that 0 is not 0, or that another rational number is."""
    field: Any = env.field
    with suppress(*ABSENT):
        if part.operator.name in ("unlike", "nonzero"):
            return not env.value(part)
        if part.operator.name == "equal":
            gaps = [field.element(innermost(c)) for c in coefficients(env.value(difference(part)))]
            lowest = [field.ring.fraction(gap.numerator, gap.denominator, lowest_terms=True) for gap in gaps]
            return any(gap and not field.used(gap) for gap in lowest)
    return False


def not_negative(env: Env, part: Term) -> Any:
    """Return the number that an order relation says not to be negative."""
    gap = innermost(env.now(env.value(difference(part))))
    return gap if part.operator.name in ("greater", "at least") else -gap


def whole_steps(statement: Term) -> int:
    """Return an integer M such that a statement contains only multiples of α/M, for each free angle α.

    It is a multiple of all divisors, and of their products within an argument, as 4 of ``x/2/2``.
    """

    def of(node: Term) -> int:
        below = [of(a) for a in node.arguments]
        if Trait.TRANSCENDENTAL in node.operator.traits:
            found.extend(below)
            return 1
        if node.operator is over and isinstance(number := node.arguments[1], Number) and number.value:
            found.append(abs(number.value))
            return below[0] * abs(number.value)
        return prod(below) if node.operator.name == "times" else lcm(1, *below)

    found: list[int] = [1]
    of(statement)
    return lcm(*found)
