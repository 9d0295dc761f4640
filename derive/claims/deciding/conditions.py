"""Conditions of a claim, found from the points where a part of it has no value."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from ...algebra import Quaternion, Structure, Tensor
from ...algebra.matrix import Matrix
from ..language.calculus import BINDERS
from ..language.environment import Env
from ..language.matrices import at_least, at_most, greater, less, unlike
from ..language.operations import written
from ..language.operator_table import Re, cos, det, equal, nonzero, norm, over, quaternion_scalar, sin, trace
from ..language.printed import Number, Term, Trait, symbols
from ..language.substitution import written_out
from ..numbers.balls import BlurredError, precision
from ..numbers.fields import innermost
from .claim import Claim, kind
from .place import Place
from .places import Probe
from .singular import size
from .terms import is_dual
from .zeros import named


@dataclass(frozen=True)
class Exclusion:
    """Requirement ``subject relation`` of a claim for a value, such as ``norm(v) != 0``."""

    subject: Term
    relation: str

    @property
    def term(self) -> Term | None:
        """The requirement as a statement, if it is a relation."""
        sign, _, number = self.relation.partition(" ")
        if sign == "has":
            return equal(self.subject, self.subject)
        relation = {"!=": unlike, ">=": at_least, ">": greater, "<": less, "<=": at_most}.get(sign)
        subject = Re(self.subject) if is_dual(self.subject) else self.subject
        return None if relation is None else relation(subject, Number(int(number)))

    def __str__(self) -> str:
        if self.relation == "has a value":
            return f"{written(self.subject)} has a value"
        return f"{written(self.subject)} {self.relation}"


def fault(env: Env, node: Term) -> Exclusion | None:
    """Return the requirement that a term without a value violates: that of its deepest part without a value."""
    for argument in node.arguments:
        if _undefined(env, argument):
            return fault(env, argument)
    name, arguments = node.operator.name, node.arguments
    if name == "over":
        return Exclusion(_factor(env, arguments[1]), "!= 0")
    if name == "power" and isinstance(exponent := env.value(arguments[1]), Fraction) and exponent.denominator > 1:
        closed = exponent > 0 and exponent.denominator == 2 and not _vanishes(env, arguments[0])
        return Exclusion(arguments[0], ">= 0" if closed else "> 0")
    if name in ("power", "inverse"):
        return Exclusion(_factor(env, arguments[0]), "!= 0")
    if name == "norm":
        return Exclusion(Re(*arguments) if env.dual else node, "!= 0")
    if name == "root":
        return Exclusion(arguments[0], "> 0" if _vanishes(env, arguments[0]) else ">= 0")
    if name == "log":
        value = env.value(arguments[0])
        if isinstance(value, Tensor | Matrix):
            return Exclusion(trace(*arguments), "!= -1" if isinstance(value, Tensor) else "!= 0")
        if isinstance(value, Quaternion):
            return Exclusion(norm(*arguments) + quaternion_scalar(*arguments), "!= 0")
        if not isinstance(value, Structure):
            return Exclusion(arguments[0], "> 0")
    if name in ("acos", "asin"):
        return Exclusion(norm(arguments[0]), "< 1" if _vanishes(env, Number(1) - arguments[0] ** 2) else "<= 1")
    if name in ("tan", "cot"):
        return Exclusion((cos if name == "tan" else sin)(*arguments), "!= 0")
    if name == "atan2 of two":
        return Exclusion(norm(arguments[0]) + norm(arguments[1]), "!= 0")
    if name in BINDERS:
        return Exclusion(node, "has a value")
    zero = next((a for a in arguments if symbols(a) and _vanishes(env, a)), None)
    return Exclusion(node, "has a value") if zero is None else Exclusion(zero, "!= 0")


def _vanishes(env: Env, node: Term) -> bool:
    try:
        return bool(size(env.value(node)) == 0)
    except (ArithmeticError, TypeError, AttributeError, KeyError):
        return False


def _undefined(env: Env, node: Term) -> bool:
    try:
        env.value(node)
    except ArithmeticError:
        return True
    except (KeyError, TypeError):  # it has a letter that is bound further out, or is one
        return False
    return False


def _factor(env: Env, below: Term) -> Term:
    """Return the factor of a divisor that vanishes, or its determinant."""
    name, arguments = below.operator.name, below.arguments
    if name in ("negative", "bracket", "root") or (name == "power" and isinstance(arguments[1], Number)):
        return _factor(env, arguments[0])
    if name == "over":
        return _factor(env, arguments[0])
    if name == "times":
        for argument in arguments:
            if innermost(size(env.value(argument))) == 0:
                return _factor(env, argument)
    value = env.value(below)
    return det(below) if isinstance(value, Tensor | Matrix) else below


def exclusions(claim: Claim, places: Sequence[Place]) -> dict[Exclusion, Place]:
    """Return the requirements that the points without a value violate, each with the first such point.

    A requirement is left out if a stricter one of the same number is found.
    """
    found: dict[Exclusion, Place] = {}
    for place in places:
        with precision(256):
            try:
                requirement = fault(claim.env(place), written_out(claim.statement))
            except (ArithmeticError, BlurredError):
                continue
        if requirement is not None:
            found.setdefault(requirement, place)
    weaker = {replace(one, relation=f"{one.relation[0]}={one.relation[1:]}") for one in found if one.relation[1] == " "}
    return {one: place for one, place in found.items() if one not in weaker}


def plain(probe: Probe, requirement: Exclusion) -> str:
    """Return a requirement in plain form: by values of the letter if it has only one, else as it stands."""
    letters = [a for a in symbols(requirement.subject) if a in probe.claim.letters]
    if requirement.relation != "has a value" and any(a in probe.claim.coordinates and kind(a).dual for a in letters):
        requirement = replace(requirement, subject=_real(requirement.subject))
    shown = replace(requirement, subject=probe.claim.entry.contracted(requirement.subject))
    alone = len(letters) == 1 and letters[0] in probe.claim.coordinates
    if requirement.relation == "!= 0" and alone and requirement.subject not in (*letters, *map(norm, letters)):
        along = probe.roots_along(requirement.subject, letters[0])
        return (along and along[1] and values_excluded(*along)) or str(shown)
    return str(shown)


def _real(subject: Term) -> Term:
    if subject.operator is norm:
        return norm(_real(*subject.arguments))
    return subject if subject.operator is Re else Re(subject)


def values_excluded(name: str, roots: Sequence[float], vanishes: Callable[[float], bool]) -> str:
    """Return the condition that a number has none of some values; empty if they show no pattern that goes on."""
    shown = [named(t) for t in sorted(roots, key=lambda t: (abs(t), -t))]
    if any("." in t for t in shown):
        return ""
    if len(shown) == 1 or (len(shown) == 2 and "pi" not in shown[1]):
        return " and ".join(f"{name} != {t}" for t in shown)
    steps = sorted({abs(t) for t in roots})
    gap = steps[1] - steps[0] if steps[0] else steps[1]
    further = [end + (gap if end > 0 else -gap) for end in (max(roots), min(roots)) if end > 0 or min(roots) < 0]
    if all(abs(t / gap - round(t / gap)) < 1e-9 for t in steps) and all(map(vanishes, further)):
        first = f"k = {round(steps[0] / gap)}, {round(steps[0] / gap) + 1}, …" if min(roots) >= 0 else "any integer k"
        unit = named(gap).replace("pi", "k*pi") if "pi" in named(gap) else f"{named(gap)}*k"
        return f"{name} != {unit} for {first}"
    return ""


def is_sharp(condition: Term, statement: Term) -> bool:
    """Return whether the denominators of a statement show that it is undefined outside a condition.

    Each part of the condition must require a nonzero real part of a term, and the statement must always divide by that
    term. The test is sufficient only: False means that the denominators do not show sharpness.
    """
    needed = set(_needed(statement))
    return all(_subject(part) in needed for part in _parts(condition))


def _parts(condition: Term) -> Iterator[Term]:
    if Trait.JOINS in condition.operator.traits and not condition.operator.lazy:
        for part in condition.arguments:
            yield from _parts(part)
    else:
        yield condition


def _subject(part: Term) -> Term | None:
    """Return a if the condition is ``a ≠ 0`` or ``Re a ≠ 0``, else None."""
    if part.operator is not nonzero:
        return None
    (subject,) = part.arguments
    return subject.arguments[0] if subject.operator is Re else subject


def _needed(node: Term) -> Iterator[Term]:
    """Yield the terms whose real part must be nonzero for a statement to have a value."""
    if node.operator.lazy and node.operator.name != "power":
        return
    if node.operator is over:
        yield from _factors(node.arguments[1])
    elif node.operator.name == "power" and _is_negative(node.arguments[1]):
        yield det(node.arguments[0])
        yield from _factors(node.arguments[0])
    elif Trait.OVER_COSINE in node.operator.traits:
        yield cos(node.arguments[0])
    elif Trait.OVER_SINE in node.operator.traits:
        yield sin(node.arguments[0])
    for argument in node.arguments:
        yield from _needed(argument)


def _factors(below: Term) -> Iterator[Term]:
    """Yield a denominator and its factors, including factors inside powers and magnitudes."""
    yield below
    is_power = below.operator.name == "power" and not _is_negative(below.arguments[1])
    if is_power or below.operator.name in ("times", "root") or Trait.LENGTH in below.operator.traits:
        for factor in below.arguments[: 1 if is_power else None]:
            yield from _factors(factor)


def _is_negative(exponent: Term) -> bool:
    return isinstance(exponent, Number) and exponent.value < 0
