"""Examples as commands: the results that they print, and their figures; those by JAX are tested with their kernels."""

from __future__ import annotations

import importlib
from pathlib import Path

import pytest

PRINTED = {
    "arm": ("--poses 8", "hand–eye, noisy", 5),
    "attitude_filter": ("--runs 3 --steps 120", "", 5),
    "heavy_top": ("--end 0.02", "", 13),
    "rendezvous": ("--runs 50", "", 9),
    "rotation_vectors": ("--rate 5", "41 poses", 5),
    "stream": ("--count 20000 --chunk 5000", "20000 poses in chunks of 5000", 6),
}
"""Options, words in the results, and number of lines, by name."""


@pytest.mark.parametrize("name", PRINTED)
def test_printed_results_and_figure(name: str, capsys: pytest.CaptureFixture[str], tmp_path: Path):
    pytest.importorskip("matplotlib")
    options, words, lines = PRINTED[name]
    importlib.import_module(f"examples.{name}").main([*options.split(), "--figure", str(tmp_path / "figure.png")])
    out = capsys.readouterr().out
    assert words in out
    assert out.count("\n") == lines
    assert ("100% Completed" in out) == (name == "stream")
    assert (tmp_path / "figure.png").stat().st_size > 10_000
