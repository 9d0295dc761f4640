"""Exact validation of a package: shared geometry once, own functions for every chart; wrong text is refused."""

from __future__ import annotations

import math
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import mpmath
import numpy as np
import pytest

import dualcay
from derive.codegen import ValidationFailed
from derive.codegen.build import print_package
from derive.codegen.catalogue import committed
from derive.codegen.signatures import FUNCTIONS, POSES, ROTATIONS, geometry, lower_chart
from derive.codegen.targets import TARGETS
from derive.codegen.validation import own_functions, run
from derive.codegen.validation.batches import batches
from derive.codegen.validation.decimals import EXACT_DIGITS
from derive.codegen.validation.run import require_module
from derive.maps import Cayley, family
from derive.output import files
from dualcay import cayley4
from dualcay.rotation import cayley4 as rotation4

CHARTS = [Cayley(3), Cayley(4), family("orthographic")]


@pytest.mark.parametrize("chart", CHARTS, ids=lambda chart: chart.name)
def test_own_functions_read_every_result_of_every_scalar_program(chart: Any) -> None:
    lowered, programs = lower_chart(chart), geometry()

    def read(names: Any) -> set[tuple[str, int]]:
        found = [programs[FUNCTIONS[name].kernel] for name in names]
        pairs = ((p, call, i, name) for p in found for call in p.calls for i, name in enumerate(call.names))
        return {(call.function, i) for p, call, i, name in pairs if name in p.operands}

    shared = [name for name in POSES.public if FUNCTIONS[name].kernel in lowered.operations]
    assert read(set(own_functions(chart, POSES)) & set(shared)) == read(shared)


@pytest.mark.parametrize(
    ("target", "file", "right", "wrong"),
    [("array-api", "_geometry.py", "gvv1 - fv3", "gvv1 + fv3"), ("numba", "cayley4.py", "s = p * r", "s = -p * r")],
)
def test_wrong_text_of_other_targets_fails_validation(tmp_path: Path, target: str, file: str, right: str, wrong: str):
    texts = print_package([Cayley(4)], TARGETS[target]).texts
    assert right in texts[file]
    files.write(tmp_path, {**texts, file: texts[file].replace(right, wrong, 1)})
    with pytest.raises(ValidationFailed, match=r"cayley4\.\w+.*component"):
        TARGETS[target].validate(tmp_path, Cayley(4), file == "_geometry.py")


def test_function_that_is_right_pose_by_pose_and_wrong_on_batches_is_refused() -> None:
    batch = max(batches(Cayley(4), POSES, frozenset({"principal"})), key=lambda batch: len(batch.cases))

    def shuffled(v: Any) -> Any:
        found = cayley4.principal(v)
        return found[::-1] if v.ndim > 1 else found

    with mpmath.workdps(EXACT_DIGITS), np.errstate(all="ignore"):
        run._check(SimpleNamespace(__name__="dualcay.cayley4", principal=cayley4.principal), batch)
        with pytest.raises(ValidationFailed, match=r"cayley4\.principal.*component"):
            run._check(SimpleNamespace(__name__="dualcay.cayley4", principal=shuffled), batch)


# --- names and constants ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("chart", committed(), ids=lambda chart: chart.name)
def test_committed_modules_have_their_names_and_constants(chart: Any) -> None:
    require_module(getattr(dualcay, chart.name), chart, POSES)
    require_module(getattr(dualcay.rotation, chart.name), chart, ROTATIONS)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"twist": cayley4.body_twist}, "twist is not the function twist of KERNELS"),
        ({"dcay": cayley4.tangent_inv}, "dcay is not the function tangent of KERNELS"),
        ({"rate": rotation4.rate}, "rate is not the function rate of KERNELS"),
        ({"__all__": cayley4.__all__[1:]}, "__all__ holds other names"),
        ({"ORDER": 5}, "ORDER is 5, not 4"),
    ],
)
def test_wrong_names_and_constants_are_refused(changes: dict[str, Any], words: str) -> None:
    with pytest.raises(ValidationFailed, match=words):
        require_module(SimpleNamespace(**{**vars(cayley4), **changes}), Cayley(4), POSES)  # type: ignore[arg-type]


@pytest.mark.parametrize("angles", [(2 * math.pi,), (math.nextafter(6, 7), 4 * math.pi)])
def test_wrong_singular_angles_are_refused(angles: tuple[float, ...], monkeypatch: pytest.MonkeyPatch) -> None:
    kernels = type(cayley4.KERNELS)
    monkeypatch.setattr(kernels, "singular_angles", lambda self: angles)
    kernels.singular_angles.__name__ = "singular_angles"
    module: Any = SimpleNamespace(**{**vars(cayley4), "singular_angles": cayley4.KERNELS.singular_angles})
    with pytest.raises(ValidationFailed, match=r"singular_angles\(\) is"):
        require_module(module, Cayley(4), POSES)
