"""Kernels of orders that are not committed, written by the command into another folder: the same oracle and gates."""

from __future__ import annotations

import importlib
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

from tests.support import sampling
from tests.support.accuracy import FUNCTIONS, Trial

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = "kernels_of_other_orders"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    parent = tmp_path_factory.mktemp("elsewhere")
    command = [sys.executable, "-m", "derive", "generate", "-n", "7,11", "-o", str(parent / PACKAGE)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
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
