"""Explanations of kernel functions: each fact is that of the table or the file from which it comes."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import sympy

import derive
import dualcay
from derive.codegen.signatures import PUBLIC, lower_chart
from derive.pages.explain import COVERAGE

CHARTS = (derive.Cayley(1), derive.Cayley(3), derive.family("breusing"), derive.family("scaled2"))


@pytest.mark.parametrize("chart", CHARTS, ids=lambda chart: chart.name)
def test_every_function_is_explained(chart) -> None:
    folder, counted = Path(dualcay.__file__).parent.parent, lower_chart(chart).operations
    for name, row in PUBLIC.items():
        found = derive.explain(chart, name)
        assert found.formula
        assert found.total == counted.get(row.kernel, found.operations[row.kernel]).total()
        if chart.cayley:
            named = {proof.name for proof in found.theorems}
            assert named == set(COVERAGE[name].theorems)
        assert all(proof.proved for proof in found.theorems)
        for place in found.places[1:]:
            file, line, function = re.fullmatch(r"([\w/.]+):(\d+)  (\w+)", place).groups()
            assert f"def {function}(" in (folder / file).read_text(encoding="utf-8").splitlines()[int(line) - 1]
        assert repr(found).startswith(f"{name} of {chart.name}, v = ")


@pytest.mark.smoke
def test_module_that_is_not_committed_is_named_by_its_command() -> None:
    assert derive.explain(derive.Cayley(7), "dcay").places[-1].endswith("_tangent_scalars, by dualcay generate -n 7")


@pytest.mark.parametrize(
    ("chart", "function", "message"),
    [
        (derive.Cayley(2), "pos", "a function is one of quaternion, .*got 'pos'"),
        (derive.family("lambert"), "dcay", "got 'dcay'"),
        (derive.Cayley(sympy.Symbol("n")), "pose", "kernels have a number as order n, got n"),
        (derive.Parameterization("sin(alpha)"), "pose", "symbolic only"),
    ],
)
def test_other_names_and_charts_are_refused(chart, function: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        derive.explain(chart, function)
