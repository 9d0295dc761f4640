"""Claims in plain text, parsed to terms by a whitelist over Python's syntax tree. No part of a text is evaluated."""

from __future__ import annotations

import ast
import difflib
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

from ...maps.any_phi.grammar import Grammar, source
from . import matrices, operations, operator_table, relations
from .calculus import substituted
from .operations import CONSTANTS, OPERATIONS, POSE, TENSOR, Kind, KindError, is_number
from .printed import ATOM, LIST, Apply, Number, Symbol, Term, Trait, macro, takes_apart, walk

POWER_MAX = 64
"""Largest power that is a written number."""
SIZE_MAX = 12
"""Largest numbers of rows and columns of `identity` and `zeros`."""
PARTS_MAX = 6000
"""Largest number of parts of a claim with its definitions filled in."""

COUNTED = ("sum", "all")
"""Operations over an integer letter, which is their first argument."""
LITERALS = ("matrix", "block", "entry", "identity", "zeros")
RELATIONS: dict[type[ast.cmpop], Any] = {
    ast.Eq: operator_table.equal, ast.NotEq: relations.unlike, ast.Lt: relations.less, ast.LtE: relations.at_most,
    ast.Gt: relations.greater, ast.GtE: relations.at_least,
}
JOINS: dict[type[ast.boolop], Any] = {ast.And: operator_table.both, ast.Or: relations.either}
SUMS: dict[type[ast.operator], str] = {ast.Add: "+", ast.Sub: "-"}
HINTS = {"^": "a power is **", "@": "a product is *", "lambda": "", "=": "a relation is =="}


class ClaimError(ValueError):
    """Error for a text that is no claim, with its column, counted from 1; 0 for no place in a text."""

    def __init__(self, message: str, column: int = 0) -> None:
        super().__init__(message)
        self.message, self.column = message, column

    def __str__(self) -> str:
        return f"column {self.column}: {self.message}" if self.column else self.message

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.message, self.column)


def _parts(node: ast.expr) -> Sequence[ast.expr] | None:
    match node:
        case ast.Name() if not node.id.startswith("_"):
            return ()
        case ast.UnaryOp(op=ast.USub() | ast.UAdd() | ast.Not()):
            return (node.operand,)
        case ast.BinOp(op=ast.Add() | ast.Sub() | ast.Mult() | ast.Div() | ast.Pow()):
            return node.left, node.right
        case ast.BoolOp():
            return node.values
        case ast.Compare() if all(type(op) in RELATIONS for op in node.ops):
            return node.left, *node.comparators
        case ast.Call(func=ast.Name(id=name), keywords=[]) if not name.startswith("_"):
            return node.args
        case ast.List():
            return node.elts
    return None


GRAMMAR = Grammar(
    "a claim", "numbers, letters, + - * / **, == != < <= > >=, and, or, not, calls of operations and definitions",
    _parts, ClaimError, characters_max=4000, parts_max=1500, depth_max=40,
)  # fmt: skip


def tree(text: str) -> ast.expr:
    """Return the checked syntax tree of a text, which may have several lines."""
    flat = re.sub(r"\s", " ", text)
    if not flat.strip():
        raise ClaimError("a claim is expected, got nothing", 1)
    shift = len(flat) - len(flat.lstrip())
    try:
        return GRAMMAR.tree(flat.strip())
    except ClaimError as error:
        sign = re.search(r"\^|@|\blambda\b|(?<![=!<>])=(?!=)", flat)
        hint = f" ({HINTS[sign[0]]})" if sign and HINTS[sign[0]] else ""
        raise ClaimError(error.message + hint, error.column + shift) from None


@dataclass
class Abbreviation:
    """Definition of a file: a name with parameters and a text, whose kind follows from those of its arguments."""

    name: str
    parameters: tuple[str, ...]
    text: str
    latex: str = ""  # as printed; by its name if it is empty
    known: dict[tuple[Kind, ...], tuple[Term, Kind]] = field(default_factory=dict)

    @property
    def head(self) -> str:
        """Name with its parameters, as in the file."""
        return f"{self.name}({', '.join(self.parameters)})" if self.parameters else self.name

    def symbol(self, kinds: tuple[Kind, ...]) -> Symbol:
        """Return the symbol of the name, another one for arguments of each further list of kinds."""
        quantity = "function of parts" if takes_apart(self.known[kinds][0]) else "function"
        others = list(self.known).index(kinds)
        name = f"{self.name} {others + 1}" if others else self.name
        return Symbol(name, quantity, self.latex or latex_of(self.name), self.name)

    def symbols(self) -> tuple[Symbol, ...]:
        """Return the symbols of the parameters."""
        return tuple(Symbol(f"{p} of {self.name}", "index", latex_of(p), p) for p in self.parameters)


