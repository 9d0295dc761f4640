"""Claims in plain text, parsed to terms by a whitelist over Python's syntax tree. No part of a text is evaluated."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from . import matrices, names, operations
from .expressions import POWER_MAX, Expressions, tree
from .grammar import source
from .letters import LITERALS, MEMBERS, integer
from .names import Abbreviation, ClaimError, Kind, Scope, call, latex_of
from .operations import OPERATIONS
from .printed import Number, Symbol, Term, symbols
from .substitution import substituted

ROW_MAX = 50
"""Largest number of definitions that use one another in a row."""
COUNTED, LOCAL = ("sum", "product", "all"), ("limit", "integral", "at", "expectation")
"""Operations over an integer letter, which is their first argument, and others whose letter has no value outside."""
FREE = ("real", "positive", "real angle", "real vector", "twist", "wrench")
"""Quantities whose components vary freely."""
AMBIENT = ("real unit vector", "rotation", "tensor 3x3", "real quaternion of a letter", "unit real quaternion")
"""Quantities by whose components there is a derivative although they do not vary freely."""


def statement(text: str, scope: Scope) -> Term:
    """Return the claim of a text, abbreviations by their names; a text without a relation raises ClaimError."""
    node = tree(text)
    term, kind = Reader(text, scope).read(node)
    if kind != "truth":
        raise ClaimError(f"a claim is a relation such as a == b, got {names.name(kind)}", node.col_offset + 1)
    return term


class Reader(Expressions):
    """Reader of one text in a scope, with calls of operations and definitions."""

    def _called(self, name: str, node: ast.Call) -> tuple[Term, Kind]:
        if name in self.scope.abbreviations:
            return self._abbreviated(self.scope.abbreviations[name], node, node.args)
        if name in LITERALS:
            return LITERALS[name](self, node)
        if name not in OPERATIONS:
            near = self._near(name, (*OPERATIONS, *LITERALS)).replace(" (letters stand in [letters] or --let)", "")
            raise self.error(f"unknown operation {name!r}{near}", node)
        if OPERATIONS[name].binds:
            return self._bound(name, node)
        found = [self.read(argument) for argument in node.args]
        return operations.term(name, [term for term, _ in found], [kind for _, kind in found])

    def _abbreviated(self, called: Abbreviation, node: ast.expr, given: Sequence[ast.expr]) -> tuple[Term, Kind]:
        if called.name in self.scope.open:
            raise self.error(f"the definition of {called.name} uses itself", node)
        if len(self.scope.open) >= ROW_MAX:
            raise self.error(f"at most {ROW_MAX} definitions use one another in a row", node)
        if len(given) != len(called.parameters):
            raise self.error(f"{called.head} takes {len(called.parameters)} arguments, got {len(given)}", node)
        found = [self.read(argument) for argument in given]
        kinds = tuple(kind for _, kind in found)
        if kinds not in called.known:
            try:
                called.known[kinds] = Reader(called.text, self.scope.of(called, kinds)).read(tree(called.text))
            except ClaimError as error:
                where = error.message if error.message.startswith("in definition") else (
                    f"in definition {called.head!r}, column {error.column}: {error.message}")
                raise self.error(where, node) from None
        return call(called, [term for term, _ in found], kinds), called.known[kinds][1]

    def _bound(self, name: str, node: ast.Call) -> tuple[Term, Kind]:
        """Return the term of an operation that varies a letter."""
        place, count = int(name not in COUNTED), len(OPERATIONS[name].takes)
        if len(node.args) != count:
            raise self.error(f"{name} takes {count} arguments, got {len(node.args)}", node)
        letter = node.args[place]
        if isinstance(letter, ast.Name) and name in (*COUNTED, *LOCAL):
            return self._local(name, node, letter.id, place)
        at, kind = self.read(letter) if isinstance(letter, ast.Name | ast.Subscript) else (None, "")
        if not isinstance(at, Symbol) or name in (*COUNTED, *LOCAL):
            raise self.error(f"{name} varies a letter, got {source(letter, self.text)[:60]!r}", letter)
        free = (*FREE, *AMBIENT * (name == "jacobian"))
        if at.quantity.name.removeprefix("constant ") not in free and at.quantity.name != "index":
            raise self.error(f"{name} varies a real number, vector or twist, not a {at.quantity.name}", letter)
        rest = [self.read(argument) for argument in node.args[2:]]
        if name == "series" and not 0 <= (integer(node.args[2]) or 0) <= POWER_MAX:
            raise self.error(f"the order of a series is an integer from 0 to {POWER_MAX}", node.args[2])
        body, of = self.read(node.args[0])
        kinds = [of, kind, *(k for _, k in rest)]
        return OPERATIONS[name].term(body, at, at, *(term for term, _ in rest)), OPERATIONS[name].kind(name, kinds)

    def _local(self, name: str, node: ast.Call, letter: str, place: int) -> tuple[Term, Kind]:
        """Return the term of an operation whose letter is local, such as a sum or limit."""
        kind, given = self._kind_of_local(name, node, letter)
        declared, of = self.scope.letters.get(letter, (None, kind))
        symbol = Symbol(letter, "index", latex_of(letter) if declared is None else str(declared.args[2]), letter)
        inside = Reader(self.text, self.scope.with_letter(letter, symbol, kind))
        inside.shift = self.shift
        body = len(OPERATIONS[name].takes) - 1 if name in COUNTED else 0
        found = [
            (symbol, kind) if i == place else (inside if i == body else self).read(argument)
            for i, argument in enumerate(node.args)
        ]
        found = [*found[:-1], given] if given is not None else found
        if name == "expectation":  # whose degree is read from the formula
            found[body] = names.expanded(found[body][0], self.scope.abbreviations), found[body][1]
        if declared is not None:  # definitions in the body may contain the letter
            whole = names.expanded(found[body][0], self.scope.abbreviations)
            if declared in symbols(whole):
                if of != kind:
                    raise self.error(f"definitions have {letter} as {names.name(of)}, here it is "
                                     f"{names.name(kind)}", node)
                found[body] = substituted(whole, {declared: symbol}), found[body][1]
        return operations.term(name, [term for term, _ in found], [kind for _, kind in found])

    def _kind_of_local(self, name: str, node: ast.Call, letter: str) -> tuple[Kind, tuple[Term, Kind] | None]:
        """Return the kind of a local letter, and its value if that is 0, the zero of its kind."""
        if name not in ("at", "expectation"):
            endless = name == "limit" and isinstance(node.args[2], ast.Name) and node.args[2].id == "infinity"
            return ("integer" if name in COUNTED or endless else "number"), None
        value, kind = self.read(node.args[2])
        if name == "expectation":
            return ((kind[0], 1) if isinstance(kind, tuple) else "number"), None
        of = self.scope.known.get(letter, (None, kind))[1]
        if value != names.ZERO or names.is_number(of):
            return ("number" if names.is_number(kind) else kind), None
        if not isinstance(of, tuple):
            raise self.error(f"the value of {letter} is {names.name(of)}, got 0", node.args[2])
        zeros: Term = matrices.zeros(*map(Number, of))
        return of, (zeros, of)

    def _member(self, name: str, node: ast.Subscript) -> tuple[Term, Kind]:
        """Return the term of a member of a family of letters, such as ``w[k]``."""
        found = [self.scope.letters[member] for i in MEMBERS if (member := f"{name}[{i}]") in self.scope.letters]
        if not found:
            raise self.error(f"no family {name!r}: declare one such as \"{name}[k]\" = \"vector\"", node)
        written = integer(node.slice)
        if written is not None and written not in MEMBERS:
            raise self.error(f"a member has an index from {MEMBERS[0]} to {MEMBERS[-1]}, got {written}", node.slice)
        if written is not None:
            return found[written]
        index, kind = self.read(node.slice)
        if kind != "integer":
            raise self.error(f"an index is an integer, got {names.name(kind)}", node.slice)
        return matrices.member(name, index, [member for member, _ in found]), found[0][1]
