"""Examples of functions in other charts: run here, shown by a script of the site to readers who come from a chart."""

from __future__ import annotations

import doctest
import inspect
import io
import json
from contextlib import redirect_stdout
from typing import Any

import numpy as np
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import PythonConsoleLexer

import dualcay
from dualcay import cayley2


def session(examples: list[doctest.Example], chart: str) -> tuple[str, list[str]]:
    """Return an example of `cayley2` as a session in another chart, and what it prints there.

    Examples
    --------
    >>> parts = doctest.DocTestParser().get_examples(">>> cayley2.singular_angles()  # 2π")
    >>> session(parts, "cayley1")
    ('>>> cayley1.singular_angles()\\n(3.141592653589793,)\\n', ['(3.141592653589793,)\\n'])
    """
    names: dict[str, Any] = {"np": np, chart: getattr(dualcay, chart)}
    text, found = "", []
    for example in examples:
        source, printed = example.source.replace("cayley2", chart), io.StringIO()
        with redirect_stdout(printed):
            exec(compile(source, "example", "single"), names)
        found.append(printed.getvalue())
        lines = [line.partition("  # ")[0] for line in source.splitlines()]
        text += "".join(f"{'...' if i else '>>>'} {line}\n" for i, line in enumerate(lines)) + found[-1]
    return text, found


def examples(name: str, charts: list[str]) -> dict[str, str]:
    """Return an example as HTML by chart, empty where the chart's name is all that differs from `cayley2`.

    A chart in which a claim of the example fails, such as one on the branch that a chart reaches, is left out.
    """
    parts = doctest.DocTestParser().get_examples(inspect.getdoc(getattr(cayley2, name)) or "")
    _, shown = session(parts, "cayley2")
    found = {}
    for chart in charts:
        text, printed = session(parts, chart)
        if printed == shown:
            found[chart] = ""
        elif not any("True" in was and "False" in now for was, now in zip(shown, printed, strict=True)):
            found[chart] = highlight(text, PythonConsoleLexer(), HtmlFormatter(nowrap=True))
    return found


def script(name: str, charts: list[str]) -> str:
    """Return the examples of a function as data for the script of the site."""
    data = json.dumps(examples(name, charts), ensure_ascii=False).replace("</", "<\\/")
    return f'<script type="application/json" id="chart-examples">{data}</script>'
