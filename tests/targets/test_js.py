"""JavaScript modules: digits of C, errors that name the argument, results in an array of the user's, and types."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive.codegen.rows import Table, inside
from derive.codegen.signatures import POSES, ROTATIONS, lower_chart, way
from derive.codegen.targets.c import levels
from derive.codegen.targets.straight import public
from tests.support import js, languages, node
from tests.support.languages import Case

pytestmark = pytest.mark.node
CHARTS = ["cayley2", "cayley3", "exponential"]


@pytest.fixture(scope="module")
def modules(shared: Callable[[str, Callable[[Path], object]], Path]) -> Path:
    return shared("generated_js", lambda place: languages.write("js", CHARTS, place))


def calls_libm(case: Case) -> bool:
    """Return whether a function calls a tangent, an arc tangent, an exponential or a logarithm."""
    table = languages.TABLES[case.table]
    known, runs = levels(lower_chart(languages.chart(case.chart), table)), way(case.row, table)
    named = {"stayed": "stay", "returned": "principal"}
    return any(known[named.get(name, name)] == 2 for name in (runs.program, runs.then, runs.instead) if name)


@pytest.mark.parametrize("names", [CHARTS[2:], pytest.param(CHARTS[:2], marks=pytest.mark.thorough)], ids=str)
def test_node_and_libm_differ_in_elementary_functions_alone(modules: Path, tmp_path: Path, names: list[str]) -> None:
    """Functions without these give equal digits. Each value of node and of libm is within an ulp of the right one."""
    cases = [case for name in names for case in languages.cases(name)]
    found, calls = js.results(modules, cases, tmp_path)
    own = js.run(modules, cases, tmp_path, own=True)
    pairs = zip(cases, found, own)
    differ = [case for case, one, other in pairs if any(map(np.any, map(languages.differing, one, other)))]
    assert differ
    assert [str(case) for case in differ if not calls_libm(case)] == []
    for name in ("tan", "atan2"):
        _, _, libm, other = calls[name].T
        assert len(libm) > 100
        assert np.nanmax(abs(libm - other) / np.spacing(abs(libm))) <= 2, name


def described(table: Table, chart: str) -> list[dict[str, Any]]:
    """Return the functions of a chart with the sizes of their arguments and results."""
    return [
        {
            "file": inside(table, f"{chart}.js"),
            "name": f.row.name,
            "given": [{"argument": array.name, "size": array.size} for array in f.row.arguments],
            "branch": f.row.branch,
            "made": [array.size for array in f.row.results],
        }
        for f in public(table)
    ]


def test_errors_name_the_argument_and_results_go_where_the_user_wants(modules: Path) -> None:
    functions = [row for table in (POSES, ROTATIONS) for row in described(table, "cayley3")]
    assert wrong(modules, functions) == []
    functions[0]["given"][0]["argument"] = "u"
    assert len(wrong(modules, functions[:1])) > 1


def wrong(folder: Path, functions: list[dict[str, Any]]) -> Any:
    data = json.dumps({"folder": folder.resolve().as_uri(), "functions": functions})
    command = [str(node.find()), str(Path(__file__).with_name("arguments.mjs")), data]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return json.loads(done.stdout) if done.returncode == 0 else [done.stderr]


EXPORTS = "console.log(JSON.stringify(Object.keys(await import(process.argv[1]))))"


@pytest.mark.parametrize("file", [inside(table, f"{chart}.js") for table in (POSES, ROTATIONS) for chart in CHARTS])
def test_types_declare_what_a_module_exports(modules: Path, file: str) -> None:
    path = modules / file
    command = [str(node.find()), "--input-type=module", "-e", EXPORTS, path.resolve().as_uri()]
    exports = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    assert sorted(declared(path.with_suffix(".d.ts"))) == sorted(exports)


def declared(types: Path) -> list[str]:
    """Return the names that a file of types exports."""
    text = types.read_text(encoding="utf-8")
    found = re.findall(r"^export (?:function|const) (\w+)", text, re.MULTILINE)
    for listed in re.findall(r"^export \{ (.*) \}", text, re.MULTILINE):
        found += [name.split(" as ")[-1] for name in listed.split(", ")]
    whole = re.findall(r'^export \* from "(.*)\.js"', text, re.MULTILINE)
    return [*found, *(name for file in whole for name in declared(types.parent / f"{file}.d.ts"))]
