"""Letters of claims by kind, and literals: matrices, blocks, entries, identity, zeros, with written arguments."""

from __future__ import annotations

import ast
import difflib
import re
from collections.abc import Callable
from typing import Any, Protocol

from ..numbers import kinds as rows
from . import matrices, operator_table
from .grammar import source
from .names import POSE, TENSOR, TWIST, VECTOR, ClaimError, Kind, is_number, latex_of, name
from .operations import CONSTANTS
from .printed import Number, Symbol, Term

LETTERS: dict[str, tuple[str, Kind, str]] = {
    "real": ("real", "number", "real number"),
    "positive": ("positive", "number", "real number above 0"),
    "integer": ("integer", "integer", "integer of either sign"),
    "order": ("order", "integer", "order n = 1, 2, 3 …"),
    "branch": ("branch", "integer", "branch k = 0, 1 … n − 1 of an order n"),
    "sign": ("sign", "number", "1 or −1, the same in the whole claim"),
    "angle": ("real angle", "number", "real number, with special values at multiples of π"),
    "vector": ("real vector", VECTOR, "vector of three real components"),
    "unit vector": ("real unit vector", VECTOR, "vector of magnitude 1"),
    "tensor": ("tensor 3x3", TENSOR, "real 3x3 matrix"),
    "rotation": ("rotation", TENSOR, "orthogonal 3x3 matrix of determinant 1"),
    "quaternion": ("real quaternion of a letter", "quaternion", "quaternion"),
    "unit quaternion": ("unit real quaternion", "quaternion", "quaternion of norm 1"),
    "pose": ("pose 4x4", POSE, "4x4 matrix of a rotation and a translation"),
    "twist": ("twist", TWIST, "column of 6, angular velocity first"),
    "wrench": ("wrench", TWIST, "column of 6, moment first"),
    "dual number": ("dual number", "number", "dual number"),
    "invertible dual number": ("scale", "number", "dual number with a real part other than 0"),
    "dual angle": ("angle", "number", "dual number, with special values at multiples of π"),
    "dual vector": ("dual vector", VECTOR, "vector of three dual components"),
    "unit dual vector": ("unit vector", VECTOR, "dual vector of magnitude 1: a line"),
    "dual tensor": ("tensor", TENSOR, "dual 3x3 matrix"),
    "orthogonal dual tensor": ("orthogonal tensor", TENSOR, "dual 3x3 matrix of a rigid displacement"),
    "dual quaternion": ("quaternion", "quaternion", "dual quaternion"),
    "unit dual quaternion": ("unit quaternion", "quaternion", "dual quaternion of norm 1"),
}
"""Quantity, kind of value and words for each kind of letter; ``constant`` before a kind leaves out its rate."""

CONSTANT = "constant "
SHAPES = {VECTOR: r"\mathbf{{{}}}", TENSOR: r"\mathbf{{{}}}", POSE: r"\mathbf{{{}}}", "quaternion": r"\hat{{{}}}"}


def letter(name: str, kind: str) -> tuple[Symbol, Kind]:
    """Return the symbol of a letter and the kind of its values; raise ClaimError for an unknown kind."""
    if not (name.isidentifier() and name.isascii()) or name in CONSTANTS:
        taken = "has a meaning of its own" if name in CONSTANTS else "is no name"
        raise ClaimError(f"a letter is expected, such as v or theta_1; {name!r} {taken}")
    plain = kind.removeprefix(CONSTANT)
    if plain not in LETTERS:
        near = difflib.get_close_matches(plain, LETTERS, n=3, cutoff=0.5) or list(LETTERS)
        raise ClaimError(f"no kind {kind!r} of {name}: expected {', '.join(near)}")
    quantity, of, _ = LETTERS[plain]
    if kind != plain and CONSTANT + quantity in rows.KINDS:
        quantity = CONSTANT + quantity
    shown = latex_of(name)
    stem, _, below = shown.partition("_")
    shown = SHAPES.get(of, "{}").format(stem) + (f"_{below}" if below else "")
    return Symbol(name, quantity, rf"\underline{{{shown}}}" if plain.count("dual") else shown, name), of


MEMBERS = range(7)
"""Indices of a family of letters: more than the orders at which claims are tried."""


def letters(name: str, kind: str) -> dict[str, tuple[Symbol, Kind]]:
    """Return the letters of a declaration by name: one, or for ``w[k]`` the members of a family."""
    family = re.fullmatch(r"(\w+)\[[A-Za-z]\w*\]", name)
    if family is None:
        return {name: letter(name, kind)}
    found = {f"{family[1]}[{i}]": letter(f"{family[1]}_{i}", kind) for i in MEMBERS}
    return {name: (Symbol(name, *map(str, (*symbol.args[1:3], name))), of) for name, (symbol, of) in found.items()}


SIZE_MAX = 12
"""Largest numbers of rows and columns of `identity` and `zeros`."""


class Reader(Protocol):
    """Reader of a text, as the literals use it."""

    text: str

    def read(self, node: ast.expr) -> tuple[Term, Kind]: ...

    def error(self, message: str, node: ast.expr) -> ClaimError: ...


