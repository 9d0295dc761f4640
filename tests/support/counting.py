"""NumPy target for tests of worker processes: it can be pickled, and its validation returns 1 or fails at once."""

from __future__ import annotations

import multiprocessing
import os
import time
from pathlib import Path
from typing import Any

from derive.codegen.targets.numpy import Numpy
from derive.codegen.validation import ValidationFailed
from derive.maps.chart import Chart
from tests.support.staying import until


class Counting(Numpy):
    """Target that fails validation of the charts in ``failing``; the first of them fails after a pause."""

    def __init__(self, failing: tuple[str, ...] = ()) -> None:
        self.failing = failing

    def validate(self, folder: Path, chart: Chart, geometry: bool) -> int:
        if chart.name in self.failing:
            time.sleep(0.5 if chart.name == self.failing[0] else 0)
            raise ValidationFailed(f"{chart.name}.pose, component 0: 1 is not 2")
        assert (folder / f"{chart.name}.py").is_file()
        return 1

    def replay(self, folder: Path, chart: Chart, geometry: bool) -> int:
        return 2 if geometry else 1

    def test(self, folder: Path, chart: Chart) -> int | None:
        return None


class Dying(Counting):
    """Target that ends worker processes when asked to validate; the main process waits for that."""

    def validate(self, *given: Any) -> int:
        if multiprocessing.parent_process():
            (given[0] / "died").touch()
            os._exit(9)
        until((given[0] / "died").exists)
        return 1
