"""Load a package of kernels from disk under a unique name; equal text at an equal path is compiled once."""

from __future__ import annotations

import importlib.util
import itertools
import os
import sys
from collections.abc import Iterator, MutableMapping, Sequence
from contextlib import contextmanager
from functools import lru_cache
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

from ...maps.chart import Chart
from ..rows import Table
from .batches import ValidationFailed

NATIVE = "DUALCAY_NATIVE"
"""Environment variable that switches off installed compiled functions, so that the Python kernels themselves run."""

_serial = itertools.count()


@contextmanager
def replaced(place: MutableMapping[str, Any], name: str, value: Any) -> Iterator[None]:
    """Replace an entry, and restore it afterwards; ``unittest.mock`` would load a library of networks."""
    before = {name: place[name]} if name in place else {}
    place[name] = value
    try:
        yield
    finally:
        del place[name]
        place.update(before)


@contextmanager
def loaded(folder: Path) -> Iterator[str]:
    """Import a folder as a package under a unique name, and remove its modules afterwards."""
    if not (folder / "__init__.py").is_file():
        raise ValidationFailed(f"{folder} is not a package")
    name = f"_dualcay_validated_{next(_serial)}"
    finder = _Finder(name, folder)
    sys.meta_path.insert(0, finder)
    try:
        with replaced(os.environ, NATIVE, "0"):
            importlib.import_module(name)
            yield name
    finally:
        sys.meta_path.remove(finder)
        for module in [key for key in sys.modules if key == name or key.startswith(f"{name}.")]:
            del sys.modules[module]


def module_of(package: str, chart: Chart, table: Table) -> ModuleType:
    """Return the module of a chart that holds the functions of a table."""
    return importlib.import_module(".".join(filter(None, (package, table.name, chart.name))))


class _Loader(SourceFileLoader):
    """Loader that ignores cached bytecode and compiles each source text once."""

    def get_code(self, fullname: str) -> CodeType:
        path = self.get_filename(fullname)
        return _compiled(self.get_data(path), path)


class _Finder:
    """Finder of one package in a folder; modules of the package are found as usual, but compiled once."""

    def __init__(self, package: str, folder: Path) -> None:
        self._package, self._folder = package, folder

    def find_spec(self, name: str, path: Sequence[str] | None, target: Any = None) -> ModuleSpec | None:
        if name == self._package:
            file, inside = str(self._folder / "__init__.py"), [str(self._folder)]
            loader = _Loader(name, file)
            return importlib.util.spec_from_file_location(name, file, loader=loader, submodule_search_locations=inside)
        spec = PathFinder.find_spec(name, path, target) if name.startswith(f"{self._package}.") else None
        if spec and isinstance(spec.loader, SourceFileLoader):
            spec.loader = _Loader(name, spec.loader.path)
        return spec


@lru_cache(maxsize=64)  # enough for the modules that charts of a package share
def _compiled(source: bytes, path: str) -> CodeType:
    code: CodeType = compile(source, path, "exec", dont_inherit=True)
    return code