@dataclass(frozen=True)
class Scope:
    """Names that a claim may use: letters with symbols and kinds, and abbreviations."""

    letters: Mapping[str, tuple[Symbol, Kind]]
    abbreviations: Mapping[str, Abbreviation] = field(default_factory=dict)
    open: tuple[str, ...] = ()  # abbreviations that are being read

    def with_letter(self, name: str, symbol: Symbol, kind: Kind) -> Scope:
        """Return the scope inside an operation that binds a letter."""
        return Scope({**self.letters, name: (symbol, kind)}, self.abbreviations, self.open)


def statement(text: str, scope: Scope) -> Term:
    """Return the claim of a text, abbreviations by their names; a text without a relation raises ClaimError."""
    node = tree(text)
    term, kind = Reader(text, scope).read(node)
    if kind != "truth":
        raise ClaimError(f"a claim is a relation such as a == b, got {operations.name(kind)}", node.col_offset + 1)
    return term


def expanded(term: Term, abbreviations: Mapping[str, Abbreviation]) -> Term:
    """Return a term with the abbreviations filled in; raise ClaimError if it becomes too long."""
    result = _expanded(term, abbreviations)
    if sum(1 for _ in walk(result)) > PARTS_MAX:
        raise ClaimError(f"with its definitions the claim has more than {PARTS_MAX} parts")
    return result


def _expanded(term: Term, abbreviations: Mapping[str, Abbreviation]) -> Term:
    if not isinstance(term, Apply):
        return term
    arguments = [_expanded(a, abbreviations) for a in term.arguments]
    if not term.operator.name.startswith(CALL):
        return Apply(term.operator.name, *arguments)
    function = term.arguments[0]
    assert isinstance(function, Symbol)
    called, kinds = abbreviations[str(function.args[3])], CALLS[term.operator.name]
    body = _expanded(called.known[kinds][0], abbreviations)
    return substituted(body, dict(zip(called.symbols(), arguments[1:], strict=True)))


def contracted(term: Term, names: Mapping[Term, Term]) -> Term:
    """Return a term in which parts stand by their names, the largest first."""
    if term in names:
        return names[term]
    if not isinstance(term, Apply):
        return term
    return Apply(term.operator.name, *(contracted(a, names) for a in term.arguments))


CALL = "call "
CALLS: dict[str, tuple[Kind, ...]] = {}
"""Kinds of the arguments of an abbreviation, by the operator that calls it."""


def _call(abbreviation: Abbreviation, arguments: Sequence[Term], kinds: tuple[Kind, ...]) -> Term:
    """Return the term of a call: one operator for each list of kinds, since the meaning follows from them."""
    printed = abbreviation.latex if "#" in abbreviation.latex else ""
    relation = abbreviation.known[kinds][1] == "truth"
    name = f"{CALL}{'; '.join(map(str, kinds))}{' relation' * relation}{printed}"
    if name not in CALLS:
        places = ", ".join(f"{{{i}}}" for i in range(1, len(kinds) + 1))
        shown = (rf"{{0}}\left({places}\right)", f"{{0}}({places})") if kinds else ("{0}", "{0}")
        if printed:
            shown = macro(printed, 1), shown[1]
        traits = Trait.DELICATE if relation else Trait.NONE
        operator_table.define(name, *shown, ATOM, (LIST,), _called, traits=traits)
        CALLS[name] = kinds
    return Apply(name, abbreviation.symbol(kinds), *arguments)


def _called(env: Any, f: Any, *arguments: Any) -> Any:
    return f(*arguments) if arguments else f


GREEK = re.findall(
    r"\w+",
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi rho sigma tau upsilon phi chi psi omega "
    "Gamma Delta Theta Lambda Xi Sigma Phi Psi Omega",
)


def latex_of(name: str) -> str:
    """Return the LaTeX of a name: Greek letters by their names, digits and what follows an underscore below."""
    stem, _, rest = name.partition("_")
    if found := re.fullmatch(r"([A-Za-z]+)(\d+)", stem):
        stem, rest = found[1], found[2] + ("," + rest if rest else "")
    stem = rf"\{stem}" if stem in GREEK else stem if len(stem) == 1 else rf"\mathrm{{{stem}}}"
    below = "".join(rf"\{part}" if part in GREEK else part for part in re.split(r"_", rest))
    return f"{stem}_{{{below}}}" if below else stem


