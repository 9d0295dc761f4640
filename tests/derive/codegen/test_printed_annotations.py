"""Annotations in printed modules resolve to types."""

from __future__ import annotations

import importlib
import inspect
import typing
from pathlib import Path

from derive.codegen import catalogue
from derive.codegen.build import print_package
from derive.codegen.signatures import POSES, ROTATIONS
from derive.codegen.targets import TARGETS
from derive.codegen.validation.loading import loaded, module_of
from derive.output import files


def test_annotations_can_be_resolved(tmp_path: Path) -> None:
    charts = [*catalogue.charts([1]), *catalogue.charts((), ["breusing"])]
    files.write(tmp_path, print_package(charts, TARGETS["numpy"]).texts)
    with loaded(tmp_path) as package:
        modules = [module_of(package, chart, table) for chart in charts for table in (POSES, ROTATIONS)]
        geometries = [importlib.import_module(f"{package}{place}._geometry") for place in ("", ".rotation")]
        for module in (*modules, *geometries):
            for function in filter(inspect.isfunction, vars(module).values()):
                typing.get_type_hints(function)
