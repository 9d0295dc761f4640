"""Exact validation of a package: shared geometry once, own functions for every chart; wrong text is refused."""

from __future__ import annotations

import math
import random
import re
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

import dualcay
from derive.codegen import ValidationFailed
from derive.codegen.build import print_package
from derive.codegen.catalogue import committed
from derive.codegen.lowered import geometry, lower_chart
from derive.codegen.signatures import FUNCTIONS, POSES, ROTATIONS
from derive.codegen.targets import TARGETS
from derive.codegen.validation import own_functions
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


# --- wrong text -------------------------------------------------------------------------------------------------------


@cache
def texts(target: str) -> Mapping[str, str]:
    return print_package(CHARTS, TARGETS[target]).texts


SLIPS = {
    "sign": (r" \+ (?=[\w(])", " - "),
    "sign back": (r" - (?=[\w(])", " + "),
    "coefficient": (r"(?<![\w.])([2-9])(?= \* )", "7 * "),
    "division": (r" / (?=[\w(])", " * "),
    "component": (r"(?<=\bv)1\b", "2"),
    "comparison": (r" < ", " > "),
}
EQUIVALENT = re.compile(
    r'"""|\\|still|near|lost|_in\b|resting|versine|belowhalf|50[57]|sign;|xp|N / N|= number|further|# '
    r"|off = |within = |beside1 = |beyond1 = |slope = \(_?1 |ss\w* - ss|square - square|none = |one = |clear = |size \+"
)
"""Lines in which no slip changes a result: terms and factors of 0, limits of series, rounding corrections, slopes read
at 0, turns by a period of tan, the choice between equal forms, what counts as half a turn by rounding, and the angle
that is turned back or not in a chart up to π."""


def slips(text: str, count: int, seed: int) -> Iterator[tuple[str, str]]:
    """Yield the text with one slip inside a program, and the changed line."""
    draw = random.Random(seed)
    for pattern, new in SLIPS.values():
        places = [m for m in re.finditer(pattern, text) if _inside_program(text, m.start())]
        for found in draw.sample(places, min(count, len(places))):
            changed = text[: found.start()] + new + text[found.end() :]
            line = changed[changed.rfind("\n", 0, found.start()) + 1 :].partition("\n")[0]
            if changed != text and not EQUIVALENT.search(line):
                yield changed, line.strip()


def _inside_program(text: str, place: int) -> bool:
    line = text[text.rfind("\n", 0, place) + 1 : text.find("\n", place)]
    return line.startswith("    ") and " = " in line and "(self" not in line and "blocks" not in line


@pytest.mark.thorough
@pytest.mark.parametrize("target", ["numpy", "array-api", "numba"])
@pytest.mark.parametrize(("file", "whole"), [("_geometry.py", True), ("cayley4.py", False), ("orthographic.py", False)])
def test_slips_in_python_text_fail_validation(tmp_path: Path, target: str, file: str, whole: bool) -> None:
    chart = next((c for c in CHARTS if f"{c.name}.py" == file), CHARTS[0])
    survived, tried = [], 0
    for changed, line in slips(texts(target)[file], 2, seed=7):
        files.write(tmp_path, {**texts(target), file: changed}, force=True)
        tried += 1
        try:
            TARGETS[target].validate(tmp_path, chart, whole)
        except (ValidationFailed, SyntaxError, NameError):
            continue
        survived.append(line)
    assert tried > 4
    assert survived == []


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
