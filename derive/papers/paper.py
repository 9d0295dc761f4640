"""Paper with its entries by section and an inventory of its text."""

from __future__ import annotations

import importlib
from dataclasses import dataclass, replace
from types import ModuleType

from .equation import Equation


@dataclass(frozen=True)
class Paper:
    """Paper whose equations are entries.

    Attributes
    ----------
    slug, short, citation : str
    lost : str
        Characters lost by the extraction of its text.
    package : str
        Name of its package, which contains ``inventory`` and ``sections``.
    sections : tuple of str
        Names of the modules in ``sections``, in the paper's order; each defines ``ENTRIES``.
    doi : str
        Empty for a paper without a DOI.
    """

    slug: str
    short: str
    citation: str
    lost: str
    package: str
    sections: tuple[str, ...]
    doi: str = ""

    def entries(self) -> tuple[Equation, ...]:
        """Return all entries in the paper's order, each with the path of its module."""
        modules = [importlib.import_module(f"{self.package}.sections.{section}") for section in self.sections]
        return tuple(replace(entry, source=_path(module)) for module in modules for entry in module.ENTRIES)

    def inventory(self) -> dict[int, tuple[str, ...] | str]:
        """Return the inventory: each line with its deciding entries, or with the reason why it claims nothing."""
        module = importlib.import_module(f"{self.package}.inventory")
        lines: dict[int, tuple[str, ...] | str] = {}
        for entry in self.entries():
            lines[entry.line] = (*lines.get(entry.line, ()), entry.number)
        for line, numbers in module.CLAIMS.items():
            lines[line] = (*lines.get(line, ()), *numbers.split())
        return lines | {int(line): reason for reason, at in module.REASONS.items() for line in at.split()}


def _path(module: ModuleType) -> str:
    return f"{module.__name__.replace('.', '/')}.py"
