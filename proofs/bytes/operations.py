"""Operations of intermediate code on words; those that are not in the table here are declined."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from .trees import RELATIONS, Declined, Different, Tree
from .words import Words, known, ones, signed

CODES = dict(zip(RELATIONS, (0x01, 0x40, 0x00, 0x45), strict=True))  # of Iop_CmpF64
TRUE = {"LT": {"less"}, "LE": {"less", "equal"}, "EQ": {"equal"}, "UN": {"unordered"}}
VECTOR = {"V128": 16, "V256": 32}
BITWISE: Mapping[str, Callable[[int, int], int]] = {"And": operator.and_, "Or": operator.or_, "Xor": operator.xor}
INTEGERS: Mapping[str, Callable[[int, int], int]] = {
    "Add": operator.add, "Sub": operator.sub, "Mul": operator.mul, "Shl": operator.lshift, "Shr": operator.rshift,
    "Sar": operator.rshift, "CmpEQ": operator.eq, "CmpNE": operator.ne, "CmpLT": operator.lt, "CmpLE": operator.le,
}  # fmt: skip


class Operations(Words):
    """Words with the operations on them."""

    def operation(self, name: str) -> Callable[..., Any]:
        """Return an operation of intermediate code as a function of words."""
        for pattern, method in TABLE:
            if found := re.fullmatch(f"Iop_(?:{pattern})", name):
                return partial(getattr(self, method), name, found.groups())
        raise Declined(f"no operation that is known: {name}")

    def _floats(self, name: str, groups: tuple[str, ...], *words: Any) -> Any:
        """Compute on numbers: on single ones, on those of vectors, or on the lowest of these alone, as `F0x` says."""
        kind, bits, *vector = groups
        words = self._rounded(name, bits, words, 1 if kind in ("Sqrt", "Neg", "Abs") else 2)
        if not vector:
            return self._float(kind, *map(self.trees.number, words))
        low, count = vector
        width = self.unit * int(count)
        lanes = [self.cells(word, width) for word in words]
        done = 1 if low else int(count)
        made = [self._float(kind, *map(self.trees.number, given)) for given in list(zip(*lanes, strict=True))[:done]]
        return self.joined(*((cell, self.unit) for cell in [*made, *lanes[0][done:]]))

    def _rounded(self, name: str, bits: str, words: tuple[Any, ...], arity: int) -> tuple[Any, ...]:
        """Return the operands after the mode of rounding, which is to nearest."""
        if int(bits) != 8 * self.unit:
            raise Declined(f"{name}: an operation of another precision")
        if words[:-arity] not in ((), (0,)):
            raise Declined(f"{name}: a mode of rounding that is not to nearest")
        return words[-arity:]

    def _float(self, kind: str, *given: Tree) -> Any:
        trees = self.trees
        if kind.startswith("Cmp"):
            values = {each: trees.ones if each in TRUE[kind[3:]] else 0 for each in RELATIONS}
            return trees.choose(given[0], given[1], values)
        if kind in ("Min", "Max"):
            truth = trees.test(given[0], given[1], frozenset({"less" if kind == "Min" else "greater"}))
            return trees.lift(trees.select, truth, *given)
        names = {"Neg": "negated", "Abs": "absolute"}
        return getattr(trees, names.get(kind, kind.lower()))(*given)

    def _fused(self, name: str, groups: tuple[str, ...], *words: Any) -> Any:
        raise Different("a fused multiply-add rounds once where the text rounds twice")

    def _widened(self, name: str, groups: tuple[str, ...], word: Any) -> Any:
        (word,) = self._rounded(name, "32", (word,), 1)
        return self.trees.make("widened", self.trees.number(word))

    def _compared(self, name: str, groups: tuple[str, ...], *words: Any) -> Any:
        """Compare two numbers; those of single precision are widened first, which changes no comparison."""
        narrow = [word.parts[0] for word in words if isinstance(word, Tree) and word.kind == "widened"]
        if len(narrow) != 2:
            self._rounded(name, groups[0], words, 2)
        a, b = map(self.trees.number, narrow or words)
        return self.trees.choose(a, b, CODES)

    def _number(self, name: str, groups: tuple[str, ...], *words: Any) -> Any:
        """Convert a known integer to a number."""
        width = int(groups[0]) // 8
        (word,) = self._rounded(name, groups[1], words, 1)
        return self.trees.lift(lambda each: self.trees.constant(signed(known(each), width)), word)

    def _bitwise(self, name: str, groups: tuple[str, ...], *words: Any) -> Any:
        kind, type_ = groups
        width = VECTOR.get(type_) or int(type_) / 8
        if kind == "Not":
            kind, words = "Xor", (*words, (1 << int(8 * width)) - 1)
        if width < self.unit or all(isinstance(word, int) for word in words):
            return self.trees.lift(partial(self._bits, kind, int(width)), *words)
        if type_ not in VECTOR and any(isinstance(word, Tree) and word.kind == "choice" for word in words):
            return self.trees.lift(partial(self._bitwise, name, (kind, type_)), *words)
        lanes = zip(*(self.cells(word, int(width)) for word in words), strict=True)
        made = (self.trees.lift(partial(self._bits, kind, self.unit), *pair) for pair in lanes)
        return self.joined(*((cell, self.unit) for cell in made))

    def _bits(self, kind: str, width: int, a: Any, b: Any) -> Any:
        """Return a bitwise operation on patterns, or on a number and a mask of its sign."""
        trees, every, sign = self.trees, self.trees.ones, self.trees.sign
        if isinstance(a, int) and isinstance(b, int):
            return BITWISE[kind](a, b)
        if a is b:
            return 0 if kind == "Xor" and a is not trees.unset else a
        if any(isinstance(word, Tree) and word.kind == "joined" for word in (a, b)):
            bytes_ = ((self.part(a, place, 1), self.part(b, place, 1)) for place in range(width))
            return self.joined(*((self._bits(kind, 1, *pair), 1) for pair in bytes_))
        number, mask = (b, a) if isinstance(a, int) else (a, b)
        if isinstance(mask, int):
            if (pattern := trees.pattern(number)) is not None:
                return BITWISE[kind](pattern, mask)
            absorbing = (kind, mask) in (("And", 0), ("Or", every))
            if absorbing or (kind, mask) in (("And", every), ("Or", 0), ("Xor", 0)):
                return mask if absorbing else number
            if number is not trees.unset and number.kind != "part" and mask in (sign, every ^ sign):
                size = trees.absolute(number)
                signs = {("And", every ^ sign): size, ("Or", sign): trees.negated(size)}
                if kind == "Xor" and mask == sign:
                    return trees.negated(number)
                if (kind, mask) in signs:
                    return signs[kind, mask]
        return trees.unset if trees.unset in (a, b) else trees.make("unknown", kind, a, b)

    def _integer(self, name: str, groups: tuple[str, ...], a: Any, b: Any) -> Any:
        kind, bits, sign = groups
        width = int(bits) // 8
        if kind in ("Shl", "Shr") and isinstance(b, int) and not isinstance(a, int) and not b % 8:
            start = b // 8  # whole bytes of numbers
            if kind == "Shl":
                return self.joined((0, start), (self.part(a, 0, width - start), width - start))
            return self.joined((self.part(a, start, width - start), width - start), (0, start))

        def leaf(x: Any, y: Any) -> int:
            x, y = known(x), known(y)
            if kind == "Sar" or sign == "S":
                x = signed(x, width)
            if sign == "S":
                y = signed(y, width)
            return int(INTEGERS[kind](x, y)) & ones(width)

        return leaf(a, b) if isinstance(a, int) and isinstance(b, int) else self.trees.lift(leaf, a, b)

    def _divided(self, name: str, groups: tuple[str, ...], a: Any, b: Any) -> Any:
        """Return a quotient of integers, with the remainder above it where the operation has both."""
        both, width = groups[0] != "S", int(groups[1]) // 8

        def leaf(x: Any, y: Any) -> int:
            x, y = signed(known(x), 8 if both else width), signed(known(y), width)
            quotient = abs(x) // abs(y) * (1 if (x < 0) == (y < 0) else -1) if y else 0
            return quotient & ones(width) | ((x - quotient * y & ones(width)) << 8 * width if both else 0)

        return self.trees.lift(leaf, a, b)

    def _shifted(self, name: str, groups: tuple[str, ...], word: Any, count: int) -> Any:
        """Shift the bits in each lane of a vector of patterns, such as those of comparisons."""
        kind, bits, lanes = groups
        width = int(bits) // 8
        made = [(self._integer(name, (kind, bits, ""), self.part(word, start * width, width), count), width)
                for start in range(int(lanes))]  # fmt: skip
        return self.joined(*made)

    def _part(self, name: str, groups: tuple[str, ...], word: Any) -> Any:
        """Return a part of a word; the groups name its type, and whether it is the low or high one or its place."""
        high, type_, place = groups
        if type_ == "1":
            return self.trees.lift(lambda each: known(each) & 1, self.part(word, 0, 1))
        width = VECTOR.get(type_) or int(type_) // 8
        return self.part(word, width * (int(place) if place else bool(high)), width)

    def _extended(self, name: str, groups: tuple[str, ...], word: Any) -> Any:
        old, sign, new = groups
        width, wide = int(old) // 8, VECTOR.get(new) or int(new) // 8
        if sign == "S":
            bits = max(1, int(old))
            return self.trees.lift(lambda each: (known(each) - (known(each) >> bits - 1 << bits)) & ones(wide), word)
        return word if wide == width or isinstance(word, int) or not width else self._wider(word, width, wide)

    def _wider(self, word: Any, width: int, wide: int) -> Any:
        return self.joined((word, width), *((0, step) for step in self._steps(width, wide)))

    def _cut(self, name: str, groups: tuple[str, ...], word: Any) -> Any:
        """Return a vector with zeros in place of its highest bits."""
        width = 16 - int(groups[0]) // 8
        return self._wider(self.part(word, 0, width), width, 16)

    def _steps(self, width: int, wide: int) -> list[int]:
        """Return the widths of zeros that fill a word: first up to a whole number, then by numbers."""
        rest = -width % self.unit
        return [*([rest] if rest else []), *[self.unit] * ((wide - width - rest) // self.unit)]

    def _pair(self, name: str, groups: tuple[str, ...], *words: Any) -> Any:
        """Join words, the highest first."""
        type_ = groups[0] or groups[1]
        width = VECTOR.get(type_) or int(type_) // 8
        return self.joined(*((word, width) for word in reversed(words)))

    def _low(self, name: str, groups: tuple[str, ...], word: Any, low: Any) -> Any:
        width = int(groups[0]) // 8
        return self.joined((low, width), (self.part(word, width, 16 - width), 16 - width))

    def _interleaved(self, name: str, groups: tuple[str, ...], high: Any, low: Any) -> Any:
        side, bits, count = groups
        width, half = int(bits) // 8, int(count) // 2
        places = range(half, 2 * half) if side == "HI" else range(half)
        made = [self.part(word, place * width, width) for place in places for word in (low, high)]
        return self.joined(*((piece, width) for piece in made))

    def _as_it_is(self, name: str, groups: tuple[str, ...], word: Any) -> Any:
        return word


TABLE = (
    (r"(Add|Sub|Mul|Div|Min|Max|Sqrt|Neg|Abs|Cmp(?:LT|LE|EQ|UN))(32|64)F(0)?x(\d)", "_floats"),
    (r"(Add|Sub|Mul|Div|Sqrt|Neg|Abs)F(32|64)", "_floats"),
    (r"N?M(?:Add|Sub)F?(?:32|64).*", "_fused"),
    (r"F32toF64", "_widened"),
    (r"CmpF(32|64)", "_compared"),
    (r"I(32|64)StoF(32|64)", "_number"),
    (r"(And|Or|Xor|Not)(V128|V256|\d+)", "_bitwise"),
    (r"(Add|Sub|Mul|Shl|Shr|Sar|Cmp(?:EQ|NE|LT|LE))(8|16|32|64)([US]?)", "_integer"),
    (r"Div(ModS64to|S)(32|64)", "_divided"),
    (r"(Shl|Shr|Sar)N(\d+)x(\d+)", "_shifted"),
    (r"(?:\d+|V128|V256)(HI)?to(\d+|V128)(?:_(\d))?", "_part"),
    (r"(\d+)([US])to(\d+|V128)", "_extended"),
    (r"ZeroHI(\d+)ofV128", "_cut"),
    (r"(\d+|V128)HLto(?:\w+)|(\d+)x4toV256", "_pair"),
    (r"SetV128lo(32|64)", "_low"),
    (r"Interleave(LO|HI)(\d+)x(\d+)", "_interleaved"),
    (r"ReinterpF(?:32|64)asI\d+|ReinterpI(?:32|64)asF\d+", "_as_it_is"),
)
"""Patterns of operations of intermediate code, and the methods that compute them from what the groups name."""
