"""Fixtures: one package of each target except NumPy."""

from __future__ import annotations

import functools
import importlib
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType

import pytest

from tests.support import packages


@pytest.fixture(scope="session")
def folder(shared: Callable[[str, Callable[[Path], object]], Path]) -> Callable[[str], Path]:
    """Provide a function that returns the folder of a target's package; the package has the folder's name."""

    def made(target: str) -> Path:
        name = f"generated_{target.replace('-', '_')}"
        charts = packages.ORDERS[target], target
        return shared(name, lambda place: packages.write(*charts, place, packages.FAMILIES[target]))

    return made


@pytest.fixture(scope="session")
def package(folder: Callable[[str], Path], tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[[str], str]]:
    """Provide a function that returns the import name of a target's package.

    Each process has its own Numba cache. In a shared cache, a loop and the function around it may come from different
    processes, and crash the next process that loads them.
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("numba.config.CACHE_DIR", str(tmp_path_factory.mktemp("numba")))

        @functools.cache
        def name(target: str) -> str:
            patch.syspath_prepend(str(folder(target).parent))
            return folder(target).name

        yield name


@pytest.fixture(scope="session")
def array_api(package: Callable[[str], str]) -> Callable[[int], ModuleType]:
    """Provide a function that returns the array-api module of an order."""
    return lambda order: importlib.import_module(f"{package('array-api')}.cayley{order}")


@pytest.fixture(scope="session")
def charts(package: Callable[[str], str]) -> Callable[[str], ModuleType]:
    """Provide a function that returns the array-api module of a chart, by its name after that of the package."""
    return lambda name: importlib.import_module(f"{package('array-api')}.{name}")


@pytest.fixture(scope="session")
def compiled(package: Callable[[str], str]) -> Callable[[int], ModuleType]:
    """Provide a function that returns the Numba module of an order."""
    return lambda order: importlib.import_module(f"{package('numba')}.cayley{order}")


@pytest.fixture(scope="session")
def headers(shared: Callable[[str, Callable[[Path], object]], Path]) -> Path:
    """Return the folder of C headers of some charts."""
    return shared("c_headers", packages.headers)
