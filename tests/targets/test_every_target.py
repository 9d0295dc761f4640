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


@pytest.mark.smoke
@pytest.mark.parametrize("target", TARGETS.values(), ids=TARGETS)
def test_a_module_is_made_and_validated(target, tmp_path):
    chart, proved = Cayley(3), prove(Cayley(3))
    facts = Facts(proved, lower(proved))
    module = {module_name(chart, target): module_text(facts, target)}
    files.write(tmp_path, {**shared_texts(target), **companion_texts(facts, target), **module})
    assert target.validate(tmp_path, chart) > 100
