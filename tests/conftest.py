"""Deselect and report tests with missing requirements; fill expensive folders once for all tests."""

from __future__ import annotations

import importlib.util
import os
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest
from filelock import FileLock

from tests.support import browsers, compilers, node

NO_GPU = "a GPU of NVIDIA, with CuPy and PyTorch, is not found"
MISSING = {
    marker: reason
    for marker, found, reason in [
        ("torch", importlib.util.find_spec("torch"), "PyTorch is not installed (extra 'torch')"),
        ("gpu", shutil.which("nvidia-smi") and all(map(importlib.util.find_spec, ("cupy", "torch"))), NO_GPU),
        ("browser", browsers.find(), browsers.MISSING),
        ("compiler", compilers.find(), compilers.MISSING),
        ("fortran", shutil.which("gfortran"), "gfortran is not found (apt-get install gfortran)"),
        ("rust", shutil.which("cargo"), "cargo is not found (install Rust)"),
        ("mcp", importlib.util.find_spec("mcp"), "the library mcp is not installed (extra 'mcp')"),
        ("node", node.find(), node.MISSING),
        ("coq", shutil.which("coqc"), "Coq is not installed (apt-get install coq)"),
        ("vex", importlib.util.find_spec("cle"), "cle is not installed (extra 'bytes')"),
        ("frama", shutil.which("frama-c"), "Frama-C is not installed (apt-get install frama-c-base)"),
        ("octave", shutil.which("octave-cli"), "GNU Octave is not installed (apt-get install octave)"),
    ]
    if not found
}
"""Reasons why tests cannot run here, by marker."""


# By default, tests use the NumPy kernels without compiled functions; DUALCAY_NATIVE=1 uses installed ones.
os.environ.setdefault("DUALCAY_NATIVE", "0")
# Each test decides its claims; tests of kept results name a folder of their own.
os.environ["DUALCAY_CACHE"] = ""


SELECTED = {
    "browser", "compiler", "coq", "fortran", "frama", "gpu", "mcp", "node", "octave", "rust", "smoke", "thorough",
    "torch", "vex",
}  # fmt: skip
"""Markers of this project that select tests."""


def _require_named(items: list[pytest.Item]) -> None:
    """Fail if a test has a marker that its file does not name: selection by marker skips such a file."""
    borne = {(item.path, marker.name) for item in items for marker in item.iter_markers() if marker.name in SELECTED}
    unnamed = sorted(f"{path}: {name}" for path, name in borne if name not in path.read_text(encoding="utf-8"))
    if unnamed:
        raise pytest.UsageError(f"tests bear markers which their files do not name: {', '.join(unnamed)}")


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Skip files that do not name the selected marker, since collecting all tests takes half a minute."""
    marker, name = str(config.option.markexpr), collection_path.name
    if marker.isidentifier() and name.startswith("test_") and collection_path.is_file():
        return None if marker in collection_path.read_text(encoding="utf-8") else True
    return None


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    _require_named(items)
    left_out = [item for item in items if any(item.get_closest_marker(marker) for marker in MISSING)]
    if left_out:
        config.hook.pytest_deselected(items=left_out)
        items[:] = [item for item in items if item not in left_out]


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    for marker, reason in MISSING.items():
        terminalreporter.write_line(f"deselected: tests marked {marker}, for {reason}")


@pytest.fixture(scope="session")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str, Callable[[Path], object]], Path]:
    """Provide a function that returns a named folder; the first process that asks fills it, others wait."""
    own = tmp_path_factory.getbasetemp()
    root = own.parent if "PYTEST_XDIST_WORKER" in os.environ else own

    def folder(name: str, fill: Callable[[Path], object]) -> Path:
        path = root / name
        with FileLock(root / f"{name}.lock"):
            if not path.exists():
                unfinished = Path(tempfile.mkdtemp(dir=root))
                fill(unfinished)
                unfinished.rename(path)
        return path

    return folder
