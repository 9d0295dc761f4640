"""Controls: theorems with one deliberate error each, whose proof must fail.

Controls alter each equation of a claim, each integer in it, each premise, each free symbol and each multiplier. At one
order they alter each formula, claim, premise and definition of the componentwise road. If a control is proved, then a
check cannot fail, a premise is unused, or a theorem claims too little.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, fields, replace
from typing import Any

import sympy

from ..algebra import Isotropic
from ..algebra.arithmetic import Arithmetic
from ..maps.chart import Chart
from ..maps.families import alpha
from .at_order import CayleyFormulas, instances
from .components import STATEMENTS, Components, hamilton
from .computations import Computed, computations
from .identity import NO_VALUE, Proof
from .scalars import BENDS, SLOPES, VALUES, ScalarProofs
from .statement import Premise
from .theorem import Theorem


@dataclass(frozen=True)
class Control:
    """Theorem with one deliberate error.

    Attributes
    ----------
    theorem : str
        Name of the theorem.
    alteration : str
        Description of the error.
    proof : Proof
        Outcome of deciding the altered theorem.
    """

    theorem: str
    alteration: str
    proof: Proof

    @property
    def noticed(self) -> bool:
        """True if the altered theorem failed, and every expression in it has a value."""
        return not self.proof.proved and all(residue.label != NO_VALUE for residue in self.proof.residues)

    def __str__(self) -> str:
        return f"{self.theorem}: {self.alteration}"


def controls(claimed: Iterable[Theorem], known: Mapping[str, Proof]) -> Iterator[Control]:
    """Yield all controls of theorems.

    Parameters
    ----------
    claimed : iterable of Theorem
    known : mapping of str to Proof
        The proofs of these theorems, by name.
    """
    for theorem in claimed:
        yield from _of_claim(theorem, known)
        yield from _of_premises(theorem, known)
        for hypothesis, method in theorem.method.weaker():
            yield Control(theorem.name, hypothesis, replace(theorem, method=method).decide(known))
        for multiplier in known[theorem.name].multipliers:
            zeroed = theorem.decide(known, multiplier.expression)
            yield Control(theorem.name, f"multiplier 0 in place of {multiplier.text}", zeroed)


def _of_claim(theorem: Theorem, known: Mapping[str, Proof]) -> Iterator[Control]:
    for place, equation in enumerate(theorem.claim):
        for variant in equation.variants(theorem.method.sides):
            proof = theorem.with_claim(place, variant).decide(known)
            yield Control(theorem.name, f"claim {variant.text} in place of {equation.text}", proof)


def _of_premises(theorem: Theorem, known: Mapping[str, Proof]) -> Iterator[Control]:
    for place, premise in enumerate(theorem.premises):
        altered = replace(premise.altered(), theorem="")
        proof = theorem.with_premise(place, altered).decide(known)
        yield Control(theorem.name, f"premise {altered.equation.text} in place of {premise}", proof)


# ---- at one order -----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Wrong:
    """Cayley map or other chart with one formula replaced."""

    right: Any
    name: str
    value: Any

    def __getattr__(self, name: str) -> Any:
        return self.value if name == self.name else getattr(self.right, name)


@dataclass(frozen=True)
class _Coefficients:
    coefficients: tuple[sympy.Expr, ...]


class _Doubled(Components):
    """z = (1 + 2v)ⁿ"""

    def defined(self) -> Any:
        return self.power([self.one, *(c + c for c in self.v)])


class _Zero(Components):
    """z = 0."""

    def defined(self) -> Any:
        return [self.zero] * 4


class _Unconjugated(Components):
    """z r z in place of z r z*."""

    def sandwich(self, r: Any) -> Any:
        return hamilton(hamilton(self.z, r), self.z)


DEFINITION, QUATERNION, TENSOR, ORTHOGONALITY, TWIST, INVERSE = range(6)
"""Indices of the statements of the componentwise road."""

_FORMULAS: Mapping[str, tuple[int, ...]] = {
    "p": (), "q": (), "c": (), "d": (), "quaternion": (QUATERNION,), "tensor": (TENSOR,), "tangent": (TWIST, INVERSE),
    "tangent_inv": (INVERSE,),
}  # fmt: skip
"""Indices of the statements that must fail when a formula is wrong; its instance must fail too."""

_DEFINITIONS: Mapping[type[Components], tuple[int, ...]] = {
    _Doubled: (DEFINITION, QUATERNION, TENSOR, TWIST),
    _Unconjugated: (TENSOR, ORTHOGONALITY, TWIST),
    _Zero: (DEFINITION, QUATERNION, TENSOR, ORTHOGONALITY, TWIST),
}
"""Indices of the statements that must fail when a definition is wrong."""

LOWERED, RELATED, DERIVED, DERIVED_TWICE = range(4)
"""Indices of the statements about the scalars of a chart; the statement about φ is the last."""


def controls_at(cayley: CayleyFormulas) -> Iterator[Control]:
    """Yield all controls of a Cayley map at its order; each alters one formula, claim, premise or definition."""
    for name, places in _FORMULAS.items():
        for alteration, wrong in _altered(cayley, name):
            name_in_code = f"Cayley({cayley.order}).{name}"
            failing = next(proof for proof in instances(wrong) if name_in_code in proof.name.split(", "))
            yield Control(failing.name, alteration, failing)
            decided = tuple(Components(wrong).proofs()) if places else ()
            yield from (Control(decided[place].name, alteration, decided[place]) for place in places)
    for field in fields(Computed):
        functions = replace(Computed(), **{field.name: _off(field.default)})
        failing = next(proof for proof in computations(cayley.order, functions) if f".{field.name}(" in proof.name)
        yield Control(failing.name, f"{field.name} off by one", failing)
    altered_statements = [(name, tuple(e.altered() for e in claim), premises) for name, claim, premises in STATEMENTS]
    for proof in Components(cayley).proofs(altered_statements):
        yield Control(proof.name, f"claim {proof.statement}", proof)
    for place in range(max(len(premises) for _, _, premises in STATEMENTS)):
        altered_statements = [(name, claim, _with_altered(place, premises)) for name, claim, premises in STATEMENTS]
        for proof in Components(cayley).proofs(altered_statements):
            if place < len(proof.premises):
                yield Control(proof.name, f"premise {proof.premises[place]}", proof)
    for altered, places in _DEFINITIONS.items():
        decided = tuple(altered(cayley).proofs())
        yield from (Control(decided[place].name, str(altered.__doc__), decided[place]) for place in places)


def controls_of(chart: Chart) -> Iterator[Control]:
    """Yield all controls of a chart: each adds x to one scalar, or replaces φ."""
    for name in (*VALUES, *SLOPES, *BENDS):

        def scalars(x: Any, m: Arithmetic, name: str = name) -> Any:
            at = chart.scalars(x, m)
            return _Wrong(at, name, getattr(at, name) + x)

        wrong: Any = _Wrong(chart, "scalars", scalars)
        decided = tuple(ScalarProofs(wrong).proofs())
        for place in (LOWERED, RELATED) if name in VALUES else (DERIVED if name in SLOPES else DERIVED_TWICE,):
            yield Control(decided[place].name, f"{name} + x", decided[place])
    start = sympy.Rational(3, 4)  # tangent of an angle with rational cosine
    altered = {"phi of twice the angle": chart.phi.xreplace({alpha: 2 * alpha})}
    if chart.cayley:  # the tangent of a sum obeys the same differential equation
        altered["phi that begins elsewhere"] = (chart.phi + start) / (1 - start * chart.phi)
    for alteration, other in altered.items():
        wrong = _Wrong(chart, "phi", other)
        *_, failing = ScalarProofs(wrong).proofs()
        yield Control(failing.name, alteration, failing)


def _with_altered(place: int, premises: tuple[Premise, ...]) -> tuple[Premise, ...]:
    return tuple(premise.altered() if k == place else premise for k, premise in enumerate(premises))


def _altered(cayley: CayleyFormulas, name: str) -> Iterator[tuple[str, CayleyFormulas]]:
    """Yield copies of the map with one coefficient altered: increased by one, or doubled in the quaternion."""
    value = getattr(cayley, name)
    if isinstance(value, sympy.Expr):
        yield f"{name} + 1", _Wrong(cayley, name, value + 1)
        return
    for place, coefficient in enumerate(value.coefficients):
        changed = (*value.coefficients[:place], coefficient + 1, *value.coefficients[place + 1 :])
        if name == "quaternion":  # doubled coefficients still have rational squares
            changed = tuple(c * (2 if k == place else 1) for k, c in enumerate(value.coefficients))
        yield f"coefficient {place + 1} of {name}", _Wrong(cayley, name, _Coefficients(changed))


def _off(function: Any) -> Callable[..., Any]:
    """Return a function that increases the first number of the result by one."""

    def wrong(*arguments: Any) -> Any:
        result = function(*arguments)
        if isinstance(result, Isotropic):
            return replace(result, a=result.a + 1)
        if isinstance(result, tuple):
            return (result[0] + 1, *result[1:]) if result else (1,)
        return result + 1

    return wrong
