"""What ``check=True`` says of an argument: the first element that is wrong, and its largest violation."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive.codegen.module import shared_texts
from derive.codegen.targets import TARGETS
from derive.codegen.validation.loading import loaded
from derive.output import files


@pytest.fixture(scope="module")
def checks(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    """Of the templates, not of a checkout."""
    folder: Path = tmp_path_factory.mktemp("kernels")
    files.write(folder, shared_texts(TARGETS["numpy"]))
    with loaded(folder) as package:
        yield importlib.import_module(f"{package}._checks")


@pytest.mark.parametrize("spoilt", [0, 4])  # both violations are NaN, or the second one
def test_no_number_is_the_largest_violation(checks: Any, spoilt: int) -> None:
    q = np.zeros((3, 8))
    q[:, 0] = 1
    q[1] = 2, 0, 0, 0, 1, 0, 0, 0  # its square by 3, the other product by 1
    for largest in ("3", "nan"):
        with pytest.raises(ValueError, match=rf"q\[1\] is no unit dual quaternion: .*, off by {largest} "):
            checks.require(checks.LAWS["from_quaternion"], q, -1)
        q[1, spoilt] = np.nan
