"""Missing parts of functions are named, all at once."""

from __future__ import annotations

from dataclasses import replace

import pytest

from derive.codegen.rows import RULE
from derive.codegen.signatures import POSES, ROTATIONS, V
from tests.support import families
from tests.support.names import PLACES, PLACES_OF_ROTATIONS, lacking

pytestmark = pytest.mark.smoke


def test_nothing_is_missing_but_all_that_a_new_function_lacks(monkeypatch: pytest.MonkeyPatch) -> None:
    assert lacking() == []
    row = POSES.public["principal"]
    for name, decision, argument in (("half", "", V), ("third", RULE, V.called("new"))):
        monkeypatch.setitem(POSES.public, name, replace(row, name=name, derivatives=decision, arguments=(argument,)))
        monkeypatch.setitem(ROTATIONS.public, name, replace(row, name=name).of_rotation)
    kind, decision, rule = list(PLACES)[1:4]
    only = {kind: "third", decision: "half", rule: "third"}
    assert lacking() == [f"{place}: {only.get(place, 'half, third')}" for place in (*PLACES, *PLACES_OF_ROTATIONS)]


def test_family_without_an_oracle_is_named() -> None:
    with pytest.raises(LookupError, match=r"no oracle of the family sine11: .* ORACLES, tests\.support\.families"):
        families.oracle_of("sine11")
