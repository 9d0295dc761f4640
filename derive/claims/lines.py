"""Lines on which the keys of a TOML file stand, which `tomllib` does not tell.

The text is parsed once more, with marks: a further key, whose value is the line, before each line that may begin with a
key, and after what may be the header of an equation. A mark within a longer string changes that string alone.
"""

from __future__ import annotations

import re
import tomllib
from functools import cached_property
from typing import Any

HEADER = re.compile(r"""^[ \t]*\[\[[ \t]*(["']?)equation\1[ \t]*\]\]""")
KEY = re.compile(r"""^[ \t]*(?:(["'])((?:(?!\1).)*)\1|([\w-]+))[ \t]*=""")


class Lines:
    """Lines of the keys of a TOML text; 0 for one that is not known."""

    def __init__(self, text: str) -> None:
        self.text = text

    @cached_property
    def tables(self) -> dict[str, Any]:
        rows = []
        for number, row in enumerate(self.text.split("\n"), 1):
            if key := KEY.match(row):
                quote = key[1] or '"'
                rows.append(f"{quote} {key[2] or key[3] or ''}{quote} = {number}")
            rows.append(HEADER.sub(rf'\g<0>\n"" = {number}\n', row))
        try:
            return tomllib.loads("\n".join(rows))
        except ValueError:
            return {}

    def of(self, table: Any, *keys: str) -> int:
        """Return the line of the first of some keys that a table has, given by its name or as a whole."""
        given = self.tables.get(table, {}) if isinstance(table, str) else table
        return next((line for key in keys if isinstance(line := given.get(key and f" {key}"), int)), 0)

    def of_equation(self, place: int) -> int:
        """Return the line of the claim of the equation at a place, or else where the equation begins."""
        rows = self.tables.get("equation", [{}] * (place + 1))
        return self.of(rows[place], "claim", "reading", "") or self.of(self.tables, "equation")