class Reader:
    """Reader of one text in a scope."""

    def __init__(self, text: str, scope: Scope) -> None:
        self.text, self.scope = re.sub(r"\s", " ", text), scope
        self.shift = len(self.text) - len(self.text.lstrip())
        self.text = self.text.strip()

    def error(self, message: str, node: ast.expr) -> ClaimError:
        """Return the error at a node."""
        return ClaimError(message, node.col_offset + 1 + self.shift)

    def read(self, node: ast.expr) -> tuple[Term, Kind]:
        """Return the term of a node that the grammar allows, and its kind."""
        try:
            return self._read(node)
        except KindError as error:
            place = error.place
            at = node.args[place] if isinstance(node, ast.Call) and place is not None else node
            raise self.error(str(error), at) from None

    def _read(self, node: ast.expr) -> tuple[Term, Kind]:
        match node:
            case ast.Constant():
                return self._number(node)
            case ast.Name():
                return self._name(node)
            case ast.UnaryOp():
                return self._signed(node)
            case ast.BinOp(op=ast.Pow()):
                return self._power(node)
            case ast.BinOp():
                return self._combined(node)
            case ast.Compare():
                return self._compared(node)
            case ast.BoolOp():
                parts = [self._relation(part) for part in node.values]
                return JOINS[type(node.op)](*parts), "truth"
            case ast.Call(func=ast.Name(id=name)):
                return self._called(name, node)
        raise self.error("a list stands in matrix([[…]]) or block([[…]]) only", node)

    def _number(self, node: ast.Constant) -> tuple[Term, Kind]:
        digits, exponent = GRAMMAR.decimal(node, self.text)
        if exponent >= 0:
            return Number(digits * 10**exponent), "integer"
        return Number(digits) / Number(10**-exponent), "number"

    def _name(self, node: ast.Name) -> tuple[Term, Kind]:
        name = node.id
        if name in self.scope.letters:
            return self.scope.letters[name]
        if name in CONSTANTS:
            return CONSTANTS[name]
        if name in self.scope.abbreviations:
            return self._abbreviated(self.scope.abbreviations[name], node, [])
        raise self.error(f"unknown letter {name!r}{self._near(name, (*self.scope.letters, *CONSTANTS))}", node)

    def _near(self, name: str, known: Sequence[str]) -> str:
        near = difflib.get_close_matches(name, (*known, *self.scope.abbreviations), n=3, cutoff=0.5)
        return f" (nearest: {', '.join(near)})" if near else " (letters stand in [letters] or --let)"

    def _relation(self, node: ast.expr) -> Term:
        term, kind = self.read(node)
        if kind != "truth":
            raise self.error(f"a relation is expected, got {operations.name(kind)}", node)
        return term

    def _signed(self, node: ast.UnaryOp) -> tuple[Term, Kind]:
        if isinstance(node.op, ast.Not):
            return operator_table.negated(self._relation(node.operand)), "truth"
        term, kind = self.read(node.operand)
        if kind == "truth":
            raise self.error("a relation has no sign", node)
        return (-term if isinstance(node.op, ast.USub) else term), kind

    def _power(self, node: ast.BinOp) -> tuple[Term, Kind]:
        (base, kind), (exponent, of) = self.read(node.left), self.read(node.right)
        result = operations.power_kind(kind, of)
        written = _integer(node.right)
        if written is not None:
            if abs(written) > POWER_MAX:
                raise self.error(f"powers are numbers up to {POWER_MAX}, got {written}", node.right)
            exponent = Number(written)
        elif isinstance(node.right, ast.BinOp) and isinstance(node.right.op, ast.Pow) and _constant(node.right):
            raise self.error("a power of a power of numbers is too large", node.right)
        return base**exponent, result

    def _combined(self, node: ast.BinOp) -> tuple[Term, Kind]:
        (a, left), (b, right) = self.read(node.left), self.read(node.right)
        if "truth" in (left, right):
            raise self.error("a relation is no number", node)
        if isinstance(node.op, ast.Div):
            kind = operations.quotient_kind(left, right)
            if isinstance(b, Number) and b.value == 0:
                raise self.error("division by zero", node.right)
            return a / b, kind
        if isinstance(node.op, ast.Mult):
            return a * b, operations.product_kind(left, right)
        kind = operations.sum_kind(left, right, SUMS[type(node.op)])
        return (a + b if isinstance(node.op, ast.Add) else a - b), kind

    def _compared(self, node: ast.Compare) -> tuple[Term, Kind]:
        nodes = (node.left, *node.comparators)
        sides = [self.read(side) for side in nodes]
        for op, (a, left), (b, right), at in zip(node.ops, sides, sides[1:], nodes[1:], strict=False):
            ordered = not isinstance(op, ast.Eq | ast.NotEq)
            try:
                operations.require_comparable(left, right, operations.ZERO in (a, b), ordered)
            except KindError as error:
                raise self.error(str(error), at) from None
        terms = [term for term, _ in sides]
        if all(isinstance(op, ast.Eq) for op in node.ops):
            return operator_table.equal(*terms), "truth"
        found = [RELATIONS[type(op)](a, b) for op, (a, b) in zip(node.ops, pairwise(terms), strict=True)]
        return (found[0] if len(found) == 1 else operator_table.both(*found)), "truth"

    # ---- calls ------------------------------------------------------------------------------------------------------

    def _called(self, name: str, node: ast.Call) -> tuple[Term, Kind]:
        if name in self.scope.abbreviations:
            return self._abbreviated(self.scope.abbreviations[name], node, node.args)
        if name in LITERALS:
            return getattr(self, f"_{name}")(node)  # type: ignore[no-any-return]
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
        if len(given) != len(called.parameters):
            raise self.error(f"{called.head} takes {len(called.parameters)} arguments, got {len(given)}", node)
        found = [self.read(argument) for argument in given]
        kinds = tuple(kind for _, kind in found)
        if kinds not in called.known:
            inner = Scope(
                {**self.scope.letters, **{p: (s, k) for p, s, k in zip(called.parameters, called.symbols(), kinds,
                                                                       strict=True)}},
                self.scope.abbreviations, (*self.scope.open, called.name),
            )  # fmt: skip
            try:
                called.known[kinds] = Reader(called.text, inner).read(tree(called.text))
            except ClaimError as error:
                where = error.message if error.message.startswith("in definition") else (
                    f"in definition {called.head!r}, column {error.column}: {error.message}")
                raise self.error(where, node) from None
        return _call(called, [term for term, _ in found], kinds), called.known[kinds][1]

    def _bound(self, name: str, node: ast.Call) -> tuple[Term, Kind]:
        """Return the term of an operation that varies a letter."""
        place, count = int(name not in COUNTED), len(OPERATIONS[name].takes)
        if len(node.args) != count:
            raise self.error(f"{name} takes {count} arguments, got {len(node.args)}", node)
        letter = node.args[place]
        if not isinstance(letter, ast.Name):
            raise self.error(f"{name} varies a letter, got {source(letter, self.text)[:60]!r}", letter)
        if name in (*COUNTED, "limit", "integral"):
            return self._local(name, node, letter.id, place)
        at, kind = self.read(letter)
        if not isinstance(at, Symbol) or letter.id not in self.scope.letters:
            raise self.error(f"{name} varies a letter, got {letter.id!r}", letter)
        if at.quantity.name.removeprefix("constant ") not in FREE and at.quantity.name != "index":
            raise self.error(f"{name} varies a real number, vector or twist, not a {at.quantity.name}", letter)
        rest = [self.read(argument) for argument in node.args[2:]]
        if name == "series" and not 0 <= (_integer(node.args[2]) or 0) <= POWER_MAX:
            raise self.error(f"the order of a series is an integer from 0 to {POWER_MAX}", node.args[2])
        body, of = self.read(node.args[0])
        kinds = [of, kind, *(k for _, k in rest)]
        return OPERATIONS[name].term(body, at, at, *(term for term, _ in rest)), OPERATIONS[name].kind(name, kinds)

    def _local(self, name: str, node: ast.Call, letter: str, place: int) -> tuple[Term, Kind]:
        """Return the term of an operation whose letter is local, such as a sum or limit."""
        kind = "integer" if name in COUNTED else "number"
        symbol = Symbol(letter, "index", latex_of(letter), letter)
        inside = Reader(self.text, self.scope.with_letter(letter, symbol, kind))
        inside.shift = self.shift
        body = len(OPERATIONS[name].takes) - 1 if name in COUNTED else 0
        found = [
            (symbol, kind) if i == place else (inside if i == body else self).read(argument)
            for i, argument in enumerate(node.args)
        ]
        return operations.term(name, [term for term, _ in found], [kind for _, kind in found])

    # ---- literals ---------------------------------------------------------------------------------------------------

    def _rows(self, node: ast.Call) -> list[list[ast.expr]]:
        call = source(node.func, self.text)
        given = node.args[0] if len(node.args) == 1 else None
        if not (isinstance(given, ast.List) and given.elts and all(isinstance(r, ast.List) for r in given.elts)):
            raise self.error(f"{call} takes rows in brackets: {call}([[a, b], [c, d]])", node)
        rows = [row.elts for row in given.elts if isinstance(row, ast.List)]
        if not all(rows):
            raise self.error(f"{call} has an empty row", node)
        return rows

    def _matrix(self, node: ast.Call) -> tuple[Term, Kind]:
        rows = self._rows(node)
        if len({len(row) for row in rows}) > 1:
            raise self.error("the rows of a matrix have different lengths", node)
        found = [[self.read(entry) for entry in row] for row in rows]
        for parts, row in zip(found, rows, strict=True):
            for (_, kind), entry in zip(parts, row, strict=True):
                if not is_number(kind):
                    raise self.error(f"an entry is a number, got {operations.name(kind)} (blocks: block)", entry)
        size = len(rows), len(rows[0])
        term = matrices.literal("matrix", [[term for term, _ in row] for row in found])
        return term, ("number" if size == (1, 1) else size)

    def _block(self, node: ast.Call) -> tuple[Term, Kind]:
        rows = self._rows(node)
        found = [[self.read(part) for part in row] for row in rows]
        sizes: list[list[Any]] = [[(1, 1) if is_number(kind) else kind for _, kind in row] for row in found]
        for parts, row in zip(sizes, rows, strict=True):
            for size, part in zip(parts, row, strict=True):
                if not isinstance(size, tuple):
                    raise self.error(f"a block is a matrix, got {operations.name(size)}", part)
                if size[0] != parts[0][0]:
                    raise self.error(f"blocks side by side have {parts[0][0]} and {size[0]} rows", part)
        widths = [sum(columns for _, columns in parts) for parts in sizes]
        if len(set(widths)) > 1:
            raise self.error(f"the rows of blocks have {', '.join(map(str, widths))} columns", node)
        term = matrices.literal("block", [[term for term, _ in row] for row in found])
        return term, (sum(parts[0][0] for parts in sizes), widths[0])

    def _entry(self, node: ast.Call) -> tuple[Term, Kind]:
        if len(node.args) not in (2, 3):
            raise self.error("entry takes a column and an index, or a matrix and two", node)
        (a, kind), *indices = [self.read(argument) for argument in node.args]
        size: Any = (4, 1) if kind == "quaternion" else kind
        if not isinstance(size, tuple) or (len(indices) == 1 and size[1] != 1):
            raise self.error(f"entry takes a column and an index, or a matrix and two, got {operations.name(kind)}",
                             node.args[0])
        for most, (_, of), argument in zip(size, indices, node.args[1:], strict=False):
            written = _integer(argument)
            if of != "integer" or (written is not None and not 1 <= written <= most):
                raise self.error(f"an index is an integer from 1 to {most}", argument)
        return matrices.entry(a, *(term for term, _ in indices)), "number"

    def _sizes(self, node: ast.Call, count: int) -> list[int]:
        sizes = [_integer(argument) for argument in node.args]
        call = source(node.func, self.text)
        if len(sizes) != count or not all(size is not None and 1 <= size <= SIZE_MAX for size in sizes):
            raise self.error(f"{call} takes {'a size' if count == 1 else 'two sizes'} from 1 to {SIZE_MAX}", node)
        return [size for size in sizes if size is not None]

    def _identity(self, node: ast.Call) -> tuple[Term, Kind]:
        (n,) = self._sizes(node, 1)
        return matrices.identity_of(Number(n)), ("number" if n == 1 else (n, n))

    def _zeros(self, node: ast.Call) -> tuple[Term, Kind]:
        m, n = self._sizes(node, 2)
        return matrices.zeros(Number(m), Number(n)), ("number" if (m, n) == (1, 1) else (m, n))


FREE = ("real", "positive", "real angle", "real vector", "twist", "wrench")
"""Quantities whose components vary freely."""


def _integer(node: ast.expr) -> int | None:
    """Return a written integer, or None."""
    match node:
        case ast.Constant(value=int(value)):
            return value
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=int(value))):
            return -value
    return None


def _constant(node: ast.expr) -> bool:
    return not any(isinstance(part, ast.Name) for part in ast.walk(node))


__all__ = ["POSE", "TENSOR", "Abbreviation", "ClaimError", "Scope", "expanded", "latex_of", "statement"]
