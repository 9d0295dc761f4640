"""Extension modules of compiled NumPy functions: an error in any of their files stops generation."""

from __future__ import annotations

from pathlib import Path

import pytest

from derive.codegen import ValidationFailed
from derive.codegen.build import print_package
from derive.codegen.targets import TARGETS
from derive.codegen.validation import compiled
from derive.maps import Cayley
from derive.output import files

pytestmark = pytest.mark.compiler

CHART, NATIVE = Cayley(3), TARGETS["native"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("native")
    files.write(found, print_package([CHART], NATIVE, tested=False).texts)
    return found


ERRORS = ("int broken(void) { return }", "int unknown(void) { return dualcay_unknown(1); }")
NAMES = ("cayley3.c", "rotation/cayley3.c", "tiles.h", "direct.h", "loops.h", "rotation/loops.h", "gufuncs.h")


@pytest.mark.parametrize(
    ("name", "error"),
    [pytest.param(name, ERRORS[i % 2], marks=pytest.mark.thorough if i > 3 else ()) for i, name in enumerate(NAMES)],
)
def test_an_error_in_a_source_stops_generation(folder: Path, tmp_path: Path, name: str, error: str) -> None:
    texts = {str(p.relative_to(folder)): p.read_text("utf-8") for p in folder.rglob("*") if p.suffix in (".c", ".h")}
    files.write(tmp_path, {**texts, name: f"{texts[name]}\n{error}\n"})
    with pytest.raises(ValidationFailed, match=r"cayley3\.c does not compile"):
        NATIVE.test(tmp_path, CHART)


def test_sources_are_understood(folder: Path) -> None:
    compiled.require_modules(folder, ["cayley3.c", "rotation/cayley3.c"])
