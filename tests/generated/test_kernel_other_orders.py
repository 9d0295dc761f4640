"""Kernels of orders that are not committed, written by the command into another folder: the same oracle and gates."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

from tests.support import sampling
from tests.support.accuracy import FUNCTIONS, Trial
from tests.support.command import in_a_process

PACKAGE = "kernels_of_other_orders"


def by_the_command(place: Path) -> None:
    done = in_a_process("generate", "-n", "7,11", "-o", str(place))
    assert done.returncode == 0, done.stderr


@pytest.fixture(scope="module")
def folder(shared) -> Iterator[Path]:
    parent = shared(PACKAGE, by_the_command).parent
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
