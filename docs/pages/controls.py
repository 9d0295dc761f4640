"""Controls: theorems with one deliberate error each; every control must fail.

Controls alter each equation of a claim, each integer in it, each premise, each free symbol and each multiplier. At one
order, controls alter each formula, claim, premise and definition of the proofs by components. A proved control reveals
a check that cannot fail, an unused premise, or too weak a claim.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any

import sympy

from derive.algebra import Isotropic
from derive.algebra.arithmetic import Arithmetic
from derive.maps import Cayley
from derive.maps.chart import Chart
from derive.maps.elementary import alpha
from derive.proof.at_order import FUNCTIONS, Function, computations, instances
from derive.proof.components import STATEMENTS, Components, hamilton, times
from derive.proof.identity import NO_VALUE, Equation, Proof
from derive.proof.methods import Theorem
from derive.proof.notation import Shifted
from derive.proof.scalars import BENDS, SLOPES, VALUES, ScalarProofs


@dataclass(frozen=True)
class Control:
    """Name of a theorem, description of one deliberate error in it, and outcome of deciding the altered theorem."""

    theorem: str
    alteration: str
    proof: Proof

    @property
    def noticed(self) -> bool:
        """Tell whether the altered theorem failed, with a value for every expression in it."""
        return not self.proof.proved and all(residue.label != NO_VALUE for residue in self.proof.residues)

    def __str__(self) -> str:
        return f"{self.theorem}: {self.alteration}"


def controls(claimed: Iterable[Theorem], known: Mapping[str, Proof]) -> Iterator[Control]:
    """Yield all controls of theorems, given the proofs of these theorems by name."""
    for theorem in claimed:
        for alteration, altered in _altered_theorems(theorem):
            yield Control(theorem.name, alteration, altered.decide(known))
        for multiplier in known[theorem.name].multipliers:
            zeroed = theorem.decide(known, multiplier.expression)
            yield Control(theorem.name, f"multiplier 0 in place of {multiplier.text}", zeroed)


def _altered_theorems(theorem: Theorem) -> Iterator[tuple[str, Theorem]]:
    for place, equation in enumerate(theorem.claim):
        for variant in variants(equation, theorem.method.sides):
            yield f"claim {variant.text} in place of {equation.text}", theorem.with_claim(place, variant)
    for place, premise in enumerate(theorem.premises):
        altered = replace(premise.altered(), theorem="")
        yield f"premise {altered.equation.text} in place of {premise}", theorem.with_premise(place, altered)
    for hypothesis, method in theorem.method.weaker():
        yield hypothesis, replace(theorem, method=method)


def variants(equation: Equation, sides: Iterable[str] = ("left", "right")) -> Iterator[Equation]:
    """Yield the altered equation, and copies with one integer of these sides increased by one."""
    yield equation.altered()
    for side in sides:
        changed = (e for e in _increased(getattr(equation, side)) if e != getattr(equation, side))
        yield from (replace(equation, numbers=(), **{side: e}) for e in changed)


def _increased(expression: sympy.Expr) -> Iterator[sympy.Expr]:
    """Yield copies of the expression, each with one integer increased by one."""
    if expression.is_Integer:
        yield expression + (1 if expression != -1 else 2)  # an exponent of 0 would leave 1
    if isinstance(expression, Shifted):  # the integer is a place of evaluation
        return
    for place, argument in enumerate(expression.args):
        named = expression.is_Pow and not expression.exp.is_Integer and not argument.is_commutative  # (1 + v)^n
        if isinstance(argument, sympy.Expr) and not named:
            for changed in _increased(argument):
                yield expression.func(*expression.args[:place], changed, *expression.args[place + 1 :])


# ---- at one order -----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Wrong:
    """Cayley map or other chart with one formula replaced."""

    right: Any
    name: str
    value: Any

    def __getattr__(self, name: str) -> Any:
        return self.value if name == self.name else getattr(self.right, name)


class _Doubled(Components):
    """Definition of z altered to (1 + 2v)ⁿ."""

    def defined(self) -> Any:
        return self.power([self.one, *times(self.v, self.one + self.one)])


class _Zero(Components):
    """Definition of z altered to 0."""

    def defined(self) -> Any:
        return times(self.identity[0], self.zero)


class _Unconjugated(Components):
    """Sandwich z r z* altered to z r z."""

    def sandwich(self, r: Any) -> Any:
        return hamilton(hamilton(self.z, r), self.z)


DEFINITION, QUATERNION, TENSOR, ORTHOGONALITY, TWIST, INVERSE = range(6)
"""Indices of the statements proved by components."""

_FORMULAS: Mapping[str, tuple[int, ...]] = {
    "p": (), "q": (), "c": (), "d": (), "quaternion": (QUATERNION,), "tensor": (TENSOR,), "tangent": (TWIST, INVERSE),
    "tangent_inv": (INVERSE,),
}  # fmt: skip
"""Indices of the statements that must fail when a formula is wrong; the instance of the formula must fail too."""

_DEFINITIONS: Mapping[type[Components], tuple[int, ...]] = {
    _Doubled: (DEFINITION, QUATERNION, TENSOR, TWIST),
    _Unconjugated: (TENSOR, ORTHOGONALITY, TWIST),
    _Zero: (DEFINITION, QUATERNION, TENSOR, ORTHOGONALITY, TWIST),
}
"""Indices of the statements that must fail when a definition is wrong."""

LOWERED, RELATED, DERIVED, DERIVED_TWICE = range(4)
"""Indices of the statements about the scalars of a chart; the statement about φ is the last."""


def controls_at(cayley: Cayley) -> Iterator[Control]:
    """Yield all controls of a Cayley map at its order; each alters one formula, claim, premise or definition."""
    for name, places in _FORMULAS.items():
        for alteration, wrong in _altered_formulas(cayley, name):
            name_in_code = f"Cayley({cayley.order}).{name}"
            failing = next(proof for proof in instances(wrong) if name_in_code in proof.name.split(", "))
            decided = tuple(Components(wrong).proofs()) if places else ()
            for proof in (failing, *(decided[place] for place in places)):
                yield Control(proof.name, alteration, proof)
    for name, function in FUNCTIONS.items():
        altered = computations(cayley.order, {**FUNCTIONS, name: _off(function)})
        failing = next(proof for proof in altered if f".{name}(" in proof.name)
        yield Control(failing.name, f"{name} off by one", failing)
    yield from _altered_statements(cayley)
    for definition, places in _DEFINITIONS.items():
        decided = tuple(definition(cayley).proofs())
        yield from (Control(decided[place].name, str(definition.__doc__), decided[place]) for place in places)


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
    start = sympy.Rational(3, 4)  # tangent of an angle whose cosine is rational
    altered = {"phi of twice the angle": chart.phi.xreplace({alpha: 2 * alpha})}
    if chart.cayley:  # the tangent of a sum obeys the same differential equation
        altered["phi that begins elsewhere"] = (chart.phi + start) / (1 - start * chart.phi)
    for alteration, other in altered.items():
        wrong = _Wrong(chart, "phi", other)
        *_, failing = ScalarProofs(wrong).proofs()
        yield Control(failing.name, alteration, failing)


def _altered_statements(cayley: Cayley) -> Iterator[Control]:
    components = Components(cayley)
    false = [(name, tuple(e.altered() for e in claim), premises) for name, claim, premises in STATEMENTS]
    for proof in components.proofs(false):
        yield Control(proof.name, f"claim {proof.statement}", proof)
    for place in range(max(len(premises) for _, _, premises in STATEMENTS)):
        altered = [
            (name, claim, tuple(premise.altered() if k == place else premise for k, premise in enumerate(premises)))
            for name, claim, premises in STATEMENTS
        ]
        for proof in components.proofs(altered):
            if place < len(proof.premises):
                yield Control(proof.name, f"premise {proof.premises[place]}", proof)


def _altered_formulas(cayley: Cayley, name: str) -> Iterator[tuple[str, Any]]:
    """Yield copies of the map with one coefficient altered: increased by one, or doubled in the quaternion."""
    value = getattr(cayley, name)
    if isinstance(value, sympy.Expr):
        yield f"{name} + 1", _Wrong(cayley, name, value + 1)
        return
    for place, coefficient in enumerate(value.coefficients):
        # doubled coefficients of the quaternion still have rational squares
        other = 2 * coefficient if name == "quaternion" else coefficient + 1
        changed = (*value.coefficients[:place], other, *value.coefficients[place + 1 :])
        yield f"coefficient {place + 1} of {name}", _Wrong(cayley, name, SimpleNamespace(coefficients=changed))


def _off(function: Function) -> Function:
    """Return a function that increases the first number of the result by one."""

    def wrong(*arguments: Any) -> Any:
        result = function(*arguments)
        if isinstance(result, Isotropic):
            return replace(result, a=result.a + 1)
        if isinstance(result, tuple):
            return (result[0] + 1, *result[1:]) if result else (1,)
        return result + 1

    return wrong
