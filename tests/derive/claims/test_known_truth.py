"""Law of sound verdicts: no claim that is false holds, and none that is true is false."""

from __future__ import annotations

import pytest

from tests.support.claims_of_known_truth import decided, drawn, is_wrong


@pytest.mark.parametrize("known", [*drawn(1, 40)], ids=lambda known: f"{known.claim} [{known.domain}]")
def test_no_verdict_contradicts_the_truth(known) -> None:
    result = decided(known)
    assert not is_wrong(known, result.status), (result, result.method)


@pytest.mark.thorough
@pytest.mark.parametrize("seed", range(1, 12))
def test_no_verdict_of_many_contradicts_the_truth(seed: int) -> None:
    results = [(known, decided(known)) for known in drawn(seed, 100)]
    assert [(known, result) for known, result in results if is_wrong(known, result.status)] == []
