"""Packages of every other Python target, generated once for each process that runs tests."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Iterator
from types import ModuleType

import pytest

from derive.codegen import generate

ORDERS = (1, 2, 3, 4, 8)


@pytest.fixture(scope="session")
def package(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[[str], str]]:
    """The import name of the package of a target."""
    root = tmp_path_factory.mktemp("targets")
    sys.path.insert(0, str(root))
    made: set[str] = set()

    def name(target: str) -> str:
        folder = f"generated_{target.replace('-', '_')}"
        if folder not in made:
            generate(ORDERS, target, root / folder)
            importlib.invalidate_caches()
            made.add(folder)
        return folder

    yield name
    sys.path.remove(str(root))


@pytest.fixture(scope="session")
def array_api(package: Callable[[str], str]) -> Callable[[int], ModuleType]:
    """The module of an order of the array-api target."""
    return lambda order: importlib.import_module(f"{package('array-api')}.cayley{order}")


@pytest.fixture(scope="session")
def compiled(package: Callable[[str], str]) -> Callable[[int], ModuleType]:
    """The module of an order of the numba target."""
    return lambda order: importlib.import_module(f"{package('numba')}.cayley{order}")
