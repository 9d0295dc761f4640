"""The house rules a machine can check: imports run one way, kernels stand alone, user text is never evaluated."""

from __future__ import annotations

import ast
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.smoke

ROOT = Path(__file__).parent.parent
ROOMS = ("algebra", "maps", "proof", "papers", "codegen", "cli")
"""Each room may import itself and those before it."""

EVALUATORS = {"eval", "exec", "sympify", "parse_expr", "simplify"}


def imports(path: Path) -> set[str]:
    """Absolute names of the modules a file imports when it is loaded."""
    package = path.relative_to(ROOT).with_suffix("").parts[:-1]
    found = set()
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = ".".join(package[: len(package) - node.level + 1]) if node.level else ""
            module = ".".join(filter(None, (base, node.module)))
            found |= {module, *(f"{module}.{alias.name}" for alias in node.names)}
    return found


def sources(room: str) -> list[Path]:
    return sorted((ROOT / "derive" / room).rglob("*.py"))


@pytest.mark.parametrize("room", ROOMS)
def test_imports_run_one_way(room):
    allowed = ROOMS[: ROOMS.index(room) + 1]
    assert sources(room)
    for path in sources(room):
        for name in imports(path):
            parts = name.split(".")
            if parts[0] == "derive" and len(parts) > 1 and parts[1] in ROOMS:
                assert parts[1] in allowed, f"{path} imports {name}"


def test_kernels_import_numpy_and_the_standard_library_only():
    for path in sorted((ROOT / "generated" / "dualcay").glob("*.py")):
        outside = {name.split(".")[0] for name in imports(path)} - {"generated", "numpy"}
        assert outside <= sys.stdlib_module_names


def test_the_entry_point_needs_the_standard_library_only():
    for name in ("__init__.py", "__main__.py"):
        outside = {module.split(".")[0] for module in imports(ROOT / "derive" / name)}
        assert outside <= {"__future__", "importlib", "sys", "typing", "derive"}


@pytest.mark.parametrize("room", ROOMS)
def test_no_text_is_evaluated_and_nothing_decided_by_simplify(room):
    for path in sources(room):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call):
                name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
                assert name not in EVALUATORS, f"{path}:{node.lineno} calls {name}"


def test_no_templates_import_or_compute():
    for path in sorted((ROOT / "templates").rglob("*.j2")):
        text = path.read_text(encoding="utf-8")
        assert "namespace(" not in text
        assert "{% set" not in text, f"{path} computes"
