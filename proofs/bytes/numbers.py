"""Numbers and truths for the interpreter of C: their operations are trees, their comparisons choices."""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

from .trees import Tree, Trees


def _operation(name: str, swapped: bool = False) -> Callable[[Number, Any], Number]:
    def made(self: Number, other: Any) -> Number:
        operands = (self.of(other), self.tree) if swapped else (self.tree, self.of(other))
        return Number(self.trees, getattr(self.trees, name)(*operands))

    return made


def _function(name: str) -> Callable[..., Number]:
    return lambda self, *others: Number(self.trees, self.trees.call(name, self.tree, *map(self.of, others)))


def _comparison(relation: str) -> Callable[[Number, Any], Truth]:
    return lambda self, other: Truth(self.trees, self.trees.test(self.tree, self.of(other), frozenset({relation})))


class Number:
    """Number whose value is a tree."""

    __slots__ = ("tree", "trees")

    def __init__(self, trees: Trees, tree: Tree) -> None:
        self.trees, self.tree = trees, tree

    def of(self, other: Any) -> Tree:
        """Return the tree of a number or of an exact constant."""
        return other.tree if isinstance(other, Number) else self.trees.constant(other)

    __add__ = __radd__ = _operation("add")
    __sub__, __rsub__ = _operation("sub"), _operation("sub", swapped=True)
    __mul__ = __rmul__ = _operation("mul")
    __truediv__, __rtruediv__ = _operation("div"), _operation("div", swapped=True)
    __lt__, __gt__, __eq__ = _comparison("less"), _comparison("greater"), _comparison("equal")  # type: ignore[assignment]
    __hash__ = None  # type: ignore[assignment]
    tan, arctan2, expm1, log1p = map(_function, ("tan", "atan2", "expm1", "log1p"))

    def __neg__(self) -> Number:
        return Number(self.trees, self.trees.negated(self.tree))

    def __abs__(self) -> Number:
        return Number(self.trees, self.trees.absolute(self.tree))

    def sqrt(self) -> Number:
        return Number(self.trees, self.trees.sqrt(self.tree))


class Truth:
    """Truth of comparisons: True, False or a choice of these."""

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
        made = self.trees.lift(self.trees.select, self.value, *sides)
        return Truth(self.trees, made) if isinstance(one, Truth) else Number(self.trees, made)
