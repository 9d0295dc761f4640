"""Drafts: files of claims with every displayed equation of a document, and a claim where its LaTeX is surely read."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from ..output.shown import one_line, seen
from .documents import content
from .documents.comments import OF_AN_EQUATION
from .language.names import Scope, latex_of
from .proposal import NotReadError, Spellings, proposed, spellings, ways
from .sheet import Problem, Reader

HEADING = """# Draft from {name}.
# A claim with "proposed = true" was read from its LaTeX: compare both, then delete that line.
# An equation without a claim is unread. Kinds of letters: see the reference of claims.
"""


def draft(path: str | Path, letters: Mapping[str, str]) -> tuple[str, list[Problem]]:
    """Return the file of claims of a document, with further letters by kind, and what cannot be read in it."""
    tables, wrong = content(path)
    reader = Reader(str(path))
    for where, error in wrong:
        reader.problem(where, error)
    kinds, definitions = {**tables["letters"], **letters}, tables["definitions"]
    plain = reader.scope(kinds, definitions, {})
    known = spellings(plain)
    printed = ways((row["latex"] for row in tables["equation"]), known)
    only = {name: known[next(iter(way))][1] for name, way in printed.items() if len(way) == 1}
    known = known.only(printed)
    scope = Reader(str(path)).scope(kinds, definitions, only)
    usual = {name: str(symbol.args[2]) for name, (symbol, _) in plain.letters.items()}
    own = {name: shown for name, shown in only.items() if usual.get(name, latex_of(name)) != shown}
    parts = [HEADING.format(name=one_line(Path(path).name)), _table("paper", {"slug": Path(path).stem})]
    parts += [_table(*part) for part in (("letters", kinds), ("definitions", definitions), ("latex", own)) if part[1]]
    for row in tables["equation"]:
        parts.append("\n".join(("[[equation]]", *_rows(row, scope, known), "")))
    return "\n".join(parts), reader.problems


def _rows(row: Mapping[str, str], scope: Scope, known: Spellings) -> Iterator[str]:
    for key in ("number", "at", "latex"):
        yield f"{key} = {quoted(row[key])}"
    if "claim" not in row:
        try:
            yield f"claim = {quoted(proposed(row['latex'], scope, known))}"
            yield "proposed = true"
        except NotReadError as error:
            yield f'claim = ""  # not understood: {one_line(str(error))}'
    for key in OF_AN_EQUATION:
        if key in row:
            yield f"{key} = {quoted(row[key])}"


def _table(name: str, rows: Mapping[str, str]) -> str:
    return "\n".join((f"[{name}]", *(f"{_key(key)} = {quoted(text)}" for key, text in rows.items()), ""))


def _key(name: str) -> str:
    return name if name.isidentifier() and name.isascii() else quoted(name)


def quoted(text: str) -> str:
    """Return a text as TOML: as it is between single quotes if these can hold it and all of it is seen."""
    flat = re.sub(r"\s*\n\s*", " ", text).encode(errors="replace").decode()
    if flat == seen(flat) and "'" not in flat:
        return f"'{flat}'"
    signs = json.dumps(flat, ensure_ascii=False)
    return "".join(sign if sign == seen(sign) else rf"\u{ord(sign):04x}" for sign in signs)
