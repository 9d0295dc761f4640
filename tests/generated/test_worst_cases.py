"""Worst inputs of every function: errors stay within the gates."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support import cases, kernels

pytestmark = pytest.mark.thorough

KEPT, _ = cases.read()
ORDERS = sorted({case.order for case in KEPT})


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("kernels")


@pytest.mark.parametrize("order", ORDERS, ids=lambda n: f"n={n}")
def test_worst_cases_stay_within_their_gates(order: int, folder: Path) -> None:
    kernels.write([order], folder)
    for case in KEPT:
        if case.order == order:
            case.trial(kernels.load(order, folder, case.table)).check(case.function)
