"""Compiled functions find the kernels they were built of by a digest: whatever is computed otherwise has another."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace

import pytest

from derive.codegen import fingerprint as module
from derive.codegen.facts import Facts
from derive.codegen.fingerprint import fingerprint
from derive.codegen.lowered import Lowered, geometry, lower, lower_chart
from derive.codegen.programs.program import Call, Program
from derive.maps import Cayley
from derive.proof import prove


@pytest.fixture(scope="module")
def facts() -> Facts:
    proved = prove(Cayley(3))
    return Facts(proved, lower(proved))


@pytest.fixture
def lowered() -> Lowered:
    return lower_chart(Cayley(3))


def otherwise(lowered: Lowered, change: Callable[[Program], Program]) -> Lowered:
    """The same with one of its own programs changed."""
    name, program = next(iter(lowered.scalars.items()))
    return replace(lowered, scalars={**lowered.scalars, name: change(program)})


CHANGES: dict[str, Callable[[Program], Program]] = {
    "inputs": lambda p: replace(p, inputs=(*p.inputs, ("more", ("m",)))),
    "results": lambda p: replace(p, outputs=p.outputs[::-1]),
    "a statement fewer": lambda p: replace(p, statements=p.statements[:-1]),
    "another operation": lambda p: replace(p, statements=(replace(p.statements[0], op="abs"), *p.statements[1:])),
    "other operands": lambda p: replace(p, statements=(replace(p.statements[0], args=("x", "x")), *p.statements[1:])),
    "another name": lambda p: replace(p, statements=(replace(p.statements[0], name="other"), *p.statements[1:])),
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_another_program_has_another(facts: Facts, lowered: Lowered, change: Callable[[Program], Program]) -> None:
    assert fingerprint(facts, otherwise(lowered, change)) != fingerprint(facts, lowered)


def test_another_geometry_has_another(facts: Facts, lowered: Lowered, monkeypatch: pytest.MonkeyPatch) -> None:
    known = geometry(lowered.table)
    name, program = next((name, p) for name, p in known.items() if any(isinstance(s, Call) for s in p.statements))
    place, call = next((i, s) for i, s in enumerate(program.statements) if isinstance(s, Call))
    seen = {fingerprint(facts, lowered)}
    monkeypatch.setattr(module, "_of_geometry", module._of_geometry.__wrapped__)
    for asked in (
        replace(call, function="pose"), replace(call, args=("other",)), replace(call, rest=not call.rest),
        replace(call, names=call.names[::-1]), replace(call, truths=frozenset({*call.truths, "more"})),
    ):  # fmt: skip
        statements = (*program.statements[:place], asked, *program.statements[place + 1 :])
        changed = {**known, name: replace(program, statements=statements)}
        monkeypatch.setattr(module, "geometry", lambda table, changed=changed: changed)
        seen.add(fingerprint(facts, lowered))
    assert len(seen) == 6


def test_other_arrays_and_turns_have_another(facts: Facts, lowered: Lowered) -> None:
    row = lowered.table.kernels["pose"]
    rows = [replace(row, arguments=row.results), replace(row, results=row.arguments), replace(row, constants=("c",))]
    tables = [replace(lowered.table, kernels={**lowered.table.kernels, "pose": changed}) for changed in rows]
    seen = {fingerprint(facts, replace(lowered, table=table)) for table in (lowered.table, *tables)}
    for turns, returns in ((facts.turns[:-1], facts.returns), (facts.turns, facts.returns[:-1])):
        seen.add(fingerprint(SimpleNamespace(turns=turns, returns=returns), lowered))
    assert len(seen) == 6
