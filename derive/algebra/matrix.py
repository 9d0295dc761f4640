"""Matrices of any shape over any commutative coefficients; 3x3 matrices are tensors, columns of three are vectors."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Self

from .dual import Coefficient, Dual, Structure, real_part
from .structures import Tensor, Vector

Rows = Sequence[Sequence[Coefficient]]


@dataclass(frozen=True, slots=True)
class Matrix(Structure):
    """Matrix with the given `rows`, such as a twist (6x1), a pose (4x4) or an adjoint (6x6)."""

    rows: tuple[tuple[Coefficient, ...], ...]

    @classmethod
    def from_rows(cls, rows: Rows) -> Self:
        return cls(tuple(map(tuple, rows)))

    def __iter__(self) -> Iterator[Coefficient]:
        return (entry for row in self.rows for entry in row)

    def _with(self, components: Iterable[Coefficient]) -> Self:
        row = [iter(components)] * len(self.rows[0])
        return type(self)(tuple(zip(*row, strict=True)))

    def _matches(self, other: object) -> bool:
        return isinstance(other, Matrix) and shape(other) == shape(self)


def rows_of(a: Any) -> Rows:
    """Return the rows of a matrix, tensor, vector (a column) or number."""
    if isinstance(a, Matrix | Tensor):
        return a.rows
    return [[c] for c in a] if isinstance(a, Vector) else [[a]]


def shape(a: Any) -> tuple[int, int]:
    rows = rows_of(a)
    return len(rows), len(rows[0])


def shaped(rows: Rows) -> Any:
    """Return rows as a number (1x1), vector (3x1), tensor (3x3) or matrix."""
    size = len(rows), len(rows[0])
    if size == (1, 1):
        return rows[0][0]
    entries = (entry for row in rows for entry in row)
    if size == (3, 1):
        return Vector(*entries)
    return Tensor.from_entries(entries) if size == (3, 3) else Matrix.from_rows(rows)


def identity(n: int) -> Any:
    return shaped([[int(i == j) for j in range(n)] for i in range(n)])


def transposed(a: Any) -> Any:
    return shaped(list(zip(*rows_of(a), strict=True)))


def product(a: Any, b: Any) -> Any:
    columns = list(zip(*rows_of(b), strict=True))
    return shaped([[_sum(x * y for x, y in zip(row, column, strict=True)) for column in columns] for row in rows_of(a)])


def kron(a: Any, b: Any) -> Any:
    return shaped([[x * y for x in r for y in s] for r in rows_of(a) for s in rows_of(b)])


def blocks(rows: Sequence[Sequence[Any]]) -> Any:
    lines = (parts for row in rows for parts in zip(*map(rows_of, row), strict=True))
    return shaped([[entry for part in parts for entry in part] for parts in lines])


def part(a: Any, rows: range, columns: range) -> Any:
    """Return the block of a matrix with these rows and columns, counted from 0."""
    return shaped([[rows_of(a)[i][j] for j in columns] for i in rows])


def exactly(a: Any) -> Any:
    """Return a number or structure with its integers as fractions, whose quotients are exact."""
    if isinstance(a, Dual):
        return Dual(exactly(a.re), exactly(a.du))
    return a.map(exactly) if isinstance(a, Structure) else Fraction(a) if isinstance(a, int) else a


def det(a: Any) -> Coefficient:
    """Return the determinant of a square matrix, by elimination; a singular one has 0."""
    return _eliminated(rows_of(a), [[]] * len(rows_of(a)))[0]


def inverse(a: Any) -> Any:
    """Return the inverse of a square matrix, by elimination; a singular one raises ZeroDivisionError."""
    size = len(rows_of(a))
    determinant, right = _eliminated(rows_of(a), rows_of(identity(size)))
    if determinant == 0:
        raise ZeroDivisionError("a singular matrix has no inverse")
    return shaped(right)


def _eliminated(left: Rows, right: Rows) -> tuple[Coefficient, Rows]:
    """Return the determinant of the left side, and the right side where the left one became the identity."""
    size, determinant = len(left), 1
    rows = [list(map(exactly, (*a, *b))) for a, b in zip(left, right, strict=True)]
    for i in range(size):
        k = max(range(i, size), key=lambda k: _weight(rows[k][i]))
        pivot = rows[k][i]
        if _innermost(pivot) == 0:
            return 0, right
        if k != i:
            rows[i], rows[k], determinant = rows[k], rows[i], -determinant
        determinant = determinant * pivot
        rows[i] = [e / pivot for e in rows[i]]
        for j in range(size):
            if j != i and not _is_zero(factor := rows[j][i]):
                rows[j] = [a - factor * b for a, b in zip(rows[j], rows[i], strict=True)]
    return determinant, [row[size:] for row in rows]


def _weight(a: Coefficient) -> Any:
    """Return the size of a pivot: its magnitude in a type with `pivot`, so that digits are kept; else 0 or 1."""
    a = _innermost(a)
    return a.pivot() if hasattr(a, "pivot") else int(a != 0)


def _innermost(a: Coefficient) -> Coefficient:
    while (inner := real_part(a)) is not a:
        a = inner
    return a


def _is_zero(a: Coefficient) -> bool:
    return isinstance(a, int | Fraction) and a == 0


def _sum(terms: Iterable[Coefficient]) -> Coefficient:
    first, *rest = terms
    for term in rest:
        first = first + term
    return first