def integer(node: ast.expr) -> int | None:
    match node:
        case ast.Constant(value=int(value)):
            return value
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=int(value))):
            return -value
    return None


def _rows(reader: Reader, node: ast.Call) -> list[list[ast.expr]]:
    call = source(node.func, reader.text)
    given = node.args[0] if len(node.args) == 1 else None
    if not (isinstance(given, ast.List) and given.elts and all(isinstance(r, ast.List) for r in given.elts)):
        raise reader.error(f"{call} takes rows in brackets: {call}([[a, b], [c, d]])", node)
    rows = [row.elts for row in given.elts if isinstance(row, ast.List)]
    if not all(rows):
        raise reader.error(f"{call} has an empty row", node)
    return rows


def _matrix(reader: Reader, node: ast.Call) -> tuple[Term, Kind]:
    rows = _rows(reader, node)
    if len({len(row) for row in rows}) > 1:
        raise reader.error("the rows of a matrix have different lengths", node)
    found = [[reader.read(entry) for entry in row] for row in rows]
    for parts, row in zip(found, rows, strict=True):
        for (_, kind), entry in zip(parts, row, strict=True):
            if not is_number(kind):
                raise reader.error(f"an entry is a number, got {name(kind)} (blocks: block)", entry)
    size = len(rows), len(rows[0])
    term = matrices.literal("matrix", [[term for term, _ in row] for row in found])
    return term, ("number" if size == (1, 1) else size)


def _block(reader: Reader, node: ast.Call) -> tuple[Term, Kind]:
    rows = _rows(reader, node)
    found = [[reader.read(part) for part in row] for row in rows]
    sizes: list[list[Any]] = [[(1, 1) if is_number(kind) else kind for _, kind in row] for row in found]
    for parts, row in zip(sizes, rows, strict=True):
        for size, part in zip(parts, row, strict=True):
            if not isinstance(size, tuple):
                raise reader.error(f"a block is a matrix, got {name(size)}", part)
            if size[0] != parts[0][0]:
                raise reader.error(f"blocks side by side have {parts[0][0]} and {size[0]} rows", part)
    widths = [sum(columns for _, columns in parts) for parts in sizes]
    if len(set(widths)) > 1:
        raise reader.error(f"the rows of blocks have {', '.join(map(str, widths))} columns", node)
    term = matrices.literal("block", [[term for term, _ in row] for row in found])
    return term, (sum(parts[0][0] for parts in sizes), widths[0])


def _entry(reader: Reader, node: ast.Call) -> tuple[Term, Kind]:
    if len(node.args) not in (2, 3):
        raise reader.error("entry takes a column and an index, or a matrix and two", node)
    (a, kind), *indices = [reader.read(argument) for argument in node.args]
    size: Any = (4, 1) if kind == "quaternion" else kind
    if not isinstance(size, tuple) or (len(indices) == 1 and size[1] != 1):
        raise reader.error(f"entry takes a column and an index, or a matrix and two, got {name(kind)}",
                         node.args[0])
    for most, (_, of), argument in zip(size, indices, node.args[1:], strict=False):
        written = integer(argument)
        if of != "integer" or (written is not None and not 1 <= written <= most):
            raise reader.error(f"an index is an integer from 1 to {most}", argument)
    return matrices.entry(a, *(term for term, _ in indices)), "number"


def _sizes(reader: Reader, node: ast.Call, count: int) -> list[int]:
    sizes = [integer(argument) for argument in node.args]
    call = source(node.func, reader.text)
    if len(sizes) != count or not all(size is not None and 1 <= size <= SIZE_MAX for size in sizes):
        raise reader.error(f"{call} takes {'a size' if count == 1 else 'two sizes'} from 1 to {SIZE_MAX}", node)
    return [size for size in sizes if size is not None]


def _identity(reader: Reader, node: ast.Call) -> tuple[Term, Kind]:
    (n,) = _sizes(reader, node, 1)
    return matrices.identity_of(Number(n)), ("number" if n == 1 else (n, n))


def _zeros(reader: Reader, node: ast.Call) -> tuple[Term, Kind]:
    m, n = _sizes(reader, node, 2)
    return matrices.zeros(Number(m), Number(n)), ("number" if (m, n) == (1, 1) else (m, n))


def _cases(reader: Reader, node: ast.Call) -> tuple[Term, Kind]:
    found = [reader.read(argument) for argument in node.args]
    values = [kind for _, kind in found[::2]]
    conditions = [kind for _, kind in found[1::2]]
    if len(found) < 2 or "truth" in values or any(kind != "truth" for kind in conditions):
        raise reader.error("cases takes values with relations, such as cases(a, x < 0, b)", node)
    if len(set(values)) > 1 and not all(map(is_number, values)):
        raise reader.error(f"the values of cases are of one kind, got {', '.join(map(name, values))}", node)
    return operator_table.cases(*(term for term, _ in found)), values[0] if len(set(values)) == 1 else "number"


LITERALS: dict[str, Callable[[Reader, ast.Call], tuple[Term, Kind]]] = {
    "matrix": _matrix, "block": _block, "entry": _entry, "identity": _identity, "zeros": _zeros,
    "cases": _cases,
}  # fmt: skip
"""Readers of literals by name."""
