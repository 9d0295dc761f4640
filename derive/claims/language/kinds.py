"""Table of the kinds of letters in papers' files: the quantity of the letter and the kind of its values."""

from __future__ import annotations

import difflib

from ..numbers import kinds as rows
from .abbreviations import ClaimError, latex_of
from .operations import CONSTANTS
from .printed import Symbol
from .shapes import POSE, TENSOR, TWIST, VECTOR, Kind

LETTERS: dict[str, tuple[str, Kind, str]] = {
    "real": ("real", "number", "real number"),
    "positive": ("positive", "number", "real number above 0"),
    "integer": ("integer", "integer", "integer of either sign"),
    "order": ("order", "integer", "order n = 1, 2, 3 …"),
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
