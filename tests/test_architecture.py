"""Rules of the code: imports in one direction, standalone kernels, no evaluation of user text, smoke tests."""

from __future__ import annotations

import ast
import re
import sys
from pathlib import Path

import pytest

from derive.codegen.validation import compiled
from tests.support import compilers
from tests.support.imports import ROOT, imported, sources

pytestmark = pytest.mark.smoke

ORDER = {
    "derive": (
        "about", "workers", "output", "algebra", "claims", "maps", "motion_equations", "proof", "papers", "codegen",
        "pages", "front", "cli", "__main__",
    ),
    "derive.claims": (
        "numbers", "language", "equation", "result", "deciding", "decide", "transcript", "sheet", "run", "report",
    ),
    "derive.claims.deciding": (
        "claim", "constrained", "singular", "zeros", "places", "conditions", "regions", "changes", "proof", "finding",
    ),
    "derive.papers.condurache_popa_2023": ("cp23_notation", "definitions", "sections"),
    "derive.codegen": (
        "programs", "lowering", "rows", "signatures", "lowered", "validation", "package", "targets", "catalogue",
        "build", "publish",
    ),
}  # fmt: skip
"""Rooms of packages in import order; each may import itself and earlier ones. A file ``__main__`` is a command."""

EVALUATORS = {"eval", "exec", "sympify", "parse_expr", "simplify"}

TRANSLATED = ("exec", "derive/codegen/validation/c_interpreter/__init__.py")
"""Single permitted call that executes text; the text is Python translated from a printed C header."""


def out_of_order(package: str, rooms: tuple[str, ...]) -> list[str]:
    """Return imports from later rooms by earlier ones; the enclosing package counts as the last room."""
    base = tuple(package.split("."))
    order = {room: index for index, room in enumerate(rooms)}
    wrong = []
    for name, file in sources(*base):
        for module in imported(file):
            inner = module[len(base) :]
            if module[: len(base)] == base and inner and name:
                if order[inner[0]] > order["__main__" if name[-1] == "__main__" else name[0]]:
                    wrong.append(f"{file.relative_to(ROOT)} imports {'.'.join(module)}")
            elif module == base and name:
                wrong.append(f"{file.relative_to(ROOT)} imports the package it is in")
    return wrong


@pytest.mark.parametrize("package", ORDER)
def test_imports_run_one_way(package):
    assert {name[0] for name, _ in sources(*package.split(".")) if name} <= {*ORDER[package], "front", "__main__"}
    assert out_of_order(package, ORDER[package]) == []


@pytest.mark.parametrize("package", ORDER)
def test_reversed_order_of_rooms_is_reported(package):
    last = ("__main__",) if package == "derive" else ()
    assert out_of_order(package, (*reversed(ORDER[package]), *last))


def test_other_charts_import_one_module_of_any_phi():
    user = ("derive", "maps", "any_phi")
    found = {m for name, file in sources("derive", "maps") if name[:1] != user[2:] for m in imported(file)}
    assert {module for module in found if module[:3] == user} == {(*user, "parameterization")}


def test_the_toolkit_imports_nothing_of_a_checkout_alone():
    outside = {"proofs", "docs", "tests", "benchmarks", "examples"}
    assert {(file, m) for _, file in sources("derive") for m in imported(file) if m[0] in outside} == set()
    assert {m[0] for _, file in sources("docs", "pages") for m in imported(file)} & outside == {"docs"}


def test_imports_inside_functions_are_found():
    assert ("derive", "claims", "equation") in set(imported(ROOT / "derive" / "cli" / "commands.py"))


def test_kernels_import_numpy_and_the_standard_library_only():
    of_scipy = ("interop.py", "_stepping.py", "_trajectory.py", "_twist.py")
    tools = dict.fromkeys(of_scipy, "scipy") | {"dask.py": "dask"}
    for path in sorted((ROOT / "generated" / "dualcay").glob("*.py")):
        outside = {name[0] for name in imported(path)} - {"generated", "numpy", tools.get(path.name)}
        assert outside <= sys.stdlib_module_names


def test_the_entry_point_needs_the_standard_library_only():
    for name in ("__init__.py", "__main__.py", "about.py", "workers.py"):
        outside = {module[0] for module in imported(ROOT / "derive" / name)}
        assert outside <= sys.stdlib_module_names | {"derive"}


def test_no_text_is_evaluated_and_nothing_decided_by_simplify():
    for _, path in sources("derive"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call):
                name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
                allowed = (name, path.relative_to(ROOT).as_posix()) == TRANSLATED
                allowed |= name == "sympify" and "strict=True" in map(ast.unparse, node.keywords)  # refuses text
                assert allowed or name not in EVALUATORS, f"{path}:{node.lineno} calls {name}"


def test_no_templates_import_or_compute():
    for path in sorted((ROOT / "templates").rglob("*.j2")):
        text = path.read_text(encoding="utf-8")
        assert "namespace(" not in text
        assert "{% set" not in text, f"{path} computes"


# --- smoke tests ------------------------------------------------------------------------------------------------------

TESTS = ROOT / "tests"
MARKED = re.compile(r"^(@|pytestmark = )pytest\.mark\.smoke$", re.MULTILINE)


def without_smoke(folders: list[Path]) -> list[str]:
    """Return the folders in which no test file has the smoke marker."""
    files = {folder: folder.rglob("test_*.py") for folder in folders}
    return [
        str(folder.relative_to(TESTS))
        for folder, found in files.items()
        if not any(MARKED.search(file.read_text(encoding="utf-8")) for file in found)
    ]


def test_every_room_has_a_smoke_test():
    rooms = [TESTS / "derive" / file.parent.name for file in (ROOT / "derive").glob("*/__init__.py")]
    assert len(rooms) > 5
    folders = [folder for folder in TESTS.iterdir() if any(folder.rglob("test_*.py"))]
    assert without_smoke([*rooms, *folders]) == []


def test_room_without_smoke_test_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setitem(globals(), "TESTS", tmp_path)
    for room, text in (("marked", "@pytest.mark.smoke\ndef test(): ..."), ("bare", "# no pytest.mark.smoke here")):
        (tmp_path / room).mkdir()
        (tmp_path / room / "test_it.py").write_text(text)
    assert without_smoke([tmp_path / "marked", tmp_path / "bare", tmp_path / "empty"]) == ["bare", "empty"]


@pytest.mark.parametrize("named", [None, "", "cc", "tcc -m64", "no-such-compiler", "no-such-compiler cc"])
@pytest.mark.parametrize("there", [(), ("clang",), ("cc", "tcc")])
def test_tests_and_toolkit_find_the_same_compiler(named, there, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    for name in there:
        (tmp_path / name).touch(mode=0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CC", raising=False) if named is None else monkeypatch.setenv("CC", named)
    command = compiled.compiler()
    assert compilers.find() == (str(tmp_path / command[0]) if command else None)
