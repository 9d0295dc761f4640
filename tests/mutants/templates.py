"""Mutants of templates: one token changed outside of comments, docstrings and the plain text of pages."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import PurePath

from .mutant import Mutant
from .python import Edit, short

TOKENS: Mapping[str, str] = {
    "arithmetic operation": r"(?<=\w|\)|\]| ) ([-+*/]) (?=\S)",
    "comparison": r" (<=|>=|==|!=|<|>) ",
    "and, or, not, truth": r"\b(and|or|not(?= )|is not|is(?! not)|True|False|true|false)\b|(&&|\|\||!(?!=))",
    "constant ± 1": r"(?<![\w.#])(\d+)(?![\w.])",
    "sibling function": r"(?<![\w])(min|max|any|all|sin|cos|less|equal|floor|ceil)(?=\()",
    "sign": r"(?:[(\[,=] ?|return )(-)(?=[\w(])",
}
REPLACED: Mapping[str, tuple[str, ...]] = {
    "+": ("-",), "-": ("+",), "*": ("+",), "/": ("*",), "<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="),
    ">=": (">", "<"), "==": ("!=",), "!=": ("==",), "and": ("or",), "or": ("and",), "not": ("",), "is": ("is not",),
    "is not": ("is",), "True": ("False",), "False": ("True",), "true": ("false",), "false": ("true",), "&&": ("||",),
    "||": ("&&",), "!": ("",), "min": ("max",), "max": ("min",), "any": ("all",), "all": ("any",), "sin": ("cos",),
    "cos": ("sin",), "less": ("equal",), "equal": ("less",), "floor": ("ceil",), "ceil": ("floor",),
}  # fmt: skip

ARGUMENTS = re.compile(r"\(([\w.]+), ([\w.]+)(?=[,)])")
CONDITION = re.compile(r"(?<=\{% if )(.+?)(?= %\})|(?<=\bif )([^:{}%]+?)(?=:\n)")
HOLE = re.compile(r"(?<!: )(?<!-> )\{\{ .+? \}\}")
STATEMENT = re.compile(
    r"^[ \t]+(?![ \t]|\{%|[)\]}{@\"'#*]|r\"|//|(?:def|class|else|elif|if|for|while|try|except|with)\b)"
    r"([^\n]*[^\s:,({\[\\])$",
    re.M,
)

CODE = (".py", ".h", ".c", ".txt")
"""What is executed, but for comments and docstrings; of other files only what the template engine computes."""

PROSE: Mapping[str, str] = {
    ".py": r'r?"""[\s\S]*?"""|(?:^|(?<=\s))#.*$',
    ".h": r"//.*$|/\*[\s\S]*?\*/",
    ".c": r"//.*$|/\*[\s\S]*?\*/",
    ".txt": r"#.*$",
}
"""What says nothing that is executed."""

QUOTED = re.compile(r'"[^"\n]*"|(?<=raise )[^\n]*')
"""Messages and names: words in them are no operators."""

WORDS = ("and, or, not, truth", "arithmetic operation", "comparison", "sign")


def template_mutants(path: str, source: str) -> Iterator[Mutant]:
    """All mutants of a template, in the order of its text."""
    for start, end, operator, after in sorted(set(_changes(source))):
        if not _is_silent(path, source, operator, start, end):
            line = source.count("\n", 0, start) + 1
            edit = Edit(path, len(source[:start].encode()), len(source[:end].encode()), after, (0, 0))
            yield Mutant(path, line, operator, _shown(source, start, end, after), edit)


def _is_silent(path: str, source: str, operator: str, start: int, end: int) -> bool:
    """Whether a place is in a comment, a docstring, a message, or the text of a page."""
    kind = PurePath(path.removesuffix(".j2")).suffix
    prose = r"\{#[\s\S]*?#\}" + (f"|{PROSE[kind]}" if kind in PROSE else "")
    if _within(re.compile(prose, re.M), source, start, end):
        return True
    if kind not in CODE and (operator == "statement dropped" or not _within(_ENGINE, source, start, end)):
        return True
    return operator in WORDS and _within(QUOTED, source, start, end)


_ENGINE = re.compile(r"\{\{.*?\}\}|\{%.*?%\}")


def _within(pattern: re.Pattern[str], source: str, start: int, end: int) -> bool:
    return any(match.start() <= start and end <= match.end() for match in pattern.finditer(source))


def _changes(source: str) -> Iterator[tuple[int, int, str, str]]:
    for operator, pattern in TOKENS.items():
        for match in re.finditer(pattern, source):
            group = next(i for i in range(1, len(match.groups()) + 1) if match.group(i) is not None)
            for after in _replacements(operator, match.group(group)):
                yield *match.span(group), operator, after
    for match in ARGUMENTS.finditer(source):
        if match.group(1) != match.group(2):
            yield match.start(1), match.end(2), "arguments swapped", f"{match.group(2)}, {match.group(1)}"
    for match in CONDITION.finditer(source):
        yield *match.span(), "condition negated", f"not ({match.group(0)})"
    for match in HOLE.finditer(source):
        yield *match.span(), "hole dropped", ""
    for match in STATEMENT.finditer(source):
        line = match.group(1)
        if all(line.count(a) == line.count(b) for a, b in ("()", "[]", "{}")) and line.count('"') % 2 == 0:
            yield *match.span(1), "statement dropped", "" if line.endswith((";", "\\")) else "pass"


def _replacements(operator: str, token: str) -> tuple[str, ...]:
    if operator == "constant ± 1":
        return (str(int(token) + 1), str(int(token) - 1))
    return ("",) if operator == "sign" else REPLACED[token]


def _shown(source: str, start: int, end: int, after: str) -> str:
    """A token with some of its line around it, so that a reader sees which one."""
    head, tail = source.rfind("\n", 0, start) + 1, source.find("\n", end)
    left = source[max(head, start - 25) : start].lstrip()
    right = source[end : min(tail if tail >= 0 else len(source), end + 25)].rstrip()
    return f"{left}⟦{short(source[start:end])} → {short(after)}⟧{right}"
