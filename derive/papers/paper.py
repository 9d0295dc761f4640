"""Paper with its entries by section and an inventory of its text."""

from __future__ import annotations

import importlib
from dataclasses import dataclass, replace

from .equation import Equation


@dataclass(frozen=True)
class Paper:
    """Paper whose equations are entries."""

    slug: str
    short: str
    citation: str
    lost: str  # characters lost by the extraction of its text
    package: str  # name of its package, which contains ``inventory`` and ``sections``
    sections: tuple[str, ...]  # modules in ``sections``, in the paper's order; each defines ``ENTRIES``
    doi: str = ""

    def entries(self) -> tuple[Equation, ...]:
        """Return all entries in the paper's order, each with the path of its module."""
        found: list[Equation] = []
        for section in self.sections:
            name = f"{self.package}.sections.{section}"
            source = f"{name.replace('.', '/')}.py"
            found += [replace(entry, source=source) for entry in importlib.import_module(name).ENTRIES]
        return tuple(found)

    def inventory(self) -> dict[int, tuple[str, ...] | str]:
        """Return the inventory: each line with its deciding entries, or with the reason why it claims nothing."""
        module = importlib.import_module(f"{self.package}.inventory")
        lines: dict[int, tuple[str, ...] | str] = {}
        for entry in self.entries():
            lines[entry.line] = (*lines.get(entry.line, ()), entry.number)
        for line, numbers in module.CLAIMS.items():
            lines[line] = (*lines.get(line, ()), *numbers.split())
        return lines | {int(line): reason for reason, at in module.REASONS.items() for line in at.split()}
