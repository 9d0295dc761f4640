"""Loading of packages: the text now on disk is imported, and no module stays imported."""

from __future__ import annotations

import os
import py_compile
import sys
from importlib import import_module
from pathlib import Path

import pytest

from derive.codegen.validation import ValidationFailed
from derive.codegen.validation.loading import NATIVE, loaded

pytestmark = pytest.mark.smoke


def package(folder: Path, value: int) -> Path:
    (folder / "inner").mkdir(parents=True, exist_ok=True)
    (folder / "__init__.py").write_text("from .shared import VALUE\n")
    (folder / "shared.py").write_text(f"VALUE = {value}\nDEFINED = []\n")
    (folder / "inner" / "__init__.py").write_text("from ..shared import VALUE as AGAIN\n")
    return folder


def values(folder: Path) -> tuple[int, int]:
    with loaded(folder) as name:
        inner = import_module(f"{name}.inner")
        assert Path(str(inner.__file__)) == folder / "inner" / "__init__.py"
        return import_module(name).VALUE, inner.AGAIN


def test_current_text_on_disk_runs(tmp_path: Path) -> None:
    assert values(package(tmp_path, 1)) == (1, 1)
    written = (tmp_path / "shared.py").stat()
    assert values(package(tmp_path, 2)) == (2, 2)
    package(tmp_path, 3)  # new text with the same length and time stamp
    os.utime(tmp_path / "shared.py", ns=(written.st_atime_ns, written.st_mtime_ns))
    assert values(tmp_path) == (3, 3)


def test_cached_bytecode_is_ignored(tmp_path: Path) -> None:
    written = (package(tmp_path, 1) / "shared.py").stat()
    py_compile.compile(str(tmp_path / "shared.py"), doraise=True)
    package(tmp_path, 2)
    os.utime(tmp_path / "shared.py", ns=(written.st_atime_ns, written.st_mtime_ns))
    assert values(tmp_path) == (2, 2)


def test_each_load_has_modules_of_its_own(tmp_path: Path) -> None:
    package(tmp_path, 1)
    with loaded(tmp_path) as one, loaded(tmp_path) as other:
        assert one != other
        assert import_module(f"{one}.shared").DEFINED is not import_module(f"{other}.shared").DEFINED


def interrupted(folder: Path) -> None:
    with loaded(folder) as name:
        assert os.environ[NATIVE] == "0"
        import_module(f"{name}.inner")
        raise ZeroDivisionError


def test_loading_leaves_nothing_behind(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(NATIVE, "1")
    finders, modules = list(sys.meta_path), set(sys.modules)
    with pytest.raises(ZeroDivisionError):
        interrupted(package(tmp_path, 1))
    assert (sys.meta_path, set(sys.modules), os.environ[NATIVE]) == (finders, modules, "1")
    assert not list(tmp_path.rglob("*.pyc"))


def test_folder_without_init_is_no_package(tmp_path: Path) -> None:
    with pytest.raises(ValidationFailed, match="is not a package"), loaded(tmp_path):
        pass
