"""Equations of a file that follows the text of a paper: lines, readings, stated conditions and printed forms.

A file with ``conditions = "stated"`` in its table [paper] is such a transcript. Its definitions are definitions of its
entries, so that a statement stands as printed. Each condition is tested on both sides, and none is searched for.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from mpmath import mpf

from ..algebra import Dual, Structure
from .claim import operators
from .equation import Entry, Latex, Points, Reading
from .judge import COMPONENTWISE
from .language.claims import CALL, CALLS, ClaimError, Reader, Scope, statement, tree
from .language.environment import Definition, Env, let
from .language.operations import is_number
from .language.operations import name as kind_name
from .language.operator_table import nonzero
from .language.printed import Apply, Number, Symbol, Term, Trait, shown_as, symbols, walk, with_trait
from .language.relations import unlike
from .language.written import written
from .numbers.draw import Draw
from .numbers.fields import Decimal60

READING_KEYS = ("claim", "note", "supported_by")
FRAMED = COMPONENTWISE | {"vector"}
"""First words of operators that depend on the frame."""


@dataclass(frozen=True)
class Transcript:
    """Scope, names as printed, sections and points, which all entries of a transcript share."""

    source: str
    scope: Scope
    printed: Mapping[str, str]  # LaTeX of operators by name, if not as usual
    sections: tuple[int, ...] = ()  # first line of each section
    points: tuple[Mapping[Symbol, Term], ...] = ()  # values of letters at further points

    def entry(self, row: Mapping[str, Any]) -> Entry:
        """Return the entry of an equation whose keys were checked; raise ClaimError."""
        rows = row.get("reading") or [{"claim": row["claim"]}]
        readings = tuple(
            Reading(self._read(r, "claim"), r.get("note", ""), r.get("supported_by", "")) for r in rows
        )  # fmt: skip
        domain, condition, corrected, because = (
            self._read(row, key) if key in row else None for key in ("domain", "condition", "corrected", "because")
        )
        found = (*(r.statement for r in readings), domain, condition, corrected, because)
        parts = [part for part in found if part is not None]
        definitions = dict(self._definitions(parts)).values()
        inside = [*parts, *(body for _, body in definitions)]
        heads = {name.split()[0] for name in operators(*inside) if name}
        line = row.get("line", 0)
        entry = Entry(
            row["number"], row.get("title", ""), line, Latex(row.get("latex", "")), readings,
            where=tuple(definition for definition, _ in definitions), claimed=domain, condition=_sharp(condition),
            stated=(line, row["stated"]) if "stated" in row else None, corrected=corrected, because=because,
            moving=bool(with_trait(Trait.RATE, *inside)), components=bool(heads & FRAMED), source=self.source,
            at=self._section(line), abbreviations=self.scope.abbreviations,
            **{key: row[key] for key in ("lost", "fixed_by", "said", "remark") if key in row},
        )  # fmt: skip
        return replace(entry, also=self._also({a for part in parts for a in entry.free(part)}))

    def _read(self, row: Mapping[str, str], key: str) -> Term:
        try:
            return shown_as(statement(row[key], self.scope), self.printed)
        except ClaimError as error:
            raise error if key == "claim" else ClaimError(f"{key}: {error.message}", error.column) from None

    def _section(self, line: int) -> str:
        return f"section {sum(first <= line for first in self.sections)}" if self.sections else ""

    def _definitions(self, statements: Iterable[Term]) -> Iterator[tuple[Symbol, tuple[Definition, Term]]]:
        """Yield the definitions that statements use, and those that these use, by symbol and with their terms."""
        for call in (node for part in statements for node in walk(part) if node.operator.name.startswith(CALL)):
            called, kinds = self.scope.abbreviations[str(call.arguments[0].args[3])], CALLS[call.operator.name]
            body = called.known[kinds][0]
            yield (symbol := called.symbol(kinds)), (_definition(symbol, called.symbols(), body), body)
            yield from self._definitions([body])

    def _also(self, letters: set[Symbol]) -> Points | None:
        """Return the function that draws the further points of an equation with these letters."""
        found = {
            ", ".join(f"{a.name} = {written(term)}" for a, term in row.items()): row
            for row in self.points if letters.issuperset(_letters(row))
        }  # fmt: skip
        return (lambda draw: {label: _point(draw, row) for label, row in found.items()}) if found else None


def _letters(row: Mapping[Symbol, Term]) -> set[Symbol]:
    return {*row, *(a for term in row.values() for a in symbols(term) if a.quantity.varies)}


def _point(draw: Draw, row: Mapping[Symbol, Term]) -> dict[Symbol, Any]:
    """Return the values of letters, by those of the letters in them, which are drawn."""
    drawn = {a: a.quantity.generic(draw) for a in _letters(row)}
    env = Env(Decimal60(), dict(drawn), moving=draw.moving)

    def part(c: Any) -> Any:
        return draw.plain(mpf(c.numerator) / c.denominator) if isinstance(c, int | Fraction) else c

    def number(c: Any) -> Any:
        return Dual(part(c.re), part(c.du)) if isinstance(c, Dual) else part(c)

    found = {letter: env.value(term) for letter, term in row.items()}
    values = {a: value.map(number) if isinstance(value, Structure) else number(value) for a, value in found.items()}
    return {**drawn, **values}


def _definition(symbol: Symbol, parameters: Sequence[Symbol], body: Term) -> Definition:
    """Return the definition of a name: its value, or the function of its parameters."""

    def value(env: Env, *_: Any) -> Any:
        if not parameters:
            return env.value(body)
        return lambda *values: replace(env, values={**env.values, **dict(zip(parameters, values))}).value(body)

    return let(symbol, value, *(a for a in symbols(body) if a.quantity.varies))


def _sharp(condition: Term | None) -> Term | None:
    """Return a condition in which ``a != 0`` is the operator whose sharpness is tested."""
    if not isinstance(condition, Apply):
        return condition
    if condition.operator is unlike and condition.arguments[1] == Number(0):
        return nonzero(condition.arguments[0])
    if Trait.JOINS in condition.operator.traits:
        return Apply(condition.operator.name, *map(_sharp, condition.arguments))
    return condition


def point(row: Any, scope: Scope) -> dict[Symbol, Term]:
    """Return the values of letters at a further point; raise ClaimError."""
    found = {}
    for name, value in row.items():
        if name not in scope.letters or not isinstance(value, str):
            raise ClaimError(f"a point gives letters values in quotes, such as A = \"-A\", got {name}")
        letter, kind = scope.letters[name]
        found[letter], of = Reader(value, scope).read(tree(value))
        if of != kind and not (is_number(of) and is_number(kind)):
            raise ClaimError(f"{name}: {value!r} is {kind_name(of)}")
    return found
