"""Page on which a reader turns a body: modules of charts for JavaScript, inside the page.

Browsers load no module from a file, so a map of imports holds the text of each one.
"""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from docutils import nodes
from docutils.parsers.rst import Directive

from derive.codegen import catalogue
from derive.codegen.build import print_package
from derive.codegen.targets import TARGETS

ORDERS, FAMILIES = (1, 2, 3), ("exponential", "lambert")
CHARTS = (*(f"cayley{n}" for n in ORDERS), *FAMILIES)
SLIDERS = {
    "turn": ("rotation angle (°)", 0, 360, 90),
    "shift": ("shift along the axis", -1, 1, 0.5),
    "azimuth": ("azimuth of the axis (°)", -180, 180, 30),
    "height": ("height of the axis (°)", -90, 90, 60),
}
"""Sliders by name: label, ends and first value."""
SHOWN = {
    "v": "v", "angle": "angle of v", "shadow": "shadow of v, branch 1", "condition": "condition number of Re T",
}  # fmt: skip
"""Results by name, with their labels."""


def page() -> str:
    """Return the HTML of controls, picture and results, with the modules that compute them."""
    options = "".join(f"<option{' selected' * (name == 'cayley2')}>{name}</option>" for name in CHARTS)
    sliders = (
        f'<label>{label}<input type="range" name="{name}" min="{low}" max="{high}" step="any" value="{value}">'
        f'<output name="{name}_shown"></output></label>'
        for name, (label, low, high, value) in SLIDERS.items()
    )
    rows = (f'<tr><th>{label}</th><td data-shown="{name}"></td></tr>' for name, label in SHOWN.items())
    texts = print_package(catalogue.charts(ORDERS, FAMILIES, None, None), TARGETS["js"]).texts
    script = Path(__file__).with_suffix(".js").read_text(encoding="utf-8")
    return f"""<div id="live">
<form><label>chart<select name="chart">{options}</select></label>{"".join(sliders)}</form>
<svg viewBox="-2 -1.6 4 3.2" role="img" aria-label="a body, and where it was before the motion"></svg>
<table>{"".join(rows)}</table>
</div>
<script type="importmap">{json.dumps({"imports": imports(texts)})}</script>
<script type="module">
{script}</script>
"""


def imports(texts: Mapping[str, str]) -> dict[str, str]:
    """Return the modules for poses as addresses that hold their text, by the names under which they are imported."""
    known = {name: text for name, text in texts.items() if re.fullmatch(r"\w+\.js", name)}
    known["charts.js"] = "".join(f'export * as {name} from "./{name}.js";\n' for name in CHARTS)
    return {f"dualcay/{name}": address(text.replace('from "./', 'from "dualcay/')) for name, text in known.items()}


def address(text: str) -> str:
    return f"data:text/javascript;base64,{base64.b64encode(text.encode()).decode()}"


class Live(Directive):
    """Directive that stands for the controls and what they show."""

    def run(self) -> list[nodes.Node]:
        return [nodes.raw("", page(), format="html")]


def setup(app: Any) -> dict[str, bool]:
    """Connect the directive to Sphinx."""
    app.add_directive("live", Live)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
