"""README: its figures agree with the pages that it names; tests/docs/test_pages.py runs its sessions and commands."""

from __future__ import annotations

import re

import pytest

from derive.codegen.targets import TARGETS
from tests.support import pages


def read(name: str) -> str:
    return (pages.ROOT / name).read_text(encoding="utf-8")


ROWS = dict(re.findall(r"^\| (speed|accuracy|proofs|papers) \| (.+?) \| ", read("README.md"), re.M))


def measured() -> dict[str, tuple[str, ...]]:
    """Return the figures of the pages, by row of the README."""
    speed = re.search(
        r"^\| n \| function \| N \| [^|]+ \| SciPy RigidTransform \| pytransform3d \|$(?s:.+?)"
        r"^\| 2 \| pose \| (10000) \| ([\d.]+) \| ([\d.]+) \(.+?\) \| ([\d.]+) \(",
        read("docs/benchmarks.md"), re.M,
    )  # fmt: skip
    accuracy = re.search(r"`exponential` is off by at most, in eps: Q ([\d.]+), ρ ([\d.]+)", read("docs/accuracy.md"))
    assert speed is not None
    assert accuracy is not None
    theorems = read("docs/theorems.md")
    general = theorems.partition("\n## For every order\n")[2].partition("\n## ")[0]
    controls = sum(map(int, re.findall(r"^- controls: (\d+)$", theorems, re.M)))
    counts = re.findall(r"^\| \w+ \| (\d+) \| \d+ \| \d+ \| \d+ \| (\d+) \|$", read("docs/errata.md"), re.M)
    errata, entries = (sum(map(int, column)) for column in zip(*counts, strict=True))
    return {
        "speed": speed.groups(),
        "accuracy": accuracy.groups(),
        "proofs": (str(general.count("\n### ")), str(controls)),
        "papers": (str(entries), str(errata)),
    }


@pytest.mark.parametrize("row", ["speed", "accuracy", "proofs", "papers"])
def test_figures_agree_with_the_pages(row: str) -> None:
    assert tuple(re.findall(r"(?<!\w)\d+(?:\.\d+)?", ROWS[row])) == measured()[row]


def test_assurance_page_has_a_section_for_every_target() -> None:
    assert re.findall(r"^### (.+)$", read("docs/assurance.md"), re.M) == list(TARGETS)
