"""Selection of charts by order, family and φ."""

from __future__ import annotations

from pathlib import Path

import pytest

import derive
from derive.codegen import catalogue, publish


def test_default_charts_are_the_committed_ones(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[object] = []
    monkeypatch.setattr(publish, "generate_charts", lambda charts, *others, **options: asked.extend(charts))
    derive.generate(output=tmp_path)
    assert asked == catalogue.committed()


@pytest.mark.parametrize(
    ("asked", "names"),
    [
        ({"orders": [3, 2, 3]}, ["cayley2", "cayley3"]),
        ({"families": ["lambert"]}, ["lambert"]),
        ({"orders": [2], "families": ["exponential"]}, ["cayley2", "exponential"]),
        ({"phi": "4*tan(alpha/9)", "name": "mine"}, ["mine"]),
    ],
)
def test_orders_families_and_phi_are_charts(asked: dict[str, object], names: list[str]) -> None:
    found = catalogue.charts(asked.get("orders", ()), asked.get("families", ()), asked.get("phi"), asked.get("name"))
    assert [chart.name for chart in found] == names
