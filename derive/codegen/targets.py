"""The table of targets: a printer, a template folder and a row each."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..maps import Cayley
from ..output import RefusedError
from . import c99, infix, inplace, jit
from .docstrings import docstrings
from .program import Program
from .signatures import SIGNATURES
from .validation import compiled, validate


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
        Files every package of the target holds, each from the template of its name; first the one that whoever uses
        the package loads first.
    comment : str
        What begins a comment line.
    printer : callable
        What the template shows of a program.
    validate : callable
        Executes the module of an order in a folder and returns how many calls equal the formula; None where nothing
        can execute it.
    companions : tuple of str
        Further files of every module; ``test_cayley.c`` is ``test_cayley3.c`` of order 3, from the template of its
        name.
    words : callable
        What the templates of this target ask for besides what all targets show.
    """

    name: str
    extension: str
    shared: tuple[str, ...]
    comment: str
    printer: Callable[[Program], Any]
    validate: Callable[[Path, Cayley], int | None]
    words: Callable[[Cayley], Mapping[str, Any]]
    companions: tuple[str, ...] = ()

    def module_name(self, order: int) -> str:
        """File name of the module of an order."""
        return f"cayley{order}.{self.extension}"

    @property
    def entry(self) -> str:
        """The file that whoever uses a package loads first."""
        return self.shared[0]

    @property
    def template(self) -> str:
        """Template of a module."""
        return f"{self.name}/cayley.{self.extension}.j2"


def _python(
    value: str, array_like: str, array: str, options: str, passed: str, passed_alone: str
) -> Callable[[Cayley], Mapping[str, Any]]:
    """Annotation and names of arrays; keyword parameters of a function, and what it passes on of them.

    ``passed_alone`` is what a function passes that returns several arrays.
    """
    words = {
        "value": value,
        "array_like": array_like,
        "array": array,
        "options": f"*, axis: int = -1{options}",
        "passed": f"axis{passed}",
        "passed_alone": f"axis{passed_alone}",
    }
    return lambda cayley: words | docstrings(cayley)


def _prototypes(cayley: Cayley) -> Mapping[str, Any]:
    return {"signatures": SIGNATURES}


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
            words=_python(*_NUMPY, _OUT, ", out", ", None"),
        ),
        Target(
            name="array-api",
            extension="py",
            shared=("__init__.py", "_runtime.py", "_tools.py", "py.typed"),
            comment="#",
            printer=infix.body,
            validate=validate,
            words=_python("Array", "array", "array", "", "", ""),
        ),
        Target(
            name="numba",
            extension="py",
            shared=("__init__.py", "_compiled.py", "_runtime.py", "_tools.py", "py.typed"),
            comment="#",
            printer=jit.parts,
            validate=_validate_compiled,
            words=_python(*_NUMPY, f"{_OUT}, parallel: bool = False", ", out, parallel", ", None, False"),
        ),
        Target(
            name="c",
            extension="h",
            shared=("dualcay.h", "differential.h", "CMakeLists.txt"),
            comment="//",
            printer=c99.function,
            validate=compiled.validate,
            words=_prototypes,
            companions=("test_cayley.c",),
        ),
    )
}
