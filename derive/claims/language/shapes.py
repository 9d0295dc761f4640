"""Kinds of the values in claims, and of their sums, products, quotients and powers.

A kind is "integer", "number", "quaternion", "truth" or, for a matrix, its numbers of rows and columns. A vector is
(3, 1), a twist (6, 1), a tensor (3, 3), a pose (4, 4).
"""

from __future__ import annotations

from collections.abc import Callable

from .printed import Number

Kind = str | tuple[int, int]
VECTOR, TWIST, TENSOR, POSE = (3, 1), (6, 1), (3, 3), (4, 4)
NUMBERS = ("integer", "number")
NAMES: dict[Kind, str] = {VECTOR: "vector", TENSOR: "tensor (3x3)", TWIST: "column of 6", POSE: "4x4 matrix",
                          "truth": "relation"}


class KindError(ValueError):
    """Error for arguments of the wrong kind: what was expected and what was given, and the place of the argument."""

    def __init__(self, message: str, place: int | None = None) -> None:
        super().__init__(message)
        self.place = place


def name(kind: Kind) -> str:
    """Return a kind in words, with an article."""
    return article(NAMES.get(kind, kind if isinstance(kind, str) else f"{kind[0]}x{kind[1]} matrix"))


def article(words: str) -> str:
    return f"{'an' if words[0] in 'aeiou8' else 'a'} {words}"


def is_number(kind: Kind) -> bool:
    return kind in NUMBERS


TESTS: dict[str, Callable[[Kind], bool]] = {
    "integer": lambda kind: kind == "integer",
    "number": is_number,
    "vector": lambda kind: kind == VECTOR,
    "quaternion": lambda kind: kind in ("quaternion", VECTOR) or is_number(kind),
    "tensor": lambda kind: kind == TENSOR,
    "pose": lambda kind: kind == POSE,
    "twist": lambda kind: kind == TWIST,
    "column": lambda kind: is_number(kind) or (isinstance(kind, tuple) and kind[1] == 1),
    "matrix": lambda kind: isinstance(kind, tuple),
    "square matrix": lambda kind: isinstance(kind, tuple) and kind[0] == kind[1],
    "relation": lambda kind: kind == "truth",
    "value": lambda kind: kind != "truth",
}
"""Words for what an operation takes."""


def sum_kind(a: Kind, b: Kind, sign: str) -> Kind:
    """Return the kind of a sum; a number plus a vector is a quaternion."""
    if a == b:
        return a
    if is_number(a) and is_number(b):
        return "number"
    if TESTS["quaternion"](a) and TESTS["quaternion"](b):
        return "quaternion"
    raise KindError(f"{name(a)} {sign} {name(b)} has no meaning")


def product_kind(a: Kind, b: Kind) -> Kind:
    if is_number(a) or is_number(b):
        return (b if is_number(a) else a) if a == b or not (is_number(a) and is_number(b)) else "number"
    if "quaternion" in (a, b) and TESTS["quaternion"](a) and TESTS["quaternion"](b):
        return "quaternion"
    if isinstance(a, tuple) and isinstance(b, tuple) and a[1] == b[0]:
        return "number" if (a[0], b[1]) == (1, 1) else (a[0], b[1])
    hint = ": write dot, cross, dyad or quaternions" if a == b == VECTOR else ""
    raise KindError(f"{name(a)} * {name(b)} has no meaning{hint}")


def quotient_kind(a: Kind, b: Kind) -> Kind:
    if is_number(b):
        return "number" if is_number(a) else a
    if b == "quaternion" and TESTS["quaternion"](a):
        return "quaternion"
    raise KindError(f"{name(a)} / {name(b)} has no meaning: write inverse")


def power_kind(a: Kind, b: Kind) -> Kind:
    if is_number(a) and is_number(b):
        return "number"
    if b == "integer" and (a == "quaternion" or TESTS["square matrix"](a)):
        return a
    if a == "quaternion" and is_number(b):
        return a
    raise KindError(f"{name(a)} ** {name(b)} has no meaning")


def require_comparable(a: Kind, b: Kind, zero: bool, ordered: bool) -> None:
    """Raise KindError unless two sides of a relation can be compared; 0 is the zero of every kind."""
    if "truth" in (a, b):
        raise KindError("a side of a relation is a value, got a relation")
    numbers = is_number(a) and is_number(b)
    if ordered and not numbers:
        raise KindError(f"an inequality takes numbers, got {name(a)} and {name(b)}")
    quaternions = "quaternion" in (a, b) and TESTS["quaternion"](a) and TESTS["quaternion"](b)
    if not (a == b or numbers or quaternions or zero):
        raise KindError(f"{name(a)} is compared with {name(b)}")


ZERO = Number(0)
