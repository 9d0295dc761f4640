"""Paper whose formulas stand in modules of a package beside this file, and whose words stand in its ``text.toml``."""

from __future__ import annotations

import importlib
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from ..claims.equation import Entry, Home, Paper


@dataclass(frozen=True)
class Package(Paper):
    """Paper of a package: `words` has the fields of its entries by number."""

    name: str = ""
    home: Home | None = None
    words: Mapping[str, Mapping[str, Any]] = field(default_factory=dict, repr=False)

    @staticmethod
    def read(name: str, home: Home) -> Package:
        """Return the paper of a package; `home` finds its entries again."""
        data = tomllib.loads((Path(__file__).parent / name / "text.toml").read_text(encoding="utf-8"))
        words = {row["number"]: row for row in data["equation"]}
        claims = {int(line): numbers for line, numbers in data["claims"].items()}
        return Package(**data["paper"], claims=claims, reasons=data["reasons"], name=name, home=home, words=words)

    @property
    def sections(self) -> tuple[str, ...]:
        """Modules in ``sections`` that define ``ENTRIES``, in the paper's order."""
        return tuple(sorted(path.stem for path in (Path(__file__).parent / self.name / "sections").glob("s[0-9]*.py")))

    def entries(self) -> tuple[Entry, ...]:
        """Return all entries in the paper's order, each with its words and the path of its module."""
        found: list[Entry] = []
        for section in self.sections:
            module = f"{__package__}.{self.name}.sections.{section}"
            source = f"{module.replace('.', '/')}.py"
            entries = importlib.import_module(module).ENTRIES
            found += [replace(e, source=source, home=self.home, **self.words[e.number]) for e in entries]
        return tuple(found)
