"""Kernels under test: their orders, and functions that load them."""

from __future__ import annotations

import importlib
import importlib.util
import os
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import dualcay
from tests.support import packages

ORDERS = (1, 2, 3, 4, 5, 8)

LAWS = (1, 2, 3)
"""Orders that laws are tried with: geometry is one text, and only orders 1 and 2 have further rules of choice."""

ALIKE = (5,)
"""Order that stands for all orders in tests of arrays, because call conventions do not depend on the chart, and
generation replays every module."""

BACKENDS = {"native", "numpy"} if os.environ.get("DUALCAY_NATIVE") == "1" else {"numpy"}
"""Backends that run the committed charts in these tests; compiled functions run only with DUALCAY_NATIVE=1."""


def orders(chosen: Iterable[int]) -> Any:
    """Return a parametrized fixture ``order`` with these values."""
    return pytest.fixture(params=chosen, ids=lambda n: f"n={n}", name="order")(lambda request: int(request.param))


def load(order: int, folder: Path | None = None, table: str = "") -> ModuleType:
    """Return the kernel module of an order: a committed one, or one for poses from a folder that `write` filled."""
    name = ".".join(part for part in ("dualcay", table, f"cayley{order}") if part)
    if order in ORDERS:
        return importlib.import_module(name)
    if name not in sys.modules:
        if folder is None:
            raise ModuleNotFoundError(f"{name} is not committed")
        # The module is loaded as a member of the committed package, because all orders share its runtime.
        spec = importlib.util.spec_from_file_location(name, folder / f"cayley{order}.py")
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules[name] = module
        spec.loader.exec_module(module)
    return sys.modules[name]


def write(orders: Iterable[int], folder: Path) -> None:
    """Derive, prove and write the kernels of orders that are not committed."""
    missing = sorted(set(orders) - set(ORDERS))
    if missing:
        packages.write(missing, "numpy", folder)


CALL = """
import dualcay, numpy
dualcay.cayley3.pose(numpy.zeros(6))
dualcay.rotation.cayley3.tensor(numpy.zeros(3))
print({runs for kind in (dualcay, dualcay.rotation) for runs in kind.backend().values()})
"""


def said(site: Path, **environment: str) -> tuple[str, str]:
    """Return the output and the warnings of code in a fresh process."""
    paths = os.pathsep.join([str(site), str(Path(dualcay.__file__).parents[1])])
    env = {**os.environ, "PYTHONPATH": paths, "DUALCAY_NATIVE": "", **environment}
    done = subprocess.run([sys.executable, "-c", CALL], env=env, capture_output=True, text=True, check=True)
    return done.stdout, done.stderr
