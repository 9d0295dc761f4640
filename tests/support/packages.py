"""Packages that tests read or run, and their orders; packages are written without validation."""

from __future__ import annotations

import importlib
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

ORDERS = {"array-api": (1, 2, 3, 8), "numba": (1, 2, 3, 4, 8), "c": (1, 3, 8)}
FAMILIES = {
    "array-api": ("breusing", "exponential", "lambert", "orthographic", "sine3", "wiener_milenkovic"),
    **dict.fromkeys(("numba", "c"), ("exponential", "lambert")),
}
"""Orders and families in the packages shared by tests, by target."""

EXECUTED = ("validate", "replay", "test")  # names of the members of a target that execute its text


class Otherwise:
    """Target with some replaced members."""

    def __init__(self, target: Any, **members: Any) -> None:
        self._target = target
        self.__dict__.update(members)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._target, name)


def unvalidated(target: Any) -> Any:
    """Return a target that does not execute its text."""
    return Otherwise(target, **{name: lambda *_: 0 for name in EXECUTED})


def printed(orders: Iterable[int], target: str, families: Iterable[str] = ()) -> Mapping[str, str]:
    """Return the files of a package of orders and families by name, proved and printed but not validated."""
    from derive.codegen.build import print_package  # imported late, because kernels are also tested without the toolkit
    from derive.codegen.targets import TARGETS
    from derive.maps import Cayley, family

    return print_package([*map(Cayley, orders), *map(family, families)], TARGETS[target]).texts


def write(orders: Iterable[int], target: str, folder: Path, families: Iterable[str] = ()) -> None:
    """Write a package, proved and printed but not validated, into a folder."""
    from derive.output import files

    files.write(folder, dict(printed(orders, target, families)))


def headers(folder: Path) -> None:
    """Write C headers of some charts, without their differential tests, which take long to write."""
    from derive.codegen.build import print_package
    from derive.codegen.targets import TARGETS
    from derive.maps import Cayley, family
    from derive.output import files

    charts = [*map(Cayley, (2, 3)), *map(family, FAMILIES["c"])]
    files.write(folder, print_package(charts, TARGETS["c"], tested=False).texts)


def executed(charts: Iterable[Any], target: str, folder: Path) -> list[int]:
    """Write a package, execute its charts but not the geometry that they share; return the validated calls of each."""
    from derive.codegen import build
    from derive.codegen.targets import TARGETS

    chosen, asked = TARGETS[target], [one for chart in charts for one in (chart.base, chart) if one]
    package = build.print_package(asked, chosen)
    build.files.write(folder, package.texts)
    written = [build.write(module, chosen, folder, build.GEOMETRY, asked) for module in package.modules]
    counted = [[build.check((name, one)) or 0 for name in build.CHECKS] for one in written]
    return [validated for validated, *_ in counted]


def imported(chart: Any, folder: Path) -> ModuleType:
    """Return the NumPy module of a chart, proved and printed but not validated, from a package in a folder."""
    from derive.codegen.build import print_package
    from derive.codegen.targets import TARGETS
    from derive.output import files

    charts = [chart.base, chart] if chart.base else [chart]  # a multiple imports the module of its base chart
    files.write(folder / f"with_{chart.name}", print_package(charts, TARGETS["numpy"]).texts)
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(folder)
        return importlib.import_module(f"with_{chart.name}.{chart.name}")
