"""Rules of the code: imports in one direction, standalone kernels, no evaluation of user text, smoke tests."""

from __future__ import annotations

import ast
import inspect
import re
import sys
from collections.abc import Collection, Mapping
from pathlib import Path

import pytest

from derive.codegen.validation import compiled
from tests.support import compilers
from tests.support.imports import ROOT, imported, sources
from tests.support.libraries import Late

pytestmark = pytest.mark.smoke

ORDER = {
    "derive": (
        "about", "workers", "output", "algebra", "claims", "maps", "motion_equations", "proof", "papers",
        "codegen", "pages", "front", "cli", "mcp", "__main__",
    ),
    "derive.claims": (
        "numbers", "language", "documents", "proposal", "extracted", "equation", "result", "deciding", "decide",
        "transcript", "lines", "sheet", "draft", "kept", "run", "report",
    ),
    "derive.claims.deciding": (
        "terms", "place", "claim", "frames", "solved", "constrained", "singular", "zeros", "polar", "identity",
        "equal_sides", "uphill", "places", "conditions", "partial", "far", "signs", "existence", "ordering", "regions",
        "changes", "counterexample", "split", "finding",
    ),
    "derive.codegen": (
        "programs", "lowering", "rows", "signatures", "validation", "package", "descriptions", "targets", "catalogue",
        "build",
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


def circles(imports: Mapping[str, set[str]]) -> list[str]:
    """Return the modules left when those that import none of the others are taken away, again and again."""
    left = dict(imports)
    while free := [module for module, found in left.items() if not found & (left.keys() - {module})]:
        for module in free:
            del left[module]
    return sorted(left)


def test_no_files_import_each_other_in_a_circle():
    files = {("derive", *name): file for name, file in sources("derive")}
    graph = {
        ".".join(name): {".".join(m if m in files else m[:-1]) for m in imported(file)} for name, file in files.items()
    }
    assert circles(graph) == []
    graph["derive.algebra.dual"].add("derive.proof.proved")
    assert {"derive.algebra.dual", "derive.proof.rings", "derive.proof.proved"} <= {*circles(graph)}


def test_one_module_of_charts_imports_any_phi():
    user = ("derive", "maps", "any_phi")
    found = {name for name, file in sources("derive", "maps") for m in imported(file) if m[:3] == user}
    assert {name for name in found if name[0] != "any_phi"} == {("named",)}


def test_the_toolkit_imports_nothing_of_a_checkout_alone():
    outside = {"proofs", "docs", "tests", "benchmarks", "examples"}
    assert {(file, m) for _, file in sources("derive") for m in imported(file) if m[0] in outside} == set()
    assert {m[0] for _, file in sources("docs", "pages") for m in imported(file)} & outside == {"docs"}


def test_imports_inside_functions_are_found():
    assert ("derive", "claims", "equation") in set(imported(ROOT / "derive" / "cli" / "commands.py"))


def test_kernels_import_numpy_and_the_standard_library_only():
    of_scipy = ("interop.py", "_solving.py", "_stepping.py", "_trajectory.py", "_twist.py")
    tools = dict.fromkeys(of_scipy, "scipy") | {"dask.py": "dask", "plot.py": "matplotlib"}
    for path in sorted((ROOT / "generated" / "dualcay").rglob("*.py")):
        outside = {name[0] for name in imported(path)} - {"generated", "numpy", tools.get(path.name)}
        assert outside <= sys.stdlib_module_names


def test_the_entry_point_needs_the_standard_library_only():
    for name in ("__init__.py", "__main__.py", "about.py", "workers.py"):
        outside = {module[0] for module in imported(ROOT / "derive" / name)}
        assert outside <= sys.stdlib_module_names | {"derive"}


def calls(path: Path, names: Collection[str]) -> list[tuple[str, ast.Call]]:
    """Return the calls of functions with some names in a file; most files have none, and are not parsed."""
    text = path.read_text(encoding="utf-8")
    tree = ast.parse(text if re.search(rf"\b({'|'.join(names)})\b", text) else "")
    found = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    called = [getattr(node.func, "attr", getattr(node.func, "id", "")) for node in found]
    return [(name, node) for name, node in zip(called, found, strict=True) if name in names]


def test_no_text_is_evaluated_and_nothing_decided_by_simplify():
    for _, path in sources("derive"):
        for name, node in calls(path, EVALUATORS):
            allowed = (name, path.relative_to(ROOT).as_posix()) == TRANSLATED
            allowed |= name == "sympify" and "strict=True" in map(ast.unparse, node.keywords)  # refuses text
            assert allowed, f"{path}:{node.lineno} calls {name}"


def test_no_templates_import_or_compute():
    for path in sorted((ROOT / "templates").rglob("*.j2")):
        text = path.read_text(encoding="utf-8")
        assert "namespace(" not in text
        assert "{% set" not in text, f"{path} computes"


def test_pytest_imports_no_late_module():
    """JAX takes seconds in each process that collects tests; pytest unwraps every object of a file."""
    late = Late("no_such_module")
    assert inspect.unwrap(late) is late
    assert getattr(late, "_mock_name", None) is None
    with pytest.raises(ModuleNotFoundError):
        late.numpy()


# --- clocks -----------------------------------------------------------------------------------------------------------

CLOCKS = {"monotonic", "monotonic_ns", "perf_counter", "perf_counter_ns", "time.time", "Timer", "ITIMER_REAL", "alarm"}
"""Clocks that go on while a process waits for a processor; `process_time` stands still."""

WAITS = {"wait", "join", "communicate", "result", "acquire", "poll"}
"""Methods whose number is a time limit."""

SHOWN = {
    "derive/cli/display.py", "derive/output/shown.py", "derive/proof/identity.py", "proofs/__main__.py",
    "proofs/bridge.py", "proofs/checker.py", "proofs/rounding.py",
    "examples/inverse_kinematics_jax.py", "tests/derive/output/test_progress.py",
}  # fmt: skip
"""Files that show how long something takes."""


BUILT = ("docs/examples", "docs/reference/generated")
"""Folders that the build of the site writes."""


def kept(room: str, ending: str) -> list[Path]:
    """Return the files of a room with an ending, without those that the build of the site writes."""
    found = sorted((ROOT / room).rglob(f"*{ending}"))
    return [path for path in found if not path.relative_to(ROOT).as_posix().startswith(BUILT)]


SUSPECT = re.compile(rf"{'|'.join(CLOCKS)}|time import|timeout|deadline|\.({'|'.join(WAITS)})\(\s*[\d.]")
"""Words without which a program is not parsed; most have none."""


def timed(text: str) -> list[str]:
    """Return the clocks that a program reads and the time limits that it sets."""
    found = []
    for node in ast.walk(ast.parse(text)) if SUSPECT.search(text) else ():
        if isinstance(node, ast.Attribute | ast.Name):
            name = ast.unparse(node)
            found += [name] if CLOCKS & {name, name.rpartition(".")[2]} else []
        elif isinstance(node, ast.ImportFrom) and node.module in ("time", "signal", "threading"):
            found += [name.name for name in node.names if {name.name, f"time.{name.name}"} & CLOCKS]
        elif isinstance(node, ast.keyword) and node.arg and {"timeout", "deadline"} & {*node.arg.split("_")}:
            found += [ast.unparse(node)] if getattr(node.value, "value", node) is not None else []
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in WAITS:
            found += [ast.unparse(node) for given in node.args if isinstance(getattr(given, "value", ""), int | float)]
    return found


@pytest.mark.parametrize("room", ["derive", "docs", "examples", "generated", "proofs", "templates", "tests"])
def test_nothing_is_decided_by_a_clock(room: str):
    for path in kept(room, ".py"):
        if path.relative_to(ROOT).as_posix() not in SHOWN:
            assert (path, timed(path.read_text(encoding="utf-8"))) == (path, [])
    for path in kept(room, ".md"):
        assert not re.search(r"\b(monotonic|perf_counter|time\.time|timeout=)", path.read_text(encoding="utf-8")), path


@pytest.mark.parametrize(
    "text",
    ["run(c, timeout=60)", "p.wait(60)", "q.get(timeout=T)", "t.join(5.0)", "from time import monotonic", "time.time()",
     "settings(deadline=200)", "time.perf_counter() - begun < 5", "threading.Timer(3, end)", "a.b_timeout(timeout_s=3)",
     "signal.setitimer(signal.ITIMER_REAL, 1)"],
)  # fmt: skip
def test_clocks_and_time_limits_are_found(text: str):
    assert timed(text)
    assert not timed("p.wait(); settings(deadline=None); run(timeout=None); time.process_time(); found.get(2, 3)[0]")


# --- files ------------------------------------------------------------------------------------------------------------

WRITERS = {"write_text", "write_bytes", "savefig"}
"""Calls that leave half a file if they are killed; `put` and `put_picture` replace files whole."""

FOLDERS = {"TemporaryDirectory", "NamedTemporaryFile", "mkdtemp", "mkstemp"}
"""Calls whose folders stay if they are killed; the next run removes those of `scratch`."""

OWN = {
    "derive/workers.py": FOLDERS, "derive/output/files.py": WRITERS,
    # inputs of other programs
    "proofs/bridge.py": WRITERS, "proofs/checker.py": WRITERS, "derive/pages/sheet_files.py": WRITERS,
    "benchmarks/c_form.py": WRITERS, "benchmarks/flight.py": WRITERS,
}  # fmt: skip
"""Files that may call some of these."""


@pytest.mark.parametrize("room", ["derive", "docs", "benchmarks", "proofs"])
def test_files_are_replaced_whole_and_temporary_folders_are_swept(room: str):
    refused = WRITERS | FOLDERS if room in ("derive", "proofs") else WRITERS
    for path in kept(room, ".py"):
        name = path.relative_to(ROOT).as_posix()
        for called, node in calls(path, {*refused, "open"}):
            assert called not in refused - OWN.get(name, set()), f"{name}:{node.lineno} calls {called}"
            assert called != "open" or not re.search("['\"][wax]", ast.unparse(node)), f"{name}:{node.lineno} opens"


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
