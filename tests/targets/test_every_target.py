"""What holds for every target: its text is made, and says what the formulas say."""

from __future__ import annotations

import pytest

from derive.codegen.facts import Facts
from derive.codegen.lowered import lower
from derive.codegen.module import companion_texts, module_name, module_text, shared_texts
from derive.codegen.targets import TARGETS
from derive.maps import Cayley
from derive.output import files
from derive.proof import prove

# C is executed as text in tests/derive/codegen/test_c_text.py; the headers of the native target are those of C
NAMES = [name for name in TARGETS if name not in ("c", "native", "numpy")]


@pytest.mark.smoke
def test_a_module_for_numpy_is_made_and_validated(tmp_path):
    require_validated("numpy", tmp_path)


@pytest.mark.parametrize("name", NAMES)
def test_a_module_is_made_and_validated(name, tmp_path):
    require_validated(name, tmp_path)


def require_validated(name, folder):
    target, chart, proved = TARGETS[name], Cayley(3), prove(Cayley(3))
    facts = Facts(proved, lower(proved))
    module = {module_name(chart, target): module_text(facts, target)}
    files.write(folder, {**shared_texts(target), **companion_texts(facts, target), **module})
    assert target.validate(folder, chart) > 100
