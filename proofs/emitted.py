"""Transcripts of emitted programs, by the import and by the interpreter of C that also validate the kernels.

A geometry program is proved for any chart: it runs with opaque scalar programs, which write only their call.
"""

from __future__ import annotations

import importlib
import traceback
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from derive.codegen.build import print_package
from derive.codegen.signatures import PUBLIC
from derive.codegen.targets import TARGETS
from derive.codegen.validation.batches import ValidationFailed
from derive.codegen.validation.c_interpreter import UNSET, CError, Pointer, load
from derive.maps import Cayley
from derive.output import files

from .coq_definitions import GEOMETRY, SCALARS, U, V
from .statements import MachineError
from .transcript import Transcript

REFUSED = (
    ArithmeticError, AttributeError, CError, ImportError, LookupError, NameError, OSError, SyntaxError, TypeError,
    ValidationFailed, ValueError,
)  # fmt: skip
"""Errors of text that is missing, or that is no straight-line program on exact numbers."""


def printed(folder: Path, orders: Iterable[int]) -> Path:
    """Print the C headers of Cayley maps to a folder and return it."""
    files.write(folder, print_package([Cayley(order) for order in orders], TARGETS["c"], tested=False).texts)
    return folder


@contextmanager
def reading(name: str, folder: Path | None = None) -> Iterator[None]:
    """Raise `MachineError` for text that is refused, with the last line that was executed in a folder."""
    try:
        yield
    except REFUSED as error:
        frames = traceback.extract_tb(error.__traceback__)
        lines = [f"{Path(f.filename).name}:{f.lineno}: " for f in frames if Path(f.filename).parent == folder]
        raise MachineError(f"{name}: {''.join(lines[-1:])}{error}") from error


class PythonModule:
    """Module of a chart in a package of kernels, which stays imported while its programs run."""

    def __init__(self, folder: Path, package: str, chart: str) -> None:
        self.folder = folder
        with reading(f"{chart}.py", folder):
            self.module = importlib.import_module(f"{package}.{chart}")
            self.number_functions = importlib.import_module(f"{package}._numbers").Objects

    def geometry(self, name: str) -> Transcript:
        """Return the transcript of a geometry program, called as a user does."""
        with reading(name, self.folder):
            chart = replace(self.module.CHART, functions={each: _called_in_python(each) for each in SCALARS})
            method = getattr(type(self.module.KERNELS)(chart), name)
            kernel = chart.kernels.get(name) or chart.kernels[name.removeprefix("body_")]

            def program(*given: tuple[Any, ...]) -> Any:
                return method(*(np.array(each, object) for each in given)).ravel()

            return Transcript(program, _arguments(name), _place(kernel.plain))

    def scalars(self, name: str) -> Transcript:
        with reading(name, self.folder):
            function = self.module.CHART.functions[name]
            return Transcript(partial(function, self.number_functions), SCALARS[name].parameters, _place(function))


class CHeader:
    """Header of a chart; its geometry programs are those of any chart if its scalar programs are ``opaque``."""

    def __init__(self, path: Path, opaque: bool = False) -> None:
        self.path, self.prefix, self.opaque = path, f"dualcay_{path.stem}_", opaque
        instead = {f"{self.prefix}{each}": _called_in_c(each) for each in SCALARS if opaque}
        with reading(path.name):
            self.unit = load(f'#include "{path.name}"\n', path.parent, instead=instead)

    def geometry(self, name: str) -> Transcript:
        made = self.program(name, _arguments(name), [array.size for array in PUBLIC[name].results])
        if self.opaque and (own := [each for each in self.unit.called if self._place(each).startswith(self.path.name)]):
            raise MachineError(f"{name}: {self._place(own[0])}: {own[0]} is a program of one chart")
        return made

    def scalars(self, name: str) -> Transcript:
        """Return the transcript of a scalar program."""
        return self.program(name, SCALARS[name].parameters, [1] * len(SCALARS[name].results))

    def program(self, name: str, arguments: Sequence[str | tuple[str, ...]], sizes: Sequence[int]) -> Transcript:
        """Return the transcript of a function on numbers and arrays, whose last pointers are results of given sizes."""
        name = f"{self.prefix}{name}"

        def program(*given: Any) -> list[Any]:
            made = [Pointer.to([UNSET] * size) for size in sizes]
            self.unit.call(name, *(Pointer.to([*a]) if isinstance(a, tuple) else a for a in given), *made)
            return [pointer[i] for pointer, size in zip(made, sizes, strict=True) for i in range(size)]

        with reading(self.path.name):
            return Transcript(program, arguments, self._place(name))

    def _place(self, name: str) -> str:
        function = self.unit.functions.get(name)
        return self.unit.translator.places[function.__code__.co_firstlineno - 1] if function else self.path.name


def _arguments(name: str) -> tuple[tuple[str, ...], ...]:
    return (V, U) if GEOMETRY[name].second else (V,)


def _place(function: Any) -> str:
    return f"{Path(function.__code__.co_filename).name}:{function.__code__.co_firstlineno}"


def _called_in_python(name: str) -> Callable[..., Any]:
    """Return the function of kernels that writes the call of a scalar program."""
    return lambda _, *given: given[0].transcript.enter(name, given, len(SCALARS[name].results))


def _called_in_c(name: str) -> Callable[..., None]:
    """Return the function of C that writes the call of a scalar program and sets its results."""
    count = len(SCALARS[name].parameters)

    def called(*given: Any) -> None:
        results = given[0].transcript.enter(name, given[:count], len(SCALARS[name].results))
        for pointer, result in zip(given[count:], results, strict=True):
            pointer[0] = result

    return called
