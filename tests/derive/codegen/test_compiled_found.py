"""NumPy kernels use an installed package of compiled functions only if its programs equal theirs."""

from __future__ import annotations

import sys
from types import ModuleType, SimpleNamespace

import pytest

from derive.codegen.package import shared_texts
from derive.codegen.targets import TARGETS

MODULE, COMPILED = "dualcay.cayley3", "dualcay_native.cayley3"
OTHER, OTHER_COMPILED = "dualcay.cayley2", "dualcay_native.cayley2"


@pytest.fixture
def native(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """Return a fresh import of the printed module ``_native``."""
    monkeypatch.delenv("DUALCAY_NATIVE", raising=False)
    module = ModuleType("dualcay._native")
    module.__package__ = "dualcay"
    monkeypatch.setitem(sys.modules, module.__name__, module)
    exec(shared_texts(TARGETS["numpy"])["_native.py"], vars(module))
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
