"""Package of kernels: import with NumPy alone, lists of names, missing modules, ``python -m dualcay``."""

from __future__ import annotations

import importlib.util
import os
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest
from mypy import api

import dualcay
from derive import about
from derive.codegen.package import index_texts, shared_texts
from derive.codegen.targets import TARGETS
from derive.output import write
from dualcay._interface import OF_WORD, PoseKernels
from dualcay.rotation._interface import RotationKernels
from tests.support import thorough
from tests.support.kernels import BACKENDS, ORDERS, load, said

MODULES = sorted([*(f"cayley{order}" for order in ORDERS), *about.FAMILIES])


def test_the_version_matches_the_toolkit() -> None:
    assert dualcay.__version__ == about.__version__


def test_the_package_lists_its_modules_and_functions() -> None:
    assert set(MODULES) <= set(dir(dualcay))
    public = {name for name in dir(dualcay) if not name.startswith("_")}
    assert public == {*MODULES, *dualcay.__all__, "dask", "extended", "interop", "plot", "rotation"}
    assert all(hasattr(dualcay, name) for name in dir(dualcay))


def test_backend_says_what_runs_each_function() -> None:
    functions = {getattr(load(3), name).__name__ for name in load(3).__all__}  # an alias counts once
    assert list(dualcay.backend()) == sorted(functions)
    assert set(dualcay.backend().values()) == BACKENDS


@pytest.mark.parametrize(("name", "option"), [("cayley6", "-n 6"), ("sine77", "--family sine77")])
def test_missing_module_is_refused_with_its_command(name: str, option: str) -> None:
    command = rf"dualcay generate {option} -o FOLDER$"
    for package in (dualcay, dualcay.rotation):
        assert not hasattr(package, name)
        with pytest.raises(AttributeError, match=rf"cayley8.*{command}"):
            getattr(package, name)
        with pytest.raises(ImportError, match=rf"cayley8.*{command}"):
            exec(f"from {package.__name__} import {name}")
        for line in ("import {}", "from {} import pose"):
            with pytest.raises(ModuleNotFoundError, match=rf"^No module named '{package.__name__}.{name}'.*{command}"):
                exec(line.format(f"{package.__name__}.{name}"))
        assert importlib.util.find_spec(f"{package.__name__}.{name}") is None


@pytest.mark.parametrize("name", MODULES)
def test_rodrigues_vector_is_the_vector_of_a_cayley_module_alone(name: str) -> None:
    for folder, noun in (("dualcay", "Rodrigues dual vectors"), ("dualcay.rotation", "Rodrigues vectors")):
        doc = str(importlib.import_module(f"{folder}.{name}").__doc__)
        assert (f"{noun} ``v = " in doc) == name.startswith("cayley")


def test_unknown_name_is_refused_with_the_known_modules() -> None:
    for name in ("nonsense", "cayley06", "cayley0", "cayley", "sine", "sine0"):
        with pytest.raises(AttributeError, match=f"has no attribute '{name}'; kernel modules: {MODULES[0]}, "):
            getattr(dualcay, name)
    with pytest.raises(ImportError, match="has no attribute 'nonsense'; kernel modules"):
        from dualcay import nonsense  # noqa: F401
    with pytest.raises(ModuleNotFoundError, match=r"^No module named 'dualcay\.nonsense'$"):
        importlib.import_module("dualcay.nonsense")


@pytest.mark.parametrize("tool", ["interop", "plot"])
def test_functions_of_tools_are_named_with_their_tool(tool: str) -> None:
    for name in getattr(dualcay, tool).__all__:
        with pytest.raises(AttributeError, match=rf"has no attribute '{name}'; here it is {tool}\.{name}$"):
            getattr(dualcay, name)


def test_words_of_other_libraries_name_the_function_here() -> None:
    for home, kernels in ((dualcay.cayley2, PoseKernels), (dualcay.rotation.cayley2, RotationKernels)):
        words = {**OF_WORD, "to_quaternion": ["quaternion"], "as_quat": ["quaternion"], "to_rotvec": ["to_exponential"]}
        for word, functions in words.items():
            found = next((name for name in functions if hasattr(kernels, name)), word)
            if hasattr(kernels, word) or found == word:
                continue
            message = rf"^module '{home.__name__}' has no .*'; here it is {found}$"
            with pytest.raises(AttributeError, match=message):
                getattr(home, word.title())
            with pytest.raises(ImportError, match=message):
                exec(f"from {home.__name__} import {word}")
        with pytest.raises(AttributeError, match=r"has no attribute 'posse'$"):
            home.posse  # noqa: B018
    assert all(hasattr(PoseKernels, names[0]) for names in OF_WORD.values())


def test_python_m_dualcay_prints_version_modules_and_backends() -> None:
    root = Path(dualcay.__file__).parents[1]
    done = subprocess.run([sys.executable, "-m", "dualcay"], cwd=root, capture_output=True, text=True, check=True)
    counts = Counter(dualcay.backend().values())
    assert done.stdout.splitlines() == [
        f"dualcay {about.__version__}",
        f"modules  {', '.join(MODULES)}",
        *(f"backend  {name}: {count} functions" for name, count in counts.items()),
    ]
    assert done.stderr == ""


