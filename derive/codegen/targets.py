"""The table of targets: a printer, a template folder and a row each."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..maps import Cayley
from . import c99, infix, inplace, jit
from .files import RefusedError
from .program import Program
from .validation import c_text, compiled, validate


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
        Executes the text of the module of an order in a folder and returns how many calls equal the formula.
    companions : tuple of str
        Further files of every module; ``test_cayley.c`` is ``test_cayley3.c`` of order 3, from the template of its
        name.
    test : callable, optional
        Compiles and runs the tests among them and returns how many calls agree; None where nothing can compile them.
    words : mapping
        Words in which the functions of this target differ from those of another with the same templates.
    """

    name: str
    extension: str
    shared: tuple[str, ...]
    comment: str
    printer: Callable[[Program], Any]
    validate: Callable[[Path, Cayley], int]
    companions: tuple[str, ...] = ()
    test: Callable[[Path, Cayley], int | None] | None = None
    words: Mapping[str, str] = field(default_factory=dict)

    def module_name(self, order: int) -> str:
        """File name of the module of an order."""
        return f"cayley{order}.{self.extension}"

    @property
    def template(self) -> str:
        """Template of a module."""
        return f"{self.name}/cayley.{self.extension}.j2"


def _words(value: str, array_like: str, array: str, options: str, passed: str, passed_alone: str) -> dict[str, str]:
    """Annotation and names of arrays; keyword parameters of a function, and what it passes on of them.

    ``passed_alone`` is what a function passes that returns several arrays.
    """
    return {
        "value": value,
        "array_like": array_like,
        "array": array,
        "options": f"*, axis: int = -1{options}",
        "passed": f"axis{passed}",
        "passed_alone": f"axis{passed_alone}",
    }


def _validate_compiled(folder: Path, cayley: Cayley) -> int:
    """Run the source of a package which wants its compiler even so."""
    try:
        return validate(folder, cayley)
    except ImportError as error:
        raise RefusedError(f"cannot validate what was printed: {error}") from error


_OUT = ", out: Array | None = None"
_NUMPY = ("ArrayLike", "array_like", "ndarray")

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
            words=_words(*_NUMPY, _OUT, ", out", ", None"),
        ),
        Target(
            name="array-api",
            extension="py",
            shared=("__init__.py", "_runtime.py", "_tools.py", "py.typed"),
            comment="#",
            printer=infix.body,
            validate=validate,
            words=_words("Array", "array", "array", "", "", ""),
        ),
        Target(
            name="numba",
            extension="py",
            shared=("__init__.py", "_compiled.py", "_runtime.py", "_tools.py", "py.typed"),
            comment="#",
            printer=jit.parts,
            validate=_validate_compiled,
            words=_words(*_NUMPY, f"{_OUT}, parallel: bool = False", ", out, parallel", ", None, False"),
        ),
        Target(
            name="c",
            extension="h",
            shared=("dualcay.h", "differential.h", "CMakeLists.txt"),
            comment="//",
            printer=c99.function,
            validate=c_text.validate,
            companions=("test_cayley.c",),
            test=compiled.test,
        ),
    )
}
