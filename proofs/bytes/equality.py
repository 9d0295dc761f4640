"""Equality of trees for all numbers: for each relation of the numbers on which their choices depend."""

from __future__ import annotations

import math
import zlib
from collections.abc import Iterable, Iterator
from itertools import chain
from typing import Any

import numpy as np

from .order import Fact, Facts, Order, in_order
from .trees import CHOICES, LEAVES, RELATIONS, Declined, Tree, Trees, same, unsigned

SCALES = np.array([1.0, 1.0, 0.1, 3.0, 1e-4, 10.0, 0.0, 1e-9])  # of samples
REBUILT = 300_000  # largest number of trees that are made anew for cases of a function
SOON, CANDIDATES = 10_000, 3  # the same for a part, and the largest number of parts with which it is compared


class Equality:
    """Comparison of trees, with samples of their values and what was found so far."""

    def __init__(self, trees: Trees) -> None:
        self.trees, self.order = trees, Order(trees)
        self.reasons = dict[tuple[Tree, Tree], list[Facts]]()
        self.refused = set[tuple[Tree, Tree, Facts]]()
        self.rebuilt, self.bound = 0, REBUILT
        self.texts, self.indexed, self.swept = dict[bytes, list[Tree]](), set[Tree](), dict[Tree, Any]()
        self.cases = dict[Fact, tuple[dict[Tree, Any], bool]]()
        self.samples = dict[Tree, Any]()

    def equal(self, a: Any, b: Any) -> bool:
        """Return whether two values have the same bits, however the numbers compare on which their choices depend."""
        if isinstance(a, Tree) and isinstance(b, Tree) and a is not b:
            self._index(a)
            b = self._swept(b)
        return self._reason(a, b, Facts()) == Facts()

    def _index(self, tree: Any) -> None:
        """Gather the parts of a text that depend on choices, by their values at samples."""
        waiting = [tree]
        while waiting:
            each = waiting.pop()
            if isinstance(each, Tree) and each.pairs and each not in self.indexed:
                self.indexed.add(each)
                waiting += each.parts
                if each.kind not in ("choice", "pair"):
                    self.texts.setdefault(self.sample(each).tobytes(), []).append(each)

    def _swept(self, tree: Any) -> Any:
        """Return a tree with its numbers replaced by those of the text that are equal, the inner ones first."""
        if not isinstance(tree, Tree) or not tree.pairs:
            return tree
        if tree not in self.swept:
            made = self.trees.rebuilt(tree, self._swept)
            self.swept[tree] = self._of_text(made) if isinstance(made, Tree) and made.kind == "number" else made
        return self.swept[tree]

    def _of_text(self, tree: Tree) -> Tree:
        """Return the number of the text that equals a choice of numbers, or the choice if none is found soon."""
        for each in self.texts.get(self.sample(tree).tobytes(), [])[:CANDIDATES]:
            self.bound = min(self.rebuilt + SOON, REBUILT)
            try:
                if self._reason(each, tree, frozenset()) is not None:
                    return each
            except Declined:
                pass
            finally:
                self.bound = REBUILT
        return tree

    def _reason(self, a: Any, b: Any, facts: Facts) -> Facts | None:
        """Return those of some facts by which two values have the same bits, or None."""
        if not (isinstance(a, Tree) and isinstance(b, Tree)) or a is b:
            return frozenset() if same(a, b) else None
        pairs = a.pairs | b.pairs
        for pair, place in in_order(facts):
            if pair in pairs:  # it came again when another pair was known
                return self._in_case_reason(a, b, pair, place, facts)
        for reason in self.reasons.setdefault((a, b), []):
            if reason <= facts:
                return reason
        if (a, b, facts) in self.refused:
            return None
        found = None
        if self.alike_at_samples(a, b, facts):
            found = self._alike(a, b, facts)
            found = self._equal_in_cases(a, b, facts) if found is None else found
            found = self._equal_by_values(a, b, facts) if found is None else found
        if found is None:
            self.refused.add((a, b, facts))
        else:
            self.reasons[a, b].append(found)
        return found

    def _in_case_reason(self, a: Tree, b: Tree, pair: Tree, place: int, facts: Facts) -> Facts | None:
        """Return the facts by which two trees are equal where one of the facts holds, with that one."""
        found = self._reason(self._in_case(a, pair, place), self._in_case(b, pair, place), facts)
        return None if found is None else found | {(pair, place)}

    def alike_at_samples(self, a: Tree, b: Tree, facts: Facts = frozenset()) -> bool:
        """Return whether two trees have the same bits at the samples for which facts hold."""
        here = np.full(len(SCALES), True)
        for pair, place in facts:
            here &= self._relation(pair) == place
        return bool(self.sample(a)[here].tobytes() == self.sample(b)[here].tobytes())

    def sample(self, tree: Any) -> Any:
        """Return the values of a tree for some numbers that are given; trees whose values differ are not equal."""
        if not isinstance(tree, Tree):
            return np.full(len(SCALES), tree, float).astype(self.trees.type)
        if tree not in self.samples:
            with np.errstate(all="ignore"):
                made = np.asarray(self._sampled(tree), self.trees.type)
            self.samples[tree] = np.where(np.isnan(made), self.trees.type(math.nan), made)
        return self.samples[tree]

    def _sampled(self, tree: Tree) -> Any:
        if tree.kind == "const":
            return np.full(len(SCALES), self.trees.value(tree))
        if tree.kind in CHOICES:
            return np.choose(self._relation(tree.parts[0]) - 1, [self.sample(part) for part in tree.parts[1:]])
        known: dict[str, Any] = {"add": np.add, "mul": np.multiply, "div": np.divide, "neg": np.negative, "abs": np.abs,
                                 "sqrt": np.sqrt}  # fmt: skip
        if tree.kind in known:
            return known[tree.kind](*map(self.sample, tree.parts))
        if tree.kind in LEAVES or any(isinstance(part, tuple) for part in tree.parts):  # as of words of unequal parts
            seed = zlib.crc32(repr((tree.kind, tree.parts)).encode())
            return np.random.default_rng(seed).normal(size=len(SCALES)) * SCALES
        inner = np.full(len(SCALES), float(zlib.crc32(tree.kind.encode()) % 1000))
        for place, part in enumerate(tree.parts):  # any function, value by value
            inner += (place + 1.3) * (zlib.crc32(part.encode()) % 1000 if isinstance(part, str) else self.sample(part))
        return np.sin(inner)

    def _relation(self, pair: Tree) -> Any:
        """Return the places of the relations in which the samples of a pair stand."""
        if pair not in self.samples:
            a, b = map(self.sample, pair.parts)
            self.samples[pair] = 4 - 3 * (a < b) - 2 * (a == b) - (a > b)
        return self.samples[pair]

    def _alike(self, a: Tree, b: Tree, facts: Facts) -> Facts | None:
        """Return the facts by which two trees are one operation on equal operands, or None."""
        if a.kind != b.kind or a.kind in CHOICES or len(a.parts) != len(b.parts) or not (a.pairs or b.pairs):
            return None
        for order in (b.parts, b.parts[::-1]) if a.kind in ("add", "mul") else (b.parts,):
            if (found := self._all(self._reason(x, y, facts) for x, y in zip(a.parts, order, strict=True))) is not None:
                return found
        return None

    def _equal_in_cases(self, a: Tree, b: Tree, facts: Facts) -> Facts | None:
        """Compare two trees for each relation of one pair of numbers, itself free of choices."""
        pairs = [pair for pair in a.pairs | b.pairs if not pair.pairs]
        if not pairs:
            return None
        tops = [each.parts[0] for each in (b, a) if each.kind in CHOICES and not each.parts[0].pairs]
        pair = tops[0] if tops else min(pairs, key=lambda each: each.rank)
        cases = [(pair, place) for place in range(1, 5)]
        found = self._all(self._new_case_reason(a, b, case, facts) for case in cases)
        return None if found is None else found.difference(cases)

    def _equal_by_values(self, a: Tree, b: Tree, facts: Facts) -> Facts | None:
        """Compare two trees without choices where numbers in them are known, as those that came of a choice."""
        for case in in_order(facts) if not (a.pairs or b.pairs) else ():
            if self._values(*case)[1] and (self._in_case(a, *case) is not a or self._in_case(b, *case) is not b):
                return self._in_case_reason(a, b, *case, facts)
        return None

    def _new_case_reason(self, a: Tree, b: Tree, case: Fact, facts: Facts) -> Facts | None:
        """Return the facts by which two trees are equal in a new case, or by which there are no such numbers."""
        sources = dict[Fact, Facts]()
        found: Facts | None
        for fact, source in [(case, frozenset({case})), *self._consequences(facts, case)]:
            if fact is None:
                found = source
                break
            sources[fact] = source
            if (found := self.order.contradiction(facts, fact)) is not None:
                break
            facts |= {fact}
        else:
            found = self._in_case_reason(a, b, *case, facts)
        return None if found is None else frozenset().union(*(sources.get(each, {each}) for each in found))

    def _consequences(self, facts: Facts, case: Fact) -> Iterator[tuple[Fact | None, Facts]]:
        """Yield what facts and a new case say by each other, with these two; None stands for a contradiction."""
        others = in_order(facts) if self._values(*case)[1] else ()
        values = (fact for fact in in_order(facts) if self._values(*fact)[1])
        for (pair, place), other in chain(((fact, case) for fact in others), ((case, fact) for fact in values)):
            parts = [self._in_case(part, *other) for part in pair.parts]
            if any(part is not old for part, old in zip(parts, pair.parts, strict=True)):
                found = self.trees.choose(parts[0], parts[1], dict(zip(RELATIONS, range(1, 5), strict=True)))
                places = found.parts if isinstance(found, Tree) else (None, found)
                if place not in places:
                    yield None, frozenset({(pair, place), other})
                elif isinstance(found, Tree):
                    here = place if places[place] == place else places.index(place)
                    yield (found.parts[0], here), frozenset({(pair, place), other})

    def _all(self, reasons: Iterable[Facts | None]) -> Facts | None:
        """Return all facts of reasons, or None if one of these is missing."""
        found: Facts = frozenset()
        for each in reasons:
            if each is None:
                return None
            found |= each
        return found

    def _in_case(self, tree: Any, pair: Tree, place: int) -> Any:
        """Return a tree where a pair of numbers stands in the relation at a place of its choices."""
        done, everywhere = self._values(pair, place)

        def walk(each: Any) -> Any:
            if not isinstance(each, Tree) or not (everywhere or pair in each.pairs):
                return each
            if each.kind in LEAVES:
                return done.get(each, each)
            if each not in done:
                self.rebuilt += 1
                if self.rebuilt > self.bound:
                    raise Declined(f"cases with more than {REBUILT} trees")
                made = each if each.kind in CHOICES and each.parts[0] is pair else self.trees.rebuilt(each, walk)
                chosen = isinstance(made, Tree) and made.kind in CHOICES and made.parts[0] is pair
                done[each] = walk(made.parts[place]) if chosen else made
            return done[each]

        return walk(tree)

    def _values(self, pair: Tree, place: int) -> tuple[dict[Tree, Any], bool]:
        """Return what trees become in a case, and whether it replaces numbers by constants."""
        if (pair, place) not in self.cases:
            known = dict(self._same_bits(pair) if RELATIONS[place - 1] == "equal" else ())
            self.cases[pair, place] = known, bool(known)
        return self.cases[pair, place]

    def _same_bits(self, pair: Tree) -> Iterator[tuple[Tree, Tree]]:
        """Yield a number with the constant whose bits it has if they are equal: zeros may differ in sign."""
        for one, other in (pair.parts, pair.parts[::-1]):
            value = self.trees.value(other)
            if value or (value == 0 and unsigned(one) and not np.signbit(value)):
                yield one, other


def difference(a: Any, b: Any) -> tuple[Any, Any]:
    """Return the first operations that differ in two trees."""
    while isinstance(a, Tree) and isinstance(b, Tree) and a.kind == b.kind:
        parts = [(x, y) for x in a.parts if x not in b.parts for y in b.parts if y not in a.parts]
        if len(parts) != 1 or not all(isinstance(each, Tree) for each in parts[0]):
            break
        a, b = parts[0]
    return a, b
