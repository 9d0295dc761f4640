"""Trees of rounded operations, one object for each, and their choices by comparisons of numbers.

Two programs whose trees are one object compute the same bits. Trees are brought to a normal form by identities that
hold for every float, infinities, signed zeros and NaN included; only sign and payload of a NaN are left open:
a + b = b + a, a b = b a, a - b = a + (-b), (-a) b = -(a b), a / b likewise, 2 a = a + a,
(-a) + (-a) = -(a + a), 1 a = a, a + (-0) = a,
a / 2^k = a 2^-k, |-a| = |a|, |a| = a for sums of
squares, and the values of operations on constants.
"""

from __future__ import annotations

import math
import operator
import struct
import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from .statements import MachineError

RELATIONS = ("less", "equal", "greater", "unordered")
MIRROR = {"less": "greater", "greater": "less", "equal": "equal", "unordered": "unordered"}
TYPES: dict[str, tuple[Any, str, str]] = {"double": (np.float64, "<d", "<Q"), "float": (np.float32, "<f", "<I")}
SCALES = np.array([1.0, 1.0, 0.1, 3.0, 1e-4, 10.0, 0.0, 1e-9])  # of samples
CHOICES = ("choice", "number")
PATTERNS = ("choice", "joined")
LEAVES = ("given", "const", "saved", "unset")
COMPARISONS = 3_000  # largest number of pairs of trees that are compared


