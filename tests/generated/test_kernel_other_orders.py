"""Kernels of orders that are not committed, in a folder of their own: the same oracle and gates."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

from tests.support import packages, sampling
from tests.support.accuracy import FUNCTIONS, Trial

PACKAGE = "kernels_of_other_orders"


@pytest.fixture(scope="module")
def folder(shared) -> Iterator[Path]:
    parent = shared(PACKAGE, lambda place: packages.write([7, 11], "numpy", place)).parent
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(parent))
        yield parent


@pytest.fixture(params=[7, 11])
def other(request: pytest.FixtureRequest, folder: Path) -> ModuleType:
    return importlib.import_module(f"{PACKAGE}.cayley{request.param}")


@pytest.mark.parametrize("regime", sampling.REGIMES)
def test_orders_seven_and_eleven(other: ModuleType, regime: str) -> None:
    order = int(other.__name__.rpartition("cayley")[2])
    assert Path(other.__file__ or "").parent.name == PACKAGE
    trial = Trial(other, order, regime, count=2)
    for name in FUNCTIONS:
        trial.check(name)
