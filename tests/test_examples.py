"""Examples in docstrings: every public function has one, and all of them run."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from collections.abc import Iterator
from types import FunctionType, MethodType
from typing import Any

import numpy as np
import pytest

import derive
import dualcay
from derive.maps import IsotropicMap, QuaternionMap
from tests.support import examples


def modules(package: Any) -> Iterator[Any]:
    """Yield the package and its public modules."""
    yield package
    for found in pkgutil.walk_packages(package.__path__, package.__name__ + "."):
        if not found.name.rpartition(".")[2].startswith("_"):
            yield importlib.import_module(found.name)


def functions(module: Any) -> Iterator[FunctionType]:
    """Yield the functions that a module exports; a module of a chart exports bound methods."""
    for name in getattr(module, "__all__", dir(module)):
        value = getattr(module, name)
        own = value.__func__ if isinstance(value, MethodType) else value
        if not name.startswith("_") and isinstance(own, FunctionType) and own.__module__.startswith("dualcay"):
            yield own


def methods(kind: type) -> Iterator[Any]:
    """Return the public functions of a class."""
    return (value for name, value in inspect.getmembers(kind, inspect.isfunction) if not name.startswith("_"))


@pytest.mark.smoke
def test_kernels():
    found = {function.__qualname__: function for module in modules(dualcay) for function in functions(module)}
    assert len(found) > 50
    for package in ("dualcay", "dualcay.rotation"):
        known = {"np": np, "cayley2": importlib.import_module(f"{package}.cayley2")}
        own = [function for function in found.values() if function.__module__ == f"{package}._interface"]
        assert len(own) > 50
        assert examples.of_docstrings(own, known) == ""
    others = [function for function in found.values() if not function.__module__.endswith("._interface")]
    assert examples.of_docstrings(others) == ""


def test_toolkit():
    # `generate` takes seconds: tests/derive/test_shown.py runs its example and checks the result
    front = [getattr(derive, name) for name in derive.__all__ if name != "generate"]
    found = [one for one in front if callable(one) and one is not derive.alpha and one is not derive.x]
    kinds = (IsotropicMap, QuaternionMap)
    found += [derive.Cayley.prove, type(derive.family("lambert")).prove, *(m for kind in kinds for m in methods(kind))]
    assert len(found) > 8
    assert examples.of_docstrings(found) == ""


def test_wrong_and_missing_examples_are_reported():
    def wrong() -> None:
        """Add.

        >>> 1 + 1
        3
        """

    def bare() -> None:
        """No example."""

    said = examples.of_docstrings([wrong, bare])
    assert "Expected:\n    3\nGot:\n    2" in said
    assert "bare has no example" in said
