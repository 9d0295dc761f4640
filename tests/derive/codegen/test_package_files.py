"""Printed files: header comments, annotations, and the backend that a package names."""

from __future__ import annotations

import functools
import importlib
import inspect
import json
import subprocess
import sys
import tomllib
import typing
from collections.abc import Iterator
from pathlib import Path

import pytest

from derive import about
from derive.codegen.build import print_package
from derive.codegen.package import LICENCE, Package, notices, shared_texts
from derive.codegen.signatures import POSES, ROTATIONS
from derive.codegen.targets import TARGETS
from derive.maps import Cayley
from derive.output import files, write

ROOT = Path(__file__).parents[3]
CHART = Cayley(1)


@functools.cache
def printed(target: str) -> Package:
    """Return the printed package; proofs take seconds, which collection of tests need not wait for."""
    return print_package([CHART], TARGETS[target], tested=False)


def texts(target: str) -> Iterator[tuple[str, str]]:
    """Yield name and text of a package's files, then of the notices that replace some of them during writing."""
    row = TARGETS[target]
    yield from printed(target).texts.items()
    yield from notices([CHART], row).items()


def heads(text: str) -> list[str]:
    """Return the comment lines of a file from its command on, without comment marks."""
    if text.startswith("{"):
        data = json.loads(text)
        return [data["made by"], *(data.get("about") or [data["$comment"]])]
    found = files.MARK.match(text)
    assert found
    lines = text[text.rfind("\n", 0, found.start(1)) + 1 :].splitlines()
    mark = lines[0].split()[0]
    return [line.removeprefix(mark).strip() for line in lines if line.startswith(mark)]


@pytest.mark.parametrize("target", TARGETS)
def test_every_header_names_the_licence(target: str) -> None:
    for name, text in texts(target):
        command, licence, *_ = heads(text)
        assert command.startswith("python -m derive generate "), name
        assert licence == LICENCE, name


def test_licence_matches_the_project() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert f"SPDX-License-Identifier: {project['license']}" == LICENCE


@pytest.mark.parametrize("target", TARGETS)
def test_rotations_have_a_module_for_each_chart_and_a_geometry_if_poses_share_one(target: str) -> None:
    homes = [str(Path(name).parent) for name in printed(target).shared if "geometry" in name]
    assert ("rotation" in homes) == ("." in homes)
    assert {TARGETS[target].file("cayley1", table) for table in (POSES, ROTATIONS)} <= printed(target).texts.keys()


@pytest.mark.parametrize("target", TARGETS)
def test_release_changes_files_that_tell_the_version(target: str, monkeypatch: pytest.MonkeyPatch) -> None:
    before = printed(target).shared
    monkeypatch.setattr(about, "__version__", "99.1.2")
    after = shared_texts(TARGETS[target])
    # tools of the language read the version there
    told = {"c": "CMakeLists.txt", "rust": "Cargo.toml", "js": "package.json", "matlab": "Contents.m"}
    wanted = {TARGETS[target].entry, *filter(None, [told.get(target)])}
    assert {name for name, text in before.items() if after[name] != text} == wanted


# --- text about the package in its entry module -------------------------------------------------------------------


@pytest.mark.parametrize("target", ["numpy", "array-api", "numba"])
def test_package_names_its_backend_and_how_to_add_a_module(tmp_path: Path, target: str) -> None:
    write(tmp_path / "kernels", shared_texts(TARGETS[target]))

    code = "import runpy; runpy.run_module('kernels', run_name='__main__')\nfrom kernels import cayley6"
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True)
    said = done.stdout.splitlines()
    assert said[0] == f"kernels {about.__version__}"
    assert said[-1].startswith(f"backend  {target}: ")
    option = "" if target == "numpy" else f" --target {target}"
    assert done.stderr.endswith(f"dualcay generate -n 6{option} -o FOLDER\n")


@pytest.mark.parametrize("place", ["dualcay", "dualcay.rotation"])
def test_annotations_can_be_resolved(place: str) -> None:
    for name in ("cayley1", "breusing", "_geometry"):
        for function in filter(inspect.isfunction, vars(importlib.import_module(f"{place}.{name}")).values()):
            typing.get_type_hints(function)
