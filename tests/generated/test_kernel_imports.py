"""Imports of kernels: NumPy suffices, and both import names work."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.kernels import ORDERS

ROOT = Path(__file__).resolve().parents[2]
SCIPY = ("_stepping.py", "_trajectory.py", "_twist.py", "interop.py")
OPTIONAL = {"dask.py": {"dask"}} | {name: {"scipy"} for name in SCIPY}
"""Libraries that modules of tools import, by file."""

BLOCK = """
import sys
class Refuse:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {"sympy", "jinja2", "click", "derive", "mpmath", "scipy"}:
            raise ImportError("blocked: " + name)
sys.meta_path.insert(0, Refuse())
"""


def run(code: str, path: list[Path]) -> str:
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    if path:
        environment["PYTHONPATH"] = os.pathsep.join(map(str, path))
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", code],
        cwd=ROOT,
        env=environment,
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return done.stdout


def test_kernels_need_numpy_alone() -> None:
    modules = ", ".join(f"cayley{n}" for n in ORDERS)
    code = BLOCK + f"from dualcay import {modules}, matrix6\nprint(cayley3.pose([0.0] * 6).shape)"
    assert run(code, [ROOT / "generated"]).strip() == "(4, 4)"


def test_importing_a_kernel_does_not_import_the_toolkit() -> None:
    code = (
        "import sys, dualcay.cayley3\n"
        "print(sorted({m.partition('.')[0] for m in sys.modules} & {'sympy', 'jinja2', 'derive'}))"
    )
    assert run(code, [ROOT / "generated"]).strip() == "[]"


def test_a_bare_checkout_imports_through_the_folder() -> None:
    """Import from the repository root, with nothing installed and no extra path."""
    code = BLOCK + "from generated.dualcay import cayley3\nprint(cayley3.__name__, cayley3.quaternion([0.0] * 6)[0])"
    assert run(code, []).split() == ["generated.dualcay.cayley3", "1.0"]


@pytest.mark.parametrize("path", sorted((ROOT / "generated" / "dualcay").rglob("*.py")), ids=lambda p: p.name)
def test_imports_inside_the_package_are_relative_or_allowed(path: Path) -> None:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        names = []
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            names = [node.module or ""]
        for name in names:
            top = name.partition(".")[0]
            allowed = {"numpy", *sys.stdlib_module_names, *OPTIONAL.get(path.name, ())}
            assert top in allowed, f"{path.name} imports {name}"
