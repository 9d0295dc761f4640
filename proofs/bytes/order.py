"""Contradictions among relations of numbers: the order of numbers is transitive, and NaN stands in no order."""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterable, Iterator
from itertools import chain, pairwise

from .trees import RELATIONS, Tree, Trees, unsigned

Fact = tuple[Tree, int]
"""Pair of numbers whose relation is known, by its place."""
Facts = frozenset[Fact]
Edge = tuple[Hashable, Hashable, bool]
"""Number that is less than another one, or at most equal."""


def in_order(facts: Iterable[Fact]) -> list[Fact]:
    """Return facts in one order, that of their pairs, which no address in memory changes."""
    return sorted(facts, key=lambda each: (each[0].rank, each[1]))


class Order:
    """Order of the numbers that stand in relations."""

    def __init__(self, trees: Trees) -> None:
        self.trees = trees
        self.edges = dict[Fact, list[Edge]]()
        self.operands = dict[Fact, set[Tree]]()

    def contradiction(self, facts: Facts, new: Fact) -> Facts | None:
        """Return facts that contradict each other, the new one among them, or None if there is no such cycle."""
        for each in in_order(facts | {new}):
            if RELATIONS[each[1] - 1] == "unordered" and (found := self._numbers(facts | {new}, each)) is not None:
                return found
        every = {each: self._edges(each) for each in in_order(self._related(facts, new))}
        after = dict[Hashable, list[tuple[Hashable, bool, Facts]]]()
        for fact, edges in every.items():
            for low, high, less in edges:
                after.setdefault(low, []).append((high, less, frozenset({fact})))
        values = {node for edge in chain(*every.values()) for node in edge[:2] if isinstance(node, float)}
        for low, high in pairwise(sorted(values)):
            after.setdefault(low, []).append((high, True, frozenset()))
        for low, high, less in every[new]:
            if (way := self._way(after, (high, less), low)) is not None:
                return way | {new}
        return None

    def _related(self, facts: Facts, new: Fact) -> Facts:
        """Return a fact with those that share numbers with it, and with these."""
        found, sizes = {new}, self._sizes(new)
        while more := {each for each in facts if each not in found and not sizes.isdisjoint(self._sizes(each))}:
            found |= more
            sizes = sizes.union(*map(self._sizes, more))
        return frozenset(found)

    def _sizes(self, fact: Fact) -> frozenset[Tree]:
        """Return the numbers of a pair without their signs, but for constants."""
        cores = [each.parts[0] if each.kind == "neg" else each for each in fact[0].parts]
        return frozenset(each for each in cores if each.kind != "const")

    def _way(self, after: dict[Hashable, list[tuple[Hashable, bool, Facts]]], start: tuple[Hashable, bool],
             end: Hashable) -> Facts | None:  # fmt: skip
        """Return the facts by which a number is at most another one, if it is less on the whole cycle."""
        found, waiting = {start: Facts()}, [start]
        for place in waiting:
            for node, less, facts in after.get(place[0], ()):
                if (node, less or place[1]) not in found:
                    found[node, less or place[1]] = found[place] | facts
                    waiting.append((node, less or place[1]))
        return found.get((end, True))

    def _numbers(self, facts: Facts, new: Fact) -> Facts | None:
        """Return the facts by which both numbers of a pair are not NaN, so that they stand in an order."""
        found = frozenset({new})
        for part in new[0].parts:
            if (one := self._number(part, facts)) is None:
                return None
            found |= one
        return found

    def _number(self, tree: Tree, facts: Facts) -> Facts | None:
        """Return the facts by which a tree is not NaN: each operand of a number is one."""
        if tree.kind == "const":
            return None if math.isnan(self.trees.value(tree)) else Facts()
        for each in in_order(facts):
            if tree in self._operands(each):
                return frozenset({each})
        if tree.kind not in ("neg", "abs", "sqrt", "add", "mul") or (tree.kind == "sqrt" and not unsigned(tree)):
            return None
        values = [self.trees.value(part) for part in tree.parts]
        finite = any(value is not None and math.isfinite(value) and (value or tree.kind == "add") for value in values)
        if len(values) == 2 and not finite and not (tree.kind == "add" and unsigned(tree)):
            return None  # the difference of infinities, and zero times infinity
        found = [self._number(part, facts) for part in tree.parts]
        return None if None in found else frozenset().union(*(each for each in found if each))

    def _operands(self, fact: Fact) -> set[Tree]:
        """Return the numbers of a pair that stands in an order, and what they are computed of."""
        if fact not in self.operands:
            found, waiting = set[Tree](), [*fact[0].parts] if RELATIONS[fact[1] - 1] != "unordered" else []
            while waiting:
                if (each := waiting.pop()) not in found:
                    found.add(each)
                    waiting += each.parts if each.kind in ("neg", "abs", "sqrt", "add", "mul", "div") else ()
            self.operands[fact] = found
        return self.operands[fact]

    def _edges(self, fact: Fact) -> list[Edge]:
        if fact not in self.edges:
            (a, b), relation = fact[0].parts, RELATIONS[fact[1] - 1]
            made = list[Edge]()
            if relation != "unordered":
                low, high = (b, a) if relation == "greater" else (a, b)
                for x, y in ((low, high), (high, low))[: 1 + (relation == "equal")]:
                    made += self._both(x, y, relation != "equal")
                for size in filter(unsigned, self._sizes(fact)):
                    made += self._both(self.trees.constant(0), size, False)
            self.edges[fact] = made
        return self.edges[fact]

    def _both(self, low: Tree, high: Tree, less: bool) -> Iterator[Edge]:
        """Yield a relation of two numbers and that of their opposites."""
        yield self._node(low), self._node(high), less
        yield self._node(self.trees.negated(high)), self._node(self.trees.negated(low)), less

    def _node(self, tree: Tree) -> Hashable:
        """Return a number as a node of the graph; equal constants are one."""
        value = self.trees.value(tree)
        return tree if value is None or math.isnan(value) else float(value)
