"""Fingerprints of programs, by which compiled functions are known: changing any program changes them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace

import pytest

from derive.codegen import package
from derive.codegen.package import Facts, fingerprint
from derive.codegen.programs.program import Call, Program
from derive.codegen.signatures import geometry, lower
from derive.maps import Cayley
from derive.proof import prove


@pytest.fixture(scope="module")
def facts() -> Facts:
    return Facts(lower(prove(Cayley(3))))


CHANGES: dict[str, Callable[[Program], Program]] = {
    "inputs": lambda p: replace(p, inputs=(*p.inputs, ("more", ("m",)))),
    "outputs": lambda p: replace(p, outputs=p.outputs[::-1]),
    "statements": lambda p: replace(p, statements=p.statements[:-1]),
    "operation": lambda p: replace(p, statements=(replace(p.statements[0], op="abs"), *p.statements[1:])),
    "operands": lambda p: replace(p, statements=(replace(p.statements[0], args=("x", "x")), *p.statements[1:])),
    "name": lambda p: replace(p, statements=(replace(p.statements[0], name="other"), *p.statements[1:])),
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_fingerprint_changes_with_a_scalar_program(facts: Facts, change: Callable[[Program], Program]) -> None:
    lowered = facts.lowered.poses
    name, program = next(iter(lowered.scalars.items()))
    changed = replace(lowered, scalars={**lowered.scalars, name: change(program)})
    assert fingerprint(facts, changed) != fingerprint(facts, lowered)


def test_fingerprint_changes_with_a_call_in_the_geometry(facts: Facts, monkeypatch: pytest.MonkeyPatch) -> None:
    known = geometry(facts.lowered.poses.table)
    name, program = next((name, p) for name, p in known.items() if any(isinstance(s, Call) for s in p.statements))
    place, call = next((i, s) for i, s in enumerate(program.statements) if isinstance(s, Call))
    monkeypatch.setattr(package, "_shared_lines", package._shared_lines.__wrapped__)
    seen = {fingerprint(facts, facts.lowered.poses)}
    for asked in (
        replace(call, function="pose"), replace(call, args=("other",)), replace(call, rest=not call.rest),
        replace(call, names=call.names[::-1]), replace(call, truths=frozenset({*call.truths, "more"})),
    ):  # fmt: skip
        statements = (*program.statements[:place], asked, *program.statements[place + 1 :])
        changed = {**known, name: replace(program, statements=statements)}
        monkeypatch.setattr(package, "geometry", lambda table, changed=changed: changed)
        seen.add(fingerprint(facts, facts.lowered.poses))
    assert len(seen) == 6


def test_fingerprint_changes_with_arrays_and_tables_of_branches(facts: Facts) -> None:
    lowered = facts.lowered.poses
    row = lowered.table.kernels["pose"]
    rows = [replace(row, arguments=row.results), replace(row, results=row.arguments), replace(row, constants=("c",))]
    tables = [replace(lowered.table, kernels={**lowered.table.kernels, "pose": changed}) for changed in rows]
    seen = {fingerprint(facts, replace(lowered, table=table)) for table in (lowered.table, *tables)}
    for turns, returns in ((facts.turns[:-1], facts.returns), (facts.turns, facts.returns[:-1])):
        seen.add(fingerprint(SimpleNamespace(turns=turns, returns=returns), lowered))
    assert len(seen) == 6