TYPED = """
import dualcay, json
from dualcay import cayley3, matrix6
from dualcay import nonsense
from dualcay import cayley6
from dualcay.cayley3 import pose
from dualcay.cayley3 import nothing
from derive import Cayley, generate, verify, x
from derive import missing
matrix6(pose([0.0] * 6), 1)
Cayley("3")
dualcay.rotation.cayley2.pose
dualcay.extended.cayley2.pose([0.0] * 9, axis=1)
dualcay.cayley2.pose([0.0] * 6, axis=1)
dualcay.propagate(dualcay.cayley2, [0.0] * 6, [0.0] * 6, [0.0, 1.0], frame="bodi", method="rk").v.astype(float)
dualcay.convert([0.0] * 6, cayley3, json)
dualcay.mean(cayley3, [[0.0] * 6]).shape + cayley3.switch([0.0] * 6).shape
"""


def test_names_and_arguments_are_known_to_type_checkers(tmp_path: Path, monkeypatch) -> None:
    roots = (Path(importlib.import_module(name).__file__ or "").parents[1] for name in ("dualcay", "derive"))
    monkeypatch.setenv("MYPYPATH", os.pathsep.join(map(str, roots)))
    options = ("--strict", "--config-file=", "--follow-imports=silent", "--no-site-packages", f"--cache-dir={tmp_path}")
    said, _, _ = api.run([*options, "-c", TYPED])
    assert re.findall(r":(\d+): error: .*\[(.*)\]\n", said) == [
        *((str(line), "attr-defined") for line in (4, 5, 7, 9)), ("10", "call-arg"), ("11", "arg-type"),
        ("12", "attr-defined"), *((str(line), "arg-type") for line in (13, 14, 15, 15, 16)),
    ], said  # fmt: skip


@pytest.mark.parametrize("target", thorough.sampled(("numpy", "numba", "array-api"), ("array-api",)))
def test_folder_of_kernels_is_typed_in_a_users_project(tmp_path: Path, target: str) -> None:
    """Sources of NumPy and Numba kernels are also those that `make types` checks."""
    write(tmp_path / "kernels", {**shared_texts(TARGETS[target]), **index_texts(TARGETS[target], ())})
    said, _, code = api.run(["--strict", "--config-file=", f"--cache-dir={tmp_path}", str(tmp_path / "kernels")])
    assert code == 0, said


ROOT = Path(__file__).resolve().parents[2]

BLOCK = """
import sys
class Refuse:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {"sympy", "jinja2", "click", "derive", "mpmath", "scipy", "dask", "matplotlib"}:
            raise ImportError("blocked: " + name)
sys.meta_path.insert(0, Refuse())
"""


def run(code: str, path: list[Path]) -> str:
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    if path:
        environment["PYTHONPATH"] = os.pathsep.join(map(str, path))
    command = [sys.executable, "-W", "error", "-c", code]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return done.stdout


def test_members_and_help_need_numpy_alone() -> None:
    code = BLOCK + "import inspect, pydoc, dualcay\nfor one in (dualcay, dualcay.rotation, dualcay.extended):\n"
    run(code + "    inspect.getmembers(one), pydoc.render_doc(one)\n    for name, part in inspect.getmembers(one):\n"
        "        inspect.getmembers(part)\n", [ROOT / "generated"])  # fmt: skip


def test_a_bare_checkout_imports_through_the_folder() -> None:
    """Import from the repository root, with nothing installed and no extra path."""
    code = BLOCK + "from generated.dualcay import cayley3\nprint(cayley3.__name__, cayley3.quaternion([0.0] * 6)[0])"
    assert run(code, []).split() == ["generated.dualcay.cayley3", "1.0"]


FORMER = b"""class Same:
    def __ne__(self, other): return False
PROGRAMS = Same()
"""
"""Build of a former release: the same programs, without functions for direct calls."""


def test_stale_or_broken_build_is_ignored_with_one_warning(tmp_path: Path) -> None:
    folder = tmp_path / "dualcay_native"
    folder.mkdir()
    (folder / "__init__.py").touch()
    (folder / "cayley2.py").write_text("PROGRAMS = 'others'\n", encoding="utf-8")
    builds = [
        ("was built of other programs than dualcay.cayley3 holds", "cayley3.py", b"PROGRAMS, DIRECT = 'others', {}"),
        ("was built of other programs than dualcay.cayley3 holds", "cayley3.py", FORMER),
        ("cannot be loaded: No module named 'missing'", "cayley3.py", b"import missing"),
        ("cannot be loaded", "cayley3.abi3.so", b"no library"),
    ]
    for reason, file, content in builds:
        (folder / "cayley3.py").unlink(missing_ok=True)
        (folder / file).write_bytes(content)
        out, warned = said(tmp_path)
        assert out == "{'numpy'}\n"
        assert warned.count("RuntimeWarning: ") == 1
        assert f"dualcay_native.cayley3 {reason}" in warned
    assert said(tmp_path, DUALCAY_NATIVE="0") == ("{'numpy'}\n", "")
    assert said(tmp_path / "none") == ("{'numpy'}\n", "")
