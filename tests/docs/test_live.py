"""Page on which a reader turns a body: opened as a file in a browser, it shows the values of the NumPy kernels."""

from __future__ import annotations

import importlib
import json
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

from docs._ext import live
from tests.support import browsers

pytestmark = [pytest.mark.browser, pytest.mark.thorough]
SET = """<script type="module">
const form = document.querySelector("#live form");
for (const [name, value] of Object.entries(VALUES)) form.elements[name].value = value;
form.dispatchEvent(new Event("input"));
</script>"""
"""Script that moves the sliders."""
VALUES = {"turn": 250.0, "shift": 0.25, "azimuth": 90.0, "height": 0.0}  # about the y axis


@pytest.fixture(scope="module")
def text() -> str:
    return live.page()


def shown(text: str, chart: str, folder: Path) -> dict[str, str]:
    """Return what a page shows in a browser once its sliders are moved."""
    file = folder / "page.html"
    values = json.dumps({**VALUES, "chart": chart})
    file.write_text(f"<!doctype html><meta charset=utf-8>{text}{SET.replace('VALUES', values)}", encoding="utf-8")
    flags = ("--headless", "--no-sandbox", "--disable-gpu", "--dump-dom")
    command = [str(browsers.find()), *flags, f"--user-data-dir={folder / 'profile'}", file.as_uri()]
    page = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    found = dict(re.findall(r'data-shown="(\w+)">(.*?)<', page))
    return {**found, "lines": str(page.count('<path d="M'))}


def numbers(text: str) -> list[float]:
    return [float(number) for number in re.findall(r"-?\d+\.\d+", text)]


@pytest.mark.parametrize("chart", live.CHARTS)
def test_page_shows_the_values_of_the_kernels(text: str, tmp_path: Path, chart: str) -> None:
    found, kernels = shown(text, chart, tmp_path), importlib.import_module(f"dualcay.{chart}")
    turn = np.radians(VALUES["turn"])
    v = kernels.from_exponential(np.array([0, turn, 0, 0, VALUES["shift"], 0]))
    alpha, shift = kernels.angle(v)
    expected = {
        "v": v, "angle": [np.degrees(alpha), shift], "shadow": kernels.shadow(v, 1),
        "condition": [np.linalg.cond(kernels.tangent(v)[0])],
    }  # fmt: skip
    digits = {"v": 3, "angle": 1, "shadow": 3, "condition": 2}
    for name, values in expected.items():  # half a unit of the last digit shown
        half = 0.501 * 10.0 ** -digits[name]
        np.testing.assert_allclose(numbers(found[name]), values, rtol=0, atol=half, err_msg=name)
    assert found["lines"] == "6"  # the body before and after, its three axes, and the axis of the motion


def test_wrong_module_is_noticed(text: str, tmp_path: Path) -> None:
    known = live.address(live.CHARTS[0])
    assert known not in text
    broken = re.sub(r'("dualcay/cayley2.js": ")[^"]*', rf"\1{known}", text)
    assert shown(broken, "cayley2", tmp_path)["v"] == ""
