"""Packages of every other target, each generated once."""

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
    """The folder of the package of a target; its name is that of the package."""

    def made(target: str) -> Path:
        name = f"generated_{target.replace('-', '_')}"
        return shared(name, lambda place: packages.write(packages.ORDERS[target], target, place))

    return made


@pytest.fixture(scope="session")
def package(
    folder: Callable[[str], Path], tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Callable[[str], str]]:
    """The import name of the package of a target.

    Each process has its own cache of Numba. In a shared cache, a loop and the function around it may come from
    different processes, and crash the next process that loads them.
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
    """The module of an order of the array-api target."""
    return lambda order: importlib.import_module(f"{package('array-api')}.cayley{order}")


@pytest.fixture(scope="session")
def compiled(package: Callable[[str], str]) -> Callable[[int], ModuleType]:
    """The module of an order of the numba target."""
    return lambda order: importlib.import_module(f"{package('numba')}.cayley{order}")