class Declined(MachineError):
    """Reason why a function is neither proved equal nor found different."""


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
        parts = (part.text(depth - 1) if isinstance(part, Tree) else str(part) for part in self.parts)
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
        self.compared = dict[tuple[Tree, Tree], bool]()
        self.cases = dict[tuple[Tree, int], dict[Tree, Any]]()
        self.samples = dict[Tree, Any]()

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

    def _value(self, tree: Tree) -> Any:
        """Return the float of a constant, or None."""
        inner = tree.parts[0] if tree.kind == "neg" else tree
        if inner.kind != "const":
            return None
        value = self.type(struct.unpack(self.float_code, struct.pack(self.int_code, inner.parts[0]))[0])
        return -value if inner is not tree else value

    def _folded(self, operation: Callable[..., Any], *operands: Tree) -> Tree | None:
        """Return the rounded value of an operation on constants."""
        if any("const" not in (each.kind, each.kind == "neg" and each.parts[0].kind) for each in operands):
            return None
        values = [self._value(each) for each in operands]
        with np.errstate(all="ignore"):
            return self.bits(self._pattern(operation(*values)))

    # --- operations ---------------------------------------------------------------------------------------------------

    def negated(self, a: Tree) -> Tree:
        return a.parts[0] if a.kind == "neg" else a if a is self.unset else self.make("neg", a)

    def absolute(self, a: Tree) -> Tree:
        inner = a.parts[0] if a.kind == "neg" else a
        return inner if _unsigned(inner) or inner is self.unset else self.make("abs", inner)

    def add(self, a: Tree, b: Tree) -> Tree:
        for one, other in ((a, b), (b, a)):
            if one.kind == "neg" and one.parts[0].kind == "const" and not one.parts[0].parts[0]:
                return other
        if a is b and a.kind == "neg":
            return self.negated(self.add(a.parts[0], a.parts[0]))
        return self._folded(np.add, a, b) or self._ordered("add", a, b)

    def sub(self, a: Tree, b: Tree) -> Tree:
        return self.add(a, self.negated(b))

    def mul(self, a: Tree, b: Tree) -> Tree:
        if (folded := self._folded(np.multiply, a, b)) is not None:
            return folded
        a, b, opposite = self._unsigned(a, b)
        for one, other in ((a, b), (b, a)):
            if self._value(one) in (1, 2):
                made = other if self._value(one) == 1 else self.add(other, other)
                break
        else:
            made = self._ordered("mul", a, b)
        return self.negated(made) if opposite else made

    def div(self, a: Tree, b: Tree) -> Tree:
        if (folded := self._folded(np.divide, a, b)) is not None:
            return folded
        a, b, opposite = self._unsigned(a, b)
        value = self._value(b)
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

    def _unsigned(self, a: Tree, b: Tree) -> tuple[Tree, Tree, bool]:
        opposite = (a.kind == "neg") != (b.kind == "neg")
        return (*(each.parts[0] if each.kind == "neg" else each for each in (a, b)), opposite)  # type: ignore[return-value]

    # --- choices ------------------------------------------------------------------------------------------------------

    def choose(self, a: Tree, b: Tree, values: Mapping[str, Any]) -> Any:
        """Return the value that belongs to the relation of two numbers."""
        if self.unset in (a, b):
            return self.unset
        if a is b:
            values = {**dict.fromkeys(RELATIONS, values["equal"]), "unordered": values["unordered"]}
        known = self._value(a), self._value(b)
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
        pairs = [each.parts[0] for each in values if isinstance(each, Tree) and each.kind == "choice"]
        if not pairs:
            return function(*values)
        pair, known = min(pairs, key=lambda each: each.rank), dict[tuple[Any, ...], Any]()
        made = []
        for place in range(1, 5):
            given = tuple(v.parts[place] if isinstance(v, Tree) and v.kind == "choice" and v.parts[0] is pair else v
                          for v in values)  # fmt: skip
            if given not in known:
                known[given] = self.lift(function, *given)
            made.append(known[given])
        return self._choice(pair, made)

    def number(self, value: Any) -> Tree:
        """Return a value as a number: a pattern of bits is a constant."""
        if isinstance(value, Tree) and value.kind != "choice":
            return value
        return self.lift(lambda each: self.bits(each) if isinstance(each, int) else each, value)  # type: ignore[no-any-return]

    # --- equality -----------------------------------------------------------------------------------------------------

    def equal(self, a: Any, b: Any) -> bool:
        """Return whether two values have the same bits, however the numbers compare on which their choices depend."""
        if not (isinstance(a, Tree) and isinstance(b, Tree)) or a is b:
            return same(a, b)
        if (a, b) not in self.compared:
            if len(self.compared) > COMPARISONS:
                raise Declined(f"more than {COMPARISONS} comparisons of trees")
            agree = self.sample(a).tobytes() == self.sample(b).tobytes()
            self.compared[a, b] = agree and (self._alike(a, b) or self._equal_in_cases(a, b))
        return self.compared[a, b]

    def sample(self, tree: Any) -> Any:
        """Return the values of a tree for some numbers that are given; trees whose values differ are not equal."""
        if not isinstance(tree, Tree):
            return np.full(len(SCALES), tree, float).astype(self.type)
        if tree not in self.samples:
            with np.errstate(all="ignore"):
                made = np.asarray(self._sampled(tree), self.type)
            self.samples[tree] = np.where(np.isnan(made), self.type(math.nan), made)
        return self.samples[tree]

    def _sampled(self, tree: Tree) -> Any:
        if tree.kind == "const":
            return np.full(len(SCALES), self._value(tree))
        if tree.kind in CHOICES:
            a, b = map(self.sample, tree.parts[0].parts)
            return np.select([a < b, a == b, a > b], [self.sample(part) for part in tree.parts[1:4]],
                             self.sample(tree.parts[4]))  # fmt: skip
        known: dict[str, Any] = {"add": np.add, "mul": np.multiply, "div": np.divide, "neg": np.negative, "abs": np.abs,
                                 "sqrt": np.sqrt}  # fmt: skip
        if tree.kind in known:
            return known[tree.kind](*map(self.sample, tree.parts))
        if tree.kind in LEAVES:
            seed = zlib.crc32(repr((tree.kind, tree.parts)).encode())
            return np.random.default_rng(seed).normal(size=len(SCALES)) * SCALES
        inner = np.full(len(SCALES), float(zlib.crc32(tree.kind.encode()) % 1000))
        for place, part in enumerate(tree.parts):  # any function, value by value
            inner += (place + 1.3) * (zlib.crc32(part.encode()) % 1000 if isinstance(part, str) else self.sample(part))
        return np.sin(inner)

    def forget(self) -> None:
        """Forget which trees were compared."""
        self.compared.clear()
        self.cases.clear()

    def _alike(self, a: Tree, b: Tree) -> bool:
        """Return whether two trees are one operation on equal operands."""
        if a.kind != b.kind or a.kind in CHOICES or len(a.parts) != len(b.parts) or not (a.pairs or b.pairs):
            return False
        orders = [b.parts, b.parts[::-1]] if a.kind in ("add", "mul") else [b.parts]
        return any(all(map(self.equal, a.parts, order)) for order in orders)

    def _equal_in_cases(self, a: Tree, b: Tree) -> bool:
        """Compare two trees for each relation of one pair of numbers, itself free of choices."""
        pairs = [pair for pair in a.pairs | b.pairs if not pair.pairs]
        if not pairs:
            return False
        pair = min(pairs, key=lambda each: each.rank)
        return all(self.equal(*(self._in_case(each, pair, place) for each in (a, b))) for place in range(1, 5))

    def unknown(self, *values: Any) -> Tree:
        """Return a value of which nothing is known."""
        return self.make("unknown", *values)

    def difference(self, a: Any, b: Any) -> tuple[Any, Any]:
        """Return the first operations that differ in two trees, for relations of numbers where these differ."""
        while isinstance(a, Tree) and isinstance(b, Tree) and a.pairs | b.pairs:
            pair = min((pair for pair in a.pairs | b.pairs if not pair.pairs), key=lambda each: each.rank)
            cases = [[self._in_case(each, pair, place) for each in (a, b)] for place in range(1, 5)]
            a, b = next((x, y) for x, y in cases if not self.equal(x, y))
        while isinstance(a, Tree) and isinstance(b, Tree) and a.kind == b.kind:
            parts = [(x, y) for x in a.parts if x not in b.parts for y in b.parts if y not in a.parts]
            if len(parts) != 1 or not all(isinstance(each, Tree) for each in parts[0]):
                break
            a, b = parts[0]
        return a, b

    def _in_case(self, tree: Any, pair: Tree, place: int) -> Any:
        """Return a tree where a pair of numbers stands in the relation at a place of its choices."""
        if (pair, place) not in self.cases:
            self.cases[pair, place] = dict(self._same_bits(pair) if RELATIONS[place - 1] == "equal" else ())
        done = self.cases[pair, place]

        def walk(each: Any) -> Any:
            if not isinstance(each, Tree) or each.kind in LEAVES:
                return done.get(each, each) if isinstance(each, Tree) else each
            if each not in done:
                made = each if each.kind in CHOICES and each.parts[0] is pair else self.rebuilt(each, walk)
                chosen = isinstance(made, Tree) and made.kind in CHOICES and made.parts[0] is pair
                done[each] = walk(made.parts[place]) if chosen else made
            return done[each]

        return walk(tree)

    def _same_bits(self, pair: Tree) -> Iterator[tuple[Tree, Tree]]:
        """Yield a number with the constant whose bits it has if they are equal: zeros may differ in sign."""
        for one, other in (pair.parts, pair.parts[::-1]):
            value = self._value(other)
            if value or (value == 0 and _unsigned(one) and not np.signbit(value)):
                yield one, other

    def rebuilt(self, tree: Tree, changed: Callable[[Any], Any]) -> Any:
        """Return the operation of a tree on changed operands, in normal form."""
        if tree.kind in CHOICES:
            (a, b), values = map(changed, tree.parts[0].parts), map(changed, tree.parts[1:])
            return self.choose(self.number(a), self.number(b), dict(zip(RELATIONS, values, strict=True)))
        parts = [self.number(changed(part)) for part in tree.parts]
        own: dict[str, Callable[..., Tree]] = {"add": self.add, "mul": self.mul, "div": self.div, "neg": self.negated,
                                               "abs": self.absolute, "sqrt": self.sqrt}  # fmt: skip
        return own[tree.kind](*parts) if tree.kind in own else self.call(tree.kind, *parts)

    def renamed(self, tree: Any, names: dict[Tree, Tree], done: dict[Tree, Any]) -> Any:
        """Return a tree with other names of what is given."""
        if not isinstance(tree, Tree) or tree.kind in LEAVES:
            return names.get(tree, tree) if isinstance(tree, Tree) else tree
        if tree not in done:
            done[tree] = self.rebuilt(tree, lambda each: self.renamed(each, names, done))
        return done[tree]


