"""Load a package of kernels from disk under a name of its own; the same text at the same place is compiled once."""

from __future__ import annotations

import importlib
import itertools
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import lru_cache
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

from ...maps.chart import Chart
from ..rows import Table
from .errors import ValidationFailed

NATIVE = "DUALCAY_NATIVE"
"""What switches compiled functions off that may be installed: a package has to answer for itself."""

FILES = 64
"""So many files are kept compiled: all that the modules of a package share."""

_serial = itertools.count()


@contextmanager
def loaded(folder: Path) -> Iterator[str]:
    """Import a folder as a package under a name of its own, so that no other copy answers for it."""
    name = f"_dualcay_validated_{next(_serial)}"
    init = folder / "__init__.py"
    loader = _Loader(name, str(init))
    spec = spec_from_file_location(name, init, loader=loader, submodule_search_locations=[str(folder)])
    if spec is None or not init.is_file():
        raise ValidationFailed(f"{folder} is not a package")
    package = module_from_spec(spec)
    finder = _Finder(name)
    sys.meta_path.insert(0, finder)
    sys.modules[name] = package
    native, os.environ[NATIVE] = os.environ.get(NATIVE), "0"
    try:
        loader.exec_module(package)
        yield name
    finally:
        os.environ.pop(NATIVE)
        os.environ.update({NATIVE: native} if native is not None else {})
        sys.meta_path.remove(finder)
        for loaded in [key for key in sys.modules if key == name or key.startswith(name + ".")]:
            del sys.modules[loaded]


def module_of(package: str, chart: Chart, table: Table) -> ModuleType:
    """The module of a chart that holds the functions of a table."""
    return importlib.import_module(".".join(filter(None, (package, table.name, chart.name))))


class _Loader(SourceFileLoader):
    """Reads the source, whatever bytecode lies beside it, and compiles it unless it has."""

    def get_code(self, fullname: str) -> CodeType:
        path = self.get_filename(fullname)
        return _compiled(self.get_data(path), path)


class _Finder:
    """Finds the modules of one package as Python does, and has them loaded as above."""

    def __init__(self, package: str) -> None:
        self._inside = f"{package}."

    def find_spec(self, name: str, path: Sequence[str] | None, target: Any = None) -> ModuleSpec | None:
        spec = PathFinder.find_spec(name, path, target) if name.startswith(self._inside) else None
        if spec and isinstance(spec.loader, SourceFileLoader):
            spec.loader = _Loader(name, spec.loader.path)
        return spec


@lru_cache(maxsize=FILES)
def _compiled(source: bytes, path: str) -> CodeType:
    code: CodeType = compile(source, path, "exec", dont_inherit=True)
    return code
