"""What functions of printed modules say of their arguments can be looked up, as a reader's editor does."""

from __future__ import annotations

import inspect
import typing
from pathlib import Path

import pytest

from derive.codegen.build import print_package
from derive.codegen.catalogue import charts
from derive.codegen.signatures import POSES, ROTATIONS
from derive.codegen.targets import TARGETS
from derive.codegen.validation.loading import loaded, module_of
from derive.output import files


@pytest.mark.parametrize("which", ["own programs alone", "scalars alone"])
def test_every_name_in_an_annotation_is_known(tmp_path: Path, which: str) -> None:
    (chart,) = charts([1]) if which == "own programs alone" else charts((), ["breusing"])
    files.write(tmp_path, print_package([chart], TARGETS["numpy"]).texts)
    with loaded(tmp_path) as package:
        for table in (POSES, ROTATIONS):
            module = module_of(package, chart, table)
            own = [value for value in vars(module).values() if inspect.isfunction(value)]
            assert [function for function in own if function.__module__ == module.__name__]
            for function in own:
                typing.get_type_hints(function)