def _unsigned(a: Tree) -> bool:
    """Return whether a number has no minus sign whatever is given, as a square and a sum of such numbers."""
    if a.kind in ("add", "mul", "div"):
        return (a.kind == "mul" and a.parts[0] is a.parts[1]) or all(map(_unsigned, a.parts))
    return a.kind in ("abs", "const")


def same(a: Any, b: Any) -> bool:
    """Return whether two values are one tree, or equal patterns of bits."""
    return a is b or (not isinstance(a, Tree) and not isinstance(b, Tree) and a == b)


class Number:
    """Number for the interpreter of C: its operations are trees, its comparisons questions to the path."""

    __slots__ = ("tree", "trees")

    def __init__(self, trees: Trees, tree: Tree) -> None:
        self.trees, self.tree = trees, tree

    def _made(self, operation: Callable[[Tree, Tree], Tree], other: Any, swapped: bool = False) -> Number:
        operands = (self._other(other), self.tree) if swapped else (self.tree, self._other(other))
        return Number(self.trees, operation(*operands))

    def _other(self, other: Any) -> Tree:
        return other.tree if isinstance(other, Number) else self.trees.constant(other)

    def __add__(self, other: Any) -> Number:
        return self._made(self.trees.add, other)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Number:
        return self._made(self.trees.sub, other)

    def __rsub__(self, other: Any) -> Number:
        return self._made(self.trees.sub, other, swapped=True)

    def __mul__(self, other: Any) -> Number:
        return self._made(self.trees.mul, other)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Number:
        return self._made(self.trees.div, other)

    def __rtruediv__(self, other: Any) -> Number:
        return self._made(self.trees.div, other, swapped=True)

    def __neg__(self) -> Number:
        return Number(self.trees, self.trees.negated(self.tree))

    def __abs__(self) -> Number:
        return Number(self.trees, self.trees.absolute(self.tree))

    def sqrt(self) -> Number:
        return Number(self.trees, self.trees.sqrt(self.tree))

    def tan(self) -> Number:
        return Number(self.trees, self.trees.call("tan", self.tree))

    def arctan2(self, other: Any) -> Number:
        return self._made(lambda a, b: self.trees.call("atan2", a, b), other)

    def expm1(self) -> Number:
        return Number(self.trees, self.trees.call("expm1", self.tree))

    def log1p(self) -> Number:
        return Number(self.trees, self.trees.call("log1p", self.tree))

    def __lt__(self, other: Any) -> Truth:
        return self._test(other, "less")

    def __gt__(self, other: Any) -> Truth:
        return self._test(other, "greater")

    def __eq__(self, other: object) -> Truth:  # type: ignore[override]
        return self._test(other, "equal")

    __hash__ = None  # type: ignore[assignment]

    def _test(self, other: Any, relation: str) -> Truth:
        return Truth(self.trees, self.trees.test(self.tree, self._other(other), frozenset({relation})))


class Truth:
    """Truth of comparisons, for the interpreter of C."""

    __slots__ = ("trees", "value")

    def __init__(self, trees: Trees, value: Any) -> None:
        self.trees, self.value = trees, value

    def __and__(self, other: Truth) -> Truth:
        return Truth(self.trees, self.trees.lift(operator.and_, self.value, other.value))

    def __or__(self, other: Truth) -> Truth:
        return Truth(self.trees, self.trees.lift(operator.or_, self.value, other.value))

    def __bool__(self) -> bool:
        raise TypeError("a branch depends on a comparison of numbers")

    def choose(self, one: Any, other: Any) -> Any:
        """Return the one number or truth, or the other."""
        sides = [each.value if isinstance(each, Truth) else each.tree if isinstance(each, Number)
                 else self.trees.constant(each) for each in (one, other)]  # fmt: skip
        made = self.trees.lift(lambda truth, a, b: a if truth else b, self.value, *sides)
        return Truth(self.trees, made) if isinstance(one, Truth) else Number(self.trees, made)
