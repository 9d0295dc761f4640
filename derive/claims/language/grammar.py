"""Grammar: a list of allowed syntax, checked on Python's syntax tree. No part of a text is evaluated.

This module uses the standard library alone, so that a wrong text is refused before SymPy is loaded.
"""

from __future__ import annotations

import ast
import re
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import accumulate
from unicodedata import decomposition

DIGITS_MAX = 30
DECIMAL_EXPONENT_MAX = 20

NUMBER = re.compile(r"(\d+)(?:\.(\d*))?(?:[eE]([+-]?\d+))?|\.(\d+)(?:[eE]([+-]?\d+))?")


@dataclass(frozen=True)
class Grammar:
    """Allowed syntax of a text, with its limits.

    `allowed` returns the parts of a node that are checked next; None refuses the node. Numbers are always allowed.
    `error` makes the exception of a message and a column, counted from 1.
    """

    noun: str
    known: str
    allowed: Callable[[ast.expr], Sequence[ast.expr] | None]
    error: Callable[[str, int], Exception]
    characters_max: int
    parts_max: int
    depth_max: int

    def tree(self, text: str) -> ast.expr:
        """Return the syntax tree of a text, with every node checked; a forbidden part raises an error with its text."""
        if strange := re.search(r"[^ -~]|[#\\]", text):  # comments and line breaks, which Python would pass over
            known = "write ** for a power" if "<super>" in decomposition(strange[0]) else f"known are {self.known}"
            message = f"not understood in {self.noun}: {strange[0]!r} ({known})"
            raise self.error(message, strange.start() + 1)
        if len(text) > self.characters_max:
            raise self.error(f"{self.noun} has {len(text)} characters, and {self.characters_max} are the most", 1)
        opened = accumulate((c in "([{") - (c in ")]}") for c in text)
        if deep := next((i for i, open_ in enumerate(opened) if open_ > self.depth_max), None):
            raise self.error(f"{self.noun} has more than {self.depth_max} brackets in each other", deep + 1)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", SyntaxWarning)  # Python warns about "1if"
                tree = ast.parse(text, mode="eval")
        except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
            column = getattr(error, "offset", None) or 1
            raise self.error(f"{self.noun} is no expression: {text!r}", column) from error
        if (count := sum(1 for _ in ast.walk(tree))) > self.parts_max:
            raise self.error(f"{self.noun} has {count} parts, and {self.parts_max} are the most", 1)
        self._require_allowed(tree.body, text, 0)
        return tree.body

    def _require_allowed(self, node: ast.expr, text: str, depth: int) -> None:
        if depth > self.depth_max:
            message = f"{self.noun} has more than {self.depth_max} brackets in each other"
            raise self.error(message, node.col_offset + 1)
        if isinstance(node, ast.Constant) and not isinstance(node.value, bool | str | bytes | complex):
            self.decimal(node, text)
            return
        parts = self.allowed(node)
        if parts is None:
            raise self.refused(node, text)
        for part in parts:
            self._require_allowed(part, text, depth + 1)

    def decimal(self, node: ast.Constant, text: str) -> tuple[int, int]:
        """Return the digits of a number and its power of ten: 0.1 is (1, −1), exactly a tenth."""
        digits = source(node, text)
        found = NUMBER.fullmatch(digits)
        if found is None:
            raise self.refused(node, text)
        whole, rest, exponent = found[1] or "", found[2] or found[4] or "", int(found[3] or found[5] or 0)
        if len(whole + rest) > DIGITS_MAX or abs(exponent) > DECIMAL_EXPONENT_MAX:
            most = f"at most {DIGITS_MAX} digits, up to 1e{DECIMAL_EXPONENT_MAX}"
            raise self.error(f"numbers in {self.noun} have {most}, given {digits[:60]}", node.col_offset + 1)
        return int(whole + rest or 0), exponent - len(rest)

    def refused(self, node: ast.expr, text: str) -> Exception:
        match node:
            case ast.BinOp(op=ast.BitXor()):
                known = "write ** for a power"
            case ast.BinOp(op=ast.MatMult()):
                known = "write * for a product"
            case ast.Attribute(attr="T"):
                known = "write transpose(…)"
            case _:
                known = f"known are {self.known}"
        message = f"not understood in {self.noun}: {source(node, text)[:60]!r} ({known})"
        return self.error(message, node.col_offset + 1)


def source(node: ast.expr, text: str) -> str:
    """Return the part of the text that a node stands for."""
    return ast.get_source_segment(text, node) or ""
