"""Kernel modules on their way to files, and packages of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from ..proof import Proved

Counts = tuple[int, int, int | None]
"""Calls validated, replayed and tested."""


@dataclass(frozen=True, slots=True)
class Module:
    """A kernel module on its way: proved, printed, and how many calls of it were compared with its formula.

    ``companions`` are further files by name. ``replayed`` counts the calls on floats that agree, ``tested`` those of
    compiled code: 0 where the target has none of its own, None where nothing could compile it. A module that is only
    to be compared with what is on disk is not executed, and all of them are 0.
    """

    name: str
    proved: Proved
    text: str
    companions: dict[str, str]
    validated: int = 0
    replayed: int = 0
    tested: int | None = 0

    @property
    def texts(self) -> dict[str, str]:
        """Its files by name."""
        return self.companions | {self.name: self.text}

    def counted(self, counts: Counts) -> Module:
        """The same module, executed."""
        validated, replayed, tested = counts
        return replace(self, validated=validated, replayed=replayed, tested=tested)

    def __repr__(self) -> str:
        return f"<Module {self.name}: {len(self.proved.proofs)} proofs, {self.validated} calls validated>"


@dataclass(frozen=True, slots=True)
class Package:
    """All files of a package of kernels, by name, and the modules among them."""

    texts: dict[str, str]
    modules: tuple[Module, ...]

    @classmethod
    def of(cls, shared: Mapping[str, str], modules: Sequence[Module]) -> Package:
        """Of the files that modules share, and of theirs."""
        texts = dict(shared)
        for module in modules:
            texts |= module.texts
        return cls(texts, tuple(modules))

    def __repr__(self) -> str:
        return f"<Package of {', '.join(module.name for module in self.modules)}: {len(self.texts)} files>"
