"""Mutants of C text: single errors that a printer or a template could make.

Changes are made in preprocessed text, function by function. A mutant contains only the functions that its kernel
calls, so that it compiles in milliseconds.
"""

from __future__ import annotations

import random
import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass

KINDS: Mapping[str, tuple[str, str | None]] = {
    "sign": (r" \+ (?=[\w(])", " - "),
    "sign back": (r" - (?=[\w(])", " + "),
    "negation": (r"= -(?=\w)", "= "),
    "coefficient": (r"(?<![\w.\[])([2-9]|[1-9]\d+)(?= \*| -|\)|;)(?! \* \w+_by\])", None),
    "division": (r" / ", " * "),
    "product": (r"(?<=\w) \* (?=\w+[ ;)])", " / "),
    "component": (r"(?<=[a-z])([12])(?=[ ;),o])", None),
    "part": (r"(?<=\d)o\b", ""),
    "index": (r"_at\[(\d+) \* ", None),
    "first index": (r"_at\[0\]", "_at[1]"),
    "stride": (r"\* \w+_by\]", "* 1]"),
    "row": (r"(?<=\w) \+ j\b", ""),
    "row stride": (r", (\w+)_stride(?=[,)])", r", \1_stride + 1"),
    "output order": (r"(_at\[[^\]]+\] = )([^;]+)(;\s+\w+_at\[[^\]]+\] = )(?!\2;)([^;]+);", r"\1\4\3\2;"),
    "result order": (r"&(\w+), &(\w+)", r"&\2, &\1"),
    "stored result": (r"(\*\w+_at = )([^;]+)(;\s+\*\w+_at = )([^;]+);", r"\1\4\3\2;"),
    "side": (r", (\(\w+\))-(\d)", r", \1\2"),
    "early store": (r"(\n    const \w+ \w+ = \w+_at\[[^;]+;)([\s\S]*)(\n    \w+_at\[0\] = [^;]+;)(?=\n.*_at)", None),
    "comparison": (r" < ", " > "),
    "equality": (r" == ", " < "),
    "logic": (r" & ", " | "),
    "choice": (r"\? ([^:;?]+?) : ((?:\(\w+\))?[^:;]+?)(?=[;)])", r"? \2 : \1"),
    "call": (r"\bsqrt\(", "("),
    "digit": (r"\b0\.\d{20}(\d)", None),
}  # fmt: skip
"""Pattern and replacement by kind of mutant; without a replacement, a number found is increased by one."""

_DEFINITION = re.compile(r"^static inline [\w ]*?\b(\w+)\([^{;]*\)\s*\{[\s\S]*?^\}$", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class Mutant:
    """Text of a kernel and the functions it calls, with one change in the function named ``function``."""

    kind: str
    function: str
    line: str
    text: str


class Excerpts:
    """Functions of a preprocessed text, and the calls between them."""

    def __init__(self, preprocessed: str) -> None:
        text = re.sub(r"^#.*$", "", preprocessed, flags=re.MULTILINE)
        self.functions = {found.group(1): found.group() for found in _DEFINITION.finditer(text)}
        self.called = {name: self.functions.keys() & re.findall(r"\w+", f) for name, f in self.functions.items()}
        self.rest = _DEFINITION.sub("", text)

    def needed(self, name: str) -> set[str]:
        """Return the names of a function and of all functions it calls, directly or not."""
        found, new = set(), {name}
        while new:
            found |= new
            new = set().union(*(self.called[function] for function in new)) - found
        return found

    def text(self, roots: Collection[str], changed: Mapping[str, str]) -> str:
        """Return the text of some functions and of the functions they call; changed functions replace the originals."""
        needed = set().union(*map(self.needed, roots))
        return "\n".join([self.rest, *(changed.get(n, f) for n, f in self.functions.items() if n in needed)])

    def mutants(self, name: str, roots: Collection[str]) -> Iterator[Mutant]:
        """Yield every mutant of a function, as text with the root functions that call it."""
        original = self.functions[name]
        body = original.index("{")
        for kind, (pattern, replacement) in KINDS.items():
            for found in re.compile(pattern).finditer(original, body):
                new = found.expand(replacement) if replacement is not None else _next(found)
                changed = original[: found.start()] + new + original[found.end() :]
                line = changed[changed.rfind("\n", 0, found.start()) + 1 :].partition("\n")[0]
                yield Mutant(kind, name, line.strip(), self.text(roots, {name: changed}))


def _next(found: re.Match[str]) -> str:
    number = found.group(1)
    if not number.isdigit():
        load, between, store = found.groups()  # a result is stored before the last component is loaded
        return between + store + load
    start = found.start(1) - found.start()
    return found.group()[:start] + str((int(number) + 1) % 10 if len(number) == 1 else int(number) + 1) + (
        found.group()[start + len(number) :]
    )


def sample(mutants: Collection[Mutant], each: int, seed: int) -> list[Mutant]:
    """Draw at most ``each`` mutants of every kind."""
    draw = random.Random(seed)
    by_kind: dict[str, list[Mutant]] = {}
    for mutant in mutants:
        by_kind.setdefault(mutant.kind, []).append(mutant)
    return [mutant for found in by_kind.values() for mutant in draw.sample(found, min(each, len(found)))]
