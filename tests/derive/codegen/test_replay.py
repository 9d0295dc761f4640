"""Replay on floats: detection of errors in run-time parts used for floats only."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from derive.codegen import ValidationFailed
from derive.codegen.build import build
from derive.codegen.signatures import POSES, ROTATIONS
from derive.codegen.targets import TARGETS
from derive.codegen.validation.float_cases import cases
from derive.codegen.validation.replay import FEW, MANY, NUMPY, Caller, Group, replay
from derive.maps import Cayley
from derive.output import files
from dualcay._runtime import POINTWISE_MAX
from tests.support.packages import unvalidated

CHART = Cayley(3)
TARGET = TARGETS["numpy"]


@pytest.fixture(scope="module")
def texts() -> Mapping[str, str]:
    return build([Cayley(3)], unvalidated(TARGET)).texts


WRONG = {
    "selection on floats": ("_numbers.py", r"return a if condition else b", "return b if condition else a"),
    "order of arguments": ("_interface.py", r'"transform_point", axis', '"transform_point", -1'),
    "two results split at 3": (
        "_interface.py", r"screw\[:2, \.{3}\], screw\[2:, \.{3}\]", "screw[:3, ...], screw[3:, ...]",
    ),
}  # fmt: skip


@pytest.mark.thorough
@pytest.mark.parametrize("what", WRONG)
def test_wrong_run_time_part_fails_replay(texts: Mapping[str, str], tmp_path: Path, what: str) -> None:
    file, pattern, replacement = WRONG[what]
    changed, count = re.subn(pattern, replacement, texts[file])
    assert count
    files.write(tmp_path, {**texts, file: changed})
    with pytest.raises(ValidationFailed, match=r"cayley3\.\w+"):
        TARGET.replay(tmp_path, CHART, geometry=True)


@pytest.mark.thorough
def test_replay_calls_every_function_of_a_first_chart_and_fewer_of_others(
    texts: Mapping[str, str], tmp_path: Path
) -> None:
    files.write(tmp_path, texts)
    whole, own = (TARGET.replay(tmp_path, CHART, geometry=geometry) for geometry in (True, False))
    assert 700 < whole < 1500
    assert 100 < own < whole / 2
    assert replay(tmp_path, CHART, [NUMPY], [ROTATIONS], geometry=True) < whole


@pytest.mark.thorough
@pytest.mark.parametrize("table", [POSES, ROTATIONS], ids=["poses", "rotations"])
def test_scales_are_at_least_the_norms_of_results(table) -> None:
    for case in cases(CHART, table)[::25]:
        sizes = [abs(float(c)) for c in case.result]
        assert max(case.scales) * (1 + 1e-12) >= max(sizes)
        assert np.isfinite(case.scales).all()


def test_batches_run_in_both_ways_of_numpy() -> None:
    assert FEW <= POINTWISE_MAX < MANY


@pytest.mark.parametrize(("share", "agrees"), [(0.9, True), (1.1, False), (np.nan, False)])
def test_an_ill_conditioned_result_may_lose_sixteen_roundings_of_its_scale(share: float, agrees: bool) -> None:
    """Replace a function by one whose last component is off; half of the digits are lost already."""
    scale = float(np.finfo(float).eps ** -0.5)
    case: Any = SimpleNamespace(arguments=((0.5,) * 6,), result=(1.0,) * 6, scales=(1.0, scale))
    error = share * 16 * float(np.finfo(float).eps) * scale
    off = np.array([0, 0, 0, 0, 0, error])
    module: Any = SimpleNamespace(__name__="made", principal=lambda v, axis: v + 0.5 + off)
    check = Caller(module, NUMPY).check
    group = Group(POSES.public["principal"], (), (case,))
    if agrees:
        check(group, np.array([0]))
    else:
        with pytest.raises(ValidationFailed, match=r"made\.principal.*component 5 is"):
            check(group, np.array([0]))
