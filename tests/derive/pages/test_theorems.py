"""Page of theorems: it is current, and all controls fail."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest

from derive.pages.theorems import page
from derive.proof import __main__ as command
from derive.proof.controls import Control, controls
from derive.proof.evaluation import NoValueError
from derive.proof.identity import Check, Proof, decide
from derive.proof.theorem import Theorem, decided

PAGE = Path(__file__).parents[3] / "docs" / "theorems.md"
TEXT = PAGE.read_text(encoding="utf-8")
COUNTS = {
    name: int(count) for name, count in re.findall(r"^### (.+)\n\n(?:.+\n)*?- controls: (\d+)$", TEXT, re.M)
}
"""Number of controls by title of a part of the page."""


@pytest.fixture(scope="module")
def claimed() -> tuple[Proof, ...]:
    """Return the proofs of all theorems; a proof uses only earlier proofs."""
    return decided(command.CLAIMS)


def test_page_is_current(claimed: tuple[Proof, ...]) -> None:
    assert page(claimed, command.at_order(command.SHOWN), COUNTS) == TEXT


def test_altered_page_is_stale(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    place = tmp_path / "theorems.md"
    assert command._deliver(TEXT, place, check=True) == 1
    assert not place.exists()
    assert command._deliver(TEXT, place, check=False) == 0
    assert place.read_text(encoding="utf-8") == TEXT
    assert command._deliver(TEXT, place, check=True) == 0
    assert command._deliver(TEXT.replace("(57)", "(58)"), place, check=True) == 1
    assert f"accept with:  python -m derive.proof -o {place}" in capsys.readouterr().err


def test_proved_control_is_an_error(
    claimed: tuple[Proof, ...], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(command, "decided", lambda _: claimed[:1])
    monkeypatch.setattr(command, "ORDERS", ())
    monkeypatch.setattr(command, "controls", lambda *_: [Control("t", "nothing altered", claimed[0])])
    assert command.main([]) == 1
    assert capsys.readouterr().err == "t: nothing altered\n"


def test_missing_value_is_no_failed_control() -> None:
    def checks() -> Iterator[Check]:
        raise NoValueError("no premise defines it")
        yield

    assert not Control("t", "a", decide("t", (), "", checks)).noticed


SAMPLE = 16  # stride of the sample of theorems whose controls are tested; `make check-theorems` runs those of all


@pytest.mark.parametrize("theorem", command.CLAIMS[::SAMPLE], ids=lambda theorem: theorem.name)
def test_controls_fail(theorem: Theorem, claimed: tuple[Proof, ...]) -> None:
    scope = "" if theorem.scope == "all n" else f" [{theorem.scope}]"
    found = [*controls([theorem], {proof.name: proof for proof in claimed})]
    assert unnoticed(found) == []
    assert len(found) == COUNTS[theorem.name + scope] > len(theorem.claim) + len(theorem.premises) - 1


def test_controls_at_an_order_fail() -> None:
    found = command.controlled_at(command.SHOWN)
    assert unnoticed(found) == []
    scope = f" [n = {command.SHOWN}]"
    assert len(found) == sum(count for title, count in COUNTS.items() if title.endswith(scope)) > 40


def unnoticed(found: Iterable[Control]) -> list[str]:
    return [str(control) for control in found if not control.noticed]
