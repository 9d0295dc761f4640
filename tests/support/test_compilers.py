"""Check that tests which need a compiler are deselected only if the toolkit finds none."""

from __future__ import annotations

from pathlib import Path

import pytest

from derive.codegen.validation import compiled
from tests.support import compilers


@pytest.mark.parametrize("named", [None, "", "cc", "tcc -m64", "no-such-compiler", "no-such-compiler cc"])
@pytest.mark.parametrize("there", [(), ("clang",), ("cc", "tcc")])
def test_tests_and_toolkit_find_the_same_compiler(named, there, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    for name in there:
        (tmp_path / name).touch(mode=0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CC", raising=False) if named is None else monkeypatch.setenv("CC", named)
    command = compiled.compiler()
    assert compilers.find() == (str(tmp_path / command[0]) if command else None)
