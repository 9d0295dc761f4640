"""Trees of rounded operations, one object for each, and their choices by comparisons of numbers.

Two programs whose trees are one object compute the same bits. Trees are brought to a normal form by identities that
hold for every float, infinities, signed zeros and NaN included; only sign and payload of a NaN are left open:
a + b = b + a, a b = b a, a - b = a + (-b), (-a) b = -(a b), (-a) / b = -(a / b), 2 a = a + a, 1 a = a, a + (-0) = a,
(-a) + (-b) = -(a + b) for equal numbers and for sums of squares, c - (a + b) = c + ((-a) + (-b)) for a constant c that
is not 0, a / 2^k = a 2^-k, |-a| = |a|, |a| = a for sums of squares, and values of constants.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from ..statements import MachineError

RELATIONS = ("less", "equal", "greater", "unordered")
MIRROR = {"less": "greater", "greater": "less", "equal": "equal", "unordered": "unordered"}
TYPES: dict[str, tuple[Any, str, str]] = {"double": (np.float64, "<d", "<Q"), "float": (np.float32, "<f", "<I")}
CHOICES = ("choice", "number")
PATTERNS = ("choice", "part", "joined", "unknown", "widened")  # kinds of trees that are no numbers
LEAVES = ("given", "const", "saved", "unset")


class Declined(MachineError):
    """Reason why a function is neither proved equal nor found different."""


class Different(MachineError):
    """Difference between machine code and text."""


class Tree:
    """Operation with its operands; ``choice`` stands for one of four values by the relation of a pair of numbers.

    A choice of which all values are numbers is a ``number``: operations take it as one operand.

    ``pairs`` are all pairs on which the tree depends.
    """

    __slots__ = ("kind", "pairs", "parts", "rank")

    def __init__(self, kind: str, parts: tuple[Any, ...], rank: int) -> None:
        self.kind, self.parts, self.rank = kind, parts, rank
        found = [part.pairs for part in parts if isinstance(part, Tree) and part.pairs]
        self.pairs: frozenset[Tree] = found[0] if len(found) == 1 else frozenset().union(*found)
        if kind in CHOICES:
            self.pairs |= {parts[0]}

    def text(self, depth: int = 7) -> str:
        """Return the tree as text down to a depth."""
        if self.kind in LEAVES:
            return " ".join([self.kind, *map(str, self.parts)])
        if not depth:
            return "…"
        flat = [each for part in self.parts for each in (part if isinstance(part, tuple) else (part,))]
        parts = (part.text(depth - 1) if isinstance(part, Tree) else str(part) for part in flat)
        return f"{self.kind}({', '.join(parts)})"


class Trees:
    """All trees of one real type, each made once."""

    def __init__(self, real: str) -> None:
        self.type, self.float_code, self.int_code = TYPES[real]
        self.unit = np.dtype(self.type).itemsize
        self.ones = (1 << 8 * self.unit) - 1
        self.sign = 1 << 8 * self.unit - 1
        self.table: dict[tuple[Any, ...], Tree] = {}
        self.unset = self.make("unset")

    def make(self, kind: str, *parts: Any) -> Tree:
        key = (kind, *parts)
        found = self.table.get(key)
        if found is None:
            found = self.table[key] = Tree(kind, parts, len(self.table))
        return found

    # --- constants ----------------------------------------------------------------------------------------------------

    def bits(self, pattern: int) -> Tree:
        """Return the constant with a pattern of bits."""
        return self.negated(self.bits(pattern ^ self.sign)) if pattern & self.sign else self.make("const", pattern)

    def constant(self, value: Any) -> Tree:
        """Return the float nearest to an exact number or decimal text."""
        exact = Fraction(value)
        near = self.type(float(exact))
        if self.unit == 4:  # a double between two floats may lie on the wrong side of their middle
            sides = (np.nextafter(near, self.type(end)) for end in (-math.inf, math.inf))
            near = min((near, *sides), key=lambda each: (abs(Fraction(float(each)) - exact), self._pattern(each) & 1))
        return self.bits(self._pattern(near))

    def _pattern(self, value: Any) -> int:
        return int(struct.unpack(self.int_code, struct.pack(self.float_code, value))[0])

    def value(self, tree: Tree) -> Any:
        """Return the float of a constant, or None."""
        inner = tree.parts[0] if tree.kind == "neg" else tree
        if inner.kind != "const":
            return None
        value = self.type(struct.unpack(self.float_code, struct.pack(self.int_code, inner.parts[0]))[0])
        return -value if inner is not tree else value

    def pattern(self, tree: Tree) -> int | None:
        """Return the pattern of bits of a constant, or None."""
        value = self.value(tree)
        return None if value is None else self._pattern(value)

    def _folded(self, operation: Callable[..., Any], *operands: Tree) -> Tree | None:
        """Return the rounded value of an operation on constants."""
        if any("const" not in (each.kind, each.kind == "neg" and each.parts[0].kind) for each in operands):
            return None
        values = [self.value(each) for each in operands]
        with np.errstate(all="ignore"):
            return self.bits(self._pattern(operation(*values)))

    # --- operations ---------------------------------------------------------------------------------------------------

    def negated(self, a: Tree) -> Tree:
        return a.parts[0] if a.kind == "neg" else a if a is self.unset else self.make("neg", a)

    def absolute(self, a: Tree) -> Tree:
        inner = a.parts[0] if a.kind == "neg" else a
        return inner if unsigned(inner) or inner is self.unset else self.make("abs", inner)

    def add(self, a: Tree, b: Tree) -> Tree:
        for one, other in ((a, b), (b, a)):
            if one.kind == "neg" and one.parts[0].kind == "const" and not one.parts[0].parts[0]:
                return other
            if self.value(one) and other.kind == "neg" and other.parts[0].kind == "add":  # the sign of a zero is lost
                x, y = map(self.negated, other.parts[0].parts)
                return self._folded(np.add, a, b) or self._ordered("add", one, self.add(x, y))
        if a.kind == b.kind == "neg" and (a is b or (unsigned(a.parts[0]) and unsigned(b.parts[0]))):
            return self.negated(self.add(a.parts[0], b.parts[0]))
        return self._folded(np.add, a, b) or self._ordered("add", a, b)

    def sub(self, a: Tree, b: Tree) -> Tree:
        return self.add(a, self.negated(b))

    def mul(self, a: Tree, b: Tree) -> Tree:
        if (folded := self._folded(np.multiply, a, b)) is not None:
            return folded
        a, b, opposite = self._signs(a, b)
        for one, other in ((a, b), (b, a)):
            if self.value(one) in (1, 2):
                made = other if self.value(one) == 1 else self.add(other, other)
                break
        else:
            made = self._ordered("mul", a, b)
        return self.negated(made) if opposite else made

    def div(self, a: Tree, b: Tree) -> Tree:
        if (folded := self._folded(np.divide, a, b)) is not None:
            return folded
        a, b, opposite = self._signs(a, b)
        value = self.value(b)
        if value and math.isfinite(value) and math.frexp(value)[0] == 0.5 and 2.0**-100 < value < 2.0**100:
            made = self.mul(a, self.constant(1 / Fraction(float(value))))
        else:
            made = self.unset if self.unset in (a, b) else self.make("div", a, b)
        return self.negated(made) if opposite else made

    def sqrt(self, a: Tree) -> Tree:
        return self._folded(np.sqrt, a) or self.call("sqrt", a)

    def call(self, name: str, *given: Tree) -> Tree:
        """Return the result of a function of which nothing is known."""
        return self.unset if self.unset in given else self.make(name, *given)

    def _ordered(self, kind: str, a: Tree, b: Tree) -> Tree:
        if self.unset in (a, b):
            return self.unset
        return self.make(kind, a, b) if a.rank <= b.rank else self.make(kind, b, a)

    def _signs(self, a: Tree, b: Tree) -> tuple[Tree, Tree, bool]:
        opposite = (a.kind == "neg") != (b.kind == "neg")
        return (*(each.parts[0] if each.kind == "neg" else each for each in (a, b)), opposite)  # type: ignore[return-value]

    # --- choices ------------------------------------------------------------------------------------------------------

    def choose(self, a: Tree, b: Tree, values: Mapping[str, Any]) -> Any:
        """Return the value that belongs to the relation of two numbers."""
        if self.unset in (a, b):
            return self.unset
        if a is b:
            values = {**dict.fromkeys(RELATIONS, values["equal"]), "unordered": values["unordered"]}
        known = self.value(a), self.value(b)
        if None not in known:
            x, y = known
            return values["less" if x < y else "equal" if x == y else "greater" if x > y else "unordered"]
        pair, mirrored = self._pair(a, b)
        return self._choice(pair, [values[MIRROR[each] if mirrored else each] for each in RELATIONS])

    def test(self, a: Tree, b: Tree, relations: frozenset[str]) -> Any:
        """Return whether two numbers stand in one of the relations: True, False or a choice of these."""
        return self.choose(a, b, {each: each in relations for each in RELATIONS})

    def _pair(self, a: Tree, b: Tree) -> tuple[Tree, bool]:
        """Return a pair of numbers in normal form, and whether its relations are mirrored: -a < b as -b < a."""
        cores = [each.parts[0] if each.kind == "neg" else each for each in (a, b)]
        swapped = cores[0].rank > cores[1].rank
        if swapped:
            a, b = b, a
        turned = a.kind == "neg"
        return self.make("pair", *((a.parts[0], self.negated(b)) if turned else (a, b))), swapped != turned

    def _choice(self, pair: Tree, values: Sequence[Any]) -> Any:
        if all(same(value, values[0]) for value in values):
            return values[0]
        numbers = all(isinstance(value, Tree) and value.kind not in PATTERNS for value in values)
        return self.make("number" if numbers else "choice", pair, *values)

    def lift(self, function: Callable[..., Any], *values: Any) -> Any:
        """Return the value of a function, taken on every branch of the choices among its operands."""
        done = dict[tuple[Any, ...], Any]()  # branches are shared, so each is taken once

        def taken(values: tuple[Any, ...]) -> Any:
            if values not in done:
                chosen = [each for each in values if isinstance(each, Tree) and each.kind == "choice"]
                pair = min((each.parts[0] for each in chosen), key=lambda each: each.rank, default=None)
                done[values] = function(*values) if pair is None else self._choice(pair, [
                    taken(tuple(v.parts[place] if v in chosen and v.parts[0] is pair else v for v in values))
                    for place in range(1, 5)
                ])  # fmt: skip
            return done[values]

        return taken(values)

    def select(self, truth: Any, one: Any, other: Any) -> Any:
        """Return the one value or the other by a truth, or unset if that is not known."""
        return self.unset if isinstance(truth, Tree) else one if truth else other

    def number(self, value: Any) -> Tree:
        """Return a value as a number: a pattern of bits is a constant."""
        if isinstance(value, Tree) and value.kind != "choice":
            return value
        return self.lift(lambda each: self.bits(each) if isinstance(each, int) else each, value)  # type: ignore[no-any-return]

    def rebuilt(self, tree: Tree, changed: Callable[[Any], Any]) -> Any:
        """Return the operation of a tree on changed operands, in normal form."""
        if tree.kind in CHOICES:
            (a, b), values = map(changed, tree.parts[0].parts), map(changed, tree.parts[1:])
            return self.choose(self.number(a), self.number(b), dict(zip(RELATIONS, values, strict=True)))
        parts = [self.number(changed(part)) for part in tree.parts]
        own: dict[str, Callable[..., Tree]] = {"add": self.add, "mul": self.mul, "div": self.div, "neg": self.negated,
                                               "abs": self.absolute, "sqrt": self.sqrt}  # fmt: skip
        return own[tree.kind](*parts) if tree.kind in own else self.call(tree.kind, *parts)

    def as_row(self, tree: Any, row: int, done: dict[tuple[Tree, int], Any]) -> Any:
        """Return the tree of a row as that of the first one: numbers that are given have a row as their last part.

        Numbers of other rows keep their names, so that a tree which mixes rows is that of no row.
        """
        if not row or not isinstance(tree, Tree):
            return tree
        if tree.kind == "given":
            return self.make("given", *tree.parts[:-1], 0 if tree.parts[-1] == row else -1)
        if tree.kind in LEAVES:
            return tree
        if (tree, row) not in done:
            done[tree, row] = self.rebuilt(tree, lambda each: self.as_row(each, row, done))
        return done[tree, row]


def unsigned(a: Tree) -> bool:
    """Return whether a number has no minus sign whatever is given, as a square and a sum of such numbers."""
    if a.kind in ("add", "mul", "div", "sqrt"):
        return (a.kind == "mul" and a.parts[0] is a.parts[1]) or all(map(unsigned, a.parts))
    return a.kind in ("abs", "const")


def same(a: Any, b: Any) -> bool:
    """Return whether two values are one tree, or equal patterns of bits."""
    return a is b or (not isinstance(a, Tree) and not isinstance(b, Tree) and a == b)
