"""Programs as data: files meet their schema, and nothing that printers rely on is missing."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from tests.support import languages
from tests.support.languages import TABLES, functions

NAMES = ("cayley3", "exponential")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return languages.write("json", NAMES, tmp_path_factory.mktemp("json"))


def read(folder: Path, name: str) -> dict[str, Any]:
    return dict(json.loads((folder / name).read_text(encoding="utf-8")))


FILES = [f"{place}{name}.json" for place in ("", "rotation/") for name in NAMES]


@pytest.mark.parametrize("name", FILES)
def test_file_meets_its_schema(folder: Path, name: str) -> None:
    data = read(folder, name)
    assert (folder / name).parent.joinpath(data["schema"]).resolve() == (folder / "program.schema.json").resolve()
    jsonschema.Draft202012Validator(read(folder, "program.schema.json")).validate(data)


@pytest.mark.parametrize(
    ("where", "value"),
    [(("steps", 0, 1), "plus"), (("results",), None), (("steps", 0), ["x"]), (("steps", 0, 2), 0.5)],
    ids=["unknown operation", "no results", "short step", "rounded constant"],
)
def test_schema_refuses_other_programs(folder: Path, where: tuple[Any, ...], value: Any) -> None:
    data = copy.deepcopy(read(folder, "cayley3.json"))
    place: Any = data["programs"]["chart.pose_scalars"]
    for key in where[:-1]:
        place = place[key]
    place[where[-1]] = value
    validator = jsonschema.Draft202012Validator(read(folder, "program.schema.json"))
    assert not validator.is_valid(data)


@pytest.mark.parametrize("name", FILES)
def test_functions_have_their_arrays_and_programs(folder: Path, name: str) -> None:
    data = read(folder, name)
    rows = functions(TABLES["rotation" if "/" in name else ""])
    assert data["functions"].keys() == rows.keys()
    for title, function in data["functions"].items():
        row, program = rows[title], data["programs"][function["program"]]
        assert [array["name"] for array in function["arguments"]] == [array.name for array in row.arguments]
        turn = 2 * ("instead" in function)
        given = sum(array.size for array in row.arguments) + len(function["constants"])
        last = data["programs"][function.get("instead", function["program"])]
        assert len(last["given"]) == given + turn, title
        assert len(program["results"]) == sum(array.size for array in row.results), title
