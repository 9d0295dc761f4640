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

# the headers of the native target are those of C, and its package is built in test_native
NAMES = [name for name in TARGETS if name != "native"]


@pytest.mark.parametrize("name", NAMES)
def test_a_module_is_made_and_validated(name, tmp_path):
    target, chart, proved = TARGETS[name], Cayley(3), prove(Cayley(3))
    facts = Facts(proved, lower(proved))
    module = {module_name(chart, target): module_text(facts, target)}
    files.write(tmp_path, {**shared_texts(target), **companion_texts(facts, target), **module})
    assert target.validate(tmp_path, chart) > 100


@pytest.mark.smoke
def test_words_of_a_target_are_told():
    assert all(target.unproved for target in TARGETS.values())
