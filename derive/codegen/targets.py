"""The table of targets: a printer, a template folder and a row each."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..maps import Cayley
from . import infix, inplace, jit
from .program import Program
from .validation import validate


@dataclass(frozen=True, slots=True)
class Target:
    """A language kernels are printed in.

    Parameters
    ----------
    name : str
        Also its template folder.
    extension : str
        Of a module's file; its template is ``<name>/cayley.<extension>.j2``.
    shared : tuple of str
        Files every package of the target holds, each from the template of its name.
    comment : str
        What begins a comment line.
    printer : callable
        What the template shows of a program.
    validate : callable
        Executes the module of an order in a folder and returns how many calls equal the formula.
    """

    name: str
    extension: str
    shared: tuple[str, ...]
    comment: str
    printer: Callable[[Program], Any]
    validate: Callable[[Path, Cayley], int]

    def module_name(self, order: int) -> str:
        """File name of the module of an order."""
        return f"cayley{order}.{self.extension}"

    @property
    def template(self) -> str:
        """Template of a module."""
        return f"{self.name}/cayley.{self.extension}.j2"


TARGETS: Mapping[str, Target] = {
    target.name: target
    for target in (
        Target(
            name="numpy",
            extension="py",
            shared=("__init__.py", "_kernel.py", "_runtime.py", "_selection.py", "_tools.py", "py.typed"),
            comment="#",
            printer=inplace.two_forms,
            validate=validate,
        ),
        Target(
            name="array-api",
            extension="py",
            shared=("__init__.py", "_runtime.py", "_tools.py", "py.typed"),
            comment="#",
            printer=infix.body,
            validate=validate,
        ),
        Target(
            name="numba",
            extension="py",
            shared=("__init__.py", "_compiled.py", "_runtime.py", "_tools.py", "py.typed"),
            comment="#",
            printer=jit.parts,
            validate=validate,
        ),
    )
}
