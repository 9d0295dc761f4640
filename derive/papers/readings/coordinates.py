"""Values as the residues of their coordinates, and what `language.values` does to values done to those.

The coordinates of a dual value are those of its real part and then those of its dual part. Products are bilinear: what
they do to the units is asked of the algebra once, and says what they do to everything.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from itertools import product
from typing import Any

from derive.algebra import Dual, Quaternion, Structure, Tensor, Vector, dual_part, real_part
from derive.algebra.mixed import MeaninglessError, quaternion

from ..numbers.residues import PRIME, Residue, residue

Coordinates = tuple[int, ...]

EXACT = (int, Fraction)
"""What can be an exponent."""
NUMBERS = (Residue, Dual, int, Fraction)
SIZES: dict[type, int] = {**dict.fromkeys(NUMBERS, 1), Vector: 3, Quaternion: 4, Tensor: 9}
"""How many coordinates things have, or each of their two parts."""


def coordinates(value: Any) -> Coordinates | None:
    """Those of a value that needs nothing else: no derivative in time, and no angle as a number."""
    if SIZES.get(type(value)) is None or (type(value) in NUMBERS and _is_angle(value)):
        return None
    parts = _parts(value)
    layers = (real_part, dual_part) if any(isinstance(part, Dual) for part in parts) else (real_part,)
    found = [residue(layer(part)) for layer in layers for part in parts]
    return None if None in found else tuple(found)  # type: ignore[arg-type]


def _parts(value: Any) -> list[Any]:
    return list(value) if isinstance(value, Structure) else [value]  # type: ignore[call-overload]


def _is_angle(value: Any) -> bool:
    return any(isinstance(part, Residue) and part.angle is not None for part in (real_part(value), dual_part(value)))


def made(kind: type, c: Coordinates) -> Any:
    """The value with these coordinates."""
    n = SIZES[kind]
    parts: list[Any] = [Residue(a) for a in c]
    if len(c) > n:
        parts = [Dual(re, du) for re, du in zip(parts[:n], parts[n:], strict=True)]
    return _structure(kind, parts)


def _structure(kind: type, parts: list[Any]) -> Any:
    if kind is Tensor:
        return Tensor.from_entries(parts)
    if kind in (Vector, Quaternion):
        return Vector(*parts) if kind is Vector else Quaternion.from_components(parts)
    return parts[0]


def kind_of(kind: type, c: Coordinates) -> type:
    """The kind of what an operation makes: of numbers it is told by their length."""
    return kind if kind not in NUMBERS else Residue if len(c) == 1 else Dual


def plus(kind_a: type, a: Coordinates, kind_b: type, b: Coordinates, sign: int = 1) -> tuple[type, Coordinates] | None:
    """Sum or difference, of numbers and vectors as quaternions; none of a tensor and another thing."""
    n = SIZES[kind_a]
    if n != SIZES[kind_b]:
        if Tensor in (kind_a, kind_b):
            return None
        kind_a, a, b = Quaternion, _as_quaternion(n, a), _as_quaternion(SIZES[kind_b], b)
    if len(a) != len(b):
        longer = max(len(a), len(b))
        a, b = a + (0,) * (longer - len(a)), b + (0,) * (longer - len(b))
    if sign == 1:
        total = tuple([(s + t) % PRIME for s, t in zip(a, b, strict=True)])
    else:
        total = tuple([(s - t) % PRIME for s, t in zip(a, b, strict=True)])
    return kind_of(kind_a, total), total


def _as_quaternion(n: int, c: Coordinates) -> Coordinates:
    if n == 4:
        return c
    halves = (c[:n], c[n:]) if len(c) > n else (c,)
    return tuple([s for half in halves for s in ((*half, 0, 0, 0) if n == 1 else (0, *half))])


def scale(f: Coordinates, kind: type, c: Coordinates) -> tuple[type, Coordinates]:
    """The multiple by a number."""
    re = f[0]
    multiple = tuple([re * s % PRIME for s in c])
    if len(f) == 2:
        n, du = SIZES[kind], f[1]
        rest = multiple[n:] or (0,) * n
        multiple = multiple[:n] + tuple([(s + du * t) % PRIME for s, t in zip(rest, c, strict=False)])
    return kind_of(kind, multiple), multiple


def inverse(kind: type, c: Coordinates) -> Coordinates | None:
    """Of a number or a quaternion whose real part has one."""
    if kind is not Quaternion:
        return _reciprocal(c)
    _, square = times(inner, kind, c, kind, c) or (kind, (0,))
    reciprocal = _reciprocal(square)
    conjugate = tuple([s if k % 4 == 0 else -s for k, s in enumerate(c)])
    return None if reciprocal is None else scale(reciprocal, Quaternion, conjugate)[1]


def _reciprocal(c: Coordinates) -> Coordinates | None:
    if c[0] == 0:
        return None
    re = pow(c[0], -1, PRIME)
    return (re,) if len(c) == 1 else (re, -c[1] * re * re % PRIME)


def inner(a: Any, b: Any) -> Any:
    """The scalar product of vectors or quaternions."""
    return (quaternion(a) * quaternion(b).conjugate()).scalar


Product = Callable[[Any, Any], Any]
Rows = tuple[tuple[tuple[int, int, int], ...], ...]


def times(f: Product, kind_a: type, a: Coordinates, kind_b: type, b: Coordinates) -> tuple[type, Coordinates] | None:
    """A product of vectors, quaternions and tensors, if they have one."""
    known = _units(f, kind_a, kind_b)
    if known is None:
        return None
    kind, rows = known
    n, m = SIZES[kind_a], SIZES[kind_b]
    total = _sums(rows, a, b)
    if len(a) > n or len(b) > m:
        rest = [_sums(rows, a, b[m:])] if len(b) > m else []
        rest += [_sums(rows, a[n:], b)] if len(a) > n else []
        total += tuple([sum(parts) % PRIME for parts in zip(*rest, strict=True)])
    return kind_of(kind, total), total


def _sums(rows: Rows, a: Coordinates, b: Coordinates) -> Coordinates:
    return tuple([sum([s * a[i] * b[j] for i, j, s in row]) % PRIME for row in rows])


@cache
def _units(f: Product, kind_a: type, kind_b: type) -> tuple[type, Rows] | None:
    """What a product makes of units: its kind, and for each coordinate the pairs that it comes from, with signs."""
    n, m = SIZES[kind_a], SIZES[kind_b]
    try:
        made = {(i, j): f(_unit(kind_a, i), _unit(kind_b, j)) for i, j in product(range(n), range(m))}
    except MeaninglessError:
        return None
    found = {where: _parts(value) for where, value in made.items()}
    kind = type(made[0, 0])
    rows = [tuple((*where, c[k]) for where, c in found.items() if c[k]) for k in range(SIZES[kind])]
    return kind, tuple(rows)


def _unit(kind: type, i: int) -> Any:
    return _structure(kind, [int(k == i) for k in range(SIZES[kind])])
