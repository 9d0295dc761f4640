"""Compiled functions run only for the programs they were built of: changing any program changes its fingerprint."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import replace
from types import ModuleType, SimpleNamespace

import pytest

from derive.codegen import package
from derive.codegen.package import Facts, fingerprint
from derive.codegen.programs.program import Call, Program
from derive.codegen.signatures import geometry, lower
from derive.maps import Cayley
from derive.output import pages
from derive.proof import prove

MODULE, COMPILED = "dualcay.cayley3", "dualcay_native.cayley3"
OTHER, OTHER_COMPILED = "dualcay.cayley2", "dualcay_native.cayley2"


@pytest.fixture
def native(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """Return a fresh import of the module ``_native``, which is copied."""
    monkeypatch.delenv("DUALCAY_NATIVE", raising=False)
    module = ModuleType("dualcay._native")
    module.__package__ = "dualcay"
    monkeypatch.setitem(sys.modules, module.__name__, module)
    exec((pages.folder() / "numpy" / "runtime" / "_native.py").read_text("utf-8"), vars(module))
    return module


def test_compiled_functions_of_the_same_programs_are_used(native: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, COMPILED, SimpleNamespace(PROGRAMS="these", DIRECT={"pose": None}, pose=max))
    assert native.functions(MODULE, "these") == {"pose": (max, None)}
    monkeypatch.setenv("DUALCAY_NATIVE", "0")
    assert native.functions(MODULE, "these") == {}


@pytest.mark.parametrize(
    "found",
    [SimpleNamespace(PROGRAMS="others", DIRECT={"pose": None}, pose=max), SimpleNamespace(PROGRAMS="these", pose=max)],
    ids=["others", "of a former release"],
)
def test_compiled_functions_of_other_programs_are_ignored_with_one_warning(
    found: SimpleNamespace, native: ModuleType, monkeypatch: pytest.MonkeyPatch, recwarn: pytest.WarningsRecorder
) -> None:
    for name in (COMPILED, OTHER_COMPILED):
        monkeypatch.setitem(sys.modules, name, found)
    assert native.functions(MODULE, "these") == native.functions(OTHER, "these") == {}
    (warned,) = recwarn
    assert warned.category is RuntimeWarning
    assert str(warned.message) == (
        f"{COMPILED} was built of other programs than {MODULE} holds: install what the same version generates; "
        "NumPy runs instead"
    )


def test_no_warning_without_compiled_functions(native: ModuleType, recwarn: pytest.WarningsRecorder) -> None:
    assert native.functions("dualcay.nothing", "these") == {}
    assert not recwarn


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
